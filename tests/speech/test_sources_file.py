"""Sound files: whole or not at all, streamed, at any rate. What people are told of bad ones: tests/cli."""

from __future__ import annotations

import os
import struct
import tracemalloc

import numpy as np
import pytest
import soundfile
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.errors import AudioError
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE
from intent_engine.speech.sources.file import TAIL_SECONDS, FileSource, _libsndfile
from intent_engine.speech.sources.pcm import FORMATS, PcmFormat

TONE = (0.5 * np.sin(2 * np.pi * 440 * np.arange(SAMPLE_RATE) / SAMPLE_RATE)).astype(np.float32)


@pytest.mark.parametrize(
    ("name", "rate", "subtype"),
    [
        ("a.wav", 8_000, "ULAW"),
        ("a.wav", 44_100, "PCM_24"),
        ("a.wav", 96_000, "DOUBLE"),
        ("a.flac", 22_050, "PCM_16"),
        ("a.ogg", 48_000, "VORBIS"),
        ("a.aiff", 16_000, "PCM_16"),
    ],
)
def test_every_kind_of_file(tmp_path, name, rate, subtype):
    samples = 0.5 * np.sin(2 * np.pi * 440 * np.arange(2 * rate) / rate)
    soundfile.write(tmp_path / name, np.stack([samples, samples], axis=1), rate, subtype=subtype)
    source = FileSource(tmp_path / name)
    assert source.seconds == pytest.approx(2.0)
    frames = list(source.frames())
    assert [frame.time for frame in frames] == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(len(frames))])
    assert frames[-1].time == pytest.approx(2.0 + TAIL_SECONDS, abs=2 * FRAME_SECONDS)
    sound = np.concatenate([frame.samples for frame in frames])
    assert np.argmax(np.abs(np.fft.rfft(sound[:SAMPLE_RATE]))) == pytest.approx(440, abs=1)
    assert list(FileSource(tmp_path / name).frames())[7].samples == pytest.approx(frames[7].samples), "read again alike"


@settings(deadline=None, max_examples=40)
@given(st.data())
@pytest.mark.parametrize(
    "name", ["cut.wav", "cut.flac", "cut.aiff", "cut.ogg", "cut.mp3", "cut.au", "cut.rf64", "cut.w64"]
)
def test_a_file_cut_anywhere_is_not_played_at_all(tmp_path_factory, name, data):
    folder = tmp_path_factory.mktemp("cut")
    soundfile.write(folder / name, TONE, SAMPLE_RATE)
    whole = (folder / name).read_bytes()
    length = data.draw(st.integers(0, len(whole) - 1))
    (folder / name).write_bytes(whole[:length])
    with pytest.raises(AudioError, match=name):
        FileSource(folder / name)


@pytest.mark.parametrize("tag", [b"", b"ID3\x04\x00\x00\x00\x00\x01\x00" + bytes(128)], ids=["bare", "tagged"])
def test_an_mp3_file_of_which_a_byte_is_missing(tmp_path, tag):
    soundfile.write(tmp_path / "a.mp3", TONE, SAMPLE_RATE)
    whole = tag + (tmp_path / "a.mp3").read_bytes()
    (tmp_path / "whole.mp3").write_bytes(whole)
    assert FileSource(tmp_path / "whole.mp3").seconds == pytest.approx(1.0)
    (tmp_path / "cut.mp3").write_bytes(whole[:-1])
    with pytest.raises(AudioError, match=r"cut\.mp3: is cut off: 100% of it is there"):
        FileSource(tmp_path / "cut.mp3")


def test_an_mp3_file_that_does_not_tell_its_length(tmp_path):
    """libsndfile guesses it from the first frame, and is wrong where the frames are of several sizes."""
    noise = np.random.default_rng(1).normal(0, 0.2, SAMPLE_RATE)
    quiet, longer = np.zeros(3_000), np.zeros(3 * SAMPLE_RATE)
    soundfile.write(tmp_path / "a.mp3", np.concatenate((quiet, noise, longer)), SAMPLE_RATE)
    whole = (tmp_path / "a.mp3").read_bytes()
    (tmp_path / "b.mp3").write_bytes(whole[whole.index(whole[:2], 4) :])
    source = FileSource(tmp_path / "b.mp3")
    *_, last = source.frames()
    assert source.seconds > 7
    assert last.time == pytest.approx(4.2 + TAIL_SECONDS, abs=0.2)


@settings(deadline=None, max_examples=60)
@given(st.binary(max_size=300))
def test_bytes_that_are_no_sound_never_raise_anything_else(tmp_path_factory, data):
    path = tmp_path_factory.mktemp("bytes") / "odd.wav"
    path.write_bytes(data)
    with pytest.raises(AudioError):
        list(FileSource(path).frames())


@settings(deadline=None, max_examples=40)
@given(st.lists(st.tuples(st.integers(0, 43), st.integers(0, 255)), min_size=1, max_size=4))
def test_a_broken_header_never_raises_anything_else(tmp_path_factory, changes):
    path = tmp_path_factory.mktemp("header") / "odd.wav"
    soundfile.write(path, TONE[:4_000], SAMPLE_RATE)
    data = bytearray(path.read_bytes())
    for place, value in changes:
        data[place] = value
    path.write_bytes(data)
    try:
        frames = list(FileSource(path).frames())
    except AudioError:
        return
    assert all(np.isfinite(frame.samples).all() for frame in frames)


def test_chunks_before_and_after_the_sound_are_no_cut(tmp_path):
    data = (TONE * 32_767).astype("<i2").tobytes()
    chunks = b"fmt " + struct.pack("<IHHIIHH", 16, 1, 1, SAMPLE_RATE, 2 * SAMPLE_RATE, 2, 16)
    chunks += b"LIST" + struct.pack("<I", 5) + b"INFOx\0" + b"data" + struct.pack("<I", len(data)) + data
    chunks += b"id3 " + struct.pack("<I", 4) + b"name"
    (tmp_path / "a.wav").write_bytes(b"RIFF" + struct.pack("<I", 4 + len(chunks)) + b"WAVE" + chunks)
    assert FileSource(tmp_path / "a.wav").seconds == pytest.approx(1.0)


@pytest.mark.parametrize("size", [0x7FFF_F000, 0x7FFF_FF00, 0x8000_0000, 0xFFFF_FFFF], ids=hex)
def test_a_wav_file_that_was_written_into_a_pipe_is_whole(tmp_path, size):
    """SoX, arecord and ffmpeg have not known its length: ``arecord -t wav | tee talk.wav``."""
    data = (TONE * 32_767).astype("<i2").tobytes()
    head = b"RIFF" + struct.pack("<I", min(size + 36, 0xFFFF_FFFF)) + b"WAVE"
    head += b"fmt " + struct.pack("<IHHIIHH", 16, 1, 1, SAMPLE_RATE, 2 * SAMPLE_RATE, 2, 16)
    (tmp_path / "a.wav").write_bytes(head + b"data" + struct.pack("<I", size) + data)
    source = FileSource(tmp_path / "a.wav")
    assert source.seconds == pytest.approx(1.0)
    assert sum(1 for _ in source.frames()) * FRAME_SECONDS == pytest.approx(1.8, abs=FRAME_SECONDS)


def test_a_flac_file_that_does_not_know_its_length_says_so(tmp_path):
    soundfile.write(tmp_path / "a.flac", TONE, SAMPLE_RATE)
    data = bytearray((tmp_path / "a.flac").read_bytes())
    data[21] &= 0xF0  # the upper bits of the number of samples
    data[22:26] = bytes(4)
    (tmp_path / "a.flac").write_bytes(data)
    with pytest.raises(AudioError, match=r"does not say how long it is.*pipe\n    convert it: ffmpeg -i a.flac"):
        FileSource(tmp_path / "a.flac")


def test_an_hour_takes_the_room_of_a_moment(tmp_path):
    """Sparse, so that the disk does not take it either."""
    size = 3600 * SAMPLE_RATE * 2
    head = b"RIFF" + struct.pack("<I", 36 + size) + b"WAVE"
    head += b"fmt " + struct.pack("<IHHIIHH", 16, 1, 1, SAMPLE_RATE, 2 * SAMPLE_RATE, 2, 16)
    with (tmp_path / "hour.wav").open("wb") as file:
        file.write(head + b"data" + struct.pack("<I", size))
        file.truncate(44 + size)
    tracemalloc.start()
    try:
        count = sum(1 for _ in FileSource(tmp_path / "hour.wav").frames())
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert count == pytest.approx((3600 + TAIL_SECONDS) / FRAME_SECONDS, abs=2)
    assert peak < 4_000_000, "an hour of float samples would be 230 MB"


def test_a_name_too_long_for_a_file_is_told_as_any_that_cannot_be_read():
    with pytest.raises(AudioError, match=r"cannot be read: file name too long|no such file"):
        FileSource(300 * "x" + ".wav")


@pytest.mark.parametrize("name", ["a.raw", "a.PCM", "a.s16le"])
@pytest.mark.parametrize(
    ("form", "dtype"),
    [
        (PcmFormat(), "<i2"),
        (PcmFormat(8_000, "s16be", 2), ">i2"),
        (PcmFormat(48_000, "f32le"), "<f4"),
        (PcmFormat(22_050, "f64be"), ">f8"),
        (PcmFormat(16_000, "u8"), "u1"),
        (PcmFormat(16_000, "s32le"), "<i4"),
    ],
)
def test_raw_samples(tmp_path, name, form, dtype):
    samples = 0.5 * np.sin(2 * np.pi * 440 * np.arange(form.rate) / form.rate)
    kind = np.dtype(dtype)
    if kind.kind != "f":
        samples = samples * (2 ** (8 * kind.itemsize - 1) - 1) + 128 * (kind.kind == "u")
    (tmp_path / name).write_bytes(np.repeat(samples.astype(kind), form.channels).tobytes())
    source = FileSource(tmp_path / name, form=form)
    assert (source.seconds, source.rate) == (1.0, form.rate)
    heard = np.concatenate([frame.samples for frame in source.frames()])[:SAMPLE_RATE]
    assert np.sqrt(np.mean(heard**2)) == pytest.approx(0.5 / np.sqrt(2), rel=0.02)


def test_every_format_of_raw_samples_is_one_of_the_library():
    for name in FORMATS:
        form = _libsndfile(PcmFormat(encoding=name))
        assert soundfile.check_format("RAW", form["subtype"], form["endian"])


def test_raw_samples_of_which_nothing_is_known(tmp_path):
    (tmp_path / "a.raw").write_bytes(bytes(32_000))
    with pytest.raises(AudioError, match=r"raw samples(.|\n)*--rate 16000 --format s16le, or pipe it in: .*run - < "):
        FileSource(tmp_path / "a.raw")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes; CI is Linux, and runs it")
def test_a_pipe_is_no_file(tmp_path):
    os.mkfifo(tmp_path / "pipe.wav")
    with pytest.raises(AudioError, match=r"is a pipe or a device(.|\n)*intent-engine run - <"):
        FileSource(tmp_path / "pipe.wav")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read every file")
def test_a_file_without_permission(tmp_path):
    soundfile.write(tmp_path / "a.wav", TONE, SAMPLE_RATE)
    (tmp_path / "a.wav").chmod(0)
    with pytest.raises(AudioError, match="cannot be read: permission denied"):
        FileSource(tmp_path / "a.wav")


def test_close_ends_it(tmp_path):
    soundfile.write(tmp_path / "a.wav", TONE, SAMPLE_RATE)
    source = FileSource(tmp_path / "a.wav")
    frames = source.frames()
    next(frames)
    source.close()
    source.close()
    assert list(frames) == []


@pytest.mark.parametrize("subtype", ["FLOAT", "DOUBLE"])
def test_integers_that_are_called_floats_are_refused(tmp_path, subtype):
    path = tmp_path / "array.wav"
    tone = np.round(8_000 * np.sin(np.arange(80_000) / 5))
    tone[:40_000] = 0.0
    soundfile.write(path, tone, 16_000, subtype=subtype)
    with pytest.raises(AudioError, match=r"array.wav: holds floats that are whole numbers.*\n.*divide them by 32768"):
        FileSource(path)
    soundfile.write(path, tone / 32_768, 16_000, subtype=subtype)
    assert FileSource(path).seconds == 5.0


def test_integers_that_were_resampled_are_refused(tmp_path):
    path = tmp_path / "array.wav"
    soundfile.write(path, 8_000.5 * np.sin(np.arange(80_000) / 5), 16_000, subtype="FLOAT")
    with pytest.raises(AudioError, match=r"array.wav: holds floats up to 800\d, .*\n.*divide them by 32768"):
        FileSource(path)


def test_integers_of_16_bits_in_32_are_refused(tmp_path):
    path = tmp_path / "array.wav"
    tone = np.round(8_000 * np.sin(np.arange(80_000) / 5))
    tone[:40_000] = 0.0
    soundfile.write(path, tone / 2**31, 16_000, subtype="PCM_32")
    with pytest.raises(AudioError, match=r"array.wav: holds 16-bit samples in 32 bits.*silence\n.*astype\(np.int16\)"):
        FileSource(path)
    soundfile.write(path, tone / 32_768, 16_000, subtype="PCM_32")
    assert FileSource(path).seconds == 5.0
