"""An answer by voice to what was asked back: done if it was heard clearly and in time, else nothing is."""

from __future__ import annotations

import numpy as np
import pytest
from continuing_stage import ENGINE, Frames, Knows, Said, Script, Talk, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.actions import Action, Navigate, Place, Turn
from intent_engine.execution.clock import VirtualClock
from intent_engine.interpretation import Interpretation, Status
from intent_engine.runtime import Heard, HeardKind
from intent_engine.runtime.answering import Answering
from intent_engine.runtime.continuing import ONE_SENTENCE
from intent_engine.runtime.judgement import Judge
from intent_engine.runtime.last_asked import QUESTION_LASTS
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY, ENOUGH_FOR_AN_ANSWER, SURE_ENOUGH, WORTH_ASKING

APART = ONE_SENTENCE + 0.2
"""s after which an utterance is by itself."""


def bays(*names: str, wake: tuple[str, ...] = ()) -> IntentEngine:
    return IntentEngine.from_files("en", locations=dict.fromkeys(names, (1.0, 0.0, 0.0)), wake=wake)


BAYS = bays("bay 3", "bay 13", "kitchen")


def given(said: Talk) -> list[list[Action]]:
    """What the robot was given to do, by utterance."""
    return [[goal.action for goal in event.goals] for event in said.done]


def places(said: Talk) -> list[str]:
    return [action.location for one in given(said) for action in one if isinstance(action, Navigate)]


@pytest.mark.parametrize("pause", [0.8, APART, 5.0])
@pytest.mark.parametrize("answer", ["bay three", "three", "the first one", "yes, three"])
def test_an_answer_is_done(answer, pause):
    said = Talk("go to bay", answer, engine=BAYS, pause=pause)
    assert places(said) == ["bay 3"]
    assert said.last.interpretation.text == "go to bay 3"
    assert said.last.transcript.text == answer


@pytest.mark.parametrize("answer", ["yes", "no", "neither", "bay", "thirty", "what a nice day", "kitchen"])
def test_what_tells_none_does_nothing(answer):
    assert not given(Talk("go to bay", answer, engine=BAYS, pause=APART))


def test_an_answer_that_comes_late_is_none():
    assert places(Talk("go to bay", "three", engine=BAYS, pause=QUESTION_LASTS - 0.5))
    assert not given(Talk("go to bay", "three", engine=BAYS, pause=QUESTION_LASTS + 0.5))
    assert not given(Talk("go to bay", "three", engine=BAYS, pause=20.0))


def test_who_is_asked_again_may_answer_again():
    assert places(Talk("go to bay", "thirty", "three", engine=BAYS, pause=APART)) == ["bay 3"]


def test_what_was_said_between_ends_the_question():
    for between in ("no", "what a nice day", "turn left", "stop"):
        assert not places(Talk("go to bay", between, "three", engine=BAYS, pause=APART)), between


def test_another_command_is_no_answer():
    assert places(Talk("go to bay", "go to the kitchen", engine=BAYS, pause=APART)) == ["kitchen"]


def test_an_unfinished_sentence_is_finished():
    said = Talk("go to", "the kitchen", engine=BAYS, pause=APART)
    assert places(said) == ["kitchen"]


def test_what_follows_an_answer_may_belong_to_it():
    said = Talk("go to bay", "three", "and then turn left", engine=BAYS)
    assert places(said) == ["bay 3"]
    assert isinstance(given(said)[-1][0], Turn)


def test_again_is_what_was_done_before_the_question_or_what_was_answered():
    said = Talk("turn left", "go to bay", "again", engine=BAYS, pause=APART)
    assert [type(one[0]) for one in given(said)] == [Turn, Turn]
    assert places(Talk("go to bay", "three", "again", engine=BAYS, pause=APART)) == ["bay 3", "bay 3"]


def test_with_a_wake_word_an_answer_begins_with_it():
    robot = bays("bay 3", "bay 13", wake=("robot",))
    assert places(Talk("robot, go to bay", "robot, three", engine=robot, pause=APART)) == ["bay 3"]
    assert not given(Talk("robot, go to bay", "three", engine=robot, pause=APART))
    assert not given(Talk("go to bay", "robot, three", engine=robot, pause=APART))


@pytest.mark.parametrize("stopped", [False, True])
def test_a_robot_that_was_stopped_by_hand_takes_no_answer(stopped):
    clock = VirtualClock()
    done: list[Heard] = []

    def heard(event: Heard) -> None:
        if event.kind is HeardKind.SUBMITTED:
            done.append(event)
        if event.kind is HeardKind.INTERPRETATION and stopped:
            executor.stop()
            executor.settle()

    samples = np.zeros(8 * SAMPLE_RATE, np.float32)
    for at, begin in enumerate((0.6, 3.6), 1):
        samples[int(begin * SAMPLE_RATE) : int((begin + 0.6) * SAMPLE_RATE)] = at / 1000
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        recognizer, voice = Knows("go to bay", "three"), Voiced((0.5, 1.3), (3.5, 4.3))
        runtime = Runtime(BAYS, executor, recognizer, voice=voice, noise_filter=None, on_event=heard)
        runtime.run(Frames(framed(samples)))
        executor.wait()
    assert len(done) == (not stopped)


class Unreset(Voiced):
    """A voice detector that knows what time it is after a gap."""

    def reset(self) -> None: ...


@pytest.mark.parametrize("lost", [0.0, 0.5])
def test_where_sound_was_lost_nothing_is_answered(lost):
    """A "no" may be what is missing."""
    script = Script("go to bay", "bay three", "go to bay, bay three")
    said = Said(script, pause=1.1, engine=BAYS, lost=lost, voice=Unreset((0.5, 0.9), (2.0, 2.9)))
    assert [event.transcript.text for event in said.events if event.kind is HeardKind.INTERPRETATION][1] == "bay three"
    assert len(said.done) == (not lost)


# -- how it was heard --------------------------------------------------------------------------------------------------


def answer(engine: IntentEngine, asks: str, text: str, score: float = 0.0, **heard: object) -> Interpretation | None:
    """What words answer that a recogniser heard, and for which it found no sentence."""
    asked, found = engine.parse(asks, last=()), engine.parse(text, spoken=True)
    return Answering(engine).answer(asked, Transcript(text, score, text, **heard), found, ())


def test_an_answer_must_be_heard_clearly():
    assert answer(BAYS, "go to bay", "three", ENOUGH_FOR_AN_ANSWER).actions
    hardly = answer(BAYS, "go to bay", "three", ENOUGH_FOR_AN_ANSWER - 0.01)
    assert (hardly.actions, hardly.alternatives) == ((), ("bay 3", "bay 13"))
    assert hardly.question is not None, "it is asked again"
    assert "not heard clearly" in hardly.reason
    assert not answer(BAYS, "go to bay", "three", unclear=("three",)).actions


def test_the_rest_of_a_sentence_that_was_not_heard_clearly_may_be_said_again():
    found, heard = BAYS.parse("the kitchen", spoken=True), Transcript("the kitchen", CLEARLY - 0.01, "the kitchen")
    asked = BAYS.parse("go to", last=())
    again = Answering(BAYS).answer(asked, heard, found, ())
    assert (again.text, again.actions) == ("the kitchen", ())
    clearly = Answering(BAYS).answer(again, Transcript("the kitchen", 0.0, "the kitchen"), found, ())
    assert clearly.actions == BAYS.parse("go to the kitchen").actions


def test_a_number_that_sounds_like_another_answer_is_asked_again():
    alike = bays("bay 30", "bay 13")
    assert "sounds like" in answer(alike, "go to bay", "thirteen").reason
    assert answer(alike, "go to bay", "the second one").actions
    assert answer(BAYS, "go to bay", "thirteen").actions, "there is no thirty to be meant"
    assert not answer(ENGINE, "go forward", "thirteen meters")


def test_an_answer_that_sounds_like_another_is_asked_again():
    """Of "the left one" a recogniser wrote "the last one"."""
    doors = bays("left door", "right door")
    found = answer(doors, "go to the door", "the last one")
    assert (found.actions, found.alternatives) == ((), ("left door", "right door"))
    assert "sounds like" in found.reason
    assert answer(doors, "go to the door", "the left one").actions
    assert answer(doors, "go to the door", "the right one").actions
    assert answer(doors, "go to the door", "the second one").actions


def test_no_is_taken_however_it_was_heard():
    assert answer(BAYS, "go to bay", "no", ENOUGH_FOR_AN_ANSWER - 1.0).status is Status.REJECTED


@pytest.fixture(scope="module")
def judge() -> Judge:
    return Judge(BAYS)


def asked_by(judge: Judge, text: str, **heard: object) -> Interpretation:
    return judge.meaning(Transcript(text, 0.0, heard.pop("free_text", text), **heard), (), ())


def test_what_was_perhaps_heard_is_confirmed_by_a_yes(judge):
    perhaps = asked_by(judge, "turn left", free_text="torn left", confidence=SURE_ENOUGH - 0.1)
    assert perhaps.alternatives == ("turn left",)
    found = BAYS.parse("yes", spoken=True)
    yes = Answering(BAYS).answer(perhaps, Transcript("yes", 0.0, "yes"), found, ())
    assert [type(action) for action in yes.actions] == [Turn]
    no = Answering(BAYS).answer(perhaps, Transcript("no", 0.0, "no"), found, ())
    assert not no.actions


def test_of_two_ways_a_yes_tells_none(judge):
    heard = Transcript(
        "turn left", -0.9, "torn left", gap=0.4, confidence=0.95, alternatives=("turn right",), behind=(0.5,)
    )
    either = judge.meaning(heard, (), ())
    assert either.alternatives == ("turn left", "turn right")
    nothing = BAYS.parse("yes", spoken=True)
    assert not Answering(BAYS).answer(either, Transcript("yes", 0.0, "yes"), nothing, ()).actions
    second = Answering(BAYS).answer(either, Transcript("the second", 0.0, "the second"), nothing, ())
    assert second.actions == BAYS.parse("turn right").actions


@pytest.mark.parametrize(
    ("text", "heard"),
    [
        ("go to bay", {"confidence": SURE_ENOUGH - 0.1}),
        ("go to bay", {"left_out": ("do not",)}),
        ("go to bay", {"unclear": ("bay",)}),
        ("turn left", {"confidence": WORTH_ASKING - 0.1}),
        ("turn left", {"left_out": ("do not",)}),
        ("that is a left turn", {}),
    ],
)
def test_what_was_hardly_heard_and_talk_ask_nothing_that_an_answer_could_do(judge, text, heard):
    found = asked_by(judge, text, **heard)
    assert not found.actions
    assert found.question is None


def test_what_may_be_the_answer_or_a_command_is_asked_again():
    doors = bays("left door", "right door")
    for answer in ("left", "right"):
        said = Talk("go to the door", answer, engine=doors, pause=APART)
        assert not given(said), answer
        assert "may be a command" in said.last.interpretation.reason
    assert places(Talk("go to the door", "left", "the left one", engine=doors, pause=APART)) == ["left door"]


def test_what_is_not_meant_is_asked_about_no_more():
    assert not given(Talk("go to bay", "not bay three", "three", engine=BAYS, pause=APART))
    for answer in ("thirteen", "yes"):
        assert places(Talk("go to bay", "not bay three", answer, engine=BAYS, pause=APART)) == ["bay 13"]


def test_no_to_a_question_takes_back_nothing_that_was_done_before_it():
    said = Talk("pick up the cup", "go to bay", "no", "put it on the table", engine=BAYS, pause=APART)
    assert given(said)[-1] == [Place("cup", "table")]


def test_an_answer_may_be_corrected():
    assert places(Talk("go to bay", "three, no, thirteen", engine=BAYS, pause=APART)) == ["bay 13"]


def test_numbers_that_sound_alike_are_those_of_the_language(engine_of):
    """Of "zwei" a model makes "drei", and neither is an English number."""
    halls = engine_of(
        "language: de\nslots: {ort: {type: location}}\nintents:\n"
        "  fahr: {action: {type: navigate, location: '{ort}'}, sentences: ['fahr zu {ort}']}\n",
        locations={"halle zwei": (1.0, 0.0, 0.0), "halle drei": (2.0, 0.0, 0.0), "halle neun": (3.0, 0.0, 0.0)},
    )
    found = answer(halls, "fahr zu halle", "zwei")
    assert "sounds like" in found.reason
    assert answer(halls, "fahr zu halle", "neun").actions
