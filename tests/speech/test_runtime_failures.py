"""What breaks while a robot listens: the sound, the recogniser, the listener. It stops, and hears the next command."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from speech_stage import Frames, Jumpy, Says, Voiced, framed

from intent_engine import Executor, Reason, Runtime, SimulatedRobot
from intent_engine.actions import Move
from intent_engine.errors import AudioError
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.runtime import HeardKind, taking_up
from intent_engine.speech.acoustic.whisper import WhisperRecognizer
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Frame
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.utterance_decoder import OFTEN


def twice(sound: np.ndarray) -> tuple[list[Frame], int]:
    """The same words twice, and the number of frames of the first."""
    return framed(np.concatenate((sound, sound))), len(framed(sound))


def test_nothing_is_done_with_words_of_which_some_are_missing(listen, go_forward):
    frames, half = twice(go_forward)
    middle = int(2.2 / FRAME_SECONDS)
    frames[middle] = replace(frames[middle], lost=0.3)
    found = listen(frames)
    assert [event.kind for event in found.events if event.kind is HeardKind.LOST] == [HeardKind.LOST]
    first = [event for event in found.of(HeardKind.SUBMITTED) if event.time <= half * FRAME_SECONDS]
    assert first == []
    assert len(found.goals) == 1, "the second time it is whole"
    assert found.robot.pose().x == pytest.approx(2.0)


@given(gap=st.floats(0.4, 2.4), lost=st.floats(0.03, 1.0))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_nor_with_the_rest_of_a_sentence_that_begins_after_the_gap(listen, gap, lost):
    """Of "don't you ever go forward", what comes after the gap is a command."""
    frames = framed(np.zeros(5 * SAMPLE_RATE, np.float32))
    place = next(at for at, frame in enumerate(frames) if frame.time > gap)
    frames[place] = replace(frames[place], lost=lost)

    class Detector(Voiced):
        def reset(self) -> None: ...

    found = listen(frames, Says("go forward two meters"), voice=Detector((0.5, 2.5)), noise_filter=None)
    assert found.goals == []
    assert found.moved == 0.0


def test_but_a_stop_is_a_stop_and_what_is_said_later_is_done(listen):
    frames = framed(np.zeros(9 * SAMPLE_RATE, np.float32))
    place = next(at for at, frame in enumerate(frames) if frame.time > 1.2)
    frames[place] = replace(frames[place], lost=0.2)

    class Detector(Voiced):
        def reset(self) -> None: ...

    voice = Detector((0.5, 2.0), (4.0, 5.0))
    stopped = listen(frames, Says("stop"), voice=voice, noise_filter=None)
    assert [event.interpretation.stops for event in stopped.of(HeardKind.SUBMITTED)] == [True]
    voice = Detector((0.5, 2.0), (4.0, 5.0))
    found = listen(frames, Says("go back one meter", "go forward two meters"), voice=voice, noise_filter=None)
    refused, _ = found.of(HeardKind.INTERPRETATION)
    assert "sound was lost" in refused.interpretation.reason
    assert found.robot.pose().x == pytest.approx(2.0)


@pytest.mark.parametrize(("end", "moved"), [(1.5, 0.0), (2.2, 2.0)])
def test_nor_with_the_half_of_a_sentence_in_which_the_sound_ended(listen, end, moved):
    """The voice detector hears a voice up to 2 s. What had ended before the sound was cut is done."""
    frames = framed(np.zeros(5 * SAMPLE_RATE, np.float32))
    place = next(at for at, frame in enumerate(frames) if frame.time > end)
    frames[place] = replace(frames[place], cut=True)

    class Detector(Voiced):
        def reset(self) -> None: ...

    voice = Detector((0.5, min(end, 2.0)))
    found = listen(frames, Says("go forward two meters"), voice=voice, noise_filter=None)
    assert found.moved == pytest.approx(moved)
    told = [event.detail for event in found.of(HeardKind.LOST)]
    assert (
        told == []
        if moved
        else told == ["the sound ended in the midst of a word, so what was being said is not acted on"]
    )


@pytest.mark.parametrize("confidence", [float("nan"), float("inf"), -1.0, 2.0])
def test_a_confidence_that_is_none_moves_nothing(listen, go_forward, confidence):
    class Unsure:
        def transcribe(self, samples, *, final=True):
            return Transcript("go forward two meters", confidence=confidence)

        def close(self): ...

    found = listen(framed(go_forward), Unsure())
    assert found.moved == 0.0
    assert "confidence is from 0 to 1 or None" in found.of(HeardKind.ERROR)[0].detail


@pytest.mark.parametrize(("given", "named"), [("go forward", "str"), (None, "NoneType"), (b"go", "bytes")])
def test_what_is_no_transcript_is_a_failure_of_the_recogniser(listen, go_forward, given, named):
    class Strange:
        def transcribe(self, samples, *, final=True):
            return given

        def close(self): ...

    found = listen(framed(go_forward), Strange())
    assert found.moved == 0.0
    assert f"it gave {named}, and no Transcript" in found.of(HeardKind.ERROR)[0].detail


def test_sound_lost_while_nobody_speaks_is_no_matter(listen, go_forward):
    frames = framed(go_forward)
    frames[5] = replace(frames[5], lost=1.0)
    found = listen(frames)
    assert found.of(HeardKind.LOST) == []
    assert found.robot.pose().x == pytest.approx(2.0)


def deaf(start: float, seconds: float) -> list[Frame]:
    count = int(seconds / 0.128)
    return [Frame(np.zeros(512, np.float32), start + 0.128 * (n + 1), deaf=True) for n in range(count)]


def test_a_robot_that_nobody_can_stop_does_not_move(listen, go_forward):
    before = framed(go_forward)  # it is driving by now: two meters take four seconds
    gone = deaf(before[-1].time, 20.0)
    after = [replace(frame, time=frame.time + gone[-1].time) for frame in framed(go_forward)]
    found = listen([*before, *gone, *after])
    (error,) = found.of(HeardKind.ERROR)
    assert error.time == gone[0].time
    assert "nobody can stop" in error.detail
    first, second = found.goals
    assert (first.succeeded, first.reason) == (False, Reason.STOP)
    assert second.succeeded, "and when sound comes again, it listens"
    assert 2.0 < found.robot.pose().x < 3.0


def test_what_was_said_just_before_it_went_deaf_is_not_done(listen, go_forward):
    words_end = int(3.0 / FRAME_SECONDS)  # in the silence after them, before it is long enough
    before = framed(go_forward)[:words_end]
    found = listen([*before, *deaf(before[-1].time, 5.0)])
    assert found.goals == []
    assert found.moved == 0


class Breaks:
    """A real recogniser that fails the first time, as a driver or a full memory makes it."""

    def __init__(self, real: WhisperRecognizer, how) -> None:
        self.real, self.how, self.left = real, how, 1

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        if self.left:
            self.left -= 1
            self.how()
        return self.real.transcribe(samples, final=final)

    def close(self) -> None: ...


def raises(error: BaseException):
    def how() -> None:
        raise error

    return how


@pytest.mark.parametrize("error", [RuntimeError("CUDA out of memory"), MemoryError(), SystemExit(1), ValueError("")])
def test_a_recogniser_that_raises(listen, whisper, go_forward, error):
    frames, _ = twice(go_forward)
    found = listen(frames, Breaks(whisper, raises(error)), speculate=False)
    (told,) = found.of(HeardKind.ERROR)
    assert f"the recogniser failed: {type(error).__name__}" in told.detail
    assert found.summary.errors == 1
    assert len(found.goals) == 1, "the next command is heard"
    assert found.robot.pose().x == pytest.approx(2.0)


def test_a_recogniser_that_raises_while_the_robot_drives_stops_it(listen, whisper, go_forward):
    class Later(Breaks):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            text = super().transcribe(samples, final=final)
            self.left = 1
            return text

    later = Later(whisper, raises(RuntimeError("gone")))
    later.left = 0
    soon = go_forward[int(1.3 * SAMPLE_RATE) :]
    found = listen(np.concatenate((go_forward[: int(3.6 * SAMPLE_RATE)], soon)), later, speculate=False)
    (goal,) = found.goals
    assert (goal.succeeded, goal.reason) == (False, Reason.STOP)
    assert 0 < found.robot.pose().x < 2.0


def test_a_recogniser_that_hangs(listen, whisper, go_forward):
    for_ever = threading.Event()
    frames, _ = twice(go_forward)
    found = listen(frames, Breaks(whisper, for_ever.wait), speculate=False, patience=3.0)
    for_ever.set()
    (told,) = found.of(HeardKind.ERROR)
    assert "did not answer within 3 s" in told.detail
    assert len(found.goals) == 1
    assert found.robot.pose().x == pytest.approx(2.0)


def test_a_listener_that_raises_stops_the_robot(engine, whisper, go_forward):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)

    def on_event(event) -> None:
        if event.kind is HeardKind.SUBMITTED:
            raise ZeroDivisionError

    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(engine, executor, whisper, on_event=on_event)
        with pytest.raises(ZeroDivisionError):
            runtime.run(Frames(framed(go_forward)))
        assert executor.idle
        executor.wait()
    assert robot.pose().x == pytest.approx(0, abs=0.05)


@pytest.mark.parametrize(
    ("given", "what"),
    [
        (np.zeros(512, np.float32), "ndarray"),
        ((np.zeros(512, np.float32), 0.032), "tuple"),
        (Frame(np.zeros(512, np.int16), 0.032), "samples of int16"),
        (Frame(np.zeros(512), 0.032), "samples of float64"),
        (Frame([0.0] * 512, 0.032), "samples in list"),  # type: ignore[arg-type]
    ],
)
def test_a_source_that_gives_no_frames_stops_the_robot_and_is_told_what_to_give(engine, given, what):
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        (goal,) = executor.submit(Move(0.5, 2.0, 4.0))
        runtime = Runtime(engine, executor, Says(), voice=Voiced())
        with pytest.raises(TypeError, match=rf"a source gives Frame\(samples, time\), .*, not {what}: StreamSource"):
            runtime.run(Frames([given]))
        assert (goal.done, goal.reason, executor.idle) == (True, Reason.STOP, True)


class Opened(Frames):
    """Frames of a device that is open as long as they are taken."""

    open = False

    def frames(self):
        self.open = True
        try:
            yield from super().frames()
        finally:
            self.open = False


@pytest.mark.parametrize("kind", [HeardKind.SPEECH, HeardKind.HOLD, HeardKind.TRANSCRIPT, HeardKind.SUBMITTED])
@pytest.mark.parametrize("error", [ZeroDivisionError("once"), KeyboardInterrupt()], ids=["an error", "Ctrl-C"])
def test_after_a_listener_that_raised_all_is_let_go_and_it_listens_as_before(engine, kind, error):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    sound = framed(np.zeros(3 * SAMPLE_RATE, np.float32))
    events = []

    def on_event(event) -> None:
        events.append(event.kind)
        if event.kind is kind and raising:
            raise error

    with Executor(robot, clock=clock) as executor:
        said = Says("go forward two meters", "stop", "go forward two meters")
        runtime = Runtime(
            engine,
            executor,
            said,
            voice=Voiced((0.5, 1.5)),
            reflex=Jumpy() if kind is HeardKind.HOLD else None,
            noise_filter=None,
            speculate=False,
            on_event=on_event,
        )
        raising, source = True, Opened(sound)
        with pytest.raises(type(error)) as caught:
            runtime.run(source)
        assert not source.open
        assert executor.idle
        assert executor.snapshot().velocity == (0.0, 0.0)
        assert not executor.snapshot().held
        if isinstance(error, Exception):
            assert any(f"told of '{kind.value}'; the robot is stopped" in note for note in caught.value.__notes__)
        raising, first = False, events.copy()
        events.clear()
        summary = runtime.run(Opened(sound))
        assert events[: len(first)] == first, "it hears, and holds, as it did"
        assert summary.utterances == 1


@pytest.mark.parametrize("gives", [float("nan"), 1.5, -0.1, None, "0.9"])
def test_a_voice_detector_that_gives_no_probability_is_a_failure_and_no_silence(engine, gives):
    class Broken(Voiced):
        def probability(self, samples: np.ndarray) -> float:
            found = super().probability(samples)
            return gives if self._frames > 40 else found

    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        executor.submit(Move(0.5, 5.0, 10.0))
        runtime = Runtime(engine, executor, Says("stop"), voice=Broken((0.5, 2.5)), noise_filter=None)
        with pytest.raises(ValueError, match=f"a probability from 0 to 1, not {gives!r}"):
            runtime.run(Frames(framed(np.zeros(3 * SAMPLE_RATE, np.float32))))
        assert executor.idle
        assert executor.snapshot().velocity == (0.0, 0.0)


class OneAtATime:
    """Waits until it is let go, and knows whether two threads were in it."""

    def __init__(self, real: WhisperRecognizer) -> None:
        self.real = real
        self.inside, self.most, self.calls = 0, 0, 0
        self.go = threading.Event()
        self.begun = threading.Event()

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.inside += 1
        self.most = max(self.most, self.inside)
        self.calls += 1
        self.begun.set()
        self.go.wait(30)
        found = self.real.transcribe(samples, final=final)
        self.inside -= 1
        return found

    def close(self) -> None: ...


def test_in_real_time_utterances_queue_for_a_slow_recogniser(engine, whisper, go_forward):
    """Two commands are said while the first is still being decoded: each is decoded, one after the other."""
    slow = OneAtATime(whisper)
    frames, _ = twice(go_forward)

    def played():
        yield from frames
        assert slow.begun.wait(30)
        slow.go.set()

    clock = MonotonicClock()
    events = []
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        Runtime(engine, executor, slow, on_event=events.append, patience=30).run(Frames(played()))
        executor.stop()
    texts = [event.transcript.text for event in events if event.kind is HeardKind.TRANSCRIPT]
    assert len(texts) == 2
    assert slow.most == 1


def test_a_recogniser_slower_than_people_speak_does_not_do_what_was_said_long_ago(engine, monkeypatch):
    """Each utterance would be later than the one before; and one of those that wait may be a stop."""
    now = [0.0]
    monkeypatch.setattr(taking_up, "monotonic", lambda: now[0])
    go = threading.Event()

    class Slow(Says):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            go.wait(30)
            return super().transcribe(samples, final=final)

    def played():
        for frame in framed(np.zeros(30 * SAMPLE_RATE, np.float32)):
            now[0] = frame.time
            yield frame
        go.set()

    events = []
    with Executor(SimulatedRobot()) as executor:
        runtime = Runtime(
            engine,
            executor,
            Slow(*["go forward two meters"] * 9),
            voice=Voiced(*((at, at + 0.5) for at in range(1, 26, 3))),
            noise_filter=None,
            speculate=False,
            on_event=events.append,
            patience=5.0,
        )
        executor.submit(Move(0.5, 5.0, 10.0))
        summary = runtime.run(Frames(played()))
        (told, *_) = [event for event in events if event.kind is HeardKind.ERROR]
        assert "too slow: what was said" in told.detail
        assert 11.0 < told.time < 15.0
        waited = [event.speech_ended for event in events if event.kind is HeardKind.TRANSCRIPT]
        assert min(waited) > 11.0, "what was said before it is not done"
        assert summary.errors > 0
        assert executor.idle or executor.stop() is None


@pytest.mark.parametrize("gives", [None, "no", float("nan"), np.array([False, True])])
def test_a_reflex_that_gives_no_yes_or_no_is_a_failure(engine, gives):
    class Strange(Jumpy):
        def heard(self, samples):
            return gives

    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        executor.submit(Move(0.5, 5.0, 10.0))
        runtime = Runtime(engine, executor, Says(), voice=Voiced((0.5, 1.5)), noise_filter=None, reflex=Strange())
        with pytest.raises(TypeError, match="a reflex says of each frame True or False, not"):
            runtime.run(Frames(framed(np.zeros(2 * SAMPLE_RATE, np.float32))))
        assert executor.idle


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"gap": float("nan")}, "gap is a log probability, not nan"),
        ({"score": float("nan")}, "score is a log probability, not nan"),
        ({"free_text": None}, "free_text is a str, not NoneType"),
        ({"unclear": None}, "unclear are a tuple, not None"),
        ({"left_out": "do you"}, "left_out are a tuple, not 'do you'"),
        ({"alternatives": "turn right"}, "alternatives are a tuple, not 'turn right'"),
        ({"alternatives": (None,)}, "alternatives are texts, not (None,)"),
        ({"unclear": (15,)}, "unclear are texts, not (15,)"),
        ({"alternatives": ("stop",), "behind": ("near",)}, "behind are numbers, not ('near',)"),
        ({"score": None}, "score is a number, not None"),
        ({"decode_seconds": None}, "decode_seconds is a number, not None"),
        ({"decode_seconds": float("nan")}, "decode_seconds is a time in s, not nan"),
        ({"language": ["en"]}, "language is a str or None, not ['en']"),
    ],
)
def test_a_transcript_that_holds_what_it_cannot_moves_nothing(listen, go_forward, wrong, told):
    class Strange(Says):
        def transcribe(self, samples, *, final=True):
            return Transcript("go forward two meters", **wrong)

    found = listen(framed(go_forward), Strange())
    assert found.moved == 0.0
    assert told in found.of(HeardKind.ERROR)[0].detail


def test_what_is_said_at_once_after_a_talk_that_was_cut_may_be_the_rest_of_it(listen):
    """Of a talk without a pause, that is longer than any command, the next words may be "go forward" of "don't go
    forward"."""
    sound = framed(np.zeros(27 * SAMPLE_RATE, np.float32))
    voice = Voiced((0.5, 22.0), (24.0, 25.0))
    found = listen(sound, Says("and so on", *["go forward two meters"] * 2), voice=voice, noise_filter=None)
    rest, later = found.of(HeardKind.INTERPRETATION)[1:]
    assert "perhaps its beginning; say it again" in rest.interpretation.reason
    assert later.interpretation.actions, "what is said after a pause is heard"
    stopped = listen(sound, Says("and so on", "stop"), voice=Voiced((0.5, 22.0)), noise_filter=None)
    assert [event.interpretation.stops for event in stopped.of(HeardKind.SUBMITTED)] == [True]


def test_what_is_heard_along_and_is_no_transcript_is_left_alone(listen):
    """The decode at the end has the same trouble, if it has, and tells it."""

    class Strange(Says):
        asked = 0

        def follow(self, samples):
            self.asked += 1

        def lose(self): ...

    sound = framed(np.zeros(3 * SAMPLE_RATE, np.float32))
    strange = Strange("go forward two meters")
    found = listen(sound, strange, voice=Voiced((0.5, 2.0)), noise_filter=None)
    assert found.robot.pose().x == pytest.approx(2.0)
    assert strange.asked <= 1.5 / OFTEN + 1, "nor is it asked more often than another"


def test_a_source_that_cannot_be_opened_stops_the_robot(engine):
    """Whether it is opened when it is asked for its frames, or when the first of them is."""

    class Missing:
        def frames(self):
            raise AudioError("there is no such recording")

        def close(self) -> None: ...

    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        executor.submit(Move(0.5, 5.0, 10.0))
        runtime = Runtime(engine, executor, Says(), voice=Voiced(), noise_filter=None)
        with pytest.raises(AudioError, match="no such recording"):
            runtime.run(Missing())
        assert executor.idle
        assert executor.snapshot().velocity == (0.0, 0.0)
