"""Sound as the rest of the room sees it: 16 kHz mono float frames with their time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt

from intent_engine.speech.resampling import StreamResampler

__all__ = [
    "FRAME_SAMPLES",
    "FRAME_SECONDS",
    "MAX_RATE",
    "SAMPLE_RATE",
    "AudioSource",
    "Frame",
    "Report",
    "ReportKind",
    "Resampler",
    "Samples",
    "Wakeable",
    "checked_frame",
    "clean",
    "in_silence",
    "to_float",
]

SAMPLE_RATE = 16_000
"""Hz, what Whisper and Silero were trained on."""
FRAME_SAMPLES = 512
"""Samples of a frame: the length that Silero takes at 16 kHz."""
FRAME_SECONDS = FRAME_SAMPLES / SAMPLE_RATE
MAX_RATE = 768_000
"""Hz, above any converter that is sold; beyond it a rate is a mistake."""

Samples = npt.NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Frame:
    """32 ms of sound."""

    samples: Samples
    """``(512,)``, -1 to 1; or none: somebody woke the source, to look at something else than sound."""
    time: float
    """s, of the end of the frame, since the source began."""
    lost: float = 0.0
    """s of sound that are missing just before it, at least; 0: none. Words may be among them."""
    deaf: bool = False
    """No sound comes, as from a microphone that was unplugged: this is silence in its place."""
    cut: bool = False
    """The sound ended in it, in the midst of a sound: the rest of a word may be missing."""


class ReportKind(StrEnum):
    """What a live source has to tell beside its sound."""

    LOST = "lost"
    """Sound was lost: somebody was too busy to take it."""
    EARLY = "early"
    """Sound came before anybody listened: it is not heard."""
    AWAY = "away"
    """No sound comes any more."""
    BACK = "back"
    """Sound comes again."""
    MUTE = "mute"
    """Nothing that could be heard comes: the microphone is muted or may not be used, or samples have a wrong scale."""


@dataclass(frozen=True, slots=True)
class Report:
    """One thing that a live source tells."""

    kind: ReportKind
    time: float
    """s since the source began."""
    detail: str
    """For a person: what happened, and what to do about it."""


class AudioSource(Protocol):
    """Gives frames until it ends. Opened by iterating, closed by ``close()`` (idempotent, from any thread)."""

    def frames(self) -> Iterator[Frame]:
        """Frames in order.

        Raises:
            AudioError: the sound cannot be read.
            DeviceError: a device is missing or forbidden.
        """
        ...

    def close(self) -> None: ...


@runtime_checkable
class Wakeable(Protocol):
    """A live source whose reader need not wait for sound."""

    def wake(self) -> None:
        """Give a frame without sound as soon as there is no other. From any thread."""
        ...


def checked_frame(given: object) -> Frame:
    """What a source gave, which may be somebody's own.

    Raises:
        TypeError: it is no frame, or its samples are no float32.
    """
    if not isinstance(given, Frame):
        what = type(given).__name__
    elif not isinstance(given.samples, np.ndarray):
        what = f"samples in {type(given.samples).__name__}"
    elif given.samples.dtype != np.float32:
        what = f"samples of {given.samples.dtype}"
    else:
        return given
    raise TypeError(
        f"a source gives Frame(samples, time), {FRAME_SAMPLES} samples of float32 at {SAMPLE_RATE} Hz, not {what}: "
        "StreamSource(rate) makes such frames of the arrays that are pushed into it"
    )


def to_float(samples: npt.NDArray[Any]) -> npt.NDArray[np.floating]:
    """Samples of any number type, -1 to 1.

    Raises:
        TypeError: they are no real numbers.
    """
    kind = samples.dtype.kind
    if kind == "f":
        return samples
    if kind == "i":
        return samples.astype(np.float32) / np.float32(-float(np.iinfo(samples.dtype).min))
    if kind == "u":
        middle = (float(np.iinfo(samples.dtype).max) + 1) / 2
        return samples.astype(np.float32) / np.float32(middle) - np.float32(1)
    raise TypeError(f"samples must be numbers, not {samples.dtype}")


def clean(samples: npt.NDArray[np.floating]) -> Samples:
    """Finite, mono, within -1 to 1: what broken drivers and files send must not reach a model.

    Args:
        samples: ``(n,)`` or ``(n, channels)``.
    """
    # Limited before the channels are added: two large numbers would be an infinite one.
    finite = np.nan_to_num(samples, nan=0.0, posinf=0.0, neginf=0.0)
    sound = np.clip(finite, -1.0, 1.0).astype(np.float32, copy=False)
    return sound if sound.ndim == 1 else np.asarray(sound.mean(axis=1), np.float32)


def in_silence(samples: Samples, seconds: float, around: float) -> Samples:
    """A short sound with silence around it, first of all before it.

    Args:
        samples: ``(n,)``
        seconds: that it may last in all, silence and sound; one that is longer stays as it is.
        around: s of silence on either side, at most.
    """
    lack = max(round(seconds * SAMPLE_RATE) - samples.size, 0)
    most = round(around * SAMPLE_RATE)
    before = min(lack, most)
    return np.pad(samples, (before, min(lack - before, most)))


class Resampler:
    """A stream at any rate to frames at 16 kHz."""

    def __init__(self, rate: int, start: float = 0.0) -> None:
        self._stream = None if rate == SAMPLE_RATE else StreamResampler(rate, SAMPLE_RATE)
        self._left = np.zeros(0, np.float32)
        self._count = 0
        self._start = start

    @property
    def time(self) -> float:
        """s, of the end of the last frame."""
        return self._start + self._count * FRAME_SECONDS

    def shift(self, seconds: float) -> None:
        """Let later frames be ``seconds`` later: there was a gap."""
        self._start += seconds

    def push(self, samples: npt.NDArray[np.floating], *, last: bool = False) -> Iterator[Frame]:
        """Frames that are whole after more sound; with ``last`` the rest, filled with silence."""
        sound = clean(samples)
        if self._stream is not None:
            sound = self._stream.push(sound, last=last)
        self._left = np.concatenate((self._left, sound))
        if last and self._left.size % FRAME_SAMPLES:
            self._left = np.pad(self._left, (0, -self._left.size % FRAME_SAMPLES))
        whole = self._left.size // FRAME_SAMPLES
        for index in range(whole):
            self._count += 1
            yield Frame(
                self._left[index * FRAME_SAMPLES : (index + 1) * FRAME_SAMPLES],
                self._start + self._count * FRAME_SECONDS,
            )
        self._left = self._left[whole * FRAME_SAMPLES :]
