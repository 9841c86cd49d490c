"""Patterns to sentences: random ones that ``regex:`` and ``lark:`` fit, with what their slots hold.

What is known of a pattern may be more than it fits (:mod:`~intent_engine.language.pattern.spoken_patterns`), so each
sentence is shown to the pattern itself, and left out where that does not fit it or fills its slots with other words.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from intent_engine.language.grammar import Grammar, Intent, Sentence, Slot
from intent_engine.language.normalize import words_of
from intent_engine.language.pattern.pattern_tree import (
    Letters,
    Named,
    Number,
    OneOf,
    Part,
    Repeat,
    Row,
    Text,
    Words,
    leaves_open,
)
from intent_engine.language.pattern.patterns import Patterns, parts_of_patterns
from intent_engine.language.sampling.drawing import Choices, Piece, RandomChoices, one, pick
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.slot_values import SlotValues

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["PatternSampler"]

MORE_TIMES = 2
"""Times that a part is repeated besides, where its pattern does not say how often."""
NUMBERS = 20
"""Largest number that is said where no slot has a limit."""
TRIED = 20
"""Sentences of a pattern that are looked at for one that is heard as it is written."""
ANY_WORDS = ("blick", "dax", "wug", "zorp")
"""Where a pattern takes any words, and no slot."""


@dataclass(frozen=True, slots=True)
class _Said:
    """Letters that stand next to each other."""

    text: str
    slot: Slot | None = None
    value: Any = None


class PatternSampler:
    """Draws sentences of the patterns of one grammar.

    Args:
        grammar: which was checked.
        locations: the map whose names are said.
        spoken: a value for a slot that a pattern leaves open, with words for it.
    """

    def __init__(
        self, grammar: Grammar, locations: LocationMap | None, spoken: Callable[[Slot, str, Choices], Piece]
    ) -> None:
        self._grammar = grammar
        self._locations = locations
        self._spoken = spoken

    @cached_property
    def _parts(self) -> Mapping[int, tuple[Intent, Sentence, Part]]:
        return {id(sentence): (intent, sentence, part) for intent, sentence, part in parts_of_patterns(self._grammar)}

    @cached_property
    def _patterns(self) -> Patterns:
        return Patterns(self._grammar)

    @cached_property
    def _values(self) -> SlotValues:
        return SlotValues(self._grammar, self._locations, FreeText(self._grammar))

    def sentences(self, intent: str) -> Iterator[Sentence]:
        """The patterns of an intent of which it can be told how they are said."""
        return (sentence for owner, sentence, _ in self._parts.values() if owner.name == intent)

    def has(self, sentence: Sentence) -> bool:
        """Whether a sentence is such a pattern."""
        return id(sentence) in self._parts

    def drawn(self, sentence: Sentence, choices: Choices) -> list[Piece] | None:
        """A sentence of a pattern, in pieces; None if what was drawn is none, or a slot does not take what it holds."""
        pieces = self.fitting(sentence, choices)
        if pieces is None or any(piece.slot is not None and piece.value is None for piece in pieces):
            return None
        return pieces

    def fitting(self, sentence: Sentence, choices: Choices) -> list[Piece] | None:
        """The same, whatever its slots take."""
        pieces = self._fitting(sentence, choices)
        return pieces if pieces is not None and _as_heard(pieces) == _text(pieces) else None

    def never_heard(self, sentence: Sentence) -> tuple[str, str] | None:
        """What a pattern fits, and as what that is heard, which it does not fit; None: it is heard so, or that cannot
        be told. "bay12" is heard as two words."""
        drawn = [self._fitting(sentence, RandomChoices(seed)) for seed in range(TRIED)]
        ways = [(_text(pieces), _as_heard(pieces)) for pieces in drawn if pieces is not None]
        return ways[0] if ways and all(text != heard for text, heard in ways) else None

    def _fitting(self, sentence: Sentence, choices: Choices) -> list[Piece] | None:
        """The same, also where it would be heard in other words."""
        intent, _, part = self._parts[id(sentence)]
        pieces = _pieces(list(self._letters(part, choices, None)))
        return pieces if pieces is not None and self._takes(intent, pieces) else None

    def takes(self, sentence: Sentence, pieces: Sequence[Piece]) -> bool:
        """Whether a pattern fits some pieces, each of its slots what is said for it."""
        return self._takes(self._parts[id(sentence)][0], pieces)

    def _takes(self, intent: Intent, pieces: Sequence[Piece]) -> bool:
        held = {piece.label: piece.text for piece in pieces if piece.label is not None}
        return held in self._patterns.held(intent.name, _text(pieces))

    def _letters(self, part: Part, choices: Choices, slot: Slot | None) -> Iterator[_Said]:
        """What a part is said as, within a slot or none."""
        match part:
            case Text(letters):
                yield _Said(letters)
            case Letters() if part.many:
                yield _Said(pick(choices, ANY_WORDS))
            case Letters(letters):
                yield _Said(pick(choices, sorted(letters)))
            case Number():
                least, most = _limits(slot)
                yield _Said(str(least + one(choices, most - least + 1)))
            case Words():
                yield _Said(pick(choices, ANY_WORDS))
            case Row(parts):
                for inner in parts:
                    yield from self._letters(inner, choices, slot)
            case OneOf(parts):
                yield from self._letters(pick(choices, sorted(parts, key=_least)), choices, slot)
            case Repeat(inner, least, most):
                for _ in range(least + one(choices, (least + MORE_TIMES if most is None else most) - least + 1)):
                    yield from self._letters(inner, choices, slot)
            case Named(name, inner):
                own = self._grammar.slots.get(name)
                if own is None:
                    yield from self._letters(inner, choices, slot)
                else:
                    yield self._held(own, inner, choices)

    def _held(self, slot: Slot, part: Part, choices: Choices) -> _Said:
        """What is said for a slot. Without a value where the pattern spells out what the slot does not take."""
        if leaves_open(part):
            piece = self._spoken(slot, slot.name, choices)
            return _Said(piece.text, slot, piece.value)
        text = "".join(said.text for said in self._letters(part, choices, slot)).strip()
        if not text:
            return _Said("", slot)
        held = self._values.from_words(slot, slot.name, text.split())
        return _Said(text, slot, held.value if held.status == "exact" and not held.problem else None)


def _text(pieces: Sequence[Piece]) -> str:
    return " ".join(piece.text for piece in pieces)


def _as_heard(pieces: Sequence[Piece]) -> str:
    """The same with the words of the pattern as they are heard: what a slot holds is said in many ways."""
    words = (words_of(piece.text) if piece.slot is None else (piece.text,) for piece in pieces)
    return " ".join(word for heard in words for word in heard)


def _limits(slot: Slot | None) -> tuple[int, int]:
    """Whole numbers that a slot takes."""
    if slot is None or slot.type not in ("number", "ordinal"):
        return 1, NUMBERS
    least = max(0, math.ceil(slot.minimum)) if slot.minimum is not None else 1
    most = math.floor(slot.maximum) if slot.maximum is not None else max(least, NUMBERS)
    return least, max(least, most)


def _least(part: Part) -> int:
    """Letters of the shortest way to say a part."""
    match part:
        case Text(letters):
            return len(letters)
        case Row(parts):
            return sum(map(_least, parts))
        case OneOf(parts):
            return min(map(_least, parts))
        case Repeat(inner, least, _):
            return least * _least(inner)
        case Named(_, inner):
            return _least(inner)
    return 1


def _pieces(said: Sequence[_Said]) -> list[Piece] | None:
    """Letters in words; what was said for a slot is one piece. None where a slot ends within a word."""
    text = "".join(part.text for part in said)
    if not text.strip() or text.strip() != " ".join(text.split()):
        return None
    pieces: list[Piece] = []
    at, word = 0, ""
    for part in said:
        end = at + len(part.text)
        if part.slot is None:
            word += part.text
        else:
            if (text[:at].strip() and text[at - 1] != " ") or text[end : end + 1].strip() or not part.text.strip():
                return None
            pieces += map(Piece, word.split())
            word = ""
            pieces.append(Piece(part.text.strip(), part.slot.name, part.slot, part.value))
        at = end
    return [*pieces, *map(Piece, word.split())]
