""" "Don't clean the lab", said to a robot that cleans it."""

from __future__ import annotations

import numpy as np
import pytest
from continuing_stage import Frames, Parts, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.actions import Custom
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.goal import Goal, GoalState, Reason
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE

GRAMMAR = """
language: en
slots:
  room: {type: choice, values: {lab: [lab], hall: [hall]}}
intents:
  clean: {action: {type: custom, name: clean}, sentences: ["clean the {room}"]}
  forward: {action: {type: move, direction: forward, distance: 5 m}, sentences: [go forward]}
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory) -> IntentEngine:
    path = tmp_path_factory.mktemp("denied") / "clean.yaml"
    path.write_text(GRAMMAR, "utf-8")
    return IntentEngine.from_files(path)


def said(engine: IntentEngine, *texts: str, policies: dict[str, str] | None = None) -> tuple[list[Goal], list[Heard]]:
    """While the robot drives, and is to clean the lab when it is there; its goals, and what came of the words."""
    clock = VirtualClock()
    events: list[Heard] = []
    with Executor(SimulatedRobot(clock), clock=clock, policies=policies) as executor:
        executor.register("clean", lambda action: None)
        goals = executor.submit(engine.parse("go forward").actions)
        goals += executor.submit(Custom("clean", {"room": "lab"}), policy="queue")
        voice = Voiced(*((0.5 + 2 * count, 1.0 + 2 * count) for count in range(len(texts))))
        runtime = Runtime(engine, executor, Parts(*texts), noise_filter=None, on_event=events.append, voice=voice)
        runtime.run(Frames(framed(np.zeros(int((1 + 2 * len(texts)) * SAMPLE_RATE), np.float32))))
        executor.wait()
        assert executor.snapshot().velocity == (0.0, 0.0)
    return goals, events


def test_it_ends(engine):
    goals, events = said(engine, "don't clean the lab")
    assert [(goal.state, goal.reason) for goal in goals] == [(GoalState.CANCELED, Reason.STOP)] * 2
    (told,) = (event.interpretation for event in events if event.kind is HeardKind.INTERPRETATION)
    assert told is not None
    assert told.refuses


@pytest.mark.parametrize("text", ["don't clean the hall", "don't clean the moon", "don't worry"])
def test_what_it_does_not_do_changes_nothing(engine, text):
    goals, _ = said(engine, text)
    assert all(goal.succeeded for goal in goals)


def test_the_next_command_is_done(engine):
    _, events = said(engine, "don't clean the lab", "clean the hall")
    (done,) = (event for event in events if event.kind is HeardKind.SUBMITTED)
    assert [goal.succeeded for goal in done.goals] == [True]


@pytest.mark.parametrize("text", ["don't clean the lab, clean the hall", "clean the hall, not the lab"])
def test_it_ends_though_what_is_wanted_would_wait_its_turn(engine, text):
    goals, events = said(engine, text, policies={"clean": "queue"})
    assert goals[-1].state is GoalState.CANCELED
    (done,) = (event for event in events if event.kind is HeardKind.SUBMITTED)
    assert [goal.succeeded for goal in done.goals] == [True]
