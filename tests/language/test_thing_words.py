"""The words of things, by language."""

from __future__ import annotations

from pathlib import Path

import pytest

from intent_engine.language.thing_words import _FOLDER, any_articles, thing_words

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
        assert said[-1] not in words.joining | words.not_held, example
        assert not words.is_manner(said[-1]), example


def test_words_are_written_as_utterances_are():
    """Lower case and no punctuation: what is not could never be met."""
    for file in Path(_FOLDER).glob("*.yaml"):
        words = thing_words(file.stem)
        for word in words.articles | words.joining | words.never | words.not_bare | words.not_held | words.unfinished:
            assert word.islower(), (file.name, word)
            assert word.isalpha(), (file.name, word)


@pytest.mark.parametrize("word", ["carefully", "seriously", "directly", "slightly"])
def test_words_of_manner(word):
    assert thing_words("en").is_manner(word)


@pytest.mark.parametrize("word", ["family", "assembly", "butterfly", "jelly", "ally", "reply"])
def test_no_words_of_manner(word):
    assert not thing_words("en").is_manner(word)


def test_a_language_without_a_file_has_no_such_words():
    assert thing_words("tlh").articles == frozenset()
    assert not thing_words("tlh").is_manner("carefully")
    assert {"the", "der", "le", "el", "il"} <= any_articles()
