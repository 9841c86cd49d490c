"""A name of a list or a map that a later command of the same utterance points back to: "fly to tank 2 and photograph
*it*" is "... and photograph tank 2". What free words name is put in afterwards, by ``references``."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from intent_engine.interpretation import Status
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood
from intent_engine.language.phrase_set import PhraseSet
from intent_engine.language.thing_words import thing_words
from intent_engine.language.utterance import Utterance

__all__ = ["NamedBefore"]

_LISTED = ("choice", "location")


class NamedBefore:
    """Puts the one name that fits in the place of such a word.

    Args:
        grammar: whose pronouns they are.
        phrases: of it.
        meant: what an utterance means in a state of the robot, with the text that it was said in.
    """

    def __init__(
        self,
        grammar: Grammar,
        phrases: Phrases,
        meant: Callable[[str, Utterance, Collection[str]], Understood],
    ) -> None:
        known, several = thing_words(grammar.language), grammar.wording.several
        self._pronouns = PhraseSet(
            words
            for words in grammar.operators.pronoun
            if known.articles.isdisjoint(words) and " ".join(words) not in several
        )
        self._articles = [(), *((word,) for word in sorted(known.definite) if len(known.definite) == 1)]
        self._phrases = phrases
        self._meant = meant

    def ways(self, text: str, core: Utterance, state: Collection[str]) -> Iterator[list[Utterance]]:
        """For each thing that was named before the first such word all ways to write the utterance with its name."""
        found = self._pronouns.find(core.words)
        before = self._done_before(text, core, found[0], state) if found is not None else None
        if before is None:
            return
        names: dict[object, Sequence[str]] = {}
        for part in before[1]:
            for slot in part.reading.slots if part.reading is not None else ():
                if slot.slot.type in _LISTED and part.reading is not None:
                    names.setdefault(slot.value, part.reading.words[slot.start : slot.end])
        for name in names.values():
            yield [self._named(core, (*article, *name)) for article in self._articles]

    def _done_before(self, text: str, core: Utterance, place: int, state: Collection[str]) -> Understood | None:
        """What the commands mean that are whole before a place; None: there are none."""
        sequence = self._phrases.sequence
        for end in range(place - 1, 0, -1):
            if core.breaks[end] or sequence.at(core.words, end):
                found = self._meant(text, core.part(0, end), state)
                if found[0].status is Status.ACCEPTED:
                    return found
        return None

    def _named(self, core: Utterance, name: Sequence[str]) -> Utterance:
        said, place = core, 0
        while (found := self._pronouns.find(said.words, place)) is not None:
            at, length = found
            said = said.with_other(at, at + length, Utterance([*name], [False] * len(name)))
            place = at + len(name)
        return said
