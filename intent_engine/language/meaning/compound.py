"""Compounds: "go forward two meters then turn left". Taken whole, every part a whole command, or not at all."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise

from intent_engine.actions import ChangeSpeed, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.interpretation import Cause
from intent_engine.language.grammar import MOTIONS, QUANTITY_KINDS
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.joints import Joints
from intent_engine.language.meaning.negations.doing import verbs
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.several.several_at_once import SeveralAtOnce
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.slots.action_builder import names_taken
from intent_engine.language.templates.template_tree import first_words
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.thing_words import thing_words

__all__ = ["MAX_PARTS", "Compounds"]

MAX_PARTS = 8
"""Commands in one utterance."""
MOST_ENDS = 3
"""Places where a part may end, nearest first, that are tried to tell which part of an utterance is no command: each
costs a reading, and to tell why need not be exact."""


class Compounds:
    """The commands that an utterance joins."""

    def __init__(self, phrases: Phrases, commands: Commands, corrections: Corrections) -> None:
        self._phrases = phrases
        self._sequence, self._hold = phrases.sequence, phrases.objections.hold
        self._commands = commands
        self._joints = Joints(commands.matcher, phrases.sequence)
        self._corrections = corrections
        self.at_once = SeveralAtOnce(phrases, commands, corrections)
        self._where = thing_words(commands.matcher.grammar.language).where
        self._at_first = commands.matcher.grammar.wording.at_first
        self._besides = commands.matcher.grammar.wording.besides
        self._ways_back = commands.matcher.grammar.wording.ways_back
        known = thing_words(commands.matcher.grammar.language)
        self._definite, self._itself, self._persons = known.definite, known.itself, known.persons

    @step(Kind.COMMAND)
    def part(self, part: Utterance, state: Collection[str], *, loosely: bool = True) -> Clause | None:
        """The command that a part of an utterance is: exact, corrected, or with misheard names."""
        words = part.words
        clause = self._commands.exact(words, state, breaks=part.breaks)
        if clause is not None and (clause.accepted or clause.ambiguous):
            return clause
        if self._corrections.may_stand_in(words):
            corrected = self._corrections.corrected(part, state)
            if corrected is not None:
                return corrected
        if self._besides.may_stand_in(words) and (alone := self._but_for_besides(part, state)) is not None:
            return alone
        # No name takes a word that changes a sense, but a sentence may have it: "i would like a cofee". Where it may
        # join commands every part would be compared.
        if loosely and not (self._phrases.change_meaning(words) and self._sequence.may_stand_in(words)):
            loose = self._commands.misheard(words, state, breaks=part.breaks)
            if loose is not None and (clause is None or not clause.parted or loose.accepted):
                return loose
        return clause

    def _but_for_besides(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """The command that a part is but for an "as well" at its end. None: it is none so, or a sentence may go on with
        what that sounds like: "turn left too" may be the beginning of "turn left two degrees". Behind an
        amount and a pause it is not: "forward two meters, too"."""
        words = part.words
        length = self._besides.ends(words)
        if not 0 < length < len(words):
            return None
        before = part.part(0, len(part) - length)
        clause = self._commands.exact(before.words, state, breaks=before.breaks)
        if clause is None or not clause.accepted or clause.reading is None:
            return None
        matcher = self._commands.matcher
        measured = any(one.end == len(before) and one.slot.type in QUANTITY_KINDS for one in clause.reading.slots)
        for other in matcher.alikes.get(words[-1], ()) if length == 1 and not (measured and part.breaks[-1]) else ():
            if matcher.prefix([*words[:-1], other])[1] is not None:
                return None
        return clause

    @step(Kind.COMPOUND)
    def split(self, core: Utterance, state: Collection[str], *, exactly: bool = False) -> list[Clause] | None:
        """The commands that an utterance joins, if every part of some split is a whole command; else None."""
        words = core.words
        joined = self._sequence.may_stand_in(words) or any(core.breaks[1:])
        if not joined and not self._phrases.goes_on(words):
            return None
        return self._commands_in(core, state, exactly)

    def _commands_in(self, core: Utterance, state: Collection[str], exactly: bool = False) -> list[Clause] | None:
        """The same of an utterance that may be a single command.

        What may say nothing at its beginning does not where it belongs to a command: "first gear, then go back".
        """
        begin = self._phrases.goes_on(core.words) or self._phrases.agreed(core)
        whole = self._commands_from(core, state, 0, True, {}) if begin else None
        parts: dict[tuple[int, int, str], Clause | None] = {}
        whole = whole or self._commands_from(core, state, begin, exactly, parts)
        if whole is None and self.at_once.verb_may_be_shared(core):
            whole = self._commands_from(core, state, begin, exactly, parts, shared=True)
        return whole

    def _commands_from(
        self,
        core: Utterance,
        state: Collection[str],
        begin: int,
        exactly: bool,
        parts: dict[tuple[int, int, str], Clause | None],
        *,
        shared: bool = False,
    ) -> list[Clause] | None:
        """The same from a place on. ``parts`` are known already; ``shared`` tells whether one verb may be said of
        several things, as it is where there is no other way."""
        words = core.words
        tried: dict[tuple[int, str, bool], list[Clause] | None] = {}

        def rest(start: int, depth: int, before: str, joined: bool = True) -> list[Clause] | None:
            """Of the commands from a place on, behind one of the intent ``before`` and a joint, or only a pause."""
            if (start, before, joined) in tried:
                return tried[start, before, joined]
            tried[start, before, joined] = None
            found: list[Clause] | None = None
            for end, after in self._joints.boundaries(core, start):
                if start < end < after < len(words) and self._phrases.opens_what_follows(core, start, after):
                    found = rest(after, depth, before)  # else "go and wait for me there" would go somewhere else first
                    break
                part = core.part(start, end)
                if self._corrections.leans(part, state, first=start == begin):
                    continue
                if (start, end, before) not in parts:
                    parts[start, end, before] = self._one(part, state, before, exactly)
                clause = parts[start, end, before]
                several: list[Clause] = []
                if not (clause is not None and clause.accepted) and end > start + 1:
                    several = self.at_once.each(part, state, before, shared=shared)
                    if several and not several[0].accepted:
                        found = several
                        break
                    if depth + len(several) > MAX_PARTS + 1:
                        continue
                    clause = several.pop() if several else clause
                if start == begin and end < len(words) and not (clause is not None and clause.accepted):
                    clause = self._at_first_of_all(part, state, exactly)
                if clause is None or not clause.accepted:
                    continue
                # "The kitchen, the bedroom and the dock" is a list: its last joint tells it from a correction.
                listed = not joined and _goes_on(clause)
                if end == len(words):
                    found = [clause] if not listed else None
                elif self._only_ends(words, end, after) and not listed and not self._names_what(words[after:]):
                    found = [self._at_rest(clause, words[after:])]  # "... and stop"
                elif (done := depth + len(several)) < MAX_PARTS:
                    name = self._goes_on_from(clause)
                    onward = None
                    if after > end or (name and self._commands.may_go_on(words[after:], name)):
                        onward = rest(after, done + 1, name, after > end)
                    if onward is None and after == end:
                        onward = rest(after, done + 1, "")
                    if onward is not None and not self._joints.part_numbers(words, end, after, clause, onward[0]):
                        onward = None
                    if onward is not None:
                        onward = self._unless_of_its_verb(clause, self._unless_the_way_back(clause, onward), state)
                    later = onward is not None and _goes_on(onward[0])
                    if onward is not None and not later and not self._phrases.says_later(words[end:after]):
                        onward = self._unless_for_both(clause, onward)
                    if onward is not None and not onward[0].accepted:
                        found = onward
                    elif onward is not None and (_of_one_kind(clause, onward[0]) if later else not listed):
                        found = [clause, *onward] if after > end else _of_one_speed(clause, onward)
                        stops = after > end and len(onward) == 1 and isinstance(onward[0].action, Stop)
                        if stops and not self._ends_another(words[after:]):
                            found = [self._at_rest(clause, words[after:])]  # "... and wait there"
                if found is not None:
                    found = [*several, *found] if found[0].accepted else found
                    break
            tried[start, before, joined] = found
            return found

        return rest(begin, 1, "") or None

    def _only_ends(self, words: list[str], end: int, after: int) -> bool:
        """Whether what follows a command is a stop, or is joined with it and only says to wait where it ends: "and wait
        *there*". "And hold on" may take it back."""
        waits = after > end and self._hold.at(words, after) == len(words) - after and words[-1] in self._where
        return waits or self._phrases.only_stops(words, after)

    def _at_first_of_all(self, part: Utterance, state: Collection[str], exactly: bool) -> Clause | None:
        """The command that a part is but for a "first" at its end, behind which others follow. None: it has none."""
        length = self._at_first.ends(part.words)
        if not 0 < length < len(part):
            return None
        return self._one(part.part(0, len(part) - length), state, "", exactly)

    def _one(self, part: Utterance, state: Collection[str], before: str, exactly: bool) -> Clause | None:
        """The command that a part is, by itself or ("and then to the bedroom") behind one of the intent ``before``.

        What is a command by itself, exactly, is that: after "turn left ninety degrees and then", "right" is.
        """
        words = part.words
        if not before or not self._commands.may_go_on(words, before):
            return self._commands.exact(words, state, breaks=part.breaks) if exactly else self.part(part, state)
        whole = self._commands.exact(words, state, breaks=part.breaks)
        if whole is not None and (whole.accepted or whole.ambiguous):
            return whole
        later = self._commands.exact(words, state, before, part.breaks)
        if exactly or (later is not None and later.accepted):
            return later
        if self._corrections.may_stand_in(words):
            corrected = self._corrections.corrected(part, state, before)
            if corrected is not None and corrected.accepted:
                return corrected
        clause = self.part(part, state)
        if not (clause is not None and clause.accepted) and not self._phrases.change_meaning(words):
            return self._commands.misheard(words, state, before, part.breaks) or clause
        return clause

    def _unless_for_both(self, clause: Clause, onward: list[Clause]) -> list[Clause]:
        """What goes on from a command, unless it ends with what may be meant for both: "left and right ninety degrees".
        Then the one clause that says so. "A coffee and two teas" are one coffee, and "left and then right ninety
        degrees" one turn after the other."""
        one, other = clause.reading, onward[0].reading
        if one is None or other is None or one.intent is not other.intent or not other.slots:
            return onward
        last, said = other.slots[-1], one.values()
        alike = said.keys() & other.values().keys() - {last.label}
        if last.label in said or not alike or last.end < len(other.words) or self._commands.opens_with_a_verb(other):
            return onward
        both = replace(one, slots=(*one.slots, last))
        meanings = tuple(f"{described(first)}, then {described(other)}" for first in (one, both))
        reason = f"{' '.join(other.words[last.start :])!r} may be meant for both; say each command in full"
        return [Clause(one, reason=reason, alternatives=meanings, ambiguous=True)]

    def _unless_the_way_back(self, clause: Clause, onward: list[Clause]) -> list[Clause]:
        """What goes on from a command, unless that may have gone somewhere and what follows ends with "back" and says
        no more: backward, or back to where it came from? "Go forward two meters and back" is no 60 cm backward. To turn
        in between goes nowhere else: "take the cup to the kitchen, turn around and go back"."""
        back = next((later for later in onward if not isinstance(later.action, Turn)), onward[0])
        one, other = clause.reading, back.reading
        if one is None or other is None or not self._ways_back.ends(other.words):
            return onward
        if not _goes_somewhere(clause) or not isinstance(back.action, Move) or _goes_somewhere(back):
            return onward
        either = (f"{described(one)}, then {described(other)}", f"{described(one)}, then the way back")
        reason = f"{' '.join(other.words)!r} may be backward, or the way back; say how far, or where to"
        return [Clause(one, reason=reason, alternatives=either, ambiguous=True)]

    def _unless_of_its_verb(self, clause: Clause, onward: list[Clause], state: Collection[str]) -> list[Clause]:
        """What goes on from a command, unless it begins with a value and does something else behind the verb before:
        "look up and *down*" is no order to lie down, where that is one."""
        one, other = clause.reading, onward[0].reading
        if one is None or other is None or one.intent is other.intent:
            return onward
        if not onward[0].accepted or not other.slots or other.slots[0].start:
            return onward
        for slot in one.slots:
            if slot.start == 0 or slot.slot.type != "choice" or slot.slot is other.slots[0].slot:
                continue
            behind = self._commands.exact([*one.words[: slot.start], *other.words], state)
            if behind is not None and behind.accepted and behind.reading is not None:
                if behind.action == onward[0].action:
                    continue
                either = tuple(f"{described(one)}, then {described(way)}" for way in (other, behind.reading))
                reason = f"{' '.join(other.words)!r} may be a command, or be said of the verb before; say it in full"
                return [Clause(one, reason=reason, alternatives=either, ambiguous=True)]
        return onward

    def _ends_another(self, stop: list[str]) -> bool:
        """Whether a stop is no mere end of the command before it, but of something else: "turn left and *cancel the
        mission*", "... and *stop following me*"."""
        if self._phrases.cancel.at(stop, 0) or not self._persons.isdisjoint(stop) or self._names_what(stop):
            return True
        length = self._phrases.stop.at(stop, 0)
        doing = stop[length : length + 1] if length else []
        language = self._commands.matcher.grammar.language
        return any(verb in self.acting for word in doing for verb in verbs(word, language))

    def _at_rest(self, clause: Clause, stop: Sequence[str]) -> Clause:
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
        grammar = self._commands.matcher.grammar
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
        grammar = self._commands.matcher.grammar
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

    def _goes_on_from(self, clause: Clause) -> str:
        """The intent of a command, if there are parts that go on from it; else nothing."""
        name = clause.reading.intent.name if clause.reading is not None else ""
        return name if name in self._commands.matcher.later else ""

    def failing(self, core: Utterance, state: Collection[str]) -> tuple[Utterance, Clause | None] | None:
        """The part for which an utterance that joins commands is none, with what is made of it: the first that is no
        command, if those before it are, and what follows it or comes before it is at least one. None: no part is."""
        start = first = self._phrases.goes_on(core.words)
        before = ""
        while True:
            ends = list(self._joints.boundaries(core, start))
            ends = [one for one in ends if not self._joints.may_be_one_number(core.words, *one)][-MOST_ENDS:]
            parts = [(end, after, self._one(core.part(start, end), state, before, False)) for end, after in ends]
            done = next((one for one in parts if one[2] is not None and one[2].accepted), None)
            if done is None or done[2] is None:
                break
            if done[1] >= len(core.words):
                return None
            before = self._goes_on_from(done[2]) if done[1] > done[0] else ""
            start = done[1]
        end, after, clause = parts[-1]
        if start == first and not self._commands_in(core.part(after, len(core.words)), state):
            return None
        return core.part(start, end), clause


def _of_one_speed(clause: Clause, onward: Sequence[Clause]) -> list[Clause]:
    """Commands in a row behind a pause, of which two that change the speed the same way are one: who says "you're going
    too fast, slow down a bit" tells why. What says how much is the one. Said twice and corrected ("faster, faster, no,
    slower"), both are taken back."""
    one, other = clause.action, onward[0].action
    if not (isinstance(one, ChangeSpeed) and isinstance(other, ChangeSpeed)):
        return [clause, *onward]
    if (one.factor < 1) != (other.factor < 1):
        return list(onward) if Cause.CORRECTED in onward[0].causes else [clause, *onward]
    telling = (said for said in (onward[0], clause) if said.reading is not None and said.reading.values())
    return [next(telling, clause), *onward[1:]]


def _goes_on(clause: Clause) -> bool:
    """Whether a command is one only behind another."""
    reading = clause.reading
    return reading is not None and any(reading.sentence is one for one in reading.intent.then)


def _goes_somewhere(clause: Clause) -> bool:
    """Whether a command may have an end that one can come back from: a place, where a thing is or goes, or how far.
    Where an action of the user's own leads, only he knows: "deliver the mail", "take the cup to the kitchen"."""
    if isinstance(clause.action, Navigate | Custom):
        return True
    slots = clause.reading.slots if clause.reading is not None else ()
    if isinstance(clause.action, Pick | Place):
        return len(slots) > 1
    return isinstance(clause.action, Move) and any(slot.slot.type in ("distance", "duration") for slot in slots)


def _of_one_kind(clause: Clause, onward: Clause) -> bool:
    """Whether what goes on from a command names all that the command does, and no more: nobody knows whose the table is
    in "place the cup and the plate on the table", nor where the plate goes in "put the cup on it and the plate"."""
    one, other = clause.reading, onward.reading
    assert one is not None
    assert other is not None
    return names_taken(one.intent, one.values()) == names_taken(other.intent, other.values())
