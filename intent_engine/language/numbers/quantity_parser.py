"""Numbers with their units at a place among words, as people say them: "two and a half meters", "5 ft 6", "a turn".

Kinds and their SI units are those of :mod:`~intent_engine.language.quantities`, which is what others ask.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from intent_engine.language.numbers import english, english_parts, english_words, foreign
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.units import FACTORS, LONGEST, Units, units

__all__ = ["MAX_WORDS", "PI", "QuantityParser", "parser_of", "tidy"]

MAX_WORDS = 16
"""Words of the longest quantity that anybody says."""

_SMALLER: Mapping[str, tuple[float, float]] = {"m": (0.01, 100), "ft": (0.0254, 12), "h": (60.0, 60), "min": (1.0, 60)}
"""What a bare number after a unit counts, and how many make one: "one meter twenty", "five foot six"."""
_IMPERIAL = frozenset(("in", "ft", "yd", "mi"))
"""Lengths of which no other is a part: "two meters three feet" are two lengths, or the second puts the first right."""
_NO_INCH_BEFORE = english_words.NUMBER_WORDS.union(
    ("a", "an", "the", "my", "your", "his", "her", "its", "our", "their", "this", "that", "these", "those", "total"),
    ("january", "february", "march", "april", "may", "june", "july", "august", "september", "october", "november"),
    ("december", "spring", "summer", "autumn", "winter"),
)
"""What "in" leads to: "two in three", "two in my car", "put two in the box" hold no inches."""
_OF_DAYS = {"d": "d", "w": "wk"}
"""Letters that are units only before a smaller one: of "3 d" nobody knows, "3d 4h" is a time."""
PI = frozenset(("pi", "π"))


class QuantityParser:
    """Reads the numbers and units of one language. Its iterators yield a value, and the place after its last word.

    Args:
        language: whose numbers.
        table: its units; None: it has none that are known, and so no quantities but plain numbers.
    """

    def __init__(self, language: str, table: Units | None) -> None:
        self._language = language
        self._table = table or Units({}, {})
        self._angles_begin = frozenset(spoken[0] for spoken in self._table.whole_angles)

    def numbers_at(self, words: Sequence[str], at: int) -> Iterator[tuple[float, int]]:
        """Every plain number that begins at a place, the one most likely meant first."""
        if self._language == "en":
            return english.numbers_at(words, at)
        return foreign.numbers_at(words, at, self._language)

    def quantities_at(self, words: Sequence[str], at: int, kind: str) -> Iterator[tuple[float, int]]:
        """Every quantity of a kind that begins at a place, longest first."""
        if kind in ("speed", "angular_speed"):
            for value, after in self.counts_at(words, at):
                rate = self._rate(words, after, kind)
                if rate is not None:
                    yield tidy(value * rate[0]), rate[1]
            yield from self._rate_and_a_half(words, at, kind)
            if "and_part" in self._table.words:
                half = self._and_a_half(words, at, "distance" if kind == "speed" else "angle")
                bottom = self._below(words, half[1]) if half is not None else None
                if half is not None and bottom is not None:
                    yield tidy(half[0] / bottom[0]), bottom[1]
            return
        if kind == "angle" and words[at : at + 1] and words[at] in self._angles_begin:
            for spoken, angle in self._table.whole_angles.items():
                if tuple(words[at : at + len(spoken)]) == spoken:
                    yield angle, at + len(spoken)
        found: list[tuple[float, int]] = []
        for value, after, key in self._parts(words, at, kind):
            found.extend(self._extended(words, value, after, key, kind, 0))
        if "and_part" in self._table.words and (half := self._and_a_half(words, at, kind)) is not None:
            found.append(half)
        if not found and kind == "angle" and self._language == "en" and not PI.isdisjoint(words):
            yield from self._radians_in_pi(words, at)
            return
        found.sort(key=lambda pair: -pair[1])
        yield from ((tidy(value), after) for value, after in found)

    def counts_at(self, words: Sequence[str], at: int) -> Iterator[tuple[float, int]]:
        """Numbers before a unit, with "a meter", "half a meter", "a quarter of an hour"."""
        one, of = self._table.words.get("one", frozenset()), self._table.words.get("of", frozenset())
        for value, after in self.numbers_at(words, at):
            # "Four of the inches" says nobody, but "forty inches" is heard so.
            parts = self._language != "en" or value != int(value)
            if parts and after < len(words) and words[after] in of:
                onward = after + 1
                if onward < len(words) and (words[onward] in one or words[onward] == "the"):
                    onward += 1
                yield value, onward
            if after < len(words) and words[after] in one and value != int(value):
                yield value, after + 1
            if after < len(words) and words[after] in self._table.words.get("more", ()):
                yield value, after + 1
            yield value, after
        negative = self._language == "en" and at + 1 < len(words) and words[at] in ("minus", "negative")
        if negative and words[at + 1] in one:
            yield -1.0, at + 2
        if at < len(words) and (words[at] in one or words[at] in self._table.words.get("another", ())):
            yield 1.0, at + 1
            if at + 1 < len(words) and words[at + 1] in ("whole", "full", "single"):
                yield 1.0, at + 2
        elif at < len(words) and words[at] in ("whole", "full"):
            yield 1.0, at + 1

    def factor(self, unit: str, kind: str) -> float | None:
        """SI factor of a unit as a grammar file writes it: "deg", "m", "m/s"."""
        plain = FACTORS.get(kind, {}).get(unit)
        if plain is not None:
            return plain
        words = tuple(unit.replace("/", " per ").split())
        if words in self._table.by_kind.get(kind, {}):
            return self._table.by_kind[kind][words]
        rate = self._rate(words, 0, kind)
        return rate[0] if rate is not None and rate[1] == len(words) else None

    def _unit(self, words: Sequence[str], at: int, kind: str) -> tuple[float, int, str] | None:
        """The unit that stands at a place, longest first: (factor, after, key)."""
        known = self._table.by_kind.get(kind, {})
        if kind == "duration" and words[at : at + 1]:
            if words[at] == "m" and self._of_a_time(words, at):
                return 60.0, at + 1, "min"
            if words[at] in _OF_DAYS and self._before_a_time(words, at):
                key = _OF_DAYS[words[at]]
                return FACTORS["duration"][key], at + 1, key
        for length in range(min(LONGEST, len(words) - at), 0, -1):
            spoken = tuple(words[at : at + length])
            if spoken in known:
                if _another_word(spoken, words[:at], words[at + 1 : at + 4]):
                    continue
                return known[spoken], at + length, self._table.names[spoken]
        return None

    def _of_a_time(self, words: Sequence[str], at: int) -> bool:
        """Whether "m" stands between hours and seconds, after the one or before the other: "1h 30m", "1m 30s"."""
        if at > 2 and is_numeral(words[at - 1]) and self._table.names.get((words[at - 2],)) == "h":
            return True
        return at + 2 < len(words) and is_numeral(words[at + 1]) and self._table.names.get((words[at + 2],)) == "s"

    def _before_a_time(self, words: Sequence[str], at: int) -> bool:
        """Whether "d" or "w" is a unit as the next one is: "2d 4h", "1w 3d 2h"."""
        if at < 1 or at + 2 >= len(words) or not is_numeral(words[at - 1]) or not is_numeral(words[at + 1]):
            return False
        return self._unit(words, at + 2, "duration") is not None

    def _radians_in_pi(self, words: Sequence[str], at: int) -> Iterator[tuple[float, int]]:
        """ "Pi over two radians", "half pi radians", "minus 3 pi / 4 rad"; without the unit it may be any number."""
        sign = -1.0 if words[at : at + 1] and words[at] in ("minus", "negative") else 1.0
        begin = at + (sign < 0)
        tops = [(1.0, begin), *self.numbers_at(words, begin)] if begin < len(words) else []
        for top, here in tops:
            if here >= len(words) or words[here] not in PI:
                continue
            bottoms = [(1.0, here + 1)]
            if here + 2 < len(words) and words[here + 1] in ("over", "by"):
                bottoms = [*self.numbers_at(words, here + 2)]
            for bottom, end in bottoms:
                if bottom > 0 and end < len(words) and self._table.names.get((words[end],)) == "rad":
                    yield sign * top * math.pi / bottom, end + 1

    def _rate(self, words: Sequence[str], at: int, kind: str) -> tuple[float, int] | None:
        """The unit of a rate that stands at a place, "knots" or "meters per second": its factor, and where it ends."""
        single = self._unit(words, at, kind)
        if single is not None:
            return single[0], single[1]
        top = self._unit(words, at, "distance" if kind == "speed" else "angle")
        bottom = self._below(words, top[1]) if top is not None else None
        return (top[0] / bottom[0], bottom[1]) if top is not None and bottom is not None else None

    def _below(self, words: Sequence[str], at: int) -> tuple[float, int] | None:
        """What a rate is for, "per second", and where it ends."""
        for length in (2, 1):  # "in der Stunde"
            if " ".join(words[at : at + length]) in self._table.words.get("per", ()):
                bottom = self._unit(words, at + length, "duration")
                if bottom is not None:
                    return bottom[0], bottom[1]
        return None

    def _rate_and_a_half(self, words: Sequence[str], at: int, kind: str) -> Iterator[tuple[float, int]]:
        """ "A meter and a half per second"."""
        top_kind = "distance" if kind == "speed" else "angle"
        for value, after, key in self._parts(words, at, top_kind):
            factor = FACTORS[top_kind][key]
            part = self._part_after(words, after, value / factor, top_kind)
            bottom = self._below(words, part[1]) if part is not None else None
            if part is not None and bottom is not None:
                yield tidy((value + math.copysign(part[0] * factor, value)) / bottom[0]), bottom[1]

    def _and_a_half(self, words: Sequence[str], at: int, kind: str) -> tuple[float, int] | None:
        """ "Metro y medio": one and a half."""
        unit = self._unit(words, at, kind)
        if unit is None or not self._table.words["and_part"].issuperset(words[unit[1] : unit[1] + 1]):
            return None
        part = foreign.fraction(words, unit[1] + 1, self._language)
        return (unit[0] * (1 + part[0]), part[1]) if part is not None else None

    def _parts(self, words: Sequence[str], at: int, kind: str) -> Iterator[tuple[float, int, str]]:
        """Numbers with one unit that begin at a place: (value, after, key of the unit)."""
        for value, after in self.counts_at(words, at):
            found = self._unit(words, after, kind)
            if found is not None:
                factor, end, key = found
                yield value * factor, end, key
        if at < len(words) and kind == "duration":
            found = self._unit(words, at, kind)
            if found is not None and found[2] == "fortnight":
                yield found[0], found[1], found[2]

    def _extended(
        self, words: Sequence[str], value: float, after: int, key: str, kind: str, depth: int
    ) -> Iterator[tuple[float, int]]:
        """A quantity with what may follow: "and a half", a smaller unit, a bare number of the smaller unit. Below zero
        it is so as a whole: "minus one inch and a half" is -1.5 inches."""
        yield value, after
        if depth > 4 or after >= len(words):
            return
        factor = FACTORS[kind][key]
        sign = math.copysign(1.0, value)
        joined = words[after] in self._table.words.get("and", ())
        onward = after + 1 if joined else after
        part = self._part_after(words, after, value / factor, kind)
        if part is not None:
            with_part = value + sign * part[0] * factor
            yield with_part, part[1]
            yield from ((with_part, end) for end in self._more_ends(words, part[1]))
        if depth == 0:
            yield from ((value, end) for end in self._more_ends(words, after))
        for more, end, smaller in self._parts(words, onward, kind):
            if more < 0 and sign < 0:
                continue  # "minus one foot minus two inches" may be either way from there
            if FACTORS[kind][smaller] < factor and (key in _IMPERIAL) == (smaller in _IMPERIAL):
                extended = self._extended(words, more, end, smaller, kind, depth + 1)
                yield from ((value + sign * rest, last) for rest, last in extended)
        square = words[after - 1] == "m" and onward < len(words) and words[onward] in ("2", "3")  # "2 m2"
        led = not joined or kind == "duration" or words[after] in self._table.words.get("and_smaller", ())
        # "2.5 meters fifty" may be 2.55 m, "1.5 hours thirty" an hour and a half, said twice over.
        counted = tidy(value / factor).is_integer()
        if key in _SMALLER and led and counted and not square:
            size, most = _SMALLER[key]
            for number, end in self.numbers_at(words, onward):
                if end < len(words) and any(self._unit(words, end, other) is not None for other in self._table.by_kind):
                    continue  # "10 m 20 m", "one meter twenty degrees"
                if 0 < number < most and number == int(number) and (not joined or kind == "duration" or number >= 10):
                    yield value + sign * number * size, end

    def _more_ends(self, words: Sequence[str], at: int) -> Iterator[int]:
        """Where "more" and the like end behind a quantity: "two feet more", "deux mètres de plus"."""
        for end in range(at + 1, min(at + 2, len(words)) + 1):
            if " ".join(words[at:end]) in self._table.words.get("more_after", ()):
                yield end

    def _part_after(self, words: Sequence[str], after: int, count: float, kind: str) -> tuple[float, int] | None:
        """ "And a half" behind a unit of which there is a whole number: how much of it, and where that ends."""
        onward = after + 1
        # "1.5 meters and a half" is what a recogniser may make of "one meter and a half".
        joined = onward < len(words) and words[after] in self._table.words.get("and", ()) and tidy(count).is_integer()
        if not joined:
            return None
        language = self._language
        part = english_parts.fraction(words, onward) if language == "en" else foreign.fraction(words, onward, language)
        if part is None or not part[0] < 1 or self._unit(words, part[1], kind) is not None:
            return None
        return part


@cache
def parser_of(language: str) -> QuantityParser:
    """The parser of a language."""
    return QuantityParser(language, units(language))


def tidy(value: float) -> float:
    """The decimal that was said: 35 cm is 0.35 m, where 35 times 0.01 is 0.35000000000000003."""
    short = float(f"{value:.12g}")
    return short if abs(short - value) <= 4 * math.ulp(value) else value


def _another_word(spoken: tuple[str, ...], before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether what is spelled as a unit is none between its neighbours: no "in" of "10 in 3 years" or "two meters and a
    half in a minute" is an inch, "to turn", heard as "two turn", is no "two turns", and "a turn", which is written for
    "uh, turn left", is no circle; but "a turn and a half" is, and "a turn per second"."""
    last = "".join(before[-1:])
    if spoken == ("in",):
        following = "".join(after[:1])
        return is_numeral(following) or following in _NO_INCH_BEFORE or last in english_words.HALVES
    if spoken == ("turn",):
        number = english.number([last])
        if "".join(after[:1]) in ("per", "a") or (after and after[0] == "and" and english_parts.fraction(after, 1)):
            return False
        return tuple(before) in (("a",), ("an",)) or (number is not None and number > 1 and not is_numeral(last))
    return False
