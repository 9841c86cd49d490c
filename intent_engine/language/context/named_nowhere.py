"""An "it" that says where something goes, or what it is of, when nothing was named before: "stick a fork in it"."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["named_nowhere"]


def named_nowhere(found: Interpretation, grammar: Grammar) -> str:
    """The pronoun of a command that has a thing of its own besides, which is one of many ("*a* fork"): no such thing is
    at hand, so the other one is not known from what is being done either, as the pot may be on which "the lid" belongs.
    Empty: there is none, or something was named before it in the same utterance.

    Args:
        found: what was understood, where nothing is known to have been named before.
        grammar: in which it was said.
    """
    pronouns = {" ".join(words) for words in grammar.operators.pronoun}
    for slots in _steps(found):
        free = [value for label, value in slots.items() if isinstance(value, str) and _is_free(label, grammar)]
        thing, *others = free or ("",)
        pointing = next((value for value in others if value in pronouns), "")
        if pointing and thing not in pronouns and _one_of_many(thing, found.text, grammar.language):
            return pointing
        if any(isinstance(value, str) and value not in pronouns for value in slots.values()):
            return ""  # "drive to the lab and put a cup on it"
    return ""


def _steps(found: Interpretation) -> Iterator[Mapping[str, Any]]:
    """The slots of each command."""
    steps = found.slots.get("steps")
    yield from (step["slots"] for step in steps) if isinstance(steps, list) else (found.slots,)


def _is_free(label: str, grammar: Grammar) -> bool:
    """Whether a slot of any words may be called so in a sentence: one that lists its values holds no pronoun."""
    slot = grammar.slots.get(label)
    return slot is None or slot.type in FREE_KINDS


def _one_of_many(thing: str, text: str, language: str) -> bool:
    """Whether a thing was named with an article that tells not which."""
    known = thing_words(language)
    words, name = Utterance.of(text, language).words, thing.split()
    return any(
        words[at - 1] in known.introducing - known.definite and words[at : at + len(name)] == name
        for at in range(1, len(words))
    )
