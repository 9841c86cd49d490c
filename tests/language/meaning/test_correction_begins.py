"""What a command may begin with says nothing behind a correction either: "no, I mean please go ahead and ..."."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, german

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  room: [kitchen, lab]
  thing: {type: object, max_words: 6}
  gear: {type: ordinal, min: 1, max: 5}
intents:
  visit: {action: custom, sentences: ["visit the {room}"]}
  fetch: {action: custom, sentences: ["fetch {thing}"]}
  gear: {action: custom, sentences: ["shift to [{gear}] gear"]}
  ahead: {action: custom, sentences: ["go ahead"]}
"""
CORRECTIONS = ["I mean", "no", "no, I mean", "sorry", "or rather", "actually", "no wait", "scratch that", "oops"]
POLITE = ["go ahead and", "please go ahead and", "could you please", "uh can you", "let's", "I want you to", "please"]
OPENERS = ["first", "first of all", "well", "uh well", "just", "but", "but please"]


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@given(
    st.sampled_from(["turn left", "pick up the cup", "go to the kitchen", "go forward two meters"]),
    st.sampled_from(CORRECTIONS),
    st.sampled_from([" ", ", "]),
    st.sampled_from(POLITE + OPENERS),
    st.sampled_from(["turn right", "go to the bedroom", "go back"]),
)
def test_only_the_last_is_done(first: str, correction: str, pause: str, begin: str, last: str) -> None:
    assert does(f"{first}, {correction}{pause}{begin} {last}") == does(last)


@given(
    st.sampled_from(["visit the lab", "fetch the cup", "shift to third gear"]),
    st.sampled_from(CORRECTIONS),
    st.sampled_from(POLITE + OPENERS),
    st.sampled_from(["visit the kitchen", "fetch the old red box", "shift to first gear"]),
)
def test_only_the_last_is_done_of_a_small_grammar(
    engine: IntentEngine, first: str, correction: str, begin: str, last: str
) -> None:
    assert engine.parse(f"{first}, {correction}, {begin} {last}").actions == engine.parse(last).actions != ()


@pytest.mark.parametrize("begin", ["bitte", "zuerst", "also"])
def test_in_german(begin: str) -> None:
    found = german().parse(f"dreh dich nach links, nein, {begin} dreh dich nach rechts")
    assert found.actions == german().parse("dreh dich nach rechts").actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("fetch the cup, no, first the ball", {"thing": "ball"}),
        ("fetch the cup, no, well, the ball", {"thing": "ball"}),
        ("shift to second gear, no, first gear", {"gear": 1.0}),
        ("shift to second gear, no, well, third gear", {"gear": 3.0}),
    ],
)
def test_a_part_that_is_put_right_may_begin_so(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert engine.parse(said).slots == slots


def test_what_is_a_command_stays_one(engine: IntentEngine) -> None:
    assert [one.name for one in engine.parse("visit the lab, no, go ahead").actions] == ["ahead"]
    assert engine.parse("visit the lab, no, then visit the kitchen").actions == ()


@pytest.mark.parametrize(
    ("language", "tools", "said", "told"),
    [
        ("en", "the hammer, saw", "take the saw, no, the hammer", "corrected to 'take the hammer'"),
        ("en", "a long rope, saw", "take a saw, no, a long rope", "corrected to 'take a long rope'"),
        ("de", "den Hammer, Pinsel", "take den Pinsel, nein, den Hammer", "corrected to 'take den hammer'"),
    ],
)
def test_no_article_is_told_twice(engine_of, language: str, tools: str, said: str, told: str) -> None:
    article = said.split()[1]
    engine = engine_of(f"""
    language: {language}
    slots: {{tool: [{tools}]}}
    intents:
      take: {{action: custom, sentences: ["take {article} {{tool}}"]}}
    """)
    assert engine.parse(said).reason == told


LAMP = """
language: en
slots:
  colour: [red, blue]
intents:
  colour: {action: custom, sentences: ["make it {colour}"]}
"""


def test_a_command_may_begin_with_words_that_correct(engine_of) -> None:
    """Behind "no", which with "make it" is one such word more."""
    lamp = engine_of(LAMP)
    assert lamp.parse("no, make it blue").actions == lamp.parse("make it blue").actions != ()
    assert not lamp.parse("no make it blue").actions, "which may forbid it"
