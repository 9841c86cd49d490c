"""The sound of a labelled recording, clean or with noise, as a source for the runtime."""

from __future__ import annotations

import functools
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from intent_engine.errors import AudioError
from intent_engine.evaluation.label_files import MOST_PROBLEMS
from intent_engine.evaluation.labels import Row
from intent_engine.speech.audio import SAMPLE_RATE, Frame, Resampler, Samples
from intent_engine.speech.sources.file import TAIL_SECONDS, FileSource

__all__ = ["ENERGY_FRAME", "Noise", "SamplesSource", "check", "end_of_speech", "load", "mix", "read_whole", "silent"]

ENERGY_FRAME = 2048
"""Samples of a frame whose energy is compared, as Picovoice's speech-to-intent benchmark does: pauses in the speech
then do not count."""

SPEECH_FLOOR = 35.0
"""dB below the loudest 10 ms: speech ends where it stays below this. A final s or t is some 25 dB below a vowel."""
LOWEST_BIT = 1.01 * 2.0**-15
"""Of full scale, and what resampling adds to it."""


class SamplesSource:
    """Frames of sound that is at hand, at 16 kHz."""

    def __init__(self, samples: Samples) -> None:
        self._samples = samples
        self._closed = False

    def frames(self) -> Iterator[Frame]:
        for frame in Resampler(SAMPLE_RATE).push(self._samples, last=True):
            if self._closed:
                return
            yield frame

    def close(self) -> None:
        self._closed = True


def read_whole(path: Path) -> Samples:
    """A sound file as ``run`` hears it, at 16 kHz, with the silence that follows it.

    Raises:
        AudioError: it cannot be used.
    """
    return np.concatenate([frame.samples for frame in FileSource(path).frames()])


def load(row: Row) -> Samples:
    """The sound of a row, with the silence that follows it.

    Raises:
        AudioError: the file cannot be used.
    """
    if row.start == 0.0 and row.end is None:
        return read_whole(row.audio)
    whole = _read_last(row.audio, row.audio.stat().st_mtime_ns if row.audio.exists() else None)
    tail = int(TAIL_SECONDS * SAMPLE_RATE)
    spoken = whole[: whole.size - tail]
    first = round(row.start * SAMPLE_RATE)
    last = spoken.size if row.end is None else round(row.end * SAMPLE_RATE)
    return np.concatenate((spoken[first:last], np.zeros(tail, np.float32)))


@functools.lru_cache(maxsize=1)
def _read_last(path: Path, changed: int | None) -> Samples:
    """As :func:`read_whole`; the file read last is kept, since parts of one stand below each other in the labels.

    Args:
        path: of the file.
        changed: ns, when: another time is another file; None: it is not there.
    """
    return read_whole(path)


def check(rows: Sequence[Row], labels: Path) -> None:
    """Open every sound file of the labels before the first is heard, so that an hour's work does not end at the last.

    Raises:
        AudioError: with every row whose sound cannot be used, by its line.
    """
    seconds: dict[Path, float | str] = {}
    wrong = []
    for row in rows:
        if row.audio not in seconds:
            try:
                seconds[row.audio] = FileSource(row.audio).seconds
            except AudioError as error:
                seconds[row.audio] = str(error)
        length = seconds[row.audio]
        if isinstance(length, str):
            wrong.append(f"{labels}:{row.line}: {length}")
        elif row.start >= length or (row.end or 0.0) > length + 0.5:
            wrong.append(f"{labels}:{row.line}: {row.audio} lasts {length:.1f} s only\n    correct 'start' and 'end'")
        elif row.speech_end is not None and row.speech_end > (row.end or length) - row.start + 0.5:
            lasts = (row.end or length) - row.start
            wrong.append(
                f"{labels}:{row.line}: 'speech_end' is {row.speech_end:g} s, and the sound lasts {lasts:.1f} s\n"
                "    count it from where the sound begins, from 'start' if there is one"
            )
    if wrong:
        more = [f"and {len(wrong) - MOST_PROBLEMS} more like these"] if len(wrong) > MOST_PROBLEMS else []
        raise AudioError("\n".join([*wrong[:MOST_PROBLEMS], *more]))


def mix(speech: Samples, noise: Samples, snr: float) -> Samples:
    """Speech in noise; both are made quieter together, if the sum would clip.

    Args:
        speech: ``(n,)``
        noise: ``(n,)``
        snr: dB, between the largest frame energies of the two.
    """
    loudest, quiet = _energy(speech), _energy(noise)
    if loudest == 0.0 or quiet == 0.0:
        return speech
    mixed: Samples = speech + noise * np.float32(np.sqrt(loudest / quiet / 10 ** (snr / 10)))
    return mixed / np.float32(max(float(np.abs(mixed).max()), 1.0))


def silent(samples: Samples) -> bool:
    """Whether no sound is louder than the lowest bit of 16."""
    return not samples.size or float(np.abs(samples).max()) <= LOWEST_BIT


def _energy(samples: Samples) -> float:
    whole = samples.size // ENERGY_FRAME
    if whole == 0:
        return float(np.square(samples, dtype=np.float64).sum())
    frames = samples[: whole * ENERGY_FRAME].reshape(whole, ENERGY_FRAME)
    return float(np.square(frames, dtype=np.float64).sum(axis=1).max())


def end_of_speech(samples: Samples, floor: float = SPEECH_FLOOR) -> float:
    """s: where the sound is last louder than so much below its loudest; for quiet recordings. 0 for silence.

    This is the end of the last word as one would cut it by hand, give or take 10 ms.

    Args:
        samples: ``(n,)``
        floor: dB below the loudest 10 ms.
    """
    size = SAMPLE_RATE // 100
    whole = samples.size // size
    energies = np.square(samples[: whole * size].reshape(whole, size), dtype=np.float64).mean(axis=1)
    if not np.any(energies):
        return 0.0
    loud = np.nonzero(energies >= energies.max() * 10 ** (-floor / 10))[0]
    return float((loud[-1] + 1) * size / SAMPLE_RATE)


@dataclass(frozen=True)
class Noise:
    """Recordings of noise, of which each row gets a piece: always the same one, whatever the SNR and the other rows."""

    recordings: tuple[Samples, ...]
    names: tuple[str, ...]

    @classmethod
    def read(cls, paths: Sequence[Path]) -> Noise:
        """Read noise files.

        Raises:
            AudioError: a file cannot be used, or is silent.
        """
        sounds = []
        for path in paths:
            whole = read_whole(path)
            sound = whole[: whole.size - int(TAIL_SECONDS * SAMPLE_RATE)]
            if not np.any(sound):
                raise AudioError(f"{path}: is silent\n    give a recording of noise")
            sounds.append(sound)
        return cls(tuple(sounds), tuple(path.stem for path in paths))

    def piece(self, name: str, size: int) -> Samples:
        """The noise for the row of a name, ``(size,)``; goes round where the recording is too short."""
        chance, chosen = self._chosen(name)
        recording = self.recordings[chosen]
        start = int(chance.integers(recording.size))
        if start + size > recording.size and size <= recording.size:
            start = int(chance.integers(recording.size - size + 1))
        return np.take(recording, np.arange(start, start + size), mode="wrap")

    def of(self, name: str) -> str:
        """The name of the recording from which the row of a name has its noise."""
        return self.names[self._chosen(name)[1]]

    def _chosen(self, name: str) -> tuple[np.random.Generator, int]:
        chance = np.random.default_rng(zlib.crc32(name.encode()))
        return chance, int(chance.integers(len(self.recordings)))
