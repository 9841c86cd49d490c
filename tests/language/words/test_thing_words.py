"""The words of things, by language."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does

from intent_engine.language.words.thing_words import _FOLDER, any_articles, thing_words

LANGUAGES = sorted(file.stem for file in _FOLDER.glob("*.yaml"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_names_things(language):
    words = thing_words(language)
    assert all((words.articles, words.unfinished, words.joining, words.never, words.examples))
    assert words.may_begin <= words.joining  # else they say nothing
    assert not words.articles & words.never


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_example_is_refused_by_its_own_lists(language):
    words = thing_words(language)
    for example in words.examples:
        said = example.split()
        assert words.never.isdisjoint(said), example
        assert said[0] not in words.joining | words.not_bare, example
        assert said[-1] not in words.joining, example
        assert not words.is_not_held(said[-1]), example
        assert words.stays.isdisjoint(said), example
        assert not words.is_manner(said[-1]), example


def test_words_are_written_as_utterances_are():
    """Lower case and no punctuation: what is not could never be met."""
    for file in Path(_FOLDER).glob("*.yaml"):
        words = thing_words(file.stem)
        lists = (
            words.articles,
            words.joining,
            words.never,
            words.not_bare,
            words.not_held,
            words.stays,
            words.unfinished,
        )
        for word in frozenset[str]().union(*lists):
            assert word.islower(), (file.name, word)
            assert word.isalpha(), (file.name, word)


@pytest.mark.parametrize("word", ["carefully", "seriously", "directly", "slightly"])
def test_words_of_manner(word):
    assert thing_words("en").is_manner(word)


@pytest.mark.parametrize("word", ["family", "assembly", "butterfly", "jelly", "ally", "reply"])
def test_no_words_of_manner(word):
    assert not thing_words("en").is_manner(word)


@pytest.mark.parametrize(
    ("language", "held", "not_held"),
    [
        (
            "en",
            "harness prism lotion ration document fence balance station garment",
            "kindness realism motion friendship",
        ),
        ("en", "city spaceship basement decoration sequence", "generosity narration childhood amazement importance"),
        ("de", "zeitung flüssigkeit taschenlampe botschaft", "freundschaft gelegenheit tätigkeit realismus qualität"),
    ],
)
def test_what_nobody_can_hold_is_known_by_its_ending(language: str, held: str, not_held: str) -> None:
    words = thing_words(language)
    assert not [word for word in held.split() if words.is_not_held(word)]
    assert not [word for word in not_held.split() if not words.is_not_held(word)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_word_is_listed_that_its_ending_tells(language: str) -> None:
    """Else a list grows that a rule has; an exception of a rule may be no thing all the same."""
    words = thing_words(language)
    alone = replace(words, not_held=frozenset[str]())
    assert not [word for word in words.not_held if alone.is_not_held(word)]


def test_a_language_without_a_file_has_no_such_words():
    assert thing_words("tlh").articles == frozenset()
    assert not thing_words("tlh").is_manner("carefully")
    assert {"the", "der", "le", "el", "il"} <= any_articles()


HELD = ["cup", "box", "ball", "phone", "snack", "anchor", "part", "case"]


@given(
    st.sampled_from(["take", "grab", "pick up", "get hold of", "lift", "could you grab"]),
    st.sampled_from(["", "a ", "the ", "my ", "some ", "a quick "]),
    st.sampled_from(["bite", "swim", "siege", "leap", "whiff", "mother", "blinds", "hallway", "discount", "vibe"]),
)
def test_what_no_hand_holds_is_not_taken(take, article, thing):
    """Sayings are kept out by what they are about: one word more in the list, and all sentences with it."""
    assert does(f"{take} {article}{thing}") != f"pick {thing}"
    assert does(f"{take} {article}{thing} box").startswith("pick ")  # of which it says something


@given(st.sampled_from(["take", "grab", "pick up"]), st.sampled_from(HELD))
def test_what_a_hand_holds_is_taken_whatever_is_said_of_it(take, thing):
    """ "Drop the ball" may be a saying, and is an order to drop it; who means "take part" says no article."""
    assert does(f"{take} the {thing}") == f"pick {thing}"
    bare = does(f"{take} {thing}")
    assert bare == ("rejected" if thing in thing_words("en").bare else f"pick {thing}")


@pytest.mark.parametrize("whom", ["my mother", "the guest", "our friend"])
def test_things_are_brought_to_people(whom):
    assert does(f"bring the cup to {whom}") == "bring"
    assert does(f"pick up {whom}") == "rejected"
