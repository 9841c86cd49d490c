"""One of several things that is told by a value before it, behind one that was named: "grab the green cube and then the
red *one*"."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, told_before
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["NounsOfValues"]

MAX_SPELLINGS = 64
"""Ways of saying one value that are looked at."""


class NounsOfValues:
    """Puts in the noun that stood behind another value of the same list in the command before.

    Args:
        grammar: whose sentences have such nouns.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        self._standing_for = grammar.wording.standing_for
        self._sequence = sequence
        self._lists: dict[str, set[str]] = {}
        """The lists of which a value, as it is said, ends in a word."""
        for slot in grammar.slots.values():
            for _, node in slot.values if slot.type == "choice" else ():
                for said in filter(None, spellings(node, grammar.phrases, MAX_SPELLINGS)):
                    self._lists.setdefault(said[-1], set()).add(slot.name)

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that noun; None: there is none, or more than one.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        words = core.words
        places = (at for at in range(2, len(words)) if words[at] in self._standing_for and words[at - 1] in self._lists)
        place = next(places, 0)
        before = told_before(core, place, self._sequence, as_said) if place else None
        nouns = set(_nouns(before, self._lists[words[place - 1]])) if before is not None else set()
        if len(nouns) != 1:
            return None
        return as_said(core.with_other(place, place + 1, Utterance.in_one_breath(nouns.pop())))


def _nouns(before: Understood, lists: set[str]) -> Iterator[tuple[str, ...]]:
    """What stands straight behind the values of some lists in commands: another value, or a word of the sentence."""
    for reading in (part.reading for part in before[1] if part.reading is not None):
        ends = {slot.start: slot.end for slot in reading.slots if slot.start < slot.end}
        for slot in reading.slots:
            if slot.slot.name in lists and slot.end < len(reading.words):
                yield tuple(reading.words[slot.end : ends.get(slot.end, slot.end + 1)])
