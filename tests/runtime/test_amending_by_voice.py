"""A command that is carried out, and what is to be done when more of it is said."""

from __future__ import annotations

import threading

import pytest

from intent_engine import Executor, SimulatedRobot
from intent_engine.execution.goal import GoalState
from intent_engine.execution.policy import Policy
from intent_engine.runtime.amending import CarriedOut, Step

GRAMMAR = """
language: en
slots: {letter: [alpha, bravo]}
intents:
  waypoint: {action: {type: custom, name: waypoint}, sentences: ["proceed to waypoint {letter}"]}
"""
ALPHA = "proceed to waypoint alpha"


@pytest.mark.parametrize(
    ("more", "replaced"), [(", no, bravo", True), (" and then proceed to waypoint bravo", False), ("", False)]
)
def test_what_a_handler_still_does_is_replaced_by_a_correction(engine_of, more, replaced):
    engine, at_work = engine_of(GRAMMAR), threading.Event()

    def proceed(_action, context):
        at_work.set()
        assert context.cancelled.wait(60)

    with Executor(SimulatedRobot()) as executor:
        executor.register("waypoint", proceed)
        first, whole = engine.parse(ALPHA), engine.parse(ALPHA + more)
        goals = executor.submit(first.actions)
        assert at_work.wait(60)
        step = CarriedOut(first, tuple(goals)).step_to(whole)
        assert (step == Step(whole.actions, Policy.REPLACE, goes_on=True)) is replaced
        executor.stop()
        goals[0].result(60)
        assert goals[0].state is GoalState.CANCELED


def test_what_a_handler_has_done_stays_done_and_what_is_meant_is_done_as_well(engine_of):
    engine = engine_of(GRAMMAR)
    with Executor(SimulatedRobot()) as executor:
        executor.register("waypoint", lambda _action: None)
        first = engine.parse(ALPHA)
        goals = executor.submit(first.actions)
        goals[0].result(60)
        done, whole = CarriedOut(first, tuple(goals)), engine.parse(f"{ALPHA}, no, bravo")
        assert done.step_to(whole) == Step(whole.actions, Policy.REPLACE, goes_on=True)
