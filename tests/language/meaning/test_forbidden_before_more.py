"""What is forbidden stays forbidden where more follows that is not clear, or a "no" stands before it."""

from __future__ import annotations

import pytest
from meanings import shipped
from test_commands_denied import CLEAN_LAB, GRAMMARS, grammar

from intent_engine.actions import Custom, Navigate, Pick, Turn
from intent_engine.engine import IntentEngine
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.simulated import SimulatedRobot
from intent_engine.interpretation import Status

ENGLISH = shipped()
CLEAN_HALL = Custom("clean", {"room": "hall"})


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(grammar(language)) for language in GRAMMARS}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "don't clean the lab then clean the hall"),
        ("en", "do not clean the lab and dance"),
        ("en", "no, don't clean the lab, clean the hall"),
        ("en", "no, don't clean the lab but the hall"),
        ("de", "reinige nicht das Labor, dann die Halle"),
        ("de", "reinige das Labor nicht und reinige die Halle"),
        ("de", "nein, reinige nicht das Labor, reinige die Halle"),
        ("fr", "ne nettoie pas le labo puis nettoie le hall"),
        ("fr", "non, ne nettoie pas le labo, nettoie le hall"),
        ("es", "no limpies el laboratorio y luego limpia el pasillo"),
        ("es", "no, no limpies el laboratorio, limpia el pasillo"),
        ("it", "non pulire il laboratorio poi pulisci la sala"),
        ("it", "no, non pulire il laboratorio, pulisci la sala"),
    ],
)
def test_what_is_forbidden_first_is_denied(engines, language, said):
    found = engines[language].parse(said)
    assert (found.status, found.actions, found.denied) == (Status.REJECTED, (), (CLEAN_LAB,))


@pytest.mark.parametrize("joint", [" and", " but", ","])
def test_each_that_is_forbidden_is_denied(engines, joint):
    found = engines["en"].parse(f"don't clean the lab{joint} don't clean the hall")
    assert (found.actions, found.denied) == ((), (CLEAN_LAB, CLEAN_HALL))


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "if you don't clean the lab, clean the hall"),
        ("en", "don't clean the moon then clean the hall"),
        ("en", "clean the lab, not, uh, dance"),
        ("de", "reinige das Labor, nicht, äh, tanzen"),
    ],
)
def test_nothing_else_is(engines, language, said):
    found = engines[language].parse(said)
    assert (found.actions, found.denied) == ((), ())


def test_a_longer_command_is_denied_before_a_shorter_one(engines):
    assert engines["en"].parse("don't take the cup of the lab then clean the hall").denied == (Pick("cup of the lab"),)


def test_a_robot_on_its_way_there_stops():
    robot, clock = SimulatedRobot(), VirtualClock()
    with Executor(robot, clock=clock) as executor:
        (goal,) = executor.submit(ENGLISH.parse("go to the kitchen").actions)
        found = ENGLISH.parse("do not go to the kitchen then go to the bedroom", state=["moving"])
        assert [type(action) for action in found.denied] == [Navigate]
        assert executor.deny(found.denied)
        assert goal.done


def test_a_no_before_it_stops_a_robot_that_moves_as_before():
    said = "no, don't turn left, turn right"
    assert ENGLISH.parse(said, state=["moving"]).stops
    assert [type(action) for action in ENGLISH.parse(said).denied] == [Turn]


def test_a_no_before_a_forbidden_motion_stops_whatever_was_understood_last():
    last = ENGLISH.parse("go to the kitchen")
    assert ENGLISH.parse("no, don't go to the kitchen", state=["moving"], last=last).stops
