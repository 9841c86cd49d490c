"""Actions of the user's own where no program carries them out: shown, and done at once, so that a sentence goes on.

For robots that are simulated. On any other, what comes after an action that was not done might not be wanted.
"""

from __future__ import annotations

from intent_engine.actions import Custom
from intent_engine.execution.executor import Executor

__all__ = ["SHOWN_ONLY", "show_own_actions"]

SHOWN_ONLY = "no handler in this program: shown only"
"""The detail of a goal that ended so."""


def show_own_actions(executor: Executor) -> None:
    """Let every custom action that has no handler of its own succeed at once, with :data:`SHOWN_ONLY` as its detail."""
    executor.register("custom", _shown)


def _shown(action: Custom) -> str:
    return SHOWN_ONLY
