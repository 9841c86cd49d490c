"""Sound to a moving robot through two nodes of ours and three processes, with the real recogniser."""

from __future__ import annotations

import math

import pytest

pytestmark = [pytest.mark.ros2, pytest.mark.slow]


@pytest.fixture(scope="module")
def recording(root, tmp_path_factory):
    """The first sentence of the demo."""
    import json

    import soundfile

    first = json.loads((root / "examples/demo.jsonl").read_text().splitlines()[0])
    sound, rate = soundfile.read(root / "examples/demo.flac", stop=int(4.5 * 16000))
    path = tmp_path_factory.mktemp("sound") / "first.wav"
    soundfile.write(path, sound, rate)
    return path, first


def test_what_is_said_is_driven(peer, recording):
    from ros_stage import NodeProcess, until

    path, first = recording
    with NodeProcess(peer) as node:
        peer.meet()
        heard: list[str] = []
        from std_msgs.msg import String

        peer.node.create_subscription(String, "voice_commands/text", lambda message: heard.append(message.data), 10)
        with NodeProcess(peer, module="intent_engine.ros2.speech", file=path) as speech:
            until(peer.moving, "the robot moves")
            until(lambda: heard, f"{first['text']!r} comes as text")
            until(lambda: peer.goals("executing"))
            assert node.process.poll() is None
            assert speech.end() == 0
        assert "ready" in speech.output
        assert "Traceback" not in speech.output
        # A robot that is not heard any more stands.
        until(peer.standing)
        until(lambda: peer.goals("canceled"))  # another topic, which may come later
        assert peer.goals("canceled")[0]["reason"] == "stop"


@pytest.fixture(scope="module")
def paused(root, tmp_path_factory):
    """ "Turn left", a pause, "ninety degrees": the demo's second sentence, with more silence after its second word."""
    import numpy as np
    import soundfile

    sound, rate = soundfile.read(root / "examples/demo.flac")
    first, rest = sound[int(7.6 * rate) : int(9.03 * rate)], sound[int(9.03 * rate) : int(12.0 * rate)]
    path = tmp_path_factory.mktemp("sound") / "paused.wav"
    soundfile.write(path, np.concatenate((np.zeros(2 * rate), first, np.zeros(int(0.6 * rate)), rest)), rate)
    return path


def listen(peer, topic, texts):
    from std_msgs.msg import String

    return peer.node.create_subscription(
        String, f"voice_commands/{topic}", lambda message: texts.append(message.data), 10
    )


def test_what_is_said_right_after_a_motion_puts_it_right(peer, paused):
    from ros_stage import NodeProcess, until

    def turned(angle: float) -> bool:
        return any(math.isclose(goal["action"]["angle"], angle, abs_tol=1e-3) for goal in peer.goals("succeeded"))

    texts: list[str] = []
    amended: list[str] = []
    listen(peer, "text", texts)
    listen(peer, "amended_text", amended)
    with NodeProcess(peer) as node:
        peer.meet()
        until(lambda: "what lovely weather it is" in texts)  # what the peer says last, and hears itself
        texts.clear()
        with NodeProcess(peer, module="intent_engine.ros2.speech", file=paused) as speech:
            until(lambda: turned(math.radians(90)), "the robot turns by ninety degrees")
            until(lambda: texts and amended, "what was said right after comes as one text with it")
            assert node.process.poll() is None
            assert speech.end() == 0
    assert [text.lower().rstrip(".") for text in texts] == ["turn left"]
    assert [text.lower().rstrip(".") for text in amended] == ["turn left ninety degrees"]


def test_where_texts_are_only_taken_one_by_one_each_is_by_itself(peer, paused):
    """As a parser of somebody's own takes them: a second text would be done beside the first."""
    from ros_stage import NodeProcess, until

    texts: list[str] = []
    listen(peer, "text", texts)
    with NodeProcess(peer, module="intent_engine.ros2.speech", file=paused) as speech:
        until(lambda: len(texts) == 2, "both texts come")
        assert speech.end() == 0
    assert texts[0].lower().rstrip(".") == "turn left"
    assert not texts[1].lower().startswith("turn left")


def test_what_is_said_is_understood_in_the_states_of_the_robot(peer, paused, tmp_path, root):
    """A turn that goes on from another is one, only if the turn itself was understood."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from ros_stage import NodeProcess, until
    from std_msgs.msg import String

    grammar = tmp_path / "dock.yaml"
    english = (root / "grammars/en.yaml").read_text()
    assert english.count("\n  turn:\n") == 1
    grammar.write_text(english.replace("\n  turn:\n", "\n  turn:\n    requires: [docked]\n"))
    texts: list[str] = []
    amended: list[str] = []
    listen(peer, "text", texts)
    listen(peer, "amended_text", amended)
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    states = peer.node.create_publisher(String, "voice_commands/current_state", latched)
    states.publish(String(data='["docked"]'))
    with NodeProcess(peer, module="intent_engine.ros2.speech", file=paused, grammar=grammar) as speech:
        until(lambda: texts and amended, "what was said right after comes as one text with it")
        assert speech.end() == 0
    assert [text.lower().rstrip(".") for text in texts] == ["turn left"]
    assert [text.lower().rstrip(".") for text in amended] == ["turn left ninety degrees"]


@pytest.mark.parametrize(
    ("parameters", "code", "said"),
    [
        ({"file": "no_such.wav"}, 3, "no such file"),
        ({"reflex": 7}, 2, "reflex: 7"),
        ({"file": "README.md"}, 3, "sound"),
    ],
)
def test_mistakes(peer, parameters, code, said):
    from ros_stage import NodeProcess

    node = NodeProcess(peer, module="intent_engine.ros2.speech", **parameters)
    assert node.wait() == code, node.output
    assert said in node.output
    assert "Traceback" not in node.output
