"""Words that point back: "again" repeats the last action, "the other way" reverses it, "it" is what was picked up or
named last.

Applied after the meaning is known, to actions only; the slots of an interpretation keep the words that were said.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TypeAlias

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Pick, Place, Stop, Turn
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.other_way import OTHER_WAY, opposite
from intent_engine.needs import Needs

__all__ = ["AGAIN", "Before", "names_something", "resolve", "said_by_itself"]

Before: TypeAlias = Interpretation | Sequence[Action] | Action
"""What was done before: as it was understood, with what its intents ask of the states of the robot, or its actions."""

AGAIN = "again"
"""Name of the custom action that repeats the last one, ``scale`` times as far."""
_SPEED_BY_ITSELF = "another speed is of what is being done, and not of what is said with it; say it by itself"
_WHICH = "it may mean the motion or its speed; say what to do"
NOTHING_DONE = "nothing was done yet that could be done again"


def resolve(
    found: Interpretation,
    last: Sequence[Action] | None,
    pronouns: Collection[tuple[str, ...]],
    asked: Sequence[Needs] = (),
    state: Collection[str] = (),
    several: Collection[str] = (),
) -> Interpretation:
    """An interpretation with what it points back to put in.

    Args:
        found: as parsed.
        last: the actions of the utterance before, empty if there was none; None if that is not known: then words
            that point out of the utterance are left as they are. "Again" is the last of them, "it" what was named last.
        pronouns: words for a thing that was named before.
        asked: what each of the actions of ``last`` asks of the states of the robot; empty if that is not known.
        state: those in which it is.
        several: pronouns for more than one thing; some are for one as well ("the scissors").

    Returns:
        The same object if nothing points back. Rejected if something does and there is nothing to point at, or what it
        points at cannot be done in these states.
    """
    if not found.actions:
        return found
    changes = [isinstance(action, ChangeSpeed) for action in found.actions]
    if any(changes) and not all(changes):
        return _rejected(found, _SPEED_BY_ITSELF)
    before = last[-1] if last else None
    needed = asked[-1] if last and len(asked) == len(last) else None
    things = {" ".join(words) for words in pronouns}
    named = list(dict.fromkeys(one for action in last or () if (one := _thing(action, things)) is not None))
    thing = next((one for action in reversed(last or ()) if (one := _thing(action, things)) is not None), None)
    actions: list[Action] = []
    needs = list(found.needs)
    changed = False
    for place, action in enumerate(found.actions):
        meant = action
        own = needs[place] if len(needs) == len(found.actions) else None
        if isinstance(action, Custom) and action.name == OTHER_WAY:
            said_after = place > 0 or found.corrected
            if said_after or last is not None:
                turned = opposite(last or (), said_after=said_after)
                if isinstance(turned, str):
                    return _rejected(found, turned)
                meant = turned
                if needed is not None and (unmet := needed.unmet(state)):
                    return _rejected(found, unmet)
                if needed is not None and own is not None:
                    own = needs[place] = needed.joined(own)
        elif isinstance(action, Custom) and action.name == AGAIN:
            if before is None and last is not None:
                return _rejected(found, NOTHING_DONE)
            if isinstance(before, ChangeSpeed):
                return _rejected(found, _WHICH)
            if before is not None:
                repeated = _again(before, action.slots.get("scale"))
                if repeated is None:
                    return _rejected(found, f"{_name(before)} is not something to do a little more of")
                meant = repeated
                if needed is not None and (unmet := needed.unmet(state)):
                    return _rejected(found, unmet)
                if needed is not None and own is not None:
                    own = needs[place] = needed.joined(own)
        elif thing is not None:
            meant = _with_thing(action, thing, things)
            if meant is not action and len(named) > 1 and any(one in several for one in _objects(action)):
                return _rejected(found, f"more than one thing was named: {', '.join(named)}; say what to do with each")
        changed = changed or meant is not action
        actions.append(meant)
        before, needed = meant, own
        thing = _thing(meant, things) or thing
        if thing is not None and thing not in named:
            named.append(thing)
    return replace(found, actions=tuple(actions), needs=tuple(needs)) if changed else found


def said_by_itself(action: Action) -> bool:
    """Whether an action is about what is done already, so that it is refused in one sentence with others: "faster",
    "the other way"."""
    return isinstance(action, ChangeSpeed) or (isinstance(action, Custom) and action.name == OTHER_WAY)


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
    found = next((one for one in _objects(action) if one), None)
    return found if isinstance(found, str) and found not in pronouns else None


def names_something(action: Action) -> bool:
    """Whether an action has to do with something that "it" can be."""
    return any(_objects(action))


def _objects(action: Action | None) -> tuple[object, ...]:
    """What an action may have to do with, as it was said."""
    if isinstance(action, (Pick, Place)):
        return (action.object,)
    return tuple(action.slots.get(key) for key in _keys(action)) if isinstance(action, Custom) else ()


def _keys(action: Custom) -> tuple[str, ...]:
    """Slots that name what an action has to do with: of "look at the cup" its target, of "bring it to the door" not."""
    return ("thing", "object") if not action.slots.keys().isdisjoint(("thing", "object")) else ("target",)


def _with_thing(action: Action, thing: str, pronouns: Collection[str]) -> Action:
    if isinstance(action, (Pick, Place)) and action.object in pronouns:
        return replace(action, object=thing)
    if isinstance(action, Custom) and any(action.slots.get(key) in pronouns for key in _keys(action)):
        slots = {
            key: thing if key in _keys(action) and value in pronouns else value for key, value in action.slots.items()
        }
        return replace(action, slots=slots)
    return action


def _name(action: Action) -> str:
    return action.name if isinstance(action, Custom) else action.type


def _rejected(found: Interpretation, reason: str) -> Interpretation:
    return Interpretation(found.text, Status.REJECTED, found.intent, found.slots, (), 0.0, (), reason)
