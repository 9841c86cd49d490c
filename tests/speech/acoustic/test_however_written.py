"""How clearly words were heard, however they might be written."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.acoustic.however_written import HoweverWritten
from intent_engine.speech.acoustic.rows import total
from intent_engine.speech.acoustic.whisper import WhisperRecognizer


@pytest.fixture(scope="module")
def tokenizer():
    made = WhisperRecognizer("tiny.en", device="cpu")
    yield made.tokenizer()
    made.close()


@pytest.fixture(scope="module")
def writing(tokenizer) -> HoweverWritten:
    return HoweverWritten(tokenizer)


def piece(tokenizer, text: str) -> int:
    (found,) = tokenizer.encode(text)
    return found


@pytest.mark.parametrize(
    ("one", "other"),
    [(" Turn", " turn"), (" go", " GO"), (" 2", " two"), (" Ten", " 10"), (" twenty", " 20"), ("net", "Net")],
)
def test_what_writes_the_same_word(writing, tokenizer, one, other):
    assert piece(tokenizer, other) in writing.same(piece(tokenizer, one))
    assert writing.same(piece(tokenizer, one)) == writing.same(piece(tokenizer, other))


@pytest.mark.parametrize(("one", "other"), [(" left", " right"), (" 2", " 20"), (" to", " two"), (" net", "net")])
def test_what_does_not(writing, tokenizer, one, other):
    assert piece(tokenizer, other) not in writing.same(piece(tokenizer, one))


@pytest.mark.parametrize("sign", [".", "!", "?", "...", ","])
def test_a_sign_is_no_word(writing, tokenizer, sign):
    assert writing.same(piece(tokenizer, sign)) == []


@given(number=st.integers(0, 50_000))
def test_every_piece_writes_itself_or_is_a_sign(writing, number):
    same = writing.same(number)
    assert number in same or not same


def rows_of(tokenizer, *chances: dict[str, float]) -> dict[tuple[int, ...], np.ndarray]:
    """What a model thought that wrote the first of each, all else being impossible."""
    rows: dict[tuple[int, ...], np.ndarray] = {}
    heard: tuple[int, ...] = ()
    for chance in chances:
        row = np.full(50_257, -60.0, np.float32)
        for text, probability in chance.items():
            row[piece(tokenizer, text)] = math.log(probability)
        rows[heard] = row + 3.0  # known up to a constant
        heard += (piece(tokenizer, next(iter(chance))),)
    rows[heard] = np.zeros(50_257, np.float32)
    return rows


def test_probability_that_is_divided_among_writings_is_one(writing, tokenizer):
    divided = rows_of(
        tokenizer,
        {" Go": 0.45, " go": 0.45, " Come": 0.1},
        {" back": 0.9, " forward": 0.1},
        {" 2": 0.5, " two": 0.4, " to": 0.1},
        {".": 0.4, "!": 0.3, "?": 0.3},
    )
    assert writing.clearness(divided) == pytest.approx(math.log(0.9), abs=1e-4)


def test_what_may_be_another_word_is_in_doubt(writing, tokenizer):
    doubtful = rows_of(tokenizer, {" left": 0.5, " right": 0.5})
    assert writing.clearness(doubtful) == pytest.approx(math.log(0.5), abs=1e-4)


def test_nothing_heard_is_not_clear(writing, tokenizer):
    assert writing.clearness({}) == -math.inf
    assert writing.clearness(rows_of(tokenizer, {"...": 1.0})) == -math.inf


def test_what_is_not_known_is_not_clear(writing, tokenizer):
    rows = rows_of(tokenizer, {" left": 1.0}, {" turn": 1.0})
    rows.pop(next(key for key in rows if len(key) == 1))
    assert writing.clearness(rows) == -math.inf


@given(st.lists(st.floats(-20, 20), min_size=1, max_size=50))
def test_the_total_of_a_row(values):
    row = np.array(values, np.float32)
    assert np.exp(row - total(row)).sum() == pytest.approx(1.0, abs=1e-3)
