"""What the velocity process does by itself, in a thread of the tests: orders come through a socket, as ever."""

from __future__ import annotations

import json
import math
import socket
import threading

from execution_stage import until

from intent_engine.errors import RobotError
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Motion, Rates
from intent_engine.execution.velocity_loop import VelocityProcess

LIMITS = Limits(linear_acceleration=2.0, angular_acceleration=4.0)


class Failing:
    """A sink that fails once and then takes everything."""

    def __init__(self) -> None:
        self.written: list[float] = []

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        if linear and not self.written:
            self.written.append(math.nan)
            raise OSError("one frame was lost")
        self.written.append(linear)

    def stop(self) -> None:
        self.written.append(0.0)


def test_a_sink_that_fails_once_is_not_driven_on():
    ours, theirs = socket.socketpair()
    sink = Failing()
    process = VelocityProcess(sink, LIMITS, Rates(), theirs, None)
    thread = threading.Thread(target=process.run, daemon=True)
    thread.start()
    order = {"do": "start", "id": 1, "motion": Motion(False, 0.5, 5.0, 10.0).to_json()}
    ours.sendall(json.dumps(order).encode() + b"\n")
    until(lambda: len(sink.written) >= 3)
    ours.close()
    thread.join(30.0)
    assert not any(sink.written[1:])


def test_a_loop_that_has_neither_program_nor_robot_ends():
    """A pipeline that is killed as a whole must not leave it behind, writing zeros to nobody."""

    class Gone(Failing):
        def velocity(self, linear: float, angular: float, valid_for: float) -> None:
            self.written.append(linear)
            raise OSError("nobody reads")

    ours, theirs = socket.socketpair()
    sink = Gone()
    process = VelocityProcess(sink, LIMITS, Rates(), theirs, None)
    thread = threading.Thread(target=process.run, daemon=True)
    thread.start()
    ours.close()
    thread.join(30.0)
    assert not thread.is_alive()


class Dead:
    """A sink that takes nothing."""

    def __init__(self) -> None:
        self.tried: list[str] = []

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        self.tried.append("velocity")
        raise RobotError("nobody reads")

    def stop(self) -> None:
        self.tried.append("stop")


def test_the_loop_tells_once_that_its_robot_is_gone_and_writes_no_more():
    ours, theirs = socket.socketpair()
    sink = Dead()
    process = VelocityProcess(sink, LIMITS, Rates(rate=1000.0), theirs, None)
    thread = threading.Thread(target=process.run, daemon=True)
    thread.start()

    def order(**what: object) -> None:
        ours.sendall(json.dumps(what).encode() + b"\n")

    with ours.makefile() as lines:
        order(do="start", id=1, motion=Motion(False, 0.5, 5.0, 10.0).to_json())
        heard = [json.loads(lines.readline())]
        assert heard[0]["failed"] == 1
        # What the program does when it hears this, and what a user does then.
        for number in (2, 3, 4):
            order(do="halt", id=number)
        order(do="close")
        thread.join(30.0)
        assert not thread.is_alive()
        theirs.close()
        heard += [json.loads(each) for each in lines]
    ours.close()
    assert [message for message in heard if "failed" in message] == heard[:1]
    assert [message["done"] for message in heard[1:]] == [2, 3, 4]
    # The motion and its zero; each halt, which is obeyed whatever was before; the end.
    assert sink.tried.count("velocity") <= 6
    assert sink.tried[:3] == ["velocity", "velocity", "stop"]
