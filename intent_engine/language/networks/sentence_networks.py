"""What is said for slots, phrases and sentences of a grammar, as networks of words."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache, cached_property, partial
from typing import TYPE_CHECKING

from intent_engine.language import quantities
from intent_engine.language.automaton import SOUND
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, TELLING_APART, Grammar, Sentence, Slot
from intent_engine.language.networks.network import NAMED, NEVER, Call, Networks
from intent_engine.language.numbers.digit_by_digit import template_of
from intent_engine.language.numbers.spelled import figures_otherwise, number_otherwise
from intent_engine.language.numbers.units import units
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.own_units import hundredth
from intent_engine.language.slots.slot_values import NamesOf
from intent_engine.language.template import parse_template
from intent_engine.language.templates.led_names import led
from intent_engine.language.templates.moved_manner import manner_moved
from intent_engine.language.templates.moved_particles import moved
from intent_engine.language.templates.numbered import numbers_either_way
from intent_engine.language.templates.shared_verbs import SharedVerbs
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.templates.template_tree import (
    Choice,
    Node,
    Optional,
    Reference,
    Word,
    first_words,
    most_words,
    references,
)
from intent_engine.language.templates.template_tree import Sequence as TemplateSequence
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["SentenceNetworks", "call_of", "spoken_trees"]

MAX_LOOSE_WORDS = 5
"""Words that a misheard name may have."""
LOOSE_VALUE_WORDS = 3
"""The same of a value of a list, or as many as the longest of them has."""
MOST_WILD = 12
"""Words of any kind that a network may take."""
BEHIND = ("\0behind", "\0sound behind")
"""Names that no template has."""
JOINT = "\0joint"
"""Another one: of what stands between things that a verb is said of."""
OWN_UNIT = "\0unit"
"""Another one: of the units that a slot has of its own."""


class SentenceNetworks:
    """Makes the networks of one grammar and one map, in those that are given.

    Args:
        grammar: whose.
        locations: names of places; None: there are none.
        networks: to which they are added.
        free: what free words may be.
    """

    def __init__(self, grammar: Grammar, locations: LocationMap | None, networks: Networks, free: FreeText) -> None:
        self._grammar = grammar
        self._locations = locations
        self._networks = networks
        self._free = free
        self._sentences: Sequence[Sentence] = ()
        self._made: dict[str, tuple[Node, Mapping[str, Call]]] = {}
        """Templates of sentences and what their names call, by the networks made of them."""
        self._led: set[str] = set()
        """Kinds that have phrases of their own."""

    def add_sentences(self, sentences: Sequence[Sentence]) -> None:
        """Add sentences, ``sentence:0`` and so on, with all that they are made of."""
        self._sentences = sentences
        grammar = self._grammar
        spoken, free = quantities.templates(grammar.language), self._free
        for name, node in spoken_trees(grammar.language).items():
            scope = {reference.name: Call(f"quantity:{reference.name}") for reference in references(node)}
            self._networks.add_template(f"quantity:{name}", node, scope)
        for words in range(1, MOST_WILD + 1):
            self._networks.add_wild(f"wild:{words}", words)
            for key, articles in (("free", free.articles), ("dictated", frozenset[str]())):
                self._networks.add_wild(
                    f"{key}:{words}",
                    words,
                    begins=free.unfinished,
                    alone=free.alone,
                    yielded=free.no_beginning,
                    articles=articles,
                )
        for slot in grammar.slots.values():
            if slot.allow or slot.known or slot.without:
                self._networks.add_wild(
                    f"text:{slot.name}",
                    slot.max_words,
                    slot.allow | (slot.known & grammar.operators.closed),  # of which no more than the names is taken
                    free.unfinished_in(slot),
                    free.alone,
                    slot.known | thing_words(grammar.language).articles if slot.known else slot.known,
                    slot.without,
                    free.no_beginning,
                    frozenset() if slot.dictation else free.articles,
                )
        for slot in grammar.slots.values():
            self._add_slot(slot, spoken)
        for name, node in grammar.phrases.items():
            self._networks.add_template(f"phrase:{name}", self._spoken(node), self._scope(node))
        for index, sentence in enumerate(sentences):
            node = sentence.template
            self._add_template(f"sentence:{index}", self._spoken(node), self._scope(node))

    def _add_template(self, key: str, node: Node, scope: Mapping[str, Call]) -> None:
        self._made[key] = node, scope
        self._networks.add_template(key, node, scope)

    def template_of(self, index: int) -> Node:
        """The template of a sentence, as its file has it."""
        return self._sentences[index].template

    def add_polite(self, fillers: Sequence[tuple[str, ...]], sounds: Sequence[tuple[str, ...]]) -> bool:
        """The sentences with what stands behind their first words in other languages than English: "fahr bitte in die
        Küche", "fahr nicht in die Küche"; False, if nothing does."""
        language = self._grammar.language
        behind = {*self._grammar.wording.behind_verbs, *(words for words in fillers if len(words) == 1)}
        if language == "en" or not behind:
            return False
        either = Optional(Choice(tuple(Reference(name, name, 0) for name in BEHIND)))
        calls = {BEHIND[0]: Call("behind", apart=True), BEHIND[1]: Call("sounds behind", mark=SOUND, apart=True)}
        self._networks.add_names("behind", [(words, "") for words in sorted(behind.difference(sounds))])
        self._networks.add_names("sounds behind", [(words, "") for words in sorted(behind.intersection(sounds))])
        for index, sentence in enumerate(self._sentences):
            scope = self._scope(sentence.template) | calls
            self._add_template(f"polite:{index}", _with_behind_first(sentence.template, either), scope)
        return True

    def add_led(self, kind: str, indices: Iterable[int], leading: Collection[str]) -> None:
        """Some sentences with an article before names of places and values of lists, which are understood with one
        although their file writes none: "photograph the bridge", of "photograph {thing}".

        Args:
            kind: what their networks are called, before their number: "led" for ``led:0`` and so on.
            indices: which.
            leading: the articles.
        """
        self._led.add(kind)
        grammar, articles = self._grammar, thing_words(self._grammar.language).articles
        before = {slot.name: self._before(slot, leading) for slot in grammar.slots.values() if _is_named(slot)}
        counted = {slot.name for slot in grammar.slots.values() if slot.type in QUANTITY_KINDS}
        templates = [(f"{kind} phrase:{name}", node) for name, node in grammar.phrases.items()]
        templates += [(f"{kind}:{index}", self._sentences[index].template) for index in indices]
        for key, node in templates:
            template = led(node, before, counted, articles)
            self._add_template(key, self._spoken(template), self._scope(node, f"{kind} "))

    def add_otherwise(self, key: str, joint: str) -> str:
        """Add a sentence with all ways to put it that are understood though its file has one: "turn the lamp on" of
        "turn on the {lamp}", "slowly turn the crank" of "turn the crank {pace}", and "open the hatch and the gate" of
        "open the {door}".

        Args:
            key: of its network.
            joint: key of the network of what stands between two things.

        Returns:
            The key of the network; the same if there is no other way.
        """
        node, scope = self._made[key]
        grammar, articles = self._grammar, thing_words(self._grammar.language).articles
        otherwise = moved(node, grammar.wording.particles, articles, grammar.phrases, self._words_alone, self._is_free)
        otherwise += manner_moved(node, thing_words(grammar.language).is_manner, self._says_how)
        shared = SharedVerbs(Reference(JOINT, JOINT, 0), self._is_named_one, articles)
        more = tuple(shared.more_of(node))
        if not (otherwise or more):
            return key
        ways = Choice((shared.several(node), *(TemplateSequence((way, *more)) for way in otherwise)))
        kind = key.partition(":")[0]
        opened = self._scope(ways, f"{kind} " if kind in self._led else "")  # also what comes out of phrases
        self._networks.add_template(f"{joint} {key}", ways, {**opened, **scope, JOINT: Call(joint, apart=True)})
        return f"{joint} {key}"

    def _words_alone(self, name: str) -> frozenset[str]:
        """The words that are a whole value of a slot."""
        slot = self._grammar.slots.get(name)
        nodes = [node for _, node in slot.values] if slot is not None else []
        options = [one for node in nodes for one in (node.items if isinstance(node, Choice) else (node,))]
        return frozenset(one.text for one in options if isinstance(one, Word))

    def _says_how(self, name: str) -> bool:
        """Whether each word that is a whole value of a slot says how something is done."""
        words = self._words_alone(name)
        return bool(words) and all(map(thing_words(self._grammar.language).is_manner, words))

    def _is_free(self, name: str) -> bool:
        return name in self._grammar.slots and self._grammar.slots[name].type in FREE_KINDS

    def _is_named_one(self, name: str) -> bool:
        """Whether a slot tells one thing from another, or a phrase has one such slot and no more."""
        grammar = self._grammar
        if name in grammar.slots:
            return grammar.slots[name].type in TELLING_APART
        inner = [one.name for one in references(grammar.phrases[name])] if name in grammar.phrases else []
        return len(inner) == 1 and self._is_named_one(inner[0])

    def _before(self, slot: Slot, leading: Collection[str]) -> frozenset[str]:
        """The articles that may stand before what a slot holds: none with which one of its names begins, as "some milk"
        beside "milk", and "a 12" beside "12"; and none before "slowly"."""
        if self._says_how(slot.name):
            return frozenset()
        own = [first_words(node, self._grammar.phrases)[0] for _, node in slot.values]
        if slot.type == "location":
            own.append(self._begin_places)
        return frozenset(leading).difference(*own)

    @cached_property
    def _begin_places(self) -> frozenset[str]:
        """First words of the names on the map, without the "the" that none needs."""
        return frozenset(words[0] for words, _ in self._locations.names()) if self._locations else frozenset()

    def _add_slot(self, slot: Slot, spoken: Mapping[str, str]) -> None:
        key = f"slot:{slot.name}"
        if slot.type in QUANTITY_KINDS:
            kind: Node = Reference(slot.type, slot.type, 0) if slot.type in spoken else Word(NEVER)
            if slot.unit is not None and slot.type != "number":
                kind = Choice((kind, Reference("number", "number", 0)))
            elif slot.type == "percent" and "fraction" in spoken:
                kind = Choice((kind, Reference("fraction", "fraction", 0)))
            if slot.type == "percent":
                kind = Choice((kind, *map(Word, self._of_it("all_of_it")), *self._half_of_it()))
            if slot.units:
                own_units = self._own_units(slot, spoken)
                kind = Choice((kind, own_units)) if slot.type != "number" or slot.bare else own_units
            if slot.digits and slot.type in spoken:
                kind = Choice((kind, self._digit_by_digit(slot, spoken)))
            scope = {reference.name: Call(f"quantity:{reference.name}") for reference in references(kind)}
            own = {f"{OWN_UNIT}{place}": Call(f"units:{slot.name}:{place}") for place in range(len(slot.units))}
            self._networks.add_template(key, kind, scope | own)
        elif slot.type in ("choice", "boolean"):
            scope = {}
            for _, node in slot.values:
                scope.update(self._scope(node))
            self._networks.add_choice(key, [(value, self._spoken(node)) for value, node in slot.values], scope)
        elif slot.type == "location":
            language = self._grammar.language
            respell = number_otherwise if language == "en" else partial(figures_otherwise, language=language)
            self._networks.add_names(key, NamesOf(self._locations, slot.tags, language), respell)

    def _of_it(self, share: str) -> Sequence[str]:
        """Words for 100 % or 50 %: "full", "Hälfte". One that the grammar has itself means what it means there."""
        table = units(self._grammar.language)
        words = table.words.get(share, frozenset[str]()) if table is not None else frozenset[str]()
        return sorted(words - own_words(self._grammar)) if words else ()

    def _half_of_it(self) -> Iterator[Node]:
        """The same for 50 %, with its article."""
        table = units(self._grammar.language)
        articles = tuple(map(Word, sorted(table.words.get("the", ())))) if table is not None else ()
        for half in map(Word, self._of_it("half_of_it")):
            yield TemplateSequence((Optional(Choice(articles)), half)) if articles else half

    def _own_units(self, slot: Slot, spoken: Mapping[str, str]) -> Node:
        """How many there are of a unit that only this slot has: "two steps", "a step and a half"; and of a smaller one
        behind it: "two kilos and three hundred grams"."""
        part = Optional(Reference("and_part", "and_part", 0)) if "and_part" in spoken else Optional(Word(NEVER))
        table = units(self._grammar.language)
        joints = sorted(table.words.get("and", ())) if table is not None else []
        joint = (Optional(Choice(tuple(map(Word, joints)))),) if joints else ()
        ways: list[Node] = []
        smaller: list[Node] = []
        count = Reference("count", "count", 0)
        sizes = [size for size, _ in slot.units]
        for place, (size, node) in enumerate(sorted(slot.units, key=lambda unit: unit[0])):
            unit = Reference(name := f"{OWN_UNIT}{place}", name, 0)
            self._networks.add_template(f"units:{slot.name}:{place}", self._spoken(node), self._scope(node))
            less = (TemplateSequence((*joint, count, Choice(tuple(smaller)))),) if smaller else ()
            bare = (Reference("number", "number", 0),) if hundredth(size, sizes) is not None else ()
            ways.append(TemplateSequence((count, unit, Choice((part, *less, *bare)))))
            smaller.append(unit)
        return Choice(tuple(ways))

    def _digit_by_digit(self, slot: Slot, spoken: Mapping[str, str]) -> Node:
        """Digits said one by one, with what stands behind the numbers of a slot: "one eight zero degrees"."""
        names = [f"{OWN_UNIT}{place}" for place in range(len(slot.units))]
        if (usual := f"{slot.type}_unit") in spoken:
            names.append(usual)
        ends = tuple(Reference(name, name, 0) for name in names)
        digits = template_of(self._grammar.language)
        if not ends:
            return digits
        bare = slot.bare if slot.type == "number" else slot.unit is not None
        unit = Choice(ends)
        return TemplateSequence((digits, Optional(unit) if bare else unit))

    def _spoken(self, node: Node) -> Node:
        """A template of the file with its numbers in digits and in words, where those are known."""
        return numbers_either_way(node) if self._grammar.language == "en" else node

    def _scope(self, node: Node, kind: str = "") -> dict[str, Call]:
        """What the names in a template call; of its phrases the networks of some kind."""
        scope = {"#": Call("quantity:number", NAMED)}  # a numeral in a template of the file may be said in words
        for reference in references(node):
            name, label = reference.name, reference.label
            slot = self._grammar.slots.get(name)
            if slot is None:
                scope[name] = Call(f"{kind}phrase:{name}")
            else:
                scope[f"{name}:{label}"] = call_of(slot, label)
        return scope


def call_of(slot: Slot, label: str) -> Call:
    """The network of what is said for a slot, under a label."""
    mark = ("slot", label, slot.name)
    if slot.type in FREE_KINDS:
        listed = slot.allow or slot.known or slot.without
        kind = "dictated" if slot.dictation else "free"
        return Call(f"text:{slot.name}" if listed else f"{kind}:{slot.max_words}", mark)
    loose = None
    if _is_named(slot):
        loose = f"wild:{MAX_LOOSE_WORDS if slot.type == 'location' else _longest_value(slot)}"
    return Call(f"slot:{slot.name}", mark, loose)


def _longest_value(slot: Slot) -> int:
    """Words that a misheard value of a list may have."""
    longest = max((most_words(node) for _, node in slot.values), default=0)
    return min(max(longest, LOOSE_VALUE_WORDS), MOST_WILD)


def _is_named(slot: Slot) -> bool:
    """Whether what a slot holds is compared with names, and may be said with an article."""
    return slot.fuzzy and slot.type in ("location", "choice")


def _with_behind_first(node: Node, more: Node) -> Node:
    """A template with more behind the first of its words, whichever of several ways it goes."""
    match node:
        case Choice(items):
            return Choice(tuple(_with_behind_first(item, more) for item in items))
        case TemplateSequence((first, *rest)) if not isinstance(first, Optional):
            return TemplateSequence((first, more, *rest))
    return node


@cache
def spoken_trees(language: str) -> Mapping[str, Node]:
    """The spoken forms of quantities as trees."""
    return {name: parse_template(text) for name, text in quantities.templates(language).items()}
