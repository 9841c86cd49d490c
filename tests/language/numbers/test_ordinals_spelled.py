"""Ordinals as they are said and as recognisers write them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.numbers.english_ordinals import ordinal
from intent_engine.language.numbers.ordinals_spelled import (
    in_figures,
    ordinal_otherwise,
    ordinals_in_figures,
    ordinals_in_words,
)

NUMBERS = st.integers(1, 99)


@given(NUMBERS)
def test_every_ordinal_is_in_words_and_in_figures_what_it_is(number):
    figures = in_figures(number)
    words = ordinals_in_words([figures])
    assert ordinal(words) == ordinal([figures]) == number
    assert ordinals_in_figures(words) == (figures,)
    assert ordinal_otherwise([figures, "row"]) == (1, tuple(words))
    assert ordinal_otherwise([*words, "row"]) == (len(words), (figures,))


@given(st.lists(st.one_of(NUMBERS.map(in_figures), st.sampled_from(["the", "row", "and", "b", "12"]))))
def test_all_other_words_stay_as_they_are(words):
    assert ordinals_in_figures(ordinals_in_words(words)) == tuple(words)


@pytest.mark.parametrize("word", ["21th", "1th", "11st", "0th", "100th", "st", "3", "third", ""])
def test_what_is_no_ordinal_in_figures_stays(word):
    assert ordinals_in_words([word]) == [word]


@pytest.mark.parametrize(("words", "length"), [("ninety", 0), ("ten first", 0), ("row third", 0), ("third", 1)])
def test_where_no_ordinal_begins(words, length):
    assert ordinal_otherwise(words.split())[0] == length
