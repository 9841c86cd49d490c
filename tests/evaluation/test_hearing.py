"""Recordings through the real runtime: times that count the decode, and whatever a recogniser does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import soundfile
from continuing_stage import Script, Voiced

from intent_engine.evaluation.hearing import Listener, _Notes
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.labels import Expected, Row
from intent_engine.evaluation.scoring import Condition, Verdict
from intent_engine.evaluation.sound import Noise, SamplesSource, load
from intent_engine.evaluation.trial import Trial, scores
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.runtime.heard import Heard, HeardKind
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

DECODE = 0.4


class Scripted:
    """A recogniser that says what it was told to, as a slow one would."""

    def __init__(self, *texts: str | Exception) -> None:
        self.texts = list(texts)

    def transcribe(self, samples, *, final: bool = True) -> Transcript:
        text = self.texts[0] if len(self.texts) == 1 else self.texts.pop(0)
        if isinstance(text, Exception):
            raise text
        return Transcript(text, free_text=text, decode_seconds=DECODE)

    def close(self) -> None:
        pass


@pytest.fixture(scope="module")
def rows(root, engine) -> list[Row]:
    return read_labels(root / "examples" / "ten_commands" / "labels.jsonl", engine)


@pytest.fixture(scope="module")
def robot(root):
    return load_robot(root / "robots" / "simulated.yaml")


def test_an_act_comes_after_its_decode(engine, rows, robot):
    listener = Listener(engine, Scripted("go to the kitchen"), robot)
    hearing = listener.hear(SamplesSource(load(rows[2])))
    (act,) = hearing.acts
    assert act.meaning.intent == "navigate"
    # The first silent frame follows the last of speech; it asked for the decode that was acted on.
    assert act.time - act.speech_ended >= FRAME_SECONDS + DECODE
    assert act.time - act.speech_ended < DECODE + 0.8
    asked = (act.time - DECODE) / FRAME_SECONDS
    assert asked == pytest.approx(round(asked)), "asked for at a frame, and taken up at once"


def test_recordings_do_not_know_of_each_other(engine, rows, robot):
    """The robot that was told to drive is not the one that hears the next recording."""
    listener = Listener(engine, Scripted("go forward", "whoa there", "go forward"), robot)
    first, second, third = (listener.hear(SamplesSource(load(rows[0]))) for _ in range(3))
    assert first.actions == third.actions
    assert second.texts == ["whoa there"]
    assert [heard.text for heard in second.transcripts] == second.texts


def test_a_recogniser_that_fails_is_told_and_the_next_recording_heard(engine, rows, robot):
    listener = Listener(engine, Scripted(RuntimeError("out of memory"), "turn left"), robot)
    failed = listener.hear(SamplesSource(load(rows[0])))
    assert not failed.acts
    assert any("out of memory" in error for error in failed.errors)
    assert [act.meaning.intent for act in listener.hear(SamplesSource(load(rows[0]))).acts] == ["turn"]


def test_silence_and_noise_alone_do_nothing(engine, robot):
    listener = Listener(engine, Scripted("go forward"), robot)
    assert listener.hear(SamplesSource(np.zeros(0, np.float32))).acts == []
    assert listener.hear(SamplesSource(np.zeros(32_000, np.float32))).acts == []


def test_conditions_go_from_quiet_to_loud_and_are_scored_apart(engine, rows, robot, tmp_path):
    chance = np.random.default_rng(1)
    soundfile.write(tmp_path / "noise.wav", chance.normal(0, 0.1, 16_000), 16_000)
    trial = Trial(Noise.read([tmp_path / "noise.wav"]), [6.0, 24.0, 6.0])
    assert trial.conditions("a") == [Condition("a"), Condition("a", 24.0), Condition("a", 6.0)]
    listener = Listener(engine, Scripted("go forward two meters"), robot)
    heard = list(trial.hear(rows[:2], listener, "a"))
    assert [len(outcomes) for outcomes in heard] == [3, 3]
    assert [outcome.verdict for outcomes in heard for outcome in outcomes[:1]] == [Verdict.RIGHT, Verdict.WRONG]
    assert [found.noise for found in scores(outcome for outcomes in heard for outcome in outcomes)] == [
        "none",
        "24 dB",
        "6 dB",
    ]
    assert Trial(None, [6.0]).conditions("a") == [Condition("a")]


def test_a_command_in_which_nothing_can_be_heard_is_doubted(engine, rows, robot, tmp_path):
    """As of 16-bit samples that were taken for 32-bit ones, or of two channels that cancel each other."""
    chance = np.random.default_rng(1)
    soundfile.write(tmp_path / "bit.wav", chance.integers(-1, 1, 16_000).astype(np.int16), 16_000)
    sound = chance.normal(0, 0.1, 44_100)
    soundfile.write(tmp_path / "against.wav", np.stack([sound, -sound], axis=1), 44_100)
    soundfile.write(tmp_path / "quiet.wav", sound * 0.001, 44_100)
    names = ("bit", "against", "quiet")
    silent = [replace(rows[0], id=name, audio=tmp_path / f"{name}.wav") for name in names]
    no_command = replace(silent[0], expected=Expected())
    doubted = []
    trial = Trial(doubt=lambda row: doubted.append(row.id))
    list(trial.hear([*silent, no_command], Listener(engine, Scripted(""), robot), "a"))
    assert doubted == ["bit", "against"]


@pytest.mark.parametrize(("states", "done"), [((), False), (("docked",), True)])
def test_a_robot_may_be_in_a_state_all_the_time(engine_of, rows, robot, states, done):
    dock = engine_of("intents: {leave: {action: stop, requires: [docked], sentences: [let us leave]}}")
    listener = Listener(dock, Scripted("let us leave"), robot, states=states)
    assert bool(listener.hear(SamplesSource(load(rows[2]))).acts) is done


TWO_PLACES = """
language: en
slots: {room: [hall, office]}
intents:
  go: {action: custom, sentences: ["go to the {room}"], then: ["to the {room}"]}
"""


def test_actions_of_the_users_own_are_done_and_may_be_gone_on_from(engine_of, robot):
    script = Script("go to the hall", "and then to the office", "go to the hall and then to the office")
    listener = Listener(engine_of(TWO_PLACES), script, robot, voice=Voiced((0.5, 0.9), (1.2, 2.1)))
    hearing = listener.hear(SamplesSource(np.zeros(int(4.0 * SAMPLE_RATE), np.float32)))
    assert [action.slots["room"] for action in hearing.acts[-1].meaning.actions] == ["hall", "office"]


class InTurn:
    """A recogniser that says one text after the other, whatever it is given, with what it decodes anew in its place."""

    def __init__(self, *texts: str) -> None:
        self._texts = list(texts)

    def transcribe(self, samples, *, final: bool = True) -> Transcript:
        text = self._texts.pop(0)
        return Transcript(text, 0.0, text, gap=0.0)

    def close(self) -> None: ...


def test_what_a_command_goes_on_from_is_counted_once_whatever_was_said_between(engine, robot):
    """The whole is heard from its first word on: with the command that it begins with, and all that came since."""
    spans = Voiced((0.5, 0.9), (1.6, 1.9), (2.6, 3.4))
    script = InTurn("turn left", "hmm", "turn left hmm", "ninety degrees", "turn left ninety degrees")
    listener = Listener(engine, script, robot, voice=spans, speculate=False, noise_filter=None)
    hearing = listener.hear(SamplesSource(np.zeros(int(6.0 * SAMPLE_RATE), np.float32)))
    assert hearing.texts == hearing.free_texts == ["turn left ninety degrees"]
    assert [heard.text for heard in hearing.transcripts] == hearing.texts
    assert [act.meaning.text for act in hearing.acts] == hearing.texts


def test_what_is_put_right_after_a_stop_counts_as_one_command(engine):
    """ "Turn left" ... "no, wait!" ... "turn right": a turn to the right was meant, and was said once."""
    notes = _Notes(None, leaves=False)
    whole = "turn left no wait turn right"
    for text, goes_on in (("turn left", False), ("no wait", False), (whole, True)):
        meaning, transcript = engine.parse(text), Transcript(text, 0.0, text)
        assert meaning.actions
        told = {"interpretation": meaning, "goes_on": goes_on}
        notes.take(Heard(HeardKind.TRANSCRIPT, 1.0, transcript=transcript, goes_on=goes_on))
        notes.take(Heard(HeardKind.INTERPRETATION, 1.0, **told))
        notes.take(Heard(HeardKind.SUBMITTED, 1.0, **told))
    assert notes.hearing.texts == notes.hearing.free_texts == [whole]
    assert notes.hearing.actions == engine.parse("turn right").actions


def test_a_decode_counts_once_whichever_of_its_texts_is_told_in_the_end(engine):
    """What is no command, and what answers a question, is told as it was heard freely."""
    notes, decoded = _Notes(None, leaves=False), Transcript("turn left", 0.0, "turn lift", decode_seconds=DECODE)
    meaning = engine.parse("turn left")
    notes.take(Heard(HeardKind.PARTIAL, 1.0, transcript=decoded, speech_ended=0.9))
    notes.take(Heard(HeardKind.TRANSCRIPT, 1.5, transcript=decoded.as_heard(), speech_ended=0.9))
    notes.take(Heard(HeardKind.INTERPRETATION, 1.5, interpretation=meaning, speech_ended=0.9))
    notes.take(Heard(HeardKind.SUBMITTED, 1.5, interpretation=meaning, speech_ended=0.9))
    assert notes.hearing.decodes == [DECODE]
    assert [act.time for act in notes.hearing.acts] == [1.5], "it was there 1.4 s after the sound began"
