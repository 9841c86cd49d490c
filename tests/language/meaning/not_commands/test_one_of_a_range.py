"""Two numbers of which one is meant: nothing is done, and it is told why."""

from __future__ import annotations

import pytest
from meanings import german, shipped


@pytest.mark.parametrize(
    ("language", "said", "named"),
    [
        ("en", "go forward two to four meters", "two to four"),
        ("en", "turn left ten or maybe", ""),
        ("en", "move one hundred to two hundred centimeters", "one hundred to two hundred"),
        ("en", "go back one or two steps", "one or two"),
        ("en", "two to four", ""),
        ("en", "don't go two to four meters", ""),
        ("en", "go to the kitchen or four", ""),
        ("de", "fahr zwei bis vier Meter vor", "zwei bis vier"),
    ],
)
def test_it_is_told_which_numbers_leave_it_open(language: str, said: str, named: str) -> None:
    found = (german() if language == "de" else shipped()).parse(said)
    assert not found.actions
    assert found.reason.startswith(f"'{named}' leaves open which number is meant") == bool(named)
