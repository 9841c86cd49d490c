"""Names of a list that share their noun: "raise the left and right armrest" is "raise the left armrest and the right
armrest", of a grammar that lists both."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import listed_words
from intent_engine.language.words.thing_words import thing_words

__all__ = ["SharedNouns"]

_NAMES = ("choice", "location")
_MOST = 4
"""Names that share one."""


class SharedNouns:
    """Reads such names with the noun behind each.

    Args:
        matcher: of the grammar whose they are. Where nouns stand before what tells which, nothing is read so.
        phrases: of the grammar.
    """

    def __init__(self, matcher: Matcher, phrases: Phrases) -> None:
        grammar = matcher.grammar
        places = (words for words, _ in matcher.locations.names()) if matcher.locations else ()
        self._named = listed_words(grammar).union(*places)
        known = thing_words(grammar.language)
        self._noun_last = bool(known.qualities)
        self._articles, self._endings = known.articles, known.plurals
        self._no_name = known.joining | known.binding | known.within | grammar.operators.closed
        self._language = grammar.language
        self._sequence = phrases.sequence

    def ways(self, core: Utterance, verbs: Sequence[str] | frozenset[str]) -> Iterator[tuple[Utterance, str]]:
        """With a noun behind each of two or more names, and that noun.

        Args:
            core: what was said.
            verbs: with which commands begin: "the lid and *close* the door" does something else.
        """
        words = core.words
        for at in range(2, len(words) - 2) if self._noun_last else ():
            length = self._sequence.at(words, at)
            last = at + length
            if words[last : last + 1] and words[last] in self._articles:
                last += 1  # "the left and the right armrest"
            if not length or last + 1 >= len(words) or any(core.breaks[at + 1 : last + 2]):
                continue
            first = self._first(core, at)
            names = [*words[first:at], words[last]]
            if any(self._is_none(name) or name in verbs for name in (*names, words[last + 1])):
                continue
            article = [words[first - 1]] if words[first - 1] in self._articles else []
            if last > at + length and words[last - 1 : last] != article:
                continue
            before = {one for word in words[:at] for one in self._ones(word)}
            for noun in (one for one in self._ones(words[last + 1]) if one in self._named - before):
                said = [word for name in names[:-1] for word in (*article, name, noun)][len(article) :]
                said += [*words[at : at + length], *article, names[-1], noun]
                yield core.with_other(first, last + 2, self._parted(said, [*article, names[0], noun], article)), noun

    def _ones(self, word: str) -> tuple[str, ...]:
        """A word, and the same for one of what it may name."""
        return (word, *(one for (one,) in singular((word,), self._endings)))

    def _parted(self, said: list[str], one: Sequence[str], article: Sequence[str]) -> Utterance:
        """The names with a pause between all but the last two."""
        breaks: list[bool | None] = [False] * len(said)
        for start in range(len(one) - len(article), len(said) - len(one) - 1, len(one)):
            breaks[start] = True
        return Utterance(said, breaks)

    def _first(self, core: Utterance, joint: int) -> int:
        """Where the first of the names before a joint stands: a pause is enough between two."""
        first = joint - 1
        while first > 1 and core.breaks[first] and joint - first < _MOST:
            first -= 1
        return first

    def _is_none(self, word: str) -> bool:
        return word in self._no_name or word in self._articles or is_number(word, self._language)

    def means(self, readings: Sequence[Reading], noun: str) -> bool:
        """Whether commands of one kind are about a thing of such a name each, and nothing else is said of one alone."""
        if len(readings) < 2 or any(one.intent is not readings[0].intent for one in readings):
            return False
        named = [_named(reading, noun) for reading in readings]
        return all(named) and len(set(named)) == 1


def _named(reading: Reading, noun: str) -> str:
    """The label of what is listed by a name that ends so; empty: nothing is."""
    return next(
        (
            slot.label
            for slot in reading.slots
            if slot.slot.type in _NAMES and slot.status == "exact" and reading.words[slot.end - 1] == noun
        ),
        "",
    )
