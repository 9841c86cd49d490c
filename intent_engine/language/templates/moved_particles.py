"""Templates with what belongs to a verb elsewhere: who writes "turn on the {lamp}" is told "turn the lamp on" as
well."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping

from intent_engine.language.templates.template_tree import (
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    first_words,
    references,
    says_only,
)

__all__ = ["moved"]

MOST_WAYS = 64
"""To say the beginning of one template; of a template with more, none is put otherwise."""

_Items = tuple[Node, ...]


def moved(
    node: Node,
    particles: Mapping[str, Collection[str]],
    articles: Collection[str],
    phrases: Mapping[str, Node],
    values: Callable[[str], Collection[str]],
    is_free: Callable[[str], bool],
) -> list[Node]:
    """The other templates that say the same; none, if its verb has no particle.

    Args:
        node: the template.
        particles: by their verbs.
        articles: of the language; before one of them a particle is a preposition.
        phrases: of the grammar.
        values: the words of which each is all of a value of a slot: "on" and "off".
        is_free: whether a slot takes any words.
    """
    if not particles:
        return []
    ways = _opened((node,), 2, phrases)
    found: dict[Node, None] = {}
    for _ in range(MOST_WAYS):
        if (way := next(ways, None)) is None:
            return list(found)
        if len(way) < 3 or not isinstance(way[0], Word) or not (own := particles.get(way[0].text)):
            continue
        verb, *behind = way
        if _is_particle(behind[0], own, values):
            places = [place for place in range(2, len(behind) + 1) if _ends_a_thing(behind, place, articles, phrases)]
            found.update((Sequence((verb, *_put(behind, 0, place))), None) for place in places)
            continue
        if any(is_free(one.name) for one in references(node)):
            continue  # they may say where something is done: "turn down the road"
        for place, item in enumerate(behind):
            if place and _is_particle(item, own, values):
                found[Sequence((verb, item, *behind[:place], *behind[place + 1 :]))] = None
    return []


def _opened(items: _Items, most: int, phrases: Mapping[str, Node]) -> Iterator[_Items]:
    """The ways to say a sequence, its first so many words apart, and sequences in it laid open."""
    if not items:
        yield ()
        return
    first, rest = items[0], items[1:]
    match first:
        case Sequence(inner):
            yield from _opened((*inner, *rest), most, phrases)
        case Choice(inner) if most:
            for one in inner:
                yield from _opened((one, *rest), most, phrases)
        case Optional(inner) if most:
            yield from _opened((inner, *rest), most, phrases)
            yield from _opened(rest, most, phrases)
        case Reference(name) if most and name in phrases:
            yield from _opened((phrases[name], *rest), most, phrases)
        case _:
            for others in _opened(rest, max(most - 1, 0), phrases):
                yield (first, *others)


def _is_particle(item: Node, own: Collection[str], values: Callable[[str], Collection[str]]) -> bool:
    match item:
        case Word(text):
            return text in own
        case Choice(items):
            return all(isinstance(one, Word) and one.text in own for one in items)
        case Reference(name):
            return not set(own).isdisjoint(values(name))
    return False


def _ends_a_thing(items: list[Node], place: int, articles: Collection[str], phrases: Mapping[str, Node]) -> bool:
    """Whether a particle may stand before a place: behind a thing, and before no article."""
    if place < len(items) and not first_words(items[place], phrases)[0].isdisjoint(articles):
        return False
    return not says_only(items[place - 1], articles)


def _put(items: list[Node], place: int, behind: int) -> _Items:
    """The items with one of them before another one."""
    return (*items[:place], *items[place + 1 : behind], items[place], *items[behind:])
