"""What somebody wants to have done, where a grammar tells to do it: "I want the beacon turned on", "let's have the gate
open", "get the dome closed", "I need the heater at sixty percent"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording, of_things_listed
from intent_engine.language.meaning.wordings.verbless import Verbless
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.verb_forms import told_forms_of

__all__ = ["WishedDone"]

_NOT_DONE = ("s", "ing")
"""How a form of a verb ends that does not say that something was done: "closes", "closing"."""


class WishedDone:
    """Reads it with its verb first.

    Args:
        grammar: whose it is.
        verbless: reads what is told without a verb.
    """

    def __init__(self, grammar: Grammar, verbless: Verbless) -> None:
        wording = grammar.wording
        wishes_for = [words for words in wording.wishes_for if " ".join(words) not in wording.takes_along]
        self._wishes = PhraseSet((*wording.wishes_done, *wishes_for))
        self._asking = PhraseSet(wishes_for)
        self._to_be = wording.to_be
        self._levels = wording.levels
        self._language = grammar.language
        self._verbless = verbless

    def ways(self, core: Utterance, verbs: Collection[str], *, asks: bool) -> Iterator[Rewording]:
        """With each verb of which a word tells that it was done; or else with those that set something to so much, or
        switch it.

        Args:
            core: the words of one command.
            verbs: with which commands begin.
            asks: whether it is written as a question: "have the lights turned on?" asks whether.
        """
        length = (self._asking if asks else self._wishes).at(core.words, 0)
        if not 0 < length < len(core) - 1 or any(core.breaks[1:]):
            return
        thing = core.part(length, len(core))
        done = [*self._of_done(thing.words, verbs)]
        yield from done or self._of_how_it_is(thing, verbs)

    def _of_done(self, thing: list[str], verbs: Collection[str]) -> Iterator[Rewording]:
        for at in range(1, len(thing)):
            before = thing[: at - self._to_be.ends(thing[:at])]
            for verb in dict.fromkeys(self._done(thing[at])):
                if verb in verbs:
                    yield Rewording(Utterance.in_one_breath([verb, *before, *thing[at + 1 :]]), of_things_listed)

    def _of_how_it_is(self, thing: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        for verb in sorted(self._levels.keys() & verbs):
            if not self._levels[verb].isdisjoint(thing.words[1:-1]):
                yield Rewording(Utterance.in_one_breath([verb, *thing.words]), of_things_listed)
        yield from self._verbless.ways(thing, verbs)

    def _done(self, word: str) -> Iterator[str]:
        yield word  # "set", "open"
        if not word.endswith(_NOT_DONE):
            yield from told_forms_of(word, self._language)
