"""Sentences of a grammar in the words that were heard, where these mean the same.

Of "haul that waste rock over to the north dump" a model hears "hall that waystroke over to the north dump". The grammar
has "haul the waste rock to the north dump", and so unlike what was said that is hardly likely: "that" and "over" were
clearly there. With these in their places it is what the sound is compared with, if it means the same in writing.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence, Set
from typing import TYPE_CHECKING

from rapidfuzz.distance import Levenshtein

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.language.wording import Wording
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

__all__ = ["OtherWordings", "in_its_place", "in_words_heard", "small_words"]

BENEATH = 4
"""Sentences that are looked at without the small words that were heard."""
SMALL, ALONE, UNLIKE = 0.4, 0.8, 2.0
"""What it costs that a small word is another or missing, that another word is, and that a small one stands for another,
where two others cost the share of their letters by which they differ."""
STEPS = ((1, 1), (1, 0), (0, 1), (2, 1), (1, 2))
"""How many words of both may belong together."""
MOST_PLACES = 3
"""Places in which a sentence has other such words than were heard; who says it in more says something else."""


class OtherWordings:
    """Sentences of a grammar in other words than it has, for what may have been said.

    Args:
        grammar: whose sentences.
    """

    def __init__(self, grammar: SpokenGrammar) -> None:
        self._grammar = grammar

    def heard(self, words: Sequence[str], language: str | None = None) -> list[tuple[str, ...]]:
        """Sentences like the words heard but for small words, in those that were heard: "haul *that* rock"; and just
        what was heard, where it is one in other words: "I want the lamp turned on"."""
        found = [self._in_words(one, words, language) or one for one in self._beneath(words, language)]
        if self._in_other_words(words, language):
            found.append(tuple(words))
        return list(dict.fromkeys(found))

    def _beneath(self, words: Sequence[str], language: str | None) -> list[tuple[str, ...]]:
        """Sentences like the words heard without small ones. None where a sentence that is like all of them has each of
        the small ones in its place: it is looked for anyway."""
        beneath = self._grammar.without_small_words(words, language)
        if len(beneath) == len(words):
            return []
        nearest = self._grammar.like(tuple(words), language, wider=True)[:1]
        if nearest and not any(_places(nearest[0], words, self._grammar.small_words(language))):
            return []
        return self._grammar.like(beneath, language)[:BENEATH]

    def own(self, words: tuple[str, ...], language: str | None = None) -> tuple[str, ...]:
        """The sentence of the grammar that other words mean; the same where they are one, or none is."""
        if self._grammar.has(words, language):
            return words
        own = self._grammar.in_own_words(words, language)
        return own if own and self._grammar.has(own, language) else words

    def beside(
        self, sentence: tuple[str, ...], own: tuple[str, ...], words: tuple[str, ...], language: str | None = None
    ) -> tuple[str, ...]:
        """A sentence beside one of the grammar, in the other words in which this was said; itself, where there are no
        such."""
        put = in_its_place(sentence, own, words, lambda text: self._grammar.parse(text, language))
        return put or self._in_words(sentence, words, language) or sentence

    def _in_words(self, sentence: Sequence[str], heard: Sequence[str], language: str | None) -> tuple[str, ...]:
        small = self._grammar.small_words(language)
        return in_words_heard(sentence, heard, small, lambda text: self._grammar.parse(text, language))

    def _in_other_words(self, words: Sequence[str], language: str | None) -> bool:
        """Whether words are just one command of things that are listed, and the grammar has others for it."""
        if not words or self.own(tuple(words), language) == tuple(words):
            return False
        meaning = self._grammar.parse(" ".join(words), language)
        exact = meaning.status is Status.ACCEPTED and meaning.confidence == 1.0 and not meaning.stops
        return exact and not self._grammar.unlisted(meaning, language)


def small_words(wording: Wording, language: str) -> frozenset[str]:
    """Words that people put anywhere, and with which a sentence may be the same as without: "that", "by", "over"."""
    found = {*thing_words(language).articles, *wording.points, *wording.led_by, *wording.lasting, *wording.up_to}
    found.update(wording.sized, wording.ways_on, wording.back_into, wording.for_whom, wording.sizes, wording.how_often)
    for several in (wording.sizes, wording.levels, wording.idle_particles):
        found.update(*several.values())
    found.update(word for words in wording.wholes for word in words)
    ways = [way.split() for said in wording.sides for way in said.split("/")]
    found.update({word for way in ways for word in way} - {word for way in ways if len(way) == 1 for word in way})
    return frozenset(found)


def in_words_heard(
    sentence: Sequence[str],
    heard: Sequence[str],
    small: Set[str],
    parse: Callable[[str], Interpretation],
) -> tuple[str, ...]:
    """A sentence with the small words that were heard in the place of its own, as many of them as leave it what it is.
    Empty: there are none.

    Args:
        sentence: of a grammar.
        heard: the words that were heard, or another sentence.
        small: words that people put anywhere.
        parse: what a text means.
    """
    if any(isinstance(word, FreeWord) for word in sentence):
        return ()  # what may be any word is so without others around it
    places = list(_places(sentence, heard, small))
    if not 0 < len(places) <= MOST_PLACES:
        return ()
    meant = parse(" ".join(sentence)).actions

    def is_same(some: Sequence[tuple[int, int, tuple[str, ...]]]) -> bool:
        meaning = parse(" ".join(_with(sentence, some)))
        return meaning.status is Status.ACCEPTED and meaning.confidence == 1.0 and meaning.actions == meant

    if is_same(places):
        return _with(sentence, places)
    alone = [place for place in places if is_same([place])] if len(places) > 1 else []
    together = alone if len(alone) < 2 or is_same(alone) else alone[:1]
    return _with(sentence, together) if together else ()


def in_its_place(
    sentence: Sequence[str], own: Sequence[str], words: Sequence[str], parse: Callable[[str], Interpretation]
) -> tuple[str, ...]:
    """A sentence that differs from one in one place, put as this was said otherwise: of "turn the lamp off" beside
    "turn the lamp on", said as "I want the lamp turned on", it is "I want the lamp turned off". Empty: there is none.

    Args:
        sentence: of a grammar.
        own: another of it.
        words: in which that was said.
        parse: what a text means.
    """
    edits = [edit for edit in Levenshtein.opcodes(list(own), list(sentence)) if edit.tag != "equal"]
    if len(edits) != 1 or edits[0].tag != "replace":
        return ()
    (edit,) = edits
    old, new = list(own[edit.src_start : edit.src_end]), sentence[edit.dest_start : edit.dest_end]
    places = [at for at in range(len(words) - len(old) + 1) if list(words[at : at + len(old)]) == old]
    if len(places) != 1:
        return ()
    (at,) = places
    put = (*words[:at], *new, *words[at + len(old) :])
    return put if parse(" ".join(put)).actions == parse(" ".join(sentence)).actions else ()


def _places(
    sentence: Sequence[str], heard: Sequence[str], small: Set[str]
) -> Iterator[tuple[int, int, tuple[str, ...]]]:
    """Where a sentence has other small words than were heard, or none: where these begin and end, and what was
    heard."""
    start = end = 0
    said: list[str] = []
    for own, other in [*_aligned(sentence, heard, small), ((), ())]:
        end += len(own)
        if own != other and small >= {*own, *other}:
            said += other
            continue
        before = end - len(own)
        if start < before or said:
            yield start, before, tuple(said)
        start, said = end, []


def _aligned(
    sentence: Sequence[str], heard: Sequence[str], small: Set[str]
) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    """The words of a sentence beside the words heard that they seem to be, small words beside such alone, others also
    two beside one: "waste rock" beside "waystroke"."""

    def cost(own: tuple[str, ...], other: tuple[str, ...]) -> float:
        said = own + other
        if small.isdisjoint(said):
            return Levenshtein.normalized_distance("".join(own), "".join(other)) if own and other else ALONE
        return (SMALL if small >= {*said} else UNLIKE) * (own != other)

    best: dict[tuple[int, int], tuple[float, int, int]] = {(0, 0): (0.0, 0, 0)}
    for at, place in itertools.product(range(len(sentence) + 1), range(len(heard) + 1)):
        ways = []
        for own, other in STEPS:
            if at >= own and place >= other:
                step = cost(tuple(sentence[at - own : at]), tuple(heard[place - other : place]))
                ways.append((best[at - own, place - other][0] + step, own, other))
        if ways:
            best[at, place] = min(ways)
    found = []
    at, place = len(sentence), len(heard)
    while at or place:
        _, own, other = best[at, place]
        found.append((tuple(sentence[at - own : at]), tuple(heard[place - other : place])))
        at, place = at - own, place - other
    return found[::-1]


def _with(sentence: Sequence[str], places: Sequence[tuple[int, int, tuple[str, ...]]]) -> tuple[str, ...]:
    said = list(sentence)
    for start, end, words in reversed(places):
        said[start:end] = words
    return tuple(said)
