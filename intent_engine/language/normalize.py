"""What people type and recognisers write, as plain words.

The same is done to the sentences of a grammar and to what is said, so both always meet in the same form.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

from intent_engine.language.numbers.units import units
from intent_engine.language.words.thing_words import thing_words

__all__ = ["ELISION", "UNCLEAR", "Token", "elided", "plain_words", "tokenize", "without_accents", "words_of"]


class Token(NamedTuple):
    """One normalised word and where it came from."""

    word: str
    """Lower case, NFKC, without punctuation. A numeral is one word: ``2.5``, ``1/2``, ``2-1/2``, ``1200``, ``-3``."""
    start: int
    """First character in the text."""
    end: int
    """Character after the last. Words of one contraction share their place."""
    breaks: bool
    """Whether punctuation that separates clauses, or a dash, stands before."""


_NEGATED = {
    f"{verb}nt": (meant, "not")
    for verb, meant in {
        "do": "do", "wo": "will", "ca": "can", "is": "is", "are": "are", "was": "was", "were": "were", "does": "does",
        "did": "did", "should": "should", "could": "could", "would": "would", "must": "must", "need": "need",
        "have": "have", "has": "has", "had": "had", "ai": "is", "sha": "shall", "might": "might", "dare": "dare",
    }.items()
}  # fmt: skip
CONTRACTIONS: dict[str, tuple[str, ...]] = {**_NEGATED, "cannot": ("can", "not")}
"""Contractions that hide a negation. Others only lose their apostrophe ("let's" is "lets", "i'd" is "id")."""

TITLES: Mapping[str, tuple[str, ...]] = {short: (full,) for short, full in thing_words("en").titles.items()}
"""English titles, which recognisers write short: "Dr. Miller". Those of other languages are read as the grammar has
them."""

_FRACTIONS = {
    character: f" {top}/{bottom}"
    for character, top, bottom in (
        ("½", 1, 2), ("⅓", 1, 3), ("⅔", 2, 3), ("¼", 1, 4), ("¾", 3, 4), ("⅕", 1, 5), ("⅖", 2, 5), ("⅗", 3, 5),
        ("⅘", 4, 5), ("⅙", 1, 6), ("⅚", 5, 6), ("⅛", 1, 8), ("⅜", 3, 8), ("⅝", 5, 8), ("⅞", 7, 8),
    )
}  # fmt: skip

_POWERS = {"²": " squared", "³": " cubed"}
"""What is after a unit makes another of it: "2 m²" is no length of "2 m 2", which is 2.02 m."""

_ELIDED = "[cdjlmnstv]|qu|(?:jus|lors|puis|quoi)qu|(?:d?a|de|ne|su|co|que)ll|quest|dov|com|tutt|mezz"
"""French, Italian and Catalan words that lose a vowel before another: "l'entrée", "dell'ufficio" are two words each."""
_VOWEL = r"(?:[aeiouhàâäèéêëìîïòôöœùûü]|y(?![^\W\d_]))"
ELISION = re.compile(rf"(?<![\w'’])(?!(?-i:D['’`][A-Z]))({_ELIDED}|un)['’ʼ`](?={_VOWEL}|\d)", re.IGNORECASE)
"""Such a word and its apostrophe. "D'Angelo" is one word."""
_APART = re.compile(rf"(?<!\S)({_ELIDED}) (?={_VOWEL})")
_PLAIN = re.compile(r"([a-z]+(?: (?:[a-z]+|\d+(?! ?\d|[^ .!?]|\.\d)))*)[.!?]?")
"""Words, with numerals between them that are nothing but digits, as most texts of recognisers are."""
_MINUS = "-−‐‑‒–"
"""What stands straight before a number below zero: hyphens, dashes, and the sign, which may stand apart from it."""
_TOKEN = re.compile(
    rf"(?P<number>(?:(?<![\w.,])|^)(?:[{_MINUS}]|−\s+|^[-−]\s+)(?=\d|\.\d))?"
    r"(?:(?P<mixed>\d+(?:\s*-\s*|\s+)\d+\s?[/⁄]\s?\d+(?![\d/]))"
    r"|(?P<fraction>(?<![/\d])\d+[/⁄]\d+(?![\d/]))"
    r"|(?P<apart>(?<![\d.,])[1-9]\d{0,2}(?: \d{3}){2,}(?![.,]?\d| \d))"
    r"|(?P<ordinal>\d+(?:,\d{3})*(?:st|nd|rd|th)(?![^\W_]))"
    r"|(?P<comma>(?<![\d.,])(?:0,\d+|\d+,(?:\d{1,2}|\d{4,}))(?![\d.,]*\d))"
    r"|(?P<pointed>(?<![\d.,])[1-9]\d{0,2}(?:(?:\.\d{3})+,\d+|(?:\.\d{3}){2,})(?![.,]?\d))"
    r"|(?P<grouped>\d{1,3}(?:,\d{3})+(?:\.\d+)?(?!\d))"
    r"|(?P<decimal>(?<!\d\.)\d+\.\d+(?!\.?\d)|(?<![\w.])\.\d+|\d+))"
    r"|(?P<letters>(?<![^\W_]|[.])(?:[^\W\d_]\.){2,}(?![^\W_]{2})[^\W\d_]?(?![^\W_]))"
    r"|(?P<unclear>(?<!\S),\d+(?![.,]?\d))"
    r"|(?P<sign>''|’’|′′|[°º%&'’′\"”″/])"
    r"|(?P<word>[^\W\d_]+(?:['’ʼ`][^\W\d_]+)*)"
    r"|(?P<compared>(?<![^\W\d_])(?:[<>]=?|[≤≥±]|\+/?-)(?=\s*\.?\d))"
    r"|(?P<pause>[,.;:!?…–—]|(?<=\s)-+(?=\s)|--+|\n)",
)

_QUOTES = ('"“”„', "'‘’‚")
"""Signs that begin and end a quotation, each kind with its own."""

_NO_APOSTROPHES = dict.fromkeys(map(ord, "'’ʼ`"))

_BREAK = "\N{ZERO WIDTH SPACE}"
"""Stands between words where nobody writes blanks."""
_ONE_GROUP = re.compile(r"[1-9]\d{0,2}([.,])\d{3}")
_CLOCK = re.compile(r"\d:\d")
UNCLEAR = "?"
"""Ends the word of a number that could be a thousand times as much. No such word has a value."""


def plain_words(text: str) -> list[str] | None:
    """The words of a text that is nothing but ASCII words and numerals, single spaces and a sign that ends a sentence;
    None for any other text.

    The short way for what a recogniser or another program hands over; the same as :func:`tokenize` where it answers.
    """
    plain = _PLAIN.fullmatch(text.lower()) if text.isascii() else None
    if plain is None:
        return None
    words = plain[1].split(" ")
    return words if CONTRACTIONS.keys().isdisjoint(words) and TITLES.keys().isdisjoint(words) else None


def words_of(text: str, language: str = "en") -> tuple[str, ...]:
    """The normalised words of any text, without their places; ``language`` as for :func:`tokenize`."""
    plain = plain_words(text)
    return tuple(token.word for token in tokenize(text, language)) if plain is None else tuple(plain)


def tokenize(text: str, language: str = "en") -> tuple[Token, ...]:
    """The normalised words of any text, in order. Never raises; linear in the text.

    Args:
        text: what was typed or recognised.
        language: whose custom of writing "1.500" and "1,500" holds.
    """
    source, places = text, None
    if not text.isascii():
        source, places = _composed(text)
    source = ELISION.sub(r"\1 ", source)
    lowered = source.lower()
    if len(lowered) != len(source):  # a few letters grow when lowered ("İ"); places would shift
        lowered = "".join(c.lower() if len(c.lower()) == 1 else c for c in source)
    tokens: list[Token] = []
    breaks = False
    title = -1
    titles = _titles_begin(language)
    for match in _TOKEN.finditer(lowered):
        kind = match.lastgroup
        start, end = match.span()
        if kind == "pause":
            # None is the full stop of "Dr.", nor the colon of "11:30".
            none = lowered[start] == "." if start == title else _CLOCK.fullmatch(lowered, start - 1, end + 1)
            breaks = breaks or not none
            continue
        title = end if match.group() in titles else -1
        for word in _words(match, kind, lowered, tokens, language):
            if places is not None:
                tokens.append(Token(word, places[start], places[end - 1] + 1, breaks))
            else:
                tokens.append(Token(word, start, end, breaks))
            breaks = False
    return tuple(tokens)


@cache
def _titles_begin(language: str) -> frozenset[str]:
    """Words of titles, behind which a full stop is no pause."""
    return frozenset(short.split()[0] for short in thing_words(language).titles)


def elided(text: str, language: str | None) -> str:
    """Normalised words as French, Italian and Catalan are written: "à l'entrée" of "à l entrée"."""
    return _APART.sub(r"\1'", text) if language in ("fr", "it", "ca") else text


def without_accents(word: str) -> str:
    """A word with plain letters: "jose" of "josé"."""
    if word.isascii():
        return word
    return "".join(letter for letter in unicodedata.normalize("NFKD", word) if not unicodedata.combining(letter))


def _composed(text: str) -> tuple[str, list[int]]:
    """NFKC, with fractions as digits, and the place in the source of every character."""
    pieces: list[str] = []
    places: list[int] = []
    for place, character in enumerate(text):
        piece = _FRACTIONS.get(character) or _POWERS.get(character) or (character if character in "°ºª″′" else None)
        if piece is None and character in "\u00a0\u202f\u2009" and text[place - 1 : place].isdigit():
            piece = "" if text[place + 1 : place + 4].isdigit() and place else " "  # thousands, set apart
        if piece is None and character != _BREAK and unicodedata.category(character) == "Cf":
            piece = ""  # marks of direction, soft hyphens, joiners: pasted with a text, and seen and said by nobody
        if piece is None:
            piece = unicodedata.normalize("NFKC", character)
        pieces.append(piece)
        places.extend([place] * len(piece))
    joined = "".join(pieces)
    composed = unicodedata.normalize("NFC", joined)
    if len(composed) != len(joined):  # accents written as marks of their own: places of the text are then unknown
        return composed, [min(place, len(text) - 1) for place in range(len(composed))]
    return joined, places


def _words(match: re.Match[str], kind: str | None, text: str, before: list[Token], language: str) -> tuple[str, ...]:
    found = match.group()
    if kind == "letters":  # "T.V.", "U.S.B"
        return (found.replace(".", ""),)
    if kind == "word":
        word = found.translate(_NO_APOSTROPHES)
        return (TITLES.get(word) if language == "en" else None) or CONTRACTIONS.get(word, (word,))
    if kind == "compared":  # "< 5" is not 5, whatever it is
        return (found,)
    if kind == "unclear":
        return (found + UNCLEAR,)
    if kind == "sign":
        return _sign(found, text, match.start(), before, language)
    if kind == "mixed":
        whole, top, bottom = re.findall(r"\d+", found)
        number = f"{whole}-{top}/{bottom}"
    else:
        number = _number(found.lstrip(f"{_MINUS} "), kind, language)
    if number.startswith("."):
        number = "0" + number
    # "75 -300 mm" is a range, and no number below zero.
    start = match.start()
    negative = match.group("number") and not (start > 1 and text[start - 1].isspace() and text[start - 2].isdigit())
    return ("-" + number if negative else number,)


def _number(written: str, kind: str | None, language: str) -> str:
    """A number in digits with a decimal point and nothing else; or as it is written, and :data:`UNCLEAR`."""
    if kind in ("grouped", "decimal") and (group := _ONE_GROUP.fullmatch(written)) is not None:
        sign = group[1]
        table = units(language)
        meant = table.figures.get(sign) if table is not None else None
        return written + UNCLEAR if meant is None else written.replace(sign, meant)
    if kind == "pointed":
        return written.replace(".", "").replace(",", ".")
    if kind == "apart":  # "1 414 021 100"; but "1 500" may be two numbers
        return written.replace(" ", "")
    if kind in ("grouped", "ordinal"):
        return written.replace(",", "")
    if kind == "comma":
        return written.replace(",", ".")
    return written.replace("⁄", "/")


def _unit_beside(text: str, place: int, before: list[Token]) -> bool:
    """Whether a stroke stands apart between two units, as in "0.5 m / s"."""
    counted = len(before) > 1 and before[-2].word[-1].isdigit() and not before[-1].word[-1].isdigit()
    return counted and text[place - 1 : place + 2] == " / " and text[place + 2 : place + 3].isalpha()


def _sign(sign: str, text: str, place: int, before: list[Token], language: str) -> tuple[str, ...]:
    touching = place > 0 and not text[place - 1].isspace()
    after = text[place + 1 : place + 2]
    number_before = touching and bool(before) and before[-1].word[-1].isdigit() and text[place - 1].isdigit()
    if sign in "°º":
        return ("degrees",)
    if sign == "%":
        return ("percent",)
    if sign == "&":
        table = units(language)  # "R&D", "turn left & stop"
        return tuple(sorted(table.words.get("and", ()))[:1]) if table is not None else ()
    if sign == "/":
        between = touching and (text[place - 1].isalpha() or text[place - 1] in "°º") and after.isalpha()
        if before and before[-1].word in ("pi", "π") and text[place + 1 :].lstrip()[:1].isdigit():
            return ("over",) if language == "en" else ()  # "pi/2"
        return ("per",) if between or _unit_beside(text, place, before) else ()
    if not number_before or _closes_a_quotation(sign, text, place):
        return ()
    if sign in ("'", "’", "′"):  # two of them are inches
        return ("feet",) if not after.isalpha() else ()
    return ("inches",)


def _closes_a_quotation(sign: str, text: str, place: int) -> bool:
    """Whether a sign behind a number ends what was begun with such a sign ('"go forward 2"'), and is no unit. Of two,
    the second does."""
    alike = next((family for family in _QUOTES if sign in family), "")
    if not alike or text[place + 1 : place + 2] in tuple(alike):
        return False
    for before in range(place - 1, -1, -1):
        if text[before] in alike:
            opens = not text[before - 1 : before].isalnum()
            if opens or not (text[before - 1].isalpha() and text[before + 1].isalpha()):  # "don't" holds none
                return opens
    return False
