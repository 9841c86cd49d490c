"""Raw samples from a pipe: ``arecord -f S16_LE -r 16000 -t raw | intent-engine listen --pcm -``.

What begins with a WAV header is read by its header, since programs that pipe sound often write one.
"""

from __future__ import annotations

import io
import os
import re
import stat
import struct
import sys
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass
from numbers import Integral
from typing import Any, BinaryIO

import numpy as np
import numpy.typing as npt

from intent_engine.errors import AudioError
from intent_engine.execution.clock import Clock
from intent_engine.speech.audio import Frame, to_float
from intent_engine.speech.scale import check_scale
from intent_engine.speech.sources.ending import Ending
from intent_engine.speech.sources.live import Inbox, Reporter
from intent_engine.speech.sources.stream import MAX_CHANNELS, checked_rate
from intent_engine.speech.sources.whole import UNKNOWN

__all__ = ["FORMATS", "PcmFormat", "PcmSource"]

FORMATS: dict[str, tuple[str, int]] = {
    "u8": ("u1", 1),
    "s8": ("i1", 1),
    "s16le": ("<i2", 2),
    "s16be": (">i2", 2),
    "s24le": ("", 3),
    "s32le": ("<i4", 4),
    "s32be": (">i4", 4),
    "f32le": ("<f4", 4),
    "f32be": (">f4", 4),
    "f64le": ("<f8", 8),
    "f64be": (">f8", 8),
}
"""Name, as ffmpeg has it -> type of NumPy, bytes a sample."""
BLOCK_SECONDS = 0.032
OTHERS = {
    b"fLaC": "FLAC",
    b"OggS": "Ogg",
    b"ID3": "MP3",
    b"\xff\xfb": "MP3",
    b"FORM": "AIFF",
    b"\x1aE\xdf\xa3": "Matroska",
}
"""First bytes of files that are no raw samples."""
MAX_HEADER = 1 << 20
"""Bytes of one chunk before the sound; more is no header."""


@dataclass(frozen=True, slots=True)
class PcmFormat:
    """How samples lie in a stream of bytes.

    Raises:
        AudioError: there is no such format; lists those that there are.
    """

    rate: int = 16_000
    """Hz."""
    encoding: str = "s16le"
    """One of ``FORMATS``; ALSA's names (``S16_LE``, ``S24_3LE``, ``FLOAT_LE``) are understood too."""
    channels: int = 1
    """Interleaved."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "rate", checked_rate(self.rate))
        object.__setattr__(self, "encoding", _plain(self.encoding))
        channels = self.channels
        if isinstance(channels, bool) or not isinstance(channels, Integral) or not 1 <= channels <= MAX_CHANNELS:
            raise AudioError(f"{channels} channels cannot be\n    give 1 for mono, 2 for stereo")
        object.__setattr__(self, "channels", int(channels))

    @property
    def frame_bytes(self) -> int:
        """Bytes of one sample of every channel."""
        return FORMATS[self.encoding][1] * self.channels

    def decode(self, data: bytes) -> npt.NDArray[Any]:
        """``(n, channels)``, -1 to 1, of a whole number of samples."""
        dtype, size = FORMATS[self.encoding]
        if size == 3:  # NumPy has no 24 bits: the lowest byte of 32 is zero
            wide = np.zeros((len(data) // 3, 4), np.uint8)
            wide[:, 1:] = np.frombuffer(data, np.uint8).reshape(-1, 3)
            samples = wide.reshape(-1).view("<i4")
        else:
            samples = np.frombuffer(data, dtype)
        return to_float(samples).reshape(-1, self.channels)


def _plain(encoding: str) -> str:
    """The name in ``FORMATS`` of an encoding that somebody calls so."""
    name = str(encoding).lower()
    if name in ("s24_le", "s24_be"):
        raise AudioError(
            f"{encoding} is what ALSA calls 24 bits that lie in 32, which would be heard as noise\n"
            "    record S24_3LE (s24le) or S32_LE (s32le)"
        )
    plain = re.sub("^s243", "s24", name.replace("_", ""))
    plain = re.sub("^fl(oa)?t", "f", plain)
    plain = re.sub("^f(?=[lb]e|$)", "f32", plain)
    if plain not in FORMATS and f"{plain}le" in FORMATS:
        plain += "le"
    if plain not in FORMATS:
        raise AudioError(f"{encoding} is no format of raw samples\n    there is {', '.join(FORMATS)}")
    return plain


AHEAD = 4.0
"""s of sound by which a pipe from a microphone may be ahead of the time since it is read: what it and its writer
hold."""


def _on_the_disk(file: BinaryIO) -> bool:
    """Whether a file object reads a regular file, and no pipe or device."""
    try:
        return stat.S_ISREG(os.fstat(file.fileno()).st_mode)
    except (OSError, ValueError, AttributeError):  # one in memory, one that is closed, or one of somebody's own
        return False


class PcmSource:
    """Frames of raw samples that are read from a file object, in a thread of its own.

    Life cycle: made -> ``check()`` (if wished) -> ``begin()`` (if wished) -> ``frames()`` reads until the end of the
    file -> ``close()`` (idempotent, from any thread). A read that is under way when it is closed is left behind; the
    file is not closed.

    What a live source brings between ``check`` and ``begin``, while models are loaded, say, is read and dropped, as a
    microphone that is not open yet does not hear it. To hear it later would be to act on what was said when nobody
    listened, seconds ago; and it could not be heard as what it was: a pipe holds two seconds, then whoever writes it
    loses sound and does not say where. So it is read, which keeps that from happening, and what comes next is marked as
    sound before which some is missing: "go forward" may be the end of "don't go forward", and only a stop is done then.

    A file on the disk, and what ends in that time or brings more sound than time has gone by (``cat command.raw |
    ...``), is no microphone but a recording, though it was called live: nothing of it is missing, and it is played at
    its own speed.

    Args:
        file: binary; a pipe, standard input (from where it stands now), a file.
        form: how the samples lie in it. A WAV header at its beginning says better.
        live: it comes as it is heard: what cannot be taken in time is dropped and told, and times are those of arrival.
            Else it waits and times are counts, as of a recording.
        realtime: of a recording: play it at its own speed; else as fast as the reader takes it.
        name: for messages.
        patience: s without sound after which a live source counts as deaf.
        on_report: is told what was lost, went away, came back or is too quiet to be heard; None: the log is.
        clock: None: the machine's.

    Raises:
        TypeError: ``file`` is none that gives bytes.
    """

    def __init__(
        self,
        file: BinaryIO,
        form: PcmFormat | None = None,
        *,
        live: bool = False,
        realtime: bool = False,
        name: str = "standard input",
        patience: float | None = 2.0,
        on_report: Reporter | None = None,
        clock: Clock | None = None,
    ) -> None:
        if isinstance(file, io.TextIOBase) or not hasattr(file, "read"):
            raise TypeError(f"raw samples are read from sys.stdin.buffer, or open(path, 'rb'), not from {file!r:.80}")
        # A reader of its own: Python takes that of sys.stdin down at its end, and aborts if a thread still reads it.
        own = sys.stdin is not None and file is getattr(sys.stdin, "buffer", None)
        self._file = os.fdopen(os.dup(file.fileno()), "rb") if own else file
        self._form = form or PcmFormat()
        self._live = live
        self._realtime = realtime
        self._name = name
        self._error: AudioError | None = None
        self._head: bytes | None = None
        self._left: float = np.inf
        self._cut = False
        """Whether it ended in the midst of a sound,"""
        self._missing = 0.0
        """and s of sound that should have come beside: at least, by its header, or because it failed."""
        self._inbox = Inbox(name, patience=patience, on_report=on_report, clock=clock)
        self._reader: threading.Thread | None = None
        self._since = 0.0
        """When reading began, by the machine's clock."""
        self._listened = threading.Event()
        """Set from when on what comes is heard."""
        self._early = 0.0
        """s of sound that came before."""
        self._kept: list[npt.NDArray[Any]] = []
        """That sound, as long as it may be a recording's."""
        self._recording = not live or _on_the_disk(self._file)
        self._deciding = threading.Lock()

    def check(self) -> None:
        """Wait for the first bytes, and see whether they may be sound; else this is seen in ``frames``. Of a live
        source, drop what comes from now on until ``begin``, if it is no recording.

        Raises:
            AudioError: it is empty, or no raw samples.
        """
        self._check()
        if self._live:
            self._read_on()

    def begin(self) -> None:
        """From now on it is listened to. ``frames`` does it too, if nobody did before."""
        with self._deciding:
            self._listened.set()
            if not self._recording:
                self._kept.clear()

    def _check(self) -> None:
        if self._head is not None:
            return
        try:
            head = _exactly(self._file, 12)
        except (OSError, ValueError) as error:
            raise AudioError(f"{self._name} cannot be read: {error}") from None
        if not head:
            raise AudioError(
                f"{self._name} is empty (0 bytes)\n    pipe sound into it: arecord -f S16_LE -r 16000 -t raw | ..."
            )
        for magic, what in OTHERS.items():
            if head.startswith(magic):
                raise AudioError(
                    f"{self._name} is a {what} file, not raw samples\n"
                    "    give the path of the file; or convert it: ffmpeg -i FILE -f s16le -ar 16000 -ac 1 -"
                )
        if head[:4] == b"RIFF" and head[8:12] == b"WAVE":
            self._form, self._left = _wav_header(self._file, self._name)
            head = b""
        self._head = head

    def frames(self) -> Iterator[Frame]:
        """Raises:
        AudioError: it is empty, or no raw samples; or it is live, and all of it came before it was listened to.
        """
        self.begin()
        self._read_on()
        recording = self._recording  # from here on it changes no more
        frames = self._inbox.frames(counted=recording)
        yield from self._paced(frames) if self._realtime or (self._live and recording) else frames
        if self._error is not None:
            raise self._error
        if self._early and not recording and not self._inbox.closed:
            raise AudioError(
                f"{self._name}: all of it ({self._early:.1f} s) came before it was listened to\n"
                "    say it again, once it says that it listens"
            )

    def _paced(self, frames: Iterator[Frame]) -> Iterator[Frame]:
        began = time.monotonic()
        for frame in frames:
            time.sleep(max(began + frame.time - time.monotonic(), 0.0))
            yield frame

    def close(self) -> None:
        self._inbox.close()

    def wake(self) -> None:
        self._inbox.wake()

    # -- the reading thread --------------------------------------------------------------------------

    def _read_on(self) -> None:
        """Let the thread read, if it does not yet."""
        if self._reader is None:
            self._since = time.monotonic()
            self._reader = threading.Thread(target=self._work, name="pcm", daemon=True)
            self._reader.start()

    def _work(self) -> None:
        try:
            self._read()
        except AudioError as error:
            self._error, self._missing = error, BLOCK_SECONDS
        except Exception as error:  # of the file, which is the caller's; ValueError: it was closed under it
            if not self._inbox.closed:
                self._missing = BLOCK_SECONDS
                self._error = AudioError(f"{self._name} cannot be read: {error}")
        finally:
            self._inbox.end(cut=self._cut, missing=self._missing)

    def _read(self) -> None:
        self._check()
        form, left, rest = self._form, self._left, self._head or b""
        size = max(1, int(form.rate * BLOCK_SECONDS)) * form.frame_bytes
        ending = Ending(form.rate)
        while True:
            data = self._some(int(min(size, left)))
            left -= len(data)
            rest += data
            whole = len(rest) - len(rest) % form.frame_bytes
            if whole:
                ending.take(sound := form.decode(rest[:whole]))
                hint = "write the integers as they are (--format s16le), or divide them by 32768"
                check_scale(sound, f"{self._name} holds", hint)
                if not self._bring(sound, form):
                    return
                rest = rest[whole:]
            if not data:
                self._cut = ending.abrupt
                self._missing = left / form.frame_bytes / form.rate if np.isfinite(left) else 0.0
                self._keep(np.zeros((0, form.channels)), form, ended=True)
                self._put_kept(form)
                return

    def _bring(self, sound: npt.NDArray[Any], form: PcmFormat) -> bool:
        """Put sound into the box, or drop it; False when nobody wants it any more."""
        if self._keep(sound, form):
            return not self._inbox.closed
        if not self._put_kept(form):
            return False
        early, self._early = (0.0 if self._recording else self._early), 0.0
        return self._inbox.put(sound, form.rate, early=early, wait=self._recording)

    def _keep(self, sound: npt.NDArray[Any], form: PcmFormat, *, ended: bool = False) -> bool:
        """Keep what comes before anybody listens, until it is known what it is; False: it is to be heard."""
        with self._deciding:
            if self._recording or self._listened.is_set():
                return False
            seconds = len(sound) / form.rate
            if ended or self._early + seconds > time.monotonic() - self._since + AHEAD:
                self._recording = True
                return False
            self._early += seconds
            self._kept.append(sound)
            return True

    def _put_kept(self, form: PcmFormat) -> bool:
        """Put what was kept of a recording into the box; it is taken when somebody listens."""
        kept = [*self._kept]
        self._kept.clear()
        return not kept or self._inbox.put(np.concatenate(kept), form.rate, wait=True)

    def _some(self, size: int) -> bytes:
        """What there is, at most ``size``; waits for one byte, not for all of them. Empty: the end."""
        if not size:
            return b""
        read = getattr(self._file, "read1", None) or self._file.read
        return bytes(read(size) or b"")


def _exactly(file: BinaryIO, size: int) -> bytes:
    """So many bytes, less only at the end."""
    data = b""
    while len(data) < size and (more := file.read(size - len(data))):
        data += more
    return data


def _wav_header(file: BinaryIO, name: str) -> tuple[PcmFormat, float]:
    """Read up to the first sample of a WAV file whose first 12 bytes were read: its format, and the bytes of sound."""
    form: PcmFormat | None = None
    while True:
        head = _exactly(file, 8)
        if len(head) < 8:
            raise AudioError(f"{name} is a WAV file without sound\n    record it again")
        kind, length = struct.unpack("<4sI", head)
        if kind == b"data":
            break
        if length > MAX_HEADER:
            raise AudioError(f"{name} begins like a WAV file, but its header is broken\n    record it again")
        chunk = _exactly(file, length + length % 2)
        if kind == b"fmt " and len(chunk) >= 16:
            code, channels, rate, _, _, bits = struct.unpack_from("<HHIIHH", chunk)
            if code == 0xFFFE and len(chunk) >= 26:  # WAVE_FORMAT_EXTENSIBLE: the code stands further on
                (code,) = struct.unpack_from("<H", chunk, 24)
            letter = {1: "u" if bits == 8 else "s", 3: "f"}.get(code, "?")
            form = PcmFormat(rate, f"{letter}{bits}{'' if bits == 8 else 'le'}", channels)
    if form is None:
        raise AudioError(f"{name} is a WAV file that does not say its format\n    record it again")
    return form, length if 0 < length < UNKNOWN else np.inf
