"""Waiting for goals, without an executor."""

from __future__ import annotations

import threading

import pytest

from intent_engine.actions import Stop
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.execution.goal import Goal, GoalState, move_goal
from intent_engine.execution.waiting import Waiting


def goal(ended: bool) -> Goal:
    made = Goal(Stop(), 0.0)
    if ended:
        move_goal(made, GoalState.REJECTED, 0.0)
    return made


@pytest.mark.parametrize("clock", [VirtualClock, MonotonicClock])
def test_what_has_ended_is_not_waited_for(clock):
    waiting = Waiting(clock(), threading.Condition(), lambda: True)
    assert waiting.wait([goal(True)], None)
    assert waiting.wait([], None)
    assert waiting.wait(None, 0.0)
    waiting.wait_for(goal(True), None)


@pytest.mark.parametrize("timeout", [None, 3.0])
def test_a_clock_on_which_nothing_is_due_ends_it(timeout):
    waiting = Waiting(VirtualClock(), threading.Condition(), lambda: False)
    assert not waiting.wait([goal(False)], timeout)
    assert not waiting.wait(None, timeout)


def test_who_waits_for_one_is_told_that_it_has_not_ended():
    waiting = Waiting(VirtualClock(), threading.Condition(), lambda: False)
    with pytest.raises(TimeoutError, match="has not ended"):
        waiting.wait_for(goal(False), 1.0)


def test_another_thread_may_end_it():
    changed = threading.Condition()
    one = goal(False)
    waiting = Waiting(MonotonicClock(), changed, lambda: False)

    def end() -> None:
        with changed:
            move_goal(one, GoalState.REJECTED, 0.0)
            changed.notify_all()

    with changed:
        thread = threading.Thread(target=end)
        thread.start()
        assert waiting.wait([one], 30.0)
    thread.join()
