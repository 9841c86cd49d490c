"""Sentence templates without a mistake, read in one pass.

Loading Lark and building its parser takes longer than all the rest of a grammar's start, and nearly every template that
is loaded has no mistake. This reader knows the same language as ``template.lark`` and answers None for anything that
is not in it: then Lark reads the template, and says where it is wrong. Where it does answer, Lark reads the same (a
property in the tests).
"""

from __future__ import annotations

import re
from functools import lru_cache

from intent_engine.language.normalize import words_of
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
)

__all__ = ["MAX_ANY_ORDER", "read_template"]

MAX_ANY_ORDER = 6
"""Parts of an any-order group: the automaton keeps a state for each subset of them."""

_LETTERS = r"A-Za-z_\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u02af\u0370-\u1fff\u3040-\u30ff\u4e00-\u9fff\uac00-\ud7af"
"""Also of other languages: a German slot may be called "größe"."""
_NAME = rf"[{_LETTERS}][{_LETTERS}0-9]*"
_PIECE = re.compile(
    rf"\s*(?:([^\s()\[\]{{}}|;]+)|([()\[\]|;])|\{{\s*(?:({_NAME})\s*(?::\s*({_NAME})\s*)?|(#(?:word)?)\s*)\}})\s*"
)
"""A word; or a sign; or a name and the name it is given; or a class of words."""
_WORD, _SIGN, _REFERENCE, _LABEL, _CLASS = 1, 2, 3, 4, 5
_CLOSING = {"(": ")", "[": "]"}
_END = ""


def read_template(text: str) -> Node | None:
    """The tree of a template; None where there may be a mistake. Brackets must not be nested beyond all measure."""
    pieces: list[Node | str] = []
    at = 0
    while at < len(text):
        match = _PIECE.match(text, at)
        if match is None:
            return None
        kind = match.lastindex
        if kind == _WORD:
            word = _word(match[_WORD])
            if word is None:
                return None
            pieces.append(word)
        elif kind == _SIGN:
            pieces.append(match[_SIGN])
        elif kind == _CLASS:
            pieces.append(WordClass(match[_CLASS]))
        else:
            name = match[_REFERENCE]
            pieces.append(Reference(name, match[_LABEL] or name, match.start(_REFERENCE)))
        at = match.end()
    pieces.append(_END)
    found = _alternatives(pieces, 0, ("|",))
    return found[0] if found is not None and found[1] == len(pieces) - 1 else None


@lru_cache(maxsize=4096)
def _word(written: str) -> Node | None:
    """What is written between spaces, as one word or more; None if it is none."""
    items = tuple(map(Word, words_of(written)))
    if len(items) == 1:
        return items[0]
    return Sequence(items) if items else None


def _alternatives(pieces: list[Node | str], at: int, signs: tuple[str, ...]) -> tuple[Node, int] | None:
    """``a``, ``a | b | c`` or ``a; b; c``, whichever sign comes first, and the place after it."""
    found = _sequence(pieces, at)
    if found is None:
        return None
    part, at = found
    sign = pieces[at]
    if sign not in signs:
        return found
    parts = [part]
    while pieces[at] == sign:
        found = _sequence(pieces, at + 1)
        if found is None:
            return None
        part, at = found
        parts.append(part)
    if sign == "|":
        return Choice(tuple(parts)), at
    return (AnyOrder(tuple(parts)), at) if len(parts) <= MAX_ANY_ORDER else None


def _sequence(pieces: list[Node | str], at: int) -> tuple[Node, int] | None:
    """``a (b) [c]``, at least one part, and the place after it."""
    items: list[Node] = []
    while True:
        piece = pieces[at]
        if not isinstance(piece, str):
            items.append(piece)
        elif piece in _CLOSING:
            found = _alternatives(pieces, at + 1, ("|", ";"))
            if found is None or pieces[found[1]] != _CLOSING[piece]:
                return None
            items.append(Optional(found[0]) if piece == "[" else found[0])
            at = found[1]
        elif items:
            return items[0] if len(items) == 1 else Sequence(tuple(items)), at
        else:
            return None
        at += 1
