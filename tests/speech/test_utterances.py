"""What an utterance is made of: all of what was said, and nothing that was said before."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speech_stage import Frames, Jumpy, Says, Voiced, framed

from intent_engine import Executor, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

FRAME = round(FRAME_SECONDS * SAMPLE_RATE)


class Asked:
    """A recogniser that hears the same always, and keeps from when to when each sound was: samples tell their frame."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.sounds: list[tuple[int, int]] = []

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.sounds.append((round(samples[0] * 1000), round(samples[-1] * 1000)))
        return Transcript(self.text, free_text=self.text, gap=0.0)

    def close(self) -> None: ...

    @property
    def utterances(self) -> dict[int, int]:
        """Of each its first frame, and the last that was heard of it."""
        return dict(self.sounds)


def numbered(frames: int) -> np.ndarray:
    return np.repeat(np.arange(frames, dtype=np.float32) / 1000, FRAME)


@settings(max_examples=60, deadline=None)
@given(
    spans=st.lists(st.tuples(st.integers(1, 20), st.integers(4, 30)), min_size=1, max_size=8),
    text=st.sampled_from(["turn left", "go forward", "stop", "mug", ""]),
)
def test_every_frame_of_speech_is_heard_in_one_utterance(engine, spans, text):
    """Pauses and words of any length, in frames; words that are longer than a knock."""
    begin, voiced = 5, []
    for pause, word in spans:
        voiced.append((begin + pause, begin + pause + word))
        begin += pause + word
    recognizer = Asked(text)
    clock = VirtualClock()
    times = [(first * FRAME_SECONDS, last * FRAME_SECONDS) for first, last in voiced]
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        runtime = Runtime(engine, executor, recognizer, voice=Voiced(*times), noise_filter=None)
        runtime.run(Frames(framed(numbered(begin + 40))))
    found = recognizer.utterances
    for first, last in voiced:
        for frame in range(first, last):
            assert sum(start <= frame <= end for start, end in found.items()) == 1, (frame, voiced, found)


def test_what_was_done_is_not_done_again_by_its_own_end(listen):
    """The "p" of "stop" comes after a silence, as does the "t" of "turn left", of which "left" alone is a command."""
    recognizer = Asked("turn left ninety degrees")
    frames = numbered(80)
    tail = 0.9 + 5 * FRAME_SECONDS
    listened = listen(frames, recognizer, voice=Voiced((0.5, 0.9), (tail, tail + 0.15)), noise_filter=None)
    assert len(listened.of(HeardKind.SUBMITTED)) == 2
    (first, second) = recognizer.utterances
    assert first * FRAME_SECONDS < 0.5
    assert second * FRAME_SECONDS >= 0.9 - FRAME_SECONDS


def test_push_to_talk_hears_nothing_from_before_the_key_went_up(engine):
    recognizer = Asked("turn left")
    clock = VirtualClock()

    class Pressed(Frames):
        """The key is down but for a moment; somebody speaks right before and right after that."""

        def frames(self):
            for number, frame in enumerate(super().frames()):
                runtime.talk(not 30 <= number < 60)
                yield frame

    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        runtime = Runtime(engine, executor, recognizer, voice=Voiced((0.5, 0.96), (1.92, 2.6)), noise_filter=None)
        runtime.push_to_talk(True)
        runtime.run(Pressed(framed(numbered(120))))
    second = list(recognizer.utterances)[1]
    assert second >= 60


@pytest.mark.parametrize(
    ("text", "score", "stops"),
    [("Oh", -2.6, True), ("", -9.0, False), ("Oh", -0.5, False)],
    ids=["hardly a word", "nothing", "a word"],
)
def test_a_held_robot_goes_on_only_if_something_else_was_heard(listen, text, score, stops):
    class Hardly(Says):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            heard = super().transcribe(samples, final=final)
            return heard if heard.text == "go forward ten meters" else Transcript(text, score, text)

    frames = numbered(200)
    listened = listen(
        frames,
        Hardly("go forward ten meters"),
        voice=Voiced((0.5, 1.5), (3.5, 4.0)),
        noise_filter=None,
        reflex=Jumpy(),
        speculate=False,
    )
    ten, *_ = listened.goals
    assert (ten.state.value == "canceled") is stops
    assert bool(len(listened.of(HeardKind.RELEASE)) == 2) is not stops
    if stops:
        assert "heard clearly" in listened.of(HeardKind.SUBMITTED)[-1].interpretation.reason


class Probabilities:
    """A voice detector that is as sure of speech as it is told, frame by frame; then of silence."""

    def __init__(self, *parts: tuple[float, int]) -> None:
        self._parts = [probability for probability, frames in parts for _ in range(frames)]
        self._left: list[float] = []

    def reset(self) -> None:
        self._left = list(self._parts)

    def probability(self, samples: np.ndarray) -> float:
        return self._left.pop(0) if self._left else 0.0


class Glances(Asked):
    """The same; what it glances at is a sentence that is clear, or is not."""

    def __init__(self, text: str, *, clear: bool = True) -> None:
        super().__init__(text)
        self.clear = clear
        self.glances: list[int] = []

    def glance(self, samples: np.ndarray) -> Transcript:
        self.glances.append(round(samples[-1] * 1000))
        return Transcript(self.text, free_text=self.text, gap=0.0, confidence=1.0, draft=not self.clear)


@pytest.mark.parametrize(
    ("faded", "glanced_at", "decoded_at"),
    [(0, [], [35]), (1, [35], []), (4, [35], []), (5, [35], [40]), (9, [35], [44])],
    ids=["at once silent", "nearly", "a little", "for long", "for longer"],
)
def test_what_is_clear_while_the_voice_fades_is_done(listen, faded, glanced_at, decoded_at):
    """Unless it faded for so long that a quiet word may have been its end."""
    recognizer = Glances("turn left ninety degrees")
    voice = Probabilities((0.0, 15), (0.9, 20), (0.5, faded))
    found = listen(numbered(100), recognizer, voice=voice, noise_filter=None)
    assert recognizer.glances == glanced_at
    assert [last for _, last in recognizer.sounds] == decoded_at
    (done,) = found.of(HeardKind.SUBMITTED)
    # 64 ms after the voice began to fade, and not before it is low.
    assert done.time == pytest.approx((max(35 + faded, 36) + 1) * FRAME_SECONDS)


@pytest.mark.parametrize(
    ("text", "over_at"),
    [("turn left ninety degrees", 36), ("turn left", 46)],
    ids=["nothing can change", "could go on"],
)
def test_what_nothing_can_change_does_not_wait_until_the_voice_is_gone(listen, text, over_at):
    """In noise the detector is not sure of that for long: here it holds a low voice for speech for eight frames."""
    voice = Probabilities((0.0, 15), (0.9, 20), (0.55, 1), (0.45, 8))
    (done,) = listen(numbered(100), Glances(text), voice=voice, noise_filter=None).of(HeardKind.SUBMITTED)
    assert done.time >= (over_at + 1) * FRAME_SECONDS - 1e-9
    assert (done.time < 40 * FRAME_SECONDS) is (over_at < 40)


@pytest.mark.parametrize(
    ("text", "clear"),
    [("turn left ninety degrees", False), ("turn left", True), ("put down the cup", True), ("nice weather", True)],
    ids=["not clear", "could go on, and be put right", "could go on", "no command"],
)
def test_all_else_is_heard_with_its_last_sounds(listen, text, clear):
    recognizer = Glances(text, clear=clear)
    voice = Probabilities((0.0, 15), (0.9, 20), (0.5, 2))
    listen(numbered(100), recognizer, voice=voice, noise_filter=None)
    assert recognizer.glances == [35]
    assert [last for _, last in recognizer.sounds] == [37]


def test_a_voice_that_comes_back_is_heard_anew(listen):
    recognizer = Glances("turn left ninety degrees")
    voice = Probabilities((0.0, 15), (0.9, 20), (0.5, 2), (0.9, 10))
    found = listen(numbered(100), recognizer, voice=voice, noise_filter=None)
    assert recognizer.glances == [35]
    assert [last for _, last in recognizer.sounds] == [47]
    assert len(found.of(HeardKind.SUBMITTED)) == len(found.of(HeardKind.OUTDATED)) == 1


@settings(max_examples=60, deadline=None)
@given(
    parts=st.lists(st.tuples(st.sampled_from([0.1, 0.5, 0.9]), st.integers(1, 12)), max_size=20),
    text=st.sampled_from(["turn left ninety degrees", "turn left", "nice weather"]),
    clear=st.booleans(),
)
def test_a_glance_changes_when_and_never_what(engine, parts, text, clear):
    """However a voice fades and comes back, unless it was low meanwhile: as many utterances, and as many are done."""

    def done(recognizer) -> list[HeardKind]:
        events = []
        clock = VirtualClock()
        with Executor(SimulatedRobot(clock), clock=clock) as executor:
            voice = Probabilities((0.0, 5), *parts)
            runtime = Runtime(engine, executor, recognizer, voice=voice, noise_filter=None, on_event=events.append)
            runtime.run(Frames(framed(numbered(300))))
        return [one.kind for one in events if one.kind not in (HeardKind.PARTIAL, HeardKind.OUTDATED)]

    assert done(Glances(text, clear=clear)) == done(Asked(text))
