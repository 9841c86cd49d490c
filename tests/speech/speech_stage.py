"""What tests of the speech room share: sources of frames made before, and what a robot heard and did."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from intent_engine import Executor, SimulatedRobot
from intent_engine.runtime import Heard, HeardKind, Summary
from intent_engine.speech.audio import SAMPLE_RATE, Frame, Resampler

__all__ = ["DATA", "ROOT", "Frames", "Listened", "framed"]

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
