"""Work beside, in threads that native code may be busy in when the process ends.

An interpreter waits at its end for usual threads, for ever if need be, as for a model that hangs. From a daemon thread
it goes away; but native code that comes back to it then aborts the whole process. So it waits, but only so long.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import threading
import weakref
from collections.abc import Callable
from concurrent.futures import Future
from queue import Empty, SimpleQueue
from typing import ParamSpec, TypeAlias, TypeVar

__all__ = ["PATIENCE", "Beside", "cores", "start_beside"]

_Result = TypeVar("_Result")
_Asked = ParamSpec("_Asked")
_Waiting: TypeAlias = SimpleQueue[Callable[[], None] | None]

PATIENCE = 20.0
"""s that the end of the process waits for such a thread: a model that is loaded with both cores busy takes several."""


def cores() -> int:
    """Cores of the processor that this process may use; of all that there are, where the system does not tell."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # only Linux knows it
        return os.cpu_count() or 1


def start_beside(
    work: Callable[[], object], name: str, stop: Callable[[], object] | None = None, *, patience: float = PATIENCE
) -> threading.Thread:
    """Start a thread that the process waits for when it ends, but not for ever.

    Args:
        work: what it does.
        name: of the thread.
        stop: called when the process ends, so that the work ends. It may be called when that is over.
        patience: s that the process waits at most.
    """

    def run() -> None:
        try:
            work()
        finally:
            atexit.unregister(end)

    def end() -> None:
        if stop is not None:
            stop()
        with contextlib.suppress(KeyboardInterrupt):  # who asks twice is waited for no longer
            thread.join(patience)

    thread = threading.Thread(target=run, name=name, daemon=True)
    atexit.register(end)
    try:
        thread.start()
    except RuntimeError:  # the system has no more threads
        atexit.unregister(end)
        raise
    return thread


class Beside:
    """Does one piece of work after the other in one thread, which ends with it: closed, or forgotten by all.

    Args:
        name: of the thread.
        patience: s that the end of the process waits for what it does.
    """

    def __init__(self, name: str, *, patience: float = PATIENCE) -> None:
        waiting: _Waiting = SimpleQueue()
        self._waiting = waiting
        self._closed = False
        self._closing = threading.Lock()
        # The thread knows nothing but what waits: it would keep all that it works for.
        start_beside(lambda: _work(waiting), name, lambda: _drop(waiting), patience=patience)
        weakref.finalize(self, waiting.put, None)

    def submit(self, ask: Callable[_Asked, _Result], *args: _Asked.args, **kwargs: _Asked.kwargs) -> Future[_Result]:
        """Call something there, after what was submitted before; the future holds what it returns or raises, or
        a ``RuntimeError``, if this is closed."""
        future: Future[_Result] = Future()

        def answer() -> None:
            try:
                future.set_result(ask(*args, **kwargs))
            except BaseException as error:  # whatever it raises must come back to the caller
                future.set_exception(error)

        with self._closing:
            if self._closed:
                future.set_exception(RuntimeError("it is closed, and nothing more is asked of it"))
            else:
                self._waiting.put(answer)
        return future

    def close(self) -> None:
        """Let the thread end after what was submitted. Idempotent."""
        with self._closing:
            self._closed = True
            self._waiting.put(None)


def _work(waiting: _Waiting) -> None:
    """Do what waits, one after the other."""
    while (answer := waiting.get()) is not None:
        answer()
        del answer  # it holds whom it was asked by, and the next may never come


def _drop(waiting: _Waiting) -> None:
    """Let the thread end after what it does now."""
    with contextlib.suppress(Empty):
        while True:
            waiting.get_nowait()
    waiting.put(None)
