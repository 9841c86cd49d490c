"""A matcher that is slow and obvious: it writes out every way to say every sentence, and looks for the words there.

What the automaton does in one walk over shared states is done here without any sharing, so that the two can be
compared. It needs grammars whose sentences can be counted in thousands.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, permutations, product
from typing import Any

from intent_engine.language.grammar import Grammar, Slot
from intent_engine.language.networks.network import MOST_ARTICLES
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
)
from intent_engine.language.words.thing_words import ARTICLES, thing_words

MOST = 3_000
"""Ways to say one sentence that are still looked through."""


class TooManyWaysError(Exception):
    """This grammar is too large for us."""


@dataclass(frozen=True)
class Piece:
    """What one word of a way to say something may be."""

    word: str = ""
    """Exactly this word; empty: see the others."""
    numeral: bool = False
    """Any numeral."""
    free: bool = False
    """Any word that is not closed, or that is in ``allowed``."""
    article: bool = False
    """An article."""
    allowed: frozenset[str] = frozenset()
    never: frozenset[str] = frozenset()
    """Words that it is not, because nothing ends so."""

    def takes(self, word: str, closed: frozenset[str]) -> bool:
        if self.numeral:
            return word.lstrip("-").replace(".", "", 1).isdigit()
        if self.article:
            return word in ARTICLES
        if self.free:
            return word in self.allowed or (word not in closed and word not in self.never)
        return word == self.word


@dataclass(frozen=True)
class Hole:
    """A slot in a way to say something."""

    label: str
    start: int
    end: int
    value: Any
    """The value of a choice; None for text, whose value is its words."""


@dataclass(frozen=True)
class Way:
    """One way to say something."""

    pieces: tuple[Piece, ...] = ()
    holes: tuple[Hole, ...] = ()

    def then(self, other: Way) -> Way:
        shift = len(self.pieces)
        moved = tuple(Hole(hole.label, hole.start + shift, hole.end + shift, hole.value) for hole in other.holes)
        return Way(self.pieces + other.pieces, self.holes + moved)


Slots = tuple[tuple[str, int, int, Any], ...]
"""(label, first word, word after the last, value) of each slot, in the order said."""


class ReferenceMatcher:
    """Every way to say every sentence of a grammar.

    Raises:
        TooManyWaysError: there are too many.
    """

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._closed = grammar.operators.closed
        self.sentences: list[list[Way]] = []
        for intent in grammar.intents.values():
            for sentence in intent.sentences:
                ways = list(islice(self._ways(sentence.template), MOST + 1))
                if len(ways) > MOST:
                    raise TooManyWaysError
                self.sentences.append(ways)

    # -- what the automaton is asked ----------------------------------------------------------------------------

    def readings(self, words: list[str]) -> Mapping[int, set[Slots]]:
        """Number of each sentence that the words are, with every way to fill its slots."""
        found: dict[int, set[Slots]] = {}
        for number, ways in enumerate(self.sentences):
            for way in ways:
                if self._is(way, words) and _named_by_whole_numbers(way, words):
                    found.setdefault(number, set()).add(self._slots(way, words))
        return found

    def refused_for_a_number(self, words: list[str]) -> set[int]:
        """Number of each sentence that the words would be, but for a number in a name that is not whole."""
        return {
            number
            for number, ways in enumerate(self.sentences)
            if any(self._is(way, words) and not _named_by_whole_numbers(way, words) for way in ways)
        }

    def ends(self, words: list[str]) -> bool:
        """Whether the words are a sentence, whatever its numbers are."""
        return any(self._is(way, words) for ways in self.sentences for way in ways)

    def begins(self, words: list[str]) -> bool:
        """Whether any sentence begins with the words."""
        return any(self._begins(way, words) for ways in self.sentences for way in ways)

    def goes_on(self, words: list[str]) -> bool:
        """Whether any sentence begins with the words and has more."""
        return any(True for _ in self._onward(words))

    def next_words(self, words: list[str]) -> tuple[set[str], bool, bool]:
        """The words that may follow, whether a numeral may, and whether any word may."""
        pieces = set(self._onward(words))
        return (
            {piece.word for piece in pieces if piece.word},
            any(piece.numeral for piece in pieces),
            any(piece.free or piece.article for piece in pieces),
        )

    # -- how ----------------------------------------------------------------------------------------------------

    def _is(self, way: Way, words: list[str]) -> bool:
        return len(way.pieces) == len(words) and self._begins(way, words)

    def _begins(self, way: Way, words: list[str]) -> bool:
        return len(words) <= len(way.pieces) and all(
            piece.takes(word, self._closed) for piece, word in zip(way.pieces, words, strict=False)
        )

    def _onward(self, words: list[str]) -> Iterator[Piece]:
        for ways in self.sentences:
            for way in ways:
                if len(way.pieces) > len(words) and self._begins(way, words):
                    yield way.pieces[len(words)]

    def _slots(self, way: Way, words: list[str]) -> Slots:
        return tuple((hole.label, hole.start, hole.end, self._value(hole, words)) for hole in way.holes)

    def _value(self, hole: Hole, words: list[str]) -> Any:
        if hole.value is not None:
            return hole.value
        said = words[hole.start : hole.end]
        while len(said) > 1 and said[0] in ARTICLES:
            said = said[1:]
        return " ".join(said)

    def _ways(self, node: Node) -> Iterator[Way]:
        match node:
            case Word(text):
                yield Way((Piece(text),))
            case WordClass():
                yield Way((Piece(numeral=True),))
            case Choice(items):
                for item in items:
                    yield from self._ways(item)
            case Optional(item):
                yield Way()
                yield from self._ways(item)
            case Sequence(items):
                yield from self._joined(items)
            case AnyOrder(items):
                for order in permutations(items):
                    yield from self._joined(order)
            case Reference(name, label):
                slot = self._grammar.slots.get(name)
                if slot is None:
                    yield from self._ways(self._grammar.phrases[name])
                else:
                    yield from self._slot_ways(slot, label)

    def _joined(self, items: tuple[Node, ...]) -> Iterator[Way]:
        for parts in product(*(list(islice(self._ways(item), MOST + 1)) for item in items)):
            way = Way()
            for part in parts:
                way = way.then(part)
            yield way

    def _slot_ways(self, slot: Slot, label: str) -> Iterator[Way]:
        if slot.type == "text":
            for length in range(1, slot.max_words + 1):
                piece = Piece(free=True, allowed=slot.allow)
                never = thing_words("en").unfinished | (thing_words("en").alone if length == 1 else set())
                last = Piece(free=True, allowed=slot.allow, never=frozenset(never))
                name = (*((piece,) * (length - 1)), last)
                yield Way(name, (Hole(label, 0, length, None),))
                behind = (*name[:-1], Piece(free=True, allowed=slot.allow, never=thing_words("en").unfinished))
                for articles in range(1, MOST_ARTICLES + 1):
                    led = (Piece(article=True),) * articles + behind
                    yield Way(led, (Hole(label, 0, len(led), None),))
        for value, node in slot.values:
            for way in self._ways(node):
                yield Way(way.pieces, (Hole(label, 0, len(way.pieces), value),))


def _named_by_whole_numbers(way: Way, words: list[str]) -> bool:
    """Whether no number of a name is a part of one, or below zero."""
    return all(word.isdigit() for piece, word in zip(way.pieces, words, strict=True) if piece.numeral)
