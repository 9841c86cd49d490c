"""What came out of a robot's code: whether the robot has failed, and what is told of it."""

from __future__ import annotations

import threading

__all__ = ["pass_on_interrupt", "told", "with_type"]


def pass_on_interrupt(error: BaseException) -> None:
    """Raise an error that is none of the robot's: Ctrl-C, and the exit of a signal's handler, come to the main thread
    wherever it is, so that there nobody can tell whose they are. In any other thread it was the robot that raised:
    ``sys.exit()``, or the ``CancelledError`` of its event loop.
    """
    if not isinstance(error, Exception) and threading.current_thread() is threading.main_thread():
        raise error


def told(error: BaseException) -> str:
    """What an error says; with its type where that is no ordinary one, its type alone where it says nothing."""
    return (_text(error) or type(error).__name__) if isinstance(error, Exception) else with_type(error)


def with_type(error: BaseException) -> str:
    """An error's type, and what it says."""
    text = _text(error)
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


def _text(error: BaseException) -> str:
    try:
        return str(error)
    except Exception:  # it fails at that, too
        return ""
