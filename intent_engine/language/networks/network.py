"""Networks of word arcs: what templates, lists, quantities and names are compiled to.

A :class:`Network` is a small non-deterministic graph without recursion. Networks call each other (a sentence calls
a phrase, a slot calls its list of names), so that ten thousand names are stored once however many sentences use
them. They are built when the walk first enters them: loading a grammar costs what its YAML costs.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

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

__all__ = ["MOST_ARTICLES", "NAMED", "NEVER", "Call", "Edge", "Network", "Networks", "State"]

NEVER = "\0never"
"""A word that nobody says: where a language has nothing that may stand there."""
NAMED = ("named",)
"""The mark of a number that is a part of a name, without being a slot: "drawer 7"."""
MOST_ARTICLES = 2
"""Before a name: "the my cup" of somebody who begins again. A third is a word of the name."""


Name: TypeAlias = tuple[tuple[str, ...], str]
"""Words and what they name."""
Respell: TypeAlias = Callable[[tuple[str, ...]], tuple[int, Iterable[tuple[str, ...]]]]


@dataclass(frozen=True, slots=True)
class Call:
    """How a name in a template is entered."""

    network: str
    """Key of the network that spells it exactly."""
    mark: Any = None
    """Put into the reading where the call begins and ends; None for phrases, which leave no trace."""
    loose: str | None = None
    """Key of the network to enter besides, when spelling may be wrong: any words, to be compared later."""
    apart: bool = False
    """Whether what is read there is no part of a sentence: fillers, and what joins one sentence to the next."""


class Edge:
    """A step that reads no word: to ``target``, leaving ``mark``, through ``call`` if there is one."""

    __slots__ = ("call", "mark", "target")

    def __init__(self, target: State, mark: Any = None, call: Call | None = None) -> None:
        self.target = target
        self.mark = mark
        self.call = call


class State:
    """A place in a network."""

    __slots__ = (
        "allowed", "arcs", "articles", "begins", "begun", "edges", "expand", "final", "known", "led", "number",
        "numeral", "refused", "wild", "yielded",
    )  # fmt: skip

    def __init__(self) -> None:
        self.arcs: dict[str, tuple[State, ...]] = {}
        """The words that may be read here."""
        self.edges: list[Edge] = []
        """Steps without a word, most wanted first."""
        self.numeral: tuple[State, ...] = ()
        """Where a numeral ("10", "2.5") leads."""
        self.number: tuple[State, ...] = ()
        """Where a number word of the language leads."""
        self.wild: tuple[State, ...] = ()
        """Where any word leads, except those that a free slot may not swallow."""
        self.allowed: frozenset[str] = frozenset()
        """Words that this free slot may swallow all the same."""
        self.begins: frozenset[str] = frozenset()
        """Words with which this free slot may go on, but not end ("the"); they lead to ``begun``."""
        self.begun: tuple[State, ...] = ()
        self.articles: frozenset[str] = frozenset()
        """Words with which the name in this free slot may begin, and that are no part of it. They lead to the first of
        ``led``, or to the other one where they may be all that is said ("that")."""
        self.led: tuple[State, State] | None = None
        self.known: frozenset[str] = frozenset()
        """Words that are likely in this free slot."""
        self.refused: frozenset[str] = frozenset()
        """Words that show that something else is meant than what this free slot takes."""
        self.yielded: frozenset[str] = frozenset()
        """Words with which this free slot does not begin where a sentence has them: "stir [{thing}] [for {time}]"."""
        self.final = False
        """The end of its network."""
        self.expand: Callable[[State], None] | None = None
        """Fills the state in when it is first entered."""

    def add(self, word: str, target: State) -> None:
        self.arcs[word] = (*self.arcs.get(word, ()), target)

    def swallowed(self, word: str) -> tuple[State, ...]:
        """Where a word leads that this free slot swallows."""
        if self.led is not None and word in self.articles:
            return (self.led[0] if word in self.begins else self.led[1],)
        return self.begun if word in self.begins else self.wild


@dataclass(frozen=True, slots=True)
class Network:
    start: State
    end: State

    def words(self) -> frozenset[str]:
        """Its own, without those of what it calls."""
        found: set[str] = set()
        seen, waiting = {self.start}, [self.start]
        while waiting:
            state = waiting.pop()
            found.update(state.arcs)
            onward = {*(target for targets in state.arcs.values() for target in targets)}
            onward.update(edge.target for edge in state.edges)
            waiting.extend(onward - seen)
            seen |= onward
        return frozenset(found)


class Networks:
    """All networks of one grammar, by key, each built when first asked for, and unfolded as it is gone into."""

    def __init__(self) -> None:
        self.lock = threading.RLock()
        """Of all that walk through them: who came to a place that another unfolds would find no way on, for good."""
        self._builders: dict[str, Callable[[], Network]] = {}
        self._built: dict[str, Network] = {}

    def __contains__(self, key: str) -> bool:
        return key in self._builders

    def __getitem__(self, key: str) -> Network:
        network = self._built.get(key)
        if network is None:
            with self.lock:
                network = self._built.get(key) or self._built.setdefault(key, self._builders[key]())
        return network

    def size(self) -> tuple[int, int]:
        """States and arcs of what has been built so far; a step without a word is an arc as well."""
        states: set[int] = set()
        arcs = 0
        pending = [network.start for network in self._built.values()]
        while pending:
            state = pending.pop()
            if id(state) in states:
                continue
            states.add(id(state))
            onward = [target for targets in state.arcs.values() for target in targets]
            onward += [edge.target for edge in state.edges]
            onward += [*state.numeral, *state.number, *state.wild, *state.begun]
            arcs += len(onward)
            pending.extend(onward)
        return len(states), arcs

    def add(self, key: str, network: Network) -> None:
        """A network that was made elsewhere."""
        self._builders[key] = lambda: network

    def add_template(self, key: str, node: Node, scope: Mapping[str, Call]) -> None:
        """A network that spells a template; ``scope`` says what its names call."""
        self._builders[key] = lambda: _template(node, scope)

    def add_choice(self, key: str, values: Iterable[tuple[Any, Node]], scope: Mapping[str, Call]) -> None:
        """A list of values, each with the template that spells it; the value is marked."""
        options = list(values)
        self._builders[key] = lambda: _choice(options, scope)

    def add_names(self, key: str, entries: Iterable[Name], respell: Respell | None = None) -> None:
        """Names (normalised words, value), unfolded word by word as the walk goes in.

        Args:
            key: of the network.
            entries: the names; gone through when the walk first comes to them.
            respell: asked at the words of a name ("3 b"): how many of those that come next are written otherwise too
                (1), and how (("three",)).
        """
        self._builders[key] = lambda: _names(entries, respell)

    def add_wild(
        self,
        key: str,
        max_words: int,
        allowed: frozenset[str] = frozenset(),
        begins: frozenset[str] = frozenset(),
        alone: frozenset[str] = frozenset(),
        known: frozenset[str] = frozenset(),
        refused: frozenset[str] = frozenset(),
        yielded: frozenset[str] = frozenset(),
        articles: frozenset[str] = frozenset(),
    ) -> None:
        """One to ``max_words`` words of any kind, behind articles.

        Args:
            key: of the network.
            max_words: the most words.
            allowed: words that it may swallow, though they are closed to others.
            begins: words that are never the last.
            alone: words that are never the only one.
            known: words that are likely.
            refused: words with which nothing is meant that it takes.
            yielded: words with which it does not begin where a sentence goes on with them.
            articles: words of which it may begin with two that do not count.
        """
        self._builders[key] = lambda: _wild(
            max_words, allowed, begins, alone | begins, known - refused, refused, yielded - allowed, articles
        )


def _template(node: Node, scope: Mapping[str, Call]) -> Network:
    start, end = State(), State()
    end.final = True
    connect(node, start, end, scope)
    return Network(start, end)


def connect(node: Node, start: State, end: State, scope: Mapping[str, Call]) -> None:
    """Lay a template between two states."""
    match node:
        case Word(text):
            start.add(text, end)
        case WordClass("#") if "#" in scope:
            start.edges.append(Edge(end, call=scope["#"]))
        case WordClass("#"):
            start.numeral = (*start.numeral, end)
        case WordClass():
            start.number = (*start.number, end)
        case Reference(name, label, _):
            call = scope.get(f"{name}:{label}") or scope[name]
            start.edges.append(Edge(end, call=call))
        case Choice(items):
            for item in items:
                connect(item, start, end, scope)
        case Optional(item):
            connect(item, start, end, scope)
            start.edges.append(Edge(end))
        case Sequence(items):
            here = start
            for item in items[:-1]:
                there = State()
                connect(item, here, there, scope)
                here = there
            connect(items[-1], here, end, scope)
        case AnyOrder(items):
            _any_order(items, start, end, scope)


def _any_order(items: tuple[Node, ...], start: State, end: State, scope: Mapping[str, Call]) -> None:
    """A state for each set of parts already said."""
    everything = (1 << len(items)) - 1
    states = {0: start, everything: end}
    for said in range(everything):
        here = states.setdefault(said, State())
        for number, item in enumerate(items):
            if not said & (1 << number):
                after = said | (1 << number)
                connect(item, here, states.setdefault(after, State()), scope)


def _choice(options: list[tuple[Any, Node]], scope: Mapping[str, Call]) -> Network:
    start, end = State(), State()
    end.final = True
    for value, node in options:
        first = State()
        start.edges.append(Edge(first, mark=("value", value)))
        connect(node, first, end, scope)
    return Network(start, end)


def _names(entries: Iterable[Name], respell: Respell | None) -> Network:
    start, end = State(), State()
    end.final = True

    def grow(rows: Iterable[tuple[Name, int]], depth: int) -> Callable[[State], None]:
        """From the place ``depth`` of names; a row's number is where its words end that shall stay as they are."""

        def expand(state: State) -> None:
            onward: dict[str, list[tuple[Name, int]]] = {}
            for name, settled in rows:
                words, value = name
                if len(words) == depth:
                    state.edges.append(Edge(end, mark=("value", value)))
                    continue
                if respell is not None and depth >= settled:
                    length, others = respell(words[depth:])
                    settled = depth + length
                    for other in others:
                        spelled = (*words[:depth], *other, *words[settled:])
                        onward.setdefault(other[0], []).append(((spelled, value), depth + len(other)))
                onward.setdefault(words[depth], []).append((name, settled))
            for word, longer in onward.items():
                child = State()
                child.expand = grow(longer, depth + 1)
                state.add(word, child)

        return expand

    start.expand = grow(((name, 0) for name in entries), 0)
    return Network(start, end)


def _wild(
    max_words: int,
    allowed: frozenset[str],
    begins: frozenset[str],
    alone: frozenset[str],
    known: frozenset[str],
    refused: frozenset[str],
    yielded: frozenset[str],
    articles: frozenset[str],
) -> Network:
    start, end = State(), State()
    end.final = True
    start.yielded = yielded
    places = led = [start, *(State() for _ in range(MOST_ARTICLES if articles else 0))]
    for left in range(max_words - 1, -1, -1):
        there, begun = State(), State()
        for here in places:
            here.wild = (there,)
            here.allowed = allowed
            here.known = known
            here.refused = refused
            here.begins = (alone if here is start else begins) - allowed
            if left:
                here.begun = (begun,)
        if left:
            there.edges.append(Edge(begun))
        there.edges.append(Edge(end))
        places = [begun]
    for here, onward in pairwise(led):
        whole = State()
        whole.edges += (Edge(onward), Edge(end))
        here.articles, here.led = articles, (onward, whole)
    return Network(start, end)
