"""A thing is not called after when or how often it is wanted: "the cup every two hours", "the pills on Monday"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  thing: {type: object, max_words: 6}
  song: {type: text, max_words: 6}
  often: duration
intents:
  fetch: {action: custom, sentences: ["fetch {thing}"]}
  remind: {action: custom, sentences: ["remind me of {thing} every {often}"]}
  play: {action: custom, sentences: ["play {song}"]}
"""
THINGS = st.sampled_from(["cup", "the cup", "the blue pills", "some water"])
WHEN = st.sampled_from(
    ["every hour", "every two hours", "each day", "every morning", "every 4 hours", "every half an hour", "on Monday",
     "this evening", "this afternoon", "all day", "every Friday", "per hour"]
)  # fmt: skip


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(THINGS, WHEN, st.sampled_from(["", " please"]))
def test_nothing_is_done_now_that_is_wanted_then(engine: IntentEngine, thing: str, when: str, end: str) -> None:
    assert not engine.parse(f"fetch {thing} {when}{end}").actions


@pytest.mark.parametrize("said", ["fetch here", "fetch there", "fetch there please"])
def test_a_place_alone_is_nothing_to_fetch(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("fetch the plan of this week", {"thing": "plan of this week"}),
        ("fetch the day cream", {"thing": "day cream"}),
        ("fetch every cup", {"thing": "every cup"}),
        ("fetch this night light", {"thing": "night light"}),
        ("fetch the cup on the table", {"thing": "cup on the table"}),
        ("fetch the cup there", {"thing": "cup there"}),
        ("fetch this week", {"thing": "week"}),
        ("play every day every hour", {"song": "every day every hour"}),
        ("remind me of the blue pills every two hours", {"thing": "blue pills", "often": 7200.0}),
    ],
)
def test_what_is_called_so_is(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert engine.parse(said).slots == slots
