"""Every way in which the node ends, or hangs, or is late: the robot stands."""

from __future__ import annotations

import importlib.util
import json
import signal
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.ros2
ROOT = Path(__file__).resolve().parent.parent.parent


def driving(peer, **parameters):
    """A node that drives 20 m."""
    from ros_stage import NodeProcess, until

    node = NodeProcess(peer, **parameters)
    peer.meet()
    peer.say("go forward twenty meters")
    until(peer.moving)
    return node


def stays_still(peer) -> bool:
    """Whether it stands when no velocity comes any more, and the node's processes have had time to say otherwise."""
    peer.silence(0.5)
    return peer.come_to_rest()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_clean_end_leaves_zero_and_no_process(peer, number):
    from ros_stage import alive, until

    node = driving(peer)
    children = node.children()
    assert children  # the velocity's own process
    assert node.end(number) == 0, node.output
    until(peer.standing)
    assert stays_still(peer)
    until(lambda: not any(alive(pid) for pid in children))
    assert "Traceback" not in node.output


def test_a_killed_node_leaves_zero(peer):
    from ros_stage import alive, until

    node = driving(peer)
    children = node.children()
    node.process.kill()
    until(peer.standing)
    assert stays_still(peer)
    node.wait()
    until(lambda: not any(alive(pid) for pid in children))


def test_a_frozen_node_leaves_zero(peer):
    from ros_stage import until

    with driving(peer) as node:
        node.freeze()
        until(peer.standing)
        assert stays_still(peer)
        node.process.send_signal(signal.SIGCONT)
        until(lambda: peer.goals("aborted"))
        assert peer.goals("aborted")[0]["reason"] == "watchdog"
        assert stays_still(peer)


def test_a_killed_velocity_process_leaves_zero_until_it_is_reset(peer):
    import os

    from ros_stage import until
    from std_srvs.srv import Trigger

    with driving(peer) as node:
        # By their names, not their number: the middleware counts one that was killed for a while yet.
        def writers() -> set[bytes]:
            there = peer.node.get_publishers_info_by_topic(f"{peer.namespace}/cmd_vel")
            return {bytes(each.endpoint_gid) for each in there}

        before = writers()
        (child,) = node.children()
        os.kill(child, signal.SIGKILL)
        until(peer.standing)
        until(lambda: peer.goals("aborted"))
        assert peer.goals("aborted")[0]["reason"] == "velocity_loop"
        assert stays_still(peer)
        peer.say("turn left")
        until(lambda: peer.goals("rejected"))
        client = peer.node.create_client(Trigger, "intent_engine/reset")
        until(client.service_is_ready)
        answer = client.call_async(Trigger.Request())
        until(answer.done)
        assert answer.result().success
        until(lambda: writers() - before, "the new process publishes")
        peer.say("go forward five meters")
        until(peer.moving)


def test_without_a_guardian_the_end_leaves_zero_too(peer):
    from ros_stage import NodeProcess, until

    node = NodeProcess(peer, guardian=False)
    peer.meet(velocities=1)
    peer.say("go forward twenty meters")
    until(peer.moving)
    assert node.children() == []
    assert node.end() == 0
    until(peer.standing)
    assert stays_still(peer)


def test_text_that_waited_too_long_is_not_acted_on_but_a_stop_is(peer):
    from ros_stage import NodeProcess, until

    with NodeProcess(peer, expire_after=0.5) as node:
        peer.meet()
        node.freeze()
        peer.say("go forward one meter")
        peer.say("stop")
        time.sleep(1.0)
        node.process.send_signal(signal.SIGCONT)
        until(lambda: peer.goals("rejected") and peer.goals("succeeded"))
        assert peer.goals("rejected")[0]["reason"] == "expired"
        assert peer.goals("succeeded")[0]["action"] == {"type": "stop"}
        assert not any(any(twist) for twist in peer.twists)


def test_simulated_time(peer):
    """A second is a second of the simulator: none goes by while it stands still."""
    from builtin_interfaces.msg import Time
    from ros_stage import NodeProcess, until
    from rosgraph_msgs.msg import Clock

    now = [100.0]
    clock = peer.node.create_publisher(Clock, "/clock", 1)

    def tick(seconds: float) -> None:
        now[0] += seconds
        clock.publish(Clock(clock=Time(sec=int(now[0]), nanosec=int(now[0] % 1 * 1e9))))

    with NodeProcess(peer, use_sim_time=True) as node:
        until(lambda: clock.get_subscription_count() and peer.text.get_subscription_count())
        peer.meet(velocities=1)
        assert node.children() == []

        def knows_the_time() -> bool:
            tick(0.0)
            peer.say("what lovely weather")
            time.sleep(0.02)
            return any(each["time"] >= now[0] for each in list(peer.status))

        until(knows_the_time, "the node hears the simulator")
        peer.say("go forward one meter")  # 2 s
        until(peer.moving)
        time.sleep(0.5)
        assert not peer.goals("succeeded")
        for _ in range(19):
            tick(0.1)
            time.sleep(0.02)
        assert not peer.goals("succeeded")
        for _ in range(3):
            tick(0.1)
            time.sleep(0.02)
        until(lambda: peer.goals("succeeded"))
        # The simulator is reset in the middle of a motion: the robot is stopped, and can be told to move again.
        peer.say("go forward one meter")
        until(lambda: len(peer.goals("executing")) == 2)
        tick(-50.0)
        until(lambda: peer.goals("canceled"))
        until(peer.standing)
        tick(0.1)
        peer.say("turn left")
        until(lambda: len(peer.goals("executing")) == 3)
        # A simulator that is paused lets no time go by; a stop needs none.
        peer.say("stop")
        until(lambda: len(peer.goals("canceled")) == 2)
        until(peer.standing)


def test_without_a_simulators_time_nothing_begins_and_the_reason_is_told(peer):
    from ros_stage import NodeProcess, until

    with NodeProcess(peer, use_sim_time=True):
        peer.meet(velocities=1)
        for text in ("go forward one meter", "stop"):
            peer.say(text)
        until(lambda: "stop" in peer.heard_texts())
        found = [each["interpretation"] for each in peer.status if each["event"] == "interpretation"]
        assert [each["status"] for each in found] == ["rejected", "accepted"]
        assert "no time has come on /clock" in found[0]["reason"]
        until(lambda: peer.goals("succeeded"))
        assert not any(any(twist) for twist in peer.twists)


def test_stamped_by_parameter():
    from ros_stage import NodeProcess, Peer, until

    with Peer(stamped=True) as stamped, NodeProcess(stamped, stamped=True, frame_id="base_footprint"):
        stamped.meet()
        # Long enough for the middleware of a busy machine, which brings the two together when it comes to it.
        stamped.say("turn left")
        until(lambda: (0.0, 0.5) in stamped.twists)
        until(lambda: stamped.goals("succeeded"))
        assert set(stamped.frames) == {"base_footprint"}


def test_what_is_subscribed_to_is_what_is_sent():
    """The base comes up after the node, and takes TwistStamped."""
    from geometry_msgs.msg import TwistStamped
    from ros_stage import NodeProcess, Peer, until

    with Peer(stamped=None) as late, NodeProcess(late):
        late.meet()
        kinds = lambda: {  # noqa: E731
            info.topic_type for info in late.node.get_publishers_info_by_topic(f"{late.namespace}/cmd_vel")
        }
        assert kinds() == {"geometry_msgs/msg/Twist"}
        late.listen(TwistStamped)
        until(lambda: kinds() == {"geometry_msgs/msg/TwistStamped"})
        # Long enough for the middleware of a busy machine, which brings the two together when it comes to it.
        late.say("go forward five meters")
        until(lambda: (0.5, 0.0) in late.twists)


def test_names_can_be_remapped_and_commands_have_the_form_of_the_tutorials(peer):
    from geometry_msgs.msg import Twist
    from ros_stage import NodeProcess, until

    peer.listen(Twist, "base/cmd")
    with NodeProcess(peer, "-r", "cmd_vel:=base/cmd", "-r", "__node:=ears", command_form="tutorial", rate=10) as node:
        peer.meet("base/cmd")
        peer.say("go to the kitchen")
        until(lambda: peer.goals("aborted"))
        peer.say("turn left")
        until(lambda: (0.0, 0.5) in peer.twists)
        until(lambda: peer.goals("succeeded"))
        until(lambda: len(peer.commands) == 2)
        assert peer.commands == ["navigate:go to the kitchen", "turn:turn left"]
        until(lambda: "ears" in peer.node.get_node_names())
        assert node.end() == 0
    assert "/base/cmd" in node.output


def test_wrong_parameters_are_told_all_at_once_and_end_it(peer):
    from ros_stage import NodeProcess

    node = NodeProcess(
        peer, max_linear=-1, rate=2, ttl=0.1, stamped="maybe", guardian=3, max_angular="fast", robot="nonesuch",
        journal="[a, b]", navigate_to_pose="/go//there",
    )  # fmt: skip
    assert node.wait() == 2
    for name in ("max_linear: -1 is not a number above zero", "rate and ttl", "stamped: 'maybe'", "guardian: 3",
                 "max_angular: 'fast'", "nonesuch", "journal: ['a', 'b'] is not one text",
                 "navigate_to_pose: '/go//there' is not a name"):  # fmt: skip
        assert name in node.output
    assert "Traceback" not in node.output


def test_a_parameter_of_another_name_is_told_and_what_was_meant(peer, tmp_path):
    from ros_stage import NodeProcess, until

    file = tmp_path / "robot.yaml"
    file.write_text(
        "/**:\n  ros__parameters: {max_liner: 0.2, wheels: 4, max_angular: 0.3,\n"
        "    qos_overrides./parameter_events.publisher.depth: 10}\n"
    )
    with NodeProcess(peer, "--params-file", str(file)) as node:
        peer.meet()
        peer.say("turn left")
        until(lambda: (0.0, 0.3) in peer.twists)
        assert node.end() == 0
    told = [line.split("]: ")[1] for line in node.output.splitlines() if "this node has none" in line]
    assert sorted(told) == [
        "parameter max_liner: this node has none of that name, and goes on without it; did you mean 'max_linear'?",
        "parameter wheels: this node has none of that name, and goes on without it",
    ]


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["-p", "grammar:=no_such.yaml"], 2, "no_such.yaml"),
        (["-p", "grammar:=[]"], 2, "parameter grammar: [] is not a name, or a list of names"),
        (["-p", "navigation:=action"], 6, "nav2_msgs is not installed"),
        (["-p", "broken"], 2, "broken"),
        (["-p", "max_angular:=90"], 2, "90 degrees a second are math.radians(90)"),
        (["-r", "cmd_vel:=not a name"], 2, "not a name"),
        (["--", "turn left"], 2, "'turn left' is not understood"),
    ],
)
def test_other_mistakes_end_it_with_a_reason(peer, arguments, code, said):
    from ros_stage import NodeProcess

    if "nav2_msgs" in said and importlib.util.find_spec("nav2_msgs") is not None:
        pytest.skip("nav2_msgs is installed here")
    node = NodeProcess(peer, *arguments)
    assert node.wait() == code, node.output
    assert said in node.output
    assert "Traceback" not in node.output


def test_a_robot_file_and_a_journal(peer, tmp_path):
    from ros_stage import NodeProcess, until

    path, file = tmp_path / "journal.jsonl", tmp_path / "robot.yaml"
    file.write_text("name: mine\nlimits: {linear_velocity: {max: 0.22, over: clamp}}\ncapabilities: [move]\n")
    with NodeProcess(peer, robot=file, journal=path):
        peer.meet()
        peer.say("go forward one meter")
        until(lambda: peer.goals("succeeded"))
        until(peer.come_to_rest)
        assert max(twist[0] for twist in peer.twists) <= 0.22
        peer.say("turn left ten degrees")
        until(lambda: peer.goals("rejected"))
        assert peer.goals("rejected")[0]["detail"] == "this robot cannot turn"
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    assert any(line.get("text") == "go forward one meter" for line in lines)


def test_actions_of_others_are_handed_over_when_their_turn_comes(peer, tmp_path):
    from ros_stage import NodeProcess, until
    from std_msgs.msg import String

    grammar = tmp_path / "wave.yaml"
    grammar.write_text(
        f"language: en\ninclude: [{ROOT / 'grammars/en.yaml'}]\nintents:\n  wave:\n"
        "    action: {type: custom, name: wave}\n    sentences: [wave your arm]\n"
    )
    actions: list[tuple[dict, int]] = []
    peer.node.create_subscription(
        String,
        "voice_commands/action",
        lambda message: actions.append((json.loads(message.data), sum(map(any, peer.twists)))),
        10,
    )
    with NodeProcess(peer, grammar=grammar, robot="arm_mobile"):
        peer.meet()
        until(lambda: peer.node.count_publishers(f"{peer.namespace}/voice_commands/action"))
        # Far enough for the middleware of a busy machine to bring the two together.
        peer.say("go forward one meter then wave your arm and pick up the bottle")
        until(lambda: len(peer.goals("succeeded")) == 3)
        until(lambda: len(actions) == 2)
    until(lambda: len(actions) == 3)
    assert actions.pop()[0] == {"type": "stop"}  # the node has ended
    assert [action for action, _ in actions] == [
        {"type": "custom", "name": "wave", "slots": {}},
        {"type": "pick", "object": "bottle"},
    ]
    assert all(driven > 0 for _, driven in actions)
