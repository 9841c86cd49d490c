"""The wake word alone, and what is said after a moment: "robot", and then "turn left"."""

from __future__ import annotations

import numpy as np
import pytest
from speech_stage import ROOT, Frames, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.recognizer import Transcript

SPOKEN = {0.1: "robot", 0.2: "turn left", 0.3: "it is broken", 0.4: "hey robot"}
"""What a sound of such a level is."""


class Hears:
    """A recogniser that hears what the levels of a sound say."""

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        levels = np.round(samples[np.flatnonzero(samples)], 1)
        order = [level for at, level in enumerate(levels) if at == 0 or level != levels[at - 1]]
        text = " ".join(SPOKEN[round(float(level), 1)] for level in order)
        return Transcript(text, free_text=text, gap=0.0)

    def close(self) -> None: ...


@pytest.fixture(scope="module")
def woken() -> IntentEngine:
    return IntentEngine.from_files(ROOT / "grammars" / "en.yaml", wake=["robot"])


def turned(engine: IntentEngine, *said: tuple[float, float], waits: Settings | None = None) -> bool:
    """Whether the robot turned after sounds: (when it begins, its level); each of half a second."""
    sound = np.zeros(round(12 * SAMPLE_RATE), np.float32)
    for begin, level in said:
        sound[round(begin * SAMPLE_RATE) : round((begin + 0.5) * SAMPLE_RATE)] = level
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        voice = Voiced(*((begin, begin + 0.5) for begin, _ in said))
        runtime = Runtime(engine, executor, Hears(), voice=voice, noise_filter=None, settings=waits or Settings())
        runtime.run(Frames(framed(sound)))
    return abs(robot.pose().yaw) > 0.1


@pytest.mark.parametrize("pause", [0.3, 0.9, 1.5, 2.4])
@pytest.mark.parametrize("called", [0.1, 0.4])
def test_a_command_may_follow_the_wake_word_after_a_moment(woken, called, pause):
    assert turned(woken, (1.0, called), (1.5 + pause, 0.2))


def test_not_after_longer_nor_after_other_words(woken):
    assert not turned(woken, (1.0, 0.1), (5.0, 0.2))
    assert not turned(woken, (1.0, 0.1), (2.5, 0.3), (4.0, 0.2))
    assert not turned(woken, (1.0, 0.3), (2.5, 0.2))


def test_it_calls_for_one_sentence(woken):
    assert not turned(woken, (1.0, 0.1), (2.5, 0.3), (3.9, 0.2))


def test_how_long_is_a_setting(woken):
    assert not turned(woken, (1.0, 0.1), (3.0, 0.2), waits=Settings(wake_lasts=0.8))
    assert turned(woken, (1.0, 0.1), (6.0, 0.2), waits=Settings(wake_lasts=6.0))


def test_where_no_wake_word_is_asked_for_nothing_is_kept(engine):
    assert turned(engine, (1.0, 0.2))
    assert not turned(engine, (1.0, 0.1), (2.5, 0.3))
