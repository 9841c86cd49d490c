"""Dashes before numbers that may be their sign: those of "Z-5", "x - 10" and "at - 20", and the one of "bay-3"."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from enum import Enum
from itertools import pairwise

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.told import Understood
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers.quantity_parser import parser_of
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.adjacent_numbers import row_in_pieces
from intent_engine.language.words.thing_words import thing_words

__all__ = ["DashOrSign"]

_MOST = 12
"""So many may be in a command."""
_MINUS = "−"
_SIGNS = frozenset("-−‐‑‒–—")
_HYPHENS = re.compile(
    r"(?:(?<=[^\W\d_])[-−‐‑‒–]"
    r"|(?<=[^\W_]),[-−‐‑‒–]"
    r"|(?<=[^\W\d_])\s+[-‐‑‒–]\s+"
    r"|(?<=\d)\s+[-−‐‑‒–]\s*"
    r"|[=:(]\s*[-‐‑‒–]\s+)(?=\.?\d)"
)
"""Those that stand between a word and a number, or in a list of numbers: "z-5", "10,-5", "10 -5", "z - 5", "z = - 5".
Others are what they seem: "z -5" has a sign, "3-5" none."""
_SIGN_APART = re.compile(r"\s+[-−‐‑‒–]")
_SIGNED = re.compile(r"(?<!\S)[-−‐‑‒–]\.?\d[\d.]*\Z")
"""A number that is signed like the one behind such a hyphen: the first of "-2 -3"."""
_SIGNED_BEFORE = re.compile(r"(?<!\S)[-−‐‑‒–]\.?\d[\d.]*(?P<hyphen>[-−‐‑‒–])(?=\.?\d)")
"""One right behind such a number, that may be the dash of a range or the next sign: "-2-3"."""
_SIGNED_LETTER = re.compile(r"(?<!\S)[-−‐‑‒–]([^\W\d_])(?!\w)")
"""A letter with a sign, as an axis has it: "along -x"."""
_DASH = re.compile(r"\s*[-−‐‑‒–—]+\s*")
_NUMBER = re.compile(r"[\d.,]*\d")
_LAST_WORD = re.compile(r"[^\W_]+$")


_OF_TWO_UNITS = ("distance", "duration", "angle")
"""Types of which so much may be less than another: "one hour - 5 minutes"."""


class _Read(Enum):
    SIGN = "sign"
    HYPHEN = "hyphen"
    EITHER = "either"


class DashOrSign:
    """Says which such dashes are signs, and refuses a text in which that is unclear.

    They are where the number may be below zero and a letter, a preposition or a sign stands before it: "z-5 mm", "by -
    5 mm", "10,-5". They are none where no number of that slot is below zero ("bay-3"), and between two values ("turn
    left - 90 degrees"). Of others nobody knows, nor of one that stands apart where a value follows: no pause is made
    behind the "at" of "keep it at - 20 degrees".
    """

    def __init__(self, grammar: Grammar) -> None:
        self._language = grammar.language
        words = thing_words(grammar.language)
        self._leading = words.joining
        self._articles = words.articles
        self._level = (units(grammar.language) or Units({}, {})).words.get("level", frozenset())
        self._taking_back = {phrase[-1] for phrase in grammar.operators.correction}
        self._below_zero = any(
            slot.type in _OF_TWO_UNITS or (slot.type in QUANTITY_KINDS and (slot.smallest is None or slot.smallest < 0))
            for slot in grammar.slots.values()
        )

    def may_stand_in(self, text: str) -> bool:
        """Whether there is a dash at all."""
        return not _SIGNS.isdisjoint(text)

    def understood(self, text: str, meant: Callable[[str], Understood]) -> Understood:
        """What a text means with its signs as such.

        Args:
            text: what was said or typed.
            meant: what a text means, its hyphens taken for hyphens.
        """
        signed, found = self._signed(text, meant) if self._below_zero else (text, meant(text))
        if found[0].actions and not found[0].stops and (number := self._unclear(signed, found[1])):
            return _either(text, number)
        if found[0].actions and not found[0].stops and (letter := _letter_with_sign(text, found[1])):
            reason = f"{letter!r} may be the other way along it; say which way"
            return Interpretation(text, Status.REJECTED, reason=reason), ()
        if from_to := self._from_to(signed, found[1]):
            reason = f"{from_to!r} may be all from the one to the other; say each of them"
            return Interpretation(text, Status.REJECTED, reason=reason), ()
        return replace(found[0], text=text), found[1]

    def _signed(self, text: str, meant: Callable[[str], Understood]) -> tuple[str, Understood]:
        """A text with each hyphen that is a sign written as nothing else, and what it means."""
        found = meant(text)
        signed, begin, count = text, 0, 0
        while not found[0].stops and (hyphen := _HYPHENS.search(signed, begin)) is not None:
            begin, count = hyphen.end(), count + 1
            other = _with_sign(signed, hyphen)
            otherwise = meant(other)
            before = _LAST_WORD.search(signed, 0, hyphen.start())
            word = before[0].casefold() if before is not None else ""
            read = self._read(hyphen[0], word, found, otherwise) if count <= _MOST else _Read.EITHER
            alike = _SIGN_APART.fullmatch(hyphen[0]) and _SIGNED.search(signed, 0, hyphen.start())
            if read is _Read.EITHER and alike and _of_two(otherwise):
                read = _Read.SIGN
            if read is _Read.EITHER:
                number = _NUMBER.match(signed, begin)
                written = f"{hyphen[0].strip()}{number[0]}" if number is not None else hyphen[0]
                return signed, _either(text, written, behind_number=word[-1:].isdigit())
            if read is _Read.SIGN:
                begin += len(other) - len(signed)
                signed, found = other, otherwise
        for dash in _SIGNED_BEFORE.finditer(signed) if found[0].actions and not found[0].stops else ():
            at = dash.start("hyphen")
            otherwise = meant(f"{signed[:at]}  {_MINUS}{signed[at + 1 :]}")
            if otherwise[0].status is Status.ACCEPTED and _of_two(otherwise):
                return signed, _either(text, f"{dash['hyphen']}{signed[dash.end() :].split()[0]}", behind_number=True)
        return signed, found

    def _unclear(self, text: str, parts: Sequence[Clause]) -> str:
        """A number behind a dash, where a value is to follow; empty: there is none, or it stands among free words."""
        tokens = tokenize(text, self._language) if self._level and _DASH.search(text) else ()
        words = [token.word for token in tokens]
        for at in range(1, len(tokens)):
            between = text[tokens[at - 1].end : tokens[at].start]
            if words[at - 1] not in self._level or not _DASH.fullmatch(between):
                continue
            is_number = next(parser_of(self._language).numbers_at(words, at), None) is not None
            free = (name for part in parts for name in part.free_names)
            if is_number and not any(words[at] in name for name in free):
                return text[tokens[at - 1].end : tokens[at].end].strip()
        return ""

    def _from_to(self, text: str, parts: Sequence[Clause]) -> str:
        """Two numbers with a dash between them, each of another command of a list, or both of what a slot takes for
        one that is said digit by digit: "drawers 2-5 and 7", "gate 12-15"; empty: there are none."""
        readings = [part.reading for part in parts if part.reading is not None]
        rows = [(one, slot) for one in readings for slot in one.slots if slot.slot.digits]
        tokens = tokenize(text, self._language) if len(readings) > 1 or rows else ()
        dashed = [_DASH.fullmatch(text[one.end : other.start]) is not None for one, other in pairwise(tokens)]
        for (one, other), dash in zip(pairwise(tokens), dashed, strict=True):
            for before, after in pairwise(readings) if dash else ():
                if before.sentence is after.sentence and _ends(before, one.word) and _begins(after, other.word):
                    return text[one.start : other.end]
        for reading, slot in rows if any(dashed) else ():
            row, words = [*reading.words[slot.start : slot.end]], [token.word for token in tokens]
            for begin in range(len(words) - len(row) + 1):
                end = begin + len(row)
                at = replace(slot, start=begin, end=end)
                if words[begin:end] == row and row_in_pieces(at, words, [False, *dashed], self._language):
                    return text[tokens[begin].start : tokens[end - 1].end]
        return ""

    def _read(self, hyphen: str, before: str, found: Understood, otherwise: Understood) -> _Read:
        """What a hyphen behind a word is of which it is known what the text means without a sign there and with one."""
        if otherwise[0].status is not Status.ACCEPTED:
            return _Read.HYPHEN
        known, below = _below_zero(found), _below_zero(otherwise)
        more = [below[place] for place in below if place not in known]
        if len(below) == len(known):  # "one hour - 5 minutes" may be less than an hour
            return _Read.HYPHEN if _amounts(found) == _amounts(otherwise) else _Read.EITHER
        return self._of_slot(hyphen, before, *more[0]) if len(more) == 1 else _Read.EITHER

    def _of_slot(self, hyphen: str, before: str, reading: Reading, slot: SlotReading) -> _Read:
        if _MINUS in hyphen or any(sign in hyphen for sign in ",=("):
            return _Read.SIGN  # no name is written so, and no pause
        if before[-1:].isdigit():
            return _Read.EITHER  # two coordinates, or from the one to the other
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
    # Behind a number and one blank it would be the dash of a range: "75 -300 mm".
    apart = "  " if hyphen[0][0].isspace() and text[hyphen.start() - 1].isdigit() else " "
    return f"{text[: hyphen.start()]}{before}{apart}{_MINUS}{text[hyphen.end() :]}"


def _below_zero(understood: Understood) -> dict[tuple[int, str, int], tuple[Reading, SlotReading]]:
    """Slots with a value below zero, by the command in which they stand, their name and place."""
    return {
        (place, slot.label, slot.start): (part.reading, slot)
        for place, part in enumerate(understood[1])
        if part.reading is not None and part.accepted
        for slot in part.reading.slots
        if isinstance(slot.value, (int, float)) and not isinstance(slot.value, bool) and slot.value < 0
    }


def _letter_with_sign(text: str, parts: Sequence[Clause]) -> str:
    """A letter with a sign before it that was taken for the value of a list; empty: there is none."""
    signed = {found[1].casefold(): found[0] for found in _SIGNED_LETTER.finditer(text)}
    readings = (part.reading for part in parts if signed and part.reading is not None)
    listed = ((one.words, slot) for one in readings for slot in one.slots if slot.slot.type == "choice")
    letters = (words[slot.start] for words, slot in listed if slot.end - slot.start == 1)
    return next((signed[letter] for letter in letters if letter in signed), "")


def _amounts(understood: Understood) -> list[object]:
    """The value of every quantity, in order."""
    readings = (part.reading for part in understood[1] if part.reading is not None)
    return [slot.value for reading in readings for slot in reading.slots if slot.slot.type in QUANTITY_KINDS]


def _ends(reading: Reading, word: str) -> bool:
    """Whether a number ends with a word."""
    return any(slot.slot.type == "number" and reading.words[slot.end - 1] == word for slot in reading.slots)


def _begins(reading: Reading, word: str) -> bool:
    """Whether a number begins with a word."""
    return any(slot.slot.type == "number" and reading.words[slot.start] == word for slot in reading.slots)


def _of_two(understood: Understood) -> bool:
    """Whether a number below zero stands right behind another one."""
    return any(
        any(other.end == slot.start and other.slot.type == slot.slot.type for other in reading.slots)
        for reading, slot in _below_zero(understood).values()
    )


def _either(text: str, written: str, *, behind_number: bool = False) -> Understood:
    how = "a comma between the numbers" if behind_number else "a space before the sign and none behind it"
    reason = f"{written!r} could be below zero or not; write {how}, or say 'minus'"
    return Interpretation(text, Status.REJECTED, reason=reason), ()
