"""What a ``regex:`` or ``lark:`` pattern may be said as: a tree of letters, before it is known where words begin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

__all__ = [
    "DIGITS",
    "LETTERS",
    "Letters",
    "Named",
    "Number",
    "OneOf",
    "Part",
    "Repeat",
    "Row",
    "Text",
    "UnsayableError",
    "Words",
    "leaves_open",
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
class Letters:
    """Any one letter."""

    letters: frozenset[str]
    """Of these."""

    @property
    def many(self) -> bool:
        """Whether they are too many to be tried one by one: then they are as good as any word."""
        return len(self.letters) > MOST_CHOICES


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


Part: TypeAlias = Text | Letters | Number | Words | Named | Row | OneOf | Repeat


def walk(part: Part) -> Iterator[Part]:
    """A part and all that it is made of."""
    yield part
    if isinstance(part, Row | OneOf):
        for inner in part.parts:
            yield from walk(inner)
    elif isinstance(part, Named | Repeat):
        yield from walk(part.part)


def leaves_open(part: Part) -> bool:
    """Whether any words may stand somewhere in a part."""
    return any(isinstance(one, Words) or (isinstance(one, Letters) and one.many) for one in walk(part))


def repeated(part: Part, least: int, most: int | None) -> Part:
    """A part several times; of several letters any number, word, or words.

    Args:
        part: the part.
        least: how often.
        most: how often; None: as often as one likes.

    Raises:
        UnsayableError: it is too often to be tried.
    """
    letters = _alphabet(part)
    found: Part
    if letters == frozenset(" "):
        found = Text(" ")  # what is heard has one between two words
    elif most == 1 or letters is None or len(letters) == 1:
        return _times(part, least, most)
    elif letters & DIGITS and letters <= DIGITS | frozenset(".,"):
        found = Number()
    elif most is None or most > MOST_TIMES:
        several = " " in letters
        space = (Repeat(Text(" "), 0, 1),) if several else ()  # of ".*forward" the space is one of these letters
        found = Row((*space, Words(single=not several), *space))
    else:
        return _times(part, least, most)
    return found if least else Repeat(found, 0, 1)


def _times(part: Part, least: int, most: int | None) -> Part:
    if most is not None and most > MOST_TIMES:
        raise UnsayableError(f"{most} times the same")
    return Repeat(part, least, most)


def _alphabet(part: Part) -> frozenset[str] | None:
    """The letters of which a part is any one: "[0-9]", "(?:a|[b-d])"; None: it is more."""
    match part:
        case Letters(letters):
            return letters
        case Text(letters) if len(letters) == 1:
            return frozenset(letters)
        case OneOf(parts):
            found = [_alphabet(one) for one in parts]
            return frozenset().union(*filter(None, found)) if None not in found else None
    return None
