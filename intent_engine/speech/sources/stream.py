"""Sound that the embedding process has already: NumPy arrays pushed from any thread, at any rate."""

from __future__ import annotations

from collections.abc import Iterator
from numbers import Real

import numpy as np
import numpy.typing as npt

from intent_engine.errors import AudioError
from intent_engine.speech.audio import MAX_RATE, Frame, to_float
from intent_engine.speech.sources.live import CAPACITY, Clock, Inbox, Reporter

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
            dropped, and this is told. Else it is a recording: ``push`` waits for room, and times are counts.
        patience: s without a push after which a live stream counts as deaf, which stops the robot: it could not be
            told to stop. None: silence stands in, for programs that push nothing while nobody speaks.
        capacity: s of sound that may wait.
        on_report: is told what was lost, went away and came back.
        clock: None: the machine's.

    Raises:
        AudioError: the rate is none.
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
        self._live = live
        self._inbox = Inbox("the stream", patience=patience, capacity=capacity, on_report=on_report, clock=clock)

    def push(self, samples: npt.ArrayLike) -> bool:
        """Bring more sound.

        Args:
            samples: ``(n,)`` or ``(n, channels)``, any number type; integers are scaled by their range. Copied. What is
                not finite becomes silence.

        Returns:
            False when the stream was closed or ended: nobody hears it.

        Raises:
            AudioError: not an array of such a shape, or not of numbers.
        """
        given = np.asarray(samples)
        if given.ndim not in (1, 2) or (given.ndim == 2 and not 1 <= given.shape[1] <= MAX_CHANNELS):
            raise AudioError(
                f"the stream was given an array of shape {given.shape}\n"
                "    push (samples,) for one channel, (samples, channels) for more"
            )
        try:
            sound = np.array(to_float(given))
        except TypeError as error:
            raise AudioError(f"the stream was given no sound: {error}") from None
        step = self.rate  # a second at a time, so that the box never holds one block larger than itself
        return all(
            self._inbox.put(sound[start : start + step], self.rate, wait=not self._live)
            for start in range(0, max(len(sound), 1), step)
        )

    def frames(self) -> Iterator[Frame]:
        return self._inbox.frames(counted=not self._live)

    def end(self) -> None:
        """Nothing more will be pushed."""
        self._inbox.end()

    def close(self) -> None:
        self._inbox.close()

    def wake(self) -> None:
        self._inbox.wake()


def checked_rate(rate: int) -> int:
    """A sample rate that is one.

    Raises:
        AudioError: it is none.
    """
    if not isinstance(rate, Real) or not 1000 <= rate <= MAX_RATE:
        shown = f"{rate} Hz" if isinstance(rate, Real) else repr(rate)
        raise AudioError(f"{shown} is no sample rate of sound\n    give one from 1000 to {MAX_RATE}, such as 16000")
    return rate
