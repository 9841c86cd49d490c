"""A thing that is named first, and taken up by a pronoun: "drawer one, unlock it" is "unlock drawer one",
and so is "I need drawer one, unlock it"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording, of_things_listed
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["NamedFirst"]

_MOST = 7
"""Words of the thing, and of what somebody says who wants it."""


class NamedFirst:
    """Reads it with the thing in the place of the pronoun."""

    def __init__(self, grammar: Grammar) -> None:
        # Languages in which it agrees with the article have more of it, in "taken_up".
        self._wishes = PhraseSet(words for words in grammar.wording.wishes_done if len(words) > 1)
        self._pronouns = PhraseSet(() if grammar.wording.taken_up else grammar.operators.pronoun)

    def ways(self, said: Utterance, verbs: Collection[str]) -> Iterator[Rewording]:
        """The one way, where a pause is behind the thing, and a verb behind that."""
        pause = next((at for at in range(1, len(said)) if said.breaks[at]), 0)
        if not 0 < pause <= _MOST or any(said.breaks[pause + 1 :]) or said.words[pause] not in verbs:
            return
        thing, order = said.words[self._wishes.at(said.words, 0) : pause], said.words[pause:]
        found = self._pronouns.find(order, 1)
        if (
            found is None
            or not thing
            or any(word in verbs for word in thing)
            or self._pronouns.at(thing, 0) == len(thing)
        ):
            return
        at, length = found
        if self._pronouns.find(order, at + length) is None:
            yield Rewording(Utterance.in_one_breath([*order[:at], *thing, *order[at + length :]]), of_things_listed)
