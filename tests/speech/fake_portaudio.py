"""A stand-in for the sounddevice module: microphones that are plugged in, unplugged and busy, in virtual time.

It is the only part that is not real, and stands at the seam to the hardware that a test machine does not have.
"""

from __future__ import annotations

import heapq
import itertools
import math
import threading
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np


class FakeTime:
    """A clock whose waits do at once what is due, and never sleep."""

    def __init__(self) -> None:
        self.time = 100.0  # like a machine's, it does not begin at zero
        self._due: list[tuple[float, int, Callable[[], None]]] = []
        self._order = itertools.count()

    def now(self) -> float:
        return self.time

    def at(self, moment: float, what: Callable[[], None]) -> None:
        heapq.heappush(self._due, (moment, next(self._order), what))

    def later(self, seconds: float, what: Callable[[], None]) -> None:
        self.at(self.time + seconds, what)

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        if self._due and (deadline is None or self._due[0][0] <= deadline):
            moment, _, what = heapq.heappop(self._due)
            self.time = max(self.time, moment)
            what()
            return False
        if deadline is None:
            raise AssertionError("it would wait for ever")
        self.time = max(self.time, deadline)
        return True

    def pass_by(self, seconds: float) -> None:
        """Time passes while nobody waits: what is due happens."""
        end = self.time + seconds
        while self._due and self._due[0][0] <= end:
            moment, _, what = heapq.heappop(self._due)
            self.time = max(self.time, moment)
            what()
        self.time = end


class PortAudioError(Exception):
    pass


def tone(hertz: float = 440.0) -> Callable[[np.ndarray], np.ndarray]:
    return lambda time: 0.5 * np.sin(2 * math.pi * hertz * time)


class Plug:
    """A microphone of the fake."""

    def __init__(
        self,
        name: str,
        *,
        channels: int = 1,
        rate: int = 16_000,
        rates: tuple[int, ...] = (16_000, 44_100, 48_000),
        sound: Callable[[np.ndarray], np.ndarray] | None = None,
        true_rate: float | None = None,
        busy: bool = False,
        delay: float = 0.0,
    ) -> None:
        self.name, self.channels, self.rate, self.rates = name, channels, rate, rates
        self.sound = sound or tone()
        self.true_rate = true_rate
        """Hz at which samples really come; a cheap oscillator."""
        self.busy = busy
        self.delay = delay
        """s from its start to its first sound."""
        self.plugged = True
        self.overflows = 0
        """Of so many blocks to come it is said that sound was lost before them."""

    def entry(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "max_input_channels": self.channels,
            "max_output_channels": 0,
            "default_samplerate": float(self.rate),
            "hostapi": 0,
        }


class FakePortAudio:
    """Put this in ``sys.modules["sounddevice"]``."""

    PortAudioError = PortAudioError

    def __init__(self, time: FakeTime, *plugs: Plug) -> None:
        self.time = time
        self.plugs = list(plugs)
        self.open_streams: list[Any] = []
        self.started = 0
        """How often PortAudio was started."""
        self._initialize()
        self.InputStream = lambda **how: _Stream(self, **how)

    def _initialize(self) -> None:
        self.started += 1
        self._seen = [plug for plug in self.plugs if plug.plugged]  # as PortAudio, it looks only once

    def _terminate(self) -> None:
        for stream in list(self.open_streams):
            stream.running = False
        self.open_streams.clear()

    @property
    def default(self) -> Any:
        return SimpleNamespace(device=(0 if self._seen else -1, -1))

    def query_devices(self) -> list[dict[str, Any]]:
        speaker = {**Plug("loudspeaker").entry(), "max_input_channels": 0, "max_output_channels": 2}
        return [plug.entry() for plug in self._seen] + [speaker]

    def query_hostapis(self, index: int) -> dict[str, Any]:
        return {"name": "Fake"}

    def plug(self, index: int) -> Plug:
        return self._seen[index]

    def check_input_settings(self, *, device: int, channels: int, dtype: str, samplerate: float) -> None:
        plug = self.plug(device)
        if not plug.plugged:
            raise PortAudioError("Device unavailable [PaErrorCode -9985]")
        if samplerate not in plug.rates:
            raise PortAudioError("Invalid sample rate [PaErrorCode -9997]")
        if channels > plug.channels or (plug.channels > 1 and channels == 1 and plug.name.startswith("stereo")):
            raise PortAudioError("Invalid number of channels [PaErrorCode -9998]")


class _Stream:
    def __init__(
        self,
        owner: FakePortAudio,
        *,
        device: int,
        samplerate: int,
        channels: int,
        dtype: str,
        blocksize: int,
        callback: Callable[..., None],
        finished_callback: Callable[[], None],
    ) -> None:
        self.owner, self.plug = owner, owner.plug(device)
        self.rate, self.channels, self.block = samplerate, channels, blocksize
        self.callback, self.finished = callback, finished_callback
        self.running = False
        self.given = 0

    def start(self) -> None:
        if self.plug.busy or not self.plug.plugged:
            raise PortAudioError("Device unavailable [PaErrorCode -9985]")
        self.running = True
        self.owner.open_streams.append(self)
        self.began = self.owner.time.now() + self.plug.delay
        self._next()

    def _next(self) -> None:
        true_rate = self.plug.true_rate or self.rate
        self.owner.time.at(self.began + (self.given + self.block) / true_rate, self._block)

    def _block(self) -> None:
        if not self.running:
            return
        if not self.plug.plugged:
            self.running = False
            self.finished()
            return
        moments = (self.given + np.arange(self.block)) / self.rate
        sound = np.repeat(self.plug.sound(moments).astype(np.float32)[:, None], self.channels, axis=1)
        overflow = self.plug.overflows > 0
        self.plug.overflows -= overflow
        self.given += self.block
        self.callback(sound, self.block, None, SimpleNamespace(input_overflow=overflow) if overflow else None)
        self._next()

    def abort(self, ignore_errors: bool = True) -> None:
        self.running = False

    def close(self, ignore_errors: bool = True) -> None:
        self.running = False
        if self in self.owner.open_streams:
            self.owner.open_streams.remove(self)
