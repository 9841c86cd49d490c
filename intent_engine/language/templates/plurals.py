"""One thing and more of it: "one tip" where a grammar has "{count} tips", "two point five bars" where it has "bar", and
"beers" where a list has "beer". Whoever writes a grammar writes one of them, and people say the other.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cached_property

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.loading.language_words import default_another
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import listed_words
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Plurals"]

LEAST_LETTERS = 3
"""Of a word that may be one of something, or more of it: "as" is no more of "a"."""


class Plurals:
    """Words of a grammar by how many they name. Thread-safe: at worst it is looked up twice.

    Args:
        grammar: whose words.
        first_words: tells the words with which its commands begin: "lifts" tells what somebody does, and is no more of
            "lift". Asked only where something is not understood.
    """

    def __init__(self, grammar: Grammar, first_words: Callable[[], Collection[str]]) -> None:
        self._grammar = grammar
        self._first_words = first_words

    def counted(self, words: Sequence[str]) -> list[str] | None:
        """The same words with those beside numbers, as :meth:`otherwise` has them; None: they are the same."""
        if self._grammar.language != "en" or not any(is_number(word, "en") for word in words):
            return None
        counted = [self._counted(words, place) if self._is_strange(word) else word for place, word in enumerate(words)]
        return counted if counted != [*words] else None

    def _counted(self, words: Sequence[str], place: int) -> str:
        beside = any(
            is_number(word, "en") for word in (*words[max(place - 2, 0) : place], *words[place + 1 : place + 2])
        )
        return next(self._ways(words[place], counted=True), words[place]) if beside else words[place]

    def otherwise(self, said: Utterance, *, known: bool = False, owners: Collection[str] = ()) -> Utterance | None:
        """The same utterance with the words that the grammar has for one or more of the same; None: it is the same, or
        no English.

        A word that the grammar does not have changes: one beside a number into one or into more, and one anywhere into
        one of what a list names.

        Args:
            said: the utterance.
            known: whether one of something becomes more behind a number though the grammar has a word for one: "take
                one more photo" of "take {n} more photos" and "take a photo". Never the other way, or there is no end.
            owners: words that tell whose something is, and name no more than one: "tell *Anna's* son".
        """
        if self._grammar.language != "en":
            return None
        words = list(said.words)
        for place, word in enumerate(words):
            behind = any(is_number(other, "en") for other in words[max(place - 2, 0) : place])  # "one fresh tip"
            before = any(is_number(other, "en") for other in words[place + 1 : place + 2])
            if before and not behind and self._names_several(words, place + 1):
                continue
            if place and words[place - 1] in self._of_one and any(singular((word,))):
                continue  # "a beers" may be eight
            if self._is_strange(word) and (behind or word not in owners):
                words[place] = next(self._ways(word, counted=behind or before), word)
            elif known and behind and word not in self._first_words():
                words[place] = next(iter(self._more.get(word, ())), word)
        return Utterance(words, list(said.breaks)) if words != said.words else None

    def _names_several(self, words: Sequence[str], start: int) -> bool:
        """Whether numbers are said that are not one: "totes 14, 15" are two, and no tote 1415 of a slot that is said
        digit by digit."""
        language = self._grammar.language
        end = next((at for at in range(start, len(words)) if not is_number(words[at], language)), len(words))
        return end > start + 1 and evaluate(words[start:end], "number", language) is None

    def one_of_each(self, said: Utterance) -> Utterance | None:
        """The same utterance with every strange word for more of something as the word of the grammar for one: "the
        *lamps* in the kitchen and the hall", and any such word before a number: "tables 4 and 5" of a grammar that has
        "all tables" too. Only where commands come of it that do it for each of several."""
        language, closed = self._grammar.language, self._grammar.operators.closed
        words = list(said.words)
        for place, (before, word, after) in enumerate(zip(("", *words), said.words, (*words[1:], ""), strict=False)):
            named = place > 0 and before not in closed and is_number(after, language)  # "and *lifts* 3 boxes" tells
            if named or self._is_strange(word):
                words[place] = self._one_of(word, named=named)
        return Utterance(words, list(said.breaks)) if words != said.words else None

    def _one_of(self, word: str, *, named: bool) -> str:
        endings = thing_words(self._grammar.language).plurals
        ones = (one for (one,) in singular((word,), endings) if one in self._words and len(one) >= LEAST_LETTERS)
        return next((one for one in ones if named or one not in self._first_words()), word)

    def changes_free_words(self, said: Utterance, other: Utterance, readings: Sequence[Reading]) -> bool:
        """Whether a name in free words would not be what was said: of "boxes" there are more than of "box"."""
        changed = set(other.words).difference(said.words)
        return any(
            not changed.isdisjoint(reading.words[slot.start : slot.end])
            for reading in readings
            for slot in reading.slots
            if slot.slot.type in FREE_KINDS
        )

    def _is_strange(self, word: str) -> bool:
        known = word in self._words or word in self._grammar.operators.closed
        known = known or is_number(word, self._grammar.language)
        return word.isalpha() and len(word) >= LEAST_LETTERS and not known

    def _ways(self, word: str, *, counted: bool) -> Iterator[str]:
        """The words of the grammar that a word may stand for, likely ones first."""
        own = self._words if counted else self._listed
        ways = [one for (one,) in singular((word,))]
        if counted:
            ways += self._more.get(word, ())
        yield from (one for one in ways if one in own and one not in self._first_words() and len(one) >= LEAST_LETTERS)

    @cached_property
    def _of_one(self) -> frozenset[str]:
        return frozenset(one for meant in default_another(self._grammar.language).values() for one in meant)

    @cached_property
    def _words(self) -> frozenset[str]:
        return own_words(self._grammar)

    @cached_property
    def _listed(self) -> frozenset[str]:
        """Words of the values of lists."""
        return listed_words(self._grammar)

    @cached_property
    def _more(self) -> dict[str, list[str]]:
        """By one of something: the words that the grammar has for more of it."""
        found: dict[str, list[str]] = {}
        for word in sorted(self._words):
            for (one,) in singular((word,)):
                found.setdefault(one, []).append(word)
        return found
