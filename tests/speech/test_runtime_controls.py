"""What a person has in hand beside the voice: the key of push-to-talk, the wake word, and ending it all."""

from __future__ import annotations

import itertools
import sys
import threading
from collections.abc import Iterator

import numpy as np
import pytest
from speech_stage import ROOT, Frames, Says, Voiced, framed

from intent_engine import Executor, IntentEngine, Move, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import HeardKind
from intent_engine.runtime import runtime as runtime_module
from intent_engine.speech.audio import FRAME_SAMPLES, SAMPLE_RATE, Frame
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.sources.stream import StreamSource
from intent_engine.speech.utterance_decoder import UtteranceDecoder


def held_down(engine, whisper, sound: np.ndarray, down: float, up: float):
    """The key is down from one time to another; gives the transcripts and where the robot went."""
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    events = []
    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(engine, executor, whisper, on_event=events.append, patience=120)
        runtime.push_to_talk()

        def frames():
            for frame in framed(sound):
                runtime.talk(down <= frame.time < up)
                yield frame

        runtime.run(Frames(frames()))
        executor.wait()
    return [event for event in events if event.kind is HeardKind.TRANSCRIPT], robot.pose().x


def test_push_to_talk_hears_only_while_the_key_is_down(engine, whisper, go_forward):
    heard, x = held_down(engine, whisper, go_forward, 0.5, 4.0)
    assert len(heard) == 1
    assert x == pytest.approx(2.0)


def test_without_the_key_nothing_is_heard(engine, whisper, go_forward):
    heard, x = held_down(engine, whisper, go_forward, 9.0, 9.0)
    assert (heard, x) == ([], 0.0)


def test_the_key_ends_the_utterance_at_once(engine, whisper, go_forward):
    heard, x = held_down(engine, whisper, go_forward, 0.5, 3.05)
    assert len(heard) == 1
    assert heard[0].time <= 3.1
    assert x == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("go forward two meters", False),
        ("robot go forward two meters", True),
        ("hey robot, could you go forward two meters", True),
        ("okay Robot: go forward two meters", True),
        ("go forward two meters robot", False),
        ("the robot go forward two meters", False),
        ("robot", False),
    ],
)
def test_wake_word(go_forward, said, done):
    engine = IntentEngine.from_files(ROOT / "grammars" / "en.yaml", wake=["robot"])
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    with Executor(robot, clock=clock) as executor:
        Runtime(engine, executor, Says(said), speculate=False).run(Frames(framed(go_forward)))
        executor.wait()
    assert (robot.pose().x > 0) is done


@pytest.mark.parametrize(("wait", "seconds"), [("", 0.35), ("wait: 900 ms", 0.9), ("wait: 0.2", 0.2)])
def test_an_intent_waits_as_long_as_its_grammar_says(tmp_path, go_forward, wait, seconds):
    grammar = tmp_path / "bar.yaml"
    order = f"  order: {{action: {{type: custom, name: order}}, sentences: ['a latte [with {{what}}]'], {wait}}}\n"
    grammar.write_text(f"language: en\nslots: {{what: [milk, cream]}}\nintents:\n{order}", "utf-8")
    clock = VirtualClock()
    events = []
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        runtime = Runtime(IntentEngine.from_files(grammar), executor, Says("a latte"), on_event=events.append)
        runtime.run(Frames(framed(go_forward)))
    (meant,) = (event for event in events if event.kind is HeardKind.INTERPRETATION)
    assert meant.interpretation.actions
    assert meant.time - meant.speech_ended == pytest.approx(seconds, abs=0.017)


def test_a_stop_needs_no_wake_word(go_forward):
    engine = IntentEngine.from_files(ROOT / "grammars" / "en.yaml", wake=["robot"])
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    both = np.concatenate((go_forward[: int(3.6 * SAMPLE_RATE)], go_forward[int(1.3 * SAMPLE_RATE) :]))
    with Executor(robot, clock=clock) as executor:
        Runtime(engine, executor, Says("robot go forward two meters", "stop"), speculate=False).run(
            Frames(framed(both))
        )
        executor.wait()
    assert 0 < robot.pose().x < 1.9


def test_a_wake_word_stays_after_a_reload(tmp_path):
    grammar = tmp_path / "go.yaml"
    grammar.write_text("language: en\nintents:\n  wave: {action: custom, sentences: [wave]}\n", "utf-8")
    engine = IntentEngine.from_files(grammar, wake=["Robbie the robot"])
    engine.reload()
    assert not engine.parse("wave", spoken=True).actions
    assert engine.parse("robbie the robot wave", spoken=True).actions
    assert engine.parse("wave").actions, "who types is meant to"


def test_close_from_another_thread_ends_it_and_stops_the_robot(engine, whisper, go_forward):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    source = StreamSource(SAMPLE_RATE, live=False)
    submitted = threading.Event()
    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(
            engine,
            executor,
            whisper,
            on_event=lambda event: submitted.set() if event.kind is HeardKind.SUBMITTED else None,
            patience=120,
        )
        thread = threading.Thread(target=runtime.run, args=(source,))
        thread.start()
        source.push(go_forward)
        assert submitted.wait(120)
        runtime.close()
        runtime.close()
        thread.join(timeout=30)
        assert not thread.is_alive()
        executor.wait()
        assert executor.idle
    assert robot.pose().x < 2.0


class SaysWhenAllowed(Says):
    """A recogniser that says nothing until it may."""

    def __init__(self, *texts: str) -> None:
        super().__init__(*texts)
        self.may = threading.Event()

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        assert self.may.wait(60)
        return super().transcribe(samples, final=final)


class Taken(StreamSource):
    """A stream that tells when so many frames were taken."""

    def __init__(self, count: int, told: threading.Event) -> None:
        super().__init__(SAMPLE_RATE, live=False)
        self._count = count
        self._told = told

    def frames(self) -> Iterator[Frame]:
        for number, frame in enumerate(super().frames(), 1):
            yield frame
            if number == self._count:
                self._told.set()


def test_what_is_decoded_is_done_though_no_more_sound_comes(engine):
    """At the next frame it would be up to 32 ms later."""
    recognizer, submitted = SaysWhenAllowed("turn left"), threading.Event()
    source = Taken(90, recognizer.may)
    with Executor(SimulatedRobot()) as executor:
        runtime = Runtime(
            engine,
            executor,
            recognizer,
            voice=Voiced((0.5, 1.5)),
            noise_filter=None,
            on_event=lambda event: submitted.set() if event.kind is HeardKind.SUBMITTED else None,
        )
        thread = threading.Thread(target=runtime.run, args=(source,))
        thread.start()
        source.push(np.zeros(90 * FRAME_SAMPLES, np.float32))
        assert submitted.wait(60)
        runtime.close()
        thread.join(timeout=60)
        assert not thread.is_alive()


def test_what_is_decoded_when_it_is_closed_is_not_done_and_not_waited_for(engine, monkeypatch):
    """The sound is over, and its last words are waited for: the recogniser does not answer before it is closed."""
    waits, never = threading.Event(), threading.Event()
    wait = UtteranceDecoder.wait

    def told(decoder: UtteranceDecoder, job) -> None:
        waits.set()
        wait(decoder, job)

    monkeypatch.setattr(UtteranceDecoder, "wait", told)
    monkeypatch.setattr("intent_engine.runtime.runtime.LAST_DECODE", 0.0)

    class Hangs(Says):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            never.wait(60)
            return super().transcribe(samples, final=final)

    events, summaries = [], []
    with Executor(SimulatedRobot()) as executor:
        runtime = Runtime(
            engine,
            executor,
            Hangs("turn left"),
            voice=Voiced((0.5, 1.5)),
            noise_filter=None,
            speculate=False,
            on_event=events.append,
            patience=60,
        )
        source = Frames(framed(np.zeros(2 * SAMPLE_RATE, np.float32)))
        thread = threading.Thread(target=lambda: summaries.append(runtime.run(source)))
        thread.start()
        assert waits.wait(60)
        runtime.close()
        thread.join(timeout=10)
        waited = thread.is_alive()
        never.set()
        thread.join(timeout=30)
        assert not waited
        assert executor.idle
    assert [event.kind for event in events] == [HeardKind.SPEECH]
    assert (summaries[0].utterances, summaries[0].errors) == (0, 0)


@pytest.mark.parametrize("kind", [HeardKind.SPEECH, HeardKind.PARTIAL, HeardKind.TRANSCRIPT, HeardKind.INTERPRETATION])
def test_nothing_is_begun_after_a_listener_has_closed_it(engine, kind):
    clock = VirtualClock()
    events = []

    def on_event(event) -> None:
        events.append(event.kind)
        if event.kind is kind:
            runtime.close()

    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        voice = Voiced((0.5, 1.5))
        said = Says("turn left", "turn left")
        runtime = Runtime(engine, executor, said, voice=voice, noise_filter=None, on_event=on_event)
        summary = runtime.run(Frames(framed(np.zeros(4 * SAMPLE_RATE, np.float32))))
        assert executor.idle
    assert kind in events
    assert HeardKind.SUBMITTED not in events
    assert summary.accepted == 0


def test_what_was_closed_asks_for_no_sound(engine):
    """A recording of which nothing has come yet would be waited for, for ever."""
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        runtime = Runtime(engine, executor, Says(), voice=Voiced(), noise_filter=None)
        runtime.close()
        source = StreamSource(SAMPLE_RATE, live=False)
        thread = threading.Thread(target=runtime.run, args=(source,), daemon=True)
        thread.start()
        thread.join(timeout=10)
        source.close()
        assert not thread.is_alive()


def test_it_listens_along_to_the_second_source_as_to_the_first(engine):
    class Follows(Says):
        asked = 0

        def follow(self, samples):
            self.asked += 1
            return Transcript("go", free_text="go", draft=True, decode_seconds=0.05)

        def lose(self) -> None: ...

    clock = VirtualClock()
    counted = []
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        follows = Follows()
        runtime = Runtime(engine, executor, follows, voice=Voiced((5.0, 8.0)), noise_filter=None)
        for _ in range(2):
            runtime.run(Frames(framed(np.zeros(9 * SAMPLE_RATE, np.float32))))
            counted.append(follows.asked)
    assert 0 < counted[0] == counted[1] - counted[0]


@pytest.mark.parametrize("patience", [float("inf"), 1e300])
def test_a_recogniser_may_be_waited_for_as_long_as_it_takes(listen, patience):
    class Late(Says):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            threading.Event().wait(0.01)
            return super().transcribe(samples, final=final)

    sound = framed(np.zeros(3 * SAMPLE_RATE, np.float32))
    late = Late("go forward two meters")
    found = listen(sound, late, voice=Voiced((0.5, 1.5)), noise_filter=None, patience=patience)
    assert found.robot.pose().x == pytest.approx(2.0)


def test_it_hears_one_source_at_a_time(engine, go_forward):
    """Two would share one endpoint, and close() would end the second alone."""
    clock = VirtualClock()
    refused = []

    def on_event(event) -> None:
        if event.kind is HeardKind.SPEECH:
            with pytest.raises(RuntimeError, match=r"listens already.*or make another Runtime") as caught:
                runtime.run(Frames([]))
            refused.append(caught)

    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        voice = Voiced((0.5, 1.5))
        runtime = Runtime(engine, executor, Says("turn left"), voice=voice, noise_filter=None, on_event=on_event)
        sound = framed(np.zeros(3 * SAMPLE_RATE, np.float32))
        assert runtime.run(Frames(sound)).utterances == 1
        assert len(refused) == 1
        assert runtime.run(Frames(sound)).seconds > 0, "once it is over it may be called again"


def interrupted_at(line: int, call) -> bool:
    """Ctrl-C at the ``line``-th line of the runtime's module that ``call`` comes to; whether it came."""
    lines = 0

    def trace(frame, event, _):
        nonlocal lines
        if frame.f_code.co_filename != runtime_module.__file__:
            return None
        if event == "line":
            lines += 1
            if lines == line:
                raise KeyboardInterrupt
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        call()
    except KeyboardInterrupt:
        return True
    finally:
        sys.settrace(before)
    return False


def test_an_interrupt_as_it_begins_stops_the_robot_and_leaves_it_able_to_listen(engine):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)

    class Source:
        def frames(self) -> Iterator[Frame]:
            sys.settrace(None)  # what comes later is not its beginning
            return iter(())

    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(engine, executor, Says("turn left"), voice=Voiced((0.5, 1.5)), noise_filter=None)
        goes_on = 0
        for line in itertools.count(1):
            executor.submit(Move(0.5, 5.0, 10.0))
            clock.advance(0.1)
            assert robot.speed() == (0.5, 0.0)
            if not interrupted_at(line, lambda: runtime.run(Source())):
                break
            if robot.speed() == (0.5, 0.0):
                assert line == goes_on + 1, "nothing but what comes before anything is taken"
                goes_on = line
            assert runtime.run(Frames([])).utterances == 0
            executor.stop()
        assert 0 < goes_on < 8 < line


def keyed(engine, said: list[str], voiced, downs, sound: np.ndarray):
    """The key is down at some times, and a voice is heard at some; gives where the robot went, and what was told."""
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    events = []
    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(
            engine,
            executor,
            Says(*said),
            voice=Voiced(*voiced),
            noise_filter=None,
            speculate=False,
            on_event=events.append,
        )
        runtime.push_to_talk()

        def frames():
            for frame in framed(sound):
                runtime.talk(any(down <= frame.time < up for down, up in downs))
                yield frame

        runtime.run(Frames(frames()))
        executor.wait()
    return robot.pose().x, [event.interpretation for event in events if event.kind is HeardKind.INTERPRETATION]


def loud(seconds: float, *times: tuple[float, float, float]) -> np.ndarray:
    """Noise of some loudness at some times."""
    sound = np.full(int(seconds * SAMPLE_RATE), 1e-4, np.float32)
    for begin, end, level in times:
        sound[int(begin * SAMPLE_RATE) : int(end * SAMPLE_RATE)] = level
    return sound


@pytest.mark.parametrize(
    ("voice", "down", "why"),
    [
        ((0.5, 2.0), 1.0, "in the midst of the sentence"),
        ((0.5, 2.0), 0.7, "in the midst of its first word"),
        ((0.5, 0.9, 1.2, 2.0), 1.0, "in a pause of it"),
    ],
)
def test_the_rest_of_a_sentence_that_began_before_the_key_was_pressed_is_not_done(engine, voice, down, why):
    """Of "don't go forward", what is heard is a command."""
    spans = list(zip(voice[::2], voice[1::2], strict=True))
    sound = loud(5, *((begin, end, 0.1) for begin, end in spans))
    x, (meant,) = keyed(engine, ["go forward two meters"], spans, [(down, 4.0)], sound)
    assert x == 0.0, why
    assert "perhaps its beginning; say it again" in meant.reason
    _, (stop,) = keyed(engine, ["stop"], spans, [(down, 4.0)], sound)
    assert stop.stops, "a stop is one whatever came before it"


@pytest.mark.parametrize(
    ("voice", "levels", "down", "why"),
    [
        ((0.5, 0.9, 2.0, 3.0), (0.1, 0.1), 1.2, "what came before was over"),
        ((0.5, 1.5, 1.5, 3.0), (0.01, 0.1), 1.4, "others talk farther off"),
        ((1.1, 2.0), (0.1,), 1.0, "the key was pressed first"),
    ],
)
def test_who_presses_the_key_in_time_is_heard(engine, voice, levels, down, why):
    spans = list(zip(voice[::2], voice[1::2], strict=True))
    sound = loud(6, *((begin, end, level) for (begin, end), level in zip(spans, levels, strict=True)))
    x, _ = keyed(engine, ["go forward two meters"], spans, [(down, 5.0)], sound)
    assert x == pytest.approx(2.0), why


def test_a_knock_of_the_key_itself_is_no_command(engine):
    """Letting go ends the utterance at once, which makes it no longer than it was."""
    sound = loud(3, (0.5, 0.58, 0.1))
    x, _ = keyed(engine, ["go forward two meters"], [(0.5, 0.58)], [(0.3, 0.6)], sound)
    assert x == 0.0
    x, (meant,) = keyed(engine, ["stop"], [(0.5, 0.58)], [(0.3, 0.6)], sound)
    assert meant.stops, "a stop may be as short"


@pytest.mark.parametrize(("said", "acts"), [("go forward two meters", 0), ("stop", 1)])
def test_nor_is_a_knock_with_which_the_sound_ends(listen, said, acts):
    found = listen(framed(np.zeros(int(0.6 * SAMPLE_RATE), np.float32)), Says(said), voice=Voiced((0.5, 9.0)))
    assert len(found.of(HeardKind.SUBMITTED)) == acts


def test_a_key_that_bounces_in_the_midst_of_a_word_does_not_join_the_pieces(engine):
    """ "Go", a gap, "four meters" may have been "go forward two meters"."""
    sound = loud(6, (0.5, 2.5, 0.1))
    x, meant = keyed(engine, ["i", "go four meters"], [(0.5, 2.5)], [(0.3, 1.0), (1.1, 5.0)], sound)
    assert x == 0.0
    assert "perhaps its beginning" in meant[-1].reason


def test_the_end_of_one_command_does_not_spoil_the_next(engine):
    """The detector hears a voice for 0.1 s after the key was let go."""
    said = ["go forward two meters", "go forward one meter"]
    spans = [(0.5, 1.6), (1.9, 3.0)]
    sound = loud(6, *((begin, end, 0.1) for begin, end in spans))
    x, meant = keyed(engine, said, spans, [(0.3, 1.5), (1.8, 5.0)], sound)
    assert [one.status.value for one in meant] == ["accepted", "accepted"]
    assert x > 0.9


def test_a_robot_is_not_asked_where_it_is_to_know_that_it_moves(engine):
    """It may take its time to answer, and nothing is heard meanwhile."""

    class Slow(SimulatedRobot):
        asked = 0

        def pose(self):
            self.asked += 1
            return super().pose()

    clock = VirtualClock()
    robot = Slow(clock)
    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(engine, executor, Says("hello there"), voice=Voiced((0.5, 1.5)), noise_filter=None)
        runtime.run(Frames(framed(np.zeros(3 * SAMPLE_RATE, np.float32))))
        assert robot.asked == 0
