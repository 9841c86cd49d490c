"""What is told to be on or off without a verb: "lights on", "Licht aus"."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import product

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording, of_things_listed
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Verbless"]

_MOST = 6
"""Words of such an order."""


class Verbless:
    """Reads it with a verb of a grammar before it, and with an article where the grammar has one.

    Args:
        grammar: whose they are.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: Collection[str]) -> None:
        self._switched = grammar.wording.switched
        self._parts = bool(grammar.wording.parted)
        self._switching = grammar.wording.switching
        self._known_articles = thing_words(grammar.language).articles
        self._articles = sorted(thing_words(grammar.language).definite_of_things.intersection(own))

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        """With each of the verbs that commands begin with."""
        words = core.words
        if not 1 < len(words) <= _MOST or words[-1] not in self._switched or words[0] in verbs or any(core.breaks[1:]):
            return
        *thing, switched = words
        things = [thing] if thing[0] in self._articles else [thing, *([article, *thing] for article in self._articles)]
        for verb, named in product(sorted(verbs), things):
            yield Rewording(Utterance.in_one_breath([verb, *named, switched]), of_things_listed)
            if not self._parts:  # "schalte ein Licht" is about a light
                yield Rewording(Utterance.in_one_breath([verb, switched, *named]), of_things_listed)

    def without_verb(self, core: Utterance) -> Iterator[Rewording]:
        """What is told to be switched, of a grammar that has no verb for it: "turn the lights on", "switch on the
        lights" of "lights (on|off)"."""
        words = core.words
        if not 2 < len(words) <= _MOST + 1 or words[0] not in self._switching or any(core.breaks[1:]):
            return
        for at in {1, len(words) - 1}:
            if words[at] in self._switched:
                thing = [*words[1:at], *words[at + 1 :]]
                things = (thing, thing[1:]) if thing[0] in self._known_articles and len(thing) > 1 else (thing,)
                for named in things:
                    yield Rewording(Utterance.in_one_breath([*named, words[at]]), of_things_listed)
