"""A percentage right after where to turn may be its speed or a part of the way: nothing is done."""

from __future__ import annotations

import pytest
from meanings import does


@pytest.mark.parametrize(
    "said",
    [
        "turn left ninety percent",
        "turn right 50 %",
        "turn fifty percent left",
        "fifty percent turn left",
        "turn left, no, right ninety percent",
        "go forward and turn left ninety percent",
    ],
)
def test_what_may_be_speed_or_way_is_not_done(said: str) -> None:
    assert does(said) == "rejected"


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("turn left at fifty percent", "left 21"),
        ("turn left fifty percent speed", "left 21"),
        ("turn left half speed", "left 21"),
        ("turn left slowly", "left 21"),
        ("turn left ninety degrees fifty percent", "left 90"),
        ("turn left at fifty percent and go forward", "left 21, forward 1"),
        ("go forward fifty percent", "forward 0.5"),
    ],
)
def test_a_speed_that_is_told_is_one(said: str, done: str) -> None:
    assert does(said) == done
