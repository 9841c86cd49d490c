"""Sound that the embedding process has already: NumPy arrays pushed from any thread, at any rate."""

from __future__ import annotations

from collections.abc import Iterator
from numbers import Real
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.errors import AudioError
from intent_engine.execution.clock import Clock
from intent_engine.speech.audio import MAX_RATE, Frame, clean, to_float
from intent_engine.speech.scale import check_scale
from intent_engine.speech.sources.ending import Ending
from intent_engine.speech.sources.live import CAPACITY, Inbox, Reporter

__all__ = ["StreamSource"]

MAX_CHANNELS = 64
"""More channels than samples is an array that lies on its side."""


class StreamSource:
    """Frames of what is pushed.

    Life cycle: made -> ``push`` from one thread while ``Runtime.run`` takes frames in another -> ``end()``: what was
    pushed is still heard; or ``close()``: at once (idempotent, from any thread).

    Args:
        rate: Hz of what is pushed.
        live: sound is pushed as it is heard, and it is too late for what cannot be taken in time: the oldest is
            dropped, and this is told. Else it is a recording: ``push`` waits for room, or until it is closed, and
            times are counts.
        patience: s without a push after which a live stream counts as deaf, which stops the robot: it could not be
            told to stop. None: silence stands in, for programs that push nothing while nobody speaks.
        capacity: s of sound that may wait.
        on_report: is told what was lost, went away, came back or is too quiet to be heard; None: the log is.
        clock: None: the machine's.

    Raises:
        AudioError: the rate is none, or ``patience`` or ``capacity`` no time.
    """

    def __init__(
        self,
        rate: int,
        *,
        live: bool = True,
        patience: float | None = 2.0,
        capacity: float = CAPACITY,
        on_report: Reporter | None = None,
        clock: Clock | None = None,
    ) -> None:
        self.rate = checked_rate(rate)
        _check_seconds("capacity", capacity)
        if patience is not None:
            _check_seconds("patience", patience)
        self._channels: set[int] = set()
        """Numbers of channels that came."""
        self._ending = Ending(self.rate)
        self._live = live
        self._inbox = Inbox("the stream", patience=patience, capacity=capacity, on_report=on_report, clock=clock)

    def push(self, samples: npt.ArrayLike) -> bool:
        """Bring more sound.

        Args:
            samples: ``(n,)`` or ``(n, channels)``; floats from -1 to 1, or integers up to 32 bits, which are scaled by
                the range of their type. Copied. What is not finite becomes silence.

        Returns:
            False when the stream was closed or ended: nobody hears it.

        Raises:
            AudioError: not an array of such a shape, or not of such numbers.
        """
        given = self._given(samples)
        try:
            sound = np.array(to_float(given))
        except TypeError as error:
            raise AudioError(f"the stream was given no sound: {error}") from None
        hint = "push the integers as they are: samples.astype(np.int16), or divide them: samples / 32768"
        check_scale(sound, "the stream was given", hint)
        self._ending.take(clean(sound[-self.rate :]).reshape(-1, 1))
        step = self.rate  # a second at a time, so that the box never holds one block larger than itself
        return all(
            self._inbox.put(sound[start : start + step], self.rate, wait=not self._live)
            for start in range(0, max(len(sound), 1), step)
        )

    def _given(self, samples: npt.ArrayLike) -> npt.NDArray[Any]:
        if _are_bytes(samples):
            raise AudioError(
                "the stream was given bytes, which may be samples of any kind\n"
                "    push np.frombuffer(data, np.int16), or take a PcmSource"
            )
        try:
            given = np.asarray(samples)
        except ValueError:
            raise AudioError("the stream was given lists of different lengths\n    push an array") from None
        if given.ndim not in (1, 2) or (given.ndim == 2 and not 1 <= given.shape[1] <= MAX_CHANNELS):
            raise AudioError(
                f"the stream was given an array of shape {given.shape}\n"
                "    push (samples,) for one channel, (samples, channels) for more"
            )
        if given.dtype.kind in "iu" and given.dtype.itemsize > 4 and given.size:
            raise AudioError(
                f"the stream was given {given.dtype}, whose whole range no sound fills\n"
                "    push the type in which it was recorded: samples.astype(np.int16)"
            )
        channels = 1 if given.ndim == 1 else given.shape[1]
        if 0 < len(given) < channels and channels > 2 and channels not in self._channels:
            raise AudioError(
                f"the stream was given an array of shape {given.shape}, which lies on its side\n"
                "    push (samples, channels): array.T"
            )
        self._channels.add(channels)
        return given

    def frames(self) -> Iterator[Frame]:
        return self._inbox.frames(counted=not self._live)

    def end(self, *, cut: bool | None = None) -> None:
        """Nothing more will be pushed.

        Args:
            cut: it ended in the midst of what was being said, as when a connection broke, and that is not acted on.
                None: a live one did if it is as loud at its end as in the midst of a word; a recording is whole.
        """
        self._inbox.end(cut=(self._live and self._ending.abrupt) if cut is None else cut)

    def close(self) -> None:
        self._inbox.close()

    def wake(self) -> None:
        self._inbox.wake()


def _are_bytes(samples: object) -> bool:
    """Whether nothing tells what kind of numbers they are: bytes, or a buffer of them, as PortAudio's raw streams
    give."""
    if isinstance(samples, np.ndarray):
        return False
    try:
        return memoryview(samples).format in ("B", "c")  # type: ignore[arg-type]
    except TypeError:  # no buffer
        return False


def checked_rate(rate: int) -> int:
    """A sample rate that is one; ``16000.0`` is 16000.

    Raises:
        AudioError: it is none.
    """
    if not isinstance(rate, Real) or not 1000 <= rate <= MAX_RATE or rate != int(rate):
        shown = f"{rate} Hz" if isinstance(rate, Real) else repr(rate)
        raise AudioError(f"{shown} is no sample rate of sound\n    give one from 1000 to {MAX_RATE}, such as 16000")
    return int(rate)


def _check_seconds(name: str, value: float) -> None:
    if isinstance(value, bool) or not isinstance(value, Real) or not value > 0:
        raise AudioError(f"{name}={value!r} is no time\n    give seconds, more than 0")
