"""A tokenizer file that has lost its first merge, as those of the multilingual models have."""

from __future__ import annotations

import json

import pytest

from intent_engine.speech.acoustic.pieces import mended

TEXTS = [
    " turn to the left",
    " Take the tall table",
    "t",
    " t",
    " the",
    " go forward twenty-two meters.",
    " 12.5 ",
    "Tür",
]


@pytest.fixture(scope="module")
def whole(whisper):
    return whisper._model.hf_tokenizer


@pytest.fixture(scope="module")
def broken(whole):
    parts = json.loads(whole.to_str())
    first = parts["model"]["merges"].pop(0)
    assert "".join(first if isinstance(first, list) else first.split(" ")) == "\u0120t"
    return type(whole).from_str(json.dumps(parts))


def test_one_that_is_whole_is_left_alone(whole):
    assert mended(whole) is whole


def test_the_fault_is_real(whole, broken):
    assert broken.encode(" to").ids != whole.encode(" to").ids


@pytest.mark.parametrize("text", TEXTS)
def test_every_piece_is_back(whole, broken, text):
    assert mended(broken).encode(text).ids == whole.encode(text).ids
    assert mended(broken).decode(whole.encode(text).ids) == whole.decode(whole.encode(text).ids)
