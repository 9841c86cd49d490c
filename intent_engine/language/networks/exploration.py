"""Everything that a grammar understands, walked: for each set of sentences that share words, the shortest such words.

Words that lead to the same place are taken once, a quantity is "7" and a unit, and of a large map only the names that
could be taken for something else are kept. So the walk visits every way in which sentences meet, and yet ends.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from intent_engine.language.automaton import Automaton
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.matcher import Matcher
from intent_engine.language.networks.network import NEVER
from intent_engine.language.networks.sentence_networks import spoken_trees
from intent_engine.language.networks.word_state import WordState
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
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
from intent_engine.language.vocabulary import vocabulary

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["Exploration", "Meeting", "explore"]

MAX_STATES = 25_000
"""Word states that are visited; the shipped English grammar has 9,000."""
MAX_NAMES = 200
"""Names of a map that are kept."""
NUMERAL = "7"
FREE_WORDS = ("something", "whatever", "thingamajig", "qwx")
"""Stand for any word of a free slot: the first that the grammar does not have."""
_TOPS = {"speed": "distance", "angular_speed": "angle"}


@dataclass(frozen=True, slots=True)
class Meeting:
    """Words, and every reading of them, most wanted first."""

    words: tuple[str, ...]
    readings: tuple[Reading, ...]


@dataclass(frozen=True)
class Exploration:
    """What the walk came upon."""

    matcher: Matcher
    """Of the reduced grammar."""
    free: str
    """The word that stands for any word of free text."""
    meetings: tuple[Meeting, ...]
    """One for each word state that ends a sentence, shortest words first."""
    later: tuple[Meeting, ...]
    """The same of what is a command only behind another."""
    states: int
    """Word states visited."""
    widest: int
    """Most ways to go on after the same words."""
    complete: bool
    """Whether all were visited."""


def explore(grammar: Grammar, locations: LocationMap | None, most: int = MAX_STATES) -> Exploration:
    """Walk all sentences of a grammar, breadth first.

    Raises:
        ConfigError: the grammar has more than 20,000 ways to go on after the same words.
    """
    own = vocabulary(grammar)
    matcher = Matcher(grammar, _few(locations, own))
    number = _number(own, grammar.language)
    trees = spoken_trees(grammar.language)
    for kind in (*QUANTITY_KINDS, "count"):
        # English ordinals are few words, and none is a numeral: "third", "3rd".
        if kind in trees and (kind != "ordinal" or grammar.language != "en"):
            matcher.networks.add_template(f"quantity:{kind}", _reduced(kind, trees, number), {})
    part = trees.get("part")
    if grammar.language != "en" and "fraction" in trees and isinstance(part, Sequence):
        # Any number words may begin one of another language, and alone be none: "ein" of "ein Drittel".
        matcher.networks.add_template("quantity:fraction", part.items[-1], {})
    matcher.networks.add_template("quantity:and_part", Word(NEVER), {})
    free = next((word for word in FREE_WORDS if word not in own), "qwxz")
    walk = _Walk(matcher.strict, grammar, free)
    meetings = [Meeting(words, tuple(matcher.read(list(words)))) for words in walk.endings(most)]
    later = []
    for name, (automaton, _) in matcher.later.items():
        for words in _Walk(automaton, grammar, free).endings(most):
            later.append(Meeting(words, tuple(matcher.read(list(words), after=name))))
    return Exploration(matcher, free, tuple(meetings), tuple(later), walk.states, walk.widest, walk.complete)


class _Walk:
    """Visits all that an automaton leads to, breadth first."""

    def __init__(self, automaton: Automaton, grammar: Grammar, free: str) -> None:
        self._automaton = automaton
        self._grammar = grammar
        self._free = free
        self.states = self.widest = 0
        self.complete = False

    def endings(self, most: int) -> Iterator[tuple[str, ...]]:
        """The shortest words to each state that ends a sentence; the shortest of all first."""
        automaton = self._automaton
        start = automaton.start()
        reached: dict[WordState, tuple[str, ...]] = {start: ()}
        pending = deque([start])
        while pending and len(reached) < most:
            state = pending.popleft()
            words = reached[state]
            self.widest = max(self.widest, len(state.members))
            for word in _kinds(automaton, state, self._grammar, self._free):
                onward = automaton.step(state, word)
                if onward is not None and onward not in reached:
                    reached[onward] = (*words, word)
                    pending.append(onward)
                    if automaton.accepting(onward):
                        yield reached[onward]
        self.states, self.complete = len(reached), not pending


def _kinds(automaton: Automaton, state: WordState, grammar: Grammar, free: str) -> Iterator[str]:
    """One word for each place that a word can lead to."""
    leads: dict[str, list[tuple[int, int]]] = {free: []} if automaton.free(state) else {}
    for index, (place, _) in enumerate(state.members):
        for word, targets in place.arcs.items():
            if word == NEVER:
                continue
            leads.setdefault(word, []).extend((index, id(target)) for target in targets)
    if automaton.allows_digits(state):
        leads.setdefault(NUMERAL, [])
    allowed = frozenset[str]().union(*(place.allowed for place, _ in state.members))
    closed = grammar.operators.closed
    seen = set()
    for word, where in leads.items():
        kind = (tuple(where), word in closed, word in allowed, word == NUMERAL)
        if kind not in seen:
            seen.add(kind)
            yield word


def _number(words: Iterable[str], language: str) -> Node:
    """Any number as "7", and those that sentences have as words of their own: "two" of "lift the two cups"."""
    values = {word: evaluate((word,), "number", language) for word in sorted(words) if not word.isdigit()}
    said = [word for word, value in values.items() if isinstance(value, float) and value >= 1]  # "half" is of a unit
    return Choice((WordClass("#"), *map(Word, said)))


def _reduced(kind: str, trees: Mapping[str, Node], number: Node) -> Node:
    """A quantity as a number and its unit, or as the fixed words that it has ("about face", "slowly")."""
    tree = trees.get(kind)
    options: list[Node] = [item for item in tree.items if _literal(item)] if isinstance(tree, Choice) else []
    top = trees.get(f"{_TOPS.get(kind, kind)}_unit")
    if kind in _TOPS and top is not None:
        options.append(Sequence((number, top, Word("per"), trees.get("duration_unit") or Word("second"))))
    elif top is not None:
        options.append(Sequence((number, top)))
    else:
        options.append(number)
    return Choice(tuple(options))


def _literal(node: Node) -> bool:
    match node:
        case Word():
            return True
        case WordClass() | Reference():
            return False
        case Optional(item):
            return _literal(item)
        case Choice(items) | Sequence(items) | AnyOrder(items):
            return all(_literal(item) for item in items)


def _few(locations: LocationMap | None, known: frozenset[str]) -> LocationMap | None:
    """A map of the places whose names share words with the sentences, and some others."""
    if locations is None or len(locations) <= MAX_NAMES:
        return locations
    from intent_engine.language.locations import LocationMap

    clashing = dict.fromkeys(name for words, name in locations.names() if not known.isdisjoint(words))
    kept = [*clashing, *(name for name in locations if name not in clashing)][:MAX_NAMES]
    return LocationMap({name: locations[name] for name in kept}, locations.frame)
