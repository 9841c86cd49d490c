"""Sounds that are hardly longer than a knock: a stop among them is carried out, nothing else is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from speech_stage import Jumpy, Listened, Says, Voiced

from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE

LONG, SHORT = 1.0, 2 * FRAME_SECONDS
"""s of speech: a command, and what the voice detector heard of one "stop" of 58."""


@pytest.fixture
def hear(listen):
    def run(lengths: Sequence[float], *texts: str, **options: object) -> Listened:
        times = [(1.0 + 2.0 * number, 1.0 + 2.0 * number + length) for number, length in enumerate(lengths)]
        sound = np.zeros(int((times[-1][1] + 1.5) * SAMPLE_RATE), np.float32)
        return listen(sound, Says(*texts), voice=Voiced(*times), noise_filter=None, **options)

    return run


def test_a_short_stop_stops(hear):
    listened = hear((LONG, SHORT), "go forward ten meters", "stop")
    assert [event.interpretation.intent for event in listened.of(HeardKind.SUBMITTED)] == ["move", "stop"]
    assert listened.goals[0].state.value == "canceled"
    assert 0 < listened.moved < 1.0


def test_no_other_word_is_taken_from_a_knock(hear):
    listened = hear((SHORT,), "go forward ten meters")
    assert listened.moved == 0
    assert not listened.of(HeardKind.SUBMITTED)
    assert not listened.texts
    assert listened.summary.utterances == 0


def test_a_knock_does_not_stop_a_robot_that_drives(hear):
    listened = hear((LONG, SHORT), "go forward two meters", "go backward")
    assert listened.moved == pytest.approx(2.0)


def test_a_robot_that_a_knock_held_goes_on(hear):
    listened = hear((LONG, SHORT), "go forward two meters", "", reflex=Jumpy())
    kinds = [event.kind for event in listened.events if event.kind in (HeardKind.HOLD, HeardKind.RELEASE)]
    assert kinds == [HeardKind.HOLD, HeardKind.RELEASE] * 2
    assert listened.moved == pytest.approx(2.0, abs=0.05)


@pytest.mark.parametrize("text", ["go backward", "mug"])
def test_why_a_held_robot_goes_on_is_told(hear, text):
    listened = hear((LONG, SHORT), "go forward two meters", text, reflex=Jumpy())
    assert "too short" in listened.of(HeardKind.RELEASE)[-1].detail
    assert listened.moved == pytest.approx(2.0, abs=0.05)
