"""How likely a stop phrase is being said, for any model: here one whose pieces are words."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.stop_phrases import OPEN, StopPhrases

WORDS = ["stop", "Stop", "please", "Please", "Please,", "hold", "Hold", "on", "go"]


def encode(text: str) -> list[int]:
    return [WORDS.index(word) for word in text.split()]


def after(**rows: dict[str, float]):
    """A model that thinks this of the next word, after some."""

    def chances(begun: tuple[int, ...]) -> np.ndarray:
        row = np.zeros(len(WORDS), np.float32)
        for word, chance in rows.get("_".join(WORDS[piece] for piece in begun) or "first", {}).items():
            row[WORDS.index(word)] = chance
        return row

    return chances


@pytest.fixture
def phrases() -> StopPhrases:
    return StopPhrases([("stop",), ("hold", "on")], ["please"], encode)


@pytest.mark.parametrize(
    ("rows", "chance"),
    [
        ({"first": {"go": 1.0}}, 0.0),
        ({"first": {"stop": 0.02, "Stop": 0.01, "go": 0.9}}, 0.03),
        ({"first": {"Please": 0.5, "stop": 0.01}, "Please": {"stop": 0.4}}, 0.21),
        ({"first": {"hold": 0.2}, "hold": {"on": 1.0}}, 0.2),
        ({"first": {"hold": 0.2}, "hold": {"stop": 1.0}}, 0.0),
        ({"first": {"hold": OPEN / 2}, "hold": {"on": 1.0}}, 0.0),
    ],
    ids=["other words", "either spelling", "after another word", "two words", "no phrase", "too unlikely to follow up"],
)
def test_what_begins_with_a_stop_phrase_adds_up(phrases, rows, chance):
    assert phrases.chance(after(**rows)) == pytest.approx(chance)


def test_what_is_likely_enough_is_not_followed_up(phrases):
    asked = []

    def model(begun: tuple[int, ...]) -> np.ndarray:
        asked.append(begun)
        return after(first={"stop": 0.3, "please": 0.6}, please={"stop": 1.0})(begun)

    assert phrases.chance(model, enough=0.2) == pytest.approx(0.3)
    assert asked == [()]
    assert phrases.chance(model) == pytest.approx(0.9)


@given(st.lists(st.floats(0, 1), min_size=len(WORDS), max_size=len(WORDS)).filter(lambda row: sum(row) > 0))
def test_it_is_a_probability_whatever_a_model_thinks(row):
    chances = np.array(row) / sum(row)
    assert 0.0 <= StopPhrases([("stop",), ("hold", "on")], ["please"], encode).chance(lambda begun: chances) <= 1 + 1e-9
