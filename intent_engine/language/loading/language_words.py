"""The words that every grammar of a language has, whatever its author writes: ``operators/<language>.yaml``, where each
list says why. Empty for a language that has no file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import cache
from pathlib import Path

from intent_engine.language.grammar import Operators, Wording
from intent_engine.language.loading.yaml_source import read_yaml

__all__ = [
    "default_around",
    "default_counting",
    "default_fillers",
    "default_operators",
    "default_opposites",
    "default_wording",
]

_FOLDER = Path(__file__).parent.parent / "operators"
_OPERATORS = frozenset(one.name for one in fields(Operators))


@cache
def _words(language: str) -> Mapping[str, tuple[str, ...]]:
    """The lists of a language's file."""
    file = _FOLDER / f"{language}.yaml"
    if not file.is_file():
        return {}
    source = read_yaml(str(file))
    return {key: tuple(str(item) for item in items) for key, items in source.data.items()}


def default_operators(language: str) -> Mapping[str, tuple[str, ...]]:
    """The words that change what a sentence does."""
    return {key: words for key, words in _words(language).items() if key in _OPERATORS}


def default_fillers(language: str) -> tuple[str, ...]:
    """What people put around any sentence ("please"), for grammars that say nothing of fillers."""
    return _words(language).get("filler", ())


def default_around(language: str) -> tuple[str, ...]:
    """What people put before a number ("about"), for the same grammars."""
    return _words(language).get("around", ())


def default_counting(language: str) -> tuple[str, ...]:
    """What people put between a number and what is counted ("two *more* coffees"), for the same grammars."""
    return _words(language).get("counting", ())


def default_opposites(language: str) -> tuple[tuple[str, str], ...]:
    """Pairs of words of which one means the opposite of the other: "on", "off"."""
    pairs = (pair.partition("/") for pair in _words(language).get("opposite", ()))
    return tuple((one, other) for one, _, other in pairs)


def default_wording(language: str, said: Callable[[Iterable[str]], tuple[tuple[str, ...], ...]]) -> Wording:
    """How people put their commands; ``said`` turns phrases into normalised words."""
    lists = _words(language)

    def phrases(key: str) -> tuple[tuple[str, ...], ...]:
        return said(lists.get(key, ()))

    def words(key: str) -> frozenset[str]:
        return frozenset(lists.get(key, ()))

    return Wording(
        greetings=phrases("greeting"),
        thanking=phrases("thanking"),
        hesitations=phrases("hesitation"),
        ways_back=phrases("way_back"),
        asked=words("asked"),
        requests=words("request"),
        agrees=words("agrees"),
        agreeing=phrases("agreeing"),
        compares=words("compares"),
        before_verbs=words("before_verb"),
        verb_follows=words("verb_follows"),
        adds=words("adds"),
        of_speed=words("of_speed"),
        negated=phrases("negated"),
        forbidding=phrases("forbidding"),
        before_negations=phrases("before_negation"),
        behind_verbs=phrases("behind_verb"),
        excludes=frozenset(phrases("excludes")),
        may_forbid=words("may_forbid"),
        none_of=words("none_of"),
        alternatives=words("alternative"),
        affirming=phrases("affirming"),
        declining=phrases("declining"),
        standing_for=words("standing_for"),
        several=words("several"),
        denying=words("denying"),
        forbidden=tuple(tuple(pair.split()) for pair in lists.get("forbidden", ())),
        parted=lists.get("parted", ()),
    )
