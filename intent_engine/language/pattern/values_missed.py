r"""Values of a list, and places of a map, that the open group of a ``regex:`` never holds: ``(?P<place>\w+)`` is one
word, and no "living room"."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from intent_engine.errors import Problem
from intent_engine.language.grammar import Grammar, Intent, Slot, problem_at
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.pattern.every_letter import with_every_letter
from intent_engine.language.pattern.pattern_regex import regex_tree
from intent_engine.language.pattern.pattern_tree import Named, UnsayableError, leaves_open, walk
from intent_engine.language.slots.slot_values import NamesOf
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import references

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["values_missed"]

_MOST_SPELLINGS = 200
"""Ways to say one value that are tried."""
_MOST_TOLD = 3
_PIECE = re.compile(r"\\.|\[\^?\]?(?:\\.|[^\]\\])*\]|\(\?P?<(?P<name>\w+)>|[()]|.", re.DOTALL)


def values_missed(intent: Intent, grammar: Grammar, locations: LocationMap | None) -> Iterator[Problem]:
    """What no pattern of an intent holds, of slots of which one has a group that takes any letters. Where a group lists
    what it takes, its author has chosen; and what a sentence of the intent takes can be said.

    Args:
        intent: whose regular expressions are looked at.
        grammar: with its slots.
        locations: the map.
    """
    groups: dict[str, list[str]] = {}
    opened: set[str] = set()
    for text in intent.regex:
        for name, inner in _groups(text):
            groups.setdefault(name, []).append(inner)
        opened |= _open_groups(text)
    said = {name.name for sentence in intent.all_sentences for name in references(sentence.template)}
    for name in sorted(opened - said):
        slot = grammar.slots.get(name)
        if slot is None or slot.type not in ("choice", "location") or intent.lark is not None:
            continue
        missed = [" ".join(words) for words in _names(slot, grammar, locations) if not _holds(groups[name], words)]
        if not missed:
            continue
        more = f" and {len(missed) - _MOST_TOLD} more" if len(missed) > _MOST_TOLD else ""
        told = ", ".join(map(repr, missed[:_MOST_TOLD]))
        shown = f"(?P<{name}>{groups[name][0]})"
        message = f"a pattern of {intent.name!r} never takes {told}{more} for {name!r}: {shown} does not fit"
        yield problem_at(intent.place, message, f"write (?P<{name}>.+), which takes what the slot has")


def _groups(text: str) -> Iterator[tuple[str, str]]:
    """The named groups of a regular expression, each with the pattern within."""
    begun: list[tuple[str, int]] = []
    for piece in _PIECE.finditer(text):
        if piece[0].startswith("("):
            begun.append((piece["name"] or "", piece.end()))
        elif piece[0] == ")" and begun:
            name, start = begun.pop()
            if name:
                yield name, text[start : piece.start()]


def _open_groups(text: str) -> set[str]:
    try:
        parts = walk(regex_tree(text))
    except UnsayableError:
        return set()
    return {part.name for part in parts if isinstance(part, Named) and leaves_open(part.part)}


def _names(slot: Slot, grammar: Grammar, locations: LocationMap | None) -> Iterator[Sequence[str]]:
    """What may be said for the values of a slot."""
    if slot.type == "choice":
        for _, node in slot.values:
            yield from spellings(node, grammar.phrases, _MOST_SPELLINGS)
    else:
        for words, _ in NamesOf(locations, slot.tags, grammar.language):
            yield words


def _holds(groups: Sequence[str], words: Sequence[str]) -> bool:
    """Whether a group fits some words, their numbers in figures or in words."""
    import re2

    options = re2.Options()
    options.log_errors = False
    ways = {" ".join(words), " ".join(in_words(list(words)))}
    for group in groups:
        try:
            pattern = re2.compile(with_every_letter(group), options)
        except re2.error:
            return True  # a part of a whole that is understood
        if any(pattern.fullmatch(way) is not None for way in ways):
            return True
    return False
