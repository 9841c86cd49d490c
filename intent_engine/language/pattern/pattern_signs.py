"""What a pattern asks for and no text has any more when it is compared with what was said: signs, blanks, capitals."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

from intent_engine.language.pattern.pattern_lark import lark_tree
from intent_engine.language.pattern.pattern_regex import regex_tree
from intent_engine.language.pattern.pattern_tree import Letters, Named, OneOf, Part, Repeat, Row, Text, UnsayableError

__all__ = ["unfit_end", "unsaid_blank", "unsaid_in_lark", "unsaid_sign"]

_OF_NUMBERS = frozenset("./-,")
"""What stands in numbers and nowhere else: "2.5", "1/2", "-3"."""
_OF_WORDS = frozenset(" <>=≤≥±")
"""A space between words; and what stands beside a number of which nobody knows what it is: "< 5"."""
_SUSPECT = re.compile(r"[^\w\s()\[\]|?*+^$]")
"""A sign that is more than a bracket of the pattern. A look that costs nothing."""


_OTHER_END = re.compile(r"\\b(?:\((?:\?:|\?P?<\w+>)?)*([^\x00-\x7f])|([^\x00-\x7f])[)?]*\\b")
"""A ``\\b`` beside a letter that English has not."""


def unfit_end(text: str) -> str | None:
    """A letter beside which a pattern asks for the end of a word, where RE2 sees none; None: there is none."""
    found = _OTHER_END.search(text)
    return (found[1] or found[2]) if found else None


def unsaid_sign(text: str) -> str | None:
    """A sign that every text has which a pattern fits, and that is in nothing that is said; None: there is none, or it
    cannot be told."""
    if _SUSPECT.search(text) is None:
        return None
    try:
        return _sign(regex_tree(text), Text(""))
    except UnsayableError:
        return None


def unsaid_blank(text: str) -> bool:
    """Whether every text that a pattern fits begins or ends with a blank, or has two side by side."""
    if not re.search(r"\s", text):
        return False
    try:
        part = regex_tree(text)
    except UnsayableError:
        return False
    parts = part.parts if isinstance(part, Row) else (part,)
    written = "".join(inner.letters if isinstance(inner, Text) else "\0" for inner in parts)
    return re.search(r"^\s|\s\s|\s$", written) is not None


def unsaid_in_lark(parser: Any, slots: Collection[str]) -> str | None:
    """A text of a Lark grammar that is in nothing that is said; None: there is none, or it cannot be told."""
    for terminal in parser.terminals:
        text = str(terminal.pattern.value)
        if terminal.pattern.type == "str" and text != text.lower() and "i" not in terminal.pattern.flags:
            return text
    try:
        return _sign(lark_tree(parser, slots), Text(""))
    except UnsayableError:
        return None


def _sign(part: Part, after: Part | None) -> str | None:
    """Such a sign of a part, before another; None: it is not known what follows."""
    match part:
        case Text(letters):
            return next((sign for sign in letters if not _said(sign, after)), None)
        case Letters(letters):
            signs = sorted(letters)
            return signs[0] if not any(_said(sign, after) for sign in signs) else None
        case Row(parts):
            onward = (*parts[1:], after) if parts else ()
            return next((sign for one, other in zip(parts, onward, strict=True) if (sign := _sign(one, other))), None)
        case OneOf(parts):
            signs_of = [_sign(one, after) for one in parts]
            return signs_of[0] if all(signs_of) else None
        case Named(_, inner):
            return _sign(inner, after)
        case Repeat(inner, least, _):
            return _sign(inner, None) if least else None
    return None


def _said(sign: str, after: Part | None) -> bool:
    if sign in _OF_NUMBERS:
        return not (isinstance(after, Text) and not after.letters[:1].isdigit())
    return sign.isalnum() or sign in _OF_WORDS
