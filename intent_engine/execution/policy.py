"""What a new command does to the one before it."""

from __future__ import annotations

from enum import StrEnum

__all__ = ["Policy"]


class Policy(StrEnum):
    """What a new command does when another one is being carried out."""

    REPLACE = "replace"
    """It takes its place at once (the default)."""
    QUEUE = "queue"
    """It waits its turn."""
    FOLLOW = "follow"
    """It waits its turn as a part of the command before it: if that is not done to its end, neither is this."""
    REFUSE = "refuse"
    """It is rejected."""
