"""A hyphen before a number that may be its sign: the one of "Z-5" and of "x - 10", and the one of "bay-3"."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from enum import Enum

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.meaning.told import Understood
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.thing_words import thing_words

__all__ = ["HyphenOrMinus"]

_MOST = 12
"""So many may be in a command."""
_MINUS = "−"
_SIGNS = frozenset("-−‐‑‒–")
_HYPHENS = re.compile(
    r"(?:(?<=[^\W\d_])[-−‐‑‒–]"
    r"|(?<=[^\W_]),[-−‐‑‒–]"
    r"|(?<=[^\W\d_])\s+[-‐‑‒–]\s+"
    r"|[=:(]\s*[-‐‑‒–]\s+)(?=\.?\d)"
)
"""Those that stand between a word and a number, or in a list of numbers: "z-5", "10,-5", "z - 5", "z = - 5". Others are
what they seem: "z -5" has a sign, "3-5" none."""
_NUMBER = re.compile(r"[\d.,]*\d")
_LAST_WORD = re.compile(r"[^\W_]+$")


class _Read(Enum):
    SIGN = "sign"
    HYPHEN = "hyphen"
    EITHER = "either"


class HyphenOrMinus:
    """Says which such hyphens are signs.

    They are where the number may be below zero and a letter, a preposition or a sign stands before it: "z-5 mm", "by -
    5 mm", "10,-5". They are none where no number of that slot is below zero ("bay-3"), and between two values ("turn
    left - 90 degrees"). Of others nobody knows.
    """

    def __init__(self, grammar: Grammar) -> None:
        words = thing_words(grammar.language)
        self._leading = words.joining
        self._articles = words.articles
        self._taking_back = {phrase[-1] for phrase in grammar.operators.correction}
        self._below_zero = any(
            slot.type in QUANTITY_KINDS and (slot.smallest is None or slot.smallest < 0)
            for slot in grammar.slots.values()
        )

    def may_stand_in(self, text: str) -> bool:
        """Whether there is such a hyphen, and a number that it may make one below zero."""
        return self._below_zero and not _SIGNS.isdisjoint(text) and _HYPHENS.search(text) is not None

    def understood(self, text: str, meant: Callable[[str], Understood]) -> Understood:
        """What a text means with its signs as such.

        Args:
            text: what was said or typed.
            meant: what a text means, its hyphens taken for hyphens.
        """
        found = meant(text)
        if found[0].stops:
            return found
        signed, begin, count = text, 0, 0
        while (hyphen := _HYPHENS.search(signed, begin)) is not None:
            begin, count = hyphen.end(), count + 1
            other = _with_sign(signed, hyphen)
            otherwise = meant(other)
            before = _LAST_WORD.search(signed, 0, hyphen.start())
            word = before[0].casefold() if before is not None else ""
            read = self._read(hyphen[0], word, found, otherwise) if count <= _MOST else _Read.EITHER
            if read is _Read.EITHER:
                number = _NUMBER.match(signed, begin)
                return _either(text, f"{hyphen[0].strip()}{number[0]}" if number is not None else hyphen[0])
            if read is _Read.SIGN:
                begin += len(other) - len(signed)
                signed, found = other, otherwise
        return replace(found[0], text=text), found[1]

    def _read(self, hyphen: str, before: str, found: Understood, otherwise: Understood) -> _Read:
        """What a hyphen behind a word is of which it is known what the text means without a sign there and with one."""
        if otherwise[0].status is not Status.ACCEPTED:
            return _Read.HYPHEN
        known, below = _below_zero(found), _below_zero(otherwise)
        more = [below[place] for place in below if place not in known]
        if len(below) == len(known):
            return _Read.HYPHEN
        return self._of_slot(hyphen, before, *more[0]) if len(more) == 1 else _Read.EITHER

    def _of_slot(self, hyphen: str, before: str, reading: Reading, slot: SlotReading) -> _Read:
        if _MINUS in hyphen or any(sign in hyphen for sign in ",=("):
            return _Read.SIGN  # no name is written so, and no pause
        word = reading.words[slot.start - 1] if slot.start else ""
        if word != before and hyphen != hyphen.strip() and before in self._taking_back:
            return _Read.HYPHEN  # "at 10 - no - 20 degrees"
        led = (len(word) == 1 or word in self._leading) and word not in self._articles
        # A number without a `min` may be the one of a name.
        pointing = slot.slot.type != "number" or slot.slot.minimum is not None
        valued = any(other.end == slot.start for other in reading.slots)
        if pointing and led:
            return _Read.SIGN
        if pointing:
            return _Read.HYPHEN if valued and hyphen != hyphen.strip() else _Read.EITHER
        return _Read.EITHER if led and not valued and not slot.slot.whole else _Read.HYPHEN


def _with_sign(text: str, hyphen: re.Match[str]) -> str:
    """A text in which a hyphen is written as nothing but a sign."""
    before = "".join(sign for sign in hyphen[0] if sign in ",=:(")
    return f"{text[: hyphen.start()]}{before} {_MINUS}{text[hyphen.end() :]}"


def _below_zero(understood: Understood) -> dict[tuple[int, str, int], tuple[Reading, SlotReading]]:
    """Slots with a value below zero, by the command in which they stand, their name and place."""
    return {
        (place, slot.label, slot.start): (part.reading, slot)
        for place, part in enumerate(understood[1])
        if part.reading is not None and part.accepted
        for slot in part.reading.slots
        if isinstance(slot.value, (int, float)) and not isinstance(slot.value, bool) and slot.value < 0
    }


def _either(text: str, written: str) -> Understood:
    reason = f"{written!r} could be below zero or not; write a space before the sign and none behind it, or say 'minus'"
    return Interpretation(text, Status.REJECTED, reason=reason), ()
