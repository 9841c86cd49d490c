"""A model that is asked what it thinks of words: what all have in common, with a model that was made up."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine.speech.acoustic.scoring import Scoring
from intent_engine.speech.recognizer import Encoded

SOUND, OTHER = (Encoded(np.zeros((1, 2, 2), np.float32), 1.0) for _ in range(2))


class Letters:
    """A piece for each letter."""

    def encode(self, text: str) -> list[int]:
        return [ord(letter) for letter in text]

    def decode(self, pieces: list[int]) -> str:
        return "".join(map(chr, pieces))


class Longer(Scoring):
    """Finds each letter of a text less likely than the one before it, and remembers what it was asked."""

    def __init__(self, wrote: str = "") -> None:
        self.asked: list[str] = []
        self.language = "en"
        self._letters = Letters()
        pieces = tuple(self._letters.encode(wrote))
        self._decoded = (SOUND, {pieces[:place]: np.zeros(1) for place in range(len(pieces) + 1)})

    def _pieces(self, encoded, texts, language):
        self.asked += texts
        return [-np.arange(1.0, len(text) + 2.0) for text in texts]

    def tokenizer(self, language=None):
        return self._letters

    encode = detect = greedy = longer = end_piece = next_pieces = None


def test_of_a_text_is_asked_once_for_each_sound():
    model = Longer()
    assert model.score(SOUND, ["a", "ab", "a"]) == [-3.0, -6.0, -3.0]
    assert model.score(SOUND, ["ab", "abc"]) == [-6.0, -10.0]
    assert model.asked == ["a", "ab", "abc"]
    model.score(OTHER, ["a"])
    model.score(SOUND, ["a"])
    assert model.asked[3:] == ["a", "a"], "only of the sound that was asked about last"


def test_a_word_is_as_likely_as_its_pieces_in_the_mean():
    assert Longer().word_scores(SOUND, "go on") == [("go", -2.0), ("on", -5.0)]


@pytest.mark.parametrize(("wrote", "begins"), [("Go", "Go"), ("go", "go"), ("", "Go")])
def test_a_sentence_begins_as_the_model_began_what_it_heard_freely(wrote, begins):
    model = Longer(wrote)
    model.score_words(SOUND, [["go", "on"]], "en")
    assert {text[:2] for text in model.asked} == {begins}


def test_what_was_written_of_another_sound_is_forgotten():
    model = Longer("Go")
    assert model.pieces_written(SOUND) == tuple(map(ord, "Go"))
    assert (model.pieces_written(OTHER), dict(model.decoded(OTHER))) == ((), {})


def test_what_somebody_else_hears_is_a_draft_where_nothing_was_written_yet():
    model, told = Longer(), ["go"]
    draft = model.drafted(np.zeros(16000, np.float32), lambda: told[0])
    assert model._letters.decode(list(draft.after(()))) == " go"
    told[0] = "go on"
    assert model._letters.decode(list(draft.after(()))) == " go on"
