"""One of several things that are told by a number, said without its noun behind one that was named: "baja la bici 4 y
sube *la 5*", "démarre la machine deux et *la trois*", "starte Presse 3 und stoppe *die 4*"."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.told import Understood, readings_of, told_before
from intent_engine.language.numbers.foreign import numbers_at
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["NounsOfNumbers"]

_OF_A_VERB = 2
"""Words of a verb between what joins and the article: "et fais tourner la trois"."""

_MOST_WORDS = 24
"""Words of an utterance that is looked at."""


class NounsOfNumbers:
    """Puts in the noun before another number of the command before. In English "the 4" is no thing.

    Args:
        grammar: whose sentences have such nouns.
        sequence: its words between commands.
    """

    def __init__(self, grammar: Grammar, sequence: PhraseSet) -> None:
        known, wording = thing_words(grammar.language), grammar.wording
        numbered = any(slot.type == "number" and not slot.units for slot in grammar.slots.values())
        self._articles = known.articles if numbered and grammar.language != "en" else frozenset[str]()
        self._no_noun = known.joining | known.binding | known.articles | known.alone
        self._follows = wording.leads | {words[0] for words in wording.besides}
        self._sequence = sequence
        self._language = grammar.language

    def put_in(self, core: Utterance, as_said: Callable[[Utterance], Understood | None]) -> Understood | None:
        """The meaning of an utterance with that noun; None: there is none, or more than one.

        Args:
            core: what was said.
            as_said: what an utterance means that takes its place; None: it is no command.
        """
        at = next(self._places(core), 0) if len(core) <= _MOST_WORDS else 0
        before = told_before(core, at, self._sequence, as_said) if at else None
        nouns = set(self._nouns(before, core.words[at - 1]))
        if len(nouns) != 1:
            return None
        noun = nouns.pop()
        ways = ([core.words[at - 1], noun], [noun])
        said = (as_said(core.with_other(at - 1, at, Utterance.in_one_breath(way))) for way in ways)
        return next(filter(None, said), None)

    def _places(self, core: Utterance) -> Iterator[int]:
        """Where a number stands behind its article, with nothing that it counts, and what joins or a verb before it:
        "y a la una" says when."""
        words, breaks = core.words, core.breaks
        for at in (at for at in range(3, len(words)) if self._articles and words[at - 1] in self._articles):
            _, end = next(numbers_at(words, at, self._language), (0.0, at))
            bare = end == len(words) or breaks[end] or words[end] in self._follows or self._sequence.at(words, end)
            begins = range(max(2, at - 1 - _OF_A_VERB), at)
            joined = any(breaks[begin] or self._sequence.ends(words[:begin]) for begin in begins)
            if end > at and bare and joined and not any(breaks[at:end]):
                yield at

    def _nouns(self, before: Understood | None, article: str) -> Iterator[str]:
        """The nouns before numbers in commands, each with the same article or with none."""
        for reading in readings_of(before):
            held = {at for slot in reading.slots for at in range(slot.start, slot.end)}
            for slot in (one for one in reading.slots if one.slot.type == "number" and not one.slot.units):
                noun = slot.start - 1
                if noun < 1 or noun in held or reading.words[noun] in self._no_noun:
                    continue
                if reading.words[noun - 1] == article or reading.words[noun - 1] not in self._articles:
                    yield reading.words[noun]
