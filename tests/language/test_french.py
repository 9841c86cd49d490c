"""French: words that lose a vowel before another, and numbers in names."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

GRAMMAR = """
language: fr
fillers: [s'il te plaît]
slots:
  lieu: location
  distance: {type: distance, max: 20 m}
  chose: object
intents:
  avancer:
    action: {type: move, direction: forward, distance: "{distance}"}
    sentences: ["avance (de|d') {distance}"]
  aller:
    action: {type: navigate, location: "{lieu}"}
    sentences: ["va (à la|au|à l'|dans la) {lieu}"]
  prendre:
    action: {type: pick, object: "{chose}"}
    sentences: ["prends (le|la|l') {chose}"]
"""
PLACES = {"Entrée": (1.0, 2.0), "salle d'eau": (3.0, 4.0), "Bureau 12": (5.0, 6.0)}


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR, locations=PLACES)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("va à l'entrée", {"lieu": "Entrée"}),
        ("Va à l’Entrée, s’il te plaît.", {"lieu": "Entrée"}),
        ("va dans la salle d'eau", {"lieu": "salle d'eau"}),
        ("va au bureau douze", {"lieu": "Bureau 12"}),
        ("avance d'un mètre et demi", {"distance": 1.5}),
        ("avance d'1,5 mètre", {"distance": 1.5}),
        ("prends l'assiette", {"chose": "assiette"}),
    ],
)
def test_elided_words(engine, said, slots):
    found = engine.parse(said)
    assert (found.status, dict(found.slots)) == (Status.ACCEPTED, slots)


ARTICLES = {
    "fr": ("va (à|dans) {place}|va à l' {place}", "va à l'atelier", "L'atelier", "prends {thing}", "prends l'assiette"),
    "de": ("fahr in (die|den) {place}", "fahr in die Halle", "Die Halle", "nimm {thing}", "nimm die Tasse"),
    "es": ("ve a la {place}", "ve a la sala azul", "La Sala Azul", "coge {thing}", "coge el vaso"),
    "it": ("vai nella {place}", "vai nella serra", "La Serra", "prendi {thing}", "prendi la tazza"),
}


@pytest.mark.parametrize("language", ARTICLES)
def test_an_article_is_no_part_of_a_name(tmp_path, language):
    way, there, place, take, taken = ARTICLES[language]
    path = tmp_path / f"{language}.yaml"
    path.write_text(
        f"language: {language}\nslots: {{place: location, thing: object}}\n"
        f'intents:\n  go: {{action: {{type: navigate, location: "{{place}}"}}, sentences: ["({way})"]}}\n'
        f'  take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{take}"]}}\n',
        "utf-8",
    )
    engine = IntentEngine.from_files(path, locations={place: (1.0, 2.0)})
    assert engine.parse(there).slots == {"place": place}
    assert engine.parse(taken).slots == {"thing": taken.replace("'", " ").split()[-1].lower()}
    both = {place: (1.0, 2.0), there.replace("'", " ").split()[-1]: (3.0, 4.0)}
    assert IntentEngine.from_files(path, locations=both).parse(there).status is Status.ACCEPTED


def test_a_thing_is_called_as_it_is_written(engine):
    assert engine.parse("prends la bouteille d'eau").slots == {"chose": "bouteille d'eau"}


@pytest.mark.parametrize(
    "said", ["n'avance pas d'un mètre", "n'avance plus d'un mètre", "j'avance d'un mètre", "va au bureau treize",
             "je voudrais qu'il prenne l'assiette", "prends l'assiette qu'il veut"],
)  # fmt: skip
def test_what_is_no_command(engine, said):
    assert engine.parse(said).actions == ()


SPELLED_OUT = """
language: {language}
slots:
  distance: {{type: distance, max: 20 m}}
  thing: object
intents:
  go: {{action: custom, sentences: ["{go}"]}}
  take: {{action: custom, sentences: ["{take}"]}}
"""


@pytest.mark.parametrize(
    ("language", "go", "take", "said", "slots"),
    [
        ("fr", "avance [de] {distance}", "prends (le|la|les) {thing}", "avance d'un mètre", {"distance": 1.0}),
        ("fr", "avance [de] {distance}", "prends (le|la|les) {thing}", "prends l'assiette", {"thing": "assiette"}),
        ("fr", "avance [de] {distance}", "prends (le|la|les) {thing}", "prends l’échelle", {"thing": "échelle"}),
        ("it", "vai avanti di {distance}", "prendi (lo|la|il) {thing}", "vai avanti d'un metro", {"distance": 1.0}),
        ("it", "vai avanti di {distance}", "prendi (lo|la|il) {thing}", "prendi l'acqua", {"thing": "acqua"}),
    ],
)
def test_words_written_in_full_are_understood_shortened(
    engine_of, language: str, go: str, take: str, said: str, slots: dict[str, object]
) -> None:
    found = engine_of(SPELLED_OUT.format(language=language, go=go, take=take)).parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.slots == slots


def test_before_a_consonant_nothing_is_short_for_anything(engine_of) -> None:
    engine = engine_of(SPELLED_OUT.format(language="fr", go="avance [de] {distance}", take="prends (le|la) {thing}"))
    for said in ("avance d trois mètres", "prends l verre"):
        assert not engine.parse(said).actions, said
