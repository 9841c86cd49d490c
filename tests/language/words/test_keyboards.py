"""Words that are typed without the letters that a keyboard lacks."""

from __future__ import annotations

import pytest
from meanings import done, german

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status

GRAMMAR = """
language: {language}
slots:
  place: {{type: choice, values: {places}}}
  thing: object
intents:
  go: {{action: custom, sentences: ["{go} {{place}}"]}}
  take: {{action: custom, sentences: ["{take} {{thing}}"]}}
"""


@pytest.mark.parametrize(
    ("typed", "written"),
    [
        ("fahr in die Kueche", "fahr in die Küche"),
        ("fahr zwei Meter zurueck", "fahr zwei Meter zurück"),
        ("kannst du zwei Meter rueckwaertsfahren", "kannst du zwei Meter rückwärtsfahren"),
        ("geh zur Haustuer", "geh zur Haustür"),
        (
            "fahr in die Kueche und anschliessend ins Schlafzimmer",
            "fahr in die Küche und anschließend ins Schlafzimmer",
        ),
        ("nimm den gruenen Ball", "nimm den grünen Ball"),
        ("hoer auf", "hör auf"),
        ("fahr vor, hoer auf", "fahr vor, hör auf"),
    ],
)
def test_german_letters_written_as_two(typed: str, written: str) -> None:
    found = german().parse(typed)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.actions == german().parse(written).actions


@pytest.mark.parametrize("typed", ["hoer nicht auf", "fahr nicht zurueck", "fahr in die Kuechen", "neue Kueche"])
def test_what_is_no_command_is_none_so_typed(typed: str) -> None:
    assert done(german().parse(typed)) == "rejected"


def of(engine_of, language: str, go: str, take: str, *places: str) -> IntentEngine:
    return engine_of(GRAMMAR.format(language=language, go=go, take=take, places=list(places)))


@pytest.mark.parametrize(
    ("language", "go", "take", "place", "typed", "slots"),
    [
        ("fr", "vas à", "prends", "entrée", "vas à entree s'il te plait", {"place": "entrée"}),
        ("es", "ve al", "tráeme", "salón", "ve al salon", {"place": "salón"}),
        ("es", "ve al", "tráeme", "salón", "traeme el vaso", {"thing": "vaso"}),
        ("it", "vai al", "prendi", "caffè", "vai al caffe", {"place": "caffè"}),
        ("en", "go to the", "take", "café", "go to the cafe", {"place": "café"}),
    ],
)
def test_letters_without_their_marks(engine_of, language, go, take, place, typed, slots) -> None:
    found = of(engine_of, language, go, take, place).parse(typed)
    assert (found.status, dict(found.slots)) == (Status.ACCEPTED, slots), found.reason


@pytest.mark.parametrize(
    ("language", "typed"), [("fr", "arrete toi"), ("fr", "arretez"), ("es", "parate"), ("es", "detengase")]
)
def test_a_stop_without_its_marks(engine_of, language: str, typed: str) -> None:
    found = of(engine_of, language, "ve a", "toma", "casa").parse(typed, state=("moving",))
    assert done(found) == "stop"


def test_a_word_that_the_grammar_has_is_no_other(engine_of) -> None:
    engine = of(engine_of, "fr", "va au", "prends", "marche", "marché")
    assert engine.parse("va au marche").slots == {"place": "marche"}


def test_a_word_that_may_be_two_is_neither(engine_of) -> None:
    engine = of(engine_of, "fr", "va au", "prends", "pâte", "pâté")
    assert not engine.parse("va au pate").actions


def test_an_umlaut_is_no_plain_letter(engine_of) -> None:
    engine = of(engine_of, "de", "drücken", "nimm", "knopf")
    assert not engine.parse("drucken knopf").actions


def test_the_beginning_of_a_command_is_known_so_too(engine_of):
    engine = engine_of("language: de\nintents:\n  weg: {action: custom, sentences: [zurück in die küche]}\n")
    assert engine.prefix("zurueck in die").status is PrefixStatus.INCOMPLETE
    assert engine.prefix("zurueck in die kueche").status is PrefixStatus.COMPLETE
