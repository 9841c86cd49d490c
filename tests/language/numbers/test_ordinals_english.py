"""English ordinals: every one is found again however it is said."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.english_ordinals import ordinal
from intent_engine.language.numbers.spelled import in_words

ORDINALS = {
    "one": "first", "two": "second", "three": "third", "five": "fifth", "eight": "eighth", "nine": "ninth",
    "twelve": "twelfth",
}  # fmt: skip


def words(text: str) -> list[str]:
    return [token.word for token in tokenize(text)]


def spoken(number: int) -> str:
    *before, last = in_words([str(number)])
    if last in ORDINALS:
        last = ORDINALS[last]
    elif last.endswith("y"):
        last = last[:-1] + "ieth"
    else:
        last += "th"
    return " ".join((*before, last))


@given(st.integers(1, 999))
def test_an_ordinal_is_found_again(number: int) -> None:
    assert ordinal(words(spoken(number))) == number
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th") if number % 100 not in (11, 12, 13) else "th"
    assert ordinal(words(f"{number}{ending}")) == number


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("third", 3),
        ("the last", -1),
        ("twenty first", 21),
        ("one hundred and first", 101),
        ("two hundred and tenth", 210),
        ("hundredth", 100),
        ("two thousandth", 2000),
        ("22nd", 22),
    ],
)
def test_ordinals(said: str, value: float) -> None:
    assert ordinal(words(said)) == value


@pytest.mark.parametrize(
    "said",
    [
        "",
        "three",
        "ten first",
        "the",
        "firsts",
        "th",
        "twenty and",
        "first second",
        "zero third",
        "number",
        "number half",
    ],
)
def test_what_is_no_ordinal(said: str) -> None:
    assert ordinal(words(said)) is None
