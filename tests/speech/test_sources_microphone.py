"""The microphone, from PortAudio's callback to frames: unplugged, replugged, too fast, muted, forbidden."""

from __future__ import annotations

import itertools
import sys

import numpy as np
import pytest
from fake_portaudio import FakePortAudio, FakeTime, Plug

from intent_engine.errors import DeviceError
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, ReportKind
from intent_engine.speech.sources.microphone import Microphone


@pytest.fixture
def time():
    return FakeTime()


@pytest.fixture
def audio(monkeypatch, time):
    """PortAudio with the microphones that it is given."""

    def make(*plugs: Plug) -> FakePortAudio:
        fake = FakePortAudio(time, *plugs)
        monkeypatch.setitem(sys.modules, "sounddevice", fake)
        return fake

    return make


def take(frames, count):
    return list(itertools.islice(frames, count))


def loudest_hertz(frames) -> float:
    sound = np.concatenate([frame.samples for frame in frames])
    return float(np.argmax(np.abs(np.fft.rfft(sound * np.hanning(sound.size)))) * SAMPLE_RATE / sound.size)


def test_frames_come_as_they_are_heard(audio, time):
    audio(Plug("headset"))
    frames = take(Microphone(clock=time).frames(), 100)
    assert [frame.samples.shape for frame in frames] == [(512,)] * 100
    assert [frame.time for frame in frames] == pytest.approx([FRAME_SECONDS * (n + 1) for n in range(100)], abs=1e-6)
    assert not any(frame.lost or frame.deaf for frame in frames[1:])
    assert frames[0].lost > 0, "what was being said when it was opened may have begun before"
    assert not frames[0].deaf
    assert loudest_hertz(frames) == pytest.approx(440, abs=1)


@pytest.mark.parametrize(
    ("plug", "opened"),
    [
        (Plug("usb", rate=44_100, rates=(44_100,)), (44_100, 1)),
        (Plug("stereo", channels=2, rate=48_000, rates=(48_000,)), (48_000, 2)),
        (Plug("array", channels=6, rate=8_000, rates=(8_000,)), (8_000, 1)),
        (Plug("plain", rate=48_000), (16_000, 1)),
    ],
    ids=lambda value: value.name if isinstance(value, Plug) else "",
)
def test_any_rate_and_number_of_channels(audio, time, plug, opened):
    fake = audio(plug)
    listening = Microphone(clock=time).frames()
    frames = take(listening, 60)
    assert (fake.open_streams[0].rate, fake.open_streams[0].channels) == opened
    assert loudest_hertz(frames) == pytest.approx(440, abs=2)
    assert frames[-1].time == pytest.approx(60 * FRAME_SECONDS, abs=0.05)


def test_unplugged_and_plugged_in_again(audio, time):
    headset = Plug("headset")
    fake = audio(headset)
    reports = []
    frames = Microphone(clock=time, on_report=reports.append).frames()
    take(frames, 30)
    headset.plugged = False
    unplugged = time.now()
    first = next(frame for frame in frames if frame.deaf)
    assert first.time < unplugged - 100 + 0.1, "PortAudio says so, and patience need not run out"
    assert not first.samples.any()
    away = take(frames, 40)
    assert all(frame.deaf for frame in away)
    assert len(away) < 60 * (away[-1].time - first.time), "frames of nothing cost nothing"
    headset.plugged = True
    back = next(frame for frame in frames if not frame.deaf)
    assert back.samples.any()
    more = take(frames, 30)
    assert not any(frame.deaf for frame in more)
    assert more[-1].time == pytest.approx(time.now() - 100, abs=0.05)
    assert [report.kind for report in reports] == [ReportKind.AWAY, ReportKind.BACK]
    assert fake.started > 1, "PortAudio lists new devices only when it is started anew"
    assert len(fake.open_streams) == 1


def test_a_microphone_that_takes_its_time_to_begin(audio, time):
    audio(Plug("bluetooth", delay=2.5))
    reports = []
    frames = Microphone(clock=time, on_report=reports.append).frames()
    assert not any(frame.deaf for frame in take(frames, 50))
    assert reports == []


def test_a_driver_that_falls_silent_without_a_word(audio, time):
    fake = audio(Plug("headset"))
    frames = Microphone(clock=time).frames()
    take(frames, 10)
    fake.open_streams[0].running = False
    stopped = time.now()
    assert next(frames).deaf
    assert 0.5 < time.now() - stopped < 2.0
    assert not next(frame for frame in frames if not frame.deaf).deaf, "opening it again brings it back"


def test_a_chosen_microphone_is_found_again_under_another_number(audio, time):
    table, headset = Plug("table"), Plug("headset", sound=lambda moments: np.full(moments.size, 0.25))
    fake = audio(table, headset)
    microphone = Microphone("headset", clock=time)
    frames = microphone.frames()
    take(frames, 10)
    assert microphone.device.index == 1
    headset.plugged = False
    assert all(frame.deaf for frame in itertools.islice((f for f in frames if f.deaf), 30)), "no other is taken"
    fake.plugs.reverse()
    headset.plugged = True
    back = next(frame for frame in frames if not frame.deaf)
    assert back.samples == pytest.approx(0.25)
    assert microphone.device.index == 0


def test_without_a_choice_another_microphone_takes_over(audio, time):
    first, second = Plug("first"), Plug("second")
    audio(first, second)
    microphone = Microphone(clock=time)
    frames = microphone.frames()
    take(frames, 5)
    first.plugged = False
    next(frame for frame in frames if frame.deaf)
    next(frame for frame in frames if not frame.deaf)
    assert microphone.device.name == "second"


def test_overruns_are_marked_and_told_but_not_one_by_one(audio, time):
    headset = Plug("headset")
    audio(headset)
    reports = []
    frames = Microphone(clock=time, on_report=reports.append).frames()
    take(frames, 5)
    headset.overflows = 20
    marked = [frame for frame in take(frames, 60) if frame.lost]
    assert len(marked) == 20
    assert [report.kind for report in reports] == [ReportKind.LOST]
    assert "0.03 s of sound from microphone 'headset' were lost" in reports[0].detail
    take(frames, 300)
    assert [report.kind for report in reports] == [ReportKind.LOST] * 2
    assert "0.61 s of sound" in reports[1].detail


def test_what_nobody_takes_does_not_pile_up(audio, time):
    audio(Plug("headset"))
    microphone = Microphone(clock=time, capacity=2.0)
    frames = microphone.frames()
    take(frames, 5)
    time.pass_by(600.0)
    frame = next(frames)
    assert frame.lost == pytest.approx(598.0, abs=0.1)
    assert frame.time == pytest.approx(600.0 - 2.0 + 5 * FRAME_SECONDS, abs=0.3), "its time is that of its sound"
    after = take(frames, 70)
    assert not any(frame.lost for frame in after)
    times = [frame.time for frame in after]
    assert times == sorted(times)
    assert times[-1] == pytest.approx(time.now() - 100, abs=0.3)


@pytest.mark.parametrize("true_rate", [15_900.0, 16_100.0])
def test_times_follow_the_clock_not_the_crystal(audio, time, true_rate):
    audio(Plug("cheap", true_rate=true_rate))
    frames = take(Microphone(clock=time).frames(), 4_000)
    times = [frame.time for frame in frames]
    assert times == sorted(times)
    assert times[-1] == pytest.approx(time.now() - 100, abs=0.3)


def test_nothing_but_zeros_is_told_once(audio, time):
    audio(Plug("muted", sound=np.zeros_like))
    reports = []
    take(Microphone(clock=time, on_report=reports.append).frames(), 400)
    assert [report.kind for report in reports] == [ReportKind.MUTE]
    assert "may not use it" in reports[0].detail


def test_close_ends_it_and_lets_the_device_go(audio, time):
    fake = audio(Plug("headset"))
    microphone = Microphone(clock=time)
    frames = microphone.frames()
    take(frames, 5)
    microphone.close()
    microphone.close()
    assert list(frames) == []
    assert fake.open_streams == []


def test_without_portaudio(monkeypatch):
    monkeypatch.setitem(sys.modules, "sounddevice", None)
    with pytest.raises(DeviceError, match=r"PortAudio is not there(.|\n)*install"):
        Microphone()


@pytest.mark.parametrize(
    ("plugs", "device", "says"),
    [
        ((), None, "there is no microphone\n"),
        ((Plug("headset"),), "webcam", "there is no microphone 'webcam'; choose by number or name:\n    0: headset"),
        ((Plug("headset"),), 7, "there is no microphone '7'"),
        ((Plug("left mic"), Plug("right mic")), "mic", "several microphones are named like 'mic'"),
    ],
)
def test_no_such_microphone(audio, plugs, device, says):
    audio(*plugs)
    with pytest.raises(DeviceError) as caught:
        Microphone(device)
    assert says in str(caught.value)


@pytest.mark.parametrize("device", ["right mic", "RIGHT", 1, "1"])
def test_chosen_by_name_part_or_number(audio, device):
    audio(Plug("left mic"), Plug("right mic"))
    assert Microphone(device).device.name == "right mic"


@pytest.mark.parametrize("plug", [Plug("held", busy=True), Plug("odd", rates=())], ids=["busy", "no rate"])
def test_a_microphone_that_cannot_be_opened(audio, time, plug):
    audio(plug)
    microphone = Microphone(clock=time)
    with pytest.raises(DeviceError, match="cannot be opened"):
        next(microphone.frames())
