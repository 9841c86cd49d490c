"""What the ``regex:`` and ``lark:`` patterns of a grammar may be said as, among the networks of its templates.

It is for hearing them and for looking ahead, and may fit more than they do: what anything means the patterns say.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator
from functools import cached_property

from intent_engine.language.grammar import Grammar, Slot
from intent_engine.language.networks.network import Call, Network, Networks
from intent_engine.language.pattern.pattern_tree import Named, Number, Part, UnsayableError, Words, leaves_open, walk
from intent_engine.language.pattern.pattern_words import pattern_network
from intent_engine.language.pattern.patterns import said_by_patterns
from intent_engine.language.template import parse_template
from intent_engine.language.words.thing_words import ARTICLES

__all__ = ["SpokenPatterns"]

MAX_OPEN_WORDS = 4
"""Words that a pattern leaves open where no slot takes them."""


class SpokenPatterns:
    """The patterns of one grammar. They are looked at when somebody first asks.

    Args:
        grammar: which was checked.
        networks: of its templates, to which those of the patterns are added.
        call: how a slot is entered, and under which name its value is given.
    """

    def __init__(self, grammar: Grammar, networks: Networks, call: Callable[[Slot, str], Call]) -> None:
        self._grammar = grammar
        self._networks = networks
        self._call = call

    @cached_property
    def networks(self) -> tuple[str, ...]:
        """Keys of the networks of those patterns of which it can be told how they are said."""
        keys = []
        for index, network in enumerate(self._made(self._parts)):
            keys.append(f"pattern:{index}")
            self._networks.add(keys[-1], network)
        return tuple(keys)

    @cached_property
    def words(self) -> frozenset[str]:
        """The words that patterns spell out."""
        return frozenset().union(*(self._networks[key].words() for key in self.networks))

    @cached_property
    def first_words(self) -> frozenset[str]:
        """Those of them with which patterns begin."""
        return frozenset().union(*(self._networks[key].start.arcs for key in self.networks))

    @cached_property
    def values(self) -> frozenset[str]:
        """Those of them that they list for slots: "(?P<lamp>lights?|lamp)"."""
        slots = (one.part for part in self._parts for one in walk(part) if isinstance(one, Named))
        return frozenset().union(*(network.words() for network in self._made(slots)))

    @cached_property
    def _parts(self) -> tuple[Part, ...]:
        return tuple(said_by_patterns(self._grammar))

    def _made(self, parts: Iterable[Part]) -> Iterator[Network]:
        for part in parts:
            with contextlib.suppress(UnsayableError):
                yield pattern_network(part, self._entered, numbers=self._grammar.language == "en")

    def _entered(self, part: Number | Words | Named) -> Call | None:
        """The network of what a pattern leaves open. A slot that it leaves open takes what slots of its type take."""
        if isinstance(part, Words):
            return Call("free:1" if part.single else f"free:{MAX_OPEN_WORDS}")
        if isinstance(part, Number):
            return Call("quantity:number")
        slot = self._grammar.slots.get(part.name)
        if slot is None or not leaves_open(part.part):
            return None
        call = self._call(slot, part.name)
        if slot.type not in ("choice", "location"):
            return call
        key, articles = f"open:{slot.name}", "|".join(sorted(ARTICLES))
        self._networks.add_template(key, parse_template(f"[({articles})] {{{slot.name}}}"), {slot.name: call})
        return Call(key)
