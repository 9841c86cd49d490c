"""Sound to a moving robot through two nodes of ours and three processes, with the real recogniser."""

from __future__ import annotations

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
