"""Noise reduction, off unless asked for: a filter between the microphone and the recogniser.

Whisper was trained on noisy speech, and may lose more by what a filter takes from the voice than it gains. Measure with
your own noise before you switch it on: docs/decisions/speech-noise.md has figures.

It filters what was said as a whole, just before it is recognised. The voice detector and the reflex hear the unfiltered
sound: a filter of the stream would delay a stop.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from intent_engine.errors import ConfigError, Problem
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.leaving import Leavable
from intent_engine.speech.recognizer import Glancing, Recognizer, Transcript

__all__ = ["DenoisedRecognizer", "NoiseReduction"]

STRENGTH = 0.8
"""Share of the noise that is taken away; all of it makes the voice ring."""
FFT = 512
"""Samples of a window: 32 ms, as usual for speech."""
QUIET = 0.25
"""Share of the windows, the quietest, that are taken for noise: the sound before the first word and between words."""
MIN_SAMPLES = 16 * FFT
"""Shorter sound has nothing to estimate noise from."""


class NoiseReduction:
    """Spectral gating by the noisereduce package, with the noise estimated from the sound itself.

    Args:
        strength: share of the noise that is taken away, 0 to 1.

    Raises:
        ConfigError: the package is not installed; says how.
    """

    def __init__(self, strength: float = STRENGTH) -> None:
        if not 0 <= strength <= 1:
            raise ConfigError(Problem(f"noise reduction of strength {strength:g}", hint="give 0 to 1"))
        try:
            from noisereduce import reduce_noise
        except ImportError:
            raise ConfigError(
                Problem("noise reduction is not installed", hint="pip install 'intent-engine[noise]'")
            ) from None
        self._reduce: Any = reduce_noise
        self._strength = strength

    def __call__(self, samples: Samples) -> Samples:
        """The same sound with less noise; as long as it was, finite, and never louder than full scale."""
        if samples.size < MIN_SAMPLES or not samples.any() or not np.isfinite(samples).all():
            return samples
        with np.errstate(all="ignore"):
            found = self._reduce(
                y=samples,
                sr=SAMPLE_RATE,
                y_noise=_quietest(samples),
                stationary=True,
                prop_decrease=self._strength,
                n_fft=FFT,
                use_torch=False,
            )
        sound = np.nan_to_num(np.asarray(found, np.float32), nan=0.0, posinf=0.0, neginf=0.0)
        return np.clip(sound[: samples.size], -1.0, 1.0)


def _quietest(samples: Samples) -> Samples:
    """The quietest windows, one after the other."""
    windows = samples[: samples.size - samples.size % FFT].reshape(-1, FFT)
    energy = np.square(windows, dtype=np.float64).sum(axis=1)
    count = max(4, int(QUIET * len(windows)))
    return np.ascontiguousarray(windows[np.sort(np.argsort(energy, kind="stable")[:count])].reshape(-1))


class DenoisedRecognizer:
    """A recogniser that hears what a filter has left.

    Args:
        recognizer: what recognises.
        filter: what it hears through.
    """

    def __init__(self, recognizer: Recognizer, filter: NoiseReduction | None = None) -> None:
        self.recognizer = recognizer
        self._filter = filter or NoiseReduction()

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        return self.recognizer.transcribe(self._filter(samples), final=final)

    def glance(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Glancing.glance`; who has none is sure of nothing."""
        if not isinstance(self.recognizer, Glancing):
            return Transcript("", draft=True)
        return self.recognizer.glance(self._filter(samples))

    def leave(self) -> None:
        """As :meth:`~intent_engine.speech.leaving.Leavable.leave`, if the recogniser can be left."""
        if isinstance(self.recognizer, Leavable):
            self.recognizer.leave()

    def close(self) -> None:
        self.recognizer.close()
