"""What is forbidden in other languages: "non girare" forbids "gira", "ne va pas" has two words for "not"."""

from __future__ import annotations

import pytest
from meanings import done

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
slots:
  place: location
  side: {{type: choice, values: {{left: [{left}], right: [{right}]}}}}
  thing: object
intents:
  turn: {{action: {{type: turn, direction: "{{side}}"}}, sentences: ["{turn} {{side}}"]}}
  go: {{action: {{type: navigate, location: "{{place}}"}}, sentences: ["{go} {{place}}"]}}
  pick: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{pick} {{thing}}"]}}
"""
WORDS = {
    "en": {"left": "left", "right": "right", "turn": "turn", "go": "go to the", "pick": "take the"},
    "de": {"left": "nach links", "right": "nach rechts", "turn": "dreh dich", "go": "fahr zum", "pick": "nimm das"},
    "fr": {"left": "à gauche", "right": "à droite", "turn": "tourne", "go": "va au", "pick": "prends le"},
    "es": {"left": "a la izquierda", "right": "a la derecha", "turn": "gira", "go": "ve al", "pick": "coge el"},
    "it": {"left": "a sinistra", "right": "a destra", "turn": "gira", "go": "vai al", "pick": "prendi il"},
}
PLACES = {"bar": (1.0, 2.0), "garage": (3.0, 4.0)}
FORBIDDEN_MOTIONS = [
    ("en", "don't turn"),
    ("de", "dreh dich nicht"),
    ("de", "nicht drehen"),
    ("de", "nicht nach links drehen"),
    ("de", "nicht zum bar fahren"),
    ("en", "you must not go to the bar"),
    ("fr", "ne va pas au bar"),
    ("fr", "n'y va pas"),
    ("fr", "ne tourne plus à gauche"),
    ("fr", "ne tourne pas"),
    ("fr", "ne pas tourner à gauche"),
    ("es", "no gires a la derecha"),
    ("es", "no vayas al bar"),
    ("es", "no gires"),
    ("es", "no girar"),
    ("it", "non girare a sinistra"),
    ("it", "non andare al bar"),
    ("it", "non girare"),
]
OTHERS_FORBIDDEN = [
    ("en", "don't take the cup"),
    ("en", "don't worry"),
    ("de", "nimm das Glas nicht"),
    ("fr", "ne prends pas le verre"),
    ("fr", "ne t'inquiète pas"),
    ("es", "no cojas el vaso"),
    ("es", "no te preocupes"),
    ("it", "non prendere il vaso"),
    ("it", "non preoccuparti"),
]
INSTEAD = [
    ("fr", "ne va pas au bar, va au garage", "go garage"),
    ("fr", "ne va pas au bar mais au garage", "go garage"),
    ("fr", "ne tourne pas à gauche mais à droite", "turn right"),
    ("es", "no vayas al bar sino al garage", "go garage"),
    ("es", "no gires a la izquierda, gira a la derecha", "turn right"),
    ("es", "no gires a la izquierda sino a la derecha", "turn right"),
    ("it", "non girare a sinistra ma a destra", "turn right"),
    ("it", "non andare al bar, gira a destra", "turn right"),
]
NOTHING_INSTEAD = [
    ("fr", "ne va pas au bar, ne va pas au garage"),
    ("fr", "ne va pas seulement au bar mais au garage"),
    ("fr", "ne va pas au bar va au garage"),
    ("es", "no gires a la izquierda ni a la derecha"),
    ("es", "no vayas al bar y ve al garage"),
    ("it", "non girare a sinistra e a destra"),
    ("it", "non andare al bar ma non girare a destra"),
]
ENDED = [
    ("es", "deja de girar"), ("es", "para de girar a la derecha"), ("es", "deje de coger el vaso"),
    ("it", "smetti di girare"), ("it", "smettila di girare a destra"), ("it", "smetti di prendere il vaso"),
]  # fmt: skip
NOT_ENDED = [
    ("es", "deja de hablar"),
    ("es", "no dejes de girar"),
    ("it", "smetti di parlare"),
    ("it", "il treno smetti di girare"),
]


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {
        language: engine_of(GRAMMAR.format(language=language, **words), locations=PLACES)
        for language, words in WORDS.items()
    }


@pytest.mark.parametrize(("language", "said"), FORBIDDEN_MOTIONS)
def test_a_forbidden_motion_stops_what_moves(engines, language: str, said: str) -> None:
    assert done(engines[language].parse(said, state=("moving",))) == "stop"
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize(("language", "said"), OTHERS_FORBIDDEN)
def test_what_else_is_forbidden_changes_nothing(engines, language: str, said: str) -> None:
    for state in ((), ("moving",)):
        assert not engines[language].parse(said, state=state).actions


@pytest.mark.parametrize(("language", "said", "meant"), INSTEAD)
def test_what_is_wanted_instead(engines, language: str, said: str, meant: str) -> None:
    found = engines[language].parse(said)
    assert f"{found.intent} {' '.join(map(str, found.slots.values()))}" == meant


@pytest.mark.parametrize(("language", "said"), NOTHING_INSTEAD)
def test_nothing_else_is_wanted(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize(("language", "said"), ENDED)
def test_what_it_does_is_ended_by_its_name(engines, language: str, said: str) -> None:
    assert done(engines[language].parse(said)) == "stop"


@pytest.mark.parametrize(("language", "said"), NOT_ENDED)
def test_what_is_no_command_ends_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "wart mal"), ("de", "warte kurz hier"), ("fr", "on s'arrête là"), ("fr", "attends ici"),
        ("es", "quiero que pares"), ("es", "espera un poco"), ("es", "espérate"), ("es", "detén el robot"),
        ("it", "aspetta un po'"), ("it", "aspetta qui"), ("it", "voglio che ti fermi"),
    ],
)  # fmt: skip
def test_other_ways_to_hold_what_moves(engines, language: str, said: str) -> None:
    assert done(engines[language].parse(said, state=("moving",))) == "stop"


@pytest.mark.parametrize(
    ("said", "stops"),
    [
        ("don't turn", True),
        ("please do not turn", True),
        ("never turn", True),
        ("don't turn on the radio", False),
        ("don't switch", False),
    ],
)
def test_a_verb_of_a_motion_and_of_something_else(engine_of, said: str, stops: bool) -> None:
    engine = engine_of(
        """
        language: en
        slots: {side: [left, right], device: [radio, fan]}
        intents:
          turn: {action: {type: turn, direction: "{side}"}, sentences: ["turn {side}"]}
          device: {action: custom, sentences: ["(turn|switch) on the {device}"]}
        """
    )
    assert engine.parse(said, state={"moving"}).stops == stops
