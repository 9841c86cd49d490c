"""One of what is counted, said with its article: "a scoop of tea", where a grammar has "{n} scoops of tea"."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from intent_engine.language.loading.language_words import default_another
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.thing_words import thing_words

__all__ = ["is_one_of_it", "one_of_it"]

_ONE = "1"


def one_of_it(said: Utterance, language: str) -> Utterance | None:
    """An utterance with a number in the place of such articles: "1 scoop of tea"; None: there is none.

    In other languages than English the article is the number.
    """
    other = said
    for place in _places(said, language):
        other = other.with_other(place, place + 1, Utterance.in_one_breath([_ONE]))
    return other if other is not said else None


def is_one_of_it(said: Utterance, readings: Sequence[Reading], language: str) -> bool:
    """Whether each is all of a number, and what it counts follows: "drawer a" has a letter. A sentence that has such an
    article itself says without a number what is one ("make (a|{n}) {drink}")."""
    ones = 0
    for reading in readings:
        counted = {slot.start for slot in reading.slots if slot.slot.type == "number" and slot.end == slot.start + 1}
        said_so = [at for at, word in enumerate(reading.words) if word == _ONE]
        if said_so and not _articles(language).isdisjoint(words_in(reading.sentence.template)):
            return False
        if not counted.issuperset(said_so) or len(reading.words) - 1 in said_so:
            return False
        ones += len(said_so)
    return ones == len(_places(said, language)) + said.words.count(_ONE)


@cache
def _articles(language: str) -> frozenset[str]:
    """Those that are no number words themselves."""
    articles = {article for meant in default_another(language).values() for article in meant}
    return frozenset(article for article in articles if not is_number(article, language))


def _places(said: Utterance, language: str) -> list[int]:
    """Where such an article stands behind a verb, in one breath with a noun."""
    articles = _articles(language)
    known, words = thing_words(language), said.words
    no_noun = known.joining | known.binding | known.articles | known.alone
    return [
        at
        for at in range(1, len(words) - 1)
        if words[at] in articles
        and not said.breaks[at + 1]
        and words[at + 1] not in no_noun
        and not is_number(words[at + 1], language)
        and not is_number(words[at - 1], language)
    ]
