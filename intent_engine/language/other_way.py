"""The other way: the last drive or turn, as far, in the opposite direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Turn

__all__ = ["OTHER_WAY", "opposite"]

OTHER_WAY = "other_way"
"""Name of the custom action that does the last drive or turn in the opposite direction."""
_NOTHING_DONE = "nothing was done yet that has another way"
_SEVERAL = "more than one motion was asked for before, and it may be of any; say all of what to do"
_ITS_SPEED = "how fast is not clear, since the speed was changed meanwhile; say all of what to do"
_IN_ONE_SENTENCE = "it may take the place of what it is said with, or follow it; say all of what to do"


def opposite(last: Sequence[Action], *, said_after: bool) -> Action | str:
    """The opposite of what was done last, or why there is none.

    Args:
        last: what was done before, in order.
        said_after: whether it is said behind another command, in the same sentence: what is done before it is not done
            yet.
    """
    if said_after:
        return _IN_ONE_SENTENCE
    if not last:
        return _NOTHING_DONE
    done = last[-1]
    if isinstance(done, ChangeSpeed):
        return _ITS_SPEED
    if not isinstance(done, Move | Turn):
        return f"{done.name if isinstance(done, Custom) else done.type} has no other way; say all of what to do"
    if sum(isinstance(action, Move | Turn) for action in last) > 1:
        return _SEVERAL
    if isinstance(done, Move):
        return replace(done, linear_velocity=-done.linear_velocity)
    return replace(done, angle=-done.angle, angular_velocity=-done.angular_velocity)
