"""A regular expression as what may be said: for hearing it, and looking ahead. RE2 alone says what it means."""

from __future__ import annotations

import itertools
import re
from functools import cache
from importlib.resources import files
from typing import Any

from intent_engine.language.pattern.pattern_tree import (
    DIGITS,
    LETTERS,
    Letters,
    Named,
    OneOf,
    Part,
    Row,
    Text,
    UnsayableError,
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

    grammar = files("intent_engine.language.pattern").joinpath("pattern_regex.lark").read_text("utf-8")
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
    return _letters(node)


def _one(kind: type[OneOf] | type[Row], parts: list[Part]) -> Part:
    return parts[0] if len(parts) == 1 else kind(tuple(parts))


def _times(node: Any, signs: list[str]) -> Part:
    part = _part(node)
    for sign in signs:
        part = repeated(part, *_counts(sign))
    return part


def _counts(sign: str) -> tuple[int, int | None]:
    if sign[0] in "?*+":
        return int(sign[0] == "+"), 1 if sign[0] == "?" else None
    least, _, most = sign.rstrip("?")[1:-1].partition(",")
    return int(least), int(most) if most else None if "," in sign else int(least)


def _letters(node: Any) -> Part:
    """Any one of the letters of a class; nothing, where it stands for no letter."""
    kind = str(node.data)
    if kind == "anything":
        return Letters(_ANY)
    sign = str(node.children[0])
    found = _escaped(sign[1]) if kind == "escape" else _members(sign[1:-1])
    return Letters(found) if found else Text("")


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
    letters = frozenset(" " if letter.isspace() else letter.lower() for letter in found)
    return _ANY - letters if others else letters
