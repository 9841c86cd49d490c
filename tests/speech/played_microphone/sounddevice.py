"""A microphone that plays a recording, for whole processes: put this folder first on PYTHONPATH.

``PLAYED`` names the recording; it is played once, in its own time, and then there is quiet. ``PLAYED=none`` is a
machine without a microphone, ``PLAYED=zeros`` a muted one.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import soundfile

PLAYED = os.environ["PLAYED"]
RATE = 16_000


class PortAudioError(Exception):
    pass


default = SimpleNamespace(device=(-1 if PLAYED == "none" else 0, -1))


def get_portaudio_version() -> tuple[int, str]:
    return 0, "played"


def query_devices() -> list[dict[str, Any]]:
    entry = {"name": "played", "max_input_channels": 1, "default_samplerate": float(RATE), "hostapi": 0}
    return [] if PLAYED == "none" else [entry]


def query_hostapis(index: int) -> dict[str, Any]:
    return {"name": "a file"}


def check_input_settings(**settings: Any) -> None:
    if settings["samplerate"] != RATE or settings["channels"] != 1:
        raise PortAudioError("Invalid sample rate")


def _initialize() -> None: ...


def _terminate() -> None: ...


class InputStream:
    def __init__(self, *, blocksize: int, callback: Callable[..., None], **others: Any) -> None:
        self._block, self._callback = blocksize, callback
        self._ended = threading.Event()
        if PLAYED == "zeros":
            self._sound, self._quiet = np.zeros(0, np.float32), 0.0
        else:
            self._sound, _ = soundfile.read(PLAYED, dtype="float32")
            self._quiet = 1e-4
        self._random = np.random.default_rng(1)

    def start(self) -> None:
        threading.Thread(target=self._play, daemon=True).start()

    def _play(self) -> None:
        began, given = time.monotonic(), 0
        while not self._ended.wait(max(0.0, began + (given + self._block) / RATE - time.monotonic())):
            block = self._quiet * self._random.standard_normal(self._block).astype(np.float32)
            part = self._sound[given : given + self._block]
            block[: part.size] += part
            given += self._block
            self._callback(block[:, None], self._block, None, None)

    def abort(self, ignore_errors: bool = True) -> None:
        self._ended.set()

    close = abort
