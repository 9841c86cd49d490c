"""Who tells something gives no command."""

from __future__ import annotations

import pytest

from intent_engine.speech.narration import leaves_out


@pytest.mark.parametrize(
    ("text", "story", "left_out"),
    [
        ("turn left", ["when"], True),
        ("turn left when you are there", ["when"], False),
        ("go to the kitchen", ["we"], True),
        ("put the box on the table", ["i"], True),
        ("turn left", ["you"], True),
        ("i need you to turn left", ["i"], False),
        ("id like you to turn left", ["i"], False),
        ("can you turn left", ["you"], False),
        ("i would like you to turn left", ["youd"], False),
        ("can you turn left", ["i"], True),
        ("turn left", [], False),
    ],
)
def test_a_statement_is_no_command(text, story, left_out):
    """ "We go to the kitchen" tells of somebody; who begins so and wants it done says "I want you to"."""
    assert leaves_out(text.split(), story, heard=[]) is left_out


def test_no_word_is_misheard_as_one_that_was_heard():
    """ "Please won't watch in the front room": the "front" was heard as it is, so the "won't" is none."""
    words = ["please", "walk", "in", "the", "front", "room"]
    assert leaves_out(words, ["wont"], heard=["please", "wont", "watch", "in", "the", "front", "room"])
    assert not leaves_out(words, ["wont"], heard=["please", "walk", "in", "the", "wont", "room"])
