"""A regular expression as what may be said: for hearing it, and looking ahead. RE2 alone says what it means."""

from __future__ import annotations

import itertools
import re
from functools import cache
from importlib.resources import files
from typing import Any

from intent_engine.language.pattern_tree import (
    DIGITS,
    LETTERS,
    Named,
    OneOf,
    Part,
    Row,
    Text,
    UnsayableError,
    of_letters,
    repeated,
)

__all__ = ["regex_tree"]

DEEPEST = 40
"""Brackets within each other."""
_ANY = LETTERS | DIGITS | {" "}
_CLASSES = {
    **dict.fromkeys("tnrfv", frozenset(" ")),
    "d": DIGITS,
    "w": LETTERS | DIGITS,
    "s": frozenset(" "),
    "S": LETTERS | DIGITS,
    "D": LETTERS | {" "},
}
_NOTHING = frozenset("bBAzZQE")
"""Escapes that stand for no letter."""
_MEMBER = re.compile(r"\\(.)|(.)-([^\]\\])|(.)", re.DOTALL)


def regex_tree(text: str) -> Part:
    """What a pattern may be said as.

    Raises:
        UnsayableError: it cannot be told.
    """
    from lark.exceptions import LarkError

    if _depth(text) > DEEPEST:
        raise UnsayableError(f"more than {DEEPEST} brackets within each other")
    try:
        return _part(_parser().parse(text))
    except (LarkError, RecursionError) as error:
        raise UnsayableError("a kind of pattern that is not known") from error


@cache
def _parser() -> Any:
    from lark import Lark

    grammar = files("intent_engine.language").joinpath("pattern_regex.lark").read_text("utf-8")
    return Lark(grammar, parser="lalr")


def _depth(text: str) -> int:
    """Brackets within each other, at most."""
    return max(itertools.accumulate((sign == "(") - (sign == ")") for sign in text), default=0)


def _part(node: Any) -> Part:
    match str(node.data):
        case "start" | "group":
            return _part(node.children[-1])
        case "choice":
            return _one(OneOf, [_part(child) for child in node.children])
        case "row":
            return _one(Row, [_part(child) for child in node.children])
        case "named":
            begin, inner = node.children
            return Named(str(begin).split("<")[1].rstrip(">"), _part(inner))
        case "times":
            return _times(node.children[0], [str(sign) for sign in node.children[1:]])
        case "sign":
            return Text(str(node.children[0]).lower())  # as all that is said
        case "nothing":
            return Text("")
    letters = _letters(node)
    return Text("") if not letters else of_letters(letters) if len(letters) > 1 else Text(*letters)


def _one(kind: type[OneOf] | type[Row], parts: list[Part]) -> Part:
    return parts[0] if len(parts) == 1 else kind(tuple(parts))


def _times(node: Any, signs: list[str]) -> Part:
    letters = _letters(node)
    part: Part = Text("") if letters is not None else _part(node)
    if letters is None and isinstance(part, OneOf):
        letters = _alphabet(part)  # "(?:[0-9]|x)+"
    if letters and all(map(str.isspace, letters)):
        letters = frozenset(" ")
    for sign in signs:
        least, most = _counts(sign)
        single = letters is not None and (most is None or most > 1 or letters == frozenset(" "))
        if letters is not None and not single:
            part = of_letters(letters)
        part = repeated(part, least, most, letters if single else None)
        letters = None
    return part


def _alphabet(part: Part) -> frozenset[str] | None:
    """The letters of which a part is any one; None: it is more."""
    if isinstance(part, Text):
        return frozenset(part.letters) if len(part.letters) == 1 else None
    found = [_alphabet(one) for one in part.parts] if isinstance(part, OneOf) else [None]
    return frozenset().union(*(one for one in found if one is not None)) if None not in found else None


def _counts(sign: str) -> tuple[int, int | None]:
    if sign[0] in "?*+":
        return int(sign[0] == "+"), 1 if sign[0] == "?" else None
    least, _, most = sign.rstrip("?")[1:-1].partition(",")
    return int(least), int(most) if most else None if "," in sign else int(least)


def _letters(node: Any) -> frozenset[str] | None:
    """Which letters one may be; none: it stands for no letter; None: it is no single letter."""
    kind = str(node.data)
    if kind == "anything":
        return frozenset(_ANY)
    if kind == "escape":
        return _escaped(str(node.children[0])[1])
    return _members(str(node.children[0])[1:-1]) if kind == "letters" else None


def _escaped(sign: str) -> frozenset[str]:
    if sign in _NOTHING:
        return frozenset()
    if sign.isalnum() and sign not in _CLASSES:
        raise UnsayableError(f"\\{sign}")
    return frozenset(_CLASSES.get(sign, sign))


def _members(inside: str) -> frozenset[str]:
    """The letters of a class, without its brackets."""
    others = inside.startswith("^")
    found: set[str] = set()
    for escaped, first, last, one in _MEMBER.findall(inside[others:]):
        if escaped:
            found |= _escaped(escaped)
        elif one:
            found.add(one)
        else:
            found.update(map(chr, range(ord(first), ord(last) + 1)))
    letters = frozenset(map(str.lower, found))
    return frozenset(_ANY - letters if others else letters)
