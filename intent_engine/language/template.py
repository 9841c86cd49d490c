"""Sentence templates: text to tree, or what is wrong with the text.

``(a|b)`` alternatives, ``[a]`` optional, ``(a;b;c)`` any order, ``{name}`` a phrase or slot, ``{name:as}`` a slot
under another name, ``{#}`` one number. The grammar is in ``template.lark``.
"""

from __future__ import annotations

import re
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from intent_engine.language.normalize import words_of
from intent_engine.language.templates.template_reader import MAX_ANY_ORDER, read_template
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

if TYPE_CHECKING:
    from lark import Lark

__all__ = ["TemplateError", "parse_template"]

MAX_DEPTH = 40
"""Nesting of brackets; nobody speaks deeper, and it bounds every recursion over the tree."""
MAX_LENGTH = 20_000
"""Characters of a template. The longest shipped one has 300; a file given by mistake has millions."""


class TemplateError(ValueError):
    """A template that cannot be read."""

    def __init__(self, message: str, column: int, hint: str | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.column = column
        """Place in the template, from 0."""
        self.hint = hint


@cache
def _parser() -> Lark:
    from lark import Lark

    grammar = (Path(__file__).parent / "template.lark").read_text("utf-8")
    return Lark(grammar, parser="lalr", propagate_positions=False, maybe_placeholders=False)


@lru_cache(maxsize=4096)
def parse_template(text: str) -> Node:
    """The tree of a template.

    Raises:
        TemplateError: the text is not a template; says where and what to do.
    """
    if not text.strip():
        raise TemplateError("an empty sentence", 0, "write the words that a person says, or remove the line")
    if len(text) > MAX_LENGTH:
        raise TemplateError(f"a sentence of {len(text):,} characters", 0, f"write at most {MAX_LENGTH:,}")
    _check_characters(text)
    _check_brackets(text)
    return read_template(text) or parsed_by_lark(text)


def parsed_by_lark(text: str) -> Node:
    """The tree of a template by its grammar, ``template.lark``; the last word on every template.

    Raises:
        TemplateError: the text is not a template.
    """
    from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken

    try:
        tree = _parser().parse(text)
    except UnexpectedCharacters as error:
        column = error.pos_in_stream or 0
        raise TemplateError(f"{text[column]!r} cannot stand here", column, _hint(text, column)) from None
    except UnexpectedToken as error:
        if error.token.type == "$END":
            raise TemplateError("the sentence ends too early", len(text), "something is missing") from None
        column = error.pos_in_stream if error.pos_in_stream is not None else len(text)
        raise TemplateError(f"{error.token.value!r} cannot stand here", column, _hint(text, column)) from None
    except UnexpectedInput as error:  # pragma: no cover - Lark has no other kinds today
        raise TemplateError("cannot be read", error.pos_in_stream or 0) from None
    return _build(tree.children[0])


_FOREIGN = re.compile(r"[<>$@=^~*+\\_]|(?<!\{)#")
"""Signs of other grammar languages. None is ever part of a spoken word, so here each is a mistake."""


def _check_characters(text: str) -> None:
    """Refuse what another grammar language would understand, and this one would silently drop."""
    if (column := text.find("(?")) >= 0:
        hint = "write [words] for what may be left out and {name} for a slot, or put the pattern below regex:"
        raise TemplateError("'(?' is of a regular expression, and this is a sentence", column, hint)
    for match in _FOREIGN.finditer(text):
        column = match.start()
        if text.rfind("{", 0, column) > text.rfind("}", 0, column):
            continue  # inside braces: the grammar of names has its own say
        sign = match.group()
        hint = "words are letters, digits and apostrophes"
        if sign in "<>$@":
            hint = "a phrase or slot is written {name}"
        elif sign in "*+":
            hint = "nothing repeats; write the repetition out, or use regex:"
        elif sign == "_":
            hint = "write the words apart"
        raise TemplateError(f"{sign!r} is no part of a word that can be said", column, hint)


def _hint(text: str, column: int) -> str:
    character = text[column : column + 1]
    before = text[:column].rstrip()[-1:]
    opened = text.rfind("{", 0, column)
    if opened >= 0 and "}" not in text[opened:column]:
        return "a name in braces has letters, digits and '_': {how_far} or {distance:how_far}"
    if (character in "|)];" and before in "(|[;") or (character == "|" and not before):
        return "an empty alternative; write [words] for words that may be left out"
    depth = sum((one in "([") - (one in ")]") for one in text[:column])
    if depth and character in "|;" and {"|", ";"} <= set(text):
        return "'|' and ';' cannot stand in the same brackets; put one of them in brackets of its own: ((a|b); c)"
    if character == ";":
        return "';' separates parts in any order, inside brackets: (a; b)"
    return "the template language has ( | ) [ ] { } and ; - see docs/grammar.md"


def _check_brackets(text: str) -> None:
    """Name the bracket that has no partner: better than a parser's surprise further on."""
    pairs = {")": "(", "]": "[", "}": "{"}
    open_brackets: list[tuple[str, int]] = []
    for column, character in enumerate(text):
        if character in "([{":
            open_brackets.append((character, column))
            if len(open_brackets) > MAX_DEPTH:
                raise TemplateError(f"brackets nested deeper than {MAX_DEPTH}", column, "use {phrases}")
        elif character in pairs:
            if not open_brackets:
                raise TemplateError(f"{character!r} closes nothing", column, f"add {pairs[character]!r} or remove it")
            opened, at = open_brackets.pop()
            if opened != pairs[character]:
                wanted = next(close for close, start in pairs.items() if start == opened)
                message = f"{character!r} does not close the {opened!r} at column {at + 1} of the sentence"
                raise TemplateError(message, column, f"{opened!r} is closed by {wanted!r}")
    if open_brackets:
        opened, at = open_brackets[-1]
        closing = next(close for close, start in pairs.items() if start == opened)
        raise TemplateError(f"{opened!r} is never closed", at, f"add the {closing!r}")


def _build(tree: Any) -> Node:
    kind = tree.data
    if kind == "word":
        written = tree.children[0]
        items = tuple(map(Word, words_of(str(written))))
        if not items:
            optional = str(written).startswith("?")
            hint = "write [words] for what may be left out" if optional else "write letters or digits"
            raise TemplateError(f"{str(written)!r} is no word", written.start_pos, hint)
        return items[0] if len(items) == 1 else Sequence(items)
    if kind == "choice":
        options = tuple(_build(child) for child in tree.children)
        return options[0] if len(options) == 1 else Choice(options)
    if kind == "sequence":
        parts = tuple(_build(child) for child in tree.children)
        return parts[0] if len(parts) == 1 else Sequence(parts)
    if kind == "group":
        return _build(tree.children[0])
    if kind == "optional":
        return Optional(_build(tree.children[0]))
    if kind == "word_class":
        return WordClass(str(tree.children[0]))
    if kind == "reference":
        name = tree.children[0]
        return Reference(str(name), str(tree.children[-1]), name.start_pos)
    parts = tuple(_build(child) for child in tree.children)
    if len(parts) > MAX_ANY_ORDER:
        column = next(tree.scan_values(lambda token: True)).start_pos
        raise TemplateError(f"more than {MAX_ANY_ORDER} parts in any order", column, "write several sentences")
    return Optional(AnyOrder(parts)) if kind == "optional_any_order" else AnyOrder(parts)
