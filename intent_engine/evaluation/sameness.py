"""Whether a value of a label and one that came out say the same."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from intent_engine.language.utterance import plain

__all__ = ["same"]

TOLERANCE = 1e-3
"""Relative difference of numbers that are the same: "two feet" is 0.61 m in one label and 0.6096 m in another."""


def same(one: Any, other: Any) -> bool:
    """Whether two values say the same: numbers nearly, texts in their plain words, together or apart ("tool box"), the
    rest exactly."""
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return math.isclose(one, other, rel_tol=TOLERANCE, abs_tol=1e-6)
    if isinstance(one, str) and isinstance(other, str):
        return one == other or "".join(plain(one)) == "".join(plain(other)) != ""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    return bool(one == other)
