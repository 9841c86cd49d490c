"""The words that every grammar of a language has, whatever its author writes: ``operators/<language>.yaml``, where each
list says why. Empty for a language that has no file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from typing import Any, get_type_hints

from intent_engine.language.grammar import Operators
from intent_engine.language.language_files import Keys, language_file
from intent_engine.language.loading.word_lists import in_full
from intent_engine.language.wording import Wording
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = [
    "KEYS",
    "Heard",
    "default_another",
    "default_around",
    "default_booleans",
    "default_counted",
    "default_counting",
    "default_denying",
    "default_fillers",
    "default_heard",
    "default_operators",
    "default_opposites",
    "default_parted",
    "default_wording",
]

_OPERATORS = frozenset(one.name for one in fields(Operators)) - {"stop_by_sound"}  # which is made of the stops
_LISTS = {
    "adverbs": "adverb", "alternatives": "alternative", "before_negations": "before_negation",
    "before_verbs": "before_verb", "behind_verbs": "behind_verb", "fillers_apart": "filler_apart",
    "greetings": "greeting", "hesitations": "hesitation", "requests": "request", "ways_back": "way_back",
}  # fmt: skip
"""The lists of :class:`Wording` that a file calls otherwise, each with the key there."""
_WORDING = {one.name: _LISTS.get(one.name, one.name) for one in fields(Wording)}
_BY_WORD = (
    "particles", "idle_particles", "sizes", "levels", "taken_up", "permits", "pleads", "puts", "stands_for_noun",
    "joined_short", "takes_along",
)  # fmt: skip
"""Those of it in which each word has others, in any order."""
_OTHERS = (
    "filler", "filler_denying", "around", "counting", "counted", "another", "opposite", "heard_for", "maybe_number",
    "said_for_true", "said_for_false",
)  # fmt: skip
KEYS: Keys = dict.fromkeys((*sorted(_OPERATORS), *_WORDING.values(), *_OTHERS))
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
    return {key: in_full(items) for key, items in lists}


def _pairs(language: str, key: str) -> dict[str, tuple[str, ...]]:
    """A list of it in which each word has others."""
    return {one: tuple(others) for one, others in _file(language).get(key, {}).items()}


def default_operators(language: str) -> Mapping[str, tuple[str, ...]]:
    """The words that change what a sentence does."""
    return {key: words for key, words in _words(language).items() if key in _OPERATORS}


def default_fillers(language: str) -> tuple[str, ...]:
    """What people put around any sentence ("please"), for grammars that say nothing of fillers."""
    return _words(language).get("filler", ())


def default_denying(language: str) -> tuple[str, ...]:
    """Those that say no and deny nothing ("if you don't mind"), for all grammars that have any fillers."""
    return _words(language).get("filler_denying", ())


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


def default_parted(language: str) -> frozenset[str]:
    """What is parted from a verb and stands at the end of a command: "schalte Pumpe zwei *ein*"."""
    return frozenset(_words(language).get("parted", ()))


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
    """How people put their commands; ``said`` turns phrases into normalised words. What becomes of a list is the type
    that :class:`Wording` has for it; what tells how verbs end is left as it is written."""
    lists, types = _words(language), get_type_hints(Wording)
    made: dict[Any, Callable[[tuple[str, ...]], Any]] = {
        tuple[str, ...]: tuple,
        frozenset[str]: frozenset,
        tuple[tuple[str, ...], ...]: said,
        frozenset[tuple[str, ...]]: lambda texts: frozenset(said(texts)),
        PhraseSet: lambda texts: PhraseSet(said(texts)),
    }
    others: dict[str, Any] = {
        "forbidden": tuple(tuple(form.split()) for form in lists.get("forbidden", ())),
        "wished": tuple(tuple(form.split()) for form in lists.get("wished", ())),
        **{key: {one: frozenset(others) for one, others in _pairs(language, key).items()} for key in _BY_WORD},
        "vowels": _pairs(language, "vowels"),
        "how_often": _pairs(language, "how_often"),
    }
    found = {name: made[types[name]](lists.get(key, ())) for name, key in _WORDING.items() if name not in others}
    return Wording(**found, **others)
