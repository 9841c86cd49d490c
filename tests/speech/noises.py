"""Sound that is no command, made from a seed: noises, music, and speech that nobody said."""

from __future__ import annotations

import numpy as np

from intent_engine.speech.audio import SAMPLE_RATE

__all__ = ["beat", "chords", "clicks", "pink", "sweep", "white"]


def white(seconds: float, level: float, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, level, int(seconds * SAMPLE_RATE))


def pink(seconds: float, level: float, seed: int = 2) -> np.ndarray:
    """Noise whose power falls with 1/f, as that of rooms and roads does."""
    spectrum = np.fft.rfft(white(seconds, 1.0, seed))
    spectrum[1:] /= np.sqrt(np.arange(1, spectrum.size))
    spectrum[0] = 0
    sound = np.fft.irfft(spectrum)
    return level * sound / sound.std()


def _moments(seconds: float) -> np.ndarray:
    return np.arange(int(seconds * SAMPLE_RATE)) / SAMPLE_RATE


def chords(seconds: float, level: float) -> np.ndarray:
    """A tune in chords of several harmonics, two a second, each with its attack and decay."""
    moments = _moments(seconds)
    sound = np.zeros(moments.size)
    progression = ((220.0, 277.2, 329.6), (246.9, 311.1, 370.0), (196.0, 246.9, 293.7), (261.6, 329.6, 392.0))
    length = SAMPLE_RATE // 2
    for start in range(0, moments.size, length):
        part = moments[start : start + length] - moments[start]
        for note in progression[(start // length) % 4]:
            for harmonic in range(1, 6):
                sound[start : start + length] += (
                    np.sin(2 * np.pi * note * harmonic * part) / harmonic * np.exp(-4 * part)
                )
    return level * sound / np.abs(sound).max()


def beat(seconds: float, level: float, seed: int = 3) -> np.ndarray:
    """Drums: bursts of noise and of low tones, four a second."""
    moments = _moments(seconds) % 0.25
    drums = np.sin(2 * np.pi * 80 * moments) + np.random.default_rng(seed).normal(0, 0.3, moments.size)
    return level * drums * np.exp(-20 * moments)


def sweep(seconds: float, level: float) -> np.ndarray:
    """A siren through the voice's band."""
    phase = 2 * np.pi * np.cumsum(800 + 700 * np.sin(2 * np.pi * 0.7 * _moments(seconds))) / SAMPLE_RATE
    return level * np.sin(phase)


def clicks(seconds: float, level: float) -> np.ndarray:
    sound = np.zeros(int(seconds * SAMPLE_RATE))
    sound[:: SAMPLE_RATE // 7] = level
    return sound
