"""What was asked for before a stop does not begin after it, however late it comes."""

from __future__ import annotations

import signal
import threading

import pytest

from intent_engine import Custom, Executor, Goal, GoalState, Move, Reason, Stop
from intent_engine.execution import goal as goals_module
from intent_engine.execution.goal import Times
from intent_engine.testing import RecordingRobot

LONG = Move(0.5, 50.0, 100.0)
SHORT = Move(0.5, 0.02, 0.04)


def outcome(goal: Goal) -> tuple[GoalState, Reason]:
    return goal.state, goal.reason


@pytest.mark.parametrize("end", ["stop", "estop"])
def test_a_stop_while_actions_are_still_being_submitted_is_kept(stage, end):
    s = stage()

    def slowly():
        yield LONG
        getattr(s.executor, end)()
        s.executor.reset()

    (goal,) = s.executor.submit(slowly())
    assert outcome(goal) == (GoalState.REJECTED, Reason.STOP)
    s.clock.advance(1.0)
    assert s.robot.pose().x == 0.0
    assert s.executor.submit(SHORT)[0].result().succeeded


@pytest.mark.parametrize(("at", "state"), [(2, GoalState.REJECTED), (3, GoalState.CANCELED)], ids=["made", "accepted"])
def test_a_signal_handler_may_stop_while_a_goal_is_made_or_accepted(stage, monkeypatch, at, state):
    s = stage()
    seen: list[str] = []

    def interrupted(*times: float | None) -> Times:
        seen.append("time")
        if len(seen) == at:
            signal.raise_signal(signal.SIGUSR1)
        return Times(*times)

    before = signal.signal(signal.SIGUSR1, lambda number, frame: s.executor.stop())
    try:
        with monkeypatch.context() as patch:
            patch.setattr(goals_module, "Times", interrupted)
            goals = s.executor.submit([LONG, SHORT])
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert s.executor.run_until_idle()
    assert [outcome(goal) for goal in goals] == [(state, Reason.STOP)] * 2
    assert not any(write.linear for write in s.robot.written)


def test_half_of_what_was_said_is_not_done_where_ctrl_c_breaks_a_submit_off(stage, monkeypatch):
    s = stage()
    seen: list[str] = []

    def interrupted(*times: float | None) -> Times:
        seen.append("time")
        if len(seen) == 4:  # two were submitted, the first was accepted
            raise KeyboardInterrupt
        return Times(*times)

    with monkeypatch.context() as patch:
        patch.setattr(goals_module, "Times", interrupted)
        with pytest.raises(KeyboardInterrupt):
            s.executor.submit([LONG, SHORT])
    (after,) = s.executor.submit(SHORT, policy="queue")
    after.result()
    assert s.robot.pose().x == pytest.approx(0.02)


def _patrol(then: str):
    """A handler that drives twice; in between somebody stops the robot: another, or the handler itself."""
    robot = RecordingRobot()
    driven: list[Goal] = []
    driving, over = threading.Event(), threading.Event()

    def patrol(action):
        driven.extend(executor.submit(LONG))
        driving.set()
        if then == "own":
            executor.stop()
        driven[0].result(30.0)
        driven.extend(executor.submit(SHORT))
        driven[1].result(30.0)
        over.set()

    with Executor(robot, handlers={"patrol": patrol}, handle_sigterm=False) as executor:
        executor.submit(Custom("patrol"))
        assert driving.wait(30.0)
        if then == "another":
            executor.stop()
        assert over.wait(30.0)
        if then == "another":
            assert executor.submit(SHORT)[0].result(30.0).succeeded
    return [outcome(goal) for goal in driven]


def test_a_handler_that_was_stopped_begins_nothing_more():
    assert _patrol("another") == [(GoalState.CANCELED, Reason.STOP), (GoalState.REJECTED, Reason.STOP)]


def test_a_handler_goes_on_after_its_own_stop():
    assert _patrol("own") == [(GoalState.CANCELED, Reason.STOP), (GoalState.SUCCEEDED, Reason.NONE)]


@pytest.mark.parametrize(
    ("spoken", "stopped", "done"),
    [(1.5, None, False), (2.0, None, True), (1.5, 1.0, True), (0.5, 1.0, False), (None, None, True), (2.5, 9.0, True)],
)
def test_words_from_before_a_stop_are_too_late_after_it(stage, spoken, stopped, done):
    s = stage()
    s.clock.advance(2.0)
    s.executor.stop(spoken_at=stopped)
    s.clock.advance(0.5)
    (goal,) = s.executor.submit(SHORT, spoken_at=spoken)
    if done:
        assert goal.result().succeeded
    else:
        assert outcome(goal) == (GoalState.REJECTED, Reason.STOP)
        assert goal.detail == "it was said before the last stop; say it again"


def test_a_stop_that_comes_first_does_not_reject_what_was_said_with_it(stage):
    s = stage()
    s.clock.advance(2.0)
    goals = s.executor.submit([Stop(), SHORT], spoken_at=1.0)
    assert goals[-1].result().succeeded


@pytest.mark.parametrize(("wrong", "error"), [("now", TypeError), (float("nan"), ValueError)])
def test_a_stop_at_a_wrong_time_stops_before_it_is_told(stage, wrong, error):
    s = stage()
    (goal,) = s.executor.submit(LONG)
    with pytest.raises(error, match="spoken_at"):
        s.executor.stop(spoken_at=wrong)
    assert outcome(goal) == (GoalState.CANCELED, Reason.STOP)
