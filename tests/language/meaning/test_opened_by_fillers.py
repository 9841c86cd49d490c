"""Fillers before a sentence are none of it, also where others stand within it: "go and" wait "for me" there."""

from __future__ import annotations

import pytest
from meanings import does


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("go and wait for me in the bedroom", "to bedroom"),
        ("robot go and wait for me in the bedroom", "to bedroom"),
        ("can you please go and wait for me in the bedroom", "to bedroom"),
        ("okay so go ahead and wait for me in the kitchen", "to kitchen"),
        ("could you go and wait for me in the kitchen please", "to kitchen"),
        ("turn left and go and wait for me in the kitchen", "left 43, to kitchen"),
        ("robot wait for me in the bedroom", "to bedroom"),
        ("robot pick up the cup and wait for me in the kitchen", "pick cup, to kitchen"),
        ("go and then wait for me in the kitchen", "forward 1, to kitchen"),
        ("don't go and wait for me in the bedroom", "rejected"),
        ("go and turn left", "left 43"),
        ("go and go", "forward 1"),
        ("right now, slightly more", "again"),
    ],
)
def test_what_they_open(said: str, meant: str) -> None:
    assert does(said) == meant
