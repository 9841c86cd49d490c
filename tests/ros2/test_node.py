"""Text in, velocities out: the node in its own process, as it is started."""

from __future__ import annotations

import json
import math
import time

import pytest

pytestmark = pytest.mark.ros2


@pytest.fixture
def talk(driven):
    """The shared peer, with nothing left of the test before."""
    peer, _ = driven
    peer.forget()
    return peer


def until(condition, what=""):
    from ros_stage import until as wait

    wait(condition, what)


def test_text_drives(talk, engine):
    talk.say("go forward half a meter")
    until(lambda: talk.goals("succeeded"))
    until(talk.come_to_rest)
    until(lambda: talk.twists[-3:] == [(0.0, 0.0)] * 3)
    assert set(talk.moved()) == {(0.5, 0.0)}
    assert len(talk.moved()) >= 10  # 1 s at 20 Hz, on a machine that has other things to do
    until(lambda: talk.commands)
    (command,) = talk.commands
    assert json.loads(command) == engine.parse("go forward half a meter").to_json()


def test_a_turn_to_the_right_is_negative(talk):
    talk.say("turn right ten degrees")
    until(lambda: talk.goals("succeeded"))
    until(talk.come_to_rest)
    assert set(talk.moved()) == {(0.0, -0.5)}


def test_what_waits_its_turn_and_is_denied_stops_the_robot(talk):
    talk.say("go forward five meters, then bring me the screwdriver")
    until(talk.moving)
    talk.say("don't bring me the hammer")
    talk.say("don't bring me the screwdriver")
    until(talk.standing)
    until(lambda: len(talk.goals("canceled")) == 2)
    assert not talk.goals("succeeded")


def test_stop_text_stops_and_nothing_follows(talk):
    talk.say("go forward five meters")
    until(talk.moving)
    talk.say("stop")
    until(talk.standing)
    until(lambda: talk.goals("canceled"))  # now its velocity process has been halted, too
    talk.silence()
    assert talk.standing()
    assert [goal["reason"] for goal in talk.goals("canceled")] == ["stop"]


def test_what_is_no_command_moves_nothing(talk):
    for text in ["don't move forward", "I was going to go to the kitchen", "", "  ", "vorwärts ☃", "x " * 5000, "\0"]:
        talk.say(text)
    talk.say("turn left")
    until(lambda: "turn left" in talk.heard_texts() and talk.commands)
    assert [json.loads(command)["intent"] for command in talk.commands] == ["turn"]
    statuses = [e["interpretation"]["status"] for e in talk.status if e["event"] == "interpretation"]
    assert "accepted" not in statuses[:-1]


def test_a_newer_command_takes_the_place_of_the_older(talk):
    talk.say("go forward five meters")
    until(talk.moving)
    talk.say("turn left")
    until(lambda: talk.twists and talk.twists[-1] == (0.0, 0.5))
    until(lambda: talk.goals("canceled"))  # another topic, which may come later
    assert [goal["reason"] for goal in talk.goals("canceled")] == ["preempted"]


def test_what_was_said_right_after_a_motion_puts_it_right(talk):
    talk.say("turn left ninety degrees")
    until(talk.moving)
    talk.amend("turn left ninety degrees no sixty degrees")
    until(lambda: talk.goals("succeeded"))
    until(lambda: len(talk.commands) == 2)
    assert [goal["reason"] for goal in talk.goals("canceled")] == ["preempted"]
    assert talk.goals("succeeded")[0]["action"]["angle"] == pytest.approx(math.radians(60), abs=1e-3)
    assert json.loads(talk.commands[-1])["text"] == "turn left ninety degrees no sixty degrees"


def test_an_unfinished_sentence_is_answered_by_the_next_text(talk):
    talk.say("go forward by")
    talk.say("half a meter")
    until(lambda: talk.goals("succeeded") and talk.commands)
    assert json.loads(talk.commands[-1])["text"] == "go forward by, half a meter"


def test_a_stop_ends_what_was_asked(talk):
    talk.say("go forward by")
    talk.say("stop")
    talk.say("half a meter")
    talk.say("turn left ten degrees")
    until(lambda: len(talk.goals("succeeded")) == 2)
    assert [goal["action"]["type"] for goal in talk.goals("succeeded")] == ["stop", "turn"]


def test_again_does_what_was_done_last(talk):
    talk.say("turn left ten degrees")
    until(lambda: talk.goals("succeeded"))
    talk.say("do that again")
    until(lambda: len(talk.goals("succeeded")) == len(talk.commands) == 2)
    first, second = (goal["action"] for goal in talk.goals("succeeded"))
    assert first == second
    assert json.loads(talk.commands[-1])["actions"] == [first]


def test_what_was_taken_back_is_not_done_again(talk):
    talk.say("turn left ten degrees")
    until(lambda: talk.goals("succeeded"))
    talk.say("no, the thing")
    talk.say("do that again")
    talk.say("turn right ten degrees")
    until(lambda: len(talk.goals("succeeded")) == 2)
    assert [goal["action"]["angle"] > 0 for goal in talk.goals("succeeded")] == [True, False]


def test_it_is_what_was_picked_up(talk):
    """As is told: this robot has no arm."""
    talk.say("pick up the bottle")
    until(lambda: talk.goals("rejected"))
    talk.say("bring it to the kitchen")
    until(lambda: len(talk.commands) == 2)
    assert "bottle" in json.dumps(json.loads(talk.commands[-1])["actions"])


@pytest.mark.parametrize("stop", ["stop", ""])
def test_after_a_stop_nothing_is_done_again(talk, stop):
    talk.say("turn left ninety degrees")
    until(talk.moving)
    talk.say(stop) if stop else talk.halt()
    until(lambda: talk.goals("canceled"))
    until(talk.standing)
    talk.silence()
    talk.twists.clear()
    talk.say("again")
    until(lambda: "again" in talk.heard_texts())
    found = [e["interpretation"] for e in talk.status if e["event"] == "interpretation"][-1]
    assert (found["status"], found["reason"]) == ("rejected", "nothing was done yet that could be done again")
    assert not any(any(twist) for twist in talk.twists)


@pytest.mark.parametrize(
    ("way", "then"),
    [
        ("amend", "turn left twenty degrees, and then go forward ten centimeters"),
        ("say", "when you get there, go forward ten centimeters"),
    ],
)
def test_what_is_for_later_waits_its_turn(talk, way, then):
    talk.say("turn left twenty degrees")
    until(talk.moving)
    getattr(talk, way)(then)
    until(lambda: len(talk.goals("succeeded")) == 2)
    assert not talk.goals("canceled")
    until(lambda: (0.5, 0.0) in talk.twists and talk.standing())
    assert list(dict.fromkeys(talk.moved())) == [(0.0, 0.5), (0.5, 0.0)]


def test_what_is_meant_instead_is_done_after_the_no_has_stopped_it(talk):
    talk.say("turn left ninety degrees")
    until(talk.moving)
    talk.halt()
    until(talk.standing)
    talk.amend("turn left ninety degrees no right ten degrees")
    until(lambda: talk.goals("succeeded"))
    assert talk.goals("succeeded")[0]["action"]["angle"] == pytest.approx(math.radians(-10), abs=1e-3)


@pytest.mark.parametrize("first", ["go forward ten centimeters", "stop", "what lovely weather"])
def test_what_does_not_go_on_from_what_is_done_is_not_done(talk, first):
    talk.say(first)
    until(lambda: first in talk.heard_texts())
    talk.amend("turn left ninety degrees")
    until(lambda: "turn left ninety degrees" in talk.heard_texts())
    reason = [e["interpretation"]["reason"] for e in talk.status if e["event"] == "interpretation"][-1]
    assert "does not go on" in reason
    assert (0.0, 0.5) not in talk.twists


def test_what_goes_on_and_means_the_same_is_not_done_twice(talk):
    talk.say("turn left twenty degrees")
    until(talk.moving)
    talk.amend("turn left twenty degrees please")
    until(lambda: talk.goals("succeeded") and "turn left twenty degrees please" in talk.heard_texts())
    reason = [e["interpretation"]["reason"] for e in talk.status if e["event"] == "interpretation"][-1]
    assert "means the same" in reason
    until(lambda: talk.commands)
    assert len(talk.goals("succeeded")) == len(talk.commands) == 1


def test_a_stop_after_a_motion_stops_it(talk):
    talk.say("go forward five meters")
    until(talk.moving)
    talk.amend("go forward five meters no stop")
    until(talk.standing)
    until(lambda: talk.goals("canceled"))
    assert talk.goals("canceled")[0]["reason"] == "stop"


def test_several_commands_in_one_sentence(talk):
    talk.say("go forward ten centimeters then turn left ten degrees")
    until(lambda: len(talk.goals("succeeded")) == 2)
    until(lambda: (0.0, 0.5) in talk.twists and talk.standing())
    assert list(dict.fromkeys(talk.moved())) == [(0.5, 0.0), (0.0, 0.5)]


def test_faster_than_allowed_is_driven_at_the_limit_and_said(talk):
    talk.say("go forward 10 centimeters at 2 meters per second")
    until(lambda: talk.goals("succeeded"))
    until(talk.come_to_rest)
    assert set(talk.moved()) == {(0.5, 0.0)}
    assert "cut from 2 to 0.5 m/s" in talk.goals("succeeded")[0]["detail"]


def test_what_is_driven_is_driven_slower_and_just_as_far(talk):
    talk.say("go forward half a meter")
    until(talk.moving)
    talk.say("slow down")
    until(lambda: len(talk.goals("succeeded")) == len(talk.commands) == 2)
    change, motion = talk.goals("succeeded")
    assert change["detail"] == "from 0.5 to 0.25 m/s"
    assert (motion["action"]["linear_velocity"], motion["action"]["distance"]) == (0.25, 0.5)
    until(lambda: (0.25, 0.0) in talk.twists and talk.standing())
    assert set(talk.moved()) == {(0.5, 0.0), (0.25, 0.0)}
    assert json.loads(talk.commands[-1])["actions"] == [{"type": "change_speed", "factor": 0.5}]


def test_a_robot_that_stands_goes_no_faster(talk):
    talk.say("faster")
    until(lambda: talk.goals("rejected"))
    assert talk.goals("rejected")[0]["reason"] == "nothing_moves"


def test_the_other_way_takes_the_place_of_what_is_driven(talk):
    talk.say("turn left ninety degrees")
    until(talk.moving)
    talk.say("no, the other way")
    until(lambda: talk.goals("succeeded"))
    left, right = talk.goals("canceled")[0]["action"], talk.goals("succeeded")[0]["action"]
    assert right == {**left, "angle": -left["angle"], "angular_velocity": -left["angular_velocity"]}


def test_a_robot_without_an_arm_refuses_to_pick(talk):
    talk.say("pick up the bottle")
    until(lambda: talk.goals("rejected"))
    assert talk.goals("rejected")[0]["reason"] == "capability"


def test_navigation_without_a_server_says_so(talk):
    talk.say("go to the kitchen")
    until(lambda: talk.goals("aborted"))
    assert "is the navigation running" in talk.goals("aborted")[0]["detail"]


def test_stop_service(talk):
    from std_srvs.srv import Trigger

    client = talk.node.create_client(Trigger, "stop")
    until(client.service_is_ready)
    talk.say("go forward five meters")
    until(talk.moving)
    answer = client.call_async(Trigger.Request())
    until(answer.done)
    assert answer.result().success
    until(talk.standing)
    talk.node.destroy_client(client)


def test_hold_and_release(talk):
    from std_msgs.msg import Bool

    talk.say("go forward one meter")
    until(talk.moving)
    talk.hold.publish(Bool(data=True))
    until(talk.standing)
    assert not talk.goals("canceled")
    talk.hold.publish(Bool(data=False))
    until(talk.moving)
    until(lambda: talk.goals("succeeded"))


def test_a_flood_of_commands_ends_where_the_last_one_says(talk):
    for number in range(300):
        talk.say("go forward five meters" if number % 2 else "turn left")
    time.sleep(0.1)
    talk.say("stop")
    until(lambda: "stop" in talk.heard_texts())
    until(talk.standing)
    talk.silence()
    assert talk.standing()
