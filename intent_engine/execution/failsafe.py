"""What brings the robot to rest, whatever the robot or its velocity loop raises, and knows what has failed."""

from __future__ import annotations

import logging

from intent_engine.errors import IntentEngineError
from intent_engine.execution.events import Dispatcher, EventKind
from intent_engine.execution.gate import Gate
from intent_engine.execution.given import check_pose
from intent_engine.execution.goal import Reason
from intent_engine.execution.motion import Travel
from intent_engine.execution.raised import pass_on_interrupt, told
from intent_engine.execution.robots.robot import Pose, Robot
from intent_engine.execution.runs import VelocityLoop

__all__ = ["HANGS", "Failsafe", "reason_of"]

log = logging.getLogger(__name__)

HANGS = "the robot has not come back from a call: nothing but a stop is done until it has"


class Failsafe:
    """Asks a robot and its velocity loop in ways that never raise.

    It has no lock of its own: ``stop_robot``, ``stop_past`` and ``hangs`` may be called at any time from any thread,
    all else under the executor's.

    Args:
        robot: what comes to rest.
        loop: what writes its velocities.
        gate: what they go through.
        events: hears of what has failed.
        valid_for: s, of the zero that is written where the robot's stop fails.
    """

    def __init__(self, robot: Robot, loop: VelocityLoop, gate: Gate, events: Dispatcher, valid_for: float) -> None:
        self._robot = robot
        self._loop = loop
        self._gate = gate
        self._events = events
        self._valid_for = valid_for
        self.failures = 0
        """How often the robot has failed since a goal was begun."""
        self.fault = ""
        """Why the velocity loop must not be used."""
        self._lost = False
        """Whether the robot raised when it was asked where it is, and that has been said."""

    @property
    def loop_is_asked(self) -> bool:
        """Whether the loop may still write the zeros that end a motion: not after two failures in a row."""
        return self.failures < 2

    def begin(self) -> bool:
        """A goal is begun: what failed before it no longer counts, and velocities go through. False: it must not be,
        since a stop is on its way."""
        if not self.let_through():
            return False
        self.failures = 0
        self._lost = False
        return True

    def let_through(self) -> bool:
        """Velocities go through again, until the next stop, hold or failure; False: one is on its way."""
        return self._gate.open()

    def stop(self) -> bool:
        """No velocity but zero from now on, and the robot's own stop; False if that raised."""
        self._gate.shut()
        return self.stop_robot()

    def stop_robot(self) -> bool:
        """The robot's own stop; False if it raised. Needs no lock."""
        try:
            self._robot.stop()
            return True
        except BaseException as error:
            # The protocol forbids it; and still the velocity is tried.
            log.exception("the robot raised in stop()")
            try:
                self._robot.velocity(0.0, 0.0, self._valid_for)
            except BaseException as again:
                meant = isinstance(again, IntentEngineError)
                log.error("the robot raised in velocity(0, 0): %s", told(again), exc_info=None if meant else again)
                pass_on_interrupt(again)
            self._events.tell(EventKind.ERROR, detail=f"the robot raised in stop(): {told(error)}")
            pass_on_interrupt(error)
            return False

    def stop_past(self) -> None:
        """The robot's own stop, and the end of what a process of its own writes, whoever has the lock: the gate is none
        for that. What has ended is entered by a :meth:`stop` that follows."""
        try:
            if hasattr(self._loop, "cut"):
                self._loop.cut()
        except Exception:
            log.exception("the velocity loop raised in cut()")
        self.stop_robot()

    def hangs(self) -> None:
        """A call of the robot takes too long. Whoever has the executor's lock."""
        log.error(HANGS)
        self._events.tell(EventKind.ERROR, detail=HANGS, reason=Reason.ROBOT_ERROR)

    def halt_loop(self, now: float) -> Travel | None:
        """End the motion of a robot that was stopped; how far it had come, None if the loop failed."""
        try:
            return self._loop.halt(now, write=False)
        except Exception as error:
            self.fault = told(error)
            self._events.tell(EventKind.ERROR, detail=self.fault, reason=Reason.VELOCITY_LOOP)
            return None

    def failed(self, error: BaseException) -> bool:
        """The robot raised, or the velocity loop is lost: stop. False if that raised, too."""
        self._gate.shut()
        self.failures += 1
        stopped = self.stop_robot()
        if reason_of(error) is Reason.VELOCITY_LOOP:
            self.fault = told(error)
        if self.failures == 1 and not isinstance(error, IntentEngineError):  # the goal tells what, a traceback where
            log.error("the robot raised", exc_info=error)
        return stopped

    def end_motion(self, now: float) -> Travel | None:
        """After a failure: zeros follow, and where they fail too, the robot is gone, and nothing more is written.

        Returns:
            How far the motion had come; None if nobody can tell.
        """
        if self._loop.moving or self.loop_is_asked:
            return self.halt_loop(now)
        try:
            self._loop.silence()
        except Exception:
            log.exception("the velocity loop raised in silence()")
        return None

    def pose(self) -> Pose | None:
        """Where the robot believes it is; None if it cannot tell. That it raised, or told what is no pose of finite
        numbers, is said once for each goal."""
        try:
            pose = self._robot.pose()
            if pose is not None:
                check_pose("pose() of a robot", pose)  # a localisation that has diverged says NaN, and JSON cannot
            return pose
        except BaseException as error:
            if not self._lost:
                log.exception("the robot cannot tell its pose; this is said once until the next command")
            self._lost = True
            pass_on_interrupt(error)
            return None


def reason_of(error: BaseException) -> Reason:
    """What an error of a robot or of a velocity loop means for the goal: its ``goal_reason``, if it has one."""
    reason: Reason = getattr(error, "goal_reason", Reason.ROBOT_ERROR)
    return reason
