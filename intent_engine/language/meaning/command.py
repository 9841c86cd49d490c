"""One command: the sentence that words are, exactly; else the one that they sound like."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import cached_property

from intent_engine.actions import Action, Stop
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.free_words_kept import FreeWordsKept
from intent_engine.language.meaning.not_commands.share_of_a_turn import share_of_a_turn
from intent_engine.language.meaning.not_commands.sign_and_side import sign_and_side
from intent_engine.language.meaning.problems import far_off, problem_rank, tells_what
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.meaning.wordings.ways_on import WaysOn
from intent_engine.language.meaning.wordings.whose_place import WhosePlace
from intent_engine.language.pattern.patterns import Patterns
from intent_engine.language.quantities import Relative, evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.slots.action_builder import CannotActError, build_action, check_speeds
from intent_engine.language.slots.adjacent_numbers import cuts_digits, is_number, number_said_apart
from intent_engine.language.templates.plurals import Plurals
from intent_engine.language.words.thing_words import ARTICLES, thing_words
from intent_engine.language.words.verb_forms import told_forms_of

__all__ = ["LEAST_WORDS", "Commands", "forbidden"]

_STEM = 3
"""Letters with which a verb begins in each of its forms."""
LEAST_WORDS = 2
"""Of a command among others: a word alone ("back", "right") is as likely the end of something else."""
_NAME_OR_WAY = "{!r} may be a thing, or {!r} say where it goes; say it without"
_NUMBER_PARTED = "{!r} may be a number of its own, as it was said; say it again in one breath"
_OF_A_PLACE = "{!r} is no part of a name, since the grammar has a place for it; say it as the grammar has it"
_PARTED = "{!r} after a pause is no part of a name; say it in a sentence of its own, or without the pause"


class Commands:
    """Words to one command of a grammar, for a robot in given states."""

    def __init__(self, matcher: Matcher) -> None:
        self.matcher = matcher
        self._patterns = Patterns(matcher.grammar)
        self._whose_place = WhosePlace(matcher)
        self._ways_on = WaysOn(matcher.grammar)
        self._free = FreeWordsKept(matcher, Plurals(matcher.grammar, lambda: self.first_words))
        known = thing_words(matcher.grammar.language)
        self.not_verbs = ARTICLES | known.articles | known.alone
        """Words that are no verb of a command, though one may begin with them."""
        self._telling = known.telling

    @step(Kind.SENTENCE)
    def exact(
        self, words: list[str], state: Collection[str], after: str = "", breaks: Sequence[bool | None] = ()
    ) -> Clause | None:
        """The command that these words are, exactly; None if no sentence has them.

        ``after`` names an intent whose command they go on from: "to the bedroom". ``breaks`` tells what stands before
        each word, as in an utterance.
        """
        readings = self.readings(words, after)
        free = readings and readings[0].free_words and not after
        if free and (clause := self._without_way(readings[0], state, breaks)) is not None:
            return clause
        if readings and readings[0].free_words:
            counted = self._free.counted(words, readings[0], lambda said: self.readings(said, after))
            readings = counted or [reading for reading in readings if not self._free.points(reading)]
        if readings and readings[0].free_words > 1 and (kept := self._free.place_of(readings[0])):
            return Clause(readings[0], reason=_OF_A_PLACE.format(" ".join(kept)), at_fault=(" ".join(kept),))
        if readings and readings[0].free_words > 1 and self.may_begin_in(words[LEAST_WORDS:]):
            readings = [reading for reading in readings if not self.holds_command(reading)]
        if readings and (number := self._number_said_apart(readings[0], breaks)):
            return Clause(readings[0], reason=_NUMBER_PARTED.format(" ".join(number)), parted=True)
        if readings and readings[0].free_words > 1 and True in breaks:
            parted = [self._parted_by_command(reading, breaks) for reading in readings]
            if all(parted):
                apart = " ".join(parted[0])
                return Clause(readings[0], reason=_PARTED.format(apart), at_fault=(apart,))
            readings = [reading for reading, command in zip(readings, parted, strict=True) if not command]
        return self._choose(readings, state) if readings else None

    def _without_way(self, reading: Reading, state: Collection[str], breaks: Sequence[bool | None]) -> Clause | None:
        """The command without words that say no more of a way than it does, and are no part of the thing before them;
        None: it is none so."""
        way = self._ways_on.behind_a_name(reading)
        if way is None:
            return None
        words = reading.words
        said = [*words[: way.start], *words[way.stop :]]
        clause = self.exact(said, state, breaks=[*breaks[: way.start], *breaks[way.stop :]])
        if clause is None or not clause.accepted or not self._ways_on.may_be_a_name(words, way):
            return clause
        name = " ".join(words[way.start - 1 : way.stop])
        return Clause(reading, reason=_NAME_OR_WAY.format(name, words[way.start]), at_fault=(name,))

    def readings(self, words: list[str], after: str = "") -> list[Reading]:
        """All ways to understand words as a sentence or a pattern, the best first; ``after`` as in :meth:`exact`."""
        readings = self.matcher.read(words, after=after)
        return [*readings, *self._patterns.read(words, self.matcher)] if self._patterns and not after else readings

    def likeliest(self, words: list[str], after: str = "") -> Reading | None:
        """What words that are corrected, or correct, are a sentence of, also with a number beyond its limits; ``after``
        as in :meth:`exact`. None: of none."""
        readings = self.readings(words, after)
        best = next((one for one in readings if not one.problem), None)
        if best is None:
            return next((one for one in readings if one.understood), None)
        return (_beyond_limits(best, readings) if best.free_words else None) or best

    def accepts(self, words: list[str], state: Collection[str]) -> bool:
        """Whether the words are a command by themselves, exactly."""
        clause = self.exact(words, state)
        return clause is not None and clause.accepted

    def moves(self, words: list[str], state: Collection[str]) -> bool:
        """Whether the words are a command by themselves, and no stop."""
        clause = self.exact(words, state)
        return clause is not None and clause.accepted and not isinstance(clause.action, Stop)

    def may_go_on(self, words: Sequence[str], before: str) -> bool:
        """A quick look: whether words may be what goes on from a command of an intent."""
        automaton = self.matcher.later[before][0]
        return automaton.step(automaton.start(), words[0]) is not None

    def whole_from(self, words: Sequence[str], start: int) -> Iterator[tuple[int, list[Reading]]]:
        """Where commands of two words and more end that begin at a place, exactly, and what they are."""
        strict = self.matcher.strict
        here = strict.start()
        for end in range(start + 1, len(words) + 1):
            following = strict.step(here, words[end - 1])
            if following is None:
                return
            here = following
            if end >= start + LEAST_WORDS and strict.accepting(here):
                readings = [one for one in self.matcher.read(list(words[start:end])) if not one.problem]
                if readings:
                    yield end, readings

    @cached_property
    def first_words(self) -> frozenset[str]:
        """Words with which a command may begin."""
        strict = self.matcher.strict
        return frozenset(strict.next_words(strict.start()))

    @cached_property
    def doing_begins(self) -> frozenset[str]:
        """The same, and those with which patterns begin."""
        return self.first_words | self.matcher.patterns.first_words

    @cached_property
    def verbs(self) -> frozenset[str]:
        """Those with which one may begin, and which may be verbs; "ninety" of "ninety first gear" is none."""
        language = self.matcher.grammar.language
        return frozenset(word for word in self.first_words - self.not_verbs if not is_number(word, language))

    def may_begin_in(self, words: Sequence[str]) -> bool:
        """A quick look: whether any word could be the verb of a command."""
        return not self.verbs.isdisjoint(words)

    def may_have_a_verb(self, words: Sequence[str]) -> bool:
        """The same, where it may be in another form, or parted from what it begins with: "locking", "aufschließen"."""
        return any(verb in word for verb in self._stems for word in words)

    @cached_property
    def _stems(self) -> frozenset[str]:
        return frozenset(verb[:_STEM] for verb in self.verbs)

    def opens_with_a_verb(self, reading: Reading) -> bool:
        """Whether a command begins with a word of its sentence: "go back", not "two meters ahead" or "to the left"."""
        return reading.words[0] not in self.not_verbs and all(slot.start > 0 for slot in reading.slots)

    def lists(self, words: list[str]) -> bool:
        """Whether words are a command without a verb, as one says it in a list: "left, right, left"."""
        if not words or words[0] not in self.first_words:
            return False
        readings = [reading for reading in self.matcher.read(words) if not reading.problem]
        return bool(readings) and not any(map(self.opens_with_a_verb, readings))

    def holds_command(self, reading: Reading, words: Sequence[str] = ()) -> bool:
        """Whether free words are the end of a thing's name and the beginning of a command: "the cup go forward".

        ``words`` go on after those of the reading, and a command that begins in it may end there.
        """
        words = words or reading.words
        for slot in reading.slots:
            if slot.slot.type not in FREE_KINDS:
                continue
            for place in range(slot.start + 1, slot.end):
                if words[place] in self.verbs and any(
                    self.opens_with_a_verb(one) for _, readings in self.whole_from(words, place) for one in readings
                ):
                    return True
        return False

    def _number_said_apart(self, reading: Reading, breaks: Sequence[bool | None]) -> Sequence[str]:
        """The number behind a pause or a filler that may be none of the quantity before it; empty: there is none."""
        if breaks.count(False) == len(breaks):
            return ()
        return number_said_apart(reading, breaks, self.matcher.grammar.language)

    def _tells_of_a_name(self, reading: Reading) -> bool:
        """Whether a listed name is only like what was said, which goes on to tell of it: "forward *is* slow"."""
        return any(
            slot.slot.type not in FREE_KINDS
            and isinstance(slot.value, str)
            and not self._telling.intersection(reading.words[slot.start : slot.end]) <= set(slot.value.split())
            for slot in reading.slots
        )

    def _parted_by_command(self, reading: Reading, breaks: Sequence[bool | None]) -> Sequence[str]:
        """The words after a pause within free words that are a command by themselves, or how one is done, up to the
        next pause or the end: "the cup, *back*" and "the cup, *faster*" are no names of things. Nor is what tells of
        something: "the cup, *you're nice*". A pause alone proves nothing: "the big, red cup". Empty: none are."""
        words, language = reading.words, self.matcher.grammar.language
        for slot in reading.slots:
            if slot.slot.type not in FREE_KINDS or slot.slot.dictation:
                continue
            for place in range(slot.start + 1, slot.end):
                ends = (*(at for at in range(place + 1, len(words)) if breaks[at]), len(words))
                for end in ends if breaks[place] else ():
                    apart = words[place:end]
                    if self.matcher.values.tells_besides(slot.slot, apart):
                        return apart
                    if isinstance(evaluate(apart, "speed", language), Relative):
                        return apart
                    if apart[0] in self.first_words and any(not one.problem for one in self.matcher.read([*apart])):
                        return apart
        return ()

    @step(Kind.MISHEARD)
    def misheard(
        self, words: list[str], state: Collection[str], after: str = "", breaks: Sequence[bool | None] = ()
    ) -> Clause | None:
        """The command that the words sound like: the sentence exactly, its names nearly. None if none comes near.

        ``after`` and ``breaks`` as for :meth:`exact`.
        """
        readings = [one for one in self.matcher.read(words, loose=True, after=after) if not self.holds_command(one)]
        readings = [one for one in readings if not one.free_words or self._ways_on.behind_a_name(one) is None]
        readings = [one for one in readings if not (one.free_words and self._free.points(one))]
        readings = [one for one in readings if not self._number_said_apart(one, breaks)]
        readings = [one for one in readings if not cuts_digits(words, one, self.matcher.grammar.language)]
        if not self._telling.isdisjoint(words):
            readings = [one for one in readings if one.problem or not self._tells_of_a_name(one)]
        if True in breaks:
            readings = [one for one in readings if not self._parted_by_command(one, breaks)]
        if readings and self._tells_of(words):
            readings = [one for one in readings if not any(slot.start == 0 for slot in one.slots)]
        if not readings:
            return None
        # Something must have been heard as it is: "lft" alone is nothing, and "jump" no direction that is missing.
        good = [reading for reading in readings if not reading.problem and reading.heard_exactly]
        wrong = [one for one in readings if one.problem and tells_what(one) and not far_off(one)]
        if good:
            best = max(good, key=lambda reading: (reading.intent.priority, -reading.free_words, reading.score))
            level = [
                reading
                for reading in good
                if reading.intent.priority == best.intent.priority
                and reading.free_words == best.free_words
                and reading.score > best.score - 0.08
            ]
            return self._choose([best, *(reading for reading in level if reading is not best), *wrong], state)
        return self._choose([min(wrong, key=problem_rank)], state) if wrong else None

    def _tells_of(self, words: Sequence[str]) -> bool:
        """Whether the first word says that somebody does or did what a command says in its list of verbs: "opens the
        gripper", "activated the pump". A verb is what "the" may stand behind: "lights on" are more of "light"."""
        if words[0] in self.first_words:
            return False
        strict = self.matcher.strict
        verbs = told_forms_of(words[0], self.matcher.grammar.language)
        begun = (strict.step(strict.start(), verb) for verb in verbs if verb in self.first_words)
        return any(state is not None and strict.step(state, "the") is not None for state in begun)

    @step(Kind.CHOICE)
    def _choose(self, readings: list[Reading], state: Collection[str]) -> Clause:
        """The one meaning of readings that are best first, or why there is none."""
        best = readings[0]
        if best.problem:
            return self._too_much(best) or _problem_clause(best)
        if best.free_words and (beyond := _beyond_limits(best, readings)) is not None:
            return _problem_clause(beyond)
        allowed = readings
        if len(readings) > 1 or forbidden(best, state):
            allowed = [reading for reading in readings if not reading.problem and not forbidden(reading, state)]
        if not allowed:
            return Clause(best, reason=forbidden(best, state))
        allowed = _stop_first(allowed)
        grammar = self.matcher.grammar
        if unsure := share_of_a_turn(allowed[0], grammar) or sign_and_side(allowed[0], grammar.language):
            return Clause(allowed[0], reason=unsure)
        best, ways, reason = self._whose_place.settled(allowed[0])
        if ways:
            return Clause(best, reason=reason, alternatives=tuple(map(described, ways)), ambiguous=True)
        try:
            check_speeds(best.intent, best.values(), ((slot.label, slot.slot) for slot in best.slots))
            action = build_action(best.intent, best.values(), self.matcher.locations)
        except CannotActError as error:
            return Clause(best, reason=str(error), causes=error.causes)
        if len(allowed) > 1 and not isinstance(action, Stop):
            rivals = self._rivals(best, action, allowed[1:])
            if rivals:
                return Clause(
                    best,
                    reason="it could mean two things",
                    alternatives=(described(best), *rivals),
                    ambiguous=True,
                )
        return Clause(best, action, _changes(best))

    def _too_much(self, reading: Reading) -> Clause | None:
        """Why a value of a list is none, if one of them was said and more words behind it: "pan left thirty meters" has
        a side. None: none was said."""
        slot = next((slot for slot in reading.slots if slot.problem), None)
        if slot is None or (slot.slot.type, slot.status) != ("choice", "unknown"):
            return None
        words = list(reading.words)
        for end in range(slot.end - 1, slot.start, -1):
            if self.matcher.values.from_words(slot.slot, slot.label, words[slot.start : end]).status == "exact":
                value, rest = " ".join(words[slot.start : end]), " ".join(words[end : slot.end])
                reason = f"{rest!r} is nothing that follows {value!r} in this grammar"
                return Clause(reading, reason=reason, at_fault=(rest,))
        return None

    def _rivals(self, best: Reading, action: Action, others: list[Reading]) -> tuple[str, ...]:
        """Other meanings as good as the best: same words understood, same priority, another action."""
        found: list[str] = []
        for other in others:
            if _merit(other) != _merit(best):
                continue
            try:
                meant = build_action(other.intent, other.values(), self.matcher.locations)
            except CannotActError:
                continue
            if meant != action:
                found.append(described(other))
        return tuple(dict.fromkeys(found))


def _merit(reading: Reading) -> tuple[int, int, int]:
    """By what one reading of the same words is as good as another."""
    return reading.intent.priority, reading.free_words, reading.alikes


def _stop_first(readings: list[Reading]) -> list[Reading]:
    """Readings, the best first, and of those that are as good as the best one that stops: "back up a second" is no
    question to a robot that backs up."""
    for stop in readings:
        if stop.intent.action.type == "stop" and _merit(stop) == _merit(readings[0]):
            return [stop, *(other for other in readings if other is not stop)]
    return readings


def forbidden(reading: Reading, state: Collection[str]) -> str:
    """Why a command cannot be done in these states of the robot; empty: it can."""
    return reading.intent.needs.unmet(state)


def _problem_clause(reading: Reading) -> Clause:
    slot = next(slot for slot in reading.slots if slot.problem)
    names = tuple(name for name, _ in slot.rivals[:3])
    causes = frozenset((slot.cause,) if slot.cause is not None else ())
    ambiguous = slot.status == "ambiguous"
    at_fault = reading.words[slot.start : slot.end] if slot.slot.type in FREE_KINDS else ()
    return Clause(
        reading, reason=slot.problem, causes=causes, alternatives=names, ambiguous=ambiguous, at_fault=at_fault
    )


def _beyond_limits(best: Reading, readings: Sequence[Reading]) -> Reading | None:
    """A reading that leaves fewer words to free text than the best, and is none for its number alone: who says "the
    fortieth row" where there are thirty does not mean a thing of that name."""
    return next(
        (
            one
            for one in readings
            if one.free_words < best.free_words
            and one.intent.priority >= best.intent.priority
            and one.problem
            and one.understood
        ),
        None,
    )


def _changes(reading: Reading) -> str:
    """What was changed to accept a reading that is not exact."""
    changes = []
    for slot in reading.slots:
        if slot.status == "fuzzy":
            changes.append(f"heard {' '.join(reading.words[slot.start : slot.end])!r} as {slot.value!r}")
    if reading.alikes:
        changes.append(f"read as {' '.join(reading.words)!r}")
    return "; ".join(changes) if changes else ""
