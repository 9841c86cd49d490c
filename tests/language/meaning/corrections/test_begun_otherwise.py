"""Corrections that begin another command, or have a verb with which one corrects: no name, and no command more."""

from __future__ import annotations

import pytest

GRAMMAR = """
slots:
  item: {type: text, max_words: 3}
  drink: [tea, coffee]
  n: {type: number, whole: true}
  device: [lamp, fan]
  colour: [red, blue]
intents:
  list: {action: custom, sentences: ["(add|remove) {item} (to|from) the list"]}
  make: {action: custom, sentences: ["make (a|{n}) {drink}"]}
  paint: {action: custom, sentences: ["make the {device} {colour}"]}
  switch: {action: custom, sentences: ["turn on the {device}"]}
"""


@pytest.fixture(scope="module")
def slots(engine_of):
    engine = engine_of(GRAMMAR)
    return lambda said: [dict(action.slots) for action in engine.parse(said).actions]


@pytest.mark.parametrize(
    "said",
    ["remove eggs from the list, no, add eggs", "add eggs to the list, I mean remove eggs",
     "add eggs to the list, no, turn on", "make a tea, make it two"],
)  # fmt: skip
def test_it_is_not_clear(slots, said: str) -> None:
    assert slots(said) == []


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("remove eggs from the list, no, oat milk", [{"item": "oat milk"}]),
        ("make two teas, make it three", [{"n": 3, "drink": "tea"}]),
        ("make a tea, make it a coffee", [{"drink": "coffee"}]),
        ("turn on the lamp, make it red", [{"device": "lamp"}, {"device": "lamp", "colour": "red"}]),
        ("make the lamp red, then make it blue", [{"device": "lamp", "colour": one} for one in ("red", "blue")]),
    ],
)  # fmt: skip
def test_a_part_and_what_is_done_next_are(slots, said: str, meant: list[dict[str, object]]) -> None:
    assert slots(said) == meant


LYING = """
language: {language}
slots:
  way: [{up}, {down}]
  trick: [{down}, {sit}]
intents:
  look: {{action: custom, sentences: ["{look} {{way}}"]}}
  do: {{action: custom, sentences: ["{{trick}}"]}}
"""


@pytest.mark.parametrize(
    ("language", "look", "up", "down", "sit", "joint"),
    [
        ("en", "look", "up", "down", "sit", "and"),
        ("de", "schau", "hoch", "runter", "sitz", "und"),
        ("fr", "regarde", "debout", "couché", "assis", "et"),
        ("es", "mira", "arriba", "abajo", "siéntate", "y"),
        ("it", "guarda", "su", "giù", "seduto", "e"),
    ],
)
def test_a_value_may_be_of_the_verb_before(engine_of, language, look, up, down, sit, joint) -> None:
    engine = engine_of(LYING.format(language=language, look=look, up=up, down=down, sit=sit))
    assert not engine.parse(f"{look} {up} {joint} {down}").actions
    assert len(engine.parse(f"{look} {up} {joint} {sit}").actions) == 2
    assert len(engine.parse(f"{look} {up} {joint} {look} {down}").actions) == 2
