"""The life of a process that is one node: signals, spinning, and an end in the right order."""

from __future__ import annotations

import contextlib
import itertools
import logging
import os
import signal
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Protocol

from intent_engine.errors import ConfigError, IntentEngineError, Problem
from intent_engine.execution.robots.ros2_spinning import Spinning
from intent_engine.execution.robots.ros2_support import import_rclpy

__all__ = ["EXIT_FAULT", "Room", "run_script"]

EXIT_FAULT = 70
"""A fault of ours (EX_SOFTWARE of sysexits.h), as the command line has it."""


class Room(Protocol):
    """What a node does; made with it, and closed while it is still spun."""

    def close(self) -> None: ...


def run_script(
    name: str,
    make: Callable[[Any, Callable[[int], None]], Room],
    arguments: Sequence[str] | None = None,
    about: str | None = None,
) -> int:
    """What the script of a node runs; returns the exit code, or ends the process with it. What cannot be run is told on
    standard error.

    Args:
        name, make, about: as for :func:`_run_node`.
        arguments: the whole command line; None: that of this process.
    """
    try:
        return _leave(_run_node(name, make, sys.argv if arguments is None else arguments, about))
    except IntentEngineError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.exit_code


def _run_node(
    name: str, make: Callable[[Any, Callable[[int], None]], Room], arguments: Sequence[str], about: str | None
) -> int:
    """Run a node until SIGINT, SIGTERM, the end of its terminal or its own; returns the exit code.

    The order of the end is the point of this function. rclpy's own signal handlers close the middleware first, and then
    no zero velocity can be sent and no navigation cancelled; so they are not used. What the node does is closed while
    the node is still spun, then the spinning ends, then the middleware.

    Args:
        name: of the node, if it is not remapped.
        make: makes what the node does, given the node and a function that ends the process with an exit code.
        arguments: the whole command line, ``--ros-args`` among them.
        about: what ``--help`` prints.

    Raises:
        RobotError: no ROS 2 in this Python.
        ConfigError: an argument is not understood.
    """
    words = itertools.takewhile(lambda word: word != "--ros-args", arguments[1:])
    if {"-h", "--help"} & set(words):
        print(f"{about}\nParameters: {Path(arguments[0]).name} --ros-args -p name:=value; all of them: docs/ros2.md")
        return 0
    import_rclpy()
    end = _End()
    signals = [signal.SIGINT, signal.SIGTERM]
    if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:  # as with nohup
        signals.append(signal.SIGHUP)
    before = [signal.signal(number, lambda number, frame: end.ask()) for number in signals]
    try:
        node = _made(name, arguments)
        ended = True
        try:
            ended = _live(node, make, end)
        finally:
            if ended:
                with contextlib.suppress(Exception):
                    node.destroy_node()
                    node.context.shutdown()
    finally:
        for number, handler in zip(signals, before, strict=True):
            signal.signal(number, handler)
    return end.code


class _End:
    """The end of a process: its main thread waits for it, and anybody may ask for it."""

    def __init__(self) -> None:
        self.code = 0
        """Exit code."""
        self.asked = threading.Event()

    def ask(self, code: int | None = None) -> None:
        """Let the process end; None: with the exit code that it has."""
        if code is not None:
            self.code = code
        self.asked.set()


def _made(name: str, arguments: Sequence[str]) -> Any:
    """A node in a context of its own, which leaves signals alone.

    Raises:
        ConfigError: an argument is not understood.
    """
    import rclpy
    from rclpy.signals import SignalHandlerOptions
    from rclpy.utilities import remove_ros_args

    context = rclpy.Context()
    try:
        if unknown := remove_ros_args(list(arguments))[1:]:
            raise ValueError(f"{unknown[0]!r} is not understood")
        rclpy.init(args=list(arguments), context=context, signal_handler_options=SignalHandlerOptions.NO)
        return rclpy.create_node(name, context=context)
    except Exception as error:  # rclpy has an exception for each mistake in a ROS argument, of no common kind
        raise ConfigError(
            Problem(f"arguments: {str(error).strip()}", hint="--ros-args -p parameter:=value -r name:=other")
        ) from None


def _live(node: Any, make: Callable[[Any, Callable[[int], None]], Room], end: _End) -> bool:
    """Make what a node does, and spin the node until the end is asked for. Returns whether it may be destroyed then."""
    try:
        room = make(node, end.ask)
    except IntentEngineError as error:
        node.get_logger().fatal(str(error))
        end.code = error.exit_code
        return True

    def failed(error: Exception) -> None:  # a callback of ours raised what it should have caught
        end.code = EXIT_FAULT
        node.get_logger().fatal(f"the node failed: {type(error).__name__}: {error}; the robot is stopped")

    spinning = Spinning(node, failed=failed, over=end.ask)
    try:
        end.asked.wait()
    finally:
        room.close()
        ended = spinning.end()
    return ended


def _leave(code: int) -> int:
    """The exit code of a process in which everything has been closed; or its end, then and there.

    A thread that is still inside a library (a recogniser in the middle of an utterance) and comes back while Python
    takes itself down is ended by force, and C++ then aborts the process: who started it would be told of a crash.
    """
    if any(thread is not threading.current_thread() for thread in threading.enumerate()):
        logging.shutdown()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    return code
