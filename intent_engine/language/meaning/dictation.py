"""What is dictated: "write down that", and then anything, as it was said.

The words of other slots are a name, so that "don't", "and then" and "robot" are none of them. A dictated text may hold
all of these. So only the words before it are understood, and it is kept as it is.
"""

from __future__ import annotations

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
            for earlier in self._filled_from(written, count):
                if (longer := self._parted(written, earlier, state, spoken)) is not None:
                    return longer  # "say please wait" says "please wait"
            return found
        return None

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


def _dictated(reading: Reading | None) -> SlotReading | None:
    """The slot that a text is to be put in."""
    slot = reading.slots[-1] if reading is not None and reading.slots else None
    return slot if slot is not None and slot.slot.dictation and slot.value == ANYTHING else None
