"""States that only the program knows decide what is done about what was said."""

from __future__ import annotations

import numpy as np
import pytest
from speech_stage import Frames, Says, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.speech.audio import SAMPLE_RATE

GRAMMAR = """
language: en
intents:
  undock: {action: custom, requires: [docked], sentences: [let us leave]}
  wave: {action: custom, excludes: [docked], sentences: [wave]}
  bow: {action: custom, requires: [moving], sentences: [bow]}
"""


def done(engine: IntentEngine, said: str, **options: object) -> list[str]:
    clock = VirtualClock()
    names: list[str] = []
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        executor.register("custom", lambda action: names.append(action.name))
        runtime = Runtime(
            engine, executor, Says(said), voice=Voiced((0.5, 1.5)), noise_filter=None, speculate=False, **options
        )
        runtime.run(Frames(framed(np.zeros(3 * SAMPLE_RATE, np.float32))))
        executor.wait()
        assert executor.idle
    return names


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "docked", "names"),
    [
        ("let us leave", True, ["undock"]),
        ("let us leave", False, []),
        ("wave", False, ["wave"]),
        ("wave", True, []),
        ("bow", True, []),  # no other state is "moving"
    ],
)
def test_what_a_state_forbids_is_not_done(engine, said, docked, names):
    assert done(engine, said, state=lambda: ["docked"] if docked else []) == names


def test_without_a_program_that_tells_it_is_in_none(engine):
    assert done(engine, "wave") == ["wave"]
    assert done(engine, "let us leave") == []


def test_a_state_that_cannot_be_told_ends_listening(engine):
    """Nothing is done that may be forbidden."""

    def unknown() -> list[str]:
        raise LookupError("who knows")

    with pytest.raises(LookupError, match="who knows"):
        done(engine, "wave", state=unknown)
