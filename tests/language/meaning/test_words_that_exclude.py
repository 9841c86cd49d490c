"""Words that say no without a "not": what is excluded, or left for something else, is not done."""

from __future__ import annotations

from pathlib import Path

import pytest
from meanings import does, done

from intent_engine.actions import Turn
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

FETCH = """
language: {language}
slots: {{thing: {{type: text, max_words: 6}}}}
intents:
  fetch: {{action: {{type: custom, name: fetch, thing: "{{thing}}"}}, sentences: ["{verb} {{thing}}"]}}
"""
VERBS = {"en": "take", "de": "nimm", "fr": "prends", "es": "toma", "it": "prendi"}
EXCLUDED = [
    ("en", "take the glass rather than the cup"),  # and never: take "than the cup"
    ("en", "take the glass instead of the cup"),
    ("en", "take none of the cups"),
    ("en", "take anything other than the cup"),
    ("en", "take all apart from the cup"),
    ("en", "take the cup in place of the glass"),
    ("de", "nimm keinesfalls die Tasse"),
    ("de", "nimm weder Tasse noch Teller"),
    ("de", "nimm alles außer der Tasse"),
    ("de", "nimm den Teller statt der Tasse"),
    ("de", "nimm nichts"),
    ("fr", "prends rien"),
    ("fr", "prends tout sauf la tasse"),
    ("fr", "prends le verre au lieu de la tasse"),
    ("fr", "prends le verre plutôt que la tasse"),
    ("es", "toma nada"),
    ("es", "toma todo menos la taza"),
    ("es", "toma el vaso en vez de la taza"),
    ("es", "toma la taza a menos que esté llena"),
    ("it", "prendi niente"),
    ("it", "prendi tutto tranne la tazza"),
    ("it", "prendi il bicchiere piuttosto che la tazza"),
    ("it", "prendi nemmeno la tazza"),
]
BROOMS = """
language: en
slots:
  tool: [brush, mop, broom]
intents:
  use: {action: {type: custom, name: use}, sentences: ["use the {tool} in place of the {tool:other}"]}
  home: {action: custom, sentences: [go home]}
"""


def engine_of(text: str, folder: Path) -> IntentEngine:
    file = folder / "grammar.yaml"
    file.write_text(text, encoding="utf-8")
    return IntentEngine.from_files(file)


@pytest.mark.parametrize(("language", "text"), EXCLUDED)
def test_what_is_excluded_is_not_done(language: str, text: str, tmp_path: Path) -> None:
    found = engine_of(FETCH.format(language=language, verb=VERBS[language]), tmp_path).parse(text)
    assert found.status is Status.REJECTED
    assert "negated" in (found.reason or "")


def test_a_grammar_may_compare_in_its_sentences(tmp_path: Path) -> None:
    engine = engine_of(BROOMS, tmp_path)
    assert done(engine.parse("go home and use the brush in place of the mop")) == "home, use"
    assert engine.parse("use the brush in place of the mop, no, the broom").slots["other"] == "broom"
    assert done(engine.parse("don't use the brush in place of the mop")) == "rejected"


def test_words_that_stand_apart_in_a_grammar_compare_nothing(tmp_path: Path) -> None:
    text = (
        FETCH.format(language="en", verb="take")
        + "  warm: {action: custom, sentences: [rather warm, warmer than now]}\n"
    )
    assert not engine_of(text, tmp_path).parse("take the glass rather than the cup").actions


SPANISH = """
language: es
slots: {side: {type: choice, values: {left: [izquierda], right: [derecha]}}}
intents:
  turn: {action: {type: custom, name: turn, side: "{side}"}, sentences: ["gira a la {side}"]}
  ahead: {action: custom, sentences: [avanza]}
"""


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("gira a la izquierda, no, a la derecha", "right"),
        ("Gira a la izquierda. No, gira a la derecha.", "right"),
        ("gira a la izquierda no a la derecha", None),
        ("gira a la izquierda, no a la derecha", None),
        ("gira a la izquierda no, a la derecha", None),
        ("no, gira a la derecha", "right"),
        ("no gira a la derecha", None),
        ("avanza, no, no gira a la derecha", None),
        ("no gira a la izquierda, no, a la derecha", None),
        ("gira a la izquierda, no", None),
    ],
)
def test_spanish_no_corrects_between_pauses_and_else_forbids(text: str, side: str | None, tmp_path: Path) -> None:
    found = engine_of(SPANISH, tmp_path).parse(text)
    assert found.slots.get("side") == side if side else not found.actions


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("turn right instead of left", "right 43"),
        ("turn right, instead of left", "right 43"),
        ("turn right instead of turning left", "right 43"),
        ("go forward instead of turning left", "forward 1"),
        ("go forward rather than turn left", "forward 1"),
        ("go to the kitchen instead of the bedroom", "to kitchen"),
        ("go forward two meters instead of three", "forward 2"),
        ("instead of turning left, go forward", "forward 1"),
        ("don't go to the kitchen, instead go to the bedroom", "to bedroom"),
        ("instead of turning left", "rejected"),
        ("turn right instead of", "rejected"),
        ("turn left instead of right and go forward", "rejected"),
        ("instead of turning left turn right", "rejected"),
    ],
)
def test_what_is_said_instead_of_something_else_is_done(said: str, meant: str) -> None:
    assert does(said) == meant


WAYS = """
language: {language}
fillers: []
slots:
  place: {{type: choice, values: {{bar: [bar], garage: [garage]}}}}
  side: {{type: choice, values: {{left: [{left}], right: [{right}]}}}}
intents:
  turn: {{action: {{type: turn, direction: "{{side}}"}}, sentences: ["{turn} {{side}}"]}}
  go: {{action: custom, sentences: ["{go} {{place}}"]}}
"""
TOLD = {
    "en": {"left": "left", "right": "right", "turn": "turn", "go": "go to the"},
    "de": {"left": "nach links", "right": "nach rechts", "turn": "dreh dich", "go": "fahr zum"},
    "fr": {"left": "à gauche", "right": "à droite", "turn": "tourne", "go": "va au"},
    "es": {"left": "a la izquierda", "right": "a la derecha", "turn": "gira", "go": "ve al"},
    "it": {"left": "a sinistra", "right": "a destra", "turn": "gira", "go": "vai al"},
}


@pytest.mark.parametrize(
    ("language", "said", "angle"),
    [
        ("de", "dreh dich nach links statt nach rechts", 1),
        ("de", "dreh dich nach links, anstatt nach rechts", 1),
        ("fr", "tourne à gauche au lieu de à droite", 1),
        ("fr", "tourne à gauche plutôt qu'à droite", 1),
        ("es", "gira a la izquierda en vez de a la derecha", 1),
        ("es", "gira a la izquierda en lugar de a la derecha", 1),
        ("it", "gira a sinistra invece di a destra", 1),
        ("it", "gira a sinistra anziché a destra", 1),
        ("it", "gira a sinistra piuttosto che a destra", 1),
        ("de", "dreh dich nach links nicht nach rechts", 0),
        ("fr", "tourne à gauche pas à droite", 0),
        ("es", "gira a la izquierda no a la derecha", 0),
        ("it", "gira a sinistra non a destra", 0),
        ("de", "dreh dich nach links statt zum bar", 0),
        ("it", "gira a sinistra invece di", 0),
        # Before them there is what is polite, also where no filler is.
        ("en", "please don't turn left, turn right", -1),
        ("de", "bitte nicht dreh dich nach links, dreh dich nach rechts", -1),
        ("fr", "s'il te plaît ne tourne pas à gauche, tourne à droite", -1),
        ("es", "por favor no gires a la izquierda, gira a la derecha", -1),
        ("it", "per favore non girare a sinistra, gira a destra", -1),
        ("it", "per favore non girare a sinistra", 0),
    ],
)
def test_what_is_excluded_in_other_languages(language: str, said: str, angle: int, tmp_path: Path) -> None:
    actions = engine_of(WAYS.format(language=language, **TOLD[language]), tmp_path).parse(said).actions
    assert [action.angle > 0 for action in actions if isinstance(action, Turn)] == ([angle > 0] if angle else [])
    assert len(actions) == abs(angle)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "fahr zum bar statt zum garage"),
        ("fr", "va au bar au lieu du garage"),
        ("es", "ve al bar en vez del garage"),
        ("it", "vai al bar invece del garage"),
    ],
)
def test_of_two_places_the_one_is_meant_that_is_not_excluded(language: str, said: str, tmp_path: Path) -> None:
    found = engine_of(WAYS.format(language=language, **TOLD[language]), tmp_path).parse(said)
    assert found.slots == {"place": "bar"}
    assert found.actions
