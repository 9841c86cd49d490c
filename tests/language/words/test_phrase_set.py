"""Phrases in words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.words.phrase_set import PhraseSet, SomePhrases

words = st.sampled_from("abc")
phrases = st.lists(st.lists(words, max_size=3), max_size=5)
said = st.lists(words, max_size=8)


@given(phrases, said, st.integers(0, 9))
def test_phrases_are_found_where_they_stand_longest_first(given: list[list[str]], text: list[str], at: int) -> None:
    found = PhraseSet(given)
    here = sorted({len(one) for one in given if one and text[at : at + len(one)] == one}, reverse=True)
    assert found.lengths_at(text, at) == here
    assert found.at(text, at) == (here[0] if here else 0)
    assert bool(found) == any(given)


@given(phrases, said)
def test_the_first_and_the_last_phrase(given: list[list[str]], text: list[str]) -> None:
    found = PhraseSet(given)
    places = [place for place in range(len(text)) if found.at(text, place)]
    assert found.find(text) == ((places[0], found.at(text, places[0])) if places else None)
    endings = [len(one) for one in given if one and text[-len(one) :] == one]
    # The longest that is also the longest where it begins, or none: what is cut away must be a phrase.
    assert found.ends(text) in {0, *endings}
    if endings and all(found.at(text, len(text) - length) == length for length in endings):
        assert found.ends(text) == max(endings)
    if places:
        assert found.may_stand_in(text)


@given(phrases, said, st.sets(st.integers(1, 3)))
def test_phrases_that_are_tested_when_they_are_said(given: list[list[str]], text: list[str], lengths: set[int]) -> None:
    tested: list[tuple[str, ...]] = []

    def test(phrase: tuple[str, ...]) -> bool:
        tested.append(phrase)
        return len(phrase) in lengths

    some = SomePhrases(given, test)
    assert not tested, "none before it is said"
    found = PhraseSet(one for one in given if len(one) in lengths)
    places = range(len(text) + 1)
    assert [some.lengths_at(text, at) for at in places] == [found.lengths_at(text, at) for at in places]
    assert [some.at(text, at) for at in places] == [found.at(text, at) for at in places]
    assert some.find(text) == found.find(text)
    assert some.ends(text) == found.ends(text)
    assert some.cover(text) == found.cover(text)
    assert len(tested) == len(set(tested)), "and each once"
