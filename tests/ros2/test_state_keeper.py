"""The states of the robot, by parameter and by topic: the node in its own process, as it is started."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.ros2
ROOT = Path(__file__).resolve().parent.parent.parent

GRAMMAR = f"""
language: en
include: [{ROOT / "grammars/en.yaml"}]
intents:
  undock:
    action: {{type: custom, name: undock}}
    requires: [docked]
    sentences: [leave now]
  leave:
    action: {{type: custom, name: leave}}
    excludes: [docked]
    sentences: [leave now]
  hurry:
    action: {{type: custom, name: hurry}}
    requires: [moving]
    sentences: [hurry along]
  unload:
    action: {{type: custom, name: unload}}
    requires: [carrying]
    sentences: [unload it]
"""


def until(condition, what=""):
    from ros_stage import until as wait

    wait(condition, what)


@pytest.fixture(scope="module")
def grammar(tmp_path_factory):
    path = tmp_path_factory.mktemp("grammar") / "dock.yaml"
    path.write_text(GRAMMAR)
    return path


class Stage:
    """What a test says of states, and what it is told of them."""

    def __init__(self, peer) -> None:
        from rcl_interfaces.srv import GetParameters, SetParameters
        from std_msgs.msg import String

        self.peer, self.string, self.service = peer, String, SetParameters
        self.current: list[list[str]] = []
        self.hear_current(self.current)
        self.volatile = self.publisher(latched=False)
        self.client = peer.node.create_client(SetParameters, "intent_engine/set_parameters")
        self.getter = peer.node.create_client(GetParameters, "intent_engine/get_parameters")

    def publisher(self, latched: bool, topic: str = "voice_commands/state", **options):
        from rclpy.qos import DurabilityPolicy, QoSProfile

        durability = DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE
        return self.peer.node.create_publisher(
            self.string, topic, QoSProfile(depth=10, durability=durability), **options
        )

    def hear_current(self, into: list) -> None:
        from rclpy.qos import DurabilityPolicy, QoSProfile

        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.peer.node.create_subscription(
            self.string, "voice_commands/current_state", lambda message: into.append(json.loads(message.data)), latched
        )

    def say(self, text: str, by=None) -> None:
        by = by or self.volatile
        until(by.get_subscription_count, "the node hears of states")
        by.publish(self.string(data=text))

    def holds(self, *states: str) -> None:
        until(lambda: self.current and self.current[-1] == sorted(states), f"{states}, not {self.current[-1:]}")

    def set(self, value):
        """As ``ros2 param set`` does it."""
        from rclpy.parameter import Parameter

        until(self.client.service_is_ready)
        one = Parameter("states", value=value).to_parameter_msg()
        answer = self.client.call_async(self.service.Request(parameters=[one]))
        until(answer.done)
        return answer.result().results[0]

    def parameter(self) -> list[str]:
        from rcl_interfaces.srv import GetParameters

        until(self.getter.service_is_ready)
        answer = self.getter.call_async(GetParameters.Request(names=["states"]))
        until(answer.done)
        return list(answer.result().values[0].string_array_value)

    def understood(self, text: str) -> str | None:
        """The intent of a text that is said now; None: it was not accepted."""
        count = self.peer.heard_texts().count(text)
        self.peer.say(text)
        until(lambda: self.peer.heard_texts().count(text) > count)
        heard = [each["interpretation"] for each in list(self.peer.status) if each["event"] == "interpretation"]
        found = [each for each in heard if each["text"] == text][-1]
        return found["intent"] if found["status"] == "accepted" else None

    def told(self, event: str) -> list[dict]:
        return [each for each in list(self.peer.status) if each["event"] == event]


@pytest.fixture(scope="module")
def started(grammar):
    """A node that all tests of this module talk to."""
    from ros_stage import NodeProcess, Peer

    with Peer() as peer, NodeProcess(peer, grammar=grammar):
        peer.meet()
        yield Stage(peer)


@pytest.fixture
def stage(started):
    """The node, and a robot that stands and is in no state."""
    started.say("")
    assert started.set([]).successful
    started.holds()
    started.peer.forget()
    return started


def test_the_topic_says_all_states_and_the_last_message_holds(stage):
    assert stage.understood("leave now") == "leave"
    stage.say("docked")
    stage.holds("docked")
    assert stage.understood("leave now") == "undock"
    assert stage.understood("unload it") is None
    stage.say('["carrying"]')
    stage.holds("carrying")
    assert stage.understood("leave now") == "leave"
    assert stage.understood("unload it") == "unload"
    stage.say("docked, carrying")
    stage.holds("carrying", "docked")
    stage.say("")
    stage.holds()
    until(lambda: len(stage.told("state")) == 4)
    assert [each["states"] for each in stage.told("state")] == [["docked"], ["carrying"], ["carrying", "docked"], []]


def test_states_of_best_effort_are_heard_once(stage):
    from rclpy.qos import qos_profile_sensor_data

    robot = stage.peer.node.create_publisher(stage.string, "voice_commands/state", qos_profile_sensor_data)
    try:
        until(lambda: robot.get_subscription_count(), "the node hears whoever gives no guarantee")
        stage.say("docked", by=robot)
        stage.holds("docked")
        stage.say("carrying")
        stage.holds("carrying")
        until(lambda: len(stage.told("state")) >= 2)
        assert [each["states"] for each in stage.told("state")] == [["docked"], ["carrying"]]
    finally:
        stage.peer.node.destroy_publisher(robot)


def test_what_changes_nothing_is_not_told(stage):
    stage.say("docked")
    stage.say("docked docked")
    stage.say("carrying")
    stage.holds("carrying")
    until(lambda: len(stage.told("state")) >= 2)
    assert [each["states"] for each in stage.told("state")] == [["docked"], ["carrying"]]


def test_the_parameter_can_be_set_and_holds_beside_the_topic(stage):
    assert stage.set(["docked"]).successful
    stage.holds("docked")
    assert stage.understood("leave now") == "undock"
    stage.say("carrying")
    stage.holds("carrying", "docked")
    stage.say("")
    stage.holds("docked")
    assert stage.set("carrying docked").successful
    stage.holds("carrying", "docked")
    assert stage.set([]).successful
    stage.holds()
    assert stage.understood("leave now") == "leave"


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (["docked", "dockd"], "no intent of the grammar asks for a state 'dockd': did you mean 'docked'?"),
        ("asleep", "no intent of the grammar asks for a state 'asleep': there is carrying, docked, moving"),
        ([1, 2], "1 is no name of a state"),
        (True, "True is no list of states"),
        (None, "it cannot be deleted"),
    ],
)
def test_a_wrong_value_of_the_parameter_is_refused_with_the_reason(stage, value, said):
    assert stage.set(["docked"]).successful
    result = stage.set(value)
    assert not result.successful
    assert result.reason.startswith(f"parameter states: {said}")
    assert stage.parameter() == ["docked"]
    assert stage.understood("leave now") == "undock"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("dockd", "did you mean 'docked'"),
        ("[docked", "is no JSON"),
        ('{"docked": 1}', "is no list of states"),
        ("[" * 4000, "is no JSON"),
        ("carrying " * 5000, "45000 characters"),
        ("☃ \x07", "no intent of the grammar asks for a state '☃'"),
    ],
)
def test_a_wrong_message_is_told_and_changes_nothing(stage, text, said):
    stage.say("docked")
    stage.holds("docked")
    stage.say(text)
    until(lambda: stage.told("error"))
    (error,) = stage.told("error")
    assert said in error["detail"]
    assert error["detail"].endswith('the states are as they were: ["docked"]')
    assert stage.understood("leave now") == "undock"
    assert not any(any(twist) for twist in stage.peer.twists)
    assert not [each for each in stage.told("goal") if each["action"]["type"] != "custom"]


def test_states_do_not_touch_what_is_being_done(stage):
    """A command was begun in the states of its time; neither a change nor nonsense stops it, or lets it go. Nonsense
    changes nothing for what waits its turn either."""
    stage.say("docked")
    stage.holds("docked")
    stage.peer.say("turn left twenty degrees then leave now")
    until(stage.peer.moving)
    stage.say("[nonsense")
    until(lambda: len(stage.peer.goals("succeeded")) == 2)
    assert [goal["action"].get("name") for goal in stage.peer.goals("succeeded")] == [None, "undock"]
    stage.peer.say("turn left twenty degrees")
    until(stage.peer.moving)
    stage.say("")
    stage.holds()
    until(lambda: len(stage.peer.goals("succeeded")) == 3)
    assert not stage.peer.goals("aborted")
    assert stage.understood("leave now") == "leave"


def test_moving_is_known_whatever_is_said_of_it(stage):
    assert stage.understood("hurry along") is None
    stage.peer.say("go forward five meters")
    until(stage.peer.moving)
    stage.say("docked")
    stage.say("")
    assert stage.set([]).successful
    assert stage.understood("hurry along") == "hurry"
    stage.peer.forget()
    assert stage.understood("hurry along") is None
    # The base may be driven by somebody else.
    stage.say("moving")
    stage.holds("moving")
    assert stage.understood("hurry along") == "hurry"


def test_publishers_of_either_kind_are_heard(stage):
    latched = stage.publisher(latched=True)
    stage.say("docked", latched)
    stage.holds("docked")
    stage.say("carrying")
    stage.holds("carrying")
    stage.say("docked carrying", latched)
    stage.holds("carrying", "docked")
    topic = stage.volatile.topic_name
    until(lambda: stage.peer.node.count_subscribers(topic) == 2, "kept messages are asked for")
    stage.peer.node.destroy_publisher(latched)
    until(lambda: stage.peer.node.count_subscribers(topic) == 1, "nobody keeps messages, so nobody is asked for them")


def test_a_publisher_that_keeps_nothing_is_not_warned(stage):
    """As `ros2 topic pub` would be, in words that say that it is not heard."""
    from rclpy.event_handler import PublisherEventCallbacks

    warnings: list[object] = []
    keeps_nothing = stage.publisher(
        latched=False, event_callbacks=PublisherEventCallbacks(incompatible_qos=warnings.append)
    )
    stage.say("docked", keeps_nothing)
    stage.holds("docked")
    time.sleep(1.5)  # longer than it takes the node to look around
    assert warnings == []
    stage.peer.node.destroy_publisher(keeps_nothing)


def test_who_comes_late_is_told_the_states(stage):
    stage.say("docked")
    stage.holds("docked")
    late: list[list[str]] = []
    stage.hear_current(late)
    until(lambda: late == [["docked"]])


def test_a_late_node_hears_what_was_said_before(peer, grammar):
    from ros_stage import NodeProcess

    stage = Stage(peer)
    with NodeProcess(peer, grammar=grammar, states="[carrying]"):
        stage.holds("carrying")  # what it was started with is told before anything is heard
        latched = stage.publisher(latched=True)
        latched.publish(stage.string(data="docked"))
        stage.holds("carrying", "docked")
    stage.current.clear()
    with NodeProcess(peer, grammar=grammar, states="[carrying]"):
        peer.meet()
        stage.holds("carrying", "docked")
        assert stage.parameter() == ["carrying"]
        assert stage.understood("leave now") == "undock"
        assert stage.understood("unload it") == "unload"


@pytest.mark.parametrize(
    ("states", "said"),
    [
        ("[dockd]", "parameter states: no intent of the grammar asks for a state 'dockd'"),
        ("[1]", "parameter states: 1 is no name of a state"),
    ],
)
def test_a_mistake_in_the_parameter_ends_it_with_the_reason(peer, grammar, states, said):
    from ros_stage import NodeProcess

    node = NodeProcess(peer, grammar=grammar, states=states)
    assert node.wait() == 2, node.output
    assert said in node.output
    assert "Traceback" not in node.output


@pytest.mark.parametrize("texts", [("go forward two meters, then leave now",), ("go forward two meters", "later")])
def test_what_waits_its_turn_is_asked_for_its_states_when_it_comes(stage, texts):
    from std_msgs.msg import String

    done: list[str] = []
    topic = "voice_commands/action"
    ear = stage.peer.node.create_subscription(String, topic, lambda message: done.append(message.data), 10)
    until(lambda: stage.peer.node.count_publishers(f"{stage.peer.namespace}/{topic}"))
    for text in texts:
        assert stage.understood(text.replace("later", "when you get there, leave now, and turn left"))
    until(stage.peer.moving)
    stage.say("docked")
    stage.holds("docked")
    assert not stage.peer.goals("aborted"), "what is being done is not asked again"
    until(lambda: stage.peer.goals("aborted"))
    until(lambda: len(stage.peer.goals("canceled")) == len(texts) - 1)
    (refused,) = stage.peer.goals("aborted")
    assert (refused["action"]["name"], refused["reason"]) == ("leave", "forbidden")
    assert refused["detail"] == "leave cannot be done while the robot is docked"
    assert [each["reason"] for each in stage.peer.goals("canceled")] == ["earlier_failed"] * (len(texts) - 1)
    until(stage.peer.standing)
    assert done == []
    stage.peer.node.destroy_subscription(ear)
