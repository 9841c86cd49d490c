"""Plain values that a program gave - numbers, texts, choices - looked at before anything depends on them.

What is checked here is told where it was given. Later it would be an error from deep inside, or a robot that does
something else than was meant: a choice by a wrong name would count as the other one.
"""

from __future__ import annotations

import math
import os
from numbers import Real
from typing import TypeVar

__all__ = ["WHOLE_TURN", "check_number", "check_path", "check_text", "check_timeout", "is_number", "named"]

E = TypeVar("E")

WHOLE_TURN = math.tau + 1e-3
"""rad; nobody writes more for the way a robot looks, but many write degrees."""


def is_number(value: object) -> bool:
    """Whether it can be reckoned with, numbers of NumPy included; ``True`` is none."""
    return isinstance(value, Real) and not isinstance(value, bool)


def check_number(name: str, value: object, unit: str = "s", *, positive: bool = False) -> None:
    """See that a value is a number that is not below zero. It may be infinite, where there is no limit.

    Args:
        name: what it was given as.
        value: what was given.
        unit: what it counts.
        positive: zero is none either.

    Raises:
        TypeError: it is no number.
        ValueError: it is below zero, NaN, or a whole number that no other can hold.
    """
    if not is_number(value):
        raise TypeError(f"{name} is a number of {unit}, not {value!r:.80}")
    try:
        number = float(value)  # type: ignore[arg-type]
    except OverflowError:
        raise ValueError(f"{name} is a number of {unit}, and {value!r:.20}... is beyond all of them") from None
    if math.isnan(number):
        raise ValueError(f"{name} must be a number, not nan")
    if number < 0:
        raise ValueError(f"{name} must not be below zero, as {value} is")
    if positive and number == 0:
        raise ValueError(f"{name} must be above zero")


def check_timeout(value: object) -> None:
    """See that a timeout is s, or None for none. Below zero, as what is left of a time may be, it has run out.

    Raises:
        TypeError: it is no number.
        ValueError: it is NaN, which no time ever reaches.
    """
    if value is not None and not is_number(value):
        raise TypeError(f"timeout is a number of s, or None to wait as long as it takes, not {value!r:.80}")
    if value is not None and math.isnan(value):  # type: ignore[arg-type]
        raise ValueError("timeout is a number of s, or None to wait as long as it takes, not nan")


def check_path(name: str, value: object) -> None:
    """See that a file is named.

    Raises:
        TypeError: it is not by a path.
    """
    if not isinstance(value, str | os.PathLike):
        raise TypeError(f"{name} is given by its path, not as {value!r:.80}")


def check_text(name: str, value: object, *, empty: bool = True) -> None:
    """See that a value is text.

    Raises:
        TypeError: it is none.
        ValueError: nothing stands in it, and something must (not ``empty``).
    """
    if not isinstance(value, str):
        raise TypeError(f"{name} is a text, not {value!r:.80}")
    if not (empty or value):
        raise ValueError(f"{name} is empty")


def named(kinds: type[E], name: str, value: object) -> E:
    """The value of an enumeration by its name.

    Raises:
        ValueError: there is none; says which there are.
    """
    try:
        return kinds(value)  # type: ignore[call-arg]
    except ValueError:
        there = ", ".join(map(repr, map(str, kinds)))  # type: ignore[call-overload]
        raise ValueError(f"{name} is one of {there}, not {value!r:.80}") from None
