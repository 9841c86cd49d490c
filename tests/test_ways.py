"""Which way actions go."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.ways import opposite_ways, ways

ENGINE = shipped()
SAID = ["go forward", "go back two meters", "turn left", "turn right ninety degrees", "pick up the cup", "stop"]


@pytest.mark.parametrize(
    ("text", "going"),
    [
        ("go forward two meters then turn left", (1, 2)),
        ("turn right and go back", (-2, -1)),
        ("go to the kitchen and turn right", (0, -2)),
        ("pick up the cup", (0,)),
    ],
)
def test_forward_and_left_are_ahead_of_back_and_right(text, going):
    assert ways(ENGINE.parse(text).actions) == going


@given(st.data())
def test_the_opposite_is_never_the_same_and_is_so_for_both(data: st.DataObject):
    several = st.lists(st.sampled_from(SAID), min_size=1, max_size=3)
    one, other = ([action for text in data.draw(several) for action in ENGINE.parse(text).actions] for _ in range(2))
    assert not opposite_ways(one, one)
    assert opposite_ways(one, other) == opposite_ways(other, one)
    assert not opposite_ways(one, other) or len(one) == len(other)
    assert not opposite_ways(one, other) or any(ways(one))
