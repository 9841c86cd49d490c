"""A decode that nobody waits for any more is left.

Who goes on after a short pause has made what was decoded in it worthless, and the recogniser is wanted for what is said
next. A model cannot be interrupted, but it is asked many small things, and between two of them a decode can end.
"""

from __future__ import annotations

from threading import Event
from typing import Protocol, runtime_checkable

__all__ = ["Leavable", "Leaving", "LeftError"]


class LeftError(Exception):
    """The decode was left: it has no answer."""


@runtime_checkable
class Leavable(Protocol):
    """A recogniser whose decode can be left."""

    def leave(self) -> None:
        """Let the decode under way raise :class:`LeftError` soon, if there is one. From any thread."""
        ...


class Leaving:
    """What asks a model many small things for a decode that may be left."""

    left: Event | None = None
    """Of the decode that it is asked for: set when nobody waits for that any more. None: it is never left."""

    def stay(self) -> None:
        """A new decode begins, which is waited for."""
        self.left = Event()

    def leave(self) -> None:
        """As :meth:`Leavable.leave`."""
        if self.left is not None:
            self.left.set()

    def check(self) -> None:
        """Between two questions.

        Raises:
            LeftError: nobody waits for the answer.
        """
        if self.left is not None and self.left.is_set():
            raise LeftError
