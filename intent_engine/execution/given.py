"""What a program gave to an executor, looked at before anything depends on it: a hold limit that is no number would end
the executor's thread at the first hold, and a listener that cannot be called would be heard of in the log alone.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Collection, Iterable, Mapping
from typing import Any

from intent_engine.actions import ACTION_TYPES
from intent_engine.execution.goal import Goal
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates, ramps
from intent_engine.execution.policy import Policy
from intent_engine.execution.robots.robot import Capability
from intent_engine.hints import did_you_mean
from intent_engine.values import check_number, check_text, check_timeout, is_number, named

__all__ = [
    "capabilities_of",
    "check_awaitless",
    "check_clock",
    "check_handler",
    "check_listener",
    "check_loop",
    "check_number",
    "check_parts",
    "check_policies",
    "check_pose",
    "check_robot",
    "check_spoken",
    "check_text",
    "check_timeout",
    "goal_of",
    "goals_of",
    "named",
    "time_of",
]

_ARGUMENTS = {"velocity": 3, "stop": 0, "pose": 0, "navigate": 1, "pick": 1, "place": 2, "cancel": 1}
"""Methods of a robot -> with how many arguments they are called."""
_TASKS = (Capability.NAVIGATE, Capability.PICK, Capability.PLACE)


def check_parts(clock: object, rates: object, loop: object, journal: object, on_event: object) -> None:
    """See that what an executor is made of is what it is called; None: it was not given.

    Raises:
        TypeError: it is not; says what is.
    """
    check_clock(clock)
    if rates is not None and not isinstance(rates, Rates):
        raise TypeError(f"rates are Rates(rate=20.0), or those of load_robot(file).rates, not {rates!r:.80}")
    if loop is not None and (isinstance(loop, type) or not hasattr(loop, "halt")):
        raise TypeError(f"loop is a Guardian, which writes velocities, or None, not {loop!r:.80}")
    for name, listener in (("journal", journal), ("on_event", on_event)):
        if listener is not None:
            check_listener(name, listener)


def check_loop(loop: object, limits: Limits) -> None:
    """See that the process that writes velocities keeps to the limits of its executor.

    Raises:
        ValueError: it was made with other accelerations.
    """
    own = getattr(loop, "limits", None)
    if own is not None and ramps(own) != ramps(limits):
        raise ValueError("the guardian has other accelerations than its executor: Guardian(..., limits=those of that)")


def check_clock(clock: object) -> None:
    """See that a clock, if one was given, is one.

    Raises:
        TypeError: it is not.
    """
    if clock is not None and (isinstance(clock, type) or not (hasattr(clock, "now") and hasattr(clock, "wait_until"))):
        raise TypeError(f"a clock is MonotonicClock() or VirtualClock(), not {clock!r:.80}")


def check_spoken(spoken_at: object) -> None:
    """See that the end of words, if it was given, is a time.

    Raises:
        TypeError: it is no number.
        ValueError: it is not finite.
    """
    if spoken_at is None or time_of(spoken_at) is not None:
        return
    if not is_number(spoken_at):
        by_name = isinstance(spoken_at, str) and spoken_at in [*Policy]
        hint = f"; a policy is given by its name: policy={str(spoken_at)!r}" if by_name else ""
        raise TypeError(f"spoken_at is a time on the executor's clock in s, not {spoken_at!r:.80}{hint}")
    raise ValueError(f"spoken_at must be a time on the executor's clock, not {spoken_at}")


def time_of(given: object) -> float | None:
    """A time that a program gave, if it is one."""
    return float(given) if is_number(given) and math.isfinite(given) else None  # type: ignore[arg-type]


def check_robot(robot: object) -> None:
    """See that a robot has the methods that will be called, and that a call does what it says: one that is only
    awaited, as of an ``async def``, would never stop the robot.

    Raises:
        TypeError: it has not; names those that are missing.
        ValueError: there is no such capability.
    """
    if isinstance(robot, type):
        raise TypeError(f"Executor needs a robot, not the class {robot.__name__}: pass an instance of it")
    able = capabilities_of(getattr(robot, "capabilities", ()))
    tasks = [need.value for need in _TASKS if need in able]
    needed = ["velocity", "stop", "pose", *tasks, *(["cancel"] if tasks else [])]
    missing = [name for name in ("capabilities", *needed) if not hasattr(robot, name)]
    if missing:
        raise TypeError(f"Executor needs a robot, and {robot!r:.100} is none: it has no {', '.join(missing)}")
    for name in needed:
        method = getattr(robot, name)
        if not callable(method):
            raise TypeError(f"{name} of a robot is a method, not {method!r:.80}")
        hint = "let it start what it does, as with asyncio.run_coroutine_threadsafe(..., loop), and return"
        check_awaitless(f"{name} of a robot", method, hint)
        if not _takes(method, _ARGUMENTS[name]):
            how = str(inspect.signature(method))
            raise TypeError(f"{name} of a robot is called with {_ARGUMENTS[name]} arguments, and this one takes {how}")
    if (rates := getattr(robot, "rates", None)) is not None and not isinstance(rates, Rates):
        raise TypeError(f"rates of a robot are Rates(rate=20.0), not {rates!r:.80}")


def capabilities_of(given: object) -> frozenset[Capability]:
    """The capabilities that a program gave, also by their names.

    Raises:
        TypeError: they are no set of them. Of a text, the letters would be its capabilities.
        ValueError: there is no such capability.
    """
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise TypeError(f"capabilities are a set, as {{Capability.MOVE}}, not {given!r:.80}")
    return frozenset(named(Capability, "a capability", one) for one in given)


def check_pose(name: str, value: object) -> None:
    """See that a place is a pose of finite numbers; a place of a map, which has all that a pose has, is one.

    Raises:
        TypeError: it is none.
        ValueError: one of its numbers is not finite.
    """
    try:
        numbers = [getattr(value, axis) for axis in ("x", "y", "yaw")]
    except AttributeError:
        numbers = []
    if not numbers or not all(map(is_number, numbers)):
        raise TypeError(f"{name} is a pose, as Pose(1.0, 2.0, 0.0) in m and rad, not {value!r:.80}")
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"{name} must be finite, not {value!r:.80}")


def check_policies(policies: Mapping[Any, object], handlers: Collection[str]) -> None:
    """See that policies are of actions that there are. A custom action may be called anything, and its handler be
    registered later; one that is called nearly as a type of action is so by mistake.

    Raises:
        TypeError: one is not by a name.
        ValueError: one is nearly the name of a type.
    """
    for name in policies:
        if not isinstance(name, str):
            by = repr(name.type) if isinstance(getattr(name, "type", None), str) else "'navigate'"
            raise TypeError(f"policies are by the name of an action, as {by}, not by {name!r:.80}")
        if name in ACTION_TYPES or name in handlers:
            continue
        if hint := did_you_mean(name, ACTION_TYPES, alike=75):
            one = "for an action of your own of this name, give its handler with handlers="
            raise ValueError(f"policies: there is no action {name!r}; {hint} Or, {one}")


def check_listener(name: str, listener: object) -> None:
    """See that a listener can be called.

    Raises:
        TypeError: it cannot.
    """
    if not callable(listener):
        how = "Journal(path), which writes events" if name == "journal" else "a function that takes an event"
        raise TypeError(f"{name} is {how}, not {listener!r:.80}")
    check_awaitless(name, listener, "lambda event: loop.call_soon_threadsafe(queue.put_nowait, event)")


def check_handler(taker: str, name: object, handler: object) -> None:
    """See that a handler can be called with an action.

    Raises:
        TypeError: it cannot, or its name is no text.
    """
    if not isinstance(name, str) or not callable(handler):
        raise TypeError(f"{taker} takes a name and a function, not {name!r} and {handler!r:.80}")
    hint = "lambda action: asyncio.run_coroutine_threadsafe(function(action), loop).result()"
    check_awaitless(f"the handler of {name!r}", handler, hint)
    if not (_takes(handler, 1) or _takes(handler, 2)):
        how = "handler(action), or handler(action, context)"
        raise TypeError(f"the handler of {name!r} is called as {how}, and takes neither")


def check_awaitless(name: str, function: Any, hint: str = "") -> None:
    """See that a call does something: one of an ``async def``, or of what yields, only gives what is to be awaited, or
    stepped through, and nobody would.

    Raises:
        TypeError: it does nothing yet.
    """
    kinds = (inspect.iscoroutinefunction, inspect.isasyncgenfunction, inspect.isgeneratorfunction)
    called = None if inspect.isroutine(function) or isinstance(function, type) else type(function).__call__
    if any(kind(one) for kind in kinds for one in (function, called)):
        wrong = "yields" if inspect.isgeneratorfunction(function) else "is async"
        raise TypeError(f"{name} is called, and not awaited, but {wrong}{': ' if hint else ''}{hint}")


def _takes(function: Any, count: int) -> bool:
    """Whether a function can be called with so many arguments."""
    try:
        inspect.signature(function).bind(*[None] * count)
    except TypeError:
        return False
    except ValueError:  # of a few built-in functions nobody knows
        return True
    return True


def goal_of(taker: str, given: object, executor: object) -> Goal:
    """The goal that a program gave to ``executor``.

    Raises:
        TypeError: it is none. To do nothing then would let a robot drive on that somebody wants to halt.
        ValueError: it is another executor's, which would not hear of it, nor tell of its end.
    """
    if isinstance(given, Goal):
        if not given.is_of(executor):
            raise ValueError(f"{taker} takes a goal of this executor, and {given!r:.80} is another's")
        return given
    several = isinstance(given, list | tuple) and given and all(isinstance(one, Goal) for one in given)
    how = "one of the list that submit returned" if several else "as submit returns for each action"
    raise TypeError(f"{taker} takes a goal, {how}, not {given!r:.80}")


def goals_of(taker: str, given: object, executor: object) -> list[Goal]:
    """The goals that a program gave to ``executor``: one, or several.

    Raises:
        TypeError: something among them is none.
        ValueError: something among them is another executor's.
    """
    listed = list(given) if isinstance(given, Iterable) and not isinstance(given, str | Mapping) else [given]
    return [goal_of(taker, one, executor) for one in listed]
