"""English numbers: every number is found again however it is said."""

from __future__ import annotations

import math
from unittest import mock

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers import english, english_words
from intent_engine.language.numbers.english_ordinals import ordinal
from intent_engine.language.numbers.numerals import is_numeral, numeral_value
from intent_engine.language.numbers.spelled import in_digits, in_words

SMALL = [
    *("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
    *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"),
]
TENS = ["", "", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"]
SCALES = [(10**9, "billion"), (10**6, "million"), (10**3, "thousand")]


def spoken(number: int, joint: str = "", one: str = "one", hyphen: str = " ") -> str:
    """A number in words: with "and" or without, "a hundred" or "one hundred", "twenty-five" or "twenty five"."""
    if number < 20:
        return SMALL[number]
    if number < 100:
        ones = f"{hyphen}{SMALL[number % 10]}" if number % 10 else ""
        return TENS[number // 10] + ones
    for size, name in (*SCALES, (100, "hundred")):
        if number >= size:
            top, rest = divmod(number, size)
            before = one if top == 1 else spoken(top, joint, "one", hyphen)
            if not rest:
                return f"{before} {name}"
            between = f" {joint} " if joint and rest < 100 else " "
            return f"{before} {name}{between}{spoken(rest, joint, 'one', hyphen)}"
    raise AssertionError(number)


def words(text: str) -> list[str]:
    return [token.word for token in tokenize(text)]


numbers = st.one_of(st.integers(0, 120), st.integers(0, 10_000), st.integers(0, 999_999_999_999))


@given(numbers, st.sampled_from(["", "and"]), st.sampled_from(["one", "a"]), st.sampled_from([" ", "-"]))
@example(1_001_001, "and", "a", "-")
@example(100, "", "a", " ")
def test_a_whole_number_in_words_is_found_again(number: int, joint: str, one: str, hyphen: str) -> None:
    assert english.number(words(spoken(number, joint, one, hyphen))) == number


@given(numbers, st.booleans())
def test_a_whole_number_in_figures_is_found_again(number: int, grouped: bool) -> None:
    assert english.number(words(f"{number:,}" if grouped else str(number))) == number


@given(st.integers(0, 9_999), st.text("0123456789", min_size=1, max_size=6))
def test_decimals_are_said_figure_by_figure(whole: int, decimals: str) -> None:
    said = f"{spoken(whole)} point {' '.join(SMALL[int(digit)] for digit in decimals)}"
    assert english.number(words(said)) == pytest.approx(float(f"{whole}.{decimals}"))
    assert english.number(words(f"{whole}.{decimals}")) == pytest.approx(float(f"{whole}.{decimals}"))


@given(
    st.integers(1, 500),
    st.sampled_from([("a half", 0.5), ("a quarter", 0.25), ("three quarters", 0.75), ("two thirds", 2 / 3)]),
)
def test_a_number_and_a_fraction(whole: int, part: tuple[str, float]) -> None:
    assert english.number(words(f"{spoken(whole)} and {part[0]}")) == pytest.approx(whole + part[1])


@given(numbers, st.sampled_from(["minus", "negative"]))
def test_a_sign_in_words_changes_nothing_but_the_sign(number: int, sign: str) -> None:
    assert english.number(words(f"{sign} {spoken(number)}")) == -number


@given(st.integers(0, 999_999))
def test_words_and_figures_turn_into_each_other(number: int) -> None:
    assert in_words([str(number)]) == spoken(number).split()
    if number:
        assert in_digits(spoken(number).split()) == (str(number),)


@given(
    st.lists(
        st.sampled_from([*sorted(english_words.NUMBER_WORDS), "and", "a", "of", "third", "over", "7", "-2", "1/2"]),
        max_size=8,
    )
)
def test_no_words_raise_and_every_value_is_finite(said: list[str]) -> None:
    for at in range(len(said) + 1):
        for value, after in english.numbers_at(said, at):
            assert math.isfinite(value)
            assert at < after <= len(said)
    ordinal(said)


@given(
    st.lists(
        st.sampled_from(
            [*sorted(english_words.NUMBER_WORDS), "and", "a", "thirds", "second", "over", "out", "of", "k", "7", "-2",
             "0.5", "1/2", "3rd", "meters", "in", "cups", "twelfth"]
        ),
        max_size=6,
    )
)  # fmt: skip
@example(["five", "thirds"])
@example(["7", "3rd"])
def test_the_short_way_to_a_number_of_one_word_finds_what_the_long_one_does(said: list[str]) -> None:
    places = range(len(said) + 1)
    short = [list(english.numbers_at(said, at)) for at in places]
    with mock.patch.object(english, "_single", return_value=None):
        assert [list(english.numbers_at(said, at)) for at in places] == short


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("one eighty", 180),
        ("two seventy five", 275),
        ("one oh five", 105),
        ("a quarter million", 250_000),
        ("three quarters of a million", 750_000),
        ("half a billion", 5e8),
        ("thirty fifths", 6),
        ("two third", 2 / 3),
        ("thirty fifth", None),
        ("one hundred fourth", None),
        ("one hundred forty fifth", None),
        ("one hundred fortieth", None),
        ("five ten", 510),
        ("twelve hundred", 1200),
        ("12 hundred", 1200),
        ("hundred five", 105),
        ("a couple", 2),
        ("a couple of", 2),
        ("a pair of", 2),
        ("a dozen", 12),
        ("half a dozen", 6),
        ("two dozen", 24),
        ("half", 0.5),
        ("a half", 0.5),
        ("three quarters", 0.75),
        ("two thirds", 2 / 3),
        ("three tenths", 0.3),
        ("a hundredth", 0.01),
        ("two three quarters", 2.75),
        ("point five", 0.5),
        ("two point oh five", 2.05),
        ("two point twenty five", 2.25),
        ("one over four", 0.25),
        ("one out of four", 0.25),
        ("2 million", 2e6),
        ("three point five million", 3.5e6),
        ("two and a half thousand", 2500),
        ("10 k", 10_000),
        ("½", 0.5),
        ("2½", 2.5),
        ("2 1/2", 2.5),
        ("2-1/2", 2.5),
        ("-3.5", -3.5),
        ("fourty", 40),
        ("oh", 0),
    ],
)
def test_short_forms_of_speech(said: str, value: float) -> None:
    assert english.number(words(said)) == pytest.approx(value)


@pytest.mark.parametrize(
    "said",
    [
        *("", "and", "point", "ten five", "twenty thirty", "fifty three zero", "twentieth two", "one two", "a", "once"),
        *("1/0", "1,2,3", "12,34,56", "two and", "hundred and", "minus", "half past two", "9" * 400),
    ],
)
def test_what_is_no_number(said: str) -> None:
    assert english.number(words(said)) is None


@given(st.text("0123456789./-", max_size=12))
def test_a_numeral_has_a_value_or_divides_by_zero(text: str) -> None:
    value = numeral_value(text)
    if value is not None:
        assert is_numeral(text)
        assert math.isfinite(value)
    elif is_numeral(text):
        assert set(text.rpartition("/")[2]) == {"0"}
