"""A robot that listens to ROS 2: velocities on ``cmd_vel``, navigation by Nav2.

In a program, with a ROS of its own::

    robot = Ros2Robot()
    with Executor(robot) as executor:
        executor.submit(...)
    robot.close()

or ``Ros2Robot(node)`` in a node that is spun already. The node ``intent_engine`` of :mod:`intent_engine.ros2` is all
of it, ready to start.
"""

from __future__ import annotations

import contextlib
import logging
import math
import threading
import time
from collections.abc import Callable, Iterable
from typing import Any

from intent_engine.errors import RobotError
from intent_engine.execution.clock import Clock, MonotonicClock
from intent_engine.execution.robots.remote_task import RemoteTask
from intent_engine.execution.robots.robot import Capability, Pose, Task
from intent_engine.execution.robots.ros2_last_words import cancel_all, write_zeros
from intent_engine.execution.robots.ros2_navigation import NavigationAction, NavigationWay, Ros2Navigation
from intent_engine.execution.robots.ros2_signals import stand_before_the_end
from intent_engine.execution.robots.ros2_spinning import Spinning
from intent_engine.execution.robots.ros2_support import import_rclpy, own_node, pose_of
from intent_engine.execution.robots.ros2_velocity import Stamped, TwistWriter

__all__ = ["Ros2Robot"]

log = logging.getLogger(__name__)

_ENDS = "the program was told to end"
_SHUT_DOWN = "rclpy was shut down before the executor was closed: call executor.close() and robot.close() first"


class Ros2Robot:
    """Any robot that drives by ``cmd_vel``. Thread-safe.

    A velocity that is not renewed within its ``valid_for`` is followed by a zero, sent by a thread of this robot. That
    is no help when the whole program is gone: :class:`~intent_engine.execution.guardian.Guardian` is, and in the end a
    base must have a command timeout of its own.

    Args:
        node: an rclpy node that somebody spins; None: one is made, and spun in a thread.
        cmd_vel: topic of the velocities.
        stamped: ``Twist``, ``TwistStamped`` or whatever is subscribed to.
        frame_id: of the stamped velocity.
        navigation: how goals are given to the navigation, or that there is none.
        navigate_to_pose: name of the action.
        goal_pose: topic of goals, where the action is not used.
        pose: topic of the robot's pose (``geometry_msgs/PoseWithCovarianceStamped``), as AMCL and others give it.
        action: type of the action, if it is not Nav2's.
        capabilities: what of that which ``cmd_vel`` and the navigation can do this robot can; None: all.
        clock: in whose s a velocity is valid; None: the machine's. In a simulation, the simulator's: one that runs ten
            times slower has ten times as long between two velocities.

    Raises:
        RobotError: no ROS 2 in this Python, or no nav2_msgs where they are asked for.
    """

    ZEROS = 3
    """How many zeros :meth:`close` sends."""
    STANDS = 1.0
    """s of the machine in which a simulator's time does not go on, after which no velocity is valid any more: perhaps
    it is only ``/clock`` that does not come."""

    def __init__(
        self,
        node: Any = None,
        *,
        cmd_vel: str = "cmd_vel",
        stamped: Stamped | str = Stamped.AUTO,
        frame_id: str = "base_link",
        navigation: NavigationWay | str = NavigationWay.AUTO,
        navigate_to_pose: str = "navigate_to_pose",
        goal_pose: str = "goal_pose",
        pose: str = "amcl_pose",
        action: NavigationAction | None = None,
        capabilities: Iterable[Capability | str] | None = None,
        clock: Clock | None = None,
    ) -> None:
        import_rclpy()
        given = tuple(Capability) if capabilities is None else capabilities
        self._given_capabilities = frozenset(Capability(name) for name in given)
        self._clock = clock or MonotonicClock()
        self._own: _OwnNode | None = None
        if node is None:
            self._own = _OwnNode("intent_engine_robot")
            node = self._own.node
        self.node = node
        self._writer = TwistWriter(node, cmd_vel, stamped, frame_id)
        self.navigation: Ros2Navigation | None = None
        if NavigationWay(navigation) is not NavigationWay.NONE:
            self.navigation = Ros2Navigation(node, navigation, navigate_to_pose, goal_pose, action)
        self._pose: Pose | None = None
        self._listen_for_pose(pose)
        self._lock = threading.RLock()
        self._renewed = threading.Condition(self._lock)
        self._valid_until: float | None = None
        """s, by the clock; None: nothing but zero was written."""
        self._closed = False
        self._ends = ""
        """Why nothing is begun any more: the process was told to end, or the middleware is gone."""
        self._last_words: threading.Thread | None = None
        self._when_gone: Callable[[], object] = lambda: None
        node.context.on_shutdown(self._shut_down)
        if self.navigation is not None:
            self.navigation.when_gone = lambda: self._is_gone(drives=self._valid_until is not None)
        stand_before_the_end(self, None if self._own is not None else node.context)
        self._watchdog = threading.Thread(target=self._watch, name="cmd_vel-ttl", daemon=True)
        self._watchdog.start()

    @property
    def capabilities(self) -> frozenset[Capability]:
        drives = {Capability.MOVE, Capability.TURN}
        able = drives | {Capability.NAVIGATE} if self.navigation is not None else drives
        return self._given_capabilities & able

    @property
    def topic(self) -> str:
        """The whole name of the velocities' topic, remapped."""
        return self._writer.topic

    @property
    def stamped(self) -> bool:
        """Whether velocities are sent as ``TwistStamped`` at present."""
        return self._writer.stamped

    @property
    def listeners(self) -> int:
        """How many subscribe to the velocities."""
        return self._writer.listeners

    def velocity(self, linear: float, angular: float, valid_for: float) -> None:
        with self._lock:
            if self._closed:
                raise RobotError("the ROS 2 robot is closed")
            if self._ends and (linear or angular):
                raise RobotError(self._ends)
            self._writer.write(linear, angular)
            if self._ends and (linear or angular):
                self._writer.write(0.0, 0.0)  # the end came while it was being written
                raise RobotError(self._ends)
            if not (linear or angular):
                self._valid_until = None
                return
            before, self._valid_until = self._valid_until, self._clock.now() + valid_for
            if before is None or before > self._valid_until:
                self._renewed.notify()

    def stop(self) -> None:
        # No lock: a velocity that hangs must not keep a stop from the robot. The executor's gate sends another zero
        # after a velocity that was on its way.
        drives, self._valid_until = self._valid_until is not None, None
        try:
            self._writer.write(0.0, 0.0)
        except RobotError as error:
            self._not_sent(error, drives)
        if self.navigation is not None:
            self.navigation.stop()

    def navigate(self, goal: Pose) -> Task:
        if self.navigation is None:
            raise RobotError("this robot does not navigate")
        if self._ends:
            raise RobotError(self._ends)
        return self.navigation.navigate(goal)

    def pick(self, object_name: str) -> Task:
        raise RobotError("a robot behind cmd_vel has no arm; register a handler for 'pick'")

    def place(self, object_name: str | None, location: str | None) -> Task:
        raise RobotError("a robot behind cmd_vel has no arm; register a handler for 'place'")

    def cancel(self, task: Task) -> None:
        if self.navigation is not None and isinstance(task, RemoteTask):
            self.navigation.cancel(task)

    def pose(self) -> Pose | None:
        return self._pose or (self.navigation.pose if self.navigation is not None else None)

    def stand(self) -> None:
        """Zero velocity and the end of every goal, and nothing new: the process ends, and the middleware perhaps before
        :meth:`close`."""
        self._ends = _ENDS  # without the lock, which the main thread may have: a signal waits for nobody
        for _ in range(self.ZEROS):
            self.stop()
        if self.navigation is not None:
            self.navigation.wait(self.navigation.CLOSE)
        self._writer.acknowledge()

    def close(self) -> None:
        """Zero velocity, every goal ended, and what was made for it let go. A node that was given is left alone."""
        with self._lock:
            if self._closed:
                return
            self._closed = True
            self._renewed.notify()
        for _ in range(self.ZEROS):
            self.stop()
        self._watchdog.join(1.0)
        if self._last_words is not None:
            self._last_words.join()
        if self.navigation is not None:
            self.navigation.close()
        self._writer.close()
        if self._own is not None:
            self._own.close()

    def when_gone(self, stop: Callable[[], object]) -> None:
        """Call ``stop`` when the middleware was shut down: nobody can say it by ROS any more. For the executor."""
        self._when_gone = stop

    def _shut_down(self) -> None:
        """``rclpy.shutdown()`` by the program, in its thread; the node is gone."""
        if self._closed or self._ends:
            return
        self._ends, drives, navigates = _SHUT_DOWN, self._valid_until is not None, self._navigates
        try:
            self._when_gone()
        finally:
            self._say_last_words(drives, navigates)

    @property
    def _navigates(self) -> bool:
        return self.navigation is not None and not self.navigation.quiet

    def _not_sent(self, error: RobotError, drives: bool) -> None:
        """A zero could not be."""
        if self._ends:
            return  # and the context is not asked, which who shuts it down has locked
        if self.node.context.ok():
            log.error("no zero velocity could be sent: %s", error)
        else:
            self._is_gone(drives)

    def _is_gone(self, drives: bool) -> None:
        """The middleware turns out to be shut down: by a signal's handler of rclpy's, which tells nobody."""
        if self._ends:
            return  # all was said before it was closed, or is by now
        self._ends = _SHUT_DOWN
        # Others are to be found first, and a stop is quick. It is no daemon, so that a program waits for it at its end.
        words = threading.Thread(target=self._say_last_words, args=(drives, self._navigates), name="last-words")
        try:
            words.start()
        except RuntimeError:  # that end has begun
            self._say_last_words(drives, self._navigates)
        else:
            self._last_words = words

    def _say_last_words(self, drives: bool, navigates: bool) -> None:
        """Bring a robot to rest that was driven as the middleware was shut down."""
        try:
            stopped = not drives or write_zeros(
                self._writer.topic, "true" if self._writer.stamped else "false", self._writer.frame_id
            )
            if self.navigation is not None and navigates:
                stopped = cancel_all(self.navigation.cancel_service) and stopped
        except Exception as error:
            log.debug("no last words", exc_info=True)
            log.error("%s; the robot may go on: %s: %s", _SHUT_DOWN, type(error).__name__, error)
            return
        if stopped:
            log.warning("%s; the robot was stopped all the same", _SHUT_DOWN)
        else:
            log.error("%s; nobody has answered to its stop, and the robot may go on", _SHUT_DOWN)

    def _listen_for_pose(self, topic: str) -> None:
        from geometry_msgs.msg import PoseWithCovarianceStamped
        from rclpy.qos import QoSProfile, ReliabilityPolicy

        def heard(message: Any) -> None:
            self._pose = pose_of(message.pose.pose, message.header.frame_id or "map")

        # The least that can be asked for, so that every publisher fits.
        newest = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.node.create_subscription(PoseWithCovarianceStamped, topic, heard, newest)

    def _watch(self) -> None:
        seen, since = -math.inf, 0.0
        with self._renewed:
            while not self._closed:
                until, now, here = self._valid_until, self._clock.now(), time.monotonic()
                if until is None or now != seen:
                    seen, since = now, here
                if until is None or (now < until and here - since < self.STANDS):
                    self._clock.wait_until(self._renewed, until)
                    continue
                self._valid_until = None
                try:
                    self._writer.write(0.0, 0.0)
                except RobotError as error:
                    self._not_sent(error, drives=True)


class _OwnNode:
    """A node of our own, spun in a thread."""

    def __init__(self, name: str) -> None:
        self._context, self.node = own_node(name)
        self._spinning = Spinning(self.node)

    def close(self) -> None:
        if self._spinning.end():
            with contextlib.suppress(Exception):
                self.node.destroy_node()
                self._context.shutdown()
