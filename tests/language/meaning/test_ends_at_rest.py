"""A stop that is joined to a command at last: it is how the command ends, or it ends something else."""

from __future__ import annotations

import pytest
from meanings import done, german, shipped


@pytest.mark.parametrize(
    ("said", "stop"),
    [
        ("go to the kitchen and stop", "stop"),
        ("go to the kitchen and wait there", "wait there"),
        ("release it and wait there", "wait there"),
        ("drop the cup and stay", "stay"),
        ("turn left and stop turning", "stop turning"),
        ("go forward for two seconds and then stop the robot", "stop the robot"),
        ("turn left and hit the brakes", "hit the brakes"),
        ("turn left and stop rolling", "stop rolling"),
    ],
)
def test_words_that_change_nothing_are_told(said, stop):
    engine = shipped()
    found, without = engine.parse(said), engine.parse(said.rsplit(" and ", 1)[0])
    assert found.actions == without.actions != ()
    assert found.reason == f"every command ends at rest, also without {stop!r}"
    assert not without.reason


@pytest.mark.parametrize(
    "said",
    [
        "turn left and stop following me",
        "turn left and cancel the mission",
        "go to the kitchen and cancel everything",
        "go to the kitchen and stop the navigation",
        "drop the cup and kill the motors",
        "turn left and abort the mission",
        "follow me and stop following me",
        "go to the kitchen, turn left and quit following us",
    ],
)
def test_what_ends_something_else_is_no_end_of_the_command(said):
    assert done(shipped().parse(said)) == "stop"


def test_it_is_so_in_german():
    assert done(german().parse("dreh dich nach links und hör auf mir zu folgen")) == "stop"
    assert done(german().parse("fahr vor und brich die Fahrt ab")) == "stop"
    assert done(german().parse("dreh dich nach links und stopp den Roboter")) == "left 43"
    assert german().parse("nimm die Tasse und warte").reason == "every command ends at rest, also without 'warte'"
