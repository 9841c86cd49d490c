"""A Lark grammar as what may be said, for hearing it and looking ahead. Lark itself says what it means."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from intent_engine.language.pattern.pattern_regex import regex_tree
from intent_engine.language.pattern.pattern_tree import Named, OneOf, Part, Repeat, Row, Text, UnsayableError

__all__ = ["lark_tree"]

MOST_WITHIN = 2
"""Times that a rule may stand within itself. What is deeper is heard without the grammar's help."""
MOST_ROWS = 5_000
"""Alternatives that are looked at, of rules that stand within each other."""


def lark_tree(parser: Any, slots: Collection[str]) -> Part:
    """What the sentences of a Lark grammar may be said as.

    Args:
        parser: Lark's, of the grammar.
        slots: names of rules that are slots.

    Raises:
        UnsayableError: it cannot be told.
    """
    return _Rules(parser, slots).of("start", ())


class _TooManyError(UnsayableError):
    """Not this alternative, but all of them."""


class _Rules:
    def __init__(self, parser: Any, slots: Collection[str]) -> None:
        self._slots = slots
        self._rules: dict[str, list[list[Any]]] = {}
        for rule in parser.rules:
            self._rules.setdefault(str(rule.origin.name), []).append(list(rule.expansion))
        self._terminals: Mapping[str, Any] = {str(one.name): one.pattern for one in parser.terminals}
        ignored = (self._terminal(str(name)) for name in parser.ignore_tokens)
        self._spaced = any(part == Text(" ") for part in ignored)
        """Whether what the rules have is said with a space between."""
        self._rows = 0

    def of(self, name: str, within: tuple[str, ...]) -> Part:
        """What a rule is said as, within others."""
        if within.count(name) >= MOST_WITHIN:
            raise UnsayableError(f"{name} within itself")
        ways = self._rules[name]
        again = [way[1:] for way in ways if way and _is_rule(way[0], name)]
        once = [way for way in ways if not (way and _is_rule(way[0], name))]
        # "a | a_list a", as Lark writes a+, is no rule within itself.
        found = self._any(once, (*within, name))
        if again:
            onward = self._any(again, (*within, name))
            found = Row((found, Repeat(Row((self._joint, onward)), 0, None)))
        return Named(name, found) if name in self._slots else found

    def _any(self, ways: list[list[Any]], within: tuple[str, ...]) -> Part:
        found = []
        for way in ways:
            try:
                found.append(self._row(way, within))
            except _TooManyError:
                raise
            except UnsayableError:
                continue
        if not found:
            raise UnsayableError("no sentence that could be said")
        return OneOf(tuple(found))

    def _row(self, symbols: list[Any], within: tuple[str, ...]) -> Part:
        self._rows += 1
        if self._rows > MOST_ROWS:
            raise _TooManyError("too many rules within each other")
        parts: list[Part] = []
        for symbol in symbols:
            if parts:
                parts.append(self._joint)
            name = str(symbol.name)
            parts.append(self._terminal(name) if symbol.is_term else self.of(name, within))
        return Row(tuple(parts))

    @property
    def _joint(self) -> Part:
        return Text(" " if self._spaced else "")

    def _terminal(self, name: str) -> Part:
        pattern = self._terminals.get(name)
        if pattern is None:
            raise UnsayableError(name)
        return Text(str(pattern.value).lower()) if pattern.type == "str" else regex_tree(pattern.value)


def _is_rule(symbol: Any, name: str) -> bool:
    return not symbol.is_term and str(symbol.name) == name
