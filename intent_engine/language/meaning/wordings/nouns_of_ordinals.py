"""One of several things that is told by its place alone, behind one that was named: "close the first valve and open the
*second*"."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, told_before
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NounsOfOrdinals"]


class NounsOfOrdinals:
    """Puts in the noun that stood behind the ordinal of the command before.

    Args:
        grammar: whose sentences have such nouns.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        self._ordinals = any(slot.type == "ordinal" for slot in grammar.slots.values())
        self._language = grammar.language
        self._articles = thing_words(grammar.language).articles
        self._standing_for = grammar.wording.standing_for
        self._sequence = sequence

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that noun; None: there is none, or more than one.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        place = self._alone(core) if self._ordinals else 0
        if not place:
            return None
        before = told_before(core, place, self._sequence, as_said)
        nouns = set(_nouns(before)) if before is not None else set()
        if len(nouns) != 1:
            return None
        return as_said(core.with_other(place + 1, len(core), Utterance.in_one_breath([nouns.pop()])))

    def _alone(self, core: Utterance) -> int:
        """Where an ordinal stands at the end of all, behind its article; 0: there is none."""
        words = core.words
        place = len(words) - 1 - (words[-1] in self._standing_for)
        alone = (
            place > 1
            and evaluate([words[place]], "ordinal", self._language) is not None
            and words[place - 1] in self._articles
        )
        return place if alone else 0


def _nouns(before: Understood) -> Iterator[str]:
    """The words straight behind the ordinals of commands, that are no values themselves."""
    for reading in (part.reading for part in before[1] if part.reading is not None):
        held = {at for slot in reading.slots for at in range(slot.start, slot.end)}
        for slot in reading.slots:
            if slot.slot.type == "ordinal" and slot.end < len(reading.words) and slot.end not in held:
                yield reading.words[slot.end]
