"""An "it" that says where something goes, or what it is of, when nothing was named before: "stick a fork in it"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.pronouns import things_of
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
    one = pronouns - grammar.wording.several  # "them" may be people
    for slots in _steps(found):
        said = {label: value for label, value in slots.items() if isinstance(value, str)}
        if not one.isdisjoint(said.values()):
            things = things_of(grammar)
            thing, *others = [value for label, value in said.items() if _is_free(label, grammar, things)] or ("",)
            pointing = next((value for value in others if value in one), "")
            if pointing and thing not in pronouns and _one_of_many(thing, found.text, grammar.language):
                return pointing
        if not pronouns.issuperset(said.values()):
            return ""  # "drive to the lab and put a cup on it"
    return ""


def _steps(found: Interpretation) -> Iterator[Mapping[str, Any]]:
    """The slots of each command."""
    steps = found.slots.get("steps")
    yield from (step["slots"] for step in steps) if isinstance(steps, list) else (found.slots,)


def _is_free(label: str, grammar: Grammar, things: Collection[str]) -> bool:
    """Whether a slot that holds things in any words may be called so in a sentence: a poem "about it" is about
    anything."""
    return label in things or label not in grammar.slots


def _one_of_many(thing: str, text: str, language: str) -> bool:
    """Whether a thing was named with an article that tells not which."""
    known = thing_words(language)
    words, name = Utterance.of(text, language).words, thing.split()
    return any(
        words[at - 1] in known.introducing - known.definite and words[at : at + len(name)] == name
        for at in range(1, len(words))
    )
