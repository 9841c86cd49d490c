"""Commands in every order on a virtual clock, and the laws that hold after each of them."""

from __future__ import annotations

import math
import tempfile
from itertools import pairwise
from pathlib import Path

import pytest
from execution_stage import MAP, FailingRobot
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from intent_engine.actions import Custom, Move, Navigate, Pick, Stop, Turn
from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.events import EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Keep, Rates
from intent_engine.execution.policy import Policy
from intent_engine.interpretation import Status

ACCELERATION, TURN_ACCELERATION = 0.8, 1.6
RATES = Rates(rate=20.0, valid_for=0.3)

moves = st.builds(
    lambda v, d: Move(v, d, d / abs(v)), st.sampled_from([-0.6, -0.2, 0.3, 0.9]), st.floats(0.0, 2.0, width=32)
)
turns = st.builds(
    lambda w, a: Turn(math.copysign(a, w), w, a / abs(w)), st.sampled_from([-1.0, 0.4, 1.5]), st.floats(0.0, 4.0)
)
navigations = st.sampled_from([Navigate(name, p.x, p.y, p.yaw) for name, p in MAP.items()])
others = st.sampled_from([Pick("cup"), Custom("wave"), Custom("broken"), Custom("unknown"), Stop()])
actions = st.one_of(moves, turns, navigations, others)


GRAMMAR = """
language: en
slots:
  direction: {{type: choice, values: {{forward: [forward], backward: [back]}}}}
intents:
  move:
    action: move
    sentences: ["{verb} {{direction}}"]
    defaults: {{speed: 0.5 m/s, duration: 2 s}}
"""


class ExecutorMachine(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.clock = VirtualClock()
        self.robot = FailingRobot(self.clock, locations=MAP)
        self.goals: list = []
        self.ends: dict[int, int] = {}
        self.started: list[int] = []
        self.begun_while: dict[int, str] = {}
        self.guarded: set[int] = set()
        self.why = ""
        """Why what is guarded must not begin now."""
        self.folder = tempfile.TemporaryDirectory()
        self.file = Path(self.folder.name) / "grammar.yaml"
        self.file.write_text(GRAMMAR.format(verb="go"))
        self.engine = IntentEngine.from_files([self.file])
        self.verb = "go"
        self.executor = Executor(
            self.robot,
            Limits(linear_acceleration=ACCELERATION, angular_acceleration=TURN_ACCELERATION),
            on_event=self.hear,
            rates=RATES,
            policies={"pick": Policy.QUEUE},
            handlers={"wave": lambda action: "hello", "broken": self.broken},
            handle_sigterm=False,
        )
        self.still_since: int | None = 0
        """Index of the first write that must be zero; None while something may move."""
        self.jumps_allowed = True

    @staticmethod
    def broken(action: Custom) -> None:
        raise ValueError("no arm")

    def hear(self, event) -> None:
        if event.kind is EventKind.GOAL and event.state.ended:
            self.ends[event.goal.id] = self.ends.get(event.goal.id, 0) + 1
        if event.kind is EventKind.GOAL and event.state is GoalState.EXECUTING:
            self.started.append(event.goal.id)
            self.begun_while[event.goal.id] = self.why

    def may_move(self) -> None:
        self.still_since = None

    def stopped(self) -> None:
        self.still_since = len(self.robot.written)

    @rule(
        listed=st.lists(actions, min_size=1, max_size=4),
        policy=st.sampled_from([None, *Policy]),
        keep=st.sampled_from(list(Keep)),
        guarded=st.booleans(),
    )
    def submit(self, listed, policy, keep, guarded=False) -> None:
        if not (self.executor.snapshot().held or self.executor.estopped) or isinstance(listed[0], Stop):
            self.may_move()
        guards = [self.guard] * len(listed) if guarded else []
        new = self.executor.submit(listed, policy=policy, keep=keep, guards=guards)
        self.goals += new
        self.guarded.update(goal.id for goal in new if guarded and not isinstance(goal.action, Stop))

    @rule(answer=st.sampled_from(["", "", "docked", "nobody knows"]))
    def states_change(self, answer) -> None:
        self.why = answer

    def guard(self) -> str:
        if self.why == "nobody knows":
            raise LookupError(self.why)
        return self.why

    @rule(seconds=st.one_of(st.floats(0.0, 0.3), st.floats(0.0, 6.0), st.sampled_from([0.05, 0.1, 1.0])))
    def advance(self, seconds) -> None:
        self.clock.advance(seconds)

    @rule(motion=st.one_of(moves, turns), seconds=st.floats(0.0, 2.0))
    def drive(self, motion, seconds) -> None:
        """The everyday case, often: a motion that replaces whatever there is."""
        self.submit([motion], None, Keep.DISTANCE)
        self.clock.advance(seconds)

    @rule(verb=st.sampled_from(["go", "roll", "[broken"]), seconds=st.floats(0.0, 1.0))
    def reload_and_speak(self, verb, seconds) -> None:
        """A grammar is taken up, or not because it is broken, while the robot does whatever it does."""
        before = list(self.robot.written)
        standing = [goal.state for goal in self.goals]
        self.file.write_text(GRAMMAR.format(verb=verb))
        try:
            self.engine.reload()
            self.verb = verb
        except ConfigError:
            assert verb == "[broken"
        assert (self.robot.written, [goal.state for goal in self.goals]) == (before, standing)
        for spoken in ("go", "roll"):
            found = self.engine.parse(f"{spoken} back")
            assert (found.status is Status.ACCEPTED) == (spoken == self.verb)
            if found.status is Status.ACCEPTED:
                self.submit(found.actions, None, Keep.DISTANCE)
        self.clock.advance(seconds)

    @rule(count=st.integers(1, 9))
    def register_anew(self, count) -> None:
        """A handler is replaced: the goals that come are the new one's."""
        self.executor.register("wave", lambda action: f"hello {count}")

    @rule(what=st.sampled_from(["navigate", "stop"]))
    def fail_to(self, what) -> None:
        self.robot.fails_to = what

    @rule()
    def stop(self) -> None:
        self.executor.stop()
        self.stopped()
        assert self.executor.idle
        assert all(goal.done for goal in self.goals)
        now = self.executor.snapshot()
        assert (now.held, now.paused, now.queued) == (False, False, 0)
        assert now.velocity == (0.0, 0.0)

    @rule(answer=st.sampled_from(["leave", "move", "reset"]))
    def estop(self, answer) -> None:
        self.executor.estop()
        self.stopped()
        if answer == "move":
            self.goals += self.executor.submit(Move(0.3, 1.0, 1.0 / 0.3))
            assert self.goals[-1].state is GoalState.REJECTED
        if answer != "leave":
            self.executor.reset()

    @rule(seconds=st.floats(0.0, 3.0), then=st.sampled_from(["stay", "release", "release", "stop"]))
    def hold(self, seconds, then) -> None:
        self.executor.hold()
        self.stopped()
        self.clock.advance(seconds)
        self.nothing_moves_after_a_stop()
        if then == "stop":
            self.stop()
        elif then == "release":
            self.may_move()
            self.executor.release()

    @rule(seconds=st.floats(0.0, 3.0), then=st.sampled_from(["stay", "resume", "resume"]))
    def pause(self, seconds, then) -> None:
        self.executor.pause()
        self.clock.advance(seconds)
        if then == "resume" and not self.executor.snapshot().held:
            self.may_move()
        if then == "resume":
            self.executor.resume()

    @rule()
    def let_go(self) -> None:
        now = self.executor.snapshot()
        if now.held or now.paused:
            self.may_move()
        self.executor.release()
        self.executor.resume()
        self.executor.reset()

    @rule(count=st.integers(0, 30))
    def fail_later(self, count) -> None:
        self.robot.fail_in = count

    @precondition(lambda self: self.goals)
    @rule(which=st.integers(0, 5))
    def cancel_one(self, which) -> None:
        self.executor.cancel(self.goals[-1 - which % len(self.goals)])

    @invariant()
    def nothing_moves_after_a_stop(self) -> None:
        if self.still_since is not None:
            assert not [w for w in self.robot.written[self.still_since :] if w.linear or w.angular]

    @invariant()
    def every_goal_ends_once(self) -> None:
        for goal in self.goals:
            assert self.ends.get(goal.id, 0) == (1 if goal.done else 0)

    @invariant()
    def what_is_forbidden_is_not_begun(self) -> None:
        assert not [id for id in self.guarded if self.begun_while.get(id)]
        for goal in self.goals:
            if goal.reason is Reason.FORBIDDEN:
                assert (goal.state, goal.times.started) == (GoalState.ABORTED, None)

    @invariant()
    def order_is_kept(self) -> None:
        assert self.started == sorted(self.started)

    @invariant()
    def acceleration_is_within_its_limit(self) -> None:
        written = self.robot.written
        for before, after in pairwise(written):
            if after.by_stop:
                continue  # a stop and a hold are at once, by design
            gap = max(after.time - before.time, RATES.period) + 1e-9
            if after.time - before.time > RATES.valid_for:
                before = type(before)(before.time, 0.0, 0.0)
            assert abs(after.linear - before.linear) <= ACCELERATION * gap + 1e-9, (before, after)
            assert abs(after.angular - before.angular) <= TURN_ACCELERATION * gap + 1e-9, (before, after)

    def teardown(self) -> None:
        self.executor.resume()
        self.executor.release()
        self.executor.reset()
        self.executor.run_until_idle()
        assert self.executor.idle
        assert all(goal.done for goal in self.goals)
        self.executor.close()
        assert self.robot.speed() == (0.0, 0.0)
        self.folder.cleanup()


TestExecutor = ExecutorMachine.TestCase
TestExecutor.settings = settings(max_examples=100, stateful_step_count=30, deadline=None)


@pytest.mark.slow
class TestExecutorLong(ExecutorMachine.TestCase):
    """The same, many more times."""

    settings = settings(max_examples=500, stateful_step_count=50, deadline=None)
