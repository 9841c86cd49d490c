"""What was last understood, for words of the next utterance that point back to it: "again", "it"."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from intent_engine.actions import ChangeSpeed
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.references import Before
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.pronouns import names_something, things_of
from intent_engine.needs import Needs

__all__ = ["LastSaid"]


class LastSaid:
    """Keeps what was last carried out; whatever stops the robot leaves nothing to point back to. For one thread.

    Args:
        grammars: gives those that are loaded, which say what their slots hold.
    """

    def __init__(self, grammars: Callable[[], Iterable[Grammar]] = tuple) -> None:
        self._grammars = grammars
        self.meaning: Before = ()
        """For ``IntentEngine.parse(text, last=...)``; empty: there was nothing, or it is forgotten. Where the last
        utterance names nothing, the actions of the last one that did stand before its own: after "pick up the ball"
        and "go to the kitchen", "it" is the ball. Before a change of its speed stands the motion."""
        self._named: Interpretation | None = None
        """The last utterance with an action that names something."""

    def take(self, meaning: Interpretation) -> None:
        """An utterance is carried out. One that is not accepted, or does nothing, changes nothing."""
        if meaning.stops:
            self.forget()
        elif meaning.status is Status.ACCEPTED and meaning.actions:
            if isinstance(self.meaning, Interpretation) and _only_speed(meaning):
                if not _only_speed(self.meaning, last=True):
                    self.meaning = _together(self.meaning, meaning)
            elif self._names_something(meaning):
                self._named = meaning
                self.meaning = meaning
            else:
                self.meaning = meaning if self._named is None else _together(self._named, meaning)

    def _names_something(self, meaning: Interpretation) -> bool:
        things = frozenset[str]().union(*map(things_of, self._grammars()))
        return any(names_something(action, things) for action in meaning.actions)

    def forget(self) -> None:
        """The robot was stopped, or a new session begins."""
        self.meaning = ()
        self._named = None


def _only_speed(meaning: Interpretation, *, last: bool = False) -> bool:
    """Whether all it does, or the last thing, is to change the speed of what is being done."""
    return all(isinstance(action, ChangeSpeed) for action in meaning.actions[-1 if last else 0 :])


def _together(before: Interpretation, last: Interpretation) -> Interpretation:
    """The last utterance, with the actions of an earlier one before its own."""
    known = all(len(one.needs) == len(one.actions) for one in (before, last))
    needs: tuple[Needs, ...] = (*before.needs, *last.needs) if known else ()
    return replace(last, actions=(*before.actions, *last.actions), needs=needs)
