"""Sound files: WAV, FLAC and whatever else libsndfile reads, at any rate, streamed."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.errors import AudioError
from intent_engine.speech.audio import Frame, Resampler
from intent_engine.speech.scale import check_scale, faint, holds_16_bits
from intent_engine.speech.sources.pcm import FORMATS, OTHERS, PcmFormat
from intent_engine.speech.sources.whole import ENDLESS, check_mp3, check_whole
from intent_engine.values import check_path

__all__ = ["FileSource", "is_headerless"]

MAX_SECONDS = 4 * 3600.0
"""A recording beyond this is a mistake; a session of commands has minutes."""
TAIL_SECONDS = 0.8
"""Silence added at the end, so that the last command is heard to end."""
BLOCK = 1 << 15
HEADERLESS = (".raw", ".pcm", *(f".{name}" for name in FORMATS))
"""Endings of files that hold nothing but samples."""
SUBTYPES = {
    "u8": "PCM_U8",
    "s8": "PCM_S8",
    "s16": "PCM_16",
    "s24": "PCM_24",
    "s32": "PCM_32",
    "f32": "FLOAT",
    "f64": "DOUBLE",
}
"""Samples -> what libsndfile calls them."""


def is_headerless(path: str | Path) -> bool:
    """Whether a file holds raw samples, by its name."""
    return Path(path).suffix.lower() in HEADERLESS


class FileSource:
    """Frames of a sound file.

    Args:
        path: WAV, FLAC, OGG, AIFF; any rate, mono or more channels.
        realtime: play at the speed of the recording; else as fast as the reader takes it.
        form: how raw samples lie in it, which no header tells; None: it has a header.

    Raises:
        AudioError: the file is missing, empty, cut off, no sound file, longer than four hours, or of samples at a
            wrong scale.
    """

    def __init__(self, path: str | Path, *, realtime: bool = False, form: PcmFormat | None = None) -> None:
        import soundfile

        check_path("a recording", path)
        self.path = Path(path)
        self._realtime = realtime
        self._form = _libsndfile(form) if form is not None else {}
        self._closed = False
        try:
            _check_there(self.path)
        except OSError as error:  # also of a name too long for any file, and in a folder that may not be looked into
            raise AudioError(f"{path}: cannot be read: {(error.strerror or str(error)).lower()}") from None
        if form is None and is_headerless(self.path):
            raise AudioError(
                f"{path}: holds raw samples, by its name, and nothing says how they lie in it\n"
                "    give --rate and --format, as --rate 16000 --format s16le, or pipe it in: intent-engine run - < "
                f"{path}"
            )
        if form is None:
            check_mp3(self.path)
        try:
            with soundfile.SoundFile(str(self.path), **self._form) as info:
                self.rate: int = info.samplerate
                channels, frames = info.channels, info.frames
        except (soundfile.LibsndfileError, RuntimeError, OSError):
            raise AudioError(f"{path}: {_unreadable(self.path)}") from None
        if self.rate <= 0 or channels <= 0 or frames <= 0:
            raise AudioError(f"{path}: holds no sound\n    record it again")
        if frames >= ENDLESS:
            raise AudioError(
                f"{path}: does not say how long it is, as a FLAC file that was written into a pipe\n"
                f"    convert it: ffmpeg -i {self.path.name} speech.wav"
            )
        self.seconds: float = frames / self.rate
        """Length of the recording in s."""
        if self.seconds > MAX_SECONDS:
            raise AudioError(
                f"{path}: lasts {self.seconds / 3600:.1f} hours; at most {MAX_SECONDS / 3600:.0f} are taken\n"
                "    cut out the part with the commands"
            )
        if form is None:
            check_whole(self.path)
        self._check_scale()

    def _check_scale(self) -> None:
        """See that numbers are a sound's: what tools write of arrays may be integers that are called floats, or that
        were given more bits than they fill."""
        import soundfile

        with soundfile.SoundFile(str(self.path), **self._form) as file:
            if file.subtype in ("FLOAT", "DOUBLE"):
                for block in file.blocks(BLOCK, dtype="float64"):
                    hint = "write the samples as 16-bit integers, or divide them by 32768"
                    check_scale(block, f"{self.path}: holds", hint)
            elif file.subtype == "PCM_32" and _holds_16_bits(file.blocks(BLOCK, dtype="int32")):
                raise AudioError(
                    f"{self.path}: holds 16-bit samples in 32 bits, which are heard as silence\n"
                    "    write them as 16-bit integers: samples.astype(np.int16)"
                )

    def frames(self) -> Iterator[Frame]:
        began = time.monotonic()
        for frame in self._frames():
            if self._closed:
                return
            if self._realtime:
                wait = began + frame.time - time.monotonic()
                if wait > 0:
                    time.sleep(wait)
            yield frame

    def _frames(self) -> Iterator[Frame]:
        import soundfile

        resampler = Resampler(self.rate)
        read = 0
        try:
            with soundfile.SoundFile(str(self.path), **self._form) as file:
                expected = file.frames if file.format != "MP3" else 0  # of an MP3 file it is a guess
                while True:
                    block = file.read(BLOCK, dtype="float32", always_2d=True)
                    if not len(block):
                        break
                    read += len(block)
                    yield from resampler.push(block)
        except (soundfile.LibsndfileError, RuntimeError, OSError) as error:
            raise AudioError(f"{self.path}: breaks off after {read / self.rate:.1f} s ({error})") from None
        if read < expected:
            raise AudioError(
                f"{self.path}: is cut off: {read / self.rate:.1f} s of {expected / self.rate:.1f} s are there\n"
                "    copy or record it again"
            )
        silence = np.zeros(int(TAIL_SECONDS * self.rate), np.float32)
        yield from resampler.push(silence, last=True)

    def close(self) -> None:
        self._closed = True


def _check_there(path: Path) -> None:
    """See that a file is there, with something in it.

    Raises:
        AudioError: it is not.
        OSError: it cannot be read.
    """
    if not path.exists():
        raise AudioError(f"{path}: no such file\n    give the path of a WAV or FLAC file")
    if path.is_dir():
        raise AudioError(f"{path}: is a folder\n    give the path of a WAV or FLAC file")
    if not path.is_file():
        raise AudioError(f"{path}: is a pipe or a device, not a file\n    pipe it in: intent-engine run - < {path}")
    with path.open("rb"):
        pass
    if path.stat().st_size == 0:
        raise AudioError(f"{path}: is empty (0 bytes)\n    record it again")


def _holds_16_bits(blocks: Iterable[npt.NDArray[np.int32]]) -> bool:
    """Whether a recording of 32-bit integers is one of 16 bits throughout."""
    found = False
    for block in blocks:
        if not faint(block):
            return False
        found = found or holds_16_bits(block)
    return found


def _unreadable(path: Path) -> str:
    """What a file is that libsndfile does not read."""
    with path.open("rb") as file:
        head = file.read(4)
    convert = f"convert it: ffmpeg -i {path.name} speech.wav"
    kind = next((name for begin, name in OTHERS.items() if head.startswith(begin)), "")
    if not kind:
        return f"is no sound file that can be read\n    {convert}"
    why = "it is cut off, damaged or of an odd kind"
    return f"begins as {kind} does, but cannot be read: {why}\n    copy it again, or {convert}"


def _libsndfile(form: PcmFormat) -> dict[str, Any]:
    """A format of raw samples, as soundfile takes it."""
    return {
        "samplerate": form.rate,
        "channels": form.channels,
        "format": "RAW",
        "subtype": SUBTYPES[form.encoding.removesuffix("le").removesuffix("be")],
        "endian": "BIG" if form.encoding.endswith("be") else "LITTLE",
    }
