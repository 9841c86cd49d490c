"""Less noise for the recogniser: some of what RNNoise takes for noise is taken out, while the person still speaks.

Taking out all of it takes something of the voice as well, by which Whisper loses more than it gains;
docs/decisions/speech-noise.md has figures. The voice detector and the reflex hear the sound as it is. RNNoise needs 2
to 3 ms for a frame of 32 ms, so it follows the speech instead of waiting for its end, and it is left out where hardly
any noise can be heard.

Source: J.-M. Valin, "A Hybrid DSP/Deep Learning Approach to Real-Time Full-Band Speech Enhancement", 2018;
https://github.com/xiph/rnnoise. The library comes with the package pyrnnoise, whose own module is not imported: it
brings a sound reader and a plotter along.
"""

from __future__ import annotations

import ctypes
import platform
from collections import deque
from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from intent_engine.errors import ConfigError, Problem
from intent_engine.speech.audio import SAMPLE_RATE, Samples

__all__ = ["FilteredSpeech", "NoiseFilter", "RNNoise", "installed_filter"]

RATE = 48_000
"""Hz, of RNNoise."""
BLOCK = 480
"""Samples that RNNoise takes at a time."""
DELAY = 960
"""Samples by which what it gives is late."""
FULL_SCALE = 32768.0
TAKEN_OUT = 0.3
"""Share of the noise that is taken out. Of 184 coffee orders in kitchen noise at 6 and 12 dB 150 were right with none,
153 with this share and 150 with half of it taken out."""
NOISE = 12
"""Frames at the beginning of what is kept from before the onset, from which the noise is measured."""
QUIET = 1000.0
"""Energy of the loudest frame over that of the noise before it, from which there is nothing to take out: 30 dB."""
CATCH_UP = 3
"""Frames filtered with each new one, at most, so that nothing waits long for those from before the onset."""


class FilteredSpeech(Protocol):
    """The sound of one utterance, on its way through a filter."""

    def add(self, samples: Samples) -> None:
        """Take one frame more."""
        ...

    def sound(self) -> Samples:
        """All that was taken, filtered; as long as it was."""
        ...


class NoiseFilter(Protocol):
    """Filters utterances."""

    def begin(self, frames: Iterable[Samples]) -> FilteredSpeech:
        """A new utterance, with the sound from before its onset and that of it."""
        ...


class RNNoise:
    """RNNoise, from the package pyrnnoise.

    Args:
        share: of the noise that is taken out, 0 to 1.

    Raises:
        ConfigError: the package is not installed; says how.
    """

    def __init__(self, share: float = TAKEN_OUT) -> None:
        if not 0 <= share <= 1:
            raise ConfigError(Problem(f"a share of {share:g} of the noise", hint="give 0 to 1"))
        self._library = _library()
        self._share = share

    def begin(self, frames: Iterable[Samples]) -> FilteredSpeech:
        return _Speech(self._library, self._share, list(frames))


def installed_filter() -> NoiseFilter | None:
    """RNNoise where it is installed, else None."""
    try:
        return RNNoise()
    except ConfigError:
        return None


class _Speech:
    _state: Any = None
    """What the library keeps of the sound; None: a signal came while it was made."""

    def __init__(self, library: Any, share: float, frames: list[Samples]) -> None:
        import soxr

        self._library, self._share = library, share
        self._state = library.rnnoise_create(None)
        self._frames: list[Samples] = []
        self._waiting: deque[Samples] = deque()
        self._noise = max(float(np.median([_energy(frame) for frame in frames[:NOISE]])) if frames else 0.0, 1e-12)
        self._loudest = 0.0
        self._up = soxr.ResampleStream(SAMPLE_RATE, RATE, 1, dtype="float32")
        self._rest: npt.NDArray[np.float32] = np.zeros(0, np.float32)
        self._out: list[npt.NDArray[np.float32]] = []
        for frame in frames:
            self._take(frame)

    def __del__(self) -> None:
        if self._state is not None:
            self._library.rnnoise_destroy(self._state)

    @property
    def quiet(self) -> bool:
        """Whether the speech is so much louder than the noise that the noise does no harm."""
        return self._loudest > self._noise * QUIET

    def add(self, samples: Samples) -> None:
        self._take(samples)
        self._catch_up(CATCH_UP)

    def sound(self) -> Samples:
        import soxr

        whole = np.concatenate(self._frames) if self._frames else np.zeros(0, np.float32)
        if self.quiet:
            return whole
        self._catch_up(len(self._waiting))
        if not self._out:
            return whole
        less = soxr.resample(np.concatenate(self._out)[DELAY:] / FULL_SCALE, RATE, SAMPLE_RATE)[: whole.size]
        if not np.isfinite(less).all():
            return whole
        # The last few milliseconds are still on their way.
        mixed = whole.copy()
        mixed[: less.size] += self._share * (less - whole[: less.size])
        return mixed

    def _take(self, samples: Samples) -> None:
        self._frames.append(samples)
        self._loudest = max(self._loudest, _energy(samples))
        if self.quiet:
            self._waiting.clear()
        else:
            self._waiting.append(samples)

    def _catch_up(self, most: int) -> None:
        for _ in range(min(most, len(self._waiting))):
            clean = np.clip(np.nan_to_num(self._waiting.popleft()), -1.0, 1.0).astype(np.float32)
            more = self._up.resample_chunk(clean) * np.float32(FULL_SCALE)
            sound = np.ascontiguousarray(np.concatenate([self._rest, more]), np.float32)
            whole = sound.size - sound.size % BLOCK
            for at in range(0, whole, BLOCK):
                block = sound[at:].ctypes.data
                self._library.rnnoise_process_frame(self._state, block, block)
            self._out.append(sound[:whole])
            self._rest = sound[whole:]


def _energy(samples: Samples) -> float:
    """Mean square of a frame."""
    return float(np.mean(np.square(np.nan_to_num(samples), dtype=np.float64))) if samples.size else 0.0


@cache
def _library() -> Any:
    """The shared library in the package."""
    name = {"Darwin": "librnnoise.dylib", "Windows": "rnnoise.dll"}.get(platform.system(), "librnnoise.so")
    package = find_spec("pyrnnoise")
    folders = package.submodule_search_locations if package is not None else None
    file = Path(folders[0]) / name if folders else None
    if file is None or not file.is_file():
        raise ConfigError(Problem("RNNoise is not installed", hint="pip install 'intent-engine[noise]'"))
    try:
        library = ctypes.CDLL(str(file))
    except OSError as error:
        raise ConfigError(Problem(f"RNNoise cannot be loaded: {error}")) from None
    library.rnnoise_create.argtypes = [ctypes.c_void_p]
    library.rnnoise_create.restype = ctypes.c_void_p
    library.rnnoise_destroy.argtypes = [ctypes.c_void_p]
    library.rnnoise_destroy.restype = None
    library.rnnoise_process_frame.argtypes = [ctypes.c_void_p] * 3
    library.rnnoise_process_frame.restype = ctypes.c_float
    return library
