"""Several things of which one verb is said: "open the first and the third drawer" is "open the first drawer" and "open
the third drawer", and "fade A to 20 and B to 30" is two fades.

What stands between the verb and what all share is said anew for each, in the same way. A name alone ("paint it red and
blue") may be for each or for all together, and what follows the last ("to ten percent") for each or for the last: they
are asked about.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from intent_engine.actions import ChangeSpeed, Custom, Stop
from intent_engine.language.context.done_again import AGAIN
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, TELLING_APART
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.several.listed_numbers import OF_EACH, ListedNumbers
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["SharedVerb"]

MOST_SAID = 8
"""Things that one verb is said of, as commands in one utterance."""
MOST_WORDS = 30
"""Of a sentence with one verb for several things."""
_LEAST_WITH_A_NUMBER = 2
_NAMES = (*TELLING_APART, *FREE_KINDS)


@dataclass(frozen=True, slots=True)
class _Said:
    """One of the commands: words that all share around those that are its own, from ``start`` to ``end``."""

    clause: Clause
    reading: Reading
    start: int
    end: int

    @property
    def own(self) -> list[SlotReading]:
        return [slot for slot in self.reading.slots if slot.start >= self.start and slot.end <= self.end]

    @property
    def shared(self) -> list[SlotReading]:
        return [slot for slot in self.reading.slots if slot.end <= self.start or slot.start >= self.end]

    @property
    def is_bare(self) -> bool:
        """Whether nothing but a name is its own, which is no "first" or "third"."""
        own = self.own
        name = len(own) == 1 and (own[0].start, own[0].end) == (self.start, self.end)
        return name and own[0].slot.type != "ordinal"


class SharedVerb:
    """The commands of one sentence whose verb is said once."""

    def __init__(self, phrases: Phrases, commands: Commands, lists: ListedNumbers) -> None:
        self._commands = commands
        self._lists = lists
        self._sequence, self._stop, self._correction = phrases.sequence, phrases.stop, phrases.correction
        self._says_later = phrases.says_later
        grammar = commands.matcher.grammar
        self._language = grammar.language
        known, operators, wording = thing_words(grammar.language), grammar.operators, grammar.wording
        self._articles = known.articles | set(known.contracted)
        self._joining = known.joining | known.binding | known.within
        self._placed = wording.placed
        turning = (*operators.negation, *operators.contrast)
        self._turns = wording.leaves_open.union(
            wording.alternatives, (words[0] for words in turning if len(words) == 1)
        )
        self._alternatives = wording.alternatives
        self._joints = {words[0] for words in operators.sequence if len(words) == 1}

    def each(self, part: Utterance, state: Collection[str], *, of_each: bool = False) -> list[Clause] | None:
        """The commands, one for each thing; or the one clause that asks, where it is not clear what is of which, unless
        it was said that it is ``of_each``. None: there is nothing of the kind."""
        if not self.may_stand_in(part) or self._correction.find(part.words) is not None:
            return None
        joints = list(_joints_in(part, self._sequence))
        if not joints or joints[-1][0] == joints[-1][1] or len(joints) >= MOST_SAID:
            return None  # without a word before the last it may be a correction
        if any(self._lists.joins_one(part.words, *joint) for joint in joints):
            return None
        in_turn = all(self._says_later(part.words[start:end]) for start, end in joints)
        found: dict[tuple[object, ...], list[Clause]] = {}
        for said in self._ways(part, joints, state, of_each=of_each):
            clauses = [one.clause for one in said]
            asked = self._asked(said, part, state, in_turn=in_turn, of_each=of_each)
            if asked is None:
                found.setdefault(tuple(clause.action for clause in clauses), clauses)
            else:
                found.setdefault((asked.reason,), [asked])
        clear = [clauses for clauses in found.values() if clauses[0].accepted]
        if len(clear) > 1:
            told = tuple(" and ".join(described(one.reading) for one in ways if one.reading) for ways in clear)
            return [Clause(reason="it could mean two things", alternatives=told, ambiguous=True)]
        return next(iter(clear or found.values()), None)

    def may_stand_in(self, part: Utterance) -> bool:
        """A quick look: whether words join, and none turns or stops what is said."""
        words = part.words
        if (
            not 4 <= len(part) <= MOST_WORDS
            or not self._sequence.may_stand_in(words[2:-1])
            or not self._turns.isdisjoint(words)
        ):
            return False
        return self._stop.find(words) is None

    def one_of(self, part: Utterance, state: Collection[str]) -> list[tuple[str, str]]:
        """What is said of each thing of which one is meant, and the whole command with it: "13" and "unlock drawer 13"
        of "unlock drawer 13 or 30". Empty: there are none, or it is not clear which they are."""
        words = part.words
        others = self._turns - self._alternatives
        if not 4 <= len(part) <= MOST_WORDS or self._alternatives.isdisjoint(words) or not others.isdisjoint(words):
            return []
        if any(phrases.find(words) is not None for phrases in (self._stop, self._correction, self._sequence)):
            return []
        joints = list(_joints_in(part, PhraseSet((word,) for word in self._alternatives)))
        if not joints or joints[-1][0] == joints[-1][1] or len(joints) >= MOST_SAID:
            return []
        ways: dict[tuple[object, ...], list[list[tuple[str, str]]]] = {}
        for said in self._ways(part, joints, state, one=True):
            named = [(" ".join(one.reading.words[one.start : one.end]), " ".join(one.reading.words)) for one in said]
            ways.setdefault(tuple(one.clause.action for one in said), []).append(named)
        found = next(iter(ways.values())) if len(ways) == 1 else []
        articled = [one for one in found if all(name.split()[0] in self._articles for name, _ in one)]
        return next(iter(articled or found), [])

    def _ways(
        self,
        part: Utterance,
        joints: Sequence[tuple[int, int]],
        state: Collection[str],
        *,
        one: bool = False,
        of_each: bool = False,
    ) -> Iterator[list[_Said]]:
        """The commands, for each place where what all share may end before the first, and go on behind the last."""
        words, first_end, last_start = part.words, joints[0][0], joints[-1][1]
        between = [(one[1], other[0]) for one, other in pairwise(joints)]
        for end in range(len(words), last_start, -1):
            after = part.part(end, len(part))
            first = self._said(part.part(0, first_end), after, 0, state)
            if first is None or not self._begins_with_a_verb(first.reading, words):
                continue
            for start in range(first_end - 1, 0, -1):
                said = [_Said(first.clause, first.reading, start, first_end)]
                for begin, stop in (*between, (last_start, end)):
                    own = _joined(part.part(0, start), self._with_unit(part.part(begin, stop), said[0]))
                    other = self._said(own, after, start, state)
                    if other is None:
                        break
                    said.append(other)
                else:
                    if self._are_alike(said, one=one, of_each=of_each):
                        yield said

    def _with_unit(self, own: Utterance, first: _Said) -> Utterance:
        """What is said of another thing, with the unit that was said of the first: "the peppers for ten", behind "water
        the basil for five *minutes*"."""
        is_number, words = self._commands.matcher.is_number, first.reading.words
        measured = any(slot.end == first.end and slot.slot.type in QUANTITY_KINDS for slot in first.own)
        if not measured or len(own) < _LEAST_WITH_A_NUMBER or not is_number(own.words[-1]):
            return own
        number = next((at for at in range(first.end, first.start, -1) if is_number(words[at - 1])), first.end)
        return _joined(own, Utterance.in_one_breath(words[number : first.end]))

    def _begins_with_a_verb(self, reading: Reading, words: Sequence[str]) -> bool:
        """Whether all share a verb, which may be a value of a list before an article: "{does} the {thing}"."""
        begun = [slot for slot in reading.slots if slot.start == 0]
        if not begun:
            return self._commands.opens_with_a_verb(reading)
        listed = reading.words[0] not in self._commands.not_verbs and begun[0].slot.type == "choice"
        return listed and begun[0].end < len(words) and words[begun[0].end] in self._articles

    def _said(self, before: Utterance, after: Utterance, start: int, state: Collection[str]) -> _Said | None:
        whole = _joined(before, after)
        clause = self._commands.exact(whole.words, state, breaks=whole.breaks)
        if clause is None or not clause.accepted or clause.reading is None:
            return None
        if isinstance(clause.action, Stop | ChangeSpeed) or len(clause.reading.words) != len(whole):
            return None
        if isinstance(clause.action, Custom) and clause.action.name == AGAIN:
            return None
        return _Said(clause, clause.reading, start, len(before))

    def _are_alike(self, said: Sequence[_Said], *, one: bool, of_each: bool) -> bool:
        """Whether all say the same of themselves, each of something else, and share the rest. If ``one`` of them is
        meant, that may be an amount as well; what was said to be ``of_each`` is not of all together."""
        first = said[0]
        labels = sorted(slot.label for slot in first.own)
        for other in said:
            if not labels or sorted(slot.label for slot in other.own) != labels:
                return False
            if len(other.own) + len(other.shared) != len(other.reading.slots):
                return False
            if one and any(slot.slot.type in FREE_KINDS for slot in other.own):
                return False  # of which things are given as they were said: "a cup or two"
            if not one and not self._may_be_listed(other, of_each=of_each):
                return False
            if {slot.label: slot.value for slot in other.shared} != {slot.label: slot.value for slot in first.shared}:
                return False
            same = other.reading.sentence is first.reading.sentence
            if (not same and other.end < len(other.reading.words)) or (
                not one and self._joins_by_itself(other.reading)
            ):
                return False
        if len({clause.clause.action for clause in said}) < len(said):
            return False
        names = labels if one else self._names(first)
        return any(len({str(each.reading.values()[label]) for each in said}) == len(said) for label in names)

    def _names(self, said: _Said) -> list[str]:
        """The labels of what tells it from another: no amount does, but "bin 3" and the 2 of "well A2"."""
        return [
            slot.label
            for slot in said.own
            if slot.slot.type in _NAMES
            or (slot.start > said.start and self._lists.is_name(slot, said.reading))
            or self._lists.is_of_a_letter(slot, said.reading)
        ]

    def _may_be_listed(self, said: _Said, *, of_each: bool) -> bool:
        """Whether any free words of its own are a thing that the grammar lists, beside something else; and none that
        all share, nor an amount before, which may be of all together."""
        for slot in said.reading.slots:
            shared = slot.start < said.start and slot.slot.type not in OF_EACH
            if shared and (not of_each or slot.slot.type in FREE_KINDS):
                return False
            if slot.slot.type in FREE_KINDS:
                listed = self._articles.union(slot.slot.known).issuperset(said.reading.words[slot.start : slot.end])
                if slot not in said.own or not listed or len(said.own) == 1 or said.end < len(said.reading.words):
                    return False
        return True

    def _joins_by_itself(self, reading: Reading) -> bool:
        """Whether a command of the same verb has words that join of its own: "mix {one} and {other}"."""
        verb = reading.words[0]
        sentences = (words_in(one.template) for one in reading.intent.sentences)
        return any(verb in words and not self._joints.isdisjoint(words) for words in map(set, sentences))

    def _asked(
        self, said: Sequence[_Said], part: Utterance, state: Collection[str], *, in_turn: bool, of_each: bool
    ) -> Clause | None:
        """The clause that asks what is of which; None: it is clear. What is said to be done ``in_turn``, "left, then
        right", is no one thing and not done together."""
        one, last = said[0], said[-1]
        words = one.reading.words
        each = tuple(described(other.reading) for other in said)
        listed = " ".join(part.words[one.start : len(part) - (len(words) - one.end)])
        behind = [slot for slot in one.shared if slot.start >= one.end]
        alone = self._commands.exact(list(words[: one.end]), state) if behind else None
        is_whole = alone is not None and alone.accepted
        unclear = is_whole or not all(self._lists.is_of_each(slot, one.reading) for slot in behind)
        if unclear and not of_each:
            told = f"{' '.join(words[one.end :])!r} may be meant for each of them, for the last, or for all together"
        elif self._is_one_thing(one):
            told = f"{listed!r} may be of one thing, or of one for each"
        elif any(self._is_named_anew(one, other) for other in said[1:]):
            told = f"{listed!r} may all belong to what is named before, or only the first"
        elif _may_share_tens(said):
            told = f"{listed!r} may share their tens"
        elif not (in_turn or of_each) and any(map(self._is_bare, said[1:])) and not self._names_things(last):
            told = f"{listed!r} may be for each of them, or for all together"
        else:
            return None
        return Clause(one.reading, reason=f"{told}; say each command in full", alternatives=each, ambiguous=True)

    def _is_bare(self, said: _Said) -> bool:
        """Whether a name is said without an article, be it its own: "show the Thinker and *the* Mona Lisa"."""
        own = said.reading.words[said.start : said.end]
        led = len(own) > 1 and own[0] in self._articles and said.own[0].slot.type in TELLING_APART
        return said.is_bare and not led

    def _is_one_thing(self, said: _Said) -> bool:
        """Whether a thing is named before that goes or is done only once: "bring *coffee* to the lab and to the hall".
        Of the lamp "im Flur und im Bad" there is one in each."""
        words = said.reading.words
        listed = [slot for slot in said.shared if slot.end <= said.start and slot.slot.type == "choice"]
        before = [slot.end for slot in listed if not self._is_no_thing(words[slot.start : slot.end])]
        if not before:
            return False
        between = words[max(before) : said.own[0].start]
        placed = self._placed.at(words, said.start) > 0 and max(before) == said.start
        return not self._joining.isdisjoint(between) and not placed

    def _is_named_anew(self, one: _Said, other: _Said) -> bool:
        """Whether an article begins the name of another thing, where the first belongs to what was named before it: in
        "the kitchen lamp and *the* fan" that may be another fan than the one of the kitchen."""
        words, first = other.reading.words, one.reading.words[one.start]
        if words[other.start] not in self._articles or first in self._articles:
            return False
        before = (slot for slot in other.shared if slot.end == other.start and slot.start > 0)
        return any(
            slot.slot.type in ("choice", "location") and not self._is_no_thing(words[slot.start : slot.end])
            for slot in before
        )

    def _is_no_thing(self, words: Sequence[str]) -> bool:
        """Whether words of a list say which of two is done: "on" and "off", "open" and "close"."""
        return all(opposed(word, self._language) for word in words)

    def _names_things(self, said: _Said) -> bool:
        """Whether a bare name stands behind an article, and no noun behind it: "the hall and bathroom", but not "the
        red and blue box"."""
        words = list(said.reading.words)
        ends = said.end == len(words) or words[said.end] in self._joining
        return ends and (words[said.start - 1] in self._articles or self._placed.ends(words[: said.start]) > 0)


def _may_share_tens(said: Sequence[_Said]) -> bool:
    """Whether "twenty first and third" may be the first and the third of the twenties."""
    slots = [(slot, one) for one in said for slot in one.own if slot.slot.type == "ordinal"]
    return any(
        one.value >= 20 > other.value and other.start == of.start and one.value % 10 != 0
        for (one, _), (other, of) in pairwise(slots)
    )


def _joints_in(part: Utterance, joining: PhraseSet) -> Iterator[tuple[int, int]]:
    """Where words stand that join, or only a pause."""
    place = 2
    while place < len(part) - 1:
        length = joining.at(part.words, place)
        if length or part.breaks[place]:
            yield place, place + length
        place += length + 1


def _joined(one: Utterance, other: Utterance) -> Utterance:
    breaks = [False, *other.breaks[1:]] if other.words else []
    return Utterance([*one.words, *other.words], [*one.breaks, *breaks])
