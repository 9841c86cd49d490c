"""Orders with something before the verb with which somebody is asked: "die Kiste stellst du bitte ins Regal" is "stell
die Kiste ins Regal", "im Flur machen Sie bitte das Licht an" is "im Flur mach das Licht an"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.formal import Formal
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbSecond"]

_MOST = 6
"""Words before the verb."""


class VerbSecond:
    """Reads such an order as it is told.

    Args:
        grammar: whose language has its verbs second.
        forms: how somebody is asked, each with how it is told.
    """

    def __init__(self, grammar: Grammar, *forms: Formal) -> None:
        wording = grammar.wording
        self._leads = wording.leads
        # A thing in the accusative is nobody who does anything.
        self._things = thing_words(grammar.language).done_to if wording.parted else frozenset()
        self._forms = forms

    def ways(self, core: Utterance) -> Iterator[Utterance]:
        """The one way: the verb before a thing, or behind how or where it is done. A word that asks for it makes an
        order of it: "die Kiste stellst du ins Regal" may tell what somebody always does.

        Args:
            core: what was said, without its fillers.
        """
        if not self._things or any(core.breaks[1:]):
            return
        first = core.words[0]
        for at in range(1, min(len(core), _MOST + 1)):
            for form in self._forms:
                if (told := form.told_at(core, at)) is None:
                    continue
                length, verb = told
                before, behind = core.words[:at], core.words[at + length :]
                if first in self._things:
                    yield Utterance.in_one_breath([*verb, *before, *behind])
                elif first in self._leads:
                    yield Utterance.in_one_breath([*before, *verb, *behind])
                return
