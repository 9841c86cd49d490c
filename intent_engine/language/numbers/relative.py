"""A speed that is said without a number."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Relative"]


@dataclass(frozen=True, slots=True)
class Relative:
    """A speed that was said in terms of the usual one: "half speed", "slowly"."""

    factor: float
