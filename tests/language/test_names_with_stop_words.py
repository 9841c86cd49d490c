"""Things that are listed by a name with a word that stops, joins or denies: "brake pads", "stop sign"."""

from __future__ import annotations

import pytest

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  tool: {type: object, known: [brake pads, stop sign, parking brake, cup, salt and pepper]}
  title: {type: text, known: [if you leave]}
intents:
  fetch: {action: pick, sentences: ["(hand me|drop) {tool:object}"]}
  play: {action: custom, sentences: ["play {title}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize("state", [(), ("moving",)], ids=str)
@pytest.mark.parametrize("name", ["brake pads", "stop sign", "parking brake", "salt and pepper"])
@pytest.mark.parametrize("said", ["hand me the {}", "hand me {}", "please hand me the {}", "hand me the {} please"])
def test_a_listed_thing_is_meant_by_its_whole_name(engine: IntentEngine, said: str, name: str, state) -> None:
    found = engine.parse(said.format(name), state=state)
    assert [action.object for action in found.actions] == [name], found.reason


def test_any_words_of_a_listed_title(engine: IntentEngine) -> None:
    assert engine.parse("play if you leave").slots == {"title": "if you leave"}


@pytest.mark.parametrize("said", ["hand me the brake", "hand me the stop", "hand me the cup, stop", "stop", "brake"])
def test_the_words_alone_are_what_they_were(engine: IntentEngine, said: str) -> None:
    assert all(isinstance(action, Stop) for action in engine.parse(said, state=("moving",)).actions)


@pytest.mark.parametrize(
    "said", ["hand me the brake cup", "hand me the pads brake", "hand me salt and", "play if", "play if you go"]
)
def test_nothing_but_the_name_is_taken(engine: IntentEngine, said: str) -> None:
    assert not any(not isinstance(action, Stop) for action in engine.parse(said).actions)


def test_two_things_are_two(engine: IntentEngine) -> None:
    found = engine.parse("hand me the cup and hand me the brake pads")
    assert [action.object for action in found.actions] == ["cup", "brake pads"]
