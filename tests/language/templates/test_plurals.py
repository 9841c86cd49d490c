"""One thing and more of it: what people say of the words that a grammar has."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

WAITER = """
language: en
slots:
  n: {type: number, min: 1, max: 8, whole: true}
  table: {type: number, min: 1, max: 24, whole: true}
  bar: {type: number, max: 6}
  dish: [soup, salad, glass of wine]
  thing: {type: object, known: [cup]}
intents:
  serve: {action: custom, sentences: ["bring [{n}] {dish} to table {table}"]}
  tips: {action: custom, sentences: ["pick up {n} [fresh] tips"]}
  spray: {action: custom, sentences: ["spray at {bar} bar"]}
  order: {action: custom, sentences: ["order {n} coffee", "for table {table} order {n} coffee"]}
  photo: {action: custom, sentences: ["take a photo", "take {n} more photos"]}
  row: {action: custom, sentences: ["sow {n} row [by] {table}", "sow {n} rows"]}
  wait: {action: custom, sentences: ["wait [for {n} minutes]"]}
  wipe: {action: custom, sentences: ["wipe the {thing} {n} times"]}
"""


@pytest.fixture(scope="module")
def waiter(engine_of) -> IntentEngine:
    return engine_of(WAITER)


@pytest.mark.parametrize(
    ("said", "written"),
    [
        ("pick up one tip", "pick up one tips"),
        ("pick up 1 fresh tip, please", "pick up 1 fresh tips"),
        ("spray at two point five bars", "spray at 2.5 bar"),
        ("order two coffees", "order two coffee"),
        ("take 1 more photo", "take 1 more photos"),
        ("take three more photo", "take 3 more photos"),
        ("wipe the cups one time", "wipe the cups one times"),
        ("bring two, no, three soups to table 6", "bring three soup to table 6"),
        ("bring two soups, no, salads to table 6", "bring two salad to table 6"),
        ("bring two soups to table 6, no, to table 7", "bring two soup to table 7"),
        ("bring two soups to table 6, no, three soups to table 7", "bring three soup to table 7"),
        ("bring two, no, three glasses of wine to table 6", "bring three glass of wine to table 6"),
    ],
)
def test_more_of_a_thing_is_what_the_grammar_has_for_one(waiter, said, written):
    assert waiter.parse(said).actions == waiter.parse(written).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "table 4 orders two coffees",
        "for table 4 orders two coffee",
        "picks up two tips",
        "spray at two barrels",
        "sow three row",  # may have broken off
        "take a more photo",
        "take 3 photos of the cup",
        "take 3 photo of the cup",
        "don't bring two soups to table 6",
        "bring two soups or three salads to table 6",
        "bring nine soups to table 6",
        "did you bring two soups to table 6",
        "if he wants two coffees order two coffees",
    ],
)
def test_nobody_is_obeyed_who_only_tells(waiter, said):
    assert not waiter.parse(said).actions


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        (
            "bring two soups to table 5, no, 6",
            "it is not clear what '6' takes the place of; say the whole command again",
        ),
        ("take a photo, wait for two minutes and take it", "'take it' is not a command of this grammar"),
    ],
)
def test_what_is_not_clear_is_told(waiter, said, reason):
    assert waiter.parse(said).reason == reason


HALL = """
slots:
  n: {type: number, min: 1, max: 40, whole: true}
  lamp: {type: number, min: 1, max: 9, whole: true}
  time: duration
intents:
  wipe: {action: custom, sentences: ["wipe [the] table {n} [for {time}]"]}
  all: {action: custom, sentences: ["wipe all [the] tables", "count the lamps"]}
  dim: {action: custom, sentences: ["dim lamp {lamp}"]}
  pair: {action: custom, sentences: ["join benches {n} and {n:other}", "move bench {n}"]}
  order: {action: custom, sentences: ["table {n} wants tea", "lift {n}", "lamp {lamp} is broken"]}
"""


@pytest.mark.parametrize(
    ("said", "done_for"),
    [
        ("wipe tables 4 and 5", [4, 5]),
        ("please wipe the tables 4, 5 and 6", [4, 5, 6]),
        ("dim lamps two and three", [2, 3]),
        ("lift 3 and lifts 4", None),
        ("lifts 3 and 4", None),
        ("he lifts 3 and 4", None),
        ("wipe tables 4", None),
        ("wipe tables", None),
        ("wipe tables 4 or 5", None),
        ("wipe tables 4 to 6", None),
        ("wipe tables 4 and 50", None),
        ("wipe tables 4 and 5 for ten minutes", None),
        ("don't wipe tables 4 and 5", None),
        ("we wiped tables 4 and 5", None),
        ("count lamps 4 and 5", None),
    ],
)
def test_several_are_named_though_the_grammar_has_the_word_for_more(engine_of, said: str, done_for) -> None:
    found = engine_of(HALL).parse(said)
    assert ([next(iter(one.slots.values())) for one in found.actions] or None) == done_for


def test_a_sentence_of_several_is_one(engine_of) -> None:
    (action,) = engine_of(HALL).parse("join benches 3 and 4").actions
    assert action.slots == {"n": 3, "other": 4}


POST = """
slots:
  who: [Anna, Tom, Ben]
  message: {type: text, max_words: 8}
  plant: [fern, cactus]
  thing: {type: text, max_words: 3}
  n: {type: number, whole: true}
intents:
  tell: {action: custom, sentences: ["tell {who} [that] {message}", "say {message}", "tell desk {n} [that] {message}"]}
  water: {action: custom, sentences: ["water [{n}] [the] {plant} [{thing}]"]}
"""


@pytest.mark.parametrize(
    "said",
    [
        "tell Anna's son that I'm here",
        "tell Tom’s wife it is late",
        "Tell Ben's mother hello",
        "water the fern's pot",
        "tell desk 4's guest it is late",
    ],
)
def test_who_owns_something_is_no_name_in_the_plural(engine_of, said: str) -> None:
    assert not engine_of(POST).parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("tell desk 4 it's Tom's turn", {"n": 4, "message": "its toms turn"}),
        ("tell Anna it's Tom's turn", {"who": "Anna", "message": "its toms turn"}),
        ("water the ferns", {"plant": "fern"}),
        ("water two fern's", {"n": 2, "plant": "fern"}),  # as many write it
    ],
)
def test_what_is_named_in_the_plural_is(engine_of, said: str, slots) -> None:
    assert engine_of(POST).parse(said).slots == slots


@pytest.mark.parametrize(
    "said", ["tell Anna or Tom that it is late", "tell Anna or Tom it is late", "water the fern or cactus"]
)
def test_free_words_do_not_begin_with_another_name(engine_of, said: str) -> None:
    """Who is told, and which plant is meant, is left open."""
    assert not engine_of(POST).parse(said).actions


def test_free_words_may_tell_of_two(engine_of) -> None:
    assert engine_of(POST).parse("say now or never").actions == ()  # "never" denies
    assert engine_of(POST).parse("say tea or coffee").slots == {"message": "tea or coffee"}
