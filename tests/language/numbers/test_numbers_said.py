"""Numbers of other languages, to words and back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.numbers import foreign, said
from intent_engine.language.numbers.spelled import in_digits, in_words, number_words

LANGUAGES = st.sampled_from(["de", "es", "fr"])


@given(LANGUAGES, st.integers(2, 999))
def test_a_whole_number_comes_back(language, number):
    words = said.spell(number, language)
    assert words
    assert all(word == word.lower() and word.isalpha() for word in words)
    assert foreign.number(words, language) == number
    assert in_digits(words, language) == (str(number),)


@given(LANGUAGES, st.integers(0, 99), st.integers(1, 9))
def test_a_decimal_comes_back(language, whole, tenths):
    words = in_words([f"{whole}.{tenths}"], language)
    assert len(words) >= 3
    assert foreign.number(words, language) == pytest.approx(whole + tenths / 10)


@given(st.sampled_from(["de", "es", "fr", "it"]))
def test_what_people_say_is_a_number(language):
    for words in said.usual(language):
        value = foreign.number(words, language)
        assert value is not None or language == "it", words  # text2num lacks some of Italian: "centottantuno"
    assert number_words(language) == {word for words in said.usual(language) for word in words}


@pytest.mark.parametrize("words", [["fahr", "einen", "meter"], ["nimm", "eine", "tasse"], ["fahr", "2", "meter"]])
def test_an_article_and_what_is_in_digits_stays(words):
    assert in_digits(words, "de") == tuple(words)


def test_german_halves_are_one_word():
    assert {("anderthalb",), ("zweieinhalb",), ("eineinhalb",)} <= set(said.usual("de"))
    assert in_digits(["zweieinhalb", "meter"], "de") == ("2.5", "meter")


@pytest.mark.parametrize("number", [-1, said.LARGEST + 1])
def test_what_is_not_said_to_robots(number):
    assert said.spell(number, "de") == ()


def test_an_unknown_language_has_no_words():
    assert said.spell(5, "xx") == said.usual("xx") == ()
    assert in_words(["5", "m"], "xx") == ["5", "m"]
    assert number_words("xx") == frozenset()


def test_english_is_as_before():
    assert in_words(["45"], None) == in_words(["45"]) == ["forty", "five"]
    assert in_digits(["forty", "five"], None) == ("45",)
