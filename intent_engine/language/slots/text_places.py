"""Where a title, a message or another text of any words stands in a sentence: what belongs to it is no filler."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.matcher import Matcher
from intent_engine.language.networks.word_state import Stack, WordState
from intent_engine.language.words.openers import TextPlace
from intent_engine.language.words.thing_words import thing_words

__all__ = ["TextPlaces"]


class TextPlaces:
    """The places of text in the sentences of one grammar. Thread-safe.

    The names of things are no text: what is around them is left out ("the cup please"), since no thing is called so.
    Of the words within them, those that describe a thing are asked for separately.
    """

    def __init__(self, matcher: Matcher) -> None:
        self._matcher = matcher
        free = [slot for slot in matcher.grammar.slots.values() if slot.type in FREE_KINDS and not slot.dictation]
        self._things = {slot.name for slot in free if matcher.values.is_thing(slot)}
        self._texts = {slot.name for slot in free} - self._things

    def __bool__(self) -> bool:
        return bool(self._texts)

    def at(self, before: Sequence[str], after: str) -> TextPlace | None:
        """Where a filler stands that is said between words and another word; None: they begin no sentence, not even
        the last of several.

        Args:
            before: what was said up to there.
            after: the first word behind it that is none; empty: there is none.
        """
        automaton = self._matcher.strict
        for start in range(len(before)):
            _, state = automaton.walk(before[start:])
            if state is None:
                continue
            texts = _open(state)
            if not texts or not self._texts.issuperset(texts.values()) or self._goes_on(state, after):
                return TextPlace.OUTSIDE
            _, earlier = automaton.walk(before[start:-1])
            begun = earlier is not None and texts.keys() <= _open(earlier).keys()
            return TextPlace.WITHIN if begun else TextPlace.BEGINS
        return None

    def name(self, before: Sequence[str], after: str) -> bool:
        """Whether words end within the name of a thing, or where one begins, and another word can only go on there:
        no sentence has it, and it begins nothing else, as in "the good *in* people"."""
        if after in thing_words(self._matcher.grammar.language).joining:
            return False
        automaton = self._matcher.strict
        for start in range(len(before)):
            _, state = automaton.walk(before[start:])
            if state is not None:
                open_slots = _open(state)
                return (
                    bool(open_slots)
                    and self._things.issuperset(open_slots.values())
                    and not self._goes_on(state, after)
                )
        return False

    def _goes_on(self, state: WordState, after: str) -> bool:
        """Whether a sentence has a word here, beside its text: "play yesterday please *by* the beatles"."""
        number = bool(after) and self._matcher.is_number(after)
        return any(after in place.arcs or (number and (place.number or place.numeral)) for place, _ in state.members)


def _open(state: WordState) -> dict[Stack, str]:
    """The slots that take any word next, by where they were entered."""
    calls = ((stack, stack.call_mark) for place, stack in state.members if place.wild)
    return {stack: mark[2] for stack, mark in calls if mark is not None and mark[0] == "slot"}
