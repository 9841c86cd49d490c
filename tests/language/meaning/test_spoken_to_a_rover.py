"""What people say to a robot far away, which they see through its camera, and what only sounds like it."""

from __future__ import annotations

import pytest
from meanings import does, done, shipped

DONE = {
    # Asked, and approved of.
    "if you could move forward two meters": "forward 2",
    "try to turn left twenty degrees": "left 20",
    "try moving forward two meters": "forward 2",
    "I'd like for you to turn left": "left 43",
    "cool, now turn left": "left 43",
    "awesome turn right ninety degrees": "right 90",
    "go straight back two meters": "back 2",
    "adjust right ten degrees": "right 10",
    "shift to the left ten degrees": "left 10",
    "hard left": "left 43",
    "make a half turn": "left 180",
    "pull a one eighty": "left 180",
    "do a full three sixty": "left 360",
    # What is meant, and not the other.
    "turn left, not right": "left 43",
    "turn left rather than right": "left 43",
    "left not right": "left 43",
    "move forward two meters not three": "forward 2",
    "turn left ninety degrees, not forty five": "left 90",
    "go to the kitchen not the bedroom": "to kitchen",
    # Stops.
    "dude stop": "stop",
    "shit stop": "stop",
    "try to stop": "stop",
    "stop completely": "stop",
    "come to a complete stop": "stop",
    "everybody stop": "stop",
    "pause there": "stop",
}
NOT_DONE = [
    "turn left not right now",
    "turn left not yet",
    "turn left not left",
    "turn left not ninety degrees",
    "move not left",
    "move not back",
    "turn right not left ninety degrees",
    "don't turn left not right",
    "you said left not right",
    "turn left not right not back",
    "yeah right",
    "right okay",
    "oh right",
    "go forward is",
    "moving forward is slow",
    "take the cup back",
    "follow me and stay",
    "follow me and stop",
    "what if you could turn left",
]


@pytest.mark.parametrize(("said", "meant"), DONE.items())
def test_it_is_done(said: str, meant: str) -> None:
    assert does(said) == meant


@pytest.mark.parametrize("said", NOT_DONE)
def test_it_is_not_done(said: str) -> None:
    assert shipped().parse(said).actions == ()


def test_what_only_a_stop_ends_is_not_begun_with_one() -> None:
    found = shipped().parse("follow me and stay")
    assert found.reason == "'stay' would end at once what was told before it; say one of them"
    assert found.alternatives == ("follow", "stay")
    assert done(shipped().parse("come here and stay")) == "come"
