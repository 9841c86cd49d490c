"""Compounds: "go forward two meters then turn left". Taken whole, every part a whole command, or not at all."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from intent_engine.actions import ChangeSpeed, Stop
from intent_engine.interpretation import Cause
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.ends_at_rest import EndsAtRest
from intent_engine.language.meaning.joined_doubts import JoinedDoubts
from intent_engine.language.meaning.joints import Joints
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.several.several_at_once import SeveralAtOnce
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.slots.action_builder import names_taken
from intent_engine.language.utterance import Utterance

__all__ = ["MAX_PARTS", "Compounds"]

MAX_PARTS = 8
"""Commands in one utterance."""
MOST_ENDS = 3
"""Places where a part may end, nearest first, that are tried to tell which part of an utterance is no command: each
costs a reading, and to tell why need not be exact."""
_BOTH = 2


@dataclass(frozen=True, slots=True)
class _Way:
    """How an utterance is taken apart, and what is known of its parts already."""

    core: Utterance
    state: Collection[str]
    begin: int
    """Where its first command begins."""
    exactly: bool
    """Whether no name in it is misheard."""
    shared: bool = False
    """Whether one verb may be said of several things, as it is where there is no other way."""
    parts: dict[tuple[int, int, str], Clause | None] = field(default_factory=dict)
    """The command that each part is, from a place to another, behind one of an intent."""
    tried: dict[tuple[int, str, bool], list[Clause] | None] = field(default_factory=dict)
    """The commands from a place on, behind one of an intent, and a joint or only a pause."""


class Compounds:
    """The commands that an utterance joins."""

    def __init__(self, phrases: Phrases, commands: Commands, corrections: Corrections) -> None:
        self._phrases = phrases
        self._sequence = phrases.sequence
        self._commands = commands
        self._joints = Joints(commands.matcher, phrases.sequence)
        self._corrections = corrections
        self.at_once = SeveralAtOnce(phrases, commands, corrections)
        self.ends = EndsAtRest(phrases, commands.matcher.grammar)
        self._doubts = JoinedDoubts(commands)
        self._at_first = commands.matcher.grammar.wording.at_first
        self._besides = commands.matcher.grammar.wording.besides
        self._both_of = commands.matcher.grammar.wording.both_of

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
        whole = self._commands_from(_Way(core, state, 0, exactly=True), 0, 1, "") if begin else None
        way = _Way(core, state, begin, exactly=exactly)
        whole = whole or self._commands_from(way, begin, 1, "")
        if not whole and self.at_once.verb_may_be_shared(core):
            whole = self._commands_from(replace(way, shared=True, tried={}), begin, 1, "")
        if not whole and (both := self._both_of.find(core.words, 1)) is not None:
            whole = self._both(core.cut(both[0], sum(both)), state, exactly)
        return whole or None

    def _both(self, core: Utterance, state: Collection[str], exactly: bool) -> list[Clause] | None:
        """The two commands of an utterance that says "both", without that word, where the second goes on from the
        first: "pick up both the cup and the plate"; None: there are more, or fewer."""
        found = self._commands_in(core, state, exactly) or []
        return found if len(found) == _BOTH and _goes_on(found[-1]) else None

    def _commands_from(
        self, way: _Way, start: int, depth: int, before: str, joined: bool = True
    ) -> list[Clause] | None:
        """The commands from a place on. None: they are none.

        Args:
            way: how the utterance is taken apart.
            start: the place.
            depth: which command begins there, counted from 1.
            before: the intent of the command behind which it stands; empty: it is one by itself.
            joined: whether a joint stands before it, and not only a pause.
        """
        key = (start, before, joined)
        if key not in way.tried:
            way.tried[key] = None
            way.tried[key] = self._longest_first(way, start, depth, before, joined)
        return way.tried[key]

    def _longest_first(self, way: _Way, start: int, depth: int, before: str, joined: bool) -> list[Clause] | None:
        """The same of the longest part that is a command, if commands follow it."""
        core = way.core
        for end, after in self._joints.boundaries(core, start):
            if start < end < after < len(core) and self._phrases.opens_what_follows(core, start, after):
                # Else "go and wait for me there" would go somewhere else first.
                return self._commands_from(way, after, depth, before)
            part = core.part(start, end)
            if self._corrections.leans(part, way.state, first=start == way.begin):
                continue
            clauses = self._in_part(way, part, start, depth, before)
            if not clauses:
                continue
            if not clauses[0].accepted:
                return clauses
            *several, clause = clauses
            found = self._with_what_follows(way, clause, end, after, depth + len(several), joined)
            if found is not None:
                return [*several, *found] if found[0].accepted else found
        return None

    def _in_part(self, way: _Way, part: Utterance, start: int, depth: int, before: str) -> list[Clause]:
        """The command that a part is, or those of a list of things; or the one clause that is not accepted, as
        :meth:`SeveralAtOnce.each` has it. Empty: it is none."""
        end = start + len(part)
        if (start, end, before) not in way.parts:
            way.parts[start, end, before] = self._one(part, way.state, before, way.exactly)
        clause = way.parts[start, end, before]
        if clause is not None and clause.accepted:
            return [clause]
        several = self.at_once.each(part, way.state, before, shared=way.shared) if len(part) > 1 else []
        if several:
            too_many = several[0].accepted and depth + len(several) > MAX_PARTS + 1
            return [] if too_many else several
        if start == way.begin and end < len(way.core):
            clause = self._at_first_of_all(part, way.state, way.exactly)
        return [clause] if clause is not None and clause.accepted else []

    def _with_what_follows(
        self, way: _Way, clause: Clause, end: int, after: int, depth: int, joined: bool
    ) -> list[Clause] | None:
        """A command that ends at a place, and those behind the joint there. None: what follows is none."""
        words = way.core.words
        # "The kitchen, the bedroom and the dock" is a list: its last joint tells it from a correction.
        listed = not joined and _goes_on(clause)
        if end == len(words):
            return [clause] if not listed else None
        if not listed and self.ends.only(words, end, after):
            return [self.ends.at_rest(clause, words[after:])]  # "... and stop"
        if depth >= MAX_PARTS:
            return None
        name = self._goes_on_from(clause)
        onward = None
        if after > end or (name and self._commands.may_go_on(words[after:], name)):
            onward = self._commands_from(way, after, depth + 1, name, after > end)
        if onward is None and after == end:
            onward = self._commands_from(way, after, depth + 1, "")
        if onward is None or not self._joints.part_numbers(words, end, after, clause, onward[0]):
            return None
        onward = self._doubts.unless_of_its_verb(clause, self._doubts.unless_the_way_back(clause, onward), way.state)
        later = _goes_on(onward[0])
        if not later and not self._phrases.says_later(words[end:after]):
            onward = self._doubts.unless_for_both(clause, onward)
        if not onward[0].accepted:
            return onward
        if not (_of_one_kind(clause, onward[0]) if later else not listed):
            return None
        if after == end:
            return _of_one_speed(clause, onward)
        if len(onward) == 1 and isinstance(onward[0].action, Stop) and not self.ends.another(words[after:]):
            return [self.ends.at_rest(clause, words[after:])]  # "... and wait there"
        return [clause, *onward]

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


def _of_one_kind(clause: Clause, onward: Clause) -> bool:
    """Whether what goes on from a command names all that the command does, and no more: nobody knows whose the table is
    in "place the cup and the plate on the table", nor where the plate goes in "put the cup on it and the plate"."""
    one, other = clause.reading, onward.reading
    assert one is not None
    assert other is not None
    return names_taken(one.intent, one.values()) == names_taken(other.intent, other.values())
