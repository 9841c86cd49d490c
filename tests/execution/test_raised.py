"""What is no ordinary error of a robot: `sys.exit()`, a cancelled coroutine, an error that cannot say what it is."""

from __future__ import annotations

import asyncio
import threading

import pytest

from intent_engine import Executor, Move
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.testing import RecordingRobot, VirtualClock


class OwnError(BaseException):
    pass


class UnspeakableError(Exception):
    def __str__(self) -> str:
        raise RuntimeError("no words")


class Failing(RecordingRobot):
    """Raises in one method, once it is told to."""

    method = ""
    error: type[BaseException] = Exception

    def _fail(self, method):
        if method == self.method:
            raise self.error

    def velocity(self, linear, angular, valid_for):
        self._fail("velocity")
        super().velocity(linear, angular, valid_for)

    def stop(self):
        super().stop()
        self._fail("stop")

    def pose(self):
        self._fail("pose")
        return super().pose()


ERRORS = [SystemExit, asyncio.CancelledError, GeneratorExit, OwnError, KeyboardInterrupt, UnspeakableError]
FORWARD = Move(linear_velocity=0.5, distance=0.02, duration=0.04)


def _in_a_thread(work):
    """What a program does in another thread than its main one."""
    thread = threading.Thread(target=work)
    thread.start()
    thread.join(60)
    assert not thread.is_alive()


@pytest.mark.parametrize("method", ["velocity", "pose", "stop"])
@pytest.mark.parametrize("error", ERRORS)
@pytest.mark.filterwarnings("error::pytest.PytestUnhandledThreadExceptionWarning")
def test_whatever_a_robot_raises_goals_end_and_the_next_is_done(error, method):
    robot = Failing()
    with Executor(robot, handle_sigterm=False) as executor:
        ends = []

        def work():
            robot.method, robot.error = method, error
            (goal,) = executor.submit(FORWARD)
            ends.append(goal.result(timeout=30).state)
            executor.stop()
            robot.method = ""
            (goal,) = executor.submit(FORWARD)
            ends.append(goal.result(timeout=30).state)

        _in_a_thread(work)
        assert ends == [GoalState.ABORTED if method == "velocity" else GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert robot.at_rest


@pytest.mark.parametrize("error", ERRORS)
def test_the_goal_says_what_was_raised(error):
    clock = VirtualClock()
    robot = Failing(clock)
    goals = []

    def work():
        with Executor(robot, clock=clock, handle_sigterm=False) as executor:
            robot.method, robot.error = "velocity", error
            goals.extend(executor.submit(FORWARD))
            clock.run_until_idle()

    _in_a_thread(work)
    assert (goals[0].state, goals[0].reason, goals[0].detail) == (
        GoalState.ABORTED,
        Reason.ROBOT_ERROR,
        error.__name__,
    )


@pytest.mark.parametrize("method", ["velocity", "pose", "stop"])
def test_ctrl_c_in_the_main_thread_is_the_programs_own_and_leaves_zero(method):
    clock = VirtualClock()
    robot = Failing(clock)
    executor = Executor(robot, clock=clock, handle_sigterm=False)
    robot.error = KeyboardInterrupt
    executor.submit(Move(linear_velocity=0.5, distance=2.0, duration=4.0))
    clock.advance(1.0)
    robot.method = method
    with pytest.raises(KeyboardInterrupt):
        (executor.stop if method == "stop" else lambda: clock.advance(1.0))()
    robot.method = ""
    executor.close()
    assert robot.at_rest
