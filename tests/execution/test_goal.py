"""What a goal, an event and an executor say to who wants to copy them."""

from __future__ import annotations

import copy
import pickle

import pytest

from intent_engine import Move


@pytest.mark.parametrize("copied", [pickle.dumps, copy.copy, copy.deepcopy], ids=lambda copied: copied.__name__)
def test_a_goal_and_an_executor_cannot_be_copied_and_say_what_to_do(stage, copied):
    s = stage()
    (goal,) = s.executor.submit(Move(0.5, 1.0, 2.0))
    with pytest.raises(TypeError, match=r"hand on goal\.action, or what goal\.to_json\(\)"):
        copied(goal)
    with pytest.raises(TypeError, match="share it between threads"):
        copied(s.executor)
    if copied is not copy.copy:
        with pytest.raises(TypeError, match=r"event\.to_json\(\)"):
            copied(s.events[0])
