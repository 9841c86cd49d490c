"""An article behind a joint may begin what belongs to nothing before: "the kitchen lamp and the fan"."""

from __future__ import annotations

import pytest

from intent_engine.interpretation import Status

GRAMMAR = """
slots:
  room: [kitchen, hall]
  device: [lamp, fan]
  on: boolean
intents:
  switch: {action: custom, sentences: ["turn the {room} {device} {on}", "turn the {device} {on}"]}
"""


@pytest.fixture(scope="module")
def parse(engine_of):
    return engine_of(GRAMMAR).parse


def test_it_is_asked_whose_it_is(parse) -> None:
    found = parse("turn the kitchen lamp and the fan on")
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())


@pytest.mark.parametrize(
    ("said", "rooms"),
    [
        ("turn the kitchen lamp and the hall fan on", ["kitchen", "hall"]),
        ("turn the kitchen and the hall lamp on", ["kitchen", "hall"]),
        ("turn the lamp and the fan on", [None, None]),
    ],
)
def test_what_is_said_of_each_is_clear(parse, said: str, rooms: list[str | None]) -> None:
    assert [action.slots.get("room") for action in parse(said).actions] == rooms
