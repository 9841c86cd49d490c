"""What a runtime tells while it listens."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Protocol

from intent_engine.execution.goal import Goal
from intent_engine.interpretation import Interpretation
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.recognizer import Transcript

__all__ = ["Heard", "HeardKind", "Summary", "Tell"]


class HeardKind(StrEnum):
    """What a runtime tells."""

    SPEECH = "speech"
    """Somebody began to speak."""
    PARTIAL = "partial"
    """What was said so far, while somebody speaks or at a pause; may still change. What it would mean, and when the
    last frame of speech was, are told at a pause alone."""
    OUTDATED = "outdated"
    """Somebody speaks on: what was said so far, told or not yet, is to be heard anew."""
    TRANSCRIPT = "transcript"
    """What was said."""
    INTERPRETATION = "interpretation"
    """What it was understood to mean."""
    SUBMITTED = "submitted"
    """Goals were given to the executor."""
    HOLD = "hold"
    """The reflex heard a stop word: the robot is held."""
    RELEASE = "release"
    """It was none: the robot goes on."""
    LOST = "lost"
    """Sound was lost while somebody spoke: what was being said is not acted on."""
    ERROR = "error"
    """Something failed; the robot was stopped and listening goes on."""


@dataclass(frozen=True, slots=True)
class Heard:
    """One event of a runtime."""

    kind: HeardKind
    time: float
    """s since the source began: of the sound that caused it."""
    transcript: Transcript | None = None
    interpretation: Interpretation | None = None
    goals: tuple[Goal, ...] = ()
    outlook: Outlook = Outlook.UNKNOWN
    speech_ended: float | None = None
    """s: the last frame of speech."""
    goes_on: bool = False
    """Whether this is the command before and more: its goals were put right, or more were given."""
    in_turn: bool = False
    """Whether it is done after the command before, and not in its place."""
    detail: str = ""


class Tell(Protocol):
    """Is told of an event: what, when (s since the source began), and the other fields of :class:`Heard`."""

    def __call__(self, kind: HeardKind, time: float, /, **details: Any) -> None: ...


@dataclass(slots=True)
class Summary:
    """What a run of a runtime came to."""

    seconds: float = 0.0
    """Length of the sound."""
    utterances: int = 0
    accepted: int = 0
    errors: int = 0
    lost: int = 0
    """Utterances that were not acted on, since some of their sound was missing."""
