"""Quantities to words: the ways to say a length, an angle or a time within limits, each with its value.

The other direction of :mod:`~intent_engine.language.quantities`, for sampling. It shares with that module the table
of units, and nothing else, so that what one of them gets wrong the other shows.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple, TypeAlias

from intent_engine.language.numbers import foreign, said
from intent_engine.language.numbers.digit_by_digit import digits_in_words
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.numbers.units import FACTORS, RATES, SIGNS, Units, units
from intent_engine.language.quantities import Relative, tidy

__all__ = ["Spoken", "spoken_forms", "usual_units"]


class Spoken(NamedTuple):
    """One way to say a value."""

    text: str
    value: Any
    """A float in SI units, or a :class:`Relative` speed; names and words where a sampler speaks of others."""


_Number: TypeAlias = tuple[str, float]
_Said: TypeAlias = _Number | tuple[str, Relative]
_Limits: TypeAlias = tuple[float, float]
_USUAL: Mapping[str, Sequence[str]] = {
    "distance": ("m", "ft", "cm", "in", "yd", "mm", "km", "mi"),
    "duration": ("s", "min", "ms", "h"),
    "angle": ("deg", "turn", "rad"),
    "percent": ("percent",),
}
"""Units that people say to robots, the most usual first."""
_USUAL_RATES: Mapping[str, Sequence[tuple[str, str]]] = {
    "speed": (("m", "s"), ("km", "h"), ("cm", "s"), ("ft", "s"), ("m", "min"), ("mi", "h")),
    "angular_speed": (("deg", "s"), ("rad", "s"), ("turn", "min")),
}
_SIGNS: Mapping[str, str] = {"deg": "°", "percent": "%", "m": "m", "cm": "cm", "ft": "ft", "s": "s"}
"""What is written straight after a number in digits."""
_SMALLER: Mapping[str, tuple[str, float]] = {"m": ("cm", 100), "ft": ("in", 12), "min": ("s", 60), "h": ("min", 60)}
"""The unit that is said after a larger one ("two feet six inches"), and how many of it make one."""
_TURNS: Mapping[str, float] = {
    "quarter turn": math.pi / 2, "a quarter turn": math.pi / 2, "half a turn": math.pi, "a full circle": 2 * math.pi,
    "halfway around": math.pi, "all the way around": 2 * math.pi,
}  # fmt: skip
_WHOLE = (*range(1, 21), 25, 30, 35, 40, 45, 50, 60, 70, 75, 80, 90, 100, 110, 120, 135, 150, 180, 200, 225, 250, 270,
          300, 333, 360, 400, 450, 500, 720, 750, 999, 1000)  # fmt: skip
_DECIMALS = ("0.5", "1.5", "2.5", "0.2", "0.3", "0.75", "1.25", "3.4", "7.05", "12.5", "22.5", "37.8")


@cache
def spoken_forms(
    kind: str,
    language: str,
    unit: str | None,
    minimum: float | None,
    maximum: float | None,
    *,
    whole: bool = False,
    own: tuple[tuple[float, tuple[str, ...]], ...] = (),
    bare: bool = True,
    digits: bool = False,
) -> tuple[tuple[Spoken, ...], ...]:
    """The ways to say a quantity, by form (whole numbers, decimals, fractions, ...), the shortest form first.

    Args:
        kind: one of ``QUANTITY_KINDS``.
        language: its units and number words are used; where no words are known, digits serve.
        unit: of the slot; a bare number can be said if there is one.
        minimum: SI, inclusive; None: no limit.
        maximum: SI, inclusive; None: no limit.
        whole: only whole numbers.
        own: units of the slot itself: the size of each, and what it is called, singular and plural first.
        bare: whether a number is said without these, where it can be.
        digits: whether digits are said one by one, too.
    """
    limits = (-math.inf if minimum is None else minimum, math.inf if maximum is None else maximum)
    usual = _forms(kind, language, unit) if bare or kind != "number" else ()
    by_digit = _digit_by_digit(kind, language, unit, own, bare) if digits else ()
    forms = (_within(form, limits, whole) for form in (*usual, *_in_own(language, own), *by_digit))
    return tuple(sorted((form for form in forms if form), key=lambda form: len(form[0].text.split())))


def usual_units(kind: str, language: str, *, single: bool) -> Iterator[str]:
    """The first words of the units that people say for a kind, the most usual first; of rates there are none.

    Args:
        kind: one of ``QUANTITY_KINDS``.
        language: whose words.
        single: behind "one".
    """
    table = units(language)
    for key in _USUAL.get(kind, ()) if table is not None else ():
        assert table is not None
        if names := [name for name in _names(key, table) if language == "en" or name not in SIGNS]:
            yield (names[0] if single else _plural(names)).split()[0]


def _within(form: Iterable[_Said], limits: _Limits, whole: bool) -> tuple[Spoken, ...]:
    found: dict[str, Spoken] = {}
    for text, value in form:
        if isinstance(value, Relative) or (
            limits[0] <= value <= limits[1] and (not whole or float(value).is_integer())
        ):
            found.setdefault(text, Spoken(text, value if isinstance(value, Relative) else tidy(float(value))))
    return tuple(found.values())


def _forms(kind: str, language: str, unit: str | None) -> Iterator[Iterable[_Said]]:
    english = language == "en"
    if kind == "number":
        yield _whole_numbers(language)
        yield _decimal_numbers(english)
        if english:
            yield _fractions()
        return
    if kind == "ordinal":
        yield _ordinals(english)
        return
    table = units(language)
    if table is None:
        return
    factor = _factor(kind, unit)
    if factor is not None:
        yield [(text, value * factor) for text, value in (*_whole_numbers(language), *_decimal_numbers(english))]
    if kind in _USUAL_RATES:
        yield from _rates(kind, table, language)
        return
    names = {key: _names(key, table) for key in _USUAL[kind]}
    sizes = {key: FACTORS[kind][key] for key, forms in names.items() if forms}
    yield _with_units(_whole_numbers(language), names, sizes)
    yield _with_units(_decimal_numbers(english), names, sizes)
    yield [
        (f"{number}{_SIGNS[key]}", number * size)
        for key, size in sizes.items()
        if key in _SIGNS and (english or _SIGNS[key] in "°%" or (_SIGNS[key],) in table.names)
        for number in _WHOLE
    ]
    if english:
        yield from _english(kind, names, sizes)
    elif kind == "angle" and table.whole_angles:
        yield [(" ".join(words), angle) for words, angle in table.whole_angles.items()]


def _in_own(language: str, own: Iterable[tuple[float, tuple[str, ...]]]) -> Iterator[Iterable[_Said]]:
    """In units that only the slot has."""
    names = {str(at): forms for at, (_, forms) in enumerate(own)}
    sizes = {str(at): size for at, (size, _) in enumerate(own)}
    yield _with_units(_whole_numbers(language), names, sizes)
    if language == "en":
        yield _singular(names, sizes)


def _digit_by_digit(
    kind: str, language: str, unit: str | None, own: tuple[tuple[float, tuple[str, ...]], ...], bare: bool
) -> Iterator[Iterable[_Said]]:
    """Numbers whose digits are said one by one: "one eight zero degrees"."""
    numbers = [(digits_in_words(number, language), float(number)) for number in _WHOLE if number > 9]
    factor = 1.0 if kind == "number" and bare else _factor(kind, unit)
    if factor is not None:
        yield [(text, value * factor) for text, value in numbers]
    table = units(language)
    usual = {key: _names(key, table) for key in _USUAL.get(kind, ())} if table is not None else {}
    yield _with_units(numbers, usual, {key: FACTORS[kind][key] for key, forms in usual.items() if forms})
    yield _with_units(
        numbers,
        {str(at): forms for at, (_, forms) in enumerate(own)},
        {str(at): size for at, (size, _) in enumerate(own)},
    )


def _factor(kind: str, unit: str | None) -> float | None:
    """SI factor of a slot's own unit, if its plain name is one of ours."""
    if unit is None:
        return None
    return FACTORS.get(kind, {}).get(unit) or RATES.get(kind, {}).get(unit)


def _names(key: str, table: Units) -> tuple[str, ...]:
    """The spellings of a unit, in the order of its file: singular and plural first."""
    return tuple(" ".join(words) for words, name in table.names.items() if name == key and words != ("in",))


def _named(number: float, forms: Sequence[str]) -> Iterator[str]:
    """The words for a unit after a number: the usual one first, then others."""
    yield forms[0] if number == 1 else _plural(forms)
    yield from forms[2:6]


def _whole_numbers(language: str) -> Iterator[_Number]:
    for number in _WHOLE:
        yield str(number), float(number)
        if language == "en":
            yield " ".join(in_words([str(number)])), float(number)
        elif number > 1 and foreign.number(words := said.spell(number, language), language) == number:
            yield " ".join(words), float(number)  # "one" is an article; and text2num lacks a few


def _decimal_numbers(english: bool) -> Iterator[_Number]:
    for number in _DECIMALS:
        yield number, float(number)
        if english:
            yield " ".join(in_words([number])), float(number)
            if number.startswith("0."):
                yield "point " + " ".join(in_words([number])[2:]), float(number)


def _fractions() -> Iterator[_Number]:
    yield "1/2", 0.5
    yield "three quarters", 0.75
    for number in (1, 2, 3, 10):
        word = in_words([str(number)])[0]
        yield f"{word} and a half", number + 0.5
        yield f"{number} and a half", number + 0.5
        yield f"{number} 1/2", number + 0.5
        yield f"{number}-1/2", number + 0.5
        yield f"{word} and a quarter", number + 0.25


def _ordinals(english: bool) -> Iterator[_Number]:
    if not english:
        yield from ((str(number), float(number)) for number in range(1, 13))
        return
    words = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh")
    for number, word in enumerate(words, start=1):
        yield word, float(number)
    for number in (1, 2, 3, 4, 12, 21):
        suffix = {1: "st", 2: "nd", 3: "rd"}.get(0 if 10 < number < 20 else number % 10, "th")
        yield f"{number}{suffix}", float(number)
    yield "twenty first", 21.0


def _with_units(
    numbers: Iterable[_Number], names: Mapping[str, Sequence[str]], sizes: Mapping[str, float]
) -> Iterator[_Number]:
    said = list(numbers)
    for key, size in sizes.items():
        for text, number in said:
            for name in _named(number, names[key]):
                if len(name) > 2 or text[-1].isdigit():  # nobody writes "twenty s"
                    yield f"{text} {name}", number * size


def _rates(kind: str, table: Units, language: str) -> Iterator[Iterable[_Said]]:
    top_kind = "distance" if kind == "speed" else "angle"
    rates: list[_Number] = []
    per = "per" if "per" in table.words.get("per", ()) else min(table.words.get("per", ("per",)))
    for top, bottom in _USUAL_RATES[kind]:
        above, below = _names(top, table), _names(bottom, table)
        if above and below:
            rates.append((f"{_plural(above)} {per} {below[0]}", FACTORS[top_kind][top] / FACTORS["duration"][bottom]))
    for numbers in (_whole_numbers(language), _decimal_numbers(language == "en")):
        said = list(numbers)
        yield [(f"{text} {name}", number * size) for name, size in rates for text, number in said]
    signs = {"m/s": 1.0, "km/h": 1 / 3.6} if kind == "speed" else {"rad/s": 1.0}
    yield [(f"{text} {sign}", float(text) * size) for sign, size in signs.items() for text in ("1", "2", *_DECIMALS)]
    for key, size in RATES[kind].items():
        if names := _names(key, table):
            yield [(f"{text} {names[0]}", number * size) for text, number in _whole_numbers(language)]
    if table.speeds:
        yield [(text, Relative(factor)) for text, factor in table.speeds.items()]


def _english(kind: str, names: Mapping[str, Sequence[str]], sizes: Mapping[str, float]) -> Iterator[Iterable[_Said]]:
    if kind != "percent":
        yield _singular(names, sizes)
    yield _with_units(((text, value) for text, value in _fractions() if value > 1), names, sizes)
    yield _mixed(names, sizes)
    if kind == "angle":
        yield _TURNS.items()


def _singular(names: Mapping[str, Sequence[str]], sizes: Mapping[str, float]) -> Iterator[_Number]:
    for key, size in sizes.items():
        name, plural = names[key][0], _plural(names[key])
        a = "an" if name[0] in "aeio" or name == "hour" else "a"
        if name != "turn":  # "a turn left" is none
            yield f"{a} {name}", size
            yield f"{a} {name} and a half", size * 1.5
        yield f"half {a} {name}", size / 2
        yield f"1/2 {name}", size / 2
        yield f"a quarter of {a} {name}", size / 4
        yield f"a couple of {plural}", size * 2
        yield f"a couple {plural}", size * 2


def _mixed(names: Mapping[str, Sequence[str]], sizes: Mapping[str, float]) -> Iterator[_Number]:
    """ "two feet six inches", "one meter twenty", "a minute and ten seconds"."""
    for key, (small, many) in _SMALLER.items():
        if key not in sizes or small not in sizes:
            continue
        for top, number in (("1", 1), ("2", 2), ("three", 3), ("10", 10)):
            name = names[key][0] if number == 1 else _plural(names[key])
            for rest in (6, 10, 30, 45):
                if rest >= many:
                    continue
                value = number * sizes[key] + rest * sizes[small]
                for words in (str(rest), " ".join(in_words([str(rest)]))):
                    yield f"{top} {name} {words}", value
                    yield f"{top} {name} {words} {_plural(names[small])}", value
                    yield f"{top} {name} and {words} {_plural(names[small])}", value
            yield f"{top} {name} and a half", (number + 0.5) * sizes[key]


def _plural(names: Sequence[str]) -> str:
    return names[1] if len(names) > 1 else names[0]
