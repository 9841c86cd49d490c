"""What the nodes say. No ROS is needed for it."""

from __future__ import annotations

import json

import jsonschema
import pytest

from intent_engine.actions import Custom, Move, Navigate, Pick, Stop, to_json
from intent_engine.engine import IntentEngine
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.interpretation import Interpretation, Status
from intent_engine.ros2.messages import (
    CommandForm,
    action_message_schema,
    action_text,
    command_texts,
    event_text,
    interpretation_text,
)
from intent_engine.ros2.speech import worth_saying
from intent_engine.runtime.amending import in_a_row
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.recognizer import Transcript


@pytest.mark.parametrize(
    ("text", "tutorial"),
    [
        ("go to the kitchen", ["navigate:go to the kitchen"]),
        ("stop", ["stop:stop"]),
        (
            "go to the kitchen then turn left",
            ["navigate:go to the kitchen then turn left", "turn:go to the kitchen then turn left"],
        ),
        ("don't go to the kitchen", []),
        ("the weather is nice", []),
        ("go to the", []),
    ],
)
def test_command(engine, text, tutorial):
    found = engine.parse(text)
    assert command_texts(found, CommandForm.TUTORIAL) == tutorial
    as_json = command_texts(found, CommandForm.JSON)
    assert [json.loads(each) for each in as_json] == ([found.to_json()] if tutorial else [])


def test_status_of_what_was_heard(engine):
    data = json.loads(interpretation_text(engine.parse("don't move"), 12.34567))
    assert (data["event"], data["time"]) == ("interpretation", 12.346)
    assert Interpretation.from_json(data["interpretation"]).status is Status.REJECTED


def test_status_of_what_is_done():
    clock = VirtualClock()
    texts = []
    with Executor(
        SimulatedRobot(clock), on_event=lambda event: texts.append(event_text(event, event.time)), handle_sigterm=False
    ) as executor:
        executor.wait(executor.submit(Move(0.5, 1.0, 2.0)))
    told = [json.loads(text) for text in texts]
    goals = [each for each in told if each["event"] == "goal"]
    assert [each["state"] for each in goals] == ["pending", "accepted", "executing", "succeeded"]
    assert goals[-1]["action"] == {"type": "move", "linear_velocity": 0.5, "distance": 1.0, "duration": 2.0}
    feedback = [each for each in told if each["event"] == "feedback"]
    assert 0.0 < feedback[0]["progress"] < 1.0


def test_those_who_do_actions_are_told_of_their_turn_and_of_what_ends_it_in_order():
    clock = VirtualClock()
    told = []

    def listen(event):
        if (text := action_text(event, {"custom", "pick"})) is not None:
            told.append(json.loads(text))

    lab = Custom("clean", {"room": "lab"})
    with Executor(
        SimulatedRobot(clock), handlers={"custom": lambda action: None}, on_event=listen, handle_sigterm=False
    ) as executor:
        executor.submit([Move(0.5, 1.0, 2.0), lab])
        clock.advance(1.0)
        assert told == []  # its turn has not come
        clock.advance(2.0)
        executor.deny([lab, Navigate("lab", 1.0, 2.0, 0.0), Pick("cup")])
        executor.deny(Move(0.5, 1.0, 2.0))  # nobody else does that
        executor.stop()
        executor.estop()
    cancel = {"type": "cancel", "actions": [to_json(lab), to_json(Pick("cup"))]}
    assert told == [to_json(lab), cancel, *[to_json(Stop())] * 3]  # the last is the end of the executor
    for each in told:
        jsonschema.validate(each, action_message_schema())
    for wrong in ({"type": "cancel"}, {**cancel, "actions": []}, {**cancel, "name": "clean"}, {"type": "clean"}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(wrong, action_message_schema())
    assert action_message_schema()["$id"] == "urn:intent-engine:ros2:action-message:1"


def test_what_the_runtime_did_not_believe_is_not_said(engine, tmp_path, root):
    believed = engine.parse("go to the kitchen")
    assert worth_saying(engine, believed)
    doubted = Interpretation("go to the kitchen", Status.REJECTED, reason="it sounded too different")
    assert not worth_saying(engine, doubted)
    assert worth_saying(engine, engine.parse("the weather is nice"))
    assert not worth_saying(engine, Interpretation(" ", Status.REJECTED))


def test_an_answer_that_the_runtime_did_not_believe_is_not_said():
    """It was not heard clearly, came late, or lacked the wake word: the other node would know nothing of that."""
    engine = IntentEngine.from_files("en", locations={"bay 3": (3.0, 0.0, 0.0), "bay 13": (13.0, 0.0, 0.0)})
    asked = engine.parse("go to bay", heard=True)
    for doubted in ("three", "the second one", "bay 13"):
        assert not worth_saying(engine, Interpretation(doubted, Status.REJECTED), asked=asked)
        assert worth_saying(engine, Interpretation(doubted, Status.REJECTED)), "where nothing is asked it does nothing"
    for other in ("yes", "no", "the weather is nice"):
        assert worth_saying(engine, Interpretation(other, Status.REJECTED), asked=asked)
    answer = engine.answer(asked, "three", heard=True)
    assert answer is not None
    assert worth_saying(engine, answer, asked=asked)


@pytest.mark.parametrize(
    ("first", "then", "one"),
    [
        ("turn left", "and then go to the kitchen", True),
        ("turn left", "go forward two meters", True),
        ("go forward", "two meters", False),  # no command by itself
        ("go forward two meters", "at half speed", False),
    ],
)
def test_two_commands_are_one_text_where_that_means_both(engine, first, then, one):
    before, after = engine.parse(first), engine.parse(then)
    both = in_a_row(engine.parse, before, after)
    assert (both is not None) is one
    if both is not None:
        assert both.actions == (*before.actions, *after.actions)


@pytest.mark.parametrize(
    ("heard", "confidence", "said"),
    [
        ("undock", 0.95, False),  # not by its name
        ("robot undock", 0.95, True),
        ("robot undock", 0.6, False),
        ("robot charge", 0.8, False),  # costs more to be wrong about
        ("robot charge", 0.95, True),
        ("robot fly away", 0.1, True),  # no command, in whichever state
        ("undock slowly", 0.95, True),
    ],
)
def test_what_means_something_in_another_state_is_said_if_it_would_be_believed_there(
    engine_of, heard, confidence, said
):
    """Whoever is given the text may know better in which state the robot is, or why it is not done."""
    engine = engine_of(
        "language: en\nwake: [robot]\nintents:\n  undock: {action: custom, requires: [docked], sentences: [undock]}\n"
        "  charge: {action: custom, requires: [docked], min_confidence: 0.9, sentences: [charge]}\n"
    )
    found = engine.parse(heard, spoken=True)
    assert found.status is not Status.ACCEPTED
    transcript = Transcript(heard, free_text=heard, confidence=confidence)
    assert worth_saying(engine, found, (), transcript) is said
    there = Judge(engine).meaning(transcript, ("docked",), ())
    assert worth_saying(engine, there, ("docked",), transcript) is said


def test_what_lacks_the_wake_word_is_not_said(engine_of):
    engine = engine_of(
        'language: en\nwake: [robot]\nintents:\n  halt:\n    action: stop\n    sentences: ["freeze now"]\n'
    )
    heard = engine.parse("freeze now", spoken=True)
    if heard.status is not Status.ACCEPTED:  # a stop may need no wake word
        assert not worth_saying(engine, heard)
    assert worth_saying(engine, engine.parse("robot freeze now", spoken=True))
