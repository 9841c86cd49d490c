"""What tests of the speech room share: sources of frames made before, and what a robot heard and did."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from intent_engine import Executor, SimulatedRobot
from intent_engine.runtime import Heard, HeardKind, Summary
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Frame, Resampler
from intent_engine.speech.recognizer import Transcript

__all__ = ["DATA", "ROOT", "Frames", "Jumpy", "Listened", "Says", "Voiced", "framed"]

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


class Says:
    """A recogniser that is sure of one text after the other, whatever was said, and then of none: what is tested comes
    after it."""

    def __init__(self, *texts: str) -> None:
        self._texts = list(texts)

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        text = self._texts.pop(0) if self._texts else ""
        return Transcript(text, free_text=text, gap=0.0)

    def close(self) -> None: ...


class Jumpy:
    """A reflex that takes everything for a stop."""

    def begin(self, frames: object) -> None: ...

    def heard(self, samples: object) -> bool:
        return True

    def close(self) -> None: ...


class Voiced:
    """A voice detector that hears speech at some times: (begin, end) in s."""

    def __init__(self, *times: tuple[float, float]) -> None:
        self._times = times
        self._frames = 0

    def reset(self) -> None:
        self._frames = 0

    def probability(self, samples: np.ndarray) -> float:
        time = self._frames * FRAME_SECONDS
        self._frames += 1
        return float(any(begin - 1e-6 <= time < end - 1e-6 for begin, end in self._times))


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
