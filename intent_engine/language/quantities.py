"""Words to quantities in SI units: the one page that the rest of the language asks.

Kinds: ``number``, ``ordinal``, ``distance`` (m), ``angle`` (rad), ``duration`` (s), ``speed`` (m/s),
``angular_speed`` (rad/s), ``percent`` (a fraction of 1).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from intent_engine.language.numbers import english, english_ordinals, foreign
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.phrases import RELATIVE_SPEEDS, SHARE_OF, WHOLE_ANGLES, Relative
from intent_engine.language.numbers.templates import WITHOUT_ONE, templates
from intent_engine.language.numbers.units import FACTORS, LONGEST, Units, units

__all__ = [
    "RELATIVE_SPEEDS",
    "Found",
    "Relative",
    "counts",
    "evaluate",
    "find",
    "is_number_word",
    "is_numeral",
    "is_ordinal_word",
    "part_of_one",
    "templates",
    "tidy",
]

MAX_WORDS = 16
"""Words of the longest quantity that anybody says."""


_ANGLES_BEGIN = frozenset(spoken[0] for spoken in WHOLE_ANGLES)
_SMALLER: Mapping[str, tuple[float, float]] = {"m": (0.01, 100), "ft": (0.0254, 12), "h": (60.0, 60), "min": (1.0, 60)}
"""What a bare number after a unit counts, and how many make one: "one meter twenty", "five foot six"."""
_IMPERIAL = frozenset(("in", "ft", "yd", "mi"))
"""Lengths of which no other is a part: "two meters three feet" are two lengths, or the second puts the first right."""

_Numbers = Callable[[Sequence[str], int], Iterator[tuple[float, int]]]


JOINED = frozenset(("es", "it"))
"""Languages that say "a meter and fifty": "un metro e cinquanta"."""


def is_number_word(word: str, language: str = "en") -> bool:
    """Whether a word is a number of a language, or part of one. Templates spell out the English ones, but not "3rd"."""
    if language == "en":
        return word[:1].isdigit() and not is_numeral(word) and english_ordinals.ordinal([word]) is not None
    return foreign.is_number_word(word, language)


def is_ordinal_word(word: str, language: str = "en") -> bool:
    """Whether a word is a number or an ordinal of a language, or part of one."""
    return is_number_word(word, language) or (language != "en" and foreign.is_ordinal_word(word, language))


def people_rest_after(words: Sequence[str], language: str = "en") -> bool:
    """Whether words end in a quantity that people like to add to, after a rest: a single unit ("an hour", "and a half")
    and hours ("two hours", "and twenty minutes")."""
    table = units(language)
    found = table.unit_at_end(words) if table is not None else None
    if table is None or found is None:
        return False
    unit, begin = found
    before = words[begin - 1 : begin]
    single = table.words.get("one", frozenset()).issuperset(before) or evaluate(before, "number", language) == 1.0
    return unit == "h" or (begin > 0 and single)


def _numbers(language: str) -> _Numbers:
    if language == "en":
        return english.numbers_at
    return lambda words, at: foreign.numbers_at(words, at, language)


def evaluate(words: Sequence[str], kind: str, language: str = "en", unit: str | None = None) -> float | Relative | None:
    """The value of exactly these words in SI units.

    Args:
        words: normalised words, all of which must belong to the quantity.
        kind: see the module.
        unit: taken if the words carry none ("deg"); None: a unit must be said.

    Returns:
        A finite float; :class:`Relative` for a speed said in terms of the usual one; None if the words are no
        such quantity.
    """
    if not words or len(words) > MAX_WORDS:
        return None
    if kind == "number":
        return _whole(_numbers(language)(words, 0), len(words))
    if kind == "ordinal":
        return english_ordinals.ordinal(words) if language == "en" else foreign.ordinal(words, language)
    table = units(language)
    if table is None:
        return None
    if kind in ("speed", "angular_speed"):
        relative = RELATIVE_SPEEDS.get(language, {}).get(" ".join(words))
        if relative is not None:
            return Relative(relative)
        share = words[:-1] if words[-1] in SHARE_OF.get(language, ()) else words
        percent = _whole(_quantities(share, 0, "percent", language, table), len(share)) if len(share) > 1 else None
        if percent is not None and math.isfinite(percent):
            return Relative(percent) if 0 < percent <= 2 else None
    value = _whole(_quantities(words, 0, kind, language, table), len(words))
    if value is None and unit is not None:
        number = _whole(_numbers(language)(words, 0), len(words))
        if kind == "angle" and words[-1] in english.HALVES and number is not None and number < 1:
            return None  # "a quarter" of a turn, or of what? Never 0.25 degrees
        factor = _unit_factor(unit, kind, table)
        if number is not None and factor is not None:
            value = tidy(number * factor)
    if value is None or not math.isfinite(value) or (kind == "angle" and _in_two_pieces(words, value, language)):
        return None
    return value


def _in_two_pieces(words: Sequence[str], angle: float, language: str) -> bool:
    """Whether "five ten degrees" are two numbers, of which the second puts the first right: nobody turns by 510.
    Hundreds are left out of angles up to a whole turn ("one eighty"), and of quarter turns ("seven twenty")."""
    quarters = abs(angle) / (math.pi / 2)
    left_out = language == "en" and english.leaves_hundred_out(words)
    return left_out and quarters > 4 and not math.isclose(quarters, round(quarters))


def counts(words: Sequence[str], language: str = "en") -> Iterator[tuple[float, int]]:
    """How many of something the words begin with, and where that ends: "two", "half a", "another"."""
    yield from _counts(words, 0, language, units(language) or Units({}, {}))


def part_of_one(words: Sequence[str], language: str = "en") -> float | None:
    """How much of one thing the words say, before the word for it: "half a", "three quarters of a"; None: nothing."""
    if len(words) < 2 or words[-1] not in (units(language) or Units({}, {})).words.get("one", ()):
        return None
    return next((value for value, after in counts(words, language) if after == len(words)), None)


def tidy(value: float) -> float:
    """The decimal that was said: 35 cm is 0.35 m, where 35 times 0.01 is 0.35000000000000003."""
    short = float(f"{value:.12g}")
    return short if abs(short - value) <= 4 * math.ulp(value) else value


def _whole(found: Iterator[tuple[float, int]], length: int) -> float | None:
    return next((value for value, after in found if after == length and math.isfinite(value)), None)


def _unit_factor(unit: str, kind: str, table: Units) -> float | None:
    """SI factor of a unit as a grammar file writes it: "deg", "m", "m/s"."""
    plain = FACTORS.get(kind, {}).get(unit)
    if plain is not None:
        return plain
    words = tuple(unit.replace("/", " per ").split())
    if words in table.by_kind.get(kind, {}):
        return table.by_kind[kind][words]
    rate = _rate(words, 0, kind, table, "en")
    return rate[0] if rate is not None and rate[1] == len(words) else None


def _unit(words: Sequence[str], at: int, kind: str, table: Units) -> tuple[float, int, str] | None:
    """The unit that stands at a place, longest first: (factor, after, key)."""
    known = table.by_kind.get(kind, {})
    if kind == "duration" and words[at : at + 1] and words[at] == "m" and _of_a_time(words, at, table):
        return 60.0, at + 1, "min"
    for length in range(min(LONGEST, len(words) - at), 0, -1):
        spoken = tuple(words[at : at + length])
        if spoken in known:
            if _another_word(spoken, words[:at], words[at + 1 : at + 4]):
                continue
            return known[spoken], at + length, table.names[spoken]
    return None


def _of_a_time(words: Sequence[str], at: int, table: Units) -> bool:
    """Whether "m" stands between hours and seconds, after the one or before the other: "1h 30m", "1m 30s"."""
    if at > 2 and is_numeral(words[at - 1]) and table.names.get((words[at - 2],)) == "h":
        return True
    return at + 2 < len(words) and is_numeral(words[at + 1]) and table.names.get((words[at + 2],)) == "s"


def _another_word(spoken: tuple[str, ...], before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether what is spelled as a unit is none between its neighbours: no "in" of "10 in 3 years" or "two meters and a
    half in a minute" is an inch, "to turn", heard as "two turn", is no "two turns", and "a turn", which is written for
    "uh, turn left", is no circle; but "a turn and a half" is, and "a turn per second"."""
    last = "".join(before[-1:])
    if spoken == ("in",):
        return is_numeral("".join(after[:1])) or last in english.HALVES
    if spoken == ("turn",):
        number = english.number([last])
        if "".join(after[:1]) in ("per", "a") or (after and after[0] == "and" and english.fraction(after, 1)):
            return False
        return tuple(before) in (("a",), ("an",)) or (number is not None and number > 1 and not is_numeral(last))
    return False


def _rate(words: Sequence[str], at: int, kind: str, table: Units, language: str) -> tuple[float, int] | None:
    single = _unit(words, at, kind, table)
    if single is not None:
        return single[0], single[1]
    top = _unit(words, at, "distance" if kind == "speed" else "angle", table)
    bottom = _below(words, top[1], table) if top is not None else None
    return (top[0] / bottom[0], bottom[1]) if top is not None and bottom is not None else None


def _below(words: Sequence[str], at: int, table: Units) -> tuple[float, int] | None:
    """What a rate is for, "per second", and where it ends."""
    for length in (2, 1):  # "in der Stunde"
        if " ".join(words[at : at + length]) in table.words.get("per", ()):
            bottom = _unit(words, at + length, "duration", table)
            if bottom is not None:
                return bottom[0], bottom[1]
    return None


def _rate_and_a_half(
    words: Sequence[str], at: int, kind: str, language: str, table: Units
) -> Iterator[tuple[float, int]]:
    """ "A meter and a half per second"."""
    top_kind = "distance" if kind == "speed" else "angle"
    for value, after, key in _parts(words, at, top_kind, language, table):
        factor = FACTORS[top_kind][key]
        part = _part_after(words, after, value / factor, top_kind, language, table)
        bottom = _below(words, part[1], table) if part is not None else None
        if part is not None and bottom is not None:
            yield tidy((value + part[0] * factor) / bottom[0]), bottom[1]


def _quantities(words: Sequence[str], at: int, kind: str, language: str, table: Units) -> Iterator[tuple[float, int]]:
    """Every quantity of a kind that begins at a place, longest first."""
    if kind in ("speed", "angular_speed"):
        for value, after in _counts(words, at, language, table):
            rate = _rate(words, after, kind, table, language)
            if rate is not None:
                yield tidy(value * rate[0]), rate[1]
        yield from _rate_and_a_half(words, at, kind, language, table)
        if language in WITHOUT_ONE:
            half = _and_a_half(words, at, "distance" if kind == "speed" else "angle", language, table)
            bottom = _below(words, half[1], table) if half is not None else None
            if half is not None and bottom is not None:
                yield tidy(half[0] / bottom[0]), bottom[1]
        return
    if kind == "angle" and language == "en" and words[at : at + 1] and words[at] in _ANGLES_BEGIN:
        for spoken, angle in WHOLE_ANGLES.items():
            if tuple(words[at : at + len(spoken)]) == spoken:
                yield angle, at + len(spoken)
    found: list[tuple[float, int]] = []
    for value, after, key in _parts(words, at, kind, language, table):
        found.extend(_extended(words, value, after, key, kind, language, table, 0))
    if language in WITHOUT_ONE and (half := _and_a_half(words, at, kind, language, table)) is not None:
        found.append(half)
    found.sort(key=lambda pair: -pair[1])
    yield from ((tidy(value), after) for value, after in found)


def _and_a_half(words: Sequence[str], at: int, kind: str, language: str, table: Units) -> tuple[float, int] | None:
    """ "Metro y medio": one and a half."""
    unit = _unit(words, at, kind, table)
    if unit is None or not table.words.get("and", frozenset()).issuperset(words[unit[1] : unit[1] + 1]):
        return None
    part = foreign.fraction(words, unit[1] + 1, language)
    return (unit[0] * (1 + part[0]), part[1]) if part is not None else None


def _counts(words: Sequence[str], at: int, language: str, table: Units) -> Iterator[tuple[float, int]]:
    """Numbers before a unit, with "a meter", "half a meter", "a quarter of an hour"."""
    one, of = table.words.get("one", frozenset()), table.words.get("of", frozenset())
    for value, after in _numbers(language)(words, at):
        # "Four of the inches" says nobody, but "forty inches" is heard so.
        parts = language != "en" or value != int(value)
        if parts and after < len(words) and words[after] in of:
            onward = after + 1
            if onward < len(words) and (words[onward] in one or words[onward] == "the"):
                onward += 1
            yield value, onward
        if after < len(words) and words[after] in one and value != int(value):
            yield value, after + 1
        if after < len(words) and words[after] in table.words.get("more", ()):
            yield value, after + 1
        yield value, after
    if at + 1 < len(words) and words[at] in ("minus", "negative") and language == "en" and words[at + 1] in one:
        yield -1.0, at + 2
    if at < len(words) and (words[at] in one or words[at] in table.words.get("another", ())):
        yield 1.0, at + 1
        if at + 1 < len(words) and words[at + 1] in ("whole", "full", "single"):
            yield 1.0, at + 2
    elif at < len(words) and words[at] in ("whole", "full"):
        yield 1.0, at + 1


def _parts(words: Sequence[str], at: int, kind: str, language: str, table: Units) -> Iterator[tuple[float, int, str]]:
    for value, after in _counts(words, at, language, table):
        found = _unit(words, after, kind, table)
        if found is not None:
            factor, end, key = found
            yield value * factor, end, key
    if at < len(words) and kind == "duration":
        found = _unit(words, at, kind, table)
        if found is not None and found[2] == "fortnight":
            yield found[0], found[1], found[2]


def _extended(
    words: Sequence[str], value: float, after: int, key: str, kind: str, language: str, table: Units, depth: int
) -> Iterator[tuple[float, int]]:
    """A quantity with what may follow: "and a half", a smaller unit, a bare number of the smaller unit."""
    yield value, after
    if depth > 4 or after >= len(words):
        return
    factor = FACTORS[kind][key]
    joined = words[after] in table.words.get("and", ())
    onward = after + 1 if joined else after
    part = _part_after(words, after, value / factor, kind, language, table)
    if part is not None:
        with_part = value + part[0] * factor
        yield with_part, part[1]
        yield from ((with_part, end) for end in _more_ends(words, part[1], table))
    if depth == 0:
        yield from ((value, end) for end in _more_ends(words, after, table))
    for more, end, smaller in _parts(words, onward, kind, language, table):
        if FACTORS[kind][smaller] < factor and (key in _IMPERIAL) == (smaller in _IMPERIAL):
            yield from (
                (value + rest, last)
                for rest, last in _extended(words, more, end, smaller, kind, language, table, depth + 1)
            )
    square = words[after - 1] == "m" and len(words[onward : onward + 1]) == 1 and words[onward] in ("2", "3")  # "2 m2"
    if key in _SMALLER and (not joined or kind == "duration" or language in JOINED) and not square:
        size, most = _SMALLER[key]
        for number, end in _numbers(language)(words, onward):
            if 0 < number < most and number == int(number) and (not joined or kind == "duration" or number >= 10):
                yield value + number * size, end


def _more_ends(words: Sequence[str], at: int, table: Units) -> Iterator[int]:
    """Where "more" and the like end behind a quantity: "two feet more", "deux mètres de plus"."""
    for end in (at + 1, at + 2):
        if " ".join(words[at:end]) in table.words.get("more_after", ()):
            yield end


def _part_after(
    words: Sequence[str], after: int, count: float, kind: str, language: str, table: Units
) -> tuple[float, int] | None:
    """ "And a half" behind a unit of which there is a whole number: how much of it, and where that ends."""
    onward = after + 1
    # "1.5 meters and a half" is what a recogniser may make of "one meter and a half".
    joined = onward < len(words) and words[after] in table.words.get("and", ()) and tidy(count).is_integer()
    if not joined:
        return None
    part = english.fraction(words, onward) if language == "en" else foreign.fraction(words, onward, language)
    if part is None or not part[0] < 1 or _unit(words, part[1], kind, table) is not None:
        return None
    return part


@dataclass(frozen=True, slots=True)
class Found:
    """A quantity in running text."""

    kind: str
    value: float
    """SI."""
    start: int
    """First character."""
    end: int
    """Character after the last."""
    text: str


def find(text: str, language: str = "en") -> list[Found]:
    """All quantities in a text, left to right, the longest at each place; plain numbers where there is no unit."""
    from intent_engine.language.normalize import tokenize

    tokens = tokenize(text, language)
    words = [token.word for token in tokens]
    table = units(language)
    found: list[Found] = []
    at = 0
    while at < len(words):
        best: tuple[int, str, float] | None = None
        window = words[: at + MAX_WORDS]
        if table is not None:
            for kind in ("speed", "angular_speed", "distance", "duration", "angle"):
                for value, after in _quantities(window, at, kind, language, table):
                    bare_article = after == at + 2 and words[at] in table.words.get("one", ()) and kind == "angle"
                    if (best is None or after > best[0]) and not bare_article:
                        best = (after, kind, value)
                    break
        if best is None:
            for value, after in _numbers(language)(window, at):
                if after > at and (best is None or after > best[0]):
                    best = (after, "number", value)
        if best is None or not math.isfinite(best[2]):
            at += 1
            continue
        after, kind, value = best
        start, end = tokens[at].start, tokens[after - 1].end
        found.append(Found(kind, value, start, end, text[start:end]))
        at = after
    return found
