"""Lists with a pause in them: the first is begun at the pause, and the rest is done after it."""

from __future__ import annotations

import numpy as np
import pytest
from continuing_stage import Script
from speech_stage import Frames, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE

GRAMMAR = """
language: en
slots:
  person: [Anna, Ben, Lucy]
  n: {type: number, min: 1, max: 60, whole: true}
intents:
  wave: {action: custom, sentences: ["wave to {person}"], then: ["[to] {person}"]}
  unlock: {action: custom, sentences: ["unlock drawer {n}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


class Said:
    """Two utterances of 0.4 s and 0.9 s, and what was done of them."""

    def __init__(
        self, engine: IntentEngine, first: str, second: str, *, pause: float = 0.6, score: float = 0.0
    ) -> None:
        begin = 0.9 + pause
        clock = VirtualClock()
        self.done: list[object] = []
        self.events: list[Heard] = []
        script = Script(first, second, f"{first} {second}", score)
        with Executor(SimulatedRobot(clock), clock=clock) as executor:
            for name in engine.grammar.intents:
                executor.register(name, lambda action: self.done.extend(action.slots.values()))
            voice = Voiced((0.5, 0.9), (begin, begin + 0.9))
            runtime = Runtime(engine, executor, script, voice=voice, noise_filter=None, on_event=self.events.append)
            runtime.run(Frames(framed(np.zeros(int((begin + 3.0) * SAMPLE_RATE), np.float32))))
            executor.wait()

    @property
    def reason(self) -> str:
        found = [event.interpretation for event in self.events if event.kind is HeardKind.INTERPRETATION]
        return found[-1].reason if found[-1] is not None else ""

    @property
    def begun(self) -> int:
        """Commands that were begun, one after the other."""
        return sum(event.kind is HeardKind.SUBMITTED for event in self.events)


@pytest.mark.parametrize(
    ("first", "second", "done"),
    [
        ("unlock drawer three", "and four", [3, 4]),
        ("unlock drawer three", "and also six", [3, 6]),
        ("unlock drawer three", "and four and nine", [3, 4, 9]),
        ("unlock drawer three", "and drawer four", [3, 4]),
        ("unlock drawer three", "four and five", [3, 4, 5]),
        ("wave to anna", "and ben", ["Anna", "Ben"]),
        ("wave to anna", "and also to ben", ["Anna", "Ben"]),
        ("wave to anna", "ben and lucy", ["Anna", "Ben", "Lucy"]),
    ],
)
def test_the_list_goes_on(engine: IntentEngine, first: str, second: str, done: list[object]) -> None:
    said = Said(engine, first, second)
    assert (said.done, said.begun) == (done, 2)


@pytest.mark.parametrize(
    ("first", "second", "done"),
    [
        ("unlock drawer three", "four", [3]),
        ("unlock drawer three", "drawer four", [3]),
        ("wave to anna", "ben", ["Anna"]),
    ],
)
def test_a_name_alone_may_correct_and_is_told(
    engine: IntentEngine, first: str, second: str, done: list[object]
) -> None:
    said = Said(engine, first, second)
    assert said.done == done
    assert said.reason.startswith(f"{second!r} may be said besides what was said before, or in its place")


@pytest.mark.parametrize(
    ("first", "second", "done"),
    [
        ("unlock drawer three", "or four", [3]),
        ("unlock drawer three", "and a half", [3]),
        ("unlock drawer three", "and three", [3]),
        ("unlock drawer twenty", "and four", [20]),
        ("unlock drawer twenty", "four and five", [20]),
        ("wave to anna", "or ben", ["Anna"]),
        ("wave to anna", "and not ben", ["Anna"]),
    ],
)
def test_what_is_no_rest_of_a_list_does_nothing(engine, first: str, second: str, done: list[object]) -> None:
    said = Said(engine, first, second)
    assert said.done == done
    assert "besides" not in said.reason


def test_long_afterwards_nothing_goes_on(engine: IntentEngine) -> None:
    assert Said(engine, "unlock drawer three", "and four", pause=2.0).done == [3]
    assert "besides" not in Said(engine, "wave to anna", "ben", pause=2.0).reason


def test_what_was_hardly_heard_is_told_as_before(engine: IntentEngine) -> None:
    assert "besides" not in Said(engine, "wave to anna", "ben", score=-3.0).reason
