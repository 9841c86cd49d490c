"""Readings that no command can be made of, and which of them tells most."""

from __future__ import annotations

from intent_engine.language.continuation import MANNER
from intent_engine.language.reading import Reading

__all__ = ["far_off", "problem_rank", "tells_what"]


def problem_rank(reading: Reading) -> tuple[int, int, float]:
    """Which failure tells most: an ambiguous name, then a limit, then a place that is not on the map, since places are
    called anything and values of a list are not ("go to room 206" is no turn); then the fewest words not understood."""
    order = {"ambiguous": 0, "limit": 1}
    slot = next(slot for slot in reading.slots if slot.problem)
    nearest = slot.rivals[0][1] if slot.rivals else 0.0
    rank = order.get(slot.status, 2 if slot.slot.type == "location" else 3)
    return rank, slot.end - slot.start, -nearest


def tells_what(reading: Reading) -> bool:
    """Whether more was heard as it is than how something is to be done: "slow down" has no direction called "down"."""
    manner = sum(slot.end - slot.start for slot in reading.slots if slot.slot.type in MANNER and not slot.problem)
    return reading.heard_exactly > manner


def far_off(reading: Reading) -> bool:
    """Whether an amount is beyond its limits and something else is not understood either: "to the kitchen" is no turn
    by two degrees to a side called "kitchen"."""
    problems = [slot.status for slot in reading.slots if slot.problem]
    return len(problems) > 1 and "limit" in problems
