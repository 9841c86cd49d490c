"""What is dictated: "write down that", and then anything, as it was said.

The words of other slots are a name, so that "don't", "and then" and "robot" are none of them. A dictated text may hold
all of these. So only the words before it are understood, and it is kept as it is.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.action_builder import CannotActError, build_action
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Dictated", "Dictation"]

LONGEST = 16
"""Words before a dictated text, with all that says nothing: "hey robot, could you please write down for me that"."""
MOST_JOINTS = 5
"""Words of a joint: "and once you are there"."""
ANYTHING = "\0anything"
"""Stands for the text, as a word that no grammar has."""
AROUND = " \t\n,;:-.\u2026"
"""What is written around the text and not said."""
PAUSES = ",;:.!?\u2026"
"""What is written at the end of a word where a pause follows."""
ANNOUNCES = ":"
"""The one of these behind which the text comes: "say: hello"."""
_APOSTROPHE = re.compile("['’]")


@dataclass(frozen=True, slots=True)
class Dictated:
    """A command with a text in it."""

    clause: Clause
    begin: tuple[str, ...]
    """The words before the text, without such as say nothing."""
    text: str
    """As it was written."""


class Dictation:
    """Finds what is dictated in texts of one grammar. Thread-safe."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._phrases = phrases
        self._commands = commands
        self._greetings = PhraseSet(commands.matcher.grammar.wording.greetings)
        self._alternatives = commands.matcher.grammar.wording.alternatives
        self._language = commands.matcher.grammar.language
        known = thing_words(self._language)
        closed = commands.matcher.grammar.operators.closed
        self._articles = known.articles
        self._no_name = known.articles | known.joining | closed
        """Words of which none stands behind the first of a name: "Anna *is* late", "Anna *the* cup"."""
        self._possible = commands.matcher.grammar.dictates

    def __bool__(self) -> bool:
        return self._possible

    @step(Kind.DICTATION)
    def taken(self, text: str, state: Collection[str] = (), spoken: bool = False) -> Dictated | None:
        """The command that a text is, with what is dictated in it; None: nothing is.

        Args:
            text: what was said or typed.
            state: of the robot.
            spoken: whether a wake word is needed, if the grammar has one.
        """
        written = text.split()
        for count in range(min(len(written) - 1, LONGEST), 0, -1):
            if (found := self._parted(written, count, state, spoken)) is None:
                continue
            if _named_before(found) is not None:
                found = self._where_the_name_ends(written, found, count, state, spoken)
            for earlier in self._filled_from(written, count) if found.clause.accepted else ():
                if (longer := self._parted(written, earlier, state, spoken)) is not None:
                    return longer  # "say please wait" says "please wait"
            return found
        return None

    def _where_the_name_ends(
        self, written: list[str], found: Dictated, count: int, state: Collection[str], spoken: bool
    ) -> Dictated:
        """The command with a name of free words that a text follows with no word between: "tell Anna dinner is ready".
        The name ends before a pause, before a word that no name has, and behind its last capital letter, unless a word
        follows that may be of the text ("Anna Peter is here"); where it may yet end in several places, nobody is told
        anything."""
        fits = {count: found}
        for other in range(count - 1, 0, -1):
            shorter = self._parted(written, other, state, spoken)
            if shorter is not None and _named_before(shorter) is not None:
                fits[other] = shorter
        fits = {at: way for at, way in fits.items() if self._may_be_named(_named_before(way) or (), written[:at])}
        listed = [at for at, way in fits.items() if _lists_it(way)]
        paused = [at for at in fits if written[at - 1][-1] in PAUSES]
        capital = [at for at in fits if self._ends_in_capitals(written, at)]
        clear = (listed or paused or capital or list(fits))[:1]
        if clear and (listed or paused or capital or len(fits) == 1):
            return fits[clear[0]]
        names = " or ".join(repr(" ".join(_named_before(way) or ())) for way in (fits or {count: found}).values())
        reason = f"whether {names} is told it is not clear; pause before it"
        return replace(found, clause=Clause(found.clause.reading, reason=reason))

    def _may_be_named(self, name: tuple[str, ...], written: list[str]) -> bool:
        """Whether words may be a name: behind its first no word stands that no name has, be it shortened ("I'm"), and
        they are no hesitation."""
        shortened = (_APOSTROPHE.split(word.lower())[0] for word in written[len(written) - len(name) + 1 :])
        return self._no_name.isdisjoint((*name[1:], *shortened)) and not self._phrases.fillers.cover([*name])

    def _ends_in_capitals(self, written: list[str], at: int) -> bool:
        """Whether a name that ends at a place has its last capital letter there."""
        after = Utterance.of(written[at], self._language).words[:1]
        follows = self._no_name.isdisjoint(after) or not self._articles.isdisjoint(after)
        return written[at - 1][:1].isupper() and not written[at][:1].isupper() and follows

    def behind(self, text: str, state: Collection[str] = ()) -> Iterator[tuple[str, Dictated]]:
        """What is said before a command in which something is dictated, and that command: "turn left, and write down
        that". The first of such commands comes first: another may be part of what it dictates."""
        written = text.split()
        for place in range(1, len(written) - 1):
            longest = next((n for n in range(MOST_JOINTS, 0, -1) if self._joins(written[place : place + n])), 0)
            if longest or written[place - 1][-1] in PAUSES:
                found = self.taken(" ".join(written[place + longest :]), state)
                if found is not None and found.clause.accepted:
                    yield " ".join(written[:place]), found

    def _joins(self, written: list[str]) -> bool:
        """Whether words are one joint, and nothing else: "and then"."""
        words = Utterance.of(" ".join(written), self._language).words
        return bool(words) and self._phrases.sequence.at(words, 0) == len(words)

    def _parted(self, written: list[str], count: int, state: Collection[str], spoken: bool) -> Dictated | None:
        """The command with a text that begins after so many words, if it is one."""
        rest = " ".join(written[count:]).strip(AROUND)
        if self._says_nothing(rest) and not self._greets(rest, written[count - 1]):
            return None
        taken: Dictated | None = None
        for begin in self._begins(" ".join(written[:count]), spoken):
            clause = self._commands.exact([*begin.words, ANYTHING], state)
            if clause is not None and (slot := _dictated(clause.reading)) is not None:
                if self._lists(clause.reading, slot, rest, written[count - 1]):
                    reason = f"whether {rest!r} is what is told, or whom to tell, is not clear; pause before it"
                    clause = Clause(clause.reading, reason=reason)
                else:
                    clause = self._with(clause, slot, rest)
                if taken is None or clause.accepted:
                    taken = Dictated(clause, tuple(begin.words), rest)
                if not _has_free_name(clause.reading):
                    break  # else it may hold a filler: "tell uh Anna that"
        return taken

    def _filled_from(self, written: list[str], count: int) -> Iterator[int]:
        """Where words begin that say nothing and lead to what is dictated in one breath: "please wait". With a pause
        behind them only a greeting does, and what is announced: "hello, goodbye", but "please, check the brakes"."""
        paused = written[count - 1][-1] in PAUSES
        for start in range(1, count):
            before, filler = written[start - 1], " ".join(written[start:count])
            leads = not paused or before[-1] in ANNOUNCES or self._greets(filler, before)
            if leads and self._says_nothing(filler):
                yield start

    def _says_nothing(self, text: str) -> bool:
        """Whether there is nothing in it to dictate: "write down, please"."""
        return self._phrases.fillers.cover(Utterance.of(text, self._language).words)

    def _greets(self, text: str, before: str) -> bool:
        """Whether what says nothing around a command is meant to be said: "say hello". After a pause it thanks whoever
        is to write, and in "take a note please" there is nothing to write."""
        paused = before[-1] in PAUSES and before[-1] not in ANNOUNCES
        return not paused and self._greetings.find(Utterance.of(text, self._language).words) is not None

    def _lists(self, reading: Reading | None, slot: SlotReading, text: str, before: str) -> bool:
        """Whether a text goes on from the value before it: "tell Anna [and Tom that I'm late]". Who else is to be told
        is no part of what they are told."""
        assert reading is not None
        listed = len(reading.slots) > 1 and reading.slots[-2].end == slot.start and before[-1] not in PAUSES
        words = Utterance.of(text, self._language).words
        return listed and (self._phrases.sequence.at(words, 0) > 0 or not self._alternatives.isdisjoint(words[:1]))

    def _begins(self, text: str, spoken: bool) -> Iterator[Utterance]:
        """A beginning of a text, without the wake word, as it is and without what says nothing."""
        said = Utterance.of(text, self._language)
        if self._phrases.wake:
            woken = self._phrases.awake(said)
            if woken is None and spoken:
                return
            said = woken or said
        yield said
        without = self._phrases.without_fillers(said)
        if without is not said:
            yield without

    def _with(self, clause: Clause, slot: SlotReading, text: str) -> Clause:
        """The command with a text in its slot."""
        assert clause.reading is not None
        words = Utterance.of(text, self._language).words
        slots = (*clause.reading.slots[:-1], replace(slot, end=slot.start + len(words), value=text))
        reading = replace(
            clause.reading, slots=slots, words=(*clause.reading.words[:-1], *words), free_words=len(words)
        )
        if not clause.accepted:
            return replace(clause, reading=reading)
        try:
            action = build_action(reading.intent, reading.values(), self._commands.matcher.locations)
        except CannotActError as error:
            return Clause(reading, reason=str(error), causes=error.causes)
        return replace(clause, reading=reading, action=action)


def _has_free_name(reading: Reading | None) -> bool:
    """Whether words of any kind stand before what is dictated: "tell {name} that"."""
    return reading is not None and any(slot.slot.type in FREE_KINDS for slot in reading.slots[:-1])


def _named_before(found: Dictated) -> tuple[str, ...] | None:
    """The name of free words straight before what is dictated; None: a word of the sentence stands between."""
    reading = found.clause.reading
    if reading is None or len(reading.slots) < 2:
        return None
    name, text = reading.slots[-2:]
    free = name.slot.type in FREE_KINDS and name.end == text.start
    return tuple(reading.words[name.start : name.end]) if free else None


def _lists_it(found: Dictated) -> bool:
    """Whether the slot of such a name lists it among those that are likely."""
    reading = found.clause.reading
    return reading is not None and _named_before(found) in reading.slots[-2].slot.known_names


def _dictated(reading: Reading | None) -> SlotReading | None:
    """The slot that a text is to be put in."""
    slot = reading.slots[-1] if reading is not None and reading.slots else None
    return slot if slot is not None and slot.slot.dictation and slot.value == ANYTHING else None
