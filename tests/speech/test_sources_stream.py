"""Sound that a program pushes: shapes, types and rates; too fast, too slow, from another thread."""

from __future__ import annotations

import itertools
import threading

import numpy as np
import pytest
from fake_portaudio import FakeTime

from intent_engine.errors import AudioError
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, ReportKind
from intent_engine.speech.sources.stream import StreamSource


@pytest.fixture
def time():
    return FakeTime()


def pushed(source: StreamSource, *blocks: np.ndarray) -> list:
    """All frames of a recording that is pushed from another thread."""

    def work() -> None:
        for block in blocks:
            source.push(block)
        source.end()

    thread = threading.Thread(target=work)
    thread.start()
    frames = list(source.frames())
    thread.join()
    return frames


def sound_of(frames) -> np.ndarray:
    return np.concatenate([frame.samples for frame in frames])


@pytest.mark.parametrize("rate", [8_000, 16_000, 44_100, 96_000])
@pytest.mark.parametrize("channels", [0, 1, 2])
def test_a_recording_is_heard_whole(rate, channels):
    moments = np.arange(rate * 10) / rate
    samples = (8_000 * np.sin(2 * np.pi * 440 * moments)).astype(np.int16)
    blocks = np.array_split(np.stack([samples] * channels, axis=1) if channels else samples, 37)
    frames = pushed(StreamSource(rate, live=False, capacity=0.5), *blocks)
    assert not any(frame.lost or frame.deaf for frame in frames)
    times = [frame.time for frame in frames]
    assert times == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(len(frames))])
    assert 10.8 - 0.01 <= times[-1] <= 10.8 + 2 * FRAME_SECONDS, "with the silence at the end"
    sound = sound_of(frames)
    assert np.abs(sound[SAMPLE_RATE : 9 * SAMPLE_RATE]).max() == pytest.approx(8_000 / 32_768, rel=0.02)
    assert not np.abs(sound[-SAMPLE_RATE // 2 :]).max() > 0.01


def test_nothing_is_no_sound():
    assert pushed(StreamSource(16_000, live=False)) == []
    assert pushed(StreamSource(16_000, live=False), np.zeros(0)) == []


def test_a_program_that_pushes_nothing_again_and_again_brings_no_sound(time):
    """As one whose own microphone is gone, and gives it empty arrays: the robot could not be told to stop."""
    reports = []
    source = StreamSource(16_000, clock=time, on_report=reports.append)
    source.push(np.zeros(1_600))
    frames = source.frames()
    wait = time.wait_until

    def pushes(condition, deadline):
        assert source.push(np.zeros(0)) is True
        return wait(condition, deadline)

    time.wait_until = pushes
    assert any(frame.deaf for frame in itertools.islice(frames, 5))
    assert [report.kind for report in reports] == [ReportKind.AWAY]
    source.close()
    assert source.push(np.zeros(0)) is False


def test_what_came_while_nobody_listened_any_more_is_not_heard_later(time):
    """A program may listen again after an error of its own, a minute later."""
    reports = []
    source = StreamSource(16_000, clock=time, on_report=reports.append)
    source.push(np.full(1_600, 0.5))
    frames = source.frames()
    next(frames)
    frames.close()
    source.push(np.full(1_600, 0.5))
    time.time += 60.0
    time.later(0.1, lambda: source.push(np.full(1_600, 0.1)))
    again = source.frames()
    first = next(again)
    assert first.samples == pytest.approx(0.1, abs=1e-3)
    assert first.lost == pytest.approx(0.1)
    assert first.time < 1.0
    assert next(again).lost == 0.0
    assert [report.kind for report in reports] == [ReportKind.EARLY]


def test_what_is_not_finite_is_silence():
    sound = sound_of(pushed(StreamSource(16_000, live=False), np.full(16_000, np.nan), np.full(16_000, np.inf)))
    assert np.isfinite(sound).all()
    assert not sound.any()


@pytest.mark.parametrize("bad", [np.zeros((2, 2, 2)), np.zeros((1, 16_000)), np.float32(1.0), ["go"], None, [1j]])
def test_what_is_no_sound_is_refused(bad):
    with pytest.raises(AudioError, match="the stream was given"):
        StreamSource(16_000).push(bad)


@pytest.mark.parametrize("rate", [22_050.5, 0, -16_000, 16, 10_000_000])
def test_a_rate_that_is_none(rate):
    with pytest.raises(AudioError, match="no sample rate"):
        StreamSource(rate)


@pytest.mark.parametrize(
    ("bad", "says"),
    [
        (b"\0\0" * 100, r"given bytes.*\n    push np.frombuffer\(data, np.int16\)"),
        (bytearray(200), "given bytes"),
        (memoryview(bytes(200)), "given bytes"),
        ([[1.0], [1.0, 2.0]], "lists of different lengths"),
        ([1, 2, 3], r"int64.*\n.*astype\(np.int16\)"),
        (np.zeros(9, np.uint64), r"uint64.*\n.*astype"),
        (np.zeros((6, 32)), r"\(6, 32\), which lies on its side\n.*array.T"),
        (np.zeros((2, 1000)), r"\(2, 1000\)\n    push \(samples,\) for one channel"),
    ],
)
def test_what_would_be_heard_as_something_else_is_refused(bad, says):
    with pytest.raises(AudioError, match=says):
        StreamSource(16_000).push(bad)


def test_the_last_block_of_many_channels_may_be_short():
    source = StreamSource(16_000)
    assert source.push(np.zeros((100, 6)))
    assert source.push(np.zeros((3, 6)))
    assert source.push(np.zeros((1, 2)))


@pytest.mark.parametrize("rate", [16_000.0, np.float64(16_000), np.int32(16_000)])
def test_a_whole_rate_may_be_of_any_type(rate):
    sound = sound_of(pushed(StreamSource(rate, live=False), np.zeros(16_000, np.float32)))
    assert sound.size == pytest.approx(1.8 * 16_000, abs=512)


@pytest.mark.parametrize("wrong", [0, -1, float("nan"), "1", True])
@pytest.mark.parametrize("name", ["capacity", "patience"])
def test_a_time_that_is_none_is_refused_and_nobody_waits_for_ever(name, wrong):
    with pytest.raises(AudioError, match=f"{name}=.* is no time\n    give seconds, more than 0"):
        StreamSource(16_000, **{name: wrong})


def test_what_is_pushed_may_be_changed_afterwards(time):
    source = StreamSource(16_000, clock=time)
    block = np.full(512, 0.25, np.float32)
    source.push(block)
    block[:] = 0
    assert next(source.frames()).samples == pytest.approx(0.25)


def test_live_sound_keeps_the_time_at_which_it_came(time):
    source = StreamSource(16_000, clock=time)
    for second in range(1, 11):
        time.at(100 + second, lambda: source.push(np.full(16_000, 0.1)))
    frames = list(itertools.islice(source.frames(), 300))
    assert not any(frame.lost or frame.deaf for frame in frames)
    assert [frame.time for frame in frames] == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(300)], abs=0.04)


def test_live_sound_that_nobody_takes_is_dropped_and_told(time):
    reports = []
    source = StreamSource(48_000, clock=time, capacity=3.0, on_report=reports.append)
    frames = source.frames()
    source.push(np.zeros(4_800))
    next(frames)
    for _ in range(60):
        time.time += 1.0
        source.push(np.full(48_000, 0.1))
    lost = sum(frame.lost for frame in itertools.islice(frames, 80))
    assert lost == pytest.approx(57.0, abs=1.0)
    assert [report.kind for report in reports] == [ReportKind.LOST]


def test_a_program_that_pushes_no_more_leaves_it_deaf(time):
    reports = []
    source = StreamSource(16_000, clock=time, on_report=reports.append)
    source.push(np.zeros(1_600))
    frames = source.frames()
    heard = list(itertools.takewhile(lambda frame: not frame.deaf, frames))
    assert len(heard) == 3
    assert 1.5 < time.now() - 100 < 3.0
    assert next(frames).deaf
    source.push(np.full(1_600, 0.1))
    assert not next(frames).deaf
    assert [report.kind for report in reports] == [ReportKind.AWAY, ReportKind.BACK]


def test_whoever_waits_for_sound_is_woken_once_and_after_what_has_come(time):
    source = StreamSource(16_000, clock=time)
    source.push(np.full(1_024, 0.1))
    source.wake()
    source.wake()
    time.later(0.1, lambda: source.push(np.full(512, 0.2)))
    frames = [(frame.samples.size, frame.time) for frame in itertools.islice(source.frames(), 4)]
    assert [size for size, _ in frames] == [512, 512, 0, 512]
    assert [moment for _, moment in frames] == sorted(moment for _, moment in frames)


def test_to_be_woken_does_not_make_a_deaf_source_hear(time):
    reports = []
    source = StreamSource(16_000, clock=time, on_report=reports.append)
    source.push(np.zeros(1_600))
    frames = source.frames()
    assert any(frame.deaf for frame in itertools.islice(frames, 4))
    source.wake()
    assert not next(frames).samples.size
    assert next(frames).deaf
    assert [report.kind for report in reports] == [ReportKind.AWAY]


def test_without_patience_silence_stands_in(time):
    source = StreamSource(16_000, clock=time, patience=None)
    source.push(np.full(8_000, 0.1))
    time.at(110.0, lambda: source.push(np.full(8_000, 0.2)))
    frames = list(itertools.islice(source.frames(), 320))
    assert not any(frame.deaf or frame.lost for frame in frames)
    times = [frame.time for frame in frames]
    assert times == sorted(times)
    loud = [frame.time for frame in frames if frame.samples.max() > 0.15]
    assert len(loud) == 15
    assert loud[0] == pytest.approx(9.5, abs=0.1)
    assert len(frames) * FRAME_SECONDS == pytest.approx(times[-1], abs=0.1), "silence lasts as long as it lasted"


def test_close_from_another_thread_ends_both_sides():
    source = StreamSource(16_000, live=False, capacity=0.1)
    results = []

    def work() -> None:
        while source.push(np.zeros(1_600)):
            pass
        results.append("the pusher was told")

    thread = threading.Thread(target=work)
    thread.start()
    for count, _ in enumerate(source.frames()):
        if count == 20:
            source.close()
    thread.join(timeout=10)
    assert results == ["the pusher was told"]
    assert source.push(np.zeros(10)) is False


def test_channels_that_cancel_each_other_are_told(time):
    """The mean of a sound and its opposite, as of a balanced cable, is silence: no stop would be heard."""
    reports = []
    source = StreamSource(16_000, clock=time, capacity=10, on_report=reports.append)
    tone = 0.3 * np.sin(np.arange(4 * 16_000) / 5)
    source.push(np.stack([tone, -tone], axis=1))
    source.end(cut=False)
    assert not sound_of(source.frames()).any()
    (told,) = reports
    assert told.kind is ReportKind.MUTE
    assert "channels that cancel each other out" in told.detail


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_integers_that_are_called_floats_are_refused(dtype):
    """All of them would be clipped, and no word of it told."""
    samples = (8_000 * np.sin(np.arange(1_600) / 5)).astype(np.int16)
    source = StreamSource(16_000)
    with pytest.raises(AudioError, match=r"whole numbers, where sound is from -1 to 1\n.*divide"):
        source.push(samples.astype(dtype))
    assert source.push(samples)
    assert source.push(samples.astype(dtype) / 32_768)
    assert source.push(1.5 * np.sin(np.arange(1_600, dtype=dtype) / 5)), "somewhat too loud is clipped"
    assert source.push(np.sign(samples).astype(dtype))


def test_integers_that_were_resampled_are_refused():
    """They are no whole numbers any more, and would be clipped all the same."""
    samples = 8_000.5 * np.sin(np.arange(1_600) / 5)
    with pytest.raises(AudioError, match=r"given floats up to 800\d, where sound is from -1 to 1\n.*samples / 32768"):
        StreamSource(16_000).push(samples)


@pytest.mark.parametrize("live", [True, False])
def test_integers_of_16_bits_in_an_array_of_32_are_told(time, live):
    samples = (8_000 * np.sin(np.arange(16_000) / 5)).astype(np.int16)
    for wrong in (True, False):
        reports = []
        source = StreamSource(16_000, live=live, clock=time, on_report=reports.append)
        for _ in range(3):
            source.push(samples.astype(np.int32) << (0 if wrong else 16))
        source.end()
        list(source.frames())
        assert [report.kind for report in reports] == [ReportKind.MUTE] * wrong
        assert all("less than -96 dB" in report.detail and "int16" in report.detail for report in reports)


def test_a_recording_that_begins_with_silence_is_not_mute(time):
    reports = []
    source = StreamSource(16_000, live=False, capacity=60, clock=time, on_report=reports.append)
    source.push(np.zeros(16_000 * 5))
    source.push(TONE)
    source.end()
    list(source.frames())
    assert reports == []


def test_what_nobody_asks_to_be_told_is_logged(time, caplog):
    source = StreamSource(16_000, clock=time)
    source.push(np.zeros(1_600))
    assert any(frame.deaf for frame in itertools.islice(source.frames(), 4))
    source.push(np.full(1_600, 0.1))
    assert [record.getMessage() for record in caplog.records] == ["no sound comes from the stream"]


TONE = 0.5 * np.sin(2 * np.pi * 440 * np.arange(SAMPLE_RATE) / SAMPLE_RATE)


@pytest.mark.parametrize(
    ("live", "fade", "cut", "is_cut"),
    [
        (True, False, None, True),
        (True, True, None, False),
        (True, False, False, False),
        (True, True, True, True),
        (False, False, None, False),  # a recording is whole, as a file is
        (False, True, True, True),
    ],
)
def test_an_end_in_the_midst_of_a_sound_is_told(live, fade, cut, is_cut):
    """As of a pipe: the connection broke, and who pushed from it ends the stream."""
    source = StreamSource(SAMPLE_RATE, live=live)
    source.push(TONE * np.linspace(1, 0, TONE.size) ** 4 if fade else TONE)
    source.push(np.stack([TONE[:0], TONE[:0]], axis=1))
    source.end(cut=cut)
    assert any(frame.cut for frame in source.frames()) is is_cut
