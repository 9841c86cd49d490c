"""Correction: "turn left no right", "go to the kitchen I mean the lab". The last word counts, where it is clear what it
replaces."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.meaning.command import Clause, Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.utterance import Utterance

__all__ = ["Corrections"]

_WITH_UNITS = tuple(kind for kind in QUANTITY_KINDS if kind not in ("number", "ordinal"))
_FREE = ("text", "object")
_MAY_FORBID = frozenset(("no", "nope", "nah"))
"""Words of correction that forbid what follows in one breath: "no turn left", but "no, turn left"."""


class Corrections:
    """What is meant by one command that was corrected while it was said."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._phrases = phrases
        self._correction = phrases.correction
        self._commands = commands
        self._matcher = commands.matcher

    def taken_back(self, words: list[str]) -> int:
        """Length of the correction with which the words end, with nothing in its place: "go forward, no"."""
        length = self._correction.ends(words) if self._correction.may_stand_in(words) else 0
        if 0 < length < len(words) and not self._phrases.joined_before(words, len(words) - length):
            return length
        return 0

    def may_stand_in(self, words: list[str]) -> bool:
        return self._correction.may_stand_in(words)

    @step(Kind.CORRECTION)
    def corrected(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """The command that is meant at last; None if nothing is corrected or it is not clear what."""
        pieces = list(self._split(part))
        if len(pieces) < 2:
            return self._corrected_before(part, state)
        current = pieces[0].words
        for piece in pieces[1:]:
            if not piece.words:
                continue
            replaced = self._replace(current, piece.words, state)
            if replaced is None:
                return None
            current = replaced
        clause = self._commands.exact(current, state)
        if clause is None or not clause.accepted:
            return clause
        return Clause(clause.reading, clause.action, f"corrected to {' '.join(current)!r}")

    def instead(self, denied: list[str], meant: list[str], state: Collection[str]) -> list[str] | None:
        """A command that is denied, with what is meant in the place of a part of it: "go to the kitchen", "to the
        bedroom". None: that is not clear, or the same, or any words would do there ("pick up the cup", "smile")."""
        words = self._replace(denied, meant, state)
        if words is None:
            return None
        before, after = (self._commands.exact(some, state) for some in (denied, words))
        if before is None or after is None or after.reading is None or after.reading.free_words:
            return None
        return words if before.accepted and after.accepted and before.action != after.action else None

    def _corrected_before(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """ "no, turn left", "actually go back": a whole command after a word of correction replaces an earlier one.

        Not "sorry, right": one word is as likely talk. Nor "no turn left" in one breath, which may forbid.
        """
        start = 0
        while length := self._correction.at(part.words, start):
            start += length
        forbids = _MAY_FORBID.issuperset(part.words[:start]) and not self._pause_after(part, start)
        if not start or len(part) < start + 2 or forbids:
            return None
        clause = self._commands.exact(part.words[start:], state)
        if clause is None or not clause.accepted:
            return clause
        return replace(clause, reason=f"after {' '.join(part.words[:start])!r}")

    def _split(self, part: Utterance) -> Iterator[Utterance]:
        """What stands between the words of correction."""
        start = position = 0
        while position < len(part):
            length = self._correction.at(part.words, position)
            if length:
                bare = position == 0 and not self._pause_after(part, position + length)
                if bare and part.words[0] in _MAY_FORBID and length == 1:
                    return  # "no go to the kitchen": who knows
                if position > start or start > 0:
                    yield part.part(start, position)
                start = position = position + length
            else:
                position += 1
        yield part.part(start, len(part))

    def _pause_after(self, part: Utterance, position: int) -> bool:
        return position < len(part) and part.breaks[position]

    @step(Kind.REPLACEMENT)
    def _replace(self, said: list[str], meant: list[str], state: Collection[str]) -> list[str] | None:
        """``said`` with the part that ``meant`` corrects replaced, or None if that is not clear.

        ``meant`` takes the place of one slot of ``said`` (or of the end of it), so that the intent stays and as many
        words as possible are kept; two ways that keep as many and differ are not clear. Else it is a whole command.
        Where free words would take it, a place or a number takes it first, then what begins with a word of the
        sentence: "on the shelf" is no box, but where it is put.
        """
        whole = self._commands.accepts(meant, state)
        if not said:
            return meant if whole else None
        kept: dict[tuple[bool, bool, int], dict[tuple[Any, ...], list[str]]] = {}
        first = next((reading for reading in self._matcher.read(said) if not reading.problem), None)
        for words, count, at, label in self._replacements(said, meant, first, whole) if first is not None else ():
            assert first is not None
            old = first.values()
            for reading in self._matcher.read(words)[:1]:
                if reading.problem or reading.intent is not first.intent:
                    continue
                touched = [slot for slot in reading.slots if slot.start < at + len(meant) and slot.end > at]
                if label is not None and label not in (slot.label for slot in touched):
                    continue
                if any(self._grafted(slot, at, meant, whole) for slot in touched):
                    continue
                new = reading.values()
                changed = {label for label, value in new.items() if old.get(label) != value}
                if set(new) != set(old) or len(changed) > 1 or not changed <= {slot.label for slot in touched}:
                    continue
                meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
                # A place takes the place of a place, though free words would take it as well.
                known = not any(slot.slot.type in _FREE for slot in touched)
                introduced = not any(slot.start <= at for slot in touched)
                kept.setdefault((known, introduced, count), {}).setdefault(meaning, words)
        if kept:
            best, known = kept[max(kept)], max(kept)[0]
            if not known and first is not None and not whole:
                # "Spell tea twice, no, honey once": "honey once" is a word only where it cannot be both again.
                several = self._replace_several(said, meant, first)
                if several is not None:
                    return several
            return next(iter(best.values())) if len(best) == 1 else None
        if whole:
            # One sentence, whole or begun: of two commands joined by "and", only the last is corrected.
            _, reached = self._matcher.strict.walk(said)
            return meant if reached is not None else None
        return self._replace_several(said, meant, first) if first is not None else None

    def _replace_several(self, said: list[str], meant: list[str], first: Reading) -> list[str] | None:
        """``said`` with neighbouring slots replaced by ``meant``, which says each of them again: "two crates of pears,
        no, three sacks of plums"; at the end of the sentence it may say more than was said. None if it is not clear.

        Nothing that was said before may be lost, so what ``meant`` leaves out makes it unclear. Free words are replaced
        only along with something else, since alone they take any others in.
        """
        old = first.values()
        spoken = sorted(first.slots, key=lambda slot: slot.start)
        kept: dict[int, dict[tuple[Any, ...], list[str]]] = {}
        for start, end in itertools.combinations_with_replacement(range(len(spoken)), 2):
            run = spoken[start : end + 1]
            last = end == len(spoken) - 1
            edges = itertools.product(_beginnings(said, meant, run[0].start), _ends(said, meant, run[-1].end))
            for at, after in edges:
                words = said[:at] + meant + said[after:]
                reading = next(iter(self._matcher.read(words)), None)
                if reading is None or reading.problem or reading.intent is not first.intent:
                    continue
                stop = at + len(meant)
                touched = [slot for slot in reading.slots if slot.start < stop and slot.end > at]
                if any(slot.start < at or slot.end > stop for slot in touched):
                    continue
                if all(slot.slot.type in _FREE for slot in run):
                    continue
                again, new = {slot.label for slot in touched}, reading.values()
                same = all(new.get(label) == value for label, value in old.items() if label not in again)
                if not same or not {slot.label for slot in run} <= again or (not last and set(new) != set(old)):
                    continue
                if not set(old) <= set(new) or not set(new) - set(old) <= again:
                    continue
                meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
                kept.setdefault(len(words) - len(meant), {}).setdefault(meaning, words)
        best = kept[max(kept)] if kept else {}
        return next(iter(best.values())) if len(best) == 1 else None

    def _replacements(
        self, said: list[str], meant: list[str], reading: Reading, whole: bool
    ) -> Iterator[tuple[list[str], int, int, str | None]]:
        """Each way to put ``meant`` into ``said``: the words, how many of the old are kept, where the new ones begin,
        and the slot that they are for."""
        within: set[int] = set()
        for slot in reading.slots:
            if slot.slot.type in _FREE:
                # Any words would do there, so all of them are replaced, and never by what is a command itself.
                within.update(range(slot.start + (not whole), slot.end))
                ends = [] if whole else [slot.end]
            else:
                ends = list(range(slot.end, slot.start, -1))
            for end in ends:
                yield said[: slot.start] + meant + said[end:], len(said) - (end - slot.start), slot.start, slot.label
        for start in range(len(said) - 1, 0, -1):
            if start not in within:
                yield said[:start] + meant, start, start, None

    def _grafted(self, slot: SlotReading, at: int, meant: list[str], whole: bool) -> bool:
        """Whether a slot would hold what was said and what was meant as one: "point" + "20 degrees per second".

        A number alone may take the unit that was said before ("two meters, no, three"), a value with its unit takes
        the place of all. Free words take nothing over, and never hold what is a command by itself.
        """
        mixed = slot.start < at or slot.end > at + len(meant)
        if slot.slot.type in _FREE:
            return mixed or whole
        if not mixed:
            return False
        if slot.slot.type in QUANTITY_KINDS:
            kinds = _WITH_UNITS if slot.slot.type in _WITH_UNITS else (slot.slot.type,)
            return any(evaluate(meant, kind, self._matcher.grammar.language) is not None for kind in kinds)
        return self._matcher.values.from_words(slot.slot, slot.label, meant).status == "exact"


def _beginnings(said: list[str], meant: list[str], start: int) -> Iterator[int]:
    """Where ``meant`` may begin in ``said``: at a slot, or with words before it that it says again ("bed five")."""
    yield start
    for length in range(1, min(start, len(meant))):
        if said[start - length : start] == meant[:length]:
            yield start - length


def _ends(said: list[str], meant: list[str], end: int) -> Iterator[int]:
    """Where ``said`` may go on after ``meant``: after a slot, or after words behind it that it says again ("times")."""
    yield end
    for length in range(1, min(len(said) - end, len(meant) - 1) + 1):
        if said[end : end + length] == meant[-length:]:
            yield end + length
