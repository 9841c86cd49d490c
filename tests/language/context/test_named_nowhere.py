"""An "it" that says where something goes is something that was named."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, done, shipped

WHERE = st.sampled_from(["in", "on", "under", "next to"])
MANY = st.sampled_from(["a", "some"])


@given(st.sampled_from(["stick a fork", "put a lid", "put some ice", "place a pin", "lay a cloth"]), WHERE)
def test_one_of_many_things_is_put_nowhere(put: str, where: str) -> None:
    """Of "a lid" nothing is known, so neither is on what it belongs."""
    assert does(f"{put} {where} it") in ("rejected", "incomplete")
    assert does(f"{put} {where} it and turn left") in ("rejected", "incomplete")


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("take the pot and put a lid on it", "pick pot, place lid it"),
        ("put the lid on it", "place lid it"),  # which somebody points at, or the robot holds
        ("put my cup next to it", "place cup it"),
        ("put it on a table", "place it table"),
        ("go to the kitchen and put it on a tray", "to kitchen, place it tray"),
        ("put a lid on the pot", "place lid pot"),
        ("bring a coffee to them", "bring"),  # who stand there
    ],
)
def test_what_was_named_or_is_held_is_known(said: str, meant: str) -> None:
    assert does(said) == meant


@given(MANY, WHERE)
def test_what_was_named_by_the_utterance_before_is_known(article: str, where: str) -> None:
    command = f"put {article} cloth {where} it"
    assert done(shipped().parse(command, last=shipped().parse("pick up the pot"))) == "place cloth it"
    assert not shipped().parse(command, last=[]).actions
    found = shipped().parse(command)
    assert found.reason == "'it' is nothing that was named; say where"


def test_a_text_may_be_about_anything(engine_of) -> None:
    engine = engine_of("""
slots: {kind: {type: text, max_words: 2}, subject: {type: text, max_words: 2}}
intents: {write: {action: custom, sentences: ["write {kind} about {subject}"]}}
""")
    assert engine.parse("write a poem about it").actions
