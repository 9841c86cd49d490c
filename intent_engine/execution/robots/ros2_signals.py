"""Ctrl-C, SIGTERM and the end of the terminal in a program of the user's that has rclpy's signal handlers: the robot
stands before they act.

``rclpy.init()`` installs handlers that close *every* context of the process at once, ours too, and from then on no zero
velocity can be sent and no navigation cancelled. They are C, and act while the main thread waits in ``rclpy.spin``,
where a handler of Python's is not called at all. So a signal is heard by a thread, through the file descriptor that
Python's own C handler writes to; robots are made to stand, and then the thread closes the contexts that are spun, as
rclpy would have done: its handlers cannot be put back.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import socket
import threading
import weakref
from types import FrameType
from typing import Any, Protocol

__all__ = ["stand_before_the_end"]

log = logging.getLogger(__name__)


class _Robot(Protocol):
    def stand(self) -> None: ...


def stand_before_the_end(robot: _Robot, context: Any = None) -> None:
    """Call the ``stand`` of a robot when the process is told to end, before the middleware is closed.

    Where rclpy has no signal handlers nothing is closed by a signal, and nothing has to be done.

    Args:
        robot: it is forgotten when nobody else has it.
        context: of rclpy, that a signal closes beside the default one; None: no other.
    """
    global _taken
    from rclpy.signals import SignalHandlerOptions, get_current_signal_handlers_options

    _robots[robot] = context
    options = get_current_signal_handlers_options()
    kinds = {signal.SIGINT: SignalHandlerOptions.SIGINT, signal.SIGTERM: SignalHandlerOptions.SIGTERM}
    numbers = [number for number, kind in kinds.items() if options in (kind, SignalHandlerOptions.ALL)]
    if _taken is not None or not numbers:
        return
    if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_DFL:
        numbers.append(signal.SIGHUP)  # which rclpy leaves alone, and would end the program at once
    if threading.current_thread() is threading.main_thread():
        _taken = _Taken(numbers)
    else:
        log.warning(
            "Ctrl-C will close the middleware before the robot is stopped: make the robot in the main thread, or let a "
            "Guardian write its velocities"
        )


class _Taken:
    """Has taken signals from rclpy."""

    PATIENCE = 5.0
    """s that what a signal does in the main thread waits for robots to stand"""

    def __init__(self, numbers: list[signal.Signals]) -> None:
        self._stood = threading.Event()
        self._reader, self._writer = socket.socketpair()
        self._writer.setblocking(False)
        self._before: dict[int, Any] = {number: signal.getsignal(number) for number in numbers}
        for number in numbers:
            signal.signal(number, self._called)
        self._other = signal.set_wakeup_fd(self._writer.fileno(), warn_on_full_buffer=False)
        """What somebody else reads; -1: nobody."""
        threading.Thread(target=self._listen, name="ros2-signals", daemon=True).start()
        if hasattr(os, "register_at_fork"):  # Windows cannot fork
            os.register_at_fork(after_in_child=self._give_back)

    def _listen(self) -> None:
        while data := self._reader.recv(16):
            if self._other >= 0:
                with contextlib.suppress(OSError):  # closed by whoever read it
                    os.write(self._other, data)
            if not self._stood.is_set() and any(number in self._before for number in data):
                _stand()
                self._stood.set()
                _close_contexts()

    def _give_back(self) -> None:
        """In a child that was forked: a signal is the child's own, and the other end of the file is the parent's."""
        signal.set_wakeup_fd(-1)
        for number, before in self._before.items():
            signal.signal(number, before)

    def _called(self, number: int, frame: FrameType | None) -> None:
        """In the main thread, when that has time for it: perhaps after all is done."""
        self._stood.wait(self.PATIENCE)
        before = self._before[number]
        if callable(before):
            before(number, frame)  # Ctrl-C is a KeyboardInterrupt
        elif number == signal.SIGTERM:
            _end_spinning(frame)
        elif number == getattr(signal, "SIGHUP", None):  # of the others rclpy's handler has been made good
            signal.signal(number, signal.SIG_DFL)
            os.kill(os.getpid(), number)


def _end_spinning(frame: FrameType | None) -> None:
    """Tell who spins a node that it is over, as rclpy does: closed between two of its steps, a context makes it raise
    that the context is not valid."""
    from rclpy.executors import ExternalShutdownException

    while frame is not None:
        if frame.f_globals.get("__name__") == "rclpy.executors":
            raise ExternalShutdownException
        frame = frame.f_back


_robots: weakref.WeakKeyDictionary[_Robot, Any] = weakref.WeakKeyDictionary()
# A signal is the process's own: it is taken once, for all robots in it.
_taken: _Taken | None = None


def _stand() -> None:
    for robot in list(_robots):
        try:
            robot.stand()
        except Exception:
            log.exception("a robot could not be stopped")


def _close_contexts() -> None:
    """Whoever spins a node is woken and told by this that it is over."""
    from rclpy.utilities import get_default_context

    for context in {get_default_context(), *_robots.values()} - {None}:
        try:
            context.try_shutdown()
        except Exception:
            log.exception("rclpy could not be shut down")
