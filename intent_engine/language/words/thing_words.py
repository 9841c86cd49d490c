"""The words around and in the names of things, by language: ``things/<language>.yaml``, where each list says why."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, fields
from functools import cache, cached_property
from pathlib import Path

from intent_engine.language.language_files import language_file

__all__ = ["ARTICLES", "ThingWords", "any_articles", "thing_words"]

_FOLDER = Path(__file__).parent.parent / "things"


@dataclass(frozen=True)
class ThingWords:
    """Those of one language; empty for a language that has no file."""

    articles: frozenset[str] = frozenset()
    """Before the name of a thing or a place, and no part of it."""
    owning: frozenset[str] = frozenset()
    """Those of them that say whose it is, or which."""
    done_to: frozenset[str] = frozenset()
    """Those of them of what something is done to, and not only of who does it."""
    telling_which: frozenset[str] = frozenset()
    """Those of them that are a part of a title or a message: "play *my* way"."""
    of_several: frozenset[str] = frozenset()
    """Those of them before more than one thing, in a language whose names end in too many ways to tell: "die"."""
    relating: frozenset[str] = frozenset()
    """Those of them that may also begin what is told of a thing: "a place *that* delivers"."""
    definite: frozenset[str] = frozenset()
    """Those of them that tell nothing of it."""
    itself: frozenset[str] = frozenset()
    """The robot itself, and what it moves with."""
    describing: frozenset[str] = frozenset()
    """Said of a thing, behind its article and before the rest of its name, though a filler elsewhere."""
    qualities: frozenset[str] = frozenset()
    """They tell which one of several, before its noun: "the red cup, no, the *blue*"."""
    unfinished: frozenset[str] = frozenset()
    """No thing ends so."""
    alone: frozenset[str] = frozenset()
    """By itself no thing."""
    joining: frozenset[str] = frozenset()
    """No thing of a slot that lists things begins or ends so,"""
    may_begin: frozenset[str] = frozenset()
    """but may begin so."""
    within: frozenset[str] = frozenset()
    """No thing begins so either, though much that is said goes on so."""
    never: frozenset[str] = frozenset()
    """In no name of a thing."""
    not_bare: frozenset[str] = frozenset()
    """No name begins so without an article."""
    not_held: frozenset[str] = frozenset()
    """Not to be held, where no other word of the name follows."""
    not_held_endings: frozenset[str] = frozenset()
    """Endings of such words,"""
    held_endings: frozenset[str] = frozenset()
    """but not of those that end so; with a "^" it is the whole word."""
    stays: frozenset[str] = frozenset()
    """No thing that is taken, though things are given to it or put there."""
    had: frozenset[str] = frozenset()
    """Those of them of which things have one."""
    solid: frozenset[str] = frozenset()
    """Words that make a thing of one of them that follows ("toy bus"), and names of two words that end so."""
    bare: frozenset[str] = frozenset()
    """By itself and without an article no thing."""
    pronouns: frozenset[str] = frozenset()
    """A whole name."""
    whither: frozenset[str] = frozenset()
    """What such a name does not go on with: where a thing is to go."""
    persons: frozenset[str] = frozenset()
    """Words for people, and by themselves no thing that is picked up."""
    next_begins: frozenset[str] = frozenset()
    """Articles before which another thing begins,"""
    binding: frozenset[str] = frozenset()
    """unless one of these is before them."""
    telling: frozenset[str] = frozenset()
    """They say something of a thing."""
    timed: frozenset[str] = frozenset()
    """Between a thing and the time when it is wanted."""
    delaying: frozenset[str] = frozenset()
    """Between a thing and how long it is to take, or to wait."""
    where: frozenset[str] = frozenset()
    """No things by themselves: "here"."""
    dating: frozenset[str] = frozenset()
    """Between a thing and a day or a part of one when it is wanted,"""
    days: frozenset[str] = frozenset()
    """and those."""
    repeating: frozenset[str] = frozenset()
    """Those between a thing and how often it is wanted."""
    ranging: frozenset[str] = frozenset()
    """Between two numbers of which one is meant."""
    either: frozenset[str] = frozenset()
    """Between two things of which one is meant, or before them."""
    measures: frozenset[str] = frozenset()
    """Units in which things are weighed and poured."""
    having: frozenset[str] = frozenset()
    """Before what a thing is to have: "no" behind that may say what it is to have none of."""
    manner: frozenset[str] = frozenset()
    """Endings of words that say how something is done."""
    manners: frozenset[str] = frozenset()
    """Such words that are shorter than others with their endings."""
    scales: frozenset[str] = frozenset()
    """Before a number they say how much there is of one thing, and name none: "level 3"."""
    plurals: tuple[tuple[str, str], ...] = ()
    """How more of a thing end, and one of it: "batteries", "battery"."""
    sayings: tuple[str, ...] = ()
    """What is said of an "it" that is no thing."""
    contracted: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    """One word for two -> the two, of which the second is an article: "zum", "zu dem"."""
    titles: Mapping[str, str] = field(default_factory=dict)
    """What is written before the names of people, as normalised words, and the word that is said for it."""
    examples: tuple[str, ...] = ()
    """Things, for sampled sentences."""

    @property
    def introducing(self) -> frozenset[str]:
        """The articles that may stand where a sentence writes none."""
        return self.articles - self.owning

    def is_manner(self, word: str) -> bool:
        """Whether a word says how something is done: it is one that does, or ends so and has two letters before."""
        return word in self.manners or _ends(word, self._manner)

    def is_not_held(self, word: str) -> bool:
        """Whether a word tells of nothing that a hand can hold: it is one of those, or ends as they do: "kindness"."""
        return word in self.not_held or (_ends(word, self._not_held) and not _ends(word, self._held, 0))

    @property
    def definite_of_things(self) -> frozenset[str]:
        """Articles that tell nothing of what something is done to, and not where it is: "das", and no "dem"."""
        return self.definite & self.done_to if self.done_to else self.definite

    @cached_property
    def _manner(self) -> re.Pattern[str]:
        return _ending(self.manner)

    @cached_property
    def _not_held(self) -> re.Pattern[str]:
        return _ending(self.not_held_endings)

    @cached_property
    def _held(self) -> re.Pattern[str]:
        return _ending(self.held_endings)


def _ending(endings: Collection[str]) -> re.Pattern[str]:
    """A pattern of what ends with one of them."""
    return re.compile(f"(?:{'|'.join(sorted(endings))})$" if endings else "(?!)")


def _ends(word: str, ending: re.Pattern[str], least: int = 2) -> bool:
    """Whether a word ends so and has so many letters before."""
    return len(word) > least and ending.search(word, least) is not None


@cache
def thing_words(language: str) -> ThingWords:
    """Those of a language ("en").

    Raises:
        ConfigError: its file has keys that nobody reads.
    """
    data = language_file("things", language, dict.fromkeys(one.name for one in fields(ThingWords)))
    if data is None:
        return ThingWords()
    solid = frozenset(data.pop("solid", ()))
    sayings, examples = tuple(data.pop("sayings", ())), tuple(data.pop("examples", ()))
    contracted = {one: (first, second) for one, (first, second) in data.pop("contracted", {}).items()}
    titles = data.pop("titles", {})
    plurals = tuple((more, one) for more, _, one in (pair.partition("/") for pair in data.pop("plurals", "").split()))
    words = {key: frozenset(text.split()) for key, text in data.items()}
    return ThingWords(
        **words,
        solid=solid,
        plurals=plurals,
        sayings=sayings,
        contracted=contracted,
        titles=titles,
        examples=examples,
    )


@cache
def any_articles() -> frozenset[str]:
    """The articles of all languages."""
    return frozenset[str]().union(*(thing_words(file.stem).articles for file in _FOLDER.glob("*.yaml")))


ARTICLES = thing_words("en").articles
"""The English ones."""
