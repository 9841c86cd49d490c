"""The real recogniser and the real detector, loaded once; and a robot that listens on a virtual clock."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import soundfile

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard, HeardKind, Summary
from intent_engine.speech.audio import SAMPLE_RATE, Frame, Resampler
from intent_engine.speech.steered import SteeredWhisper

ROOT = Path(__file__).resolve().parent.parent.parent
DATA = ROOT.parent / "shared" / "data"


class Frames:
    """Frames that were made before."""

    def __init__(self, frames: Iterable[Frame]) -> None:
        self._frames = frames

    def frames(self) -> Iterator[Frame]:
        yield from self._frames

    def close(self) -> None:
        pass


def framed(samples: np.ndarray, rate: int = SAMPLE_RATE) -> list[Frame]:
    return list(Resampler(rate).push(samples, last=True))


@dataclass
class Listened:
    """What a robot heard and did."""

    summary: Summary
    events: list[Heard]
    robot: SimulatedRobot
    executor: Executor
    moved: float = field(init=False)
    """m from where it began."""

    def __post_init__(self) -> None:
        pose = self.robot.pose()
        self.moved = float(np.hypot(pose.x, pose.y) + abs(pose.yaw))

    def of(self, kind: HeardKind) -> list[Heard]:
        return [event for event in self.events if event.kind is kind]

    @property
    def texts(self) -> list[str]:
        return [event.transcript.text for event in self.of(HeardKind.TRANSCRIPT)]

    @property
    def goals(self) -> list[Any]:
        return [goal for event in self.of(HeardKind.SUBMITTED) for goal in event.goals]


@pytest.fixture(scope="session")
def engine() -> IntentEngine:
    return IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=ROOT / "locations" / "home.yaml")


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
