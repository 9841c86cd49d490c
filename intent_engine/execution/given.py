"""What a program gave to an executor, looked at before anything depends on it: a hold limit that is no number would end
the executor's thread at the first hold, and a listener that cannot be called would be heard of in the log alone.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Iterable, Mapping
from numbers import Real
from typing import TypeVar

from intent_engine.execution.goal import Goal
from intent_engine.execution.motion import Rates

__all__ = ["check_handler", "check_listener", "check_number", "check_parts", "goal_of", "goals_of", "named"]

E = TypeVar("E")


def check_number(name: str, value: object, unit: str = "s") -> None:
    """See that a time is one: not below zero; infinite where there is no limit.

    Raises:
        TypeError: it is no number.
        ValueError: it is below zero, or not a number by name.
    """
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} is a number of {unit}, not {value!r:.80}")
    if math.isnan(number := float(value)) or number < 0:
        raise ValueError(f"{name} must not be below zero, as {value} is")


def check_parts(clock: object, rates: object, loop: object, journal: object, on_event: object) -> None:
    """See that what an executor is made of is what it is called; None: it was not given.

    Raises:
        TypeError: it is not; says what is.
    """
    if clock is not None and (isinstance(clock, type) or not (hasattr(clock, "now") and hasattr(clock, "wait_until"))):
        raise TypeError(f"a clock is MonotonicClock() or VirtualClock(), not {clock!r:.80}")
    if rates is not None and not isinstance(rates, Rates):
        raise TypeError(f"rates are Rates(rate=20.0), or those of load_robot(file).rates, not {rates!r:.80}")
    if loop is not None and (isinstance(loop, type) or not hasattr(loop, "halt")):
        raise TypeError(f"loop is a Guardian, which writes velocities, or None, not {loop!r:.80}")
    for name, listener in (("journal", journal), ("on_event", on_event)):
        if listener is not None:
            check_listener(name, listener)


def check_listener(name: str, listener: object) -> None:
    """See that a listener can be called.

    Raises:
        TypeError: it cannot.
    """
    if not callable(listener):
        how = "Journal(path), which writes events" if name == "journal" else "a function that takes an event"
        raise TypeError(f"{name} is {how}, not {listener!r:.80}")


def check_handler(taker: str, name: object, handler: object) -> None:
    """See that a handler can be called with an action.

    Raises:
        TypeError: it cannot, or its name is no text.
    """
    if not isinstance(name, str) or not callable(handler):
        raise TypeError(f"{taker} takes a name and a function, not {name!r} and {handler!r:.80}")
    try:
        parameters = inspect.signature(handler)
    except (TypeError, ValueError):  # of a few built-in functions nobody knows
        return
    for arguments in (1, 2):
        try:
            parameters.bind(*[None] * arguments)
        except TypeError:
            continue
        return
    how = "handler(action), or handler(action, context)"
    raise TypeError(f"the handler of {name!r} is called as {how}, and takes neither")


def named(kinds: type[E], name: str, value: object) -> E:
    """The value of an enumeration by its name.

    Raises:
        ValueError: there is none; says which there are.
    """
    try:
        return kinds(value)  # type: ignore[call-arg]
    except ValueError:
        there = ", ".join(map(repr, map(str, kinds)))  # type: ignore[call-overload]
        raise ValueError(f"{name} is one of {there}, not {value!r}") from None


def goal_of(taker: str, given: object) -> Goal:
    """The goal that a program gave.

    Raises:
        TypeError: it is none. To do nothing then would let a robot drive on that somebody wants to halt.
    """
    if isinstance(given, Goal):
        return given
    several = isinstance(given, list | tuple) and given and all(isinstance(one, Goal) for one in given)
    how = "one of the list that submit returned" if several else "as submit returns for each action"
    raise TypeError(f"{taker} takes a goal, {how}, not {given!r:.80}")


def goals_of(taker: str, given: object) -> list[Goal]:
    """The goals that a program gave: one, or several.

    Raises:
        TypeError: something among them is none.
    """
    listed = list(given) if isinstance(given, Iterable) and not isinstance(given, str | Mapping) else [given]
    return [goal_of(taker, one) for one in listed]
