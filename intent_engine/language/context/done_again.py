"""What was done last, once more: "again" as it was, a little more of it, or "the other way" in the opposite
direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Stop, Turn

__all__ = ["AGAIN", "done_again", "said_by_itself"]

AGAIN = "again"
"""Name of the custom action that repeats the last one, ``scale`` times as far."""
OTHER_WAY = "other_way"
"""Name of the custom action that does the last drive or turn in the opposite direction."""
_NOTHING_DONE = "nothing was done yet that could be done again"
_WHICH = "it may mean the motion or its speed; say what to do"
_NO_OTHER_WAY_YET = "nothing was done yet that has another way"
_SEVERAL = "more than one motion was asked for before, and it may be of any; say all of what to do"
_ITS_SPEED = "how fast is not clear, since the speed was changed meanwhile; say all of what to do"
_IN_ONE_SENTENCE = "it may take the place of what it is said with, or follow it; say all of what to do"


def done_again(
    action: Action, last: Sequence[Action] | None, before: Action | None, *, said_after: bool
) -> Action | str | None:
    """What an action means that does what was done once more, or why it means nothing; None: it is no such action, or
    what was done is not known.

    Args:
        action: as it was said.
        last: what the utterance before did, in order; None: that is not known.
        before: what is done right before the action, in its own utterance or the one before.
        said_after: whether it is said behind another command in its sentence: what is done before it is not done yet.
    """
    if not isinstance(action, Custom):
        return None
    if action.name == OTHER_WAY and (said_after or last is not None):
        return _IN_ONE_SENTENCE if said_after else _opposite(last or ())
    if action.name == AGAIN and before is not None:
        return _repeated(before, action.slots.get("scale"))
    return _NOTHING_DONE if action.name == AGAIN and last is not None else None


def said_by_itself(action: Action) -> bool:
    """Whether an action is about what is done already, so that it is refused in one sentence with others: "faster",
    "the other way"."""
    return isinstance(action, ChangeSpeed) or (isinstance(action, Custom) and action.name == OTHER_WAY)


def _repeated(done: Action, scale: object) -> Action | str:
    if isinstance(done, ChangeSpeed):
        return _WHICH
    factor = float(scale) if isinstance(scale, (int, float)) and not isinstance(scale, bool) else 1.0
    if factor == 1.0 and not isinstance(done, Stop):
        return done
    if factor != 1.0 and isinstance(done, Move):
        return replace(done, distance=done.distance * factor, duration=done.duration * factor)
    if factor != 1.0 and isinstance(done, Turn):
        return replace(done, angle=done.angle * factor, duration=done.duration * factor)
    return f"{_name(done)} is not something to do a little more of"


def _opposite(last: Sequence[Action]) -> Action | str:
    if not last:
        return _NO_OTHER_WAY_YET
    done = last[-1]
    if isinstance(done, ChangeSpeed):
        return _ITS_SPEED
    if not isinstance(done, Move | Turn):
        return f"{_name(done)} has no other way; say all of what to do"
    if sum(isinstance(action, Move | Turn) for action in last) > 1:
        return _SEVERAL
    if isinstance(done, Move):
        return replace(done, linear_velocity=-done.linear_velocity)
    return replace(done, angle=-done.angle, angular_velocity=-done.angular_velocity)


def _name(action: Action) -> str:
    return action.name if isinstance(action, Custom) else action.type
