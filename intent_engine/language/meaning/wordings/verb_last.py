"""Orders whose verb stands last in the infinitive, "Ventil drei schließen": German tells so to nobody by name."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property

from intent_engine.actions import Action
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.command import LEAST_WORDS, Commands
from intent_engine.language.meaning.negations.forbidden_verbs import last_verb_first
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.parts import part_by_part
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbLast"]

_PLURALS = ("n", "s", "er", "el")
"""How German names of several things end, besides "-e", in which names of one feminine thing end as well."""


class VerbLast:
    """Reads such orders as a grammar has them, the verb first.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
    """

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._phrases = phrases
        self._commands = commands
        self._grammar = commands.matcher.grammar
        self._known = thing_words(self._grammar.language)

    @cached_property
    def _articles(self) -> list[Utterance]:
        return [Utterance.in_one_breath([word]) for word in sorted(self._known.definite & self._words)]

    @cached_property
    def _words(self) -> frozenset[str]:
        return vocabulary(self._grammar)

    def told(self, said: Utterance, state: Collection[str]) -> Utterance | None:
        """What was said, each order of it with its verb first. None: none has its verb last, or one could be two.

        Args:
            said: the words, without those that say nothing.
            state: of the robot.
        """
        return part_by_part(said, self._phrases, lambda part: self._order(part, state))

    def _order(self, part: Utterance, state: Collection[str]) -> Utterance | None:
        if len(part) < LEAST_WORDS or not part.words[-1].endswith("n"):
            return None
        named = [] if part.words[0] in self._known.articles else self._articles
        found: dict[Action | None, Utterance] = {}
        for said in (part, *(part.with_other(0, 0, article) for article in named)):  # "Tür öffnen"
            for order in last_verb_first(said, self._grammar):
                clause = self._commands.exact(order.words, state, breaks=order.breaks)
                if clause is None or not clause.accepted or clause.reading is None:
                    continue
                if self._tells_by_itself(part, clause.reading):
                    found.setdefault(clause.action, order)
        return next(iter(found.values())) if len(found) == 1 else None

    def _tells_by_itself(self, part: Utterance, order: Reading) -> bool:
        """Whether it is an order though no word asks for it, and does not tell what somebody does: "die Türen
        schließen", "sie drehen".

        A sentence that tells of somebody begins with him and has its verb second, so that a thing in the accusative or
        a way before the verb can only be told to do; and a verb that is parted would be, were it told of somebody.
        """
        known, wording = self._known, self._grammar.wording
        first, *between, last = part.words
        if first in known.pronouns or first in wording.before_verbs:
            return False
        several = first in known.of_several
        free = [order.words[slot.start] for slot in order.slots if slot.slot.type in FREE_KINDS]
        if not wording.before_verbs.isdisjoint(free) or (free and (several or first not in known.done_to)):
            return False  # "greif sich" is nobody's, and "Leute nehmen" may be about people
        parted = order.words[-1] in wording.parted and last.startswith(order.words[-1])
        if parted or not several:
            return first not in known.articles or first in known.done_to
        return bool(between) and not self._is_of_several(between[-1])

    def _is_of_several(self, noun: str) -> bool:
        return noun.endswith(_PLURALS) or (noun.endswith("e") and noun[:-1] in self._words)
