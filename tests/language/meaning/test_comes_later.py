"""What says that a command is to be done after what the robot does: "then ring", "ring next"."""

from __future__ import annotations

import pytest

RADIO = """
language: en
slots: {song: {type: text, max_words: 3}}
intents:
  next: {action: custom, sentences: ["play [the] next", "skip to the next song"]}
  play: {action: custom, sentences: ["play {song}", ring]}
"""


@pytest.mark.parametrize(
    ("said", "later"),
    [
        ("then ring", True),
        ("ring next, please", True),
        ("ring after that", True),
        ("ring next, then play yesterday", True),
        ("play yesterday next", True),
        ("play next", False),
        ("please play the next", False),
        ("skip to the next song", False),
        ("ring", False),
        ("ring next to it", False),
    ],
)
def test_what_waits_its_turn(engine_of, said: str, later: bool) -> None:
    assert engine_of(RADIO).comes_later(said) is later
