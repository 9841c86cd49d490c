"""Who carries an action out: the velocity loop, the robot itself, or a handler of the user's."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from intent_engine.actions import Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.execution.admission import Admission
from intent_engine.execution.goal import Goal
from intent_engine.execution.handlers import HandlerRun
from intent_engine.execution.motion import Keep, Motion, Travel
from intent_engine.execution.robots.robot import Pose, Robot
from intent_engine.execution.runs import MotionRun, Run, StopRun, TaskRun, VelocityLoop

__all__ = ["Carriers"]


class Carriers:
    """Makes the run of a goal.

    Args:
        robot: drives by itself, picks and places.
        admission: knows the handlers, and for how long anything may go on.
        loop: writes the velocities of motions.
        launch: does the work of a handler, outside the executor's lock.
        poke: is called when something has ended.
        stop_robot: the robot's own stop, for one inside a sequence.
    """

    def __init__(
        self,
        robot: Robot,
        admission: Admission,
        loop: VelocityLoop,
        launch: Callable[[Callable[[], None]], None],
        poke: Callable[[], None],
        stop_robot: Callable[[], object],
    ) -> None:
        self._robot = robot
        self._admission = admission
        self._loop = loop
        self._launch = launch
        self._poke = poke
        self._stop_robot = stop_robot

    def run_of(self, goal: Goal, keep: Keep, covered: Travel | None) -> Run:
        """The run of a goal that was admitted.

        Args:
            goal: what is to be done.
            keep: what ramps cost a motion.
            covered: of a motion, by a goal that it amends; None: it amends none.
        """
        action, robot = goal.action, self._robot
        timeout = self._admission.limits.task_duration
        handler = self._admission.handler(action)
        if handler is not None:
            return HandlerRun(goal, handler, self._launch, self._poke, timeout)
        if isinstance(action, Stop):
            return StopRun(goal, self._stop)
        if isinstance(action, (Move, Turn)):
            return MotionRun(goal, Motion.of(action, keep), self._loop, covered)

        def begin() -> Any:
            if isinstance(action, Navigate):
                return robot.navigate(Pose(action.x, action.y, action.yaw, action.frame))
            if isinstance(action, Pick):
                return robot.pick(action.object)
            assert isinstance(action, Place)
            return robot.place(action.object, action.location)

        return TaskRun(goal, robot, begin, lambda task: self._poke(), timeout)

    def _stop(self, now: float) -> None:
        self._stop_robot()
        self._loop.halt(now, write=False)
