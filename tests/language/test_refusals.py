"""What a sentence is refused for is what the person who said it can put right."""

from __future__ import annotations

import pytest
from meanings import shipped

from intent_engine.interpretation import Status


@pytest.mark.parametrize("place", ["garage", "room 206", "gate b", "lab 4", "lab 4 b", "pantry", "attic stairs"])
@pytest.mark.parametrize("how", ["go to {}", "go to the {}", "drive to {}", "please navigate to the {}"])
def test_a_place_that_is_not_on_the_map_is_told_as_a_place(how, place):
    found = shipped().parse(how.format(place))
    assert found.status is Status.REJECTED
    assert found.reason == f"no place is called '{place}'"
    assert len(found.alternatives) == 3


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("turn floop ninety degrees", "no side is called 'floop'"),
        ("move floop two meters", "no direction is called 'floop'"),
        ("go forward two thousand meters", "more than the largest"),
    ],
)
def test_a_value_that_no_list_has_is_told_as_one_of_that_list(text, reason):
    found = shipped().parse(text)
    assert found.status is Status.REJECTED
    assert reason in found.reason
