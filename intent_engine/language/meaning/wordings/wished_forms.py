"""The verb that stands last behind what wishes or begs: "ich möchte, dass du die Tasse *nimmst*", "ich bitte dich, die
Tasse *zu nehmen*"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.verb_forms import infinitives

__all__ = ["WishedForms"]

TO = "zu"
"""Stands before the infinitive that is begged for, or within it: "zu fahren", "vorzufahren"."""


class WishedForms:
    """Reads such a verb in the infinitive, as behind "kannst du"."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        self._wishing, self._begging = grammar.wording.wishing, grammar.wording.begging

    def ways(self, said: Utterance, asked: Utterance) -> list[Utterance]:
        """What is asked for with its verb in the infinitive; as it was said where nothing wishes or begs.

        Args:
            said: all that was said.
            asked: that without what asks for it.
        """
        wish = said.words[: self._wishing.at(said.words, 0)]
        *before, last = asked.words
        if wish and wish[-1] not in self._grammar.wording.asked:  # the verb of "dass Sie" is an infinitive
            return [Utterance([*before, verb], asked.breaks) for verb in infinitives(last, self._grammar)]
        begs = self._begging.at(said.words, 0) > 0
        return [*self._without_to(asked)] or [asked] if begs else [asked]

    def _without_to(self, asked: Utterance) -> Iterator[Utterance]:
        """What is begged for without its "zu"."""
        *before, last = asked.words
        if before and before[-1] == TO:
            yield asked.cut(len(asked) - 2, len(asked) - 1)
        for particle in self._grammar.wording.parted:
            verb = last.removeprefix(particle + TO)
            if verb not in ("", last):
                yield Utterance([*before, particle + verb], asked.breaks)
