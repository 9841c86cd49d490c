"""Whether a recording is whole. A robot must not do the first half of a file whose second half is missing.

libsndfile reads a WAV, AIFF, AU or Ogg file that was cut off as a shorter one, without a word, and notices a cut FLAC
file only when it comes to the cut; so all are looked at before the first frame is played. An MP3 file tells its length
only if its encoder has put that into its first frame, as most do.
"""

from __future__ import annotations

import struct
from pathlib import Path

from intent_engine.errors import AudioError

__all__ = ["ENDLESS", "UNKNOWN", "check_mp3", "check_whole"]

UNKNOWN = 0x7FFF0000
"""Sizes from here on are written into a header by programs that stream and do not know yet: SoX, arecord, ffmpeg."""
ENDLESS = 1 << 62
"""Bytes or samples from which on a size of 64 bits is none either."""
OGG_PAGE = 65_307
"""Bytes of the largest page of an Ogg file."""
BLOCK = 1 << 14
"""Samples read at once: so exactly it is known where a file breaks off."""
XING = 4 + 32 + 120
"""Bytes of an MPEG frame in which the length stands, if it does."""
_ADVICE = "copy or record it again"


def check_whole(path: Path) -> None:
    """Read a sound file through, as fast as it decodes (an hour of FLAC takes about a second).

    Raises:
        AudioError: the file ends before its header says it does, or cannot be decoded to its end.
    """
    with path.open("rb") as file:
        head = file.read(28)
    if head[:4] == b"RIFF" and head[8:12] == b"WAVE":
        _check_chunks(path, head, "<", b"data")
    elif head[:4] == b"FORM" and head[8:12] in (b"AIFF", b"AIFC"):
        _check_chunks(path, head, ">", b"SSND")
    elif head[:4] == b".snd" and len(head) >= 12:
        begin, length = struct.unpack_from(">II", head, 4)
        _check_size(path, begin + length if _known(length) else 0)
    elif head[:4] == b"RF64" and head[12:16] == b"ds64" and len(head) == 28:
        _check_size(path, 8 + struct.unpack_from("<Q", head, 20)[0])
    elif head[:4] == b"riff" and len(head) >= 24:  # Sony Wave64
        _check_size(path, struct.unpack_from("<Q", head, 16)[0])
    elif head[:4] == b"OggS":
        _check_ogg(path)
    elif head[:4] == b"fLaC":
        _decode(path)


def check_mp3(path: Path) -> None:
    """Look at an MP3 file before libsndfile does, which writes its own complaints about a cut one to standard error.

    Raises:
        AudioError: it ends before its first frame says it does.
    """
    with path.open("rb") as file:
        tag = file.read(10)
        begin = 0
        if tag[:3] == b"ID3" and len(tag) == 10:
            begin = 10 + sum((byte & 0x7F) << shift for byte, shift in zip(tag[6:], (21, 14, 7, 0), strict=True))
        file.seek(begin)
        frame = file.read(XING)
    place = max(frame.find(b"Xing", 0, 40), frame.find(b"Info", 0, 40))
    if frame[:1] != b"\xff" or place < 0 or len(frame) < place + 16 or not frame[place + 7] & 2:
        return
    (declared,) = struct.unpack_from(">I", frame, place + 8 + 4 * (frame[place + 7] & 1))
    _check_size(path, begin + declared)


def _known(size: int) -> bool:
    return 0 < size < UNKNOWN


def _check_size(path: Path, declared: int) -> None:
    """Bytes of a whole file against those that are there."""
    there = path.stat().st_size
    if there < declared < ENDLESS:
        raise AudioError(f"{path}: is cut off: {there / declared:.0%} of it is there\n    {_ADVICE}")


def _check_chunks(path: Path, head: bytes, order: str, sound: bytes) -> None:
    """The sizes of the chunks against the size of the file; these samples need no decoding.

    Args:
        path: the file.
        head: its first 12 bytes.
        order: of the bytes of a number, as ``struct`` has it.
        sound: name of the chunk with the sound.
    """
    size = path.stat().st_size
    (declared,) = struct.unpack_from(f"{order}I", head, 4)
    if not _known(declared):
        return
    with path.open("rb") as file:
        place = 12
        while place + 8 <= size:
            file.seek(place)
            name, length = struct.unpack(f"{order}4sI", file.read(8))
            if name == sound:
                if _known(length) and place + 8 + length > size:
                    there = (size - place - 8) / length
                    raise AudioError(f"{path}: is cut off: {there:.0%} of its sound is there\n    {_ADVICE}")
                return
            place += 8 + length + length % 2


def _check_ogg(path: Path) -> None:
    """The last page of an Ogg file says that it is the last, and is there to its end (RFC 3533)."""
    size = path.stat().st_size
    with path.open("rb") as file:
        file.seek(max(0, size - OGG_PAGE))
        tail = file.read()
    place = tail.rfind(b"OggS")
    page = tail[place:]
    whole = place >= 0 and len(page) >= 27 and len(page) >= 27 + page[26]
    if not whole or not page[5] & 4 or len(page) < 27 + page[26] + sum(page[27 : 27 + page[26]]):
        raise AudioError(f"{path}: is cut off: the end of its sound is not there\n    {_ADVICE}")


def _decode(path: Path) -> None:
    import soundfile

    read, rate = 0, 1
    try:
        with soundfile.SoundFile(str(path)) as file:
            rate, expected = file.samplerate, file.frames
            while count := len(file.read(BLOCK, dtype="int16")):
                read += count
    except (soundfile.LibsndfileError, RuntimeError, OSError):
        raise AudioError(
            f"{path}: breaks off: it cannot be read beyond about {read / rate:.0f} s\n    {_ADVICE}"
        ) from None
    if read < expected:
        raise AudioError(f"{path}: is cut off: {read / rate:.1f} s of {expected / rate:.1f} s are there\n    {_ADVICE}")
