"""What a test has people say for the free text of a grammar."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from intent_engine.errors import ConfigError
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.utterance import Utterance

__all__ = ["texts_of"]


def texts_of(given: object, grammar: Grammar) -> dict[str, tuple[str, ...]]:
    """Slot name to what is said for it; one text is a list of one.

    Raises:
        ConfigError: the grammar has no such slot of free text, nothing is said for it, or it has no room for that.
        TypeError: it is no mapping of names to texts.
    """
    if not isinstance(given, Mapping):
        raise TypeError(f"texts is a dictionary, as {{'thing': ['red cup']}}, not {given!r:.80}")
    free = [name for name, slot in grammar.slots.items() if slot.type in FREE_KINDS]
    words = FreeText(grammar)
    found: dict[str, tuple[str, ...]] = {}
    for name, said in given.items():
        if name not in free:
            there = f"there is {', '.join(free)}" if free else "it has none"
            raise ConfigError(f"texts: the grammar has no text slot {name!r}; {did_you_mean(str(name), free) or there}")
        each = (said,) if isinstance(said, str) else said
        if not isinstance(each, Collection) or not all(isinstance(text, str) for text in each):
            raise TypeError(f"texts: what is said for {name!r} is a list of texts, not {said!r:.80}")
        slot = grammar.slots[name]
        for text in each:
            heard = Utterance.of(text, grammar.language).words
            if not heard:
                raise ConfigError(f"texts: {text!r}, for slot {name!r}, has no word")
            if not slot.dictation and not words.has_room(slot, heard):
                raise ConfigError(f"texts: {text!r} has more words than the {slot.max_words} that slot {name!r} takes")
        if not each:
            raise ConfigError(f"texts: nothing is said for slot {name!r}; leave it out for common things")
        found[name] = tuple(each)
    return found
