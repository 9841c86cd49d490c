"""What looks like a quantity in running text and is none, or another than a look at its words would give."""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal

from intent_engine.language.normalize import Token
from intent_engine.language.numbers import english_ordinals, foreign_ordinals
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.quantity_parser import PI, parser_of
from intent_engine.language.numbers.units import Units, units
from intent_engine.language.numbers.vague import vague_length

__all__ = ["clause_ends", "exponents_joined", "no_amount", "of_another_unit"]

_EXPONENT = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([-+−]?\d{1,2})(?![\d.]*\d|[^\W\d_])", re.IGNORECASE)
""" "2.5e-3": times ten to that power."""
_WRITTEN = re.compile(
    r"(?<![\w.,:/])(?:\d{1,2}(?::\d\d){1,2}"  # a time
    r"|\d+(?:\.\d+)?(?:\s?[x×*]\s?10)?\^[-+−]*\d+(?:\.\d+)?"  # a power
    r"|\d{1,3}(?:['’]\d{3})+|\d{1,3} \d{3}(?! \d)"  # thousands, or two numbers
    r"|\d+(?:\.\d+)?\s?[°º]\s?\d+(?:\.\d+)?\s?['’′](?:\s?\d+(?:\.\d+)?\s?(?:[\"”″]|''))?"  # no feet after degrees
    r")(?![.,:]?\d)"
)
"""Figures that are no number, or one of several."""
_SCALES = frozenset(("thousand", "million", "billion", "trillion"))
_ROUND = frozenset((12.0, 100.0, 1e3, 1e6, 1e9))
"""Numbers of which there may be "a few"."""
_STEPS = re.compile(r"\s*,\s*|\.\s+(?![^\W\d_]*[A-Z])")
"""What may stand between the parts of one quantity, behind a unit: "7 feet, 10 inches", "5 ft. 6 in."."""
_DASH = re.compile(r"\s*[-–—]\s*")


def exponents_joined(tokens: Sequence[Token], text: str) -> list[Token]:
    """The words of a text, with a number that is written with a power of ten as one: "2.5e-3" is 0.0025."""
    joined = list(tokens)
    for match in _EXPONENT.finditer(text):
        inside = [
            place for place, token in enumerate(joined) if match.start() < token.end and token.start < match.end()
        ]
        if len(inside) != 3:
            continue
        first = joined[inside[0]]
        exponent = int(match[2].replace("−", "-"))
        if not is_numeral(first.word) or abs(exponent) > 15:
            continue
        value = f"{Decimal(first.word).scaleb(exponent):f}"
        joined[inside[0] : inside[-1] + 1] = [Token(value, first.start, match.end(), first.breaks)]
    return joined


def clause_ends(tokens: Sequence[Token], text: str, language: str) -> list[int]:
    """For every word the place where no quantity that begins there goes on: the next that begins a sentence, or that a
    sign parts from the word before it."""
    ends = [len(tokens)] * len(tokens)
    for place in range(len(tokens) - 1, 0, -1):
        ends[place - 1] = place if _parted(tokens, place, text, language) else ends[place]
    return ends


def _parted(tokens: Sequence[Token], place: int, text: str, language: str) -> bool:
    if not tokens[place].breaks:
        return False
    table = units(language) or Units({}, {})
    between = text[tokens[place - 1].end : tokens[place].start]
    before = tokens[place - 1].word
    if _DASH.fullmatch(between):  # "fifty - two", but "10 m - 20 m"
        return is_numeral(tokens[place].word) or (before,) in table.names
    joined = tokens[place].word in table.words.get("and", ())
    if not joined and (before,) in table.names:
        joined = _counts_a_unit([token.word for token in tokens[place : place + 8]], language, table)
    goes_on = (joined or before in _SCALES) and _STEPS.fullmatch(between) is not None
    return not goes_on or (between[0] == "." and text[tokens[place].start].isupper())


def _counts_a_unit(words: Sequence[str], language: str, table: Units) -> bool:
    """Whether words begin with a number and its unit: "3 inches" after "4 feet,", but not "3 boxes"."""
    ends = [end for _, end in parser_of(language).counts_at(words, 0)]
    return any(end < len(words) and any(unit[0] == words[end] for unit in table.names) for end in ends)


def no_amount(words: Sequence[str], at: int, tokens: Sequence[Token], text: str, language: str) -> int:
    """Where words end that say no number though they look like one; the place itself: they may say one.

    Args:
        words: of the text up to the end of the clause.
        at: where they begin.
        tokens: of all words.
        text: which they are of.
        language: of it.
    """
    return (
        _written(at, tokens, text)
        or _vague(words, at, language)
        or _of_pi(words, at, language)
        or _ordinal(words, at, language)
        or _many_parts(words, at, language)
        or (at + 1 if _counts_nothing(words, at, language) else at)
    )


def _written(at: int, tokens: Sequence[Token], text: str) -> int:
    """Where figures end that are no number: "4:13", "10^6", "1'500"."""
    if not tokens[at].word[-1].isdigit():
        return 0
    match = _WRITTEN.match(text, tokens[at].start + (text[tokens[at].start] in "-−"))
    if match is None:
        return at + 1 if text[tokens[at].start - 1 : tokens[at].start] == "^" else 0
    after = at + 1
    while after < len(tokens) and tokens[after].start < match.end():
        after += 1
    return after


def _vague(words: Sequence[str], at: int, language: str) -> int:
    length = vague_length(words, at, language)
    if not length:
        return 0
    after = at + length
    for value, end in parser_of(language).numbers_at(words, after):
        if value in _ROUND and end == after + 1 and not is_numeral(words[after]):
            return end  # "a few hundred"
    return after


def _of_pi(words: Sequence[str], at: int, language: str) -> int:
    """Where "two pi", "pi over four" end, if no unit says that they are an angle."""
    parser = parser_of(language)
    begins = [at, *(end for _, end in parser.numbers_at(words, at))]
    here = next((begin for begin in begins if begin < len(words) and words[begin] in PI), None)
    if here is None or next(parser.quantities_at(words, at, "angle"), None) is not None:
        return 0
    after = here + 1
    known = (units(language) or Units({}, {})).words
    if after < len(words) and words[after] in known.get("over", ()):
        after += 1
    elif after < len(words) and words[after] not in known.get("half", ()):
        return after
    return max((end for _, end in parser.numbers_at(words, after)), default=here + 1)


def _ordinal(words: Sequence[str], at: int, language: str) -> int:
    """Where an ordinal of several words ends that begins with a number: "twenty first"."""
    if is_numeral(words[at]):
        return 0  # "90°" is none, though a "3º" is
    number = max((end for _, end in parser_of(language).numbers_at(words, at)), default=0)
    for end in range(min(len(words), number + 2), number, -1) if number else ():
        said = words[at:end]
        ordinal = english_ordinals.ordinal(said) if language == "en" else foreign_ordinals.ordinal(said, language)
        if ordinal is not None:
            return end if said[-1] != "second" or said[-2] == "and" else 0  # "thirty second" may be a time
    return 0


def _many_parts(words: Sequence[str], at: int, language: str) -> int:
    """Where more parts than a whole has end in another language than English, for which there is no value: "veinte
    quintos" is no twenty. Of quarters there may be as many: they are also rooms."""
    table = units(language)
    if language == "en" or table is None:
        return 0
    end = max((end for _, end in parser_of(language).numbers_at(words, at)), default=len(words))
    parts = end < len(words) and (words[end], False) in table.parts and words[end] not in table.words.get("quarter", ())
    return end + 1 if parts else 0


def _counts_nothing(words: Sequence[str], at: int, language: str) -> bool:
    """Whether a word that may be a number is none between its neighbours: "that one", "oh", "half past", ",5"."""
    before, after = words[at - 1] if at else "", words[at + 1] if at + 1 < len(words) else ""
    known = (units(language) or Units({}, {})).words
    if language != "en":
        points = known.get("point", frozenset())
        return before in points and next(parser_of(language).numbers_at(words, at), None) is not None
    if words[at] in ("oh", "o"):
        return after != "point"
    if words[at] in ("half", "quarter"):
        return after in known["of_a_clock"]
    if words[at] != "one" or not (before in known["pointing"] or (before == "the" and not after)):
        return False
    parser = parser_of(language)
    return all(next(parser.quantities_at(words, at, kind), None) is None for kind in ("distance", "duration", "angle"))


def of_another_unit(
    words: Sequence[str], after: int, kind: str, tokens: Sequence[Token], text: str, language: str
) -> int:
    """Where a quantity goes on that is no length, speed or angle though it begins as one: "4 km squared", "9.8 m/s2",
    "30 degrees Celsius"; 0: it ends where it does.

    Args:
        words: all of the text.
        after: the place after the quantity.
        kind: what it is so far.
        tokens: of all words.
        text: which they are of.
        language: of it.
    """
    end = tokens[after - 1].end
    following = words[after] if after < len(words) else ""
    touches = after < len(words) and tokens[after].start == end
    if text[end : end + 1] == "^" or (touches and following in ("2", "3") and text[end - 1].isalpha()):
        return after + 1
    if after == len(words) or tokens[after].breaks or kind in ("duration", "percent"):
        return 0
    table = units(language) or Units({}, {})
    powers = table.words.get("power", ())
    if following in powers or (kind == "angle" and following in table.words.get("temperature", ())):
        return after + 1
    if (
        following in table.words.get("per", ())
        and following not in table.words.get("one", ())
        and after + 1 < len(words)
    ):
        again = kind in ("speed", "angular_speed") and table.names.get((words[after + 1],)) in ("s", "min", "h")
        if again or words[after + 1] in powers:  # "per second per second", "per square second"
            return after + 2
    return 0
