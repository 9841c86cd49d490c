"""The process that owns the robot's velocity: it drives on time whatever the parent does, and stops when it is gone.

Run as ``python -m intent_engine.execution.velocity_loop SETTINGS`` by :class:`~.guardian.Guardian`, which speaks with
it through a socket, one JSON object a line. It has one thread; every velocity is written by it, so that nothing can
be written after the answer to a ``halt``.

It writes zero by itself when the socket closes or the parent's process ends (killed: at once, told by the kernel),
when the parent says nothing for ``valid_for`` s during a motion (frozen), when it is asked to end, and when the robot
raises. No loop in a process can stop a robot whose computer is gone: the base needs a command timeout of its own.
"""

from __future__ import annotations

import contextlib
import gc
import json
import os
import select
import signal
import socket
import sys
import time
from importlib import import_module
from typing import Any

from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Follower, Motion, Rates, Travel, VelocitySink

__all__ = ["VelocityProcess", "main"]

STATUS_PERIOD = 0.025
"""s between two messages to the parent during a motion"""


class VelocityProcess:
    """The loop itself: what the process does between its start and its last zero."""

    def __init__(self, sink: VelocitySink, limits: Limits, rates: Rates, line: socket.socket, parent: int | None):
        self._sink = sink
        self._rates = rates
        self._follower = Follower(sink, limits, rates)
        self._line = line
        self._watched: list[Any] = [line, *([parent] if parent is not None else [])]
        self._parent = parent
        self._received = b""
        self._id = 0
        self._heard = time.monotonic()
        self._status_at = 0.0
        self._ending = False
        self._broken = False
        """The robot has failed since the last start, and the parent knows."""

    def run(self) -> None:
        """Follow the parent's orders until it says goodbye or is gone; end with zeros."""
        while not (self._ending and self._follower.due() is None):
            # Orders first, always: a halt that has arrived is obeyed before the next write.
            readable = select.select(self._watched, [], [], self._patience())[0]
            if self._line in readable:
                self._receive()
            if self._parent is not None and self._parent in readable:
                self._gone()
            now = time.monotonic()
            if self._follower.moving and now >= self._heard + self._rates.valid_for:
                self._lost(now)
            try:
                ended = self._follower.step(now)
            except Exception as error:
                self._failed(error)
                if self._ending:
                    return  # there is nobody to drive for, and nothing that could be told so
                continue
            if ended is not None:
                travel = ended.travel
                self._send(ended=self._id, at=ended.at, late=ended.late, travel=_pack(travel))
            elif self._follower.moving and now >= self._status_at:
                self._status_at = now + STATUS_PERIOD
                travel = self._follower.travel(now)
                self._send(alive=self._id, at=now, written=self._follower.written, travel=_pack(travel))

    def terminate(self) -> None:
        """Zero and end, whoever asks."""
        self._ending = True
        self._halt_quietly()

    def _patience(self) -> float | None:
        due = self._follower.due()
        times = [due] if due is not None else []
        if self._follower.moving:
            times += [self._heard + self._rates.valid_for, self._status_at]
        return max(min(times) - time.monotonic(), 0.0) if times else None

    def _receive(self) -> None:
        try:
            data = self._line.recv(65536)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            data = b""
        if not data:
            self._gone()
            return
        self._heard = time.monotonic()
        *lines, self._received = (self._received + data).split(b"\n")
        for line in lines:
            self._obey(json.loads(line))

    def _obey(self, order: dict[str, Any]) -> None:
        now = time.monotonic()
        match order["do"]:
            case "start":
                self._id, self._broken = order["id"], False
                self._follower.start(Motion.from_json(order["motion"]), now)
                self._status_at = now
            case "brake":
                travel = self._follower.brake(now)
                if not travel.braking:
                    self._id = order["id"]
                self._send(done=order["id"], travel=_pack(travel))
            case "halt":
                self._id = order["id"]
                try:
                    travel = self._follower.halt(now)
                except Exception as error:
                    self._failed(error)
                    travel = Travel()
                self._send(done=order["id"], travel=_pack(travel))
            case "silence":
                self._follower.silence()
            case "close":
                self.terminate()

    def _gone(self) -> None:
        """The parent is dead."""
        self._watched = []
        self._parent = None
        self.terminate()
        with contextlib.suppress(Exception):
            self._sink.stop()

    def _lost(self, now: float) -> None:
        """The parent is silent. It may wake again: then it hears what happened."""
        silence = now - self._heard
        self._halt_quietly()
        with contextlib.suppress(Exception):
            self._sink.stop()
        self._send(lost=self._id, error=f"the program said nothing for {silence * 1000:.0f} ms; the robot was stopped")

    def _failed(self, error: Exception) -> None:
        """The robot raised: zero, and then silence where that fails too. The parent hears of it once."""
        known, self._broken = self._broken, True
        if self._follower.moving:
            self._halt_quietly()
        elif known:
            self._follower.silence()  # else each zero that fails would be followed by others, without end
        with contextlib.suppress(Exception):
            self._sink.stop()
        if not known:
            self._tell_failure(error)

    def _halt_quietly(self) -> None:
        try:
            self._follower.halt(time.monotonic())
        except Exception as error:
            self._follower.silence()
            if not self._broken:
                self._broken = True
                self._tell_failure(error)

    def _tell_failure(self, error: Exception) -> None:
        self._send(failed=self._id, error=f"{type(error).__name__}: {error}")

    def _send(self, **message: Any) -> None:
        # Never wait for a parent that does not read: the robot comes first.
        with contextlib.suppress(OSError):
            self._line.send(json.dumps(message).encode() + b"\n", socket.MSG_DONTWAIT)


def _pack(travel: Travel) -> list[Any]:
    return [travel.amount, travel.elapsed, travel.time_left, travel.braking]


def _real_time(priority: int) -> bool:
    """First in first out scheduling, where the system allows it (root, CAP_SYS_NICE or an rtprio limit)."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(priority))
    except (AttributeError, OSError):
        return False
    return True


def _watch(pid: int) -> int | None:
    """A descriptor that becomes readable when the process ends, where the system has it (Linux 5.3)."""
    # The socket alone would do, if no other child of the parent could have inherited its other end.
    try:
        return os.pidfd_open(pid)
    except (AttributeError, OSError):
        return None


def main() -> None:
    settings = json.loads(sys.argv[1])
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTSTP, signal.SIGTTOU):
        signal.signal(number, signal.SIG_IGN)  # Ctrl-C and Ctrl-Z are the parent's, which says what to do
    line = socket.socket(fileno=settings["line"])
    parent = _watch(settings["parent"])
    if os.getppid() != settings["parent"]:
        return
    module, name = settings["sink"].split(":")
    sink = getattr(import_module(module), name)(**settings["options"])
    limits: dict[str, Any] = {key: float(value) for key, value in settings["limits"].items()}
    process = VelocityProcess(sink, Limits(**limits), Rates(**settings["rates"]), line, parent)
    signal.signal(signal.SIGTERM, lambda number, frame: process.terminate())
    fifo = _real_time(settings["priority"]) if settings["priority"] else False
    gc.collect()
    gc.freeze()
    gc.disable()  # what the loop makes it also drops; nothing of it is cyclic
    process._send(ready=os.getpid(), fifo=fifo)
    try:
        process.run()
    finally:
        with contextlib.suppress(Exception):
            sink.stop()
        if hasattr(sink, "close"):
            sink.close()


if __name__ == "__main__":
    main()
