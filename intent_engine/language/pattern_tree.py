"""What a ``regex:`` or ``lark:`` pattern may be said as: a tree of letters, before it is known where words begin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

__all__ = [
    "DIGITS",
    "LETTERS",
    "Named",
    "Number",
    "OneOf",
    "Part",
    "Repeat",
    "Row",
    "Text",
    "UnsayableError",
    "Words",
    "of_letters",
    "repeated",
    "walk",
]

LETTERS = frozenset("abcdefghijklmnopqrstuvwxyz")
DIGITS = frozenset("0123456789")
MOST_CHOICES = 36
"""Letters of a class that are tried one by one: ``[a-z]``, and digits."""
MOST_TIMES = 4
"""Times that a part is repeated where its pattern says how often."""


class UnsayableError(ValueError):
    """A pattern of which nobody knows how it is said."""


@dataclass(frozen=True, slots=True)
class Text:
    letters: str
    """As they are said, a space between two words."""


@dataclass(frozen=True, slots=True)
class Number:
    """Any number."""


@dataclass(frozen=True, slots=True)
class Words:
    """Anything."""

    single: bool
    """One word of it."""


@dataclass(frozen=True, slots=True)
class Named:
    name: str
    """Of a slot."""
    part: Part


@dataclass(frozen=True, slots=True)
class Row:
    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class OneOf:
    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class Repeat:
    part: Part
    least: int
    most: int | None
    """None: as often as one likes."""


Part: TypeAlias = Text | Number | Words | Named | Row | OneOf | Repeat


def walk(part: Part) -> Iterator[Part]:
    """A part and all that it is made of."""
    yield part
    if isinstance(part, Row | OneOf):
        for inner in part.parts:
            yield from walk(inner)
    elif isinstance(part, Named | Repeat):
        yield from walk(part.part)


def of_letters(letters: frozenset[str]) -> Part:
    """Any one of some letters; of very many, any word."""
    if len(letters) > MOST_CHOICES:
        return Words(single=True)
    return OneOf(tuple(map(Text, sorted(letters))))


def repeated(part: Part, least: int, most: int | None, letters: frozenset[str] | None = None) -> Part:
    """A part several times.

    Args:
        part: the part; any, if letters are given.
        least, most: how often; ``most`` None: as often as one likes.
        letters: if it is any one of these. Many letters are a number, a word, or several.
    """
    found: Part
    if part == Text(" ") or letters == frozenset(" "):
        found = Text(" ")  # what is heard has one between two words
    elif letters is not None and letters & DIGITS and letters <= DIGITS | frozenset(".,"):
        found = Number()
    elif letters is not None and (most is None or most > MOST_TIMES):
        several = " " in letters
        space = (Repeat(Text(" "), 0, 1),) if several else ()  # of ".*forward" the space is one of these letters
        found = Row((*space, Words(single=not several), *space))
    else:
        if most is not None and most > MOST_TIMES:
            raise UnsayableError(f"{most} times the same")
        return Repeat(part if letters is None else of_letters(letters), least, most)
    return found if least else OneOf((found, Text("")))
