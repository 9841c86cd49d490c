"""What else a recogniser heard: told to programs with each transcript, and to people where they are asked back."""

from __future__ import annotations

import json

import numpy as np
import pytest
from speech_stage import Frames, Voiced, framed

from intent_engine import Executor, Runtime, SimulatedRobot
from intent_engine.cli.reporter import Reporter
from intent_engine.execution.clock import VirtualClock
from intent_engine.interpretation import Interpretation, Status
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

SEVERAL = Transcript(
    "turn left fifteen degrees",
    free_text="turn left fifteen degrees",
    gap=0.1,
    confidence=0.9,
    unclear=("fifteen",),
    alternatives=("turn left fifty degrees", "turn left sixteen degrees"),
    behind=(0.25, 9.0),
)


class Hears:
    """A recogniser that hears one thing."""

    def __init__(self, transcript: Transcript) -> None:
        self._transcript = transcript

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        return self._transcript

    def close(self) -> None: ...


@pytest.fixture
def told(engine, capsys):
    """What is printed when a robot hears one transcript."""

    def play(transcript: Transcript, *, as_json: bool) -> list[str]:
        clock = VirtualClock()
        robot = SimulatedRobot(clock)
        reporter = Reporter(robot, as_json=as_json)
        with Executor(robot, clock=clock, on_event=reporter.executed) as executor:
            source = Frames(framed(np.zeros(3 * SAMPLE_RATE, np.float32)))
            Runtime(
                engine,
                executor,
                Hears(transcript),
                voice=Voiced((0.5, 1.5)),
                noise_filter=None,
                on_event=reporter.heard,
            ).run(source)
        return capsys.readouterr().out.splitlines()

    return play


def of(lines: list[str], kind: str) -> dict:
    (found,) = [event for event in map(json.loads, lines) if event["event"] == kind]
    return found


def test_a_program_is_told_all_readings_the_best_first(told):
    found = of(told(SEVERAL, as_json=True), "transcript")
    assert found["text"] == "turn left fifteen degrees"
    assert found["alternatives"] == [
        {"text": "turn left fifty degrees", "behind": 0.25},
        {"text": "turn left sixteen degrees", "behind": 9.0},
    ]


def test_what_is_not_known_is_null_and_of_one_reading_there_are_no_others(told):
    unknown = Transcript("go forward", free_text="go forward", alternatives=("go backward",))
    assert of(told(unknown, as_json=True), "transcript")["alternatives"] == [{"text": "go backward", "behind": None}]
    assert of(told(Transcript("go forward"), as_json=True), "transcript")["alternatives"] == []


def test_the_sentence_that_was_not_like_the_sound_is_the_first_of_the_others(told):
    """The text is what was heard then, and the sentence would be lost."""
    unlike = Transcript(
        "turn left", free_text="burn the leaf", gap=3.0, confidence=0.1, alternatives=("turn right",), behind=(1.5,)
    )
    found = of(told(unlike, as_json=True), "transcript")
    assert found["text"] == "burn the leaf"
    assert found["alternatives"] == [{"text": "turn left", "behind": 0.0}, {"text": "turn right", "behind": 1.5}]


def test_a_person_who_is_asked_back_is_told_what_was_perhaps_said(told):
    lines = told(SEVERAL, as_json=False)
    (perhaps,) = [line for line in lines if "perhaps" in line]
    assert perhaps.split("perhaps")[1].strip() == "'turn left fifty degrees'", "the third is far behind"


@pytest.mark.parametrize(
    "transcript",
    [
        Transcript("turn left", free_text="what a day", confidence=0.01, alternatives=("stop",), behind=(0.1,)),
        Transcript("turn left", free_text="turn left", confidence=1.0, alternatives=("turn right",), behind=(0.5,)),
        Transcript("what a day", free_text="what a day"),
    ],
    ids=["no command", "done", "one reading"],
)
def test_else_nothing_of_the_kind(told, transcript):
    assert not [line for line in told(transcript, as_json=False) if "perhaps" in line]


def test_what_the_reason_names_is_not_said_twice(capsys):
    heard = Transcript("turn", confidence=0.5, alternatives=("turn left", "turn right"), behind=(0.0, 0.5))
    found = Interpretation("turn", Status.REJECTED, reason="perhaps 'turn left'", alternatives=("turn left",))
    clock = VirtualClock()
    reporter = Reporter(SimulatedRobot(clock), as_json=False)
    reporter.heard(Heard(HeardKind.INTERPRETATION, 1.0, transcript=heard, interpretation=found))
    assert capsys.readouterr().out.splitlines()[-1].split() == ["perhaps", "'turn", "right'"]


def test_readings_of_a_real_recogniser(listen, go_forward):
    """In noise several sentences may have been said."""
    noise = np.random.default_rng(3).normal(0, 0.12, go_forward.size).astype(np.float32)
    found = listen(go_forward + noise)
    transcripts = [event.transcript for event in found.of(HeardKind.TRANSCRIPT)]
    readings = [one for transcript in transcripts for one in transcript.alternatives_to_json()]
    assert readings
    for transcript in transcripts:
        behind = [one["behind"] for one in transcript.alternatives_to_json()]
        assert behind == sorted(behind)
