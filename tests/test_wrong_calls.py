"""Wrong calls from Python are told as what they are, before a robot is without limits or a source is read."""

from __future__ import annotations

import pytest

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.errors import AudioError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.limits import Limits
from intent_engine.speech.sources.stream import StreamSource
from intent_engine.testing import sentences


@pytest.fixture
def executor():
    clock = VirtualClock()
    with Executor(SimulatedRobot(clock), clock=clock) as one:
        yield one


@pytest.mark.parametrize("limits", [{}, {"linear_velocity": 0.5}, "robots/turtlebot3.yaml", 0.5])
def test_what_are_no_limits_limits_nothing_and_is_refused(limits):
    clock = VirtualClock()
    with pytest.raises(TypeError, match=r"limits of a robot are Limits\(linear_velocity=0\.5\)"):
        Executor(SimulatedRobot(clock), limits, clock)
    robot = SimulatedRobot(clock)
    robot.limits = limits
    with pytest.raises(TypeError, match=r"limits of a robot are Limits\("):
        Executor(robot, clock=clock)


def test_limits_of_the_robot_hold_where_none_are_given():
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    robot.limits = Limits(linear_velocity=0.2)
    with Executor(robot, clock=clock) as own, Executor(SimulatedRobot(clock), Limits(angle=1.0), clock) as given:
        assert own.limits is robot.limits
        assert given.limits == Limits(angle=1.0)


@pytest.mark.parametrize("value", ["0.5 m/s", True, [1.0]])
def test_a_limit_is_a_number(value):
    with pytest.raises(TypeError, match="the limit linear_velocity is a number in SI units, not"):
        Limits(linear_velocity=value)


def test_what_is_no_runtime(executor):
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(TypeError, match="takes an IntentEngine and then an Executor, not Executor and IntentEngine"):
        Runtime(executor, engine)
    with pytest.raises(TypeError, match=r"run takes a source of sound, not 'talk.wav': FileSource\(path\)"):
        Runtime(engine, executor, recognizer=object(), voice=object()).run("talk.wav")


@pytest.mark.parametrize("rate", ["16k", None, 16])
def test_a_rate_that_is_none(rate):
    with pytest.raises(AudioError, match="is no sample rate of sound"):
        StreamSource(rate)


def test_what_no_sentences_are_made_of():
    with pytest.raises(TypeError, match="sentences takes an IntentEngine, not 'en'"):
        sentences("en")
    engine = IntentEngine.from_files("en", locations="home")
    with pytest.raises(ValueError, match="there is no noise 'filler'; there is fillers, spelling"):
        sentences(engine, noise=["spelling", "filler"])
