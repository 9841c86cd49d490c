"""What the real model thinks of given words."""

from __future__ import annotations

import math

import numpy as np
import pytest

from intent_engine.speech.acoustic.writing import written


@pytest.fixture
def encoded(whisper, spoken):
    return whisper.encode(spoken)


def test_what_was_said_is_likelier_than_what_is_like_it(whisper, encoded):
    said, *others = whisper.score(
        encoded, ["Go forward two meters", "Go forward ten meters", "Go to the kitchen"], "en"
    )
    assert said > max(others)
    assert whisper.score(encoded, ["Go forward two meters"], "en") == [said], "and it is remembered"


def test_the_likelier_spelling_of_a_number_counts(whisper, encoded):
    both = whisper.score(encoded, ["Go forward two meters", "Go forward 2 meters"], "en")
    assert whisper.score_words(encoded, [["go", "forward", "two", "meters"]], "en") == [max(both)]


def test_the_likelier_writing_of_a_name_counts(whisper, encoded):
    small, large = whisper.score(encoded, ["Go to anna", "Go to Anna"], "en")
    assert whisper.score_words(encoded, [["go", "to", "anna"]], "en") == [max(small, large)]
    assert small != large


def test_the_score_of_a_word_is_that_of_its_own_pieces(whisper, encoded):
    text = "go forward two screwdrivers"
    words = whisper.word_scores(encoded, text, "en")
    assert [word for word, _ in words] == text.split()
    tokenizer = whisper.tokenizer("en")
    (pieces,) = whisper._pieces(encoded, [text], "en")
    assert sum(len(tokenizer.encode(" " + word)) for word in text.split()) + 1 == len(pieces), "and the full stop"
    *said, (_, not_said) = words
    assert np.mean([score for _, score in said]) > math.log(0.3) > not_said


def test_the_real_model_tells_every_next_piece(whisper, encoded):
    tokens = tuple(whisper.tokenizer("en").encode(" " + written(["go", "forward"], "en")))
    rows = dict(whisper.next_pieces(encoded, [tokens, tokens[:1]], 6, "en"))
    assert {(), tokens[:1], tokens} <= set(rows)
    for row in rows.values():
        assert row.shape == (51864,)
        chances = np.delete(np.exp(row), whisper.end_piece("en"))
        assert 0.0 < chances.sum() <= 1.001, "the end is all that ends a sentence, which is told besides"
