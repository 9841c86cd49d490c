"""What was allowed when it was asked for is asked again when its turn comes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.actions import Custom, Move, Navigate, Pick, Stop, Turn
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits

FORWARD, LEFT = Move(0.5, 1.0, 2.0), Turn(1.0, 1.0, 1.0)
KITCHEN = Navigate("kitchen", 5.0, 2.0, 0.0)
WHY = "drawers need the robot to be docked"


class Door:
    """A guard that somebody may shut meanwhile, and how often it was asked."""

    def __init__(self, why: str = "") -> None:
        self.why, self.asked = why, 0

    def __call__(self) -> str:
        self.asked += 1
        return self.why


def states(goals):
    return [goal.state.value for goal in goals]


def test_what_may_not_begin_any_more_is_not_done_nor_is_what_comes_after_it(stage):
    s, door = stage(), Door()
    goals = s.executor.submit([FORWARD, Pick("cup"), LEFT], guards=[None, door, None])
    (other,) = s.executor.submit(LEFT, policy="queue")
    s.clock.advance(1.0)
    assert door.asked == 0
    door.why = WHY
    s.executor.run_until_idle()
    assert states(goals) == ["succeeded", "aborted", "canceled"]
    assert (goals[1].reason, goals[1].detail) == (Reason.FORBIDDEN, WHY)
    assert goals[2].reason is Reason.EARLIER_FAILED
    assert goals[1].times.started is None
    assert other.succeeded, "another command waited for its turn, and not for this one to succeed"
    told = [(e.goal.id, e.state, e.reason, e.detail) for e in s.events if e.goal is goals[1] and e.state.ended]
    assert told == [(goals[1].id, GoalState.ABORTED, Reason.FORBIDDEN, WHY)]


@pytest.mark.parametrize("action", [FORWARD, KITCHEN, Custom("wave"), Pick("cup")])
def test_every_kind_of_action_is_asked_once_when_it_begins(stage, action):
    did = []
    s = stage(handlers={"wave": did.append})
    (goal,) = s.executor.submit(action, guards=[door := Door()])
    s.executor.run_until_idle()
    assert goal.succeeded
    assert door.asked == 1
    before = len(s.robot.written)
    (goal,) = s.executor.submit(action, guards=[Door(WHY)])
    s.executor.run_until_idle()
    assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.FORBIDDEN)
    assert not [each for each in s.robot.written[before:] if each.linear or each.angular]
    assert did == ([action] if isinstance(action, Custom) else [])


def test_what_cannot_be_told_is_not_done(stage, caplog):
    def nobody_knows() -> str:
        raise LookupError("the bus is off")

    s = stage()
    goals = s.executor.submit([FORWARD, LEFT], guards=[nobody_knows, None])
    s.executor.run_until_idle()
    assert states(goals) == ["aborted", "canceled"]
    assert goals[0].reason is Reason.FORBIDDEN
    assert goals[0].detail.endswith("LookupError: the bus is off")


@pytest.mark.parametrize("limits", [None, Limits(linear_acceleration=0.5, angular_acceleration=0.5)])
def test_a_motion_that_was_to_go_over_into_another_comes_to_rest(stage, limits):
    s = stage(limits)
    (first,) = s.executor.submit(Move(0.5, 50.0, 100.0))
    s.clock.advance(3.0)
    s.executor.submit(LEFT, guards=[Door(WHY)])
    s.executor.run_until_idle()
    assert first.reason is Reason.PREEMPTED
    assert s.robot.speed() == (0.0, 0.0)
    assert [(each.linear, each.angular) for each in s.robot.written[-3:]] == [(0.0, 0.0)] * 3
    assert s.clock.now() < 5.0


def test_what_is_held_is_asked_when_it_is_let_go(stage):
    s, door = stage(), Door()
    s.executor.hold()
    (goal,) = s.executor.submit(FORWARD, guards=[door])
    s.clock.advance(1.0)
    assert door.asked == 0
    door.why = WHY
    s.executor.release()
    s.executor.run_until_idle()
    assert goal.reason is Reason.FORBIDDEN
    assert s.robot.pose().x == 0.0


def test_what_is_being_done_is_not_asked_again(stage):
    s, door = stage(), Door()
    (goal,) = s.executor.submit(FORWARD, guards=[door])
    s.clock.advance(0.5)
    door.why = WHY
    s.executor.hold()
    s.executor.release()
    s.executor.run_until_idle()
    assert goal.succeeded
    assert door.asked == 1


def test_a_stop_is_asked_nothing(stage):
    s = stage()
    goals = s.executor.submit([Stop(), FORWARD, Stop()], guards=[Door(WHY), None, Door(WHY)])
    s.executor.run_until_idle()
    assert all(goal.succeeded for goal in goals)


@pytest.mark.parametrize("then", ["stop", "hold", "pause", "close"])
def test_who_is_asked_may_end_it_all(stage, then):
    s = stage()

    def guard() -> str:
        getattr(s.executor, then)()
        return ""

    goals = s.executor.submit([FORWARD, LEFT], guards=[guard, None])
    s.clock.advance(0.5)
    assert all(goal.state in (GoalState.CANCELED, GoalState.ACCEPTED) for goal in goals)
    assert not [each for each in s.robot.written if each.linear or each.angular]


@pytest.mark.parametrize(
    ("guards", "error", "said"),
    [([None], ValueError, "2 actions, but 1 guards"), (["docked", None], TypeError, "not a str")],
)
def test_guards_that_make_no_sense(stage, guards, error, said):
    s = stage()
    with pytest.raises(error, match=said):
        s.executor.submit([FORWARD, LEFT], guards=guards)
    assert s.executor.idle


@given(st.lists(st.booleans(), min_size=1, max_size=6))
def test_the_steps_before_the_first_that_is_forbidden_are_done_and_no_others(allowed):
    from execution_stage import Stage

    s, did = Stage(handlers={"step": lambda action: did.append(action.slots["n"])}), []
    steps = [Custom("step", {"n": n}) for n in range(len(allowed))]
    goals = s.executor.submit(steps, guards=[Door("" if may else WHY) for may in allowed])
    s.executor.run_until_idle()
    first = allowed.index(False) if False in allowed else len(allowed)
    assert did == list(range(first))
    ends = ["succeeded"] * first + (["aborted"] + ["canceled"] * len(allowed))[: len(allowed) - first]
    assert states(goals) == ends
    s.executor.close()
