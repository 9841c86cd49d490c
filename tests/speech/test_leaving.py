"""A decode that nobody waits for any more is left, and what is asked next is heard as if nothing had been asked."""

from __future__ import annotations

import math
import threading
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from speech_stage import Voiced, framed

from intent_engine import Executor, Runtime, SimulatedRobot
from intent_engine.execution.clock import MonotonicClock
from intent_engine.runtime import HeardKind
from intent_engine.speech import leaving
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Frame
from intent_engine.speech.decoding import DecodeThread
from intent_engine.speech.leaving import Leavable, LeftError
from intent_engine.speech.models import NONE, recognizer_for
from intent_engine.speech.recognizer import Transcript

LONG = 60.0
"""s: nobody waits so long but where something is broken."""


class After:
    """An event that is set once it has been looked at so many times."""

    def __init__(self, looks: int) -> None:
        self.looks = looks

    def is_set(self) -> bool:
        self.looks -= 1
        return self.looks < 0

    def set(self) -> None:
        self.looks = 0


@pytest.fixture(scope="module", params=["two models", "one model"])
def recognizer(engine, request):
    made = recognizer_for(engine, second=None if request.param == "two models" else NONE)
    yield made
    made.close()


@pytest.fixture
def noisy(spoken) -> np.ndarray:
    """So that everything is asked that can be."""
    return (spoken + np.random.default_rng(3).normal(0.0, 0.05, spoken.size)).astype(np.float32)


def test_it_is_left_wherever_it_is_and_harms_nothing(recognizer, noisy, monkeypatch):
    """At the first question to a model, the third, the ninth, ... ; the answer after it is the one before it."""
    assert isinstance(recognizer, Leavable)
    whole = recognizer.transcribe(noisy)
    left = 0
    for looks in (0, 2, 8, 14, 30, 60):
        with monkeypatch.context() as patched:
            patched.setattr(leaving, "Event", lambda looks=looks: After(looks))
            try:
                recognizer.transcribe(noisy)
            except LeftError:
                left += 1
    assert left >= 4, "some are over before"
    again = recognizer.transcribe(noisy)
    assert (again.text, again.confidence) == (whole.text, whole.confidence)


def test_to_leave_what_is_over_harms_nothing(recognizer, spoken):
    decodes = DecodeThread(recognizer, patience=LONG)
    before = decodes.begin(spoken, final=True).result(LONG)
    decodes.leave()
    assert decodes.begin(spoken, final=True).result(LONG).text == before.text


class Slow:
    """A recogniser whose first answer takes until it is left, or for ever; then it hears "turn left"."""

    def __init__(self) -> None:
        self.asked: list[bool] = []
        """For each decode whether it was final."""
        self.began, self.second, self.let_go = (threading.Event() for _ in range(3))

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.asked.append(final)
        if len(self.asked) > 1:
            self.second.set()
            return Transcript("turn left", free_text="turn left", gap=0.0)
        self.began.set()
        assert self.let_go.wait(LONG)
        return self.first()

    def first(self) -> Transcript:
        return Transcript("turn right", free_text="turn right", gap=0.0)

    def close(self) -> None: ...


class Quits(Slow):
    """The same; it can be left."""

    def leave(self) -> None:
        self.let_go.set()

    def first(self) -> Transcript:
        raise LeftError


def frames_after(time: float, frame: Frame) -> int:
    """How many frames after a time, in s, another is; the first at or after it is 0."""
    return math.floor((frame.time - time) / FRAME_SECONDS)


class InTurn:
    """A live source: speech, a pause, speech, silence. It goes on when the recogniser has come as far."""

    PARTS = ((0.5, 1.0), (1.1, 1.6))

    def __init__(self, recognizer: Slow) -> None:
        self.recognizer = recognizer
        self._woken = threading.Event()

    def frames(self) -> Iterator[Frame]:
        for frame in framed(np.full(3 * SAMPLE_RATE, 0.1, np.float32)):
            yield frame
            if 1.05 < frame.time < 1.1:
                assert self.recognizer.began.wait(LONG), "the pause was decoded"
            leavable = isinstance(self.recognizer, Leavable)
            if frames_after(1.5 if leavable else 1.7, frame) == 0:  # speech has gone on; the second pause
                if not leavable:
                    self.recognizer.let_go.set()
                assert self._woken.wait(LONG), "the first decode has ended"
            if frames_after(1.7, frame) == 2:
                assert self.recognizer.second.wait(LONG), "and the second began in the silence"

    def wake(self) -> None:
        self._woken.set()

    def close(self) -> None: ...


@pytest.mark.parametrize("kind", [Slow, Quits])
def test_who_speaks_on_is_heard_anew_and_what_was_begun_before_is_nothing(engine, kind):
    """Also by a recogniser that cannot be left: what it says of the first half is not acted on."""
    recognizer = kind()
    events = []
    clock = MonotonicClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        voice = Voiced(*InTurn.PARTS)
        runtime = Runtime(engine, executor, recognizer, voice=voice, on_event=events.append, noise_filter=None)
        summary = runtime.run(InTurn(recognizer))
    assert summary.errors == 0
    assert recognizer.asked[:2] == [False, False], "both while they may go on"
    kinds = [event.kind for event in events]
    assert kinds.count(HeardKind.OUTDATED) == 1
    assert {event.transcript.text for event in events if event.transcript is not None} == {"turn left"}


@pytest.mark.parametrize("what", ["closed", "sound lost"])
def test_what_nobody_will_act_on_is_left(engine, what):
    recognizer = Quits()
    clock = MonotonicClock()

    class Broken(InTurn):
        """It comes as far as the first pause."""

        def frames(self) -> Iterator[Frame]:
            for frame in framed(np.full(int(1.5 * SAMPLE_RATE), 0.1, np.float32)):
                if frames_after(1.1, frame) == 0:
                    assert recognizer.began.wait(LONG), "the pause was decoded"
                    if what == "closed":
                        runtime.close()
                    else:
                        frame = replace(frame, lost=0.5)
                yield frame

    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        runtime = Runtime(engine, executor, recognizer, voice=Voiced((0.5, 1.0)), noise_filter=None)
        summary = runtime.run(Broken(recognizer))
    assert recognizer.let_go.wait(LONG)
    assert (summary.errors, summary.accepted) == (0, 0)


def test_what_is_known_between_two_frames_is_done_between_them(engine):
    """A command that nothing can change, and whose decode takes longer than the silence after it: the end of the decode
    wakes the source, and no other sound has to come."""

    class Late(Slow):
        def first(self) -> Transcript:
            text = "turn left ninety degrees"
            return Transcript(text, free_text=text, gap=0.0)

    recognizer = Late()
    events = []

    class Wakes(InTurn):
        def frames(self) -> Iterator[Frame]:
            for frame in framed(np.full(2 * SAMPLE_RATE, 0.1, np.float32)):
                yield frame
                if frames_after(1.0, frame) == 4:
                    recognizer.let_go.set()
                    assert self._woken.wait(LONG), "the decode has ended"
                    yield Frame(np.zeros(0, np.float32), frame.time)
                    kinds.extend(event.kind for event in events)

    kinds: list[HeardKind] = []
    clock = MonotonicClock()
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        voice = Voiced((0.5, 1.0))
        runtime = Runtime(engine, executor, recognizer, voice=voice, on_event=events.append, noise_filter=None)
        runtime.run(Wakes(recognizer))
    assert HeardKind.SUBMITTED in kinds
