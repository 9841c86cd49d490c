""" "Not the kitchen", long after the robot set out for it."""

from __future__ import annotations

import pytest
from continuing_stage import Talk

from intent_engine.execution.goal import GoalState


@pytest.mark.parametrize(
    ("command", "said", "ends"),
    [
        ("go to the kitchen", "not the kitchen", True),
        ("go to the kitchen", "not the bedroom", False),
        ("turn left two full turns", "not left", True),
    ],
)
@pytest.mark.parametrize("pause", [0.8, 2.0])
def test_it_ends_where_it_is_what_is_done(command, said, ends, pause):
    (goal,) = Talk(command, said, pause=pause).done[0].goals
    assert goal.state is (GoalState.CANCELED if ends else GoalState.SUCCEEDED)
