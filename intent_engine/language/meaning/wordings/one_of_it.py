"""One of what is counted, said with its article: "a scoop of tea", where a grammar has "{n} scoops of tea"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from intent_engine.language.loading.language_words import default_another, default_counting
from intent_engine.language.meaning.command import Commands
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.slots.name_words import singular
from intent_engine.language.templates.plurals import Plurals
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary, words_in
from intent_engine.language.words.thing_words import thing_words

__all__ = ["OneOfIt"]

_ONE = "1"
_ANY_WORD = "qwxz"
_MOST_WORDS = 20
"""Words of an utterance that is looked at."""


class OneOfIt:
    """Reads such articles as numbers. In other languages than English they are number words themselves.

    Args:
        commands: of the grammar.
    """

    def __init__(self, commands: Commands) -> None:
        language = commands.matcher.grammar.language
        articles = {article for meant in default_another(language).values() for article in meant}
        self._articles = frozenset(article for article in articles if not is_number(article, language))
        known = thing_words(language)
        self._endings = known.plurals
        own = vocabulary(commands.matcher.grammar)
        self._ones = {one for word in own for (one,) in singular((word,), known.plurals)}
        counting = {word for words in default_counting(language) for word in words.split()}  # "a more photo"
        self._no_noun = known.joining | known.binding | known.articles | known.alone | counting
        self._commands = commands
        self._another = default_another(language)
        self.rules = ((self.told, self.is_meant), (self.once_more, self.is_one_more))
        """It as some of those in which numbers are written otherwise."""
        self._plurals = Plurals(commands.matcher.grammar, lambda: commands.first_words)

    def told(self, said: Utterance, language: str) -> Utterance | None:
        """An utterance with a number in the place of each: "1 scoop of tea"; None: there is none."""
        other = said
        for place in self._places(said, language):
            other = other.with_other(place, place + 1, Utterance.in_one_breath([_ONE]))
        return other if other is not said else None

    def is_meant(self, said: Utterance, readings: Sequence[Reading], language: str) -> bool:
        """Whether each is all of a number, and what it counts follows: "drawer a" has a letter. A sentence that has
        such an article itself says without a number what is one ("make (a|{n}) {drink}")."""
        ones = 0
        for reading in readings:
            counted = {
                slot.start for slot in reading.slots if slot.slot.type == "number" and slot.end == slot.start + 1
            }
            said_so = [at for at, word in enumerate(reading.words) if word == _ONE]
            if said_so and not self._articles.isdisjoint(words_in(reading.sentence.template)):
                return False
            if not counted.issuperset(said_so) or len(reading.words) - 1 in said_so:
                return False
            ones += len(said_so)
        return ones == len(self._places(said, language)) + said.words.count(_ONE)

    def _places(self, said: Utterance, language: str) -> list[int]:
        """Where such an article stands behind a verb, in one breath with a noun, and a number may stand."""
        words = said.words if len(said) <= _MOST_WORDS else []
        return [
            at
            for at in range(1, len(words) - 1)
            if words[at] in self._articles
            and not said.breaks[at + 1]
            and words[at + 1] not in self._no_noun
            and self._is_one(words[at + 1])
            and not is_number(words[at + 1], language)
            and not is_number(words[at - 1], language)
            and self._may_be_counted(words, at)
        ]

    def _is_one(self, noun: str) -> bool:
        """Whether a noun is not of several: what sounds like "a buttons" may be eight."""
        return noun in self._ones or not any(singular((noun,), self._endings))

    def _may_be_counted(self, words: Sequence[str], at: int) -> bool:
        """A quick look: whether a command may go on so with a number and what it counts, and not with any word."""
        prefix = self._commands.matcher.prefix
        verbs = [verb for verb in range(at) if words[verb] in self._commands.first_words]
        verbs = [verb for verb in verbs if prefix([*words[verb:at], _ANY_WORD])[1] is None]
        begun = ([*words[verb:at], _ONE, words[at + 1]] for verb in verbs)
        return any(prefix(way)[1] is not None for one in begun for way in self._ways(one))

    def _ways(self, begun: list[str]) -> Iterator[list[str]]:
        """What is counted as it was said, and as a grammar may have more of it, be it that it has a word for one."""
        yield begun
        more = self._plurals.counted(begun)
        known = self._plurals.otherwise(Utterance.in_one_breath(begun), known=True) if more is None else None
        yield from (way for way in (more, known.words if known is not None else None) if way is not None)

    def once_more(self, said: Utterance, language: str) -> Utterance | None:
        """An utterance with the article in the place of an "another", where a name of a list follows; None: it has
        none."""
        at = next((at for at in range(1, len(said) - 1) if said.words[at] in self._another), None)
        if at is None or said.breaks[at + 1] or len(said) > _MOST_WORDS:
            return None
        return said.with_other(at, at + 1, Utterance.in_one_breath([self._another[said.words[at]][0]]))

    def is_one_more(self, said: Utterance, readings: Sequence[Reading], language: str) -> bool:
        """Whether it stands before what a list names, and no place: of these there is one."""
        name = next((after for word, after in pairwise(said.words) if word in self._another), "")
        slots = [slot for one in readings for slot in one.slots if name in one.words[slot.start : slot.end]]
        free = any(reading.free_words for reading in readings)
        return bool(slots) and not free and all(slot.slot.type == "choice" for slot in slots)
