"""Numbers in the words of a template: heard as they are spoken, and as a recogniser writes them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.numbers.spelled import in_words, number_otherwise
from intent_engine.language.template import parse_template
from intent_engine.language.templates.numbered import numbers_either_way
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import template_text

RADIO = """
language: en
phrases:
  gear: "gear twenty one"
slots:
  level: [level 2, level three, first level]
intents:
  tune:
    action: {type: custom, name: tune}
    sentences:
      - "tune to channel 5"
      - "use {gear}"
      - "make a 180 [now]"
      - "set {level}"
      - "(room 7|b 12|hall one hundred and five)"
      - "code 007"
      - "mind the third rail"
"""


@pytest.fixture(scope="module")
def radio(engine_of) -> IntentEngine:
    return engine_of(RADIO)


DRAWERS = """
language: en
slots:
  ward: {type: choice, values: {ward: "ward {#}", dock: "dock {#} b"}}
intents:
  open:
    action: custom
    sentences: ["open drawer {#}"]
    then: ["drawer {#}"]
  show: {action: custom, sentences: ["show {ward}"]}
"""
SCHUBLADEN = "language: de\nintents:\n  auf: {action: custom, sentences: ['öffne schublade {#}']}\n"


@pytest.fixture(scope="module")
def drawers(engine_of) -> IntentEngine:
    return engine_of(DRAWERS)


@pytest.fixture(scope="module")
def places() -> IntentEngine:
    return IntentEngine.from_files("grammars/en.yaml", locations=MAP)


@pytest.mark.parametrize(
    "text",
    [
        *("tune to channel 5", "tune to channel five", "use gear 21", "use gear twenty one", "use gear twenty-one"),
        *("make a 180", "make a one hundred eighty now", "make a one hundred and eighty", "make a one eighty"),
        *("set level two", "set level 2", "set level 3", "room seven", "b twelve", "b 12"),
        *("set 1st level", "set first level", "mind the 3rd rail"),
        *("hall 105", "hall one hundred five", "hall one hundred and five", "code 007"),
    ],
)
def test_a_number_in_a_template_may_be_said_and_written(radio: IntentEngine, text: str) -> None:
    heard = radio.parse(text)
    assert heard.status is Status.ACCEPTED, heard


@pytest.mark.parametrize(
    "text", ["tune to channel six", "use gear 1", "use gear twenty", "make a eighty", "code seven"]
)
def test_another_number_is_another_number(radio: IntentEngine, text: str) -> None:
    assert not radio.parse(text).actions


@given(st.integers(1, 999_999))
def test_every_whole_number_is_in_words_and_in_digits(number: int) -> None:
    digits, words = (str(number),), tuple(in_words([str(number)]))
    for written in (digits, words):
        template = parse_template(f"tune to {' '.join(written)} now")
        ways = spellings(numbers_either_way(template), {}, 9)
        assert ("tune", "to", *digits, "now") in ways
        assert ("tune", "to", *words, "now") in ways


NUMBERS = st.one_of(st.integers(0, 999), st.integers(0, 9_999), st.integers(0, 999_999))


@given(NUMBERS, NUMBERS)
def test_no_number_is_said_as_another(one: int, other: int) -> None:
    said, said_otherwise = ({(str(number),), *number_otherwise([str(number)])[1]} for number in (one, other))
    assert one == other or said.isdisjoint(said_otherwise)


@given(NUMBERS.filter(bool))
def test_each_way_to_say_a_number_leads_to_its_digits(number: int) -> None:
    assert number_otherwise([str(number), "b"])[0] == 1
    words = tuple(in_words([str(number)]))
    length, others = number_otherwise([*words, "b"])
    assert length == len(words)
    assert (str(number),) in others
    assert words not in others
    assert len(set(others)) == len(others)


@pytest.mark.parametrize(
    ("number", "ways"),
    [
        ("12", "twelve"),
        ("204", "two hundred four|two hundred and four|two oh four|two zero four"),
        ("110", "one hundred ten|one hundred and ten|one ten|one one oh|one one zero"),
        ("1205", "one thousand two hundred five|one thousand two hundred and five|twelve oh five|twelve zero five|"
                 "one two oh five|one two zero five"),
        ("1500", "one thousand five hundred|fifteen hundred|one five oh oh|one five zero zero"),
        ("10001", "ten thousand one|ten thousand and one"),
        ("007", ""),
        ("1.5", ""),
    ],
)  # fmt: skip
def test_how_a_number_is_said(number: str, ways: str) -> None:
    assert {" ".join(way) for way in number_otherwise([number])[1]} == {way for way in ways.split("|") if way}


@pytest.mark.parametrize(
    ("number", "ways"),
    [
        ("third", "3rd"),
        ("21st", "twenty first"),
        ("twenty first", "21st|20 first"),
        ("twenty second", "22nd|20 second"),
    ],
)
def test_how_an_ordinal_is_written(number: str, ways: str) -> None:
    assert {" ".join(way) for way in number_otherwise(number.split())[1]} == set(ways.split("|"))


MAP = {
    name: {"x": x, "y": 0}
    for x, name in enumerate(("room 204", "building 3 room 12", "gate 1205", "lab 3b", "21st street"))
}


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("go to room two oh four", "room 204"),
        ("go to room 204", "room 204"),
        ("go to room two hundred and four", "room 204"),
        ("go to room two zero four", "room 204"),
        ("go to building three room 12", "building 3 room 12"),
        ("go to building 3 room twelve", "building 3 room 12"),
        ("go to gate twelve oh five", "gate 1205"),
        ("go to lab three b", "lab 3b"),
        ("go to twenty first street", "21st street"),
        ("go to 21st street", "21st street"),
    ],
)
def test_the_number_of_a_place_is_said_as_people_say_it(places: IntentEngine, text: str, name: str) -> None:
    heard = places.parse(text)
    assert heard.status is Status.ACCEPTED, heard
    assert [goal.location for goal in heard.actions] == [name]


@pytest.mark.parametrize("text", ["go to room two oh five", "go to room two four", "go to gate twelve five"])
def test_another_number_is_another_place(places: IntentEngine, text: str) -> None:
    assert not places.parse(text).actions


@pytest.mark.parametrize("text", ["go [to] the (left|right)", "(a;b c) {slot:name} {#}", "code 007", "12345678"])
def test_a_template_without_numbers_that_are_said_is_left_as_it_is(text: str) -> None:
    node = parse_template(text)
    assert template_text(numbers_either_way(node)) == template_text(node)


NAMED = st.sampled_from(("open drawer {}", "show ward {}", "show dock {} b"))


@given(NAMED, st.integers(0, 99_999), st.booleans())
def test_a_number_of_a_name_is_one_whole_number(drawers: IntentEngine, text: str, number: int, spoken: bool) -> None:
    said = " ".join(in_words([str(number)])) if spoken else str(number)
    assert len(drawers.parse(text.format(said)).actions) == 1


@given(NAMED, st.integers(0, 999), st.integers(1, 9), st.booleans())
def test_no_part_of_a_number_and_none_below_zero_is_one_of_a_name(
    drawers: IntentEngine, text: str, number: int, tenths: int, spoken: bool
) -> None:
    whole = " ".join(in_words([str(number)])) if spoken else str(number)
    part = f"{whole} point {in_words([str(tenths)])[0]}" if spoken else f"{whole}.{tenths}"
    below = f"minus {whole} {in_words([str(tenths)])[0]}" if spoken else f"-{number + 1}"
    for said in (part, below, f"{whole} and a half"):
        assert not drawers.parse(text.format(said)).actions


@given(st.sampled_from(("show ward {}", "show dock {} b")), st.integers(0, 99), st.integers(0, 99), st.booleans())
def test_two_numbers_are_none_of_a_name(drawers: IntentEngine, text: str, one: int, other: int, spoken: bool) -> None:
    pair = [" ".join(in_words([str(number)])) if spoken else str(number) for number in (one, other)]
    assert not drawers.parse(text.format(" and ".join(pair))).actions


@pytest.mark.parametrize(
    ("text", "count"),
    [
        *(("open drawer 7 and 8", 0), ("open drawer seven and eight", 0), ("open drawer 100 and 5", 1)),
        *(("open drawer 7 and drawer 8", 2), ("open drawer seven and drawer eight", 2)),
    ],
)
def test_of_two_numbers_each_needs_its_name(drawers: IntentEngine, text: str, count: int) -> None:
    assert len(drawers.parse(text).actions) == count


def test_a_number_of_a_name_that_sounds_like_a_word_is_one(drawers: IntentEngine) -> None:
    assert drawers.parse("show dock for b").actions


@pytest.mark.parametrize(
    ("said", "opens"),
    [("7", True), ("sieben", True), ("einundzwanzig", True), ("siebeneinhalb", False), ("minus sieben", False)],
)
def test_it_is_one_in_any_language(engine_of, said: str, opens: bool) -> None:
    assert bool(engine_of(SCHUBLADEN).parse(f"öffne schublade {said}").actions) is opens
