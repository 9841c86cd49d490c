"""A handler that had to make way begins nothing more: the robot is another's."""

from __future__ import annotations

import asyncio
import contextvars
import gc
import threading
import weakref
from collections.abc import Callable

import pytest

from intent_engine import Custom, Executor, Goal, GoalState, Move, Reason, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.limits import Limits
from intent_engine.testing import RecordingRobot

LONG = Move(0.5, 50.0, 100.0)
SHORT = Move(0.5, 0.02, 0.04)
PATROL = Custom("patrol")


def outcome(goal: Goal) -> tuple[GoalState, Reason]:
    return goal.state, goal.reason


def at_once(step: Callable[[], list[Goal]]) -> list[Goal]:
    return step()


def in_a_task(step: Callable[[], list[Goal]]) -> list[Goal]:
    async def drive() -> list[Goal]:
        return await asyncio.create_task(asyncio.to_thread(step))

    return asyncio.run(drive())


def in_a_loop_of_its_own(step: Callable[[], list[Goal]]) -> list[Goal]:
    """As the error of an async handler says that one is to be registered."""

    async def drive() -> list[Goal]:
        return step()

    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever)
    thread.start()
    try:
        return asyncio.run_coroutine_threadsafe(drive(), loop).result(30.0)
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join(30.0)
        loop.close()


def in_a_thread_with_its_context(step: Callable[[], list[Goal]]) -> list[Goal]:
    made: list[Goal] = []
    context = contextvars.copy_context()
    thread = threading.Thread(target=lambda: made.extend(context.run(step)))
    thread.start()
    thread.join(30.0)
    return made


class Scene:
    """A handler that drives, waits until something else has happened, and drives again without looking."""

    def __init__(self, first=LONG, how=at_once, policy="replace", limits: Limits | None = None) -> None:
        self.driving, self.over = threading.Event(), threading.Event()
        self.go_on = threading.Event()
        self.driven: list[Goal] = []
        self.first, self.how, self.policy = first, how, policy
        self.executor = Executor(RecordingRobot(), limits, handlers={"patrol": self.patrol}, handle_sigterm=False)

    def patrol(self, action) -> None:
        try:
            if self.first is not None:
                self.driven += self.how(lambda: self.executor.submit(self.first))
            self.driving.set()
            assert self.go_on.wait(30.0)
            self.driven += self.how(lambda: self.executor.submit(SHORT, policy=self.policy))
        finally:
            self.over.set()

    def __enter__(self) -> Scene:
        (self.goal,) = self.executor.submit(PATROL)
        assert self.driving.wait(30.0)
        return self

    def finish(self) -> Goal:
        """The handler drives again."""
        self.go_on.set()
        assert self.over.wait(30.0)
        return self.driven[-1]

    def __exit__(self, *error: object) -> None:
        self.go_on.set()
        self.executor.close()


@pytest.mark.parametrize("policy", ["replace", "queue"])
@pytest.mark.parametrize("how", [at_once, in_a_task, in_a_loop_of_its_own, in_a_thread_with_its_context])
def test_a_handler_that_was_replaced_does_not_take_the_robot_back(how, policy):
    with Scene(how=how, policy=policy) as scene:
        (new,) = scene.executor.submit(LONG)
        again = scene.finish()
        assert outcome(again) == (GoalState.REJECTED, Reason.PREEMPTED)
        assert (
            again.detail == "the handler that asks for it has no turn any more: another command has come since it began"
        )
        assert not new.done
        assert outcome(scene.driven[0]) == (GoalState.CANCELED, Reason.PREEMPTED)


@pytest.mark.parametrize("how", [in_a_task, in_a_loop_of_its_own, in_a_thread_with_its_context])
def test_a_stop_ends_what_a_handler_does_elsewhere_too(how):
    with Scene(how=how) as scene:
        scene.executor.stop()
        assert outcome(scene.finish()) == (GoalState.REJECTED, Reason.STOP)


def test_nor_does_one_between_two_drives():
    with Scene(first=SHORT) as scene:
        assert scene.driven[0].result(30.0).succeeded
        (new,) = scene.executor.submit(LONG)
        assert outcome(scene.finish()) == (GoalState.REJECTED, Reason.PREEMPTED)
        assert not new.done


def test_nor_when_what_waited_its_turn_has_begun():
    with Scene(first=SHORT) as scene:
        (new,) = scene.executor.submit(SHORT, policy="queue")
        assert new.result(30.0).succeeded
        assert outcome(scene.finish()) == (GoalState.REJECTED, Reason.PREEMPTED)


def test_a_handler_goes_on_that_nobody_replaced():
    with Scene(first=SHORT) as scene:
        assert scene.driven[0].result(30.0).succeeded
        assert scene.finish().result(30.0).succeeded


def test_what_is_rejected_takes_no_handler_its_turn():
    with Scene() as scene:
        assert scene.executor.submit(SHORT, policy="refuse")[0].reason is Reason.BUSY
        assert scene.executor.submit(Custom("unknown"))[0].reason is Reason.NO_HANDLER
        assert scene.finish().result(30.0).succeeded


@pytest.mark.parametrize("which", ["handler", "drive"])
def test_a_handler_begins_nothing_after_it_was_cancelled(which):
    with Scene(first=LONG if which == "drive" else None) as scene:
        scene.executor.cancel(scene.goal if which == "handler" else scene.driven[0])
        assert outcome(scene.finish()) == (GoalState.REJECTED, Reason.CANCELED)


def test_cancelling_a_handler_that_drives_ends_what_it_would_do_next():
    with Scene(first=SHORT) as scene:
        scene.driven[0].result(30.0)
        scene.executor.cancel(scene.goal)  # over already, since its own drive took its place
        assert outcome(scene.finish()) == (GoalState.REJECTED, Reason.CANCELED)


def test_a_handler_begins_nothing_after_its_time_is_up():
    with Scene(first=None, limits=Limits(task_duration=0.01)) as scene:
        assert scene.goal.result(30.0).reason is Reason.TIMEOUT
        again = scene.finish()
        assert outcome(again) == (GoalState.REJECTED, Reason.TIMEOUT)
        assert again.detail.endswith("it took too long")


def test_nor_after_a_hold_that_nobody_released(stage):
    made: list[Goal] = []

    def patrol(action):
        s.executor.hold()
        s.clock.advance(20.0)
        made.extend(s.executor.submit(SHORT))

    s = stage(handlers={"patrol": patrol})
    s.executor.submit(PATROL)
    s.executor.run_until_idle()
    assert outcome(made[0]) == (GoalState.REJECTED, Reason.HOLD_EXPIRED)


def test_a_handler_may_cancel_what_it_began(stage):
    made: list[Goal] = []

    def patrol(action):
        made.extend(s.executor.submit(LONG))
        s.executor.cancel(made[0])
        made.extend(s.executor.submit(SHORT))

    s = stage(handlers={"patrol": patrol})
    s.executor.submit(PATROL)
    s.executor.run_until_idle()
    assert [outcome(goal) for goal in made] == [
        (GoalState.CANCELED, Reason.CANCELED),
        (GoalState.SUCCEEDED, Reason.NONE),
    ]


def test_a_handler_goes_on_after_what_another_handler_did_for_it():
    made: list[Goal] = []
    over = threading.Event()

    def tour(action):
        executor.submit(PATROL)[0].result(30.0)
        assert inner.wait(30.0)
        made[0].result(30.0)
        made.extend(executor.submit(SHORT))
        over.set()

    def patrol(action):
        made.extend(executor.submit(SHORT))
        inner.set()

    inner = threading.Event()
    with Executor(RecordingRobot(), handlers={"tour": tour, "patrol": patrol}, handle_sigterm=False) as executor:
        executor.submit(Custom("tour"))
        assert over.wait(30.0)
        assert [goal.result(30.0).succeeded for goal in made] == [True, True]


def test_a_handler_that_begins_itself_again_keeps_no_goal_of_before():
    seen: list[weakref.ref[Goal]] = []

    def patrol(action, context):
        seen.append(weakref.ref(context.goal))
        if len(seen) < 10:
            executor.submit(PATROL)

    with Executor(SimulatedRobot(), clock=VirtualClock(), handlers={"patrol": patrol}) as executor:
        executor.submit(PATROL)
        executor.run_until_idle()
        gc.collect()
        assert len(seen) == 10
        assert sum(goal() is not None for goal in seen) <= 2


def test_the_handler_of_one_robot_is_nobody_to_another(stage):
    made: list[Goal] = []

    def patrol(action):
        made.extend(first.executor.submit(SHORT))
        first.executor.submit(LONG)
        second.executor.submit(PATROL)

    def patrol_second(action):
        made.extend(second.executor.submit(SHORT))

    first, second = stage(handlers={"patrol": patrol}), stage(handlers={"patrol": patrol_second})
    first.executor.submit(PATROL)
    first.executor.stop()
    second.executor.run_until_idle()
    assert outcome(made[-1]) == (GoalState.SUCCEEDED, Reason.NONE)
