"""The node and Nav2's own action type, made here: every field arrives, and a goal's end says why."""

from __future__ import annotations

import importlib.util
import math
import os

import pytest

pytestmark = [pytest.mark.ros2, pytest.mark.slow]

MAP = """
locations:
  near: {x: 50.0, y: 2.0, yaw: 1.5707963}
  dock: {x: 200.0, y: 0.0, yaw: 0.0}
  far: {x: 3000.0, y: 0.0, yaw: 0.0}
  nowhere: {x: 27.0, y: 0.0, yaw: 0.0}
"""


@pytest.fixture(scope="module")
def with_nav2(tmp_path_factory):
    """Programs that are started now find nav2_msgs."""
    if importlib.util.find_spec("nav2_msgs") is not None:
        yield
        return
    import nav2_types

    try:
        variables = nav2_types.build(tmp_path_factory.mktemp("types"))
    except nav2_types.CannotBuildError as error:
        pytest.skip(str(error))
    with pytest.MonkeyPatch.context() as patch:
        for name, folder in variables.items():
            patch.setenv(name, folder, prepend=os.pathsep)
        yield


@pytest.fixture(scope="module")
def stage(with_nav2, tmp_path_factory):
    from ros_stage import NodeProcess, Peer, Server, until

    places = tmp_path_factory.mktemp("map") / "places.yaml"
    places.write_text(MAP)
    with Peer() as peer, NodeProcess(peer, locations=places, navigation="action") as node:
        server = Server(peer.namespace, "nav2")
        peer.meet()
        until(lambda: server.said)
        # The node and the server have to find each other too, which only the node can tell.
        for _ in range(20):
            peer.forget()
            peer.say("go to near")
            until(lambda: peer.goals("succeeded") or peer.goals("aborted"), "the first goal ends")
            if peer.goals("succeeded"):
                break
        server.told()
        server.said.clear()
        yield peer, server, node
        server.end()


def test_a_goal_arrives_whole_and_its_progress_comes_back(stage):
    from ros_stage import until

    peer, server, _ = stage
    peer.forget()
    peer.say("go to near")
    until(lambda: peer.goals("succeeded"))
    server.told()
    (driven,) = [each for each in server.said if each.get("state") == "driving"]
    assert (driven["frame"], driven["at"]) == ("map", [50.0, 2.0])
    assert driven["facing"] == pytest.approx([math.sin(math.pi / 4), math.cos(math.pi / 4)])
    feedback = [each for each in peer.status if each["event"] == "feedback"]
    assert feedback[-1]["pose"]["x"] == 1.5
    assert any(each["progress"] and 0 < each["progress"] < 1 for each in feedback)


def test_a_failure_says_why_in_nav2s_words(stage):
    from ros_stage import until

    peer, _, _ = stage
    peer.forget()
    peer.say("go to nowhere")
    until(lambda: peer.goals("aborted"))
    assert peer.goals("aborted")[0]["detail"] == "the map has no way there"


def test_stop_text_ends_it(stage):
    from ros_stage import until

    peer, server, _ = stage
    peer.forget()
    for _ in range(10):
        peer.say("go to near")  # when it is there nothing is being ended any more that the next would wait for
        until(lambda: any(goal["action"].get("location") == "near" for goal in peer.goals("succeeded")))
        server.told()
        server.said.clear()
        peer.status.clear()
        peer.say("go to far")
        peer.say("stop")
        until(lambda: peer.goals("canceled"))
        until(lambda: server.count("driving") == server.count("canceled") == 1)


def test_a_hold_ends_it_and_a_release_gives_it_again(stage):
    from ros_stage import until
    from std_msgs.msg import Bool

    peer, server, _ = stage
    peer.forget()
    server.told()
    server.said.clear()
    peer.say("go to the dock")
    until(lambda: server.count("driving") == 1)
    peer.hold.publish(Bool(data=True))
    until(lambda: server.count("canceled") == 1)
    peer.hold.publish(Bool(data=False))
    until(lambda: peer.goals("succeeded"))
    until(lambda: server.count("succeeded") == 1)
    assert server.count("driving") == 2
