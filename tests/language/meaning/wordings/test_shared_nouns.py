"""Names of a list that share their noun: "raise the left and right armrest"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  part: [left armrest, right armrest, seat]
  gate: [front gate, back gate, side gate, barn]
  song: {type: text, max_words: 4}
intents:
  raise: {action: custom, sentences: ["raise the {part}"]}
  open: {action: custom, sentences: ["open [the] {gate}", "close [the] {gate}"]}
  play: {action: custom, sentences: ["play {song}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("raise the left and right armrest", "raise the left armrest, then raise the right armrest"),
        ("raise the left and the right armrest", "raise the left armrest, then raise the right armrest"),
        ("raise the left and right armrests", "raise the left armrest, then raise the right armrest"),
        ("open the front, back and side gate", "open the front gate, open the back gate and open the side gate"),
        ("open the front and back gates please", "open the front gate, then open the back gate"),
    ],
)
def test_each_has_it(engine: IntentEngine, said: str, plain: str) -> None:
    assert_same(engine, said, plain)


@pytest.mark.parametrize(
    "said",
    [
        "raise the left or right armrest", "raise the left and seat armrest", "open the front and barn gate",
        "open the front and close the back gate", "don't raise the left and right armrest",
        "the left and right armrest are up", "raise the left and right", "raise the left and right and",
        "he raised the left and right armrest", "play me and bobby mcgee and and back gate gate gate",
    ],
)  # fmt: skip
def test_nothing_else_is_done(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_a_map_has_such_names(engine_of, tmp_path) -> None:
    places = tmp_path / "map.yaml"
    row = "{x: 1.0, y: 2.0, yaw: 0.0}"
    places.write_text(
        f"frame: map\nlocations:\n  north gate: {row}\n  south gate: {row.replace('1.0', '3.0')}\n", "utf-8"
    )
    grammar = (
        'language: en\nslots: {place: location}\nintents:\n  see: {action: custom, sentences: ["check the {place}"]}\n'
    )
    found = engine_of(grammar, locations=places).parse("check the north and south gate")
    assert [action.slots["place"] for action in found.actions] == ["north gate", "south gate"]
