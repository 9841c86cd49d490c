"""English words of numbers."""

from __future__ import annotations

__all__ = [
    "DIGITS",
    "HALVES",
    "NUMBER_WORDS",
    "ORDINAL_SCALES",
    "ORDINAL_TENS",
    "ORDINAL_UNITS",
    "SCALES",
    "SIGNS",
    "SMALL",
    "SUFFIXES",
    "TEENS",
    "TENS",
    "ZERO",
]

DIGITS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9}
TEENS = {
    "ten": 10, "eleven": 11, "twelve": 12, "thirteen": 13, "fourteen": 14, "fifteen": 15, "sixteen": 16,
    "seventeen": 17, "eighteen": 18, "nineteen": 19,
}  # fmt: skip
TENS = {
    "twenty": 20, "thirty": 30, "forty": 40, "fourty": 40, "fifty": 50, "sixty": 60, "seventy": 70, "eighty": 80,
    "ninety": 90,
}  # fmt: skip
ZERO = frozenset(("zero", "oh", "o", "nought", "naught", "nil"))
SCALES = {
    "thousand": 1e3, "thousands": 1e3, "lakh": 1e5, "lakhs": 1e5, "million": 1e6, "millions": 1e6, "mln": 1e6,
    "crore": 1e7, "crores": 1e7, "billion": 1e9, "billions": 1e9, "bln": 1e9, "trillion": 1e12, "trillions": 1e12,
    "tln": 1e12,
}  # fmt: skip
SUFFIXES = {"k": 1e3}
"""Signs that scale a numeral: "10 k". Others are units: "10 m" are ten meters, "5 g" five grams, "2 t" two tons."""
ORDINAL_UNITS = {
    "first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "seventh": 7, "eighth": 8, "ninth": 9,
    "tenth": 10, "eleventh": 11, "twelfth": 12, "thirteenth": 13, "fourteenth": 14, "fifteenth": 15, "sixteenth": 16,
    "seventeenth": 17, "eighteenth": 18, "nineteenth": 19,
}  # fmt: skip
ORDINAL_TENS = {
    "twentieth": 20, "thirtieth": 30, "fortieth": 40, "fiftieth": 50, "sixtieth": 60, "seventieth": 70,
    "eightieth": 80, "ninetieth": 90,
}  # fmt: skip
ORDINAL_SCALES = {"hundredth": 1e2, "thousandth": 1e3, "millionth": 1e6, "billionth": 1e9, "trillionth": 1e12}
HALVES = {"half": 2.0, "halves": 2.0, "halfs": 2.0, "quarter": 4.0, "quarters": 4.0}

SIGNS = frozenset(("minus", "negative", "plus"))
"""Before a number they say on which side of zero it is."""

SMALL = {**DIGITS, **TEENS, **TENS}
DOZENS = ("dozen", "dozens")
"""The noun that counts: what is said of it is said in one piece, "two dozen"."""
NUMBER_WORDS = frozenset(
    (
        *SMALL,
        *ZERO,
        *SCALES,
        "hundred",
        "hundreds",
        *DOZENS,
        "point",
        "half",
        "quarter",
        "quarters",
        "minus",
        "plus",
    )
)
