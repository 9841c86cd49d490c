"""A command that is carried out, and what is to be done when it turns out to be the beginning of a longer one.

"Turn left" is being done when "turn left ninety degrees" is known to have been meant. Some actions can be put right
while they are done; what comes after others waits its turn; and what was done is over.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass

from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Turn
from intent_engine.execution.goal import Goal, GoalState
from intent_engine.execution.policy import Policy
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.utterance import plain

__all__ = ["CarriedOut", "Step", "begun_alike", "can_be_amended", "in_a_row"]


@dataclass(frozen=True, slots=True)
class Step:
    """What is to be done of a command."""

    actions: tuple[Action, ...]
    policy: Policy | None = None
    """What becomes of what is being done; None: as for any command."""
    amends: Goal | None = None
    """The goal that the first of the actions puts right."""
    goes_on: bool = False
    """Whether the command before is a part of it."""

    @property
    def in_turn(self) -> bool:
        """Whether it is a command by itself that is done after the one before, and not in its place."""
        return self.policy is Policy.FOLLOW and not self.goes_on

    def guards_of(
        self, whole: Interpretation, state: Callable[[], Collection[str]]
    ) -> tuple[Callable[[], str] | None, ...]:
        """The guards of its actions, which are the last ones of a whole command; ``state`` as for
        :meth:`Interpretation.guards`."""
        return whole.guards(state)[len(whole.actions) - len(self.actions) :]


@dataclass(frozen=True, slots=True)
class CarriedOut:
    """A command, and the goals that carry it out."""

    meaning: Interpretation
    goals: tuple[Goal, ...]

    @property
    def under_way(self) -> bool:
        """Whether nothing came between: no stop, no other command, no failure."""
        return all(goal.succeeded or not goal.done for goal in self.goals)

    def begins(self, whole: Interpretation) -> bool:
        """Whether it is the beginning of a longer command."""
        words, begun = plain(whole.text), plain(self.meaning.text)
        return whole.status is Status.ACCEPTED and words[: len(begun)] == begun and len(words) > len(begun)

    def says_no_more(self, whole: Interpretation) -> bool:
        """Whether it is the beginning of a longer sentence that means the same: "too loud" of "too loud, turn it
        down"."""
        return self.begins(whole) and whole.actions == self.meaning.actions

    def says_more(self, whole: Interpretation) -> bool:
        """Whether it is the beginning of a longer sentence that means something else: "spin it" of "spin it for two
        minutes"."""
        return self.begins(whole) and whole.actions != self.meaning.actions

    def step_to(self, whole: Interpretation) -> Step | None:
        """What is to be done if this was the beginning of a longer command; None: it was not, or it is too late."""
        if not self.begins(whole):
            return None
        if whole.stops or (whole.corrected and not self.under_way):  # "no" had stopped it
            return Step(whole.actions, goes_on=True)
        if not self.under_way:
            return None
        done = self.meaning.actions
        if whole.actions[: len(done)] == done:
            more = whole.actions[len(done) :]
            return Step(more, Policy.FOLLOW, goes_on=True) if more else None
        first = self.goals[0]
        at_work = first.state is GoalState.EXECUTING
        if whole.corrected and (at_work or first.succeeded) and self._is_of_a_program:
            return Step(whole.actions, Policy.REPLACE, goes_on=True)  # as after a "no" alone, which stops it
        begun = at_work or (first.succeeded and not isinstance(first.action, Pick | Place))
        if not (begun and can_be_amended(self.meaning)):
            return None
        return Step(whole.actions, Policy.REPLACE, first, goes_on=True)

    @property
    def _is_of_a_program(self) -> bool:
        """Whether it is one action of a program, of which nothing is taken back when it is done."""
        return len(self.goals) == 1 and isinstance(self.goals[0].action, Custom)

    def grown_to(self, whole: Interpretation, goals: tuple[Goal, ...]) -> CarriedOut:
        """The longer command, when these goals have been given for what was to be done of it."""
        given = self.goals[: len(whole.actions) - len(goals)]
        return CarriedOut(whole, (*given, *goals))


def begun_alike(parse: Callable[[str], Interpretation], first: Interpretation, whole: Interpretation) -> Interpretation:
    """A longer command in the very words that were carried out, where it begins with others that mean the same: after
    "drive back", "drive backwards one meter".

    Args:
        parse: understands a text.
        first: what was carried out.
        whole: what was heard together with it.
    """
    words, begun = plain(whole.text), plain(first.text)
    if words[: len(begun)] == begun:
        return whole
    for place in range(len(words) - 1, 0, -1):
        if parse(" ".join(words[:place])).actions == first.actions:
            said_so = parse(" ".join((*begun, *words[place:])))
            if said_so.actions == whole.actions:
                return said_so
    return whole


def in_a_row(
    parse: Callable[[str], Interpretation], first: Interpretation, then: Interpretation
) -> Interpretation | None:
    """Two commands in one text, if that means just both.

    Args:
        parse: understands a text.
        first, then: the commands.
    """
    both = parse(f"{first.text}, {then.text}")
    return both if then.actions and both.actions == (*first.actions, *then.actions) else None


def can_be_amended(meaning: Interpretation) -> bool:
    """Whether what was understood can be put right while it is done: one drive, turn or way somewhere, or a hand that
    reaches for something, or for where that is to lie. What is let go of here, or ordered, cannot be taken back."""
    if len(meaning.actions) != 1:
        return False
    (action,) = meaning.actions
    if isinstance(action, Place):
        return action.location is not None
    return isinstance(action, Move | Turn | Navigate | Pick)
