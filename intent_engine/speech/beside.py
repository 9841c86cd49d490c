"""Work beside, one piece after the other, in a thread that never keeps the process from ending."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from queue import SimpleQueue
from typing import ParamSpec, TypeVar

__all__ = ["Beside"]

_Result = TypeVar("_Result")
_Asked = ParamSpec("_Asked")


class Beside:
    """As a ``ThreadPoolExecutor`` with one thread; but that waits at exit for what never ends, as a model may.

    Args:
        name: of the thread.
    """

    def __init__(self, name: str) -> None:
        self._waiting: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        threading.Thread(target=self._work, name=name, daemon=True).start()

    def submit(self, ask: Callable[_Asked, _Result], *args: _Asked.args, **kwargs: _Asked.kwargs) -> Future[_Result]:
        """Call something there, after what was submitted before; the future holds what it returns or raises."""
        future: Future[_Result] = Future()

        def answer() -> None:
            try:
                future.set_result(ask(*args, **kwargs))
            except BaseException as error:  # whatever it raises must come back to the caller
                future.set_exception(error)

        self._waiting.put(answer)
        return future

    def close(self) -> None:
        """Let the thread end after what was submitted. Idempotent."""
        self._waiting.put(None)

    def _work(self) -> None:
        while (answer := self._waiting.get()) is not None:
            answer()
