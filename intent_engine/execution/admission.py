"""What may be done at all: whether this robot can, is allowed to, and whether it is still wanted."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.execution.given import (
    check_awaitless,
    check_handler,
    check_number,
    check_policies,
    check_robot,
    check_spoken,
    named,
)
from intent_engine.execution.goal import Goal, GoalState, Guard, Reason
from intent_engine.execution.handlers import Handler
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Keep
from intent_engine.execution.policy import Policy
from intent_engine.execution.raised import with_type
from intent_engine.execution.robots.robot import Capability, Robot
from intent_engine.execution.runs import Ending
from intent_engine.hints import did_you_mean

__all__ = ["Admission", "Terms", "check_robot", "checked", "forbidden", "limits_of"]

log = logging.getLogger(__name__)

A_DAY = 86_400.0
"""s; sound that is read faster than it was said may end so much later than now, and not more."""

_NEEDS: dict[type[Any], Capability] = {
    Move: Capability.MOVE,
    Turn: Capability.TURN,
    Navigate: Capability.NAVIGATE,
    Pick: Capability.PICK,
    Place: Capability.PLACE,
}


@dataclass(frozen=True, slots=True)
class Terms:
    """On what terms an action was submitted."""

    keep: Keep = Keep.DISTANCE
    guard: Guard | None = None


def checked(
    actions: list[Action],
    keep: Keep | str | Sequence[Keep | str],
    spoken_at: float | None,
    guards: Sequence[Guard | None] = (),
) -> list[Terms]:
    """The terms of each action of an utterance, when what a program gave to ``submit`` makes sense.

    Raises:
        TypeError: guards that cannot be called or stand alone, or a time that is no number.
        ValueError: an unknown keep, not one for each action, not a guard for each, or a time that is none.
    """
    if not isinstance(guards, Sequence):
        raise TypeError(f"guards are a list with one for each action, or none at all, not {guards!r:.80}")
    if not isinstance(keep, str | Sequence):
        raise TypeError(f"keep is 'distance', 'duration', or a list with one for each action, not {keep!r:.80}")
    keeps = [named(Keep, "keep", each) for each in ([keep] * len(actions) if isinstance(keep, str) else keep)]
    if len(keeps) != len(actions):
        raise ValueError(f"{len(actions)} actions, but {len(keeps)} values of keep")
    if guards and len(guards) != len(actions):
        raise ValueError(f"{len(actions)} actions, but {len(guards)} guards; None where there is none")
    for guard in guards:
        if not (guard is None or callable(guard)):
            raise TypeError(f"a guard is called and answers with text, not a {type(guard).__name__}")
        if guard is not None:
            check_awaitless("a guard", guard)
    check_spoken(spoken_at)
    return [Terms(*each) for each in zip(keeps, guards or [None] * len(actions), strict=True)]


def forbidden(goal: Goal, guard: Guard | None) -> Ending | None:
    """The end of a goal whose turn has come, if it must not begin now. What cannot be told is not done."""
    if guard is None or isinstance(goal.action, Stop):
        return None
    try:
        why = guard()
    except Exception as error:
        log.exception("no guard of goal %d", goal.id)
        why = f"nobody can tell whether it may be done: {with_type(error)}"
    return Ending(GoalState.ABORTED, Reason.FORBIDDEN, why) if why else None


def limits_of(robot: object, given: Limits | None) -> Limits:
    """What holds for a robot: what was given, else its own, else nothing but that numbers are numbers.

    Raises:
        TypeError: they are no ``Limits``, and so nobody could hold the robot to them.
    """
    found: object = getattr(robot, "limits", None) if given is None else given
    if found is None:
        return Limits()
    if not isinstance(found, Limits):
        how = "Limits(linear_velocity=0.5), or those of load_robot(file).limits"
        raise TypeError(f"limits of a robot are {how}, not {found!r:.100}")
    return found


class Admission:
    """The rules by which a goal is accepted; it holds no state of what is going on."""

    def __init__(
        self,
        robot: Robot,
        limits: Limits,
        handlers: Mapping[str, Handler],
        policies: Mapping[str, Policy | str],
        expire_after: float,
    ) -> None:
        self.robot = robot
        self.limits = limits
        check_number("expire_after", expire_after)
        for what, given in (("handlers", handlers), ("policies", policies)):
            if not isinstance(given, Mapping):
                how = "{'wave': function}" if what == "handlers" else "{'navigate': 'queue'}"
                raise TypeError(f"{what} are a dictionary by action, as {how}, not {given!r:.80}")
        for name, handler in handlers.items():
            check_handler("handlers", name, handler)
        check_policies(policies, handlers)
        self.handlers: dict[str, Handler] = dict(handlers)
        self.policies = {name: named(Policy, f"the policy of {name!r}", given) for name, given in policies.items()}
        self.expire_after = expire_after

    def policy(self, action: Action) -> Policy:
        """What an action does when it comes while another is carried out."""
        name = action.name if isinstance(action, Custom) else action.type
        return self.policies.get(name, self.policies.get(action.type, Policy.REPLACE))

    def handler(self, action: Action) -> Handler | None:
        """Who carries the action out, if it is not the robot."""
        if isinstance(action, Custom):
            return self.handlers.get(action.name) or self.handlers.get("custom")
        need = _NEEDS.get(type(action))
        if need is not None and need in self.robot.capabilities:
            return None
        return self.handlers.get(action.type)

    def drives(self, action: Action) -> bool:
        """Whether it is a motion on the velocity loop."""
        return isinstance(action, (Move, Turn)) and self.handler(action) is None

    def expired(self, goal: Goal, now: float) -> Ending | None:
        """The words ended too long ago."""
        spoken = goal.times.spoken
        if spoken is None or -A_DAY <= now - spoken <= self.expire_after:
            return None
        if now < spoken:  # on another clock, and so nobody knows how old they are
            why = "spoken_at is on the executor's clock, as executor.clock.now() is"
            return _no(Reason.EXPIRED, f"the words would end {spoken - now:.0f} s from now: {why}")
        return _no(Reason.EXPIRED, f"the words ended {now - spoken:.1f} s ago; the limit is {self.expire_after:g} s")

    def impossible(self, goal: Goal) -> Ending | None:
        """This robot cannot do it, or must not. An action beyond a limit that clamps is cut down in the goal."""
        action = goal.action
        if isinstance(action, Stop | ChangeSpeed) or self.handler(action) is not None:
            return None
        need = _NEEDS.get(type(action))
        if need is None:
            name = action.name if isinstance(action, Custom) else action.type
            near = did_you_mean(name, self.handlers)
            why = f"nothing is registered for {name!r}: executor.register({name!r}, ...)"
            return _no(Reason.NO_HANDLER, f"{why}; {near}" if near else why)
        if need not in self.robot.capabilities:
            return _no(Reason.CAPABILITY, f"this robot cannot {need.value}")
        within = self.limits.check(action)
        if within.refused:
            return _no(Reason.LIMIT, within.refused)
        goal.action = within.action
        goal.detail = "; ".join(within.clamped)
        return None


def _no(reason: Reason, detail: str) -> Ending:
    return Ending(GoalState.REJECTED, reason, detail)
