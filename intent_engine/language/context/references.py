"""Words that point back, put in after the meaning is known: "again" and "the other way" do what was done last, "it" is
what was named last.

Applied to actions only; the slots of an interpretation keep the words that were said.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TypeAlias

from intent_engine.actions import Action, ChangeSpeed
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.done_again import done_again
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.pronouns import ThingsNamed
from intent_engine.needs import Needs

__all__ = ["Before", "resolve"]

Before: TypeAlias = Interpretation | Sequence[Action] | Action
"""What was done before: as it was understood, with what its intents ask of the states of the robot, or its actions."""

_SPEED_BY_ITSELF = "another speed is of what is being done, and not of what is said with it; say it by itself"


def resolve(
    found: Interpretation,
    last: Sequence[Action] | None,
    grammar: Grammar,
    asked: Sequence[Needs] = (),
    state: Collection[str] = (),
) -> Interpretation:
    """An interpretation with what it points back to put in.

    Args:
        found: as parsed.
        last: the actions of the utterance before, empty if there was none; None if that is not known: then words
            that point out of the utterance are left as they are. "Again" is the last of them, "it" what was named last.
        grammar: in which it was said.
        asked: what each of the actions of ``last`` asks of the states of the robot; empty if that is not known.
        state: those in which it is.

    Returns:
        The same object if nothing points back. Rejected if something does and there is nothing to point at, or what it
        points at cannot be done in these states.
    """
    if len({isinstance(action, ChangeSpeed) for action in found.actions}) > 1:
        return _rejected(found, _SPEED_BY_ITSELF)
    before = last[-1] if last else None
    needed = asked[-1] if last and len(asked) == len(last) else None
    named = ThingsNamed(grammar, last or ())
    if found.denied:
        denied = dict.fromkeys(meant for action in found.denied for meant in named.denied(action))
        found = replace(found, denied=tuple(denied))
    actions: list[Action] = []
    needs = list(found.needs)
    for place, action in enumerate(found.actions):
        own = needs[place] if len(needs) == len(found.actions) else None
        again = done_again(action, last, before, said_after=place > 0 or found.corrected)
        meant = named.put_in(action) if again is None else again
        if isinstance(meant, str):
            return _rejected(found, meant)
        if again is not None and needed is not None:
            if unmet := needed.unmet(state):
                return _rejected(found, unmet)
            if own is not None:
                own = needs[place] = needed.joined(own)
        named.add(meant)
        actions.append(meant)
        before, needed = meant, own
    if all(meant is action for meant, action in zip(actions, found.actions, strict=True)):
        return found
    return replace(found, actions=tuple(actions), needs=tuple(needs))


def _rejected(found: Interpretation, reason: str) -> Interpretation:
    return Interpretation(found.text, Status.REJECTED, found.intent, found.slots, (), 0.0, (), reason)
