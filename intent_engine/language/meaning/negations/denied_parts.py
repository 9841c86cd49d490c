"""What is not to be done by a part of it: "not the kitchen", after "go to the kitchen"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.actions import Action
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.verb_forms import verbs_told

__all__ = ["DeniedParts"]


class DeniedParts:
    """What is named takes the place of its like in a command, and makes the one that shall not be done."""

    def __init__(self, commands: Commands, corrections: Corrections) -> None:
        self._commands = commands
        self._corrections = corrections
        grammar = commands.matcher.grammar
        known = thing_words(grammar.language)
        self._articles, self._definite, self._stand_ins = known.articles, known.definite, grammar.wording.standing_for

    def denied(self, clause: Clause, named: Utterance, state: Collection[str]) -> Action | None:
        """What is denied of a command that was understood by naming a part of it; None: nothing."""
        if clause.reading is None or not clause.accepted:
            return None
        said = Utterance.in_one_breath(list(clause.reading.words))
        if self._is_told_of(clause.reading, named):
            return clause.action
        for one in self._ways_to_name(named):
            if self._goes_on_as(clause, one, state):
                return clause.action
            if (action := self.with_part(said, one, state)) is not None:
                return action
        for at in range(1, len(named)):  # "not left right", as it is heard without its pause
            shorter, instead = named.part(0, at), named.part(at, len(named))
            if self._corrections.instead(said, instead, state) is None:
                continue
            if (action := self.with_part(said, shorter, state)) is not None:
                return action
        return None

    def by_verb(self, words: Sequence[str], done: Sequence[Clause]) -> tuple[Action, ...]:
        """What is denied by the verb with which it was told, and no more than a pronoun for all the rest: "don't bring
        it", after "bring me the cup". ``words`` are those beside the negation."""
        grammar = self._commands.matcher.grammar
        beside = {*grammar.wording.denying, *(word for words in grammar.operators.pronoun for word in words)}
        rest = [word for word in words if word not in beside]
        if len(rest) != 1 or rest[0] in self._commands.not_verbs:
            return ()
        verbs = {rest[0], *(verb for _, verb in verbs_told(rest, grammar))}
        denied: list[Action] = []
        told = False
        for reading, action in ((clause.reading, clause.action) for clause in done):
            if reading is None or action is None:
                continue
            if reading.sentence not in reading.intent.then:  # else it has the verb of the one before
                told = reading.words[0] in verbs
            denied += [action] if told else []
        return tuple(denied)

    def _ways_to_name(self, named: Utterance) -> Iterator[Utterance]:
        """A name as it was said, and without the article with which it is told of again: "order a tea", "not *the*
        tea"."""
        yield named
        if len(named) > 1 and named.words[0] in self._definite:
            yield named.part(1, len(named))

    def _is_told_of(self, reading: Reading, named: Utterance) -> bool:
        """Whether what is named is just what a slot of a command holds, or tells which that is: "the table" of "put it
        on the table", and "the red one" of "take the red cup"."""
        words = [word for word in named.words if word not in self._articles]
        which = words[:-1] if words and words[-1] in self._stand_ins else []
        held = [reading.words[slot.start : slot.end] for slot in reading.slots]
        bare = [[word for word in some if word not in self._articles] for some in held]
        return bool(words) and (words in bare or (bool(which) and any(set(which) <= set(some[:-1]) for some in bare)))

    def _goes_on_as(self, clause: Clause, named: Utterance, state: Collection[str]) -> bool:
        """Whether a command goes on from another in just these words: "the plate", of "pick up the cup and the
        plate"."""
        if clause.reading is None or clause.reading.sentence not in clause.reading.intent.then:
            return False
        again = self._commands.exact(named.words, state, clause.reading.intent.name)
        return again is not None and again.action == clause.action

    def with_part(self, said: Utterance, named: Utterance, state: Collection[str]) -> Action | None:
        """A command that was done, with what is named in the place of its like; None: there is no like of it."""
        denied = said if self._corrections.is_said(said, named, state) else None
        denied = denied or self._corrections.instead(said, named, state)
        clause = self._commands.exact(denied.words, state) if denied is not None else None
        return clause.action if clause is not None else None
