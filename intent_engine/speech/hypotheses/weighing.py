"""What one or several models make of a sound, taken together: the sentences that it may have been, with other commands
beside the likeliest, of which none of them may have thought.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from typing import Any, Protocol

from intent_engine.speech.hypotheses.dictating import begin_of
from intent_engine.speech.hypotheses.left_out import begins_like, ends_unheard, goes_on
from intent_engine.speech.hypotheses.opinion import Opinion, Reading
from intent_engine.speech.hypotheses.ranking import ranked
from intent_engine.speech.hypotheses.said_and_heard import SaidAndHeard
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

__all__ = ["Each", "begun_otherwise", "beside_heard", "crossed", "doubted", "opposed_too"]

ROUNDS = 4
"""Times that other commands are looked for at most: again where another sentence is the likeliest then. With two "a
mocha" was found at last, and nobody looked for "an iced mocha"."""
MOST_CROSSED = 6
"""Sentences, likeliest first, of which the likeliest is crossed with the others."""
WORTH_DOUBT = 0.1
"""Confidence from which they are: of less nothing comes."""


class Each(Protocol):
    """As :class:`map`: asks one model after the other, or side by side."""

    def __call__(self, ask: Callable[[Opinion], Any], opinions: Iterable[Opinion], /) -> Iterable[Any]: ...


def doubted(
    grammar: SpokenGrammar, opinions: Sequence[Opinion], each: Each = map, *, far: bool = False
) -> list[Reading]:
    """The sentences that one of several models thought of, and commands that differ in one word from the likeliest, or
    in a wake word before it, with what all think of them, likeliest first.

    Args:
        grammar: whose sentences.
        opinions: of the same sound.
        each: asks the models.
        far: whether also with commands that differ in a few words. It takes a tenth of a second more.
    """
    sentences = list(dict.fromkeys(chain.from_iterable(one.sentences for one in opinions)))
    readings = _compared(grammar, sentences, opinions, each)
    for _ in range(ROUNDS):
        if not readings or readings[0].evidence.confidence < WORTH_DOUBT:
            break
        woken = grammar.woken(readings[0].words, opinions[0].transcript.language)
        beside = dict.fromkeys((*woken, *_beside(readings[0].words, opinions, each, far)))
        others = [words for words in beside if words not in sentences]
        if not others:
            break
        sentences += others
        readings = _compared(grammar, sentences, opinions, each)
    return readings


def begun_otherwise(
    grammar: SpokenGrammar, readings: Sequence[Reading], opinions: Sequence[Opinion], each: Each = map
) -> list[Reading]:
    """Sentences, likeliest first; where the likeliest leaves out what was heard before it, with such as mean the same
    and begin like that: "making a mocha" is no "a mocha", but it may be "make me a mocha".

    Args:
        grammar, opinions, each: as for :func:`doubted`.
        readings: what that gave.
    """
    best = readings[0].words if readings else ()
    left_out = beside_heard(grammar, best, opinions).begin_left_out()
    if not left_out:
        return list(readings)
    known = {one.words for one in readings}
    begun = dict.fromkeys(chain.from_iterable(each(lambda one: one.begun(best), opinions)))
    others = [words for words in begun if words not in known and begins_like(words, best, left_out)]
    return _compared(grammar, [*known, *others], opinions, each) if others else list(readings)


def crossed(
    grammar: SpokenGrammar, readings: Sequence[Reading], opinions: Sequence[Opinion], each: Each = map
) -> list[Reading]:
    """Sentences, likeliest first; where the likeliest leaves out what was heard before it or after it, with such as go
    over from it to another or the other way round, at a word that both have, and leave out nothing: "make me a mocha"
    and "a mocha with milk" are "make me a mocha with milk".

    Args:
        grammar, opinions, each: as for :func:`doubted`.
        readings: what that gave.
    """
    language = opinions[0].transcript.language
    if not readings or not beside_heard(grammar, readings[0].words, opinions).left_out():
        return list(readings)
    known = dict.fromkeys(one.words for one in readings)
    ways = (way for other in readings[1:MOST_CROSSED] for way in _crossings(readings[0].words, other.words))
    others = [
        words
        for words in dict.fromkeys(ways)
        if words not in known
        and grammar.possible(words, (), language)
        and not beside_heard(grammar, words, opinions).left_out()
    ]
    return _compared(grammar, [*known, *others], opinions, each) if others else list(readings)


def opposed_too(
    grammar: SpokenGrammar, readings: Sequence[Reading], opinions: Sequence[Opinion], each: Each = map
) -> list[Reading]:
    """Sentences, likeliest first; with such as do the opposite of the likeliest, where that would be done.

    Args:
        grammar, opinions, each: as for :func:`doubted`.
        readings: what that gave.
    """
    language = opinions[0].transcript.language
    if not readings or not grammar.acted_on(readings[0].evidence.confidence, language):
        return list(readings)
    known = dict.fromkeys(one.words for one in readings)
    heard = [one.heard for one in opinions]
    others = [words for words in grammar.opposing(readings[0].words, heard, language) if words not in known]
    return _compared(grammar, [*known, *others], opinions, each) if others else list(readings)


def beside_heard(grammar: SpokenGrammar, words: tuple[str, ...], opinions: Sequence[Opinion]) -> SaidAndHeard:
    """A sentence of a grammar beside what models heard.

    Args:
        grammar: whose sentence.
        words: of the sentence.
        opinions: of the same sound.
    """
    heard = [one.heard_beside(words) for one in opinions]
    texts = [one.transcript.free_text for one in opinions]
    return SaidAndHeard(grammar, words, heard, opinions[0].transcript.language, texts)


def _crossings(one: tuple[str, ...], other: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Two sentences, each with the end of the other from a word on that both have."""
    for place, word in enumerate(one):
        for at in (at for at, its in enumerate(other) if its == word):
            yield (*one[:place], *other[at:])
            yield (*other[:at], *one[place:])


def _compared(
    grammar: SpokenGrammar, sentences: Iterable[tuple[str, ...]], opinions: Sequence[Opinion], each: Each
) -> list[Reading]:
    heard = [one.heard for one in opinions if one.heard]
    several = len(opinions) > 1  # one alone may have stopped short, which its search of the grammar makes up for
    said = [
        words
        for words in sentences
        if not (goes_on(words, heard) or (several and not begin_of(words) and ends_unheard(words, heard)))
    ]
    said = grammar.taking_back(said, heard, opinions[0].transcript.language)
    if not said:
        return []
    views = zip(*each(lambda one: one.views(said), opinions), strict=True)
    return ranked(grammar, dict(zip(said, views, strict=True)), opinions[0].transcript.language)


def _beside(best: tuple[str, ...], opinions: Sequence[Opinion], each: Each, far: bool) -> Iterable[tuple[str, ...]]:
    return chain.from_iterable(each(lambda one: one.beside(best, far=far), opinions))
