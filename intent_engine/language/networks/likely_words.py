"""Which of the words that may follow are likely: for telling a person how a sentence goes on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, zip_longest

from intent_engine.language.grammar import QUANTITY_KINDS, Slot
from intent_engine.language.matcher import Matcher
from intent_engine.language.quantities import evaluate
from intent_engine.language.sampling.spoken_quantities import usual_units
from intent_engine.language.slots.own_units import units_called

__all__ = ["likely_words"]

MOST_TRIED = 500
"""Words of which each is tried, whether the sentence is whole with it; a map has thousands."""


def likely_words(matcher: Matcher, words: Sequence[str], most: int) -> tuple[str, ...]:
    """The words that may follow the beginning of an utterance, likely ones first, up to so many.

    Behind a number these are units, those of each quantity that it may be in turn: "go forward three" goes on with
    "meters" or "seconds", hardly with "centi". Of all others those come first with which the sentence is whole ("turn
    left"), among them the names of values and places before other ways to say them, then by the alphabet.
    """
    _, reached = matcher.begun.walk(words)
    if reached is None:
        return ()
    spoken, values = matcher.begun, set(_values(matcher))
    following = sorted(spoken.next_words(reached))
    few = len(following) <= MOST_TRIED

    def rank(word: str) -> tuple[bool, bool]:
        onward = spoken.step(reached, word) if few else None
        place = matcher.locations.get(word) if matcher.locations is not None else None
        named = word in values or (place is not None and place.name == word)
        return onward is None or not spoken.accepting(onward), not named

    following.sort(key=rank)
    single = evaluate(words[-1:], "number", matcher.grammar.language) == 1.0
    units = (_units(slot, matcher, single=single) for slot in _begun(matcher, words))
    in_turn = (word for word in chain.from_iterable(zip_longest(*units)) if word in following)
    return tuple(dict.fromkeys((*in_turn, *following)))[:most]


def _values(matcher: Matcher) -> Iterator[str]:
    """What the values of slots are called."""
    for slot in matcher.grammar.slots.values():
        yield from (str(value) for value, _ in slot.values)


def _begun(matcher: Matcher, words: Sequence[str]) -> Iterator[Slot]:
    """The quantities of which the last words may be the beginning, the most wanted first."""
    seen: set[str] = set()
    for _, calls, _ in matcher.begun.ways_on(words):
        for _, mark, entered in calls:
            if mark is None or mark[0] != "slot" or entered or mark[2] in seen:
                continue
            seen.add(mark[2])
            slot = matcher.grammar.slots[mark[2]]
            if slot.type in QUANTITY_KINDS:
                yield slot


def _units(slot: Slot, matcher: Matcher, *, single: bool) -> Iterator[str]:
    """What a slot counts in: the most usual unit, then its own, then the others."""
    usual = iter(usual_units(slot.type, matcher.grammar.language, single=single))
    yield from (name for name in (next(usual, None),) if name is not None)
    for _, names in units_called(slot, matcher.grammar.phrases):
        yield names[0 if single or len(names) == 1 else 1][0]
    yield from usual
