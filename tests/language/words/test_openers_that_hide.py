"""Fillers of several words of which one is a command, before its opposite or parted by a pause."""

from __future__ import annotations

import pytest
from meanings import does


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("turn right, now left", "right 43, left 43"),
        ("turn right now, left", "right 43, left 43"),
        ("turn right now left", "rejected"),
        ("turn right away left", "rejected"),
        ("turn left right now", "left 43"),
        ("all right, turn left", "left 43"),
        ("right now turn left", "left 43"),
        ("go forward right now and then turn left", "forward 1, left 43"),
    ],
)
def test_the_opposite_takes_nothing_away(said: str, meant: str) -> None:
    assert does(said) == meant
