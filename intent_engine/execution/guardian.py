"""The parent's side of the velocity process: starts it, gives it orders, and notices when it is gone.

Each of the orders ``start``, ``brake`` and ``halt`` has a number of its own, higher than those before it:

- ``start`` has no answer. What the process tells of the motion bears its number: ``alive`` (how far it is, and what is
  written) every 25 ms, then ``ended``; or ``lost`` (it heard nothing from here, and stopped) or ``failed`` (the robot
  raised).
- ``brake`` and ``halt`` are answered by ``done`` with their own number, and how far the motion had come (a stop that
  has to pass the executor's lock waits for no answer, and is followed by a ``halt`` that does). From then on
  the process tells under that number how the robot comes to rest; but a motion that is in its last ramp already is
  left alone by ``brake``, and keeps its number.
- ``silence``, ``alive`` (a sign of life from here) and ``close`` have neither number nor answer.

A message and an order may cross on the way, so what bears an older number than the current one is old news and is
dropped. One thing is not: that a motion ended, if its ``halt`` was on the way just then.
"""

from __future__ import annotations

import contextlib
import json
import logging
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any

from intent_engine.errors import RobotError
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Ended, Motion, Rates, Travel, time_for
from intent_engine.execution.velocity_faults import WITHOUT, VelocityLoopError, WatchdogError, ended_by, not_started
from intent_engine.execution.velocity_program import VelocityProgram

__all__ = ["Guardian", "VelocityLoopError", "WatchdogError"]

log = logging.getLogger(__name__)


class Guardian:
    """A velocity loop in a process of its own, for ``Executor(robot, loop=Guardian(...))``.

    The process makes its own connection to the robot's velocity, so it is told how: ``sink`` names a callable, as
    ``package.module:name``, whose result has ``velocity``, ``stop`` and ``close``; ``options`` are its keyword
    arguments, of JSON types. The executor's own robot is for everything else, and for stopping when the process is
    gone. It must be a robot in the world: a simulated one lives in the parent, and needs no guardian.

    Life cycle: made (the process runs) -> used by one executor -> ``close``, which the executor calls.

    Args:
        sink: what the process drives, e.g. ``intent_engine.execution.robots.jsonl:JsonLinesRobot``.
        options: its arguments.
        limits: accelerations of the ramps; the executor's own.
        rates: rate and validity of the writes.
        priority: of SCHED_FIFO, 1 to 99, where the system allows it; 0: ordinary scheduling.
        pass_fds: descriptors that the sink needs.

    Raises:
        RobotError: the process could not be started; the message has what it said.
    """

    ANSWER_TIMEOUT = 0.1
    """s for the answer to a halt; after it the process is killed and the robot stopped by its own stop."""
    START_TIMEOUT = 20.0
    """s for the process to be ready"""
    SILENCE = 0.25
    """s without a word during a motion, after which the process is taken for frozen. One that dies is noticed at
    once, by the end of its socket."""

    def __init__(
        self,
        sink: str,
        options: Mapping[str, Any] | None = None,
        *,
        limits: Limits | None = None,
        rates: Rates | None = None,
        priority: int = 20,
        pass_fds: tuple[int, ...] = (),
    ) -> None:
        self.limits, self._rates = limits or Limits(), rates or Rates()
        self._program = VelocityProgram(sink, dict(options or {}), self.limits, self._rates, priority, pass_fds)
        self._poke: Callable[[], None] = lambda: None
        self._stop_robot: Callable[[], None] = lambda: None
        self._heard = threading.Condition()
        """Guards what the listening thread writes."""
        self._numbers = 0
        self._current = 0
        """Number of the order whose end is waited for; what is said about an earlier one is old."""
        self._halted = 0
        """Number of the order that was the current one before a halt: it may have ended before the halt arrived."""
        self._cuts: set[int] = set()
        """Numbers of the halts that nobody waits for."""
        self._cut_at: Travel | None = None
        """How far the motion had come that it ended."""
        self._closed = self._moving = self._lost = self._fifo = False
        self._error = ""
        """Why the process can no longer be used."""
        self._problem = ""
        """Why the motion ended early."""
        self._ended: Ended | None = None
        self._written = (0.0, 0.0)
        self._turning = False
        """Whether the motion is one, and not a drive."""
        self._travel, self._travel_at = Travel(), 0.0
        self._answers: dict[int, Travel] = {}
        self._heard_at = time.monotonic()
        self._silent_since = self._looked_at = self._heard_at
        self._beat = self._rates.valid_for / 4.0
        """s between two signs of life"""
        self._beat_at = 0.0
        self._launch()

    # -- for the executor --------------------------------------------------------------------------------------------

    def attach(self, poke: Callable[[], None], stop_robot: Callable[[], None]) -> None:
        """Give it what it calls when something happened, and the robot's own stop."""
        self._poke, self._stop_robot = poke, stop_robot

    @property
    def moving(self) -> bool:
        return self._moving

    @property
    def written(self) -> tuple[float, float]:
        return self._written if self._moving else (0.0, 0.0)

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid

    @property
    def real_time(self) -> bool:
        """Whether the system gave it SCHED_FIFO."""
        return self._fifo

    def start(self, motion: Motion, now: float) -> float:
        self._check()
        # The process plans by its own clock and present velocity; this is for the time-out of the goal only.
        takes = time_for(motion, self.limits, *self.written)
        number = self._begin(motion.turning)
        self._order(do="start", id=number, motion=motion.to_json())
        self._beat_at = now + self._beat
        return now + takes

    def brake(self, now: float) -> Travel:
        self._check()
        return self._ask("brake")

    def halt(self, now: float, write: bool = True) -> Travel:
        if self._error:
            self._moving = False
            return self._travel
        travel = self._ask("halt")
        self._moving = False
        return travel

    def cut(self) -> None:
        """Zero, now, whoever has the executor's lock. The halt that makes it known here follows when that is free."""
        with self._heard:
            self._numbers += 1
            number = self._numbers
            self._cuts.add(number)
        if not self._error:
            self._order(do="halt", id=number)

    def silence(self) -> None:
        if not self._error:
            self._order(do="silence")

    def travel(self, now: float) -> Travel:
        if not self._moving:
            return Travel()
        ahead = min(max(time.monotonic() - self._travel_at, 0.0), self._rates.valid_for)
        speed = self._written[self._turning]
        there = self._travel
        return Travel(
            there.amount + speed * ahead, there.elapsed + ahead, max(there.time_left - ahead, 0.0), there.braking
        )

    def due(self) -> float | None:
        if self._error and self._moving:
            return 0.0
        return self._beat_at if self._moving else None

    def step(self, now: float) -> Ended | None:
        with self._heard:
            ended, self._ended = self._ended, None
            problem, self._problem = self._problem, ""
            if ended is not None or problem:
                self._moving = False
        if self._error and self._moving:
            self._moving = False
            self._check()
        if problem:
            raise WatchdogError(problem) if self._lost else RobotError(problem)
        if ended is not None:
            return ended
        here = time.monotonic()  # what the process says is of this clock, whatever the executor's is
        looked_at, self._looked_at = self._looked_at, here
        if self._moving:
            if here - looked_at > self.SILENCE / 2.0:
                # It was this program that was away: let the listening thread read first what came meanwhile.
                self._silent_since = here
            if here - max(self._heard_at, self._silent_since) > self.SILENCE:
                self._give_up(f"the velocity process said nothing for {self.SILENCE * 1000:.0f} ms and was killed")
                self._moving = False
                self._check()
            if now >= self._beat_at:
                self._beat_at = now + self._beat
                self._order(do="alive")
        return None

    def restart(self) -> None:
        """Start the process again, if it is gone and this is not closed.

        Raises:
            RobotError: it could not be started.
        """
        if self._closed or not self._error:
            return
        self._line.close()
        self._launch()

    def close(self) -> None:
        """Zero, and end the process. Idempotent."""
        if self._closed:
            return
        self._closed = True
        self._order(do="close")
        try:
            self._process.wait(1.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._line.close()

    # -- inside ------------------------------------------------------------------------------------------------------

    def _launch(self) -> None:
        ours, theirs = socket.socketpair()
        ready = threading.Event()
        with self._heard:
            # From here on nothing that the thread of an earlier process still hears counts.
            self._line = ours
            self._moving = self._lost = False
            self._error = self._problem = ""
            self._ended = None
            self._answers.clear()
        try:
            self._process = self._program.start(theirs)
        except OSError as error:
            self._error = f"the velocity process could not be started: {error}"
            ours.close()
            raise RobotError(f"{self._error}. {WITHOUT}") from error
        finally:
            theirs.close()
        threading.Thread(target=self._listen, args=(ours, ready), name="velocity-process", daemon=True).start()
        try:
            ready.wait(self.START_TIMEOUT)
        except BaseException:  # Ctrl-C meanwhile
            self._discard()
            raise
        if self._error or not ready.is_set():
            self._discard()
            raise RobotError(not_started(self._program.sink))

    def _discard(self) -> None:
        """End a process that nothing depends on yet."""
        self._error = self._error or "the velocity process did not start"
        self._process.kill()
        self._process.wait()
        self._line.close()

    def _begin(self, turning: bool) -> int:
        with self._heard:
            self._turning = turning
            self._numbers += 1
            self._current = self._numbers
            self._ended, self._cut_at, self._problem = None, None, ""
            self._moving = True
            self._travel, self._written = Travel(), (0.0, 0.0)
            self._silent_since = self._looked_at = self._travel_at = time.monotonic()
            return self._numbers

    def _check(self) -> None:
        if self._error:
            raise VelocityLoopError(self._error)

    def _order(self, **order: Any) -> None:
        line = self._line
        try:
            line.sendall(json.dumps(order).encode() + b"\n")
        except OSError:
            self._dead("the velocity process is gone", line)

    def _ask(self, what: str) -> Travel:
        """Give an order and wait for its answer; no answer is the end of the process."""
        with self._heard:
            self._numbers += 1
            number = self._numbers
            if what == "halt":
                # What went wrong with the motion before this is old; how far it came is not.
                self._halted, self._current, self._problem = self._current, number, ""
        self._order(do=what, id=number)
        deadline = time.monotonic() + self.ANSWER_TIMEOUT
        with self._heard:
            while number not in self._answers and not self._error:
                if not self._heard.wait(deadline - time.monotonic()) and time.monotonic() >= deadline:
                    break
            travel = self._answers.pop(number, None)
            if travel is not None and what == "brake" and not travel.braking:
                self._travel, self._travel_at = Travel(), time.monotonic()
        if travel is None:
            self._give_up(f"the velocity process did not answer within {self.ANSWER_TIMEOUT * 1000:.0f} ms")
            self._moving = False
            raise VelocityLoopError(self._error)
        return travel

    def _listen(self, line: socket.socket, ready: threading.Event) -> None:
        received = b""
        while True:
            try:
                data = line.recv(65536)
            except OSError:
                data = b""
            if not data:
                if ready.is_set():
                    if not self._closed:
                        self._dead("the velocity process ended", line)
                else:
                    self._error = "the velocity process ended before it was ready"
                    ready.set()
                return
            *lines, received = (received + data).split(b"\n")
            for text in lines:
                message = json.loads(text)
                if "ready" in message:
                    self._fifo = bool(message["fifo"])
                    ready.set()
                else:
                    self._hear(message)

    def _hear(self, message: dict[str, Any]) -> None:
        poke = False
        with self._heard:
            self._heard_at = time.monotonic()
            travel = Travel(*message["travel"]) if "travel" in message else Travel()
            if "done" in message:
                if self._ended is not None:
                    # The motion had ended before the order arrived, and the process tells only of what came after.
                    travel, self._ended = self._ended.travel, None
                elif self._cut_at is not None:
                    travel = self._cut_at  # it was cut off before, and the process tells of nothing again
                if message["done"] in self._cuts:
                    self._cut_at = self._travel = travel
                    self._written = (0.0, 0.0)
                else:
                    self._cut_at, self._answers[message["done"]] = None, travel
                if not travel.braking:
                    # The motion is now the brake, whose end comes under this number.
                    self._current = max(self._current, message["done"])
                self._heard.notify_all()
            elif message.get("ended") in (self._current, self._halted):
                self._ended, poke = Ended(message["at"], travel, message["late"]), True
            elif message.get("alive") == self._current:
                self._travel, self._travel_at = travel, message["at"]
                self._written = (message["written"][0], message["written"][1])
            elif message.get("lost", message.get("failed")) == self._current:
                self._problem, self._lost, poke = message["error"], "lost" in message, True
        if poke:
            self._poke()

    def _dead(self, why: str, line: socket.socket, kill: bool = False) -> None:
        """The process is gone, or must be: stop the robot by its own stop, from this very thread, and say so."""
        with self._heard:
            if self._error or line is not self._line:
                return
            code = self._process.poll()
            self._error = why if code is None else f"{why} ({ended_by(code)})"
            self._heard.notify_all()
        if self._closed:
            return
        log.error("%s; the robot is stopped", self._error)
        if kill:
            self._process.kill()
        self._stop_robot()
        if kill:
            # A killed process may still have been in a write; the stop that counts is the one after its end.
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(0.1)
            self._stop_robot()
        self._poke()

    def _give_up(self, why: str) -> None:
        self._dead(why, self._line, kill=True)
