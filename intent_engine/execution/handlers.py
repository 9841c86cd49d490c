"""Handlers of the user's: how one is called, what it may ask while it runs, and how it ends."""

from __future__ import annotations

import inspect
import logging
import threading
from collections.abc import Callable, Coroutine, Generator, Sequence
from typing import Any

from intent_engine.errors import IntentEngineError
from intent_engine.execution.goal import Feedback, Goal, GoalState, Reason
from intent_engine.execution.raised import with_type
from intent_engine.execution.runs import Ending

__all__ = ["Handler", "HandlerContext", "HandlerRun", "check_waiter"]

log = logging.getLogger(__name__)

_at_work = threading.local()
"""``goal``: the one whose handler this thread carries out."""


class HandlerContext:
    """What a handler may ask while it runs."""

    def __init__(self, goal: Goal) -> None:
        self.goal = goal
        self.cancelled = threading.Event()
        """Set when the goal was stopped or replaced; a long handler looks at it, or waits on it, and returns."""
        self.progress: float | None = None
        """0 to 1; the handler may set it."""


Handler = Callable[..., Any]
"""``handler(action)`` or ``handler(action, context)``; what it returns goes into the goal's detail, if it is text."""


class HandlerRun:
    """A handler of the user's, in a thread of its own (on a virtual clock: in the thread that moves the clock)."""

    needs_rest = True

    def __init__(
        self,
        goal: Goal,
        handler: Handler,
        launch: Callable[[Goal, Callable[[], None]], None],
        poke: Callable[[], None],
        timeout: float,
    ) -> None:
        self.goal = goal
        self._handler = handler
        self._launch = launch
        self._poke = poke
        self._timeout = timeout
        self._deadline = 0.0
        self._context = HandlerContext(goal)
        self._ending: Ending | None = None

    def begin(self, now: float) -> None:
        self._deadline = now + self._timeout
        self._launch(self.goal, self._work)

    def _work(self) -> None:
        if self._context.cancelled.is_set():
            return
        before, _at_work.goal = getattr(_at_work, "goal", None), self.goal
        fault: BaseException | None = None
        try:
            result = self._handler(*([self.goal.action, self._context][: _arguments(self._handler)]))
            self._ending = _after(result)
        except BaseException as error:  # a handler that calls sys.exit() ends its goal, too
            meant = isinstance(error, IntentEngineError)
            fault = None if meant else error
            text = str(error) if meant else with_type(error)
            self._ending = Ending(GoalState.ABORTED, Reason.HANDLER_ERROR, text)
            if isinstance(error, KeyboardInterrupt):
                raise
        finally:
            _at_work.goal = before
            self._poke()
        if fault is not None:  # when the goal has ended: a log that hangs holds up nobody
            log.error("the handler of %r raised", self.goal, exc_info=fault)

    def step(self, now: float) -> Ending | None:
        if self._ending is None and now >= self._deadline:
            self._context.cancelled.set()
            return Ending(GoalState.ABORTED, Reason.TIMEOUT, f"the handler took more than {self._timeout:g} s")
        return self._ending

    def due(self, now: float) -> float | None:
        return self._deadline if self._ending is None else now

    def suspend(self, now: float, at_once: bool) -> None:
        """A handler cannot be held; it goes on, and what comes after it waits."""

    def resume(self, now: float) -> None:
        pass

    def give_up(self, now: float) -> bool:
        self._context.cancelled.set()
        return True

    def feedback(self, now: float) -> Feedback:
        return Feedback(self._context.progress, None)


def check_waiter(goals: Sequence[Goal] | None, timeout: float | None) -> None:
    """See that a handler does not wait for ever: for its own goal, which ends when the handler does, or one behind it.

    Args:
        goals: what is waited for; None: everything.
        timeout: s; None: there is none.

    Raises:
        RuntimeError: it does.
    """
    own: Goal | None = getattr(_at_work, "goal", None)
    if own is None or own.done or timeout is not None:
        return
    if goals is None or any(goal is own or goal.state is GoalState.ACCEPTED for goal in goals):
        hint = "return first, submit in its place (policy='replace'), or give a timeout"
        raise RuntimeError(f"the handler of {own!r} would wait for its own end: {hint}")


def _after(result: object) -> Ending:
    """How a handler ended that returned."""
    if not (inspect.isawaitable(result) or inspect.isgenerator(result)):
        return Ending(GoalState.SUCCEEDED, detail=result if isinstance(result, str) else "")
    if isinstance(result, Coroutine | Generator):
        result.close()
    why = "the handler returned what has to be awaited, and nobody does: it is done when it returns"
    return Ending(GoalState.ABORTED, Reason.HANDLER_ERROR, why)


def _arguments(handler: Handler) -> int:
    """1 or 2: whether the handler wants the context too."""
    try:
        parameters = inspect.signature(handler).parameters.values()
    except (TypeError, ValueError):
        return 1
    places = 0
    for parameter in parameters:
        if parameter.kind is parameter.VAR_POSITIONAL:
            return 2
        if parameter.kind in (parameter.POSITIONAL_ONLY, parameter.POSITIONAL_OR_KEYWORD):
            # A second parameter with a default is the handler's own business, unless it is called context.
            places += parameter.default is parameter.empty or parameter.name == "context"
    return min(max(places, 1), 2)
