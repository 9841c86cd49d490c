"""How sure a transcript must be, for what."""

from __future__ import annotations

import pytest

from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import (
    ANOTHER_WORD,
    SURE_ENOUGH,
    SURE_ENOUGH_OF_SEVERAL,
    SURE_ENOUGH_TO_STOP,
    enough_to_stop,
)


def test_less_is_asked_of_a_stop_and_more_of_several_commands():
    assert SURE_ENOUGH_TO_STOP < SURE_ENOUGH < SURE_ENOUGH_OF_SEVERAL


@pytest.mark.parametrize(
    ("gap", "enough"),
    [(None, SURE_ENOUGH_TO_STOP), (ANOTHER_WORD, SURE_ENOUGH_TO_STOP), (ANOTHER_WORD + 0.01, SURE_ENOUGH)],
)
def test_as_much_as_ever_is_asked_of_a_stop_where_another_word_is_much_likelier(gap, enough):
    assert enough_to_stop(Transcript("whoa", free_text="Wow", gap=gap, confidence=0.5)) == enough
