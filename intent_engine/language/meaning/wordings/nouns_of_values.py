"""One of several things that is told by a value before it, or by its place alone, behind one that was named: "grab the
green cube and then the red *one*", "close the first valve and open the *second*"."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, readings_of, told_before
from intent_engine.language.quantities import evaluate
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NounsOfValues"]

MAX_SPELLINGS = 64
"""Ways of saying one value that are looked at."""


class NounsOfValues:
    """Puts in the noun that stood behind another value of the same list, or another ordinal, in the command before.

    Args:
        grammar: whose sentences have such nouns.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        self._language = grammar.language
        self._articles = thing_words(grammar.language).articles
        self._standing_for = grammar.wording.standing_for
        self._sequence = sequence
        self._ordinals = {slot.name for slot in grammar.slots.values() if slot.type == "ordinal"}
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
        start, end, slots = next(self._places(core), (0, 0, ()))
        before = told_before(core, start - 1, self._sequence, as_said) if start else None
        nouns = set(_nouns(before, slots))
        if len(nouns) != 1:
            return None
        return as_said(core.with_other(start, end, Utterance.in_one_breath(nouns.pop())))

    def _places(self, core: Utterance) -> Iterator[tuple[int, int, Collection[str]]]:
        """Where a word stands for the noun behind a value, or an ordinal with its article ends it all: where the noun
        goes, and the slots of such values."""
        words = core.words
        for at in range(1, len(words)):
            last = at + 1 == len(words)
            stands = not last and words[at + 1] in self._standing_for
            if stands and words[at] in self._lists:
                yield at + 1, at + 2, self._lists[words[at]]
            elif (
                (stands or last) and self._ordinals and words[at - 1] in self._articles and self._is_ordinal(words[at])
            ):
                yield at + 1, at + 1 + stands, self._ordinals

    def _is_ordinal(self, word: str) -> bool:
        return evaluate([word], "ordinal", self._language) is not None


def _nouns(before: Understood | None, slots: Collection[str]) -> Iterator[tuple[str, ...]]:
    """What stands straight behind the values of some slots in commands: another value, or a word of the sentence."""
    for reading in readings_of(before):
        ends = {slot.start: slot.end for slot in reading.slots if slot.start < slot.end}
        for slot in reading.slots:
            if slot.slot.name in slots and slot.end < len(reading.words):
                yield tuple(reading.words[slot.end : ends.get(slot.end, slot.end + 1)])
