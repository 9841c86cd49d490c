"""Trees to words: every way to say a value, and all words that a grammar is written in."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice, permutations

from intent_engine.language.grammar import Grammar
from intent_engine.language.numbers.units import SIGNS, units
from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Reference, Sequence, Word
from intent_engine.language.words.homophones import (
    LETTERS_BY_SOUND,
    SPELLING_ALPHABET,
    homophones,
    spelled_otherwise,
)

__all__ = ["own_homophones", "own_words", "spellings", "stops_by_sound"]

_SCALES: Mapping[str, tuple[str, ...]] = {"c": ("celsius",), "f": ("fahrenheit",)}
"""Letters that recognisers write for a word: "95 °C"."""


def spellings(node: Node, phrases: Mapping[str, Node], most: int) -> list[tuple[str, ...]]:
    """Up to ``most`` ways to say a template that holds words and phrases only."""
    return list(islice(_all(node, phrases), most))


def _all(node: Node, phrases: Mapping[str, Node]) -> Iterator[tuple[str, ...]]:
    match node:
        case Word(text):
            yield (text,)
        case Choice(items):
            for item in items:
                yield from _all(item, phrases)
        case Optional(item):
            yield from _all(item, phrases)
            yield ()
        case Sequence(items):
            yield from _sequences(items, phrases)
        case AnyOrder(items):
            for order in permutations(items):
                yield from _sequences(order, phrases)
        case Reference(name) if name in phrases:
            yield from _all(phrases[name], phrases)


def _sequences(items: tuple[Node, ...], phrases: Mapping[str, Node]) -> Iterator[tuple[str, ...]]:
    if not items:
        yield ()
        return
    for head in _all(items[0], phrases):
        for tail in _sequences(items[1:], phrases):
            yield (*head, *tail)


def own_words(grammar: Grammar) -> frozenset[str]:
    """The words that the grammar's sentences, phrases and choices are written in."""
    nodes: list[Node] = [sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences]
    nodes.extend(grammar.phrases.values())
    nodes.extend(node for slot in grammar.slots.values() for _, node in (*slot.values, *slot.units))
    return frozenset(_literal(nodes))


_WITH_A_DATIVE = ("er", "el")
"""How German names end that have an "n" behind "mit", "zu" and the like where there are several of it."""


def own_homophones(grammar: Grammar) -> dict[str, tuple[str, ...]]:
    """Words that sound like some that a grammar is written in, or are its signs in words: each with those."""
    own = own_words(grammar)
    said = {**homophones(grammar.language), **_SCALES, **_of_signs(grammar.language)}
    found = {word: tuple(filter(own.__contains__, same)) for word, same in said.items()}
    for word in sorted(own) if grammar.language == "en" else ():
        for other in spelled_otherwise(word):
            if other not in own and word not in found.get(other, ()):
                found[other] = (*found.get(other, ()), word)
    for word in sorted(own) if grammar.language == "de" else ():
        if word.endswith(_WITH_A_DATIVE) and word + "n" not in own:  # "mit zwei Newtonmetern"
            found[word + "n"] = (*found.get(word + "n", ()), word)
    letters = _letters(grammar) if grammar.language == "en" else frozenset()
    for word, letter in LETTERS_BY_SOUND.items() if letters else ():
        if letter in letters - {"a"}:
            found[word] = (*found.get(word, ()), letter)
    for word, letter in SPELLING_ALPHABET.items() if letters else ():
        if letter in letters and word not in own:  # "alpha" is no article, unless a sentence has one there
            found[word] = (*found.get(word, ()), letter)
    return {word: same for word, same in found.items() if same}


def _letters(grammar: Grammar) -> frozenset[str]:
    """Letters that are values of lists: "row B". None of a sentence ("you turned left" is no U-turn), nor "a" where a
    sentence has it as an article."""
    values = [node for slot in grammar.slots.values() for _, node in slot.values]
    nodes = [item for node in values for item in (node.items if isinstance(node, Choice) else (node,))]
    listed = frozenset(node.text for node in nodes if isinstance(node, Word) and len(node.text) == 1)
    templates = (sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences)
    return listed - {"a"}.intersection(_literal((*templates, *grammar.phrases.values())))


def _of_signs(language: str) -> dict[str, tuple[str, ...]]:
    """What the words that signs are read as are called in a language: "°" is "degrees" in every one, and "grad"."""
    table = units(language)
    if table is None or language == "en":
        return {}
    return {word: (table.first_name(word),) for word in SIGNS}


def stops_by_sound(grammar: Grammar) -> tuple[tuple[str, ...], ...]:
    """Its phrases that stop, as they may be written by their sound: "break" for "brake", where that is none of its own
    words."""
    stops = grammar.operators.stop
    alone = {words[0] for words in stops if len(words) == 1}
    taken = own_words(grammar).union(grammar.sound_alikes, *grammar.fillers, *stops)
    same = homophones(grammar.language)
    written = {word: [other for other in same.get(word, ()) if other not in taken] for word in alone}
    return tuple(
        (*words[:place], other, *words[place + 1 :])
        for words in stops
        for place, word in enumerate(words)
        for other in written.get(word, ())
    )


def _literal(nodes: Iterable[Node]) -> Iterator[str]:
    """The words that templates are written in, in any order."""
    waiting = list(nodes)
    while waiting:
        node = waiting.pop()
        if isinstance(node, Word):
            yield node.text
        elif isinstance(node, (Sequence, Choice, AnyOrder)):
            waiting.extend(node.items)
        elif isinstance(node, Optional):
            waiting.append(node.item)
