"""What comes by two ways and bears no mark is heard once, and a stop in any case; without a middleware."""

from __future__ import annotations

from collections import deque
from types import SimpleNamespace
from typing import Any

import pytest

from intent_engine.ros2.best_effort import HearAll, Pairs

A, B = True, False
"""The ways."""


@pytest.mark.parametrize(
    ("came", "heard"),
    [
        ([("go", A, 0.0), ("go", B, 0.1)], ["go"]),
        ([("go", B, 0.0), ("go", A, 0.1)], ["go"]),
        ([("go", A, 0.0), ("go", A, 0.1)], ["go", "go"]),  # said twice to who hears it by one way
        ([("go", B, 0.0), ("go", B, 0.1)], ["go", "go"]),
        ([("go", A, 0.0), ("go", A, 0.1), ("go", B, 0.2), ("go", B, 0.3)], ["go", "go"]),
        ([("go", A, 0.0), ("go", B, 0.1), ("go", A, 0.2), ("go", B, 0.3)], ["go", "go"]),
        ([("go", A, 0.0), ("left", A, 0.1), ("go", B, 0.2), ("left", B, 0.3)], ["go", "left"]),
        ([("go", A, 0.0), ("left", B, 0.1)], ["go", "left"]),
        ([("go", A, 0.0), ("go", B, 1.5)], ["go", "go"]),  # another's
    ],
)
def test_the_same_by_the_other_way_is_the_same_message(came, heard):
    pairs = Pairs()
    assert [text for text, way, now in came if not pairs.completes(text, way, now)] == heard


class Hearing(HearAll):
    """With the two ways, and no node."""

    def __init__(self, stops: Any) -> None:
        self.heard: list[str] = []
        self._pairs, self._before, self._stops = Pairs(), deque(), stops
        self._heard = lambda message, info: self.heard.append(message)


@pytest.mark.parametrize("info", [None, {}, {"source_timestamp": 0}, SimpleNamespace()], ids=str)
def test_a_stop_that_may_be_anothers_is_never_left_out(info):
    hearing = Hearing(lambda text: text == "stop")
    for text, way in [("go", A), ("stop", A), ("go", B), ("stop", B)]:
        hearing._hear(text, info, way)
    assert hearing.heard == ["go", "stop", "stop"]


def test_what_bears_a_mark_needs_no_other():
    hearing = Hearing(lambda text: False)
    for sent, way in [(1, A), (1, B), (2, B), (3, A), (3, B)]:
        hearing._hear("go", {"source_timestamp": sent}, way)
    assert hearing.heard == ["go"] * 3
