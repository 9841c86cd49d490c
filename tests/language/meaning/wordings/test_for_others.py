"""For whom something is done: it changes nothing of what is done with a thing that a grammar lists."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  load: [towels, whites]
  count: {type: number, whole: true}
  drink: [tea, coffee]
  item: {type: object, max_words: 4}
  song: {type: text, max_words: 5}
  note: {type: text, dictation: true}
  room: [kitchen, lab]
intents:
  fold: {action: custom, sentences: ["fold the {load} [into {count} piles]"]}
  order: {action: custom, sentences: ["order {count} {drink}"]}
  film: {action: custom, sentences: ["film the {item}"]}
  play: {action: custom, sentences: ["play {song}"]}
  search: {action: custom, sentences: ["search the {room}", "look around", "bring the {load}", "turn around"]}
  say: {action: custom, sentences: ["write {note}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("film the propeller for us", "film the propeller"),
        ("for us fold the towels", "fold the towels"),
        ("fold the towels for him", "fold the towels"),
        ("fold the whites into two piles for my wife, please", "fold the whites into two piles"),
        ("could you order two teas for the guests", "order two tea"),
        ("hm, order two teas for everyone", "order two tea"),
        ("play me a song", "play a song"),
        ("play us the song", "play the song"),
    ],
)
def test_it_is_done_as_for_nobody(engine: IntentEngine, said: str, command: str) -> None:
    assert_same(engine, said, command)


@pytest.mark.parametrize(
    "said",
    [
        # They are where it goes, or what is looked for.
        "bring the towels for her", "search the lab for the kids", "search the kitchen for him", "look around for them",
        # More follows, or another is meant.
        "fold the towels for him or her", "fold the towels for the kids who are here", "fold the towels for the door",
        "fold the towels for kids", "fold the towels, for her", "fold the towels for the kids when they come",
        "don't fold the towels for her", "fold the towels, not for him", "fold for him", "turn around for him",
        "film for us",
        # Who tells of it, or asks.
        "he folds the towels for her", "did you fold the towels for the kids?", "she said fold the towels for him",
        "fold the towels for the kids, she said",
    ],
)  # fmt: skip
def test_what_may_mean_something_else_does_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


def test_words_of_a_title_or_a_message_stay(engine: IntentEngine) -> None:
    assert engine.parse("play songs for the kids").slots == {"song": "songs for the kids"}
    assert engine.parse("play songs for him").slots == {"song": "songs for him"}
    assert engine.parse("film the gift for him").slots == {"item": "gift for him"}
    assert engine.parse("write me a poem").slots == {"note": "me a poem"}
