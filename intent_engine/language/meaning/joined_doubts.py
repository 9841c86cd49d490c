"""Commands that are joined and may mean two things: "left and right ninety degrees", "go forward and back"."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from intent_engine.actions import Custom, Move, Navigate, Pick, Place, Turn
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.command import Commands

__all__ = ["JoinedDoubts"]


class JoinedDoubts:
    """Puts the one clause that says so in the place of what goes on from a command."""

    def __init__(self, commands: Commands) -> None:
        self._commands = commands
        self._ways_back = commands.matcher.grammar.wording.ways_back

    def unless_for_both(self, clause: Clause, onward: list[Clause]) -> list[Clause]:
        """What goes on from a command, unless it ends with what may be meant for both: "left and right ninety degrees".
        Then the one clause that says so. "A coffee and two teas" are one coffee, and "left and then right ninety
        degrees" one turn after the other."""
        one, other = clause.reading, onward[0].reading
        if one is None or other is None or one.intent is not other.intent or not other.slots:
            return onward
        last, said = other.slots[-1], one.values()
        alike = said.keys() & other.values().keys() - {last.label}
        if last.label in said or not alike or last.end < len(other.words) or self._commands.opens_with_a_verb(other):
            return onward
        both = replace(one, slots=(*one.slots, last))
        meanings = tuple(f"{described(first)}, then {described(other)}" for first in (one, both))
        reason = f"{' '.join(other.words[last.start :])!r} may be meant for both; say each command in full"
        return [Clause(one, reason=reason, alternatives=meanings, ambiguous=True)]

    def unless_the_way_back(self, clause: Clause, onward: list[Clause]) -> list[Clause]:
        """What goes on from a command, unless that may have gone somewhere and what follows ends with "back" and says
        no more: backward, or back to where it came from? "Go forward two meters and back" is no 60 cm backward. To turn
        in between goes nowhere else: "take the cup to the kitchen, turn around and go back"."""
        back = next((later for later in onward if not isinstance(later.action, Turn)), onward[0])
        one, other = clause.reading, back.reading
        if one is None or other is None or not self._ways_back.ends(other.words):
            return onward
        if not _goes_somewhere(clause) or not isinstance(back.action, Move) or _goes_somewhere(back):
            return onward
        either = (f"{described(one)}, then {described(other)}", f"{described(one)}, then the way back")
        reason = f"{' '.join(other.words)!r} may be backward, or the way back; say how far, or where to"
        return [Clause(one, reason=reason, alternatives=either, ambiguous=True)]

    def unless_of_its_verb(self, clause: Clause, onward: list[Clause], state: Collection[str]) -> list[Clause]:
        """What goes on from a command, unless it begins with a value and does something else behind the verb before:
        "look up and *down*" is no order to lie down, where that is one."""
        one, other = clause.reading, onward[0].reading
        if one is None or other is None or one.intent is other.intent:
            return onward
        if not onward[0].accepted or not other.slots or other.slots[0].start:
            return onward
        for slot in one.slots:
            if slot.start == 0 or slot.slot.type != "choice" or slot.slot is other.slots[0].slot:
                continue
            behind = self._commands.exact([*one.words[: slot.start], *other.words], state)
            if behind is not None and behind.accepted and behind.reading is not None:
                if behind.action == onward[0].action:
                    continue
                either = tuple(f"{described(one)}, then {described(way)}" for way in (other, behind.reading))
                reason = f"{' '.join(other.words)!r} may be a command, or be said of the verb before; say it in full"
                return [Clause(one, reason=reason, alternatives=either, ambiguous=True)]
        return onward


def _goes_somewhere(clause: Clause) -> bool:
    """Whether a command may have an end that one can come back from: a place, where a thing is or goes, or how far.
    Where an action of the user's own leads, only he knows: "deliver the mail", "take the cup to the kitchen"."""
    if isinstance(clause.action, Navigate | Custom):
        return True
    slots = clause.reading.slots if clause.reading is not None else ()
    if isinstance(clause.action, Pick | Place):
        return len(slots) > 1
    return isinstance(clause.action, Move) and any(slot.slot.type in ("distance", "duration") for slot in slots)
