"""Units as people say and write them, with their size in SI."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache

from intent_engine.language.language_files import Keys, language_file

__all__ = ["SIGNS", "Units", "units"]

SIGNS = ("degrees", "percent")
"""What signs are read as, "45°", in every language."""

FACTORS: Mapping[str, Mapping[str, float]] = {
    "distance": {
        "um": 1e-6, "mm": 1e-3, "cm": 1e-2, "dm": 0.1, "m": 1.0, "dam": 10.0, "hm": 100.0, "km": 1000.0,
        "in": 0.0254, "ft": 0.3048, "yd": 0.9144, "mi": 1609.344, "nmi": 1852.0,
    },
    "duration": {
        "us": 1e-6, "ms": 1e-3, "s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0, "wk": 604800.0,
        "fortnight": 1209600.0, "quarter_hour": 900.0, "half_hour": 1800.0, "three_quarter_hour": 2700.0,
    },
    "angle": {
        "deg": math.pi / 180, "rad": 1.0, "mrad": 1e-3, "turn": 2 * math.pi, "arcmin": math.pi / 10800,
        "right_angle": math.pi / 2, "half_turn": math.pi,
    },
    "percent": {"percent": 0.01},
}  # fmt: skip
"""Unit -> SI. International yard and pound agreement of 1959 for inch, foot, yard and mile; BIPM for the rest. None is
a word for another unit in any language: a German "grad" is a degree, so gradians are not here."""

RATES: Mapping[str, Mapping[str, float]] = {
    "speed": {"mps": 1.0, "kmh": 1 / 3.6, "mph": 0.44704, "knot": 1852 / 3600, "fps": 0.3048},
    "angular_speed": {"rpm": 2 * math.pi / 60, "rps": 2 * math.pi, "dps": math.pi / 180},
}
"""Rates that are said in one word. Others are a distance or angle "per" or "a" duration."""


LONGEST = 4
"""Words of a unit."""
_WORDS = frozenset((
    "added", "all_of_it", "and", "and_part", "and_smaller", "another", "billion", "every", "every_other",
    "half",
    "half_of_it", "halves", "last", "level", "million", "minus", "more", "more_after", "no_number", "nth", "number",
    "of", "of_a_clock", "one", "ones_first",
    "over", "per", "point", "pointing", "power", "quarter", "second", "speed", "temperature", "the", "thousand", "two",
    "vague",
))  # fmt: skip
"""The lists of function words."""
KEYS: Keys = {
    "units": {kind: sizes.keys() for kind, sizes in {**FACTORS, **RATES}.items()}, "words": _WORDS,
    "parts": None, "nouns": None, "joined": None, "speeds": None, "whole_angles": None,
    "respelled": None, "respelled_parts": None, "alike": None, "figures": {",", "."}, "symbols": None,
}  # fmt: skip
"""What a file may hold,"""
NEEDED: Mapping[str, Collection[str]] = {"units": (), "words": ("one", "of", "and", "per")}
"""and what it has to."""


@dataclass(frozen=True)
class Units:
    """The unit words of one language."""

    by_kind: Mapping[str, Mapping[tuple[str, ...], float]]
    """Kind -> spoken words -> SI factor."""
    names: Mapping[tuple[str, ...], str]
    """Spoken words -> unit key ("m")."""
    words: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Function words: ``one`` (a, an), ``half``, ``quarter``, ``and``, ``of``, ``per``, ``point``."""

    point: str = ""
    """What is mostly said for the point of a number, of several words for it."""
    joined: Mapping[tuple[str, ...], str] = field(default_factory=dict)
    """What is said apart, and how a number begins that has it in one word: "veinte y", "veinti"."""
    speeds: Mapping[str, float] = field(default_factory=dict)
    """Speeds in terms of the usual one, as factors of it: "slowly" -> 0.5."""
    whole_angles: Mapping[tuple[str, ...], float] = field(default_factory=dict)
    """Angles that are said without a number, in rad: "about face"."""
    respelled: Mapping[str, str] = field(default_factory=dict)
    """Spellings of numbers that text2num does not know, as it knows them,"""
    respelled_parts: Mapping[str, str] = field(default_factory=dict)
    """and the same anywhere in a word without accents: "fuenf"."""
    alike: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Numbers that are taken for each other when they are heard, each with the others."""
    figures: Mapping[str, str] = field(default_factory=dict)
    """What a sign stands for that is followed by exactly three figures and could divide thousands or decimals; what is
    not here is unclear."""
    symbols: tuple[tuple[str, ...], ...] = ()
    """Names of one unit of any kind that may be written for each other behind a number: "kg", "kilograms"."""
    parts: Mapping[tuple[str, bool], float] = field(default_factory=dict)
    """A part of one, as it is called where there is one of it, or not: ("terzi", False) -> 3."""

    nouns: Mapping[str, float] = field(default_factory=dict)
    """Nouns that are numbers, behind how many of them there are: "dozzina" -> 12."""

    @property
    def parts_of_one(self) -> frozenset[str]:
        """Words for parts of one that stand behind an article: "half", "quarter"."""
        return self.words.get("half", frozenset()) | self.words.get("quarter", frozenset())

    def unit_at_end(self, words: Sequence[str]) -> tuple[str, int] | None:
        """The unit that some words end with, the longest, and where it begins; None: they end with no unit."""
        for begin in range(max(0, len(words) - LONGEST), len(words)):
            if (unit := self.names.get(tuple(words[begin:]))) is not None:
                return unit, begin
        return None

    def first_name(self, word: str) -> str:
        """The usual name of a unit for a name of it, where it is one word: "grad" for the "degrees" of a sign. The same
        of what is no unit."""
        key = self.names.get((word,))
        return next((name for (name, *more), other in self.names.items() if other == key and not more), word)

    def spoken(self, kind: str, *more: str) -> str:
        """All words of a kind as one template, and more words."""
        return "(" + "|".join((*(" ".join(words) for words in self.by_kind.get(kind, {})), *more)) + ")"


@cache
def units(language: str) -> Units | None:
    """The units of a language, from ``<language>.yaml``; None if there is no such file.

    Raises:
        ConfigError: the file has keys that nobody reads, or lacks words without which no quantity is read.
    """
    data = language_file("numbers", language, KEYS, NEEDED)
    if data is None:
        return None
    by_kind: dict[str, dict[tuple[str, ...], float]] = {}
    names: dict[tuple[str, ...], str] = {}
    for kind, rows in data.get("units", {}).items():
        factors = {**FACTORS.get(kind, {}), **RATES.get(kind, {})}
        for key, spellings in rows.items():
            for spelling in spellings:
                words = tuple(str(spelling).split())
                by_kind.setdefault(kind, {})[words] = factors[key]
                names[words] = key
    function_words = {key: frozenset(str(item) for item in items) for key, items in data.get("words", {}).items()}
    parts = {
        (word, place == 0): float(number)
        for number, forms in data.get("parts", {}).items()
        for place, word in enumerate((forms[0], forms[-1]))
    }
    joined = {tuple(apart.split()): begin for apart, begin in data.get("joined", {}).items()}
    point = next(iter(data.get("words", {}).get("point", ())), "")
    speeds = {said: float(factor) for factor, ways in data.get("speeds", {}).items() for said in ways}
    whole = {
        tuple(said.split()): float(turns) * FACTORS["angle"]["turn"]
        for turns, ways in data.get("whole_angles", {}).items()
        for said in ways
    }
    pairs: list[list[str]] = data.get("alike", [])
    alike = {
        word: tuple(other for pair in pairs if word in pair for other in pair if other != word)
        for word in dict.fromkeys(word for pair in pairs for word in pair)
    }
    return Units(
        by_kind,
        names,
        function_words,
        point,
        joined,
        speeds,
        whole,
        respelled=data.get("respelled", {}),
        respelled_parts=data.get("respelled_parts", {}),
        alike=alike,
        figures=data.get("figures", {}),
        symbols=tuple(map(tuple, data.get("symbols", ()))),
        parts=parts,
        nouns={noun: float(value) for value, forms in data.get("nouns", {}).items() for noun in forms},
    )
