"""The real recogniser and the real detector, loaded once; and a robot that listens on a virtual clock."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import soundfile
from speech_stage import ROOT, Frames, Listened, framed

from intent_engine import Executor, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard
from intent_engine.speech import second_opinion
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.steered import SteeredWhisper


@pytest.fixture(scope="session", autouse=True)
def _patient_search():
    """What is heard does not depend on how busy the machine is: a search is deepened however long it took."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(second_opinion, "SOON", math.inf)
        yield


@pytest.fixture(scope="session")
def grammar(engine) -> SpokenGrammar:
    return SpokenGrammar(engine)


@pytest.fixture(scope="session")
def whisper(engine):
    recognizer = SteeredWhisper(engine)
    yield recognizer
    recognizer.close()


@pytest.fixture(scope="session")
def demo() -> np.ndarray:
    samples, rate = soundfile.read(ROOT / "examples" / "demo.flac", dtype="float32")
    assert rate == SAMPLE_RATE
    return samples


@pytest.fixture(scope="session")
def go_forward(demo) -> np.ndarray:
    """ "go forward two meters" with quiet around it, 4.1 s."""
    return demo[: int(4.1 * SAMPLE_RATE)]


@pytest.fixture(scope="session")
def spoken(go_forward) -> np.ndarray:
    """The same, as an endpoint cuts it."""
    return go_forward[int(1.2 * SAMPLE_RATE) : int(3.6 * SAMPLE_RATE)]


@pytest.fixture
def listen(engine, whisper) -> Callable[..., Listened]:
    """A whole robot on a virtual clock; returns when it has done everything it was told."""

    def run(source: Any, recognizer: Any = None, **options: Any) -> Listened:
        clock = VirtualClock()
        robot = SimulatedRobot(clock)
        events: list[Heard] = []
        with Executor(robot, clock=clock) as executor:
            options.setdefault("patience", 120.0)  # how long a decode takes on this machine is not what is tested
            runtime = Runtime(engine, executor, recognizer or whisper, on_event=events.append, **options)
            if isinstance(source, np.ndarray):
                source = Frames(framed(source))
            elif isinstance(source, list):
                source = Frames(source)
            summary = runtime.run(source)
            executor.wait()
            return Listened(summary, events, robot, executor)

    return run
