"""The words that every grammar of a language has, whatever its author writes: ``operators/<language>.yaml``, where each
list says why. Empty for a language that has no file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from typing import Any

from intent_engine.language.grammar import Operators
from intent_engine.language.language_files import Keys, language_file
from intent_engine.language.wording import Wording

__all__ = [
    "KEYS",
    "Heard",
    "default_another",
    "default_around",
    "default_booleans",
    "default_counted",
    "default_counting",
    "default_fillers",
    "default_heard",
    "default_operators",
    "default_opposites",
    "default_wording",
]

_OPERATORS = frozenset(one.name for one in fields(Operators)) - {"stop_by_sound"}  # which is made of the stops
_WORDING = (
    "greeting", "hesitation", "at_first", "besides", "leads", "way_back", "asked", "request", "agrees", "agreeing",
    "compares",
    "before_verb", "verb_follows", "adds", "of_speed", "negated", "forbidding", "before_negation", "behind_verb",
    "excludes", "may_forbid", "none_of", "alternative", "several", "denying", "forbidden", "formal", "asking",
    "kindly", "told_as", "joined", "ways_on", "ways_to",    "parted",
    "thanking", "affirming", "declining", "standing_for", "placed", "asks_for_doing", "asks_to_do",
    "leaves_open", "ranging", "adverb", "for_whom", "gives", "once_more", "wishing", "wished", "particles",
)  # fmt: skip
_OTHERS = (
    "filler", "around", "counting", "counted", "another", "opposite", "heard_for", "maybe_number",
    "said_for_true", "said_for_false", "vowels",
)  # fmt: skip
KEYS: Keys = dict.fromkeys((*sorted(_OPERATORS), *_WORDING, *_OTHERS))
"""What a file may hold."""


@dataclass(frozen=True)
class Heard:
    """Words that recognisers write for others."""

    meant: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Each with those that may have been said."""
    maybe_numbers: frozenset[str] = frozenset()
    """Those of them that may be a number, which no grammar tells from the other."""


@cache
def _file(language: str) -> Mapping[str, Any]:
    """What a language's file holds.

    Raises:
        ConfigError: it has keys that nobody reads.
    """
    return language_file("operators", language, KEYS) or {}


@cache
def _words(language: str) -> Mapping[str, tuple[str, ...]]:
    """The lists of it."""
    lists = ((key, items) for key, items in _file(language).items() if isinstance(items, list))
    return {key: tuple(str(item) for item in items) for key, items in lists}


def _pairs(language: str, key: str) -> dict[str, tuple[str, ...]]:
    """A list of it in which each word has others."""
    return {one: tuple(others) for one, others in _file(language).get(key, {}).items()}


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


def default_counted(language: str) -> tuple[str, ...]:
    """What people put behind what is counted ("dos cafés *más*"), for the same grammars."""
    return _words(language).get("counted", ())


def default_another(language: str) -> Mapping[str, tuple[str, ...]]:
    """What is said for another one, and the article for which it stands: "another coffee" is "a coffee"."""
    return _pairs(language, "another")


def default_heard(language: str) -> Heard:
    """Words that recognisers write for function words of commands, and that sound otherwise or may be numbers: those
    that sound the same are ``homophones``. Names have their own index; these are for the rest."""
    return Heard(_pairs(language, "heard_for"), frozenset(_words(language).get("maybe_number", ())))


def default_booleans(language: str) -> Mapping[bool, tuple[str, ...]] | None:
    """What is said for true and for false, for slots that say nothing of it; None: it is not known."""
    words = _words(language)
    if "said_for_true" not in words or "said_for_false" not in words:
        return None
    return {True: words["said_for_true"], False: words["said_for_false"]}


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
        at_first=phrases("at_first"),
        besides=phrases("besides"),
        leads=words("leads"),
        ways_back=phrases("way_back"),
        asks_for_doing=phrases("asks_for_doing"),
        asks_to_do=phrases("asks_to_do"),
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
        leaves_open=words("leaves_open"),
        ranging=words("ranging"),
        affirming=phrases("affirming"),
        declining=phrases("declining"),
        standing_for=words("standing_for"),
        placed=phrases("placed"),
        several=words("several"),
        denying=words("denying"),
        forbidden=tuple(tuple(pair.split()) for pair in lists.get("forbidden", ())),
        formal=lists.get("formal", ()),
        asking=lists.get("asking", ()),
        kindly=phrases("kindly"),
        told_as=lists.get("told_as", ()),
        vowels=_pairs(language, "vowels"),
        joined=words("joined"),
        ways_on=words("ways_on"),
        ways_to=words("ways_to"),
        parted=lists.get("parted", ()),
        adverbs=phrases("adverb"),
        for_whom=words("for_whom"),
        gives=words("gives"),
        once_more=phrases("once_more"),
        wishing=phrases("wishing"),
        wished=tuple(tuple(pair.split()) for pair in lists.get("wished", ())),
        particles={verb: frozenset(ones) for verb, ones in _pairs(language, "particles").items()},
    )
