"""Sound at any rate to another, bit by bit, with little of it held back: docs/decisions/speech-resampling.md."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["StreamResampler"]

TAPS = 64
"""Taps of the filter at the lower of the two rates, so that 2 ms of 16 kHz are held back. Twice libswresample's own,
which would dampen 7.5 kHz by 3 dB instead of 1."""
FORM = "flt"
"""32-bit floats, channels side by side, as FFmpeg calls them."""


class StreamResampler:
    """libswresample by way of PyAV: a filter in the time domain, which gives each sample as soon as it can.

    Args:
        rate: Hz, of what is pushed.
        to: Hz, of what comes out.
    """

    def __init__(self, rate: int, to: int) -> None:
        import av
        from av.filter import Graph

        self._nothing_more = (av.error.BlockingIOError, av.error.EOFError)
        self._new_frame = av.AudioFrame.from_ndarray
        self._rate, self._to = rate, to
        self._pushed = self._given = 0
        # The graph is kept beside its ends: these do not keep it alive, and are no more without it.
        self._graph = Graph()
        self._in = self._graph.add_abuffer(
            format=FORM, sample_rate=rate, layout="mono", time_base=Fraction(1, rate), name="in"
        )
        swr = self._graph.add("aresample", f"{to}:filter_size={TAPS}")
        packed = self._graph.add("aformat", f"sample_fmts={FORM}:channel_layouts=mono")
        self._out = self._graph.add("abuffersink")
        self._graph.link_nodes(self._in, swr, packed, self._out)
        self._graph.configure()

    def push(self, samples: npt.NDArray[np.float32], *, last: bool = False) -> npt.NDArray[np.float32]:
        """What is whole after more sound; with ``last`` all the rest, and nothing may follow.

        Args:
            samples: ``(n,)``
        """
        self._add(samples)
        if not last:
            return self._ready()
        # libswresample would end with a mirror image of the last half filter, and with nothing of a sound that is
        # shorter than that. Sound that ends is followed by silence.
        wanted = math.ceil(self._pushed * self._to / self._rate) - self._given
        self._add(np.zeros(TAPS * math.ceil(max(self._rate / self._to, 1.0)), np.float32))
        self._in.push(None)
        return self._ready()[:wanted]

    def _add(self, samples: npt.NDArray[np.float32]) -> None:
        if not samples.size:
            return
        frame = self._new_frame(np.ascontiguousarray(samples[None]), format=FORM, layout="mono")
        frame.sample_rate = self._rate
        frame.pts = self._pushed
        self._pushed += samples.size
        self._in.push(frame)

    def _ready(self) -> npt.NDArray[np.float32]:
        parts = [np.zeros(0, np.float32)]
        while True:
            try:
                frame: Any = self._out.pull()
                parts.append(frame.to_ndarray()[0])
            except self._nothing_more:
                break
        whole = np.concatenate(parts)
        self._given += whole.size
        return whole
