"""A command that is joined with a stop at last: "go to the lab and stop", "turn left and wait there"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise

from intent_engine.language.grammar import MOTIONS, Grammar
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.negations.doing import verbs
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.templates.template_tree import first_words
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.thing_words import thing_words

__all__ = ["EndsAtRest"]


class EndsAtRest:
    """Tells whether such a stop is the end of the command before it, or another command."""

    def __init__(self, phrases: Phrases, grammar: Grammar) -> None:
        self._phrases = phrases
        self._grammar = grammar
        known = thing_words(grammar.language)
        self._where, self._persons = known.where, known.persons
        self._definite, self._itself = known.definite, known.itself

    def only(self, words: list[str], end: int, after: int) -> bool:
        """Whether what follows a command is a stop, or is joined with it and only says to wait where it ends: "and wait
        *there*". "And hold on" may take it back."""
        holds = self._phrases.objections.hold.at(words, after) == len(words) - after
        waits = after > end and holds and words[-1] in self._where
        return (waits or self._phrases.only_stops(words, after)) and not self._names_what(words[after:])

    def another(self, stop: list[str]) -> bool:
        """Whether a stop is no mere end of the command before it, but of something else: "turn left and *cancel the
        mission*", "... and *stop following me*"."""
        if self._phrases.cancel.at(stop, 0) or not self._persons.isdisjoint(stop) or self._names_what(stop):
            return True
        length = self._phrases.stop.at(stop, 0)
        doing = stop[length : length + 1] if length else []
        return any(verb in self.acting for word in doing for verb in verbs(word, self._grammar.language))

    def at_rest(self, clause: Clause, stop: Sequence[str]) -> Clause:
        """A command that is joined with a stop at last, which is told to be part of it: every command ends with the
        robot at rest. Only what goes on until it is stopped, would not have begun: "follow me and stay"."""
        said = " ".join(stop)
        if clause.reading is not None and clause.reading.intent.name in self._going_on:
            told = f"{said!r} would end at once what was told before it; say one of them"
            return Clause(clause.reading, reason=told, alternatives=(described(clause.reading), said), ambiguous=True)
        told = f"every command ends at rest, also without {said!r}"
        return replace(clause, reason="; ".join(filter(None, (clause.reason, told))))

    @cached_property
    def _going_on(self) -> frozenset[str]:
        """The intents whose doing the grammar has a stop for, by its name, and which are no motion: who writes "stop
        following" has a robot that follows until it is told to stop."""
        grammar = self._grammar
        stops = [intent for intent in grammar.intents.values() if intent.action.type == "stop"]
        words = {word for intent in stops for one in intent.all_sentences for word in words_in(one.template)}
        ended = {verb for word in words for verb in verbs(word, grammar.language)}
        begun: dict[bool, dict[str, frozenset[str]]] = {True: {}, False: {}}
        for intent in grammar.intents.values():
            verbs_of = (first_words(one.template, grammar.phrases)[0] for one in intent.sentences)
            begun[intent.action.type in MOTIONS][intent.name] = frozenset[str]().union(*verbs_of)
        ended = ended.difference(*begun[True].values())
        return frozenset(name for name, first in begun[False].items() if not ended.isdisjoint(first))

    @cached_property
    def acting(self) -> frozenset[str]:
        """Verbs of what a command does not end by itself: "follow", but not "roll"."""
        grammar = self._grammar
        sentences = (
            sentence
            for intent in grammar.intents.values()
            if intent.action.type not in (*MOTIONS, "stop")
            for sentence in intent.sentences
        )
        begun = (first_words(sentence.template, grammar.phrases)[0] for sentence in sentences)
        return frozenset[str]().union(*begun)

    def _names_what(self, stop: list[str]) -> bool:
        """Whether a stop names what is to stop, other than the robot itself: "kill *the motors*"."""
        return any(word in self._definite and after not in self._itself for word, after in pairwise(stop))
