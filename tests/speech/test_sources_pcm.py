"""Raw samples from a pipe: formats, headers, what is no PCM, an end in the middle of a sample."""

from __future__ import annotations

import io
import os
import queue
import struct
import threading

import numpy as np
import pytest
import soundfile
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import AudioError
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, ReportKind
from intent_engine.speech.sources import pcm
from intent_engine.speech.sources.pcm import FORMATS, PcmFormat, PcmSource

SOUND = 0.5 * np.sin(2 * np.pi * 440 * np.arange(SAMPLE_RATE) / SAMPLE_RATE)


def encoded(samples: np.ndarray, encoding: str) -> bytes:
    dtype, size = FORMATS[encoding]
    if size == 3:
        return (np.round(samples * 2**23).astype("<i4").view(np.uint8).reshape(-1, 4)[:, :3]).tobytes()
    if "f" in dtype:
        return samples.astype(dtype).tobytes()
    half = 2 ** (8 * size - 1)
    return np.round(samples * (half - 1) + (half if "u" in dtype else 0)).astype(dtype).tobytes()


def heard(data: bytes, form: PcmFormat | None = None) -> np.ndarray:
    frames = list(PcmSource(io.BytesIO(data), form).frames())
    assert [frame.time for frame in frames] == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(len(frames))])
    return np.concatenate([frame.samples for frame in frames]) if frames else np.zeros(0)


def cuts(data: bytes, form: PcmFormat | None = None) -> tuple[list[float], list[float]]:
    """When the sound was cut, and how much of it was missing."""
    frames = list(PcmSource(io.BytesIO(data), form).frames())
    return [frame.time for frame in frames if frame.cut], [frame.lost for frame in frames if frame.lost]


@pytest.mark.parametrize("encoding", FORMATS)
def test_an_end_in_the_midst_of_a_sound_is_told(encoding):
    form = PcmFormat(encoding=encoding)
    (when,), lost = cuts(encoded(SOUND, encoding), form)
    assert when == pytest.approx(1.0, abs=FRAME_SECONDS)
    assert lost == []
    faded = SOUND * np.linspace(1.0, 0.0, SOUND.size)
    assert cuts(encoded(faded, encoding), form) == ([], [])


def test_sound_that_a_wav_header_promised_is_missing():
    sound = encoded(SOUND * np.linspace(1.0, 0.0, SOUND.size), "s16le")
    head = struct.pack(
        "<4sI4s4sIHHIIHH4sI", b"RIFF", 36, b"WAVE", b"fmt ", 16, 1, 1, SAMPLE_RATE, 32_000, 2, 16, b"data", 64_000
    )
    assert cuts(head + sound) == ([], [pytest.approx(1.0)])
    assert cuts(head[:-4] + struct.pack("<I", len(sound)) + sound) == ([], [])
    assert cuts(head[:-4] + b"\xff" * 4 + sound) == ([], [])


def test_silence_and_a_moment_of_sound_are_not_cut():
    assert cuts(bytes(32_000)) == ([], [])
    assert cuts(encoded(SOUND[:300], "s16le")) == ([], [])


@pytest.mark.parametrize("encoding", FORMATS)
def test_every_format(encoding):
    sound = heard(encoded(SOUND, encoding), PcmFormat(encoding=encoding))
    assert sound[: SOUND.size] == pytest.approx(SOUND, abs=0.01)
    assert not np.abs(sound[SOUND.size :]).max() > 0.01


@pytest.mark.parametrize("name", ["S16_LE", "s16le", "s16", "S16LE"])
def test_spellings_of_alsa_and_ffmpeg(name):
    assert PcmFormat(encoding=name).encoding == "s16le"


def test_stereo_at_another_rate():
    rate = 44_100
    sound = 0.5 * np.sin(2 * np.pi * 440 * np.arange(rate * 2) / rate)
    data = encoded(np.stack([sound, sound], axis=1).reshape(-1), "f32le")
    found = heard(data, PcmFormat(rate, "f32le", 2))[: 2 * SAMPLE_RATE]
    assert np.argmax(np.abs(np.fft.rfft(found))) / 2 == pytest.approx(440, abs=1)


@pytest.mark.parametrize("cut", [1, 2, 3, 5, 1_001])
def test_an_end_in_the_middle_of_a_sample(cut):
    data = encoded(np.stack([SOUND, SOUND], axis=1).reshape(-1), "s16le")[:-cut]
    assert heard(data, PcmFormat(channels=2))[: SOUND.size - 600] == pytest.approx(SOUND[:-600], abs=0.01)


@pytest.mark.parametrize(
    ("rate", "channels", "subtype"), [(48_000, 2, "PCM_24"), (8_000, 1, "PCM_U8"), (16_000, 1, "FLOAT")]
)
def test_a_wav_header_says_better(tmp_path, rate, channels, subtype):
    sound = 0.5 * np.sin(2 * np.pi * 440 * np.arange(rate) / rate)
    soundfile.write(tmp_path / "tone.wav", np.stack([sound] * channels, axis=1), rate, subtype=subtype)
    found = heard((tmp_path / "tone.wav").read_bytes())
    assert found.size == pytest.approx(1.8 * SAMPLE_RATE, abs=1_100)
    assert np.argmax(np.abs(np.fft.rfft(found[:SAMPLE_RATE]))) == pytest.approx(440, abs=1)


@pytest.mark.parametrize(
    ("name", "encoding"),
    [
        ("S16_LE", "s16le"),
        ("S16", "s16le"),
        ("U8", "u8"),
        ("S24_3LE", "s24le"),
        ("S32_BE", "s32be"),
        ("FLOAT_LE", "f32le"),
        ("FLOAT64_BE", "f64be"),
        ("flt", "f32le"),
    ],
)
def test_a_format_by_the_name_of_alsa(name, encoding):
    assert PcmFormat(16_000.0, name, np.int64(1)) == PcmFormat(encoding=encoding)
    assert heard(encoded(SOUND, encoding), PcmFormat(encoding=name))[: SOUND.size] == pytest.approx(SOUND, abs=0.01)


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"encoding": "S24_LE"}, "24 bits that lie in 32.*\n.*S24_3LE"),
        ({"encoding": "mp3"}, "mp3 is no format"),
        ({"encoding": None}, "None is no format"),
        ({"channels": 0}, "0 channels cannot be"),
        ({"channels": 1.5}, "1.5 channels cannot be"),
        ({"rate": 0}, "0 Hz is no sample rate"),
    ],
)
def test_what_is_no_format_is_told_when_it_is_made(wrong, told):
    with pytest.raises(AudioError, match=told):
        PcmFormat(**wrong)


@pytest.mark.parametrize("file", [io.StringIO("text"), "talk.raw", None])
def test_what_gives_no_bytes_is_told_when_it_is_given(file):
    with pytest.raises(TypeError, match=r"read from sys.stdin.buffer, or open\(path, 'rb'\)"):
        PcmSource(file)


def test_standard_input_is_read_by_a_reader_of_its_own(monkeypatch):
    """A process that ends while a thread waits in that of ``sys.stdin`` is aborted."""
    get, put = os.pipe()
    with open(get) as stdin, os.fdopen(put, "wb") as talk:  # noqa: PTH123 - of a descriptor
        monkeypatch.setattr("sys.stdin", stdin)
        source = PcmSource(stdin.buffer, live=True)
        talk.write(encoded(SOUND, "s16le"))
        talk.flush()
        source.check()
        assert stdin.buffer.raw.readable(), "it is left open"
        assert source._file is not stdin.buffer
        source.close()


def test_a_streamed_wav_whose_length_nobody_knew():
    head = b"RIFF\xff\xff\xff\xffWAVEfmt " + struct.pack("<IHHIIHH", 16, 1, 1, 16_000, 32_000, 2, 16)
    sound = heard(head + b"LIST\x04\x00\x00\x00INFOdata\xff\xff\xff\xff" + encoded(SOUND, "s16le"))
    assert sound[: SOUND.size] == pytest.approx(SOUND, abs=0.01)


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "standard input is empty"),
        (b"fLaC" + bytes(100), "is a FLAC file, not raw samples"),
        (b"OggS" + bytes(100), "is a Ogg file, not raw samples"),
        (b"ID3\x04" + bytes(100), "is a MP3 file, not raw samples"),
        (b"RIFF\x00\x00\x00\x00WAVEdata\x00\x00\x00\x00" + bytes(100), "does not say its format"),
        (b"RIFF\x00\x00\x00\x00WAVEfmt ", "without sound"),
        (b"RIFF\x00\x00\x00\x00WAVE" + b"\xff" * 100, "its header is broken"),
        (
            b"RIFF\x00\x00\x00\x00WAVEfmt " + struct.pack("<IHHIIHH", 16, 85, 1, 16_000, 0, 0, 16) + b"data\0\0\0\0",
            "?16le is no format",
        ),
    ],
)
def test_what_is_no_pcm(data, says):
    with pytest.raises(AudioError) as caught:
        heard(data)
    assert says in str(caught.value)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"encoding": "mp3"}, "mp3 is no format of raw samples\n    there is u8"),
        ({"rate": 0}, "0 Hz is no sample rate"),
        ({"channels": 0}, "0 channels"),
    ],
)
def test_formats_that_there_are_not(options, says):
    with pytest.raises(AudioError) as caught:
        PcmFormat(**options)
    assert says in str(caught.value)


@pytest.mark.parametrize("data", [os.urandom(1), b"\x00\x01", os.urandom(511)], ids=["1", "2", "511"])
def test_less_than_a_frame(data):
    assert heard(data).size in (0, *range(12_800, 13_824))


def test_a_pipe_that_is_closed_under_way():
    reading, writing = os.pipe()
    with os.fdopen(reading, "rb") as file, os.fdopen(writing, "wb", buffering=0) as pipe:
        source = PcmSource(file, live=True)
        ready = threading.Event()

        def write() -> None:
            pipe.write(encoded(SOUND, "s16le"))
            ready.wait(10)

        thread = threading.Thread(target=write)
        thread.start()
        count = 0
        for _ in source.frames():
            count += 1
            if count == 10:
                source.close()
        ready.set()
        thread.join()
        pipe.close()
    assert count == 10


class Piped:
    """A pipe whose writer knows when all that it wrote was taken and what it is was decided."""

    def __init__(self) -> None:
        self._written: queue.SimpleQueue[bytes] = queue.SimpleQueue()
        self._asked = threading.Semaphore(0)

    def write(self, data: bytes) -> None:
        self.settle()
        self._asked.acquire()
        self._written.put(data)

    def settle(self) -> None:
        """Wait until it is read again."""
        assert self._asked.acquire(timeout=30)
        self._asked.release()

    def read(self, size: int) -> bytes:
        """The first bytes are all that there is in the pipe."""
        return bytes(size)

    def read1(self, size: int) -> bytes:
        self._asked.release()
        return self._written.get()


@given(early=st.lists(st.integers(1, 3_000), min_size=1, max_size=4), late=st.lists(st.integers(1, 3_000), max_size=4))
def test_what_comes_before_a_live_pipe_is_listened_to_is_dropped_and_told(early, late):
    pipe, reports = Piped(), []
    source = PcmSource(pipe, live=True, on_report=reports.append)
    source.check()
    for count in early:
        pipe.write(encoded(np.full(count, 0.9), "s16le"))
    pipe.settle()
    source.begin()
    for count in late:
        pipe.write(encoded(np.full(count, -0.5), "s16le"))
    pipe.write(b"")
    if not late:
        with pytest.raises(AudioError, match="came before it was listened to"):
            list(source.frames())
        return
    frames = list(source.frames())
    sound = np.concatenate([frame.samples for frame in frames])
    assert sound.max() <= 0.01
    assert np.count_nonzero(sound < -0.4) == sum(late)
    dropped = (sum(early) + 6) / SAMPLE_RATE
    assert frames[0].lost == pytest.approx(dropped), "what was being said may have begun before"
    assert not any(frame.lost for frame in frames[1:])
    assert [report.kind for report in reports] == [ReportKind.EARLY]
    assert f"{dropped:.1f} s of sound from standard input came before" in reports[0].detail
    times = [frame.time for frame in frames]
    assert times == sorted(times)


def test_a_pipe_that_nobody_checked_is_heard_from_its_first_sample():
    source = PcmSource(io.BytesIO(encoded(SOUND, "s16le")), live=True)
    frames = list(source.frames())
    assert not any(frame.lost for frame in frames)
    assert np.concatenate([frame.samples for frame in frames])[: SOUND.size] == pytest.approx(SOUND, abs=0.01)


def test_a_live_pipe_that_is_closed_before_it_is_listened_to_is_read_no_more():
    pipe = Piped()
    source = PcmSource(pipe, live=True)
    source.check()
    source.close()
    pipe.write(bytes(2_000))
    assert source._reader is not None
    source._reader.join(30)
    assert not source._reader.is_alive()
    assert list(source.frames()) == []


def test_a_live_pipe_that_has_ended_is_a_recording_and_heard_whole(monkeypatch):
    monkeypatch.setattr(pcm.time, "sleep", lambda _seconds: None)
    before = set(threading.enumerate())
    source = PcmSource(io.BytesIO(encoded(np.full(8_000, 0.5), "s16le")), live=True)
    source.check()
    for reader in set(threading.enumerate()) - before:
        reader.join()
    assert loud(source) == pytest.approx(8_000, abs=2)


def test_so_is_one_that_is_ahead_of_time(monkeypatch):
    monkeypatch.setattr(pcm.time, "sleep", lambda _seconds: None)
    count = int((pcm.AHEAD + 3.0) * SAMPLE_RATE)
    pipe = Piped()
    source = PcmSource(pipe, live=True)
    source.check()
    pipe.write(encoded(np.full(count, 0.5), "s16le"))
    pipe.settle()
    source.begin()
    pipe.write(b"")
    assert loud(source) == pytest.approx(count, abs=2)


def test_so_is_a_file_on_the_disk_however_slowly_it_is_read(monkeypatch, tmp_path):
    """Nobody is to hear the end of it alone because a busy machine was in the midst of it when it began to listen."""
    monkeypatch.setattr(pcm.time, "sleep", lambda _seconds: None)
    file = tmp_path / "x.raw"
    file.write_bytes(encoded(np.full(32_000, 0.5), "s16le"))
    in_the_midst, listening = threading.Event(), threading.Event()

    class Slow(io.FileIO):
        asked = 0

        def read(self, size: int = -1, /) -> bytes:
            Slow.asked += 1
            if Slow.asked == 5:
                in_the_midst.set()
                listening.wait(10)
            return super().read(size)

    with Slow(file) as slow:
        source = PcmSource(slow, live=True)
        source.check()
        assert in_the_midst.wait(10)
        source.begin()
        listening.set()
        assert loud(source) == pytest.approx(32_000, abs=2)


def loud(source: PcmSource) -> int:
    """How many samples of it are sound."""
    sound = np.concatenate([frame.samples for frame in source.frames()])
    return int(np.count_nonzero(sound > 0.4))


def test_integers_that_are_called_floats_are_refused():
    data = np.round(SOUND * 32_768).astype("<f4").tobytes()
    with pytest.raises(AudioError, match=r"the pipe holds floats that are whole numbers.*\n.*--format s16le"):
        list(PcmSource(io.BytesIO(data), PcmFormat(encoding="f32le"), name="the pipe").frames())


def test_integers_that_were_resampled_are_refused():
    data = (SOUND * 32_767.3).astype("<f4").tobytes()
    with pytest.raises(AudioError, match=r"the pipe holds floats up to \d+, .*\n.*--format s16le"):
        list(PcmSource(io.BytesIO(data), PcmFormat(encoding="f32le"), name="the pipe").frames())


def test_integers_of_16_bits_in_32_are_told():
    reports = []
    data = np.round(SOUND * 32_767).astype("<i4").tobytes()
    form = PcmFormat(encoding="s32le")
    list(PcmSource(io.BytesIO(data), form, name="the pipe", on_report=reports.append).frames())
    assert [report.kind for report in reports] == [ReportKind.MUTE]
    assert "the pipe gives next to nothing" in reports[0].detail
    assert "s16le" in reports[0].detail


class Broken(io.RawIOBase):
    """A pipe that fails after some sound, which had faded: a pause, maybe, in a sentence."""

    def __init__(self, data: bytes) -> None:
        self._data = io.BytesIO(data)

    def read(self, size: int = -1) -> bytes:
        data = self._data.read(size)
        if not data:
            raise OSError("the line is dead")
        return data


def test_a_pipe_that_fails_has_lost_sound_before_it_is_told():
    """What was being said may be half of it, and must not be acted on in the moment before the error."""
    source = PcmSource(Broken(np.round(SOUND * 32_767 * np.linspace(1, 0, SOUND.size) ** 4).astype("<i2").tobytes()))
    frames = []
    with pytest.raises(AudioError, match="cannot be read: the line is dead"):
        frames.extend(source.frames())
    assert [frame.lost > 0 for frame in frames].count(True) == 1
    assert not any(frame.samples[-1] for frame in frames if frame.lost), "at the end"


class _Odd(io.RawIOBase):
    """Fails as no file does."""

    def read(self, size: int = -1) -> bytes:
        raise RuntimeError("the decoder is lost")


def test_a_file_that_fails_as_no_file_does_is_told_and_does_not_just_end():
    with pytest.raises(AudioError, match="the pipe cannot be read: the decoder is lost"):
        list(PcmSource(_Odd(), name="the pipe").frames())
