"""Digits said one by one are one number where a slot says so, as pilots and sailors do: "heading one eight zero"."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.engine import PrefixStatus
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.digit_by_digit import MOST_DIGITS, said_together
from intent_engine.language.numbers.spelled import in_words

GRAMMAR = """
language: {language}
fillers: [please, oh, um]
slots:
  heading: {{type: angle, unit: deg, min: 0 deg, max: 360 deg{digits}}}
  channel: {{type: number{digits}}}
  way: {{type: distance, units: {{185.2 m: (cable|cables)}}{digits}}}
  row: {{type: number, whole: true, max: {most}{digits}}}
  place: {{type: number, whole: true, max: {most}{digits}}}
intents:
  steer: {{action: custom, sentences: ["(heading|steer) {{heading}}"]}}
  tune: {{action: custom, sentences: ["tune {{channel}}"]}}
  sail: {{action: custom, sentences: ["sail {{way}} [ahead]"]}}
  put: {{action: custom, sentences: ["put [it at] {{row}} {{place}}"]}}
  lights: {{action: custom, sentences: ["lights off"]}}
"""
ENGLISH = ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"]
GERMAN = ["null", "eins", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun"]


def grammar(language: str = "en", digits: bool = True, most: int = 40) -> str:
    return GRAMMAR.format(language=language, digits=", digits: true" if digits else "", most=most)


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(grammar())


@pytest.fixture(scope="module")
def without(engine_of) -> IntentEngine:
    return engine_of(grammar(digits=False))


@pytest.fixture(scope="module")
def german(engine_of) -> IntentEngine:
    return engine_of(grammar("de"))


ROWS = st.lists(st.integers(0, 9), min_size=2, max_size=MOST_DIGITS)


@given(ROWS, st.sampled_from([ENGLISH, [str(one) for one in range(10)], ["oh", *ENGLISH[1:]]]))
def test_they_are_the_number_that_they_write(engine: IntentEngine, row: list[int], words: list[str]) -> None:
    said = " ".join(words[one] for one in row)
    number = int("".join(map(str, row)))
    assert engine.parse(f"tune {said}").slots == {"channel": number}
    assert engine.parse(f"um, please tune {said} please").slots == {"channel": number}
    assert engine.parse(f"tune {number}").slots == {"channel": number}, "as a recogniser writes it"
    assert engine.parse(f"sail {said} meters").slots == {"way": number}
    assert engine.parse(f"sail {said} cables ahead").slots["way"] == pytest.approx(number * 185.2)
    assert not engine.parse(f"sail {said}").actions, "a unit must be said all the same"
    assert bool(engine.parse(f"heading {said} degrees").actions) == (number <= 360)


PAIRS = st.tuples(st.integers(10, 99), st.lists(st.integers(1, 99), min_size=1, max_size=2))


def in_pairs(first: int, rest: list[int]) -> str:
    return " ".join(f"oh {ENGLISH[one]}" if one < 10 else " ".join(in_words([str(one)])) for one in (first, *rest))


@given(PAIRS)
def test_two_by_two_they_are_the_number_that_they_write(engine: IntentEngine, pairs: tuple[int, list[int]]) -> None:
    """As rooms and years are said: "eleven thirty", "nineteen oh five"."""
    first, rest = pairs
    said, written = in_pairs(first, rest), "".join(map("{:02}".format, (first, *rest)))
    assert engine.parse(f"tune {said}").slots == {"channel": int(written)}
    assert engine.parse(f"tune {' '.join(map('{:02}'.format, (first, *rest)))}").slots == {"channel": int(written)}
    assert engine.parse(f"sail {said} meters").slots == {"way": int(written)}
    words = said.split()
    for count in range(1, len(words)):
        assert words[count] in engine.prefix("tune " + " ".join(words[:count])).next_words


@given(PAIRS)
def test_so_only_where_the_slot_says_so_too(without: IntentEngine, pairs: tuple[int, list[int]]) -> None:
    assert not without.parse(f"tune {in_pairs(*pairs)}").actions


@pytest.mark.parametrize(
    "said", ["eleven three", "oh five eleven", "twenty thirty hundred", "eleven thirty four hundred"]
)
def test_what_is_no_row_of_pairs(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(f"tune {said}").actions


@given(st.lists(st.integers(1, 9), min_size=2, max_size=MOST_DIGITS))
def test_only_where_the_slot_says_so(without: IntentEngine, row: list[int]) -> None:
    for words in (ENGLISH, [str(one) for one in range(10)]):
        assert not without.parse("tune " + " ".join(words[one] for one in row)).actions


@given(ROWS)
def test_in_german(german: IntentEngine, row: list[int]) -> None:
    number = int("".join(map(str, row)))
    for words in (GERMAN, [str(one) for one in range(10)]):
        said = " ".join(words[one] for one in row)
        assert german.parse(f"tune {said}").slots == {"channel": number}
        assert german.parse(f"sail {said} meter").slots == {"way": number}


@pytest.mark.parametrize(
    "said", ["five ten", "five ten degrees", "one two hundred", "twenty one two", "one two twenty"]
)
def test_numbers_of_more_than_a_digit_are_no_digits(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(f"heading {said}").actions
    words = [token.word for token in tokenize(said)]
    assert said_together(words, "en") == words


@pytest.mark.parametrize(
    ("said", "degrees"),
    [
        ("heading one eighty", 180),
        ("heading one eight oh", 180),
        ("please heading one eight oh please", 180),
        ("heading oh nine oh, please", 90),
        ("heading one eight, oh, please", 18),
        ("heading one eight zero, no, one nine zero", 190),
        ("heading nine, no, one nine zero", 190),
        ("heading three six zero", 360),
    ],
)
def test_a_heading(engine: IntentEngine, said: str, degrees: float) -> None:
    assert engine.parse(said).slots["heading"] == pytest.approx(math.radians(degrees))


@pytest.mark.parametrize(
    "said",
    ["heading three six one", "heading one um eight zero", "don't steer one eight zero", "heading one eight zero, no"],
)
def test_nothing_is_done(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    ("said", "channel"),
    [
        ("tune 1, 8, 0", 180),
        ("tune 1-8-0", 180),
        ("tune one, eight, zero", 180),
        ("tune two thousand, nineteen", 2019),
        ("tune 12:34", 1234),
        ("tune one two three, no, four five six", 456),
        ("tune one two three, no, fourteen", 14),
        ("tune 14, no, 5", 5),
    ],
)
def test_pauses_between_all_of_them(engine: IntentEngine, said: str, channel: float) -> None:
    assert engine.parse(said).slots == {"channel": channel}


@pytest.mark.parametrize(
    "said",
    ["tune 14, 15", "tune fourteen, fifteen", "tune one four, one five", "tune 1, 2", "tune 14, 15, 16",
     "tune 12-15", "tune 12 - 15", "tune 1-2", "tune 12: 34", "sail 14, 15 meters",
     "tune one two three, no, four", "tune one, two, three, no, four five"],
)  # fmt: skip
def test_in_pieces_they_may_be_several(engine: IntentEngine, said: str) -> None:
    """ "14, 15" may be two, "12-15" all from the one to the other, "no, four" only the last of them."""
    assert not engine.parse(said).actions
    assert not engine.parse(said, heard=True).actions


@pytest.mark.parametrize(
    ("said", "done"), [("tune eins, acht, null", True), ("tune 14, 15", False), ("tune 1, 2", False)]
)
def test_in_pieces_in_german(german: IntentEngine, said: str, done: bool) -> None:
    assert bool(german.parse(said).actions) is done


def test_where_the_first_piece_can_be_none_they_are_one(engine_of) -> None:
    years = engine_of(grammar().replace("channel: {type: number", "channel: {type: number, min: 1900"))
    assert years.parse("tune 20, 19").slots == {"channel": 2019}


def test_a_point_may_stand_among_them(engine: IntentEngine) -> None:
    assert engine.parse("tune one one eight point seven five").slots == {"channel": 118.75}
    assert engine.parse("tune minus one five").slots == {"channel": -15}


def test_another_command_may_follow(engine: IntentEngine) -> None:
    for said in ("heading one eight zero and lights off", "heading one eight zero, lights off"):
        assert [action.name for action in engine.parse(said).actions] == ["steer", "lights"]


@given(st.lists(st.integers(1, 9), min_size=2, max_size=5), st.sampled_from([9, 40, 400]))
def test_two_numbers_that_could_be_parted_otherwise_are_none(engine_of, row: list[int], most: int) -> None:
    text = "".join(map(str, row))
    cuts = [(int(text[:at]), int(text[at:])) for at in range(1, len(text))]
    ways = [cut for cut in cuts if max(cut) <= most]
    found = _parted(engine_of, most).parse("put it at " + " ".join(ENGLISH[one] for one in row))
    if found.actions:
        assert ways == [(found.slots["row"], found.slots["place"])]
        assert int(text) > most, "who leaves out the other"


_ENGINES: dict[int, IntentEngine] = {}


def _parted(engine_of, most: int) -> IntentEngine:
    if most not in _ENGINES:
        _ENGINES[most] = engine_of(grammar(most=most))
    return _ENGINES[most]


def test_what_is_looked_ahead_to(engine: IntentEngine) -> None:
    found = engine.prefix("heading one eight")
    assert found.status is PrefixStatus.EXTENDABLE
    assert not found.settled
    assert {"zero", "nine", "degrees"} <= set(found.next_words)
    assert engine.prefix("sail one eight").status is PrefixStatus.INCOMPLETE
