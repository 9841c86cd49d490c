"""Titles before names, as recognisers write them, in other languages than English: "Dr. Müller", "Sra. García"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

CALL = {"de": "ruf {who} an", "fr": "appelle {who}", "es": "llama a {who}", "it": "chiama {who}"}


def called(engine_of, language: str, names: list[str], said: str) -> object:
    listed = ", ".join(f"'{name}'" for name in names)
    grammar = f"language: {language}\nslots: {{who: [{listed}]}}\n"
    engine = engine_of(grammar + f"intents: {{call: {{action: custom, sentences: ['{CALL[language]}']}}}}\n")
    found = engine.parse(said)
    return found.slots.get("who") if found.actions else None


@pytest.mark.parametrize(
    ("language", "names", "said", "who"),
    [
        ("de", ["Doktor Müller"], "ruf Dr. Müller an", "Doktor Müller"),
        ("de", ["Dr. Müller"], "ruf Dr. Müller an", "Dr. Müller"),
        ("de", ["Dr. Müller"], "ruf Doktor Müller an", "Dr. Müller"),
        ("de", ["Prof. Berg"], "ruf Professor Berg an", "Prof. Berg"),
        ("fr", ["madame Petit", "mademoiselle Petit"], "appelle Mme Petit", "madame Petit"),
        ("fr", ["Mlle Petit"], "appelle mademoiselle Petit", "Mlle Petit"),
        ("es", ["señor García", "señora García"], "llama a Sra. García", "señora García"),
        ("es", ["señor García", "señora García"], "llama a sr garcía", "señor García"),
        ("it", ["signor Bianchi", "signora Bianchi"], "chiama Sig.ra Bianchi", "signora Bianchi"),
        ("it", ["signor Bianchi", "signora Bianchi"], "chiama sig. Bianchi", "signor Bianchi"),
        ("it", ["dottoressa Rossi", "dottor Rossi"], "chiama Dott.ssa Rossi", "dottoressa Rossi"),
        ("it", ["Sig.ra Bianchi"], "chiama la signora Bianchi", "Sig.ra Bianchi"),
        ("it", ["signor Bianchi"], "chiama Sig.ra Bianchi", None),
        ("it", ["dottor Rossi"], "chiama Dott.ssa Rossi", None),
        ("es", ["señor García"], "llama a Sra. García", None),
        ("de", ["Doktor Müller"], "ruf nicht Dr. Müller an", None),
    ],
)
def test_a_title_is_the_same_in_short_and_in_full(
    engine_of, language: str, names: list[str], said: str, who: str | None
) -> None:
    assert called(engine_of, language, names, said) == who


def test_a_place_may_be_called_so(tmp_path) -> None:
    file = tmp_path / "grammar.yaml"
    go = "action: {type: navigate, location: '{place}'}, sentences: ['geh zu {place}']"
    file.write_text(f"language: de\nslots: {{place: location}}\nintents: {{go: {{{go}}}}}\n", "utf-8")
    places = {"Büro Dr. Klein": (0.0, 0.0, 0.0), "Dr. Groß": (1.0, 0.0, 0.0)}
    engine = IntentEngine.from_files(file, locations=places)
    for said, place in (("Büro Dr. Klein", "Büro Dr. Klein"), ("Doktor Groß", "Dr. Groß"), ("Dr. Groß", "Dr. Groß")):
        assert engine.parse(f"geh zu {said}").slots == {"place": place}


def test_titles_of_free_text_stay_as_they_are(engine_of) -> None:
    engine = engine_of(
        "language: es\nslots: {text: {type: text, max_words: 4}}\n"
        "intents: {note: {action: custom, sentences: ['anota {text}']}}\n"
    )
    assert engine.parse("anota Sra. García viene").slots == {"text": "sra garcía viene"}
