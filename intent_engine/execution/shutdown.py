"""The last zeros of a process: at its normal end, and when it is asked to end, or its terminal is closed."""

from __future__ import annotations

import atexit
import logging
import os
import signal
import threading
import weakref
from types import FrameType
from typing import Any, Protocol

__all__ = ["check_free", "register", "unregister"]

log = logging.getLogger(__name__)


class _Closable(Protocol):
    robot: Any

    def close(self) -> None: ...
    def disown(self) -> None: ...
    def last_zeros(self) -> None: ...


_ASKED_TO_END = [signal.SIGTERM, *([signal.SIGHUP] if hasattr(signal, "SIGHUP") else [])]  # Windows hangs up on nobody

# The end of a process is the process's own: one list for all executors in it.
_open: weakref.WeakSet[_Closable] = weakref.WeakSet()


def check_free(robot: object) -> None:
    """See that no executor of this process drives a robot: a stop of one would not end what the other does.

    Raises:
        ValueError: one does.
    """
    if any(executor.robot is robot for executor in list(_open)):
        raise ValueError("another executor drives this robot: share that one, or close() it first")


def register(executor: _Closable, sigterm: bool) -> None:
    """Stop ``executor`` when the process ends; with ``sigterm`` also when it is asked to, if nobody else listens."""
    _open.add(executor)
    if not sigterm or threading.current_thread() is not threading.main_thread():
        return
    for number in _ASKED_TO_END:
        if signal.getsignal(number) is signal.SIG_DFL:  # and not ignored, as with nohup
            signal.signal(number, _terminate)


def unregister(executor: _Closable) -> None:
    _open.discard(executor)


def _forked() -> None:
    """A child that was forked has the parent's objects, and neither its threads nor its robot: what is submitted there
    would begin and never end, and its end must not stop what the parent drives."""
    for executor in list(_open):
        executor.disown()
    _open.clear()


if hasattr(os, "register_at_fork"):  # Windows cannot fork
    os.register_at_fork(after_in_child=_forked)


@atexit.register
def _at_exit() -> None:
    for executor in list(_open):
        try:
            executor.last_zeros()  # closing may have been interrupted, and then does nothing a second time
            executor.close()
        except Exception:
            log.exception("an executor could not be closed")


def _terminate(number: int, frame: FrameType | None) -> None:
    for executor in list(_open):
        executor.last_zeros()
    _at_exit()
    # End as a process that was terminated ends, so that who waits for it is told the truth.
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)
