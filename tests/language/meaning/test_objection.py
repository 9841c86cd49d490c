""" "No", "not that": what objects to what a robot that moves is doing."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine
from intent_engine.needs import MOVING

SENTENCES = {
    "en": "go to the {location}",
    "de": "fahr zum {location}",
    "es": "ve al {location}",
    "fr": "va au {location}",
    "it": "vai al {location}",
}
OBJECTING = [
    ("en", "no"),
    ("en", "Nope."),
    ("en", "no no no"),
    ("en", "uh, no please"),
    ("en", "no, that's wrong"),
    ("en", "not that"),
    ("en", "no, not there"),
    ("en", "not so far"),
    ("en", "that's too far!"),
    ("en", "no, not so fast"),
    ("de", "Nein!"),
    ("de", "das ist zu weit"),
    ("de", "nein, das ist falsch"),
    ("de", "nicht dahin"),
    ("es", "¡no!"),
    ("es", "no tan lejos"),
    ("es", "no, eso no"),
    ("fr", "non"),
    ("fr", "pas si loin"),
    ("fr", "non, pas ça"),
    ("it", "no"),
    ("it", "troppo lontano"),
    ("it", "no, non quello"),
]
OTHER_TALK = [
    ("en", "no, I did not see it"),
    ("en", "no problem"),
    ("en", "no idea"),
    ("en", "no, thanks"),
    ("en", "no thank you"),
    ("en", "no. No problem."),
    ("en", "not that I know of"),
    ("en", "not so far as I know"),
    ("en", "it is too far to walk"),
    ("en", "it went too far"),
    ("de", "nein, danke"),
    ("de", "nein, ich weiß es nicht"),
    ("de", "nein, kein Problem"),
    ("es", "no, gracias"),
    ("es", "no lo sé"),
    ("es", "no hay problema"),
    ("fr", "non merci"),
    ("fr", "non, je ne sais pas"),
    ("fr", "pas de problème"),
    ("it", "no, grazie"),
    ("it", "no, non lo so"),
]


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    text = 'language: {}\nslots: {{location: location}}\nintents:\n  go: {{action: navigate, sentences: ["{}"]}}\n'
    places = {"bar": (1.0, 2.0), "garage": (3.0, 4.0)}
    return {language: engine_of(text.format(language, said), locations=places) for language, said in SENTENCES.items()}


@pytest.mark.parametrize(("language", "said"), OBJECTING)
def test_it_stops_a_robot_that_moves_and_at_rest_says_nothing(engines, language, said):
    assert engines[language].parse(said, state={MOVING}).stops
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize(("language", "said"), OTHER_TALK)
def test_an_answer_to_somebody_else_stops_nothing(engines, language, said):
    assert not engines[language].parse(said, state={MOVING}).actions


def test_why_it_stops_is_told(engines):
    found = engines["en"].parse("no", state={MOVING})
    assert found.objects
    assert "'no'" in found.reason
    assert not engines["en"].parse("stop", state={MOVING}).objects


def test_a_sentence_of_the_grammar_is_its_own(engine_of):
    engine = engine_of("language: en\nintents:\n  answer: {action: custom, sentences: ['yes', 'no']}\n")
    assert not engine.parse("no", state={MOVING}).stops


def test_a_file_adds_its_own(engine_of):
    engine = engine_of(
        "language: en\noperators: {objection: [rubbish]}\nintents: {wave: {action: custom, sentences: [wave]}}\n"
    )
    assert engine.parse("rubbish", state={MOVING}).stops
