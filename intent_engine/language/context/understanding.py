"""What a text means after what was said before it: what it points back to, answers, takes back or goes against."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Generic, Protocol, TypeVar

from intent_engine.actions import Action, Custom, actions_of
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Cause, Interpretation, Status
from intent_engine.language.context.answers import Answers, answered
from intent_engine.language.context.done_again import AGAIN
from intent_engine.language.context.going_on import as_joined, goes_on_from
from intent_engine.language.context.named_before import named_before
from intent_engine.language.context.references import Before, resolve
from intent_engine.language.context.said_instead import may_forbid, said_instead
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.wordings.pronouns import NameSaid
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.unreadable import as_read
from intent_engine.needs import MOVING, Needs

__all__ = ["Parses", "Understanding"]


class Parses(Protocol):
    """What understands the text of one language: an interpreter, or a witness of one."""

    matcher: Matcher

    def interpret(
        self, text: str, state: Collection[str] = (), *, spoken: bool = False, heard: bool = False
    ) -> Interpretation: ...

    def denied_part(self, text: str, before: str, state: Collection[str] = ()) -> tuple[Action, ...]: ...

    def objection(self, text: str, before: str, state: Collection[str] = ()) -> Interpretation | None: ...

    def named_before(self, text: str, before: str, state: Collection[str] = ()) -> list[NameSaid]: ...


_Parser = TypeVar("_Parser", bound=Parses)


class Understanding(Generic[_Parser]):
    """Understands what is said next.

    Args:
        parsers: of the languages in which it may be said.
        last, state, spoken, heard: as for :meth:`~intent_engine.engine.IntentEngine.parse`.
    """

    __slots__ = ("_before", "_by_voice", "_done", "_last", "_needs", "_parsers", "_spoken", "_state")

    def __init__(
        self,
        parsers: Sequence[_Parser],
        last: Before | None = None,
        state: Collection[str] = (),
        spoken: bool = False,
        heard: bool = False,
    ) -> None:
        self._parsers, self._last, self._state, self._spoken = parsers, last, state, spoken
        self._by_voice = spoken or heard
        self._before: tuple[Action, ...] | None = None
        self._needs: tuple[Needs, ...] = ()
        self._done = ""
        if last is not None:
            self._before, self._needs, self._done = _done_before(last)

    def of(self, text: str) -> tuple[Interpretation, _Parser]:
        """What a text means, and the parser that says so."""
        found, parser = self._by_itself(text)
        answer = self._as_answer(text, found)
        return as_read(text, found if answer is None else answer), parser

    def answer(self, text: str) -> Interpretation | None:
        """What a text means as the answer to what ``last`` asks back; None: it is none."""
        answer = self._as_answer(text, self._by_itself(text)[0])
        return answer if answer is None else as_read(text, answer)

    def _as_answer(self, text: str, found: Interpretation) -> Interpretation | None:
        """The same, where it is known what it means by itself."""
        asked = self._last
        if not isinstance(asked, Interpretation) or asked.question is None:
            return None
        # The first part was called for already.
        called = Understanding(self._parsers, asked, self._state, heard=self._by_voice)
        readers = [Answers(parser.matcher.grammar) for parser in self._parsers]
        return answered(asked, text, found, readers, lambda whole: called._by_itself(whole)[0], called=self._spoken)

    def _by_itself(self, text: str) -> tuple[Interpretation, _Parser]:
        """What a text means whatever was asked, with what it points back to, and the parser that says so."""
        before, done = self._before, self._done
        try:
            found, parser = self._first_accepted(text)
        except ConfigError as error:  # a grammar too ambiguous to be walked; a text is never the cause
            return Interpretation(text, Status.REJECTED, reason=str(error)), self._parsers[0]
        by_part = parser.denied_part(text, done, self._state) if done and not (found.actions or found.denied) else ()
        if by_part:  # "not the kitchen"
            found = replace(found, denied=by_part)
        does = found.actions or by_part
        if done and not does and (more := self._going_on(text, done)) is not None:
            found, parser = more
            return resolve(found, before, parser.matcher.grammar, self._needs, self._state), parser
        if MOVING in self._state and not does and (stop := self._objection(text, done, parser)) is not None:
            return stop, parser  # "no, the lab", long after "go to the kitchen"; "no, don't turn left, turn right"
        at_rest = MOVING not in self._state
        if done and not found.actions and at_rest and (instead := self._instead(text, done)) is not None:
            return instead
        if done and not (does or found.denied) and (named := self._named_before(text, done, found)) is not None:
            found, parser = named
        if done and not (found.actions or found.denied) and (again := self._again(text)) is not None:
            return again
        if before is not None or len(found.actions) > 1 or found.corrected:
            found = resolve(found, before, parser.matcher.grammar, self._needs, self._state)
        if self._by_voice and Cause.NO_COMMAND in found.causes:
            found = replace(found, question=None)  # it may be talk, to which some sentence is always the nearest
        if found.question is not None and before:
            found = replace(found, question=replace(found.question, before=before, needs=self._needs, said_before=done))
        return found, parser

    def _going_on(self, text: str, done: str) -> tuple[Interpretation, _Parser] | None:
        """What a text that is typed adds to what was done before, and the parser that says so; None: nothing."""
        for parser in self._typed_behind(text):
            grammar = parser.matcher.grammar
            joints, wording = grammar.operators.sequence, grammar.wording
            more = as_joined(text, joints, wording.besides, grammar.language, wording.turns_to)
            parted = thing_words(grammar.language).alone.union(wording.parted)
            meaning = partial(self._resolved, parser)
            if more and (found := goes_on_from(more, done, self._before or (), meaning, parted)) is not None:
                return found, parser
        return None

    def _instead(self, text: str, done: str) -> tuple[Interpretation, _Parser] | None:
        """What one puts in the place of what was done before, if the robot is at rest; None: nothing."""
        for parser in self._typed_behind(text):
            grammar = parser.matcher.grammar
            correction, wording = grammar.operators.correction, grammar.wording
            excludes = PhraseSet(wording.excludes)  # "not the lab, the hall" is "no, not the lab, the hall"
            other = as_joined(text, correction, wording.in_its_place, grammar.language, excludes)
            listed = [name for name, slot in grammar.slots.items() if slot.type not in FREE_KINDS]
            meaning = partial(self._resolved, parser)
            if not other or may_forbid(other, grammar, meaning):
                continue
            if (found := said_instead(other, done, self._before or (), meaning, listed)) is not None:
                return found, parser
        return None

    def _again(self, text: str) -> tuple[Interpretation, _Parser] | None:
        """What was done last, once more, where no command of the grammar does that; None: it is not asked for."""
        for parser in self._typed_behind(text):
            grammar = parser.matcher.grammar
            said = Utterance.of(text, grammar.language)
            words = said.without(PhraseSet(grammar.fillers)).words
            thanks = grammar.wording.thanking.find(said.words)  # "thanks again", but "again, thanks"
            own = any(intent.action.name == AGAIN for intent in grammar.intents.values())
            if own or not words or grammar.wording.done_again.at(words, 0) < len(words):
                continue
            if thanks is not None and words[0] not in said.words[: thanks[0]]:
                continue
            asked = Interpretation(text, Status.ACCEPTED, AGAIN, actions=(Custom(AGAIN),), confidence=1.0)
            found = resolve(replace(asked, needs=(Needs(AGAIN),)), self._before, grammar, self._needs, self._state)
            return found, parser
        return None

    def _resolved(self, parser: _Parser, text: str) -> Interpretation:
        """What a text means, with what it points back to; what was said before may point back itself."""
        found = parser.interpret(text, self._state)
        return resolve(found, self._before, parser.matcher.grammar, self._needs, self._state)

    def _objection(self, text: str, done: str, parser: _Parser) -> Interpretation | None:
        """The stop of a robot that moves, where something else is said than what it does; None: it is not."""
        grammar = parser.matcher.grammar
        other = as_joined(text, grammar.operators.correction, grammar.wording.in_its_place, grammar.language)
        stop = parser.objection(other or text, done, self._state)
        if stop is None or other in ("", text):
            return stop
        return replace(stop, text=text, reason=f"{text!r} said to a robot that moves")

    def _named_before(self, text: str, done: str, found: Interpretation) -> tuple[Interpretation, _Parser] | None:
        """What one means with a name in the place of its pronoun, and the parser that says so; None: nothing."""
        for parser in self._parsers:
            meaning = partial(parser.interpret, state=self._state, spoken=self._spoken, heard=self._by_voice)
            names = parser.named_before(text, done, self._state)
            if names and (meant := named_before(text, found, names, meaning)) is not None:
                return meant, parser
        return None

    def _typed_behind(self, text: str) -> Iterator[_Parser]:
        """The parsers in whose language a text may be a part of a command, that follows what was typed before, and
        answers no question. What is spoken has its time, which is not known here: "and Ben", a minute later, is talk.
        So may be what asks with no more than a name: "and the fan?"."""
        asks = isinstance(self._last, Interpretation) and self._last.question is not None
        if self._before and not (self._by_voice or asks or "?" in text):
            yield from self._parsers

    def _first_accepted(self, text: str) -> tuple[Interpretation, _Parser]:
        """The interpretation of the first language that accepts a text; else the one that says most about it."""
        first: tuple[Interpretation, _Parser] | None = None
        for parser in self._parsers:
            found = parser.interpret(text, self._state, spoken=self._spoken, heard=self._by_voice)
            if found.status is Status.ACCEPTED:
                return found, parser
            if first is None or (first[0].status is Status.REJECTED and found.status is not Status.REJECTED):
                first = found, parser
        assert first is not None
        return first


def _done_before(last: Before) -> tuple[tuple[Action, ...], tuple[Needs, ...], str]:
    """What was done before: its actions, what each of them asks of the states of the robot, and its text; the last two
    are empty if that is not known. A question leaves what was done before it."""
    if not isinstance(last, Interpretation):
        return actions_of("last", last), (), ""
    if (asked := last.question) is not None:
        return asked.before, asked.needs, asked.said_before
    return last.actions, last.needs, last.text if last.actions else ""
