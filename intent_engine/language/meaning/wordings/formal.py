"""Commands as they are told to a stranger: "schalten Sie die Lampe ein" is "schalte die Lampe ein", and "allumez la
lampe" is "allume la lampe", of a grammar that has no other verb."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import cached_property

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["Formal"]

_LEAST_LETTERS = 2
"""Of a verb before its ending."""


class Formal:
    """Reads such commands as they are told to a friend."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        pairs = (pair.partition("/") for pair in commands.matcher.grammar.wording.formal)
        self._forms = [(form.split(), told.split()) for form, _, told in pairs]
        self._phrases = phrases
        self._commands = commands

    @cached_property
    def _grammar_says(self) -> bool:
        """Whether the grammar has such a form itself, and so says of which verbs: "finden Sie" may only ask."""
        verbs, strict = self._commands.first_words, self._commands.matcher.strict
        for verb in verbs:
            said = (Utterance.in_one_breath([verb, *form[1:]]) for form, _ in self._forms)
            if any(self._told(one, 0, verbs) and strict.walk(one.words)[1] is not None for one in said):
                return True
        return False

    def to_a_friend(self, core: Utterance) -> Utterance | None:
        """What was said, without its fillers, with all verbs with which its commands begin in the form that the grammar
        has. None: none has another form."""
        verbs = self._commands.first_words
        if not self._forms or self._told_nowhere(core) or self._grammar_says:
            return None
        said, place = core, 0
        while place < len(said):
            rest = said.words[place:]
            place += max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            told = self._told(said, place, verbs)
            if told is not None:
                length, verb = told
                said = said.with_other(place, place + length, Utterance.in_one_breath(verb))
            later = range(place + 1, len(said))
            place = next((at for at in later if said.breaks[at] or self._phrases.goes_on(said.words[at:])), len(said))
        return said if said.words != core.words else None

    def _told_nowhere(self, core: Utterance) -> bool:
        """A quick look: whether no word could be such a form."""
        verbs = self._commands.first_words
        return not any(self._told(core, place, verbs) for place in range(len(core)))

    def _told(self, said: Utterance, place: int, verbs: Collection[str]) -> tuple[int, Sequence[str]] | None:
        """How many words from a place on are such a form, and how they are told to a friend."""
        for form, told in self._forms:
            words = said.words[place : place + len(form)]
            if len(words) < len(form) or list(form[1:]) != words[1:] or any(said.breaks[place + 1 : place + len(form)]):
                continue
            ending, verb = form[0], told[0]
            if ending.startswith("-"):
                stem = words[0].removesuffix(ending[1:])
                if stem == words[0] or len(stem) < _LEAST_LETTERS:
                    continue
                verb = stem + verb.removeprefix("-")
            elif words[0] != ending:
                continue
            if verb in verbs:
                return len(form), (verb, *told[1:])
        return None
