"""Words that point back: "again" repeats the last action, "it" is what was last picked up or named.

Applied after the meaning is known, to actions only; the slots of an interpretation keep the words that were said.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from intent_engine.actions import Action, Custom, Move, Pick, Place, Stop, Turn
from intent_engine.interpretation import Interpretation, Status

__all__ = ["AGAIN", "resolve"]

AGAIN = "again"
"""Name of the custom action that repeats the last one, ``scale`` times as far."""
NOTHING_DONE = "nothing was done yet that could be done again"


def resolve(
    found: Interpretation, last: Sequence[Action] | None, pronouns: Collection[tuple[str, ...]]
) -> Interpretation:
    """An interpretation with what it points back to put in.

    Args:
        found: as parsed.
        last: the actions of the utterance before, empty if there was none; None if that is not known: then words
            that point out of the utterance are left as they are.
        pronouns: words for a thing that was named before.

    Returns:
        The same object if nothing points back. Rejected if something does and there is nothing to point at.
    """
    if not found.actions:
        return found
    before = last[-1] if last else None
    things = {" ".join(words) for words in pronouns}
    thing = _thing(before, things)
    actions: list[Action] = []
    changed = False
    for action in found.actions:
        meant = action
        if isinstance(action, Custom) and action.name == AGAIN:
            if before is None and last is not None:
                return _rejected(found, NOTHING_DONE)
            if before is not None:
                repeated = _again(before, action.slots.get("scale"))
                if repeated is None:
                    return _rejected(found, f"{_name(before)} is not something to do a little more of")
                meant = repeated
        elif thing is not None:
            meant = _with_thing(action, thing, things)
        changed = changed or meant is not action
        actions.append(meant)
        before = meant
        thing = _thing(meant, things) or thing
    return replace(found, actions=tuple(actions)) if changed else found


def _again(action: Action, scale: object) -> Action | None:
    factor = float(scale) if isinstance(scale, (int, float)) and not isinstance(scale, bool) else 1.0
    if factor == 1.0:
        return None if isinstance(action, Stop) else action
    if isinstance(action, Move):
        return replace(action, distance=action.distance * factor, duration=action.duration * factor)
    if isinstance(action, Turn):
        return replace(action, angle=action.angle * factor, duration=action.duration * factor)
    return None


def _thing(action: Action | None, pronouns: Collection[str]) -> str | None:
    """What an action has to do with."""
    found: object = None
    if isinstance(action, (Pick, Place)):
        found = action.object
    elif isinstance(action, Custom):
        found = next((action.slots[key] for key in ("thing", "object") if action.slots.get(key)), None)
    return found if isinstance(found, str) and found not in pronouns else None


def _with_thing(action: Action, thing: str, pronouns: Collection[str]) -> Action:
    if isinstance(action, (Pick, Place)) and action.object in pronouns:
        return replace(action, object=thing)
    if isinstance(action, Custom) and any(action.slots.get(key) in pronouns for key in ("thing", "object")):
        slots = {
            key: thing if key in ("thing", "object") and value in pronouns else value
            for key, value in action.slots.items()
        }
        return replace(action, slots=slots)
    return action


def _name(action: Action) -> str:
    return action.name if isinstance(action, Custom) else action.type


def _rejected(found: Interpretation, reason: str) -> Interpretation:
    return Interpretation(found.text, Status.REJECTED, found.intent, found.slots, (), 0.0, (), reason)
