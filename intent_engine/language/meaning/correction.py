"""Correction: "turn left no right", "go to the kitchen I mean the lab". The last word counts, where it is clear what it
replaces."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

from intent_engine.language.adjacent_numbers import leaves_one_of_two
from intent_engine.language.grammar import QUANTITY_KINDS
from intent_engine.language.meaning.command import Clause, Commands
from intent_engine.language.meaning.correction_places import beginnings, ends, same_but
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.quantities import counts, evaluate
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.thing_words import thing_words
from intent_engine.language.utterance import Utterance, pauses_of

__all__ = ["Corrections"]

_WITH_UNITS = tuple(kind for kind in QUANTITY_KINDS if kind not in ("number", "ordinal"))
_FREE = ("text", "object")
_MAY_FORBID = frozenset(("no", "nope", "nah"))
"""Words of correction that forbid what follows in one breath: "no turn left", but "no, turn left"."""
_NONE_OF = "no"
"""What corrects, and says that a thing is not wanted: "with milk, no sugar"."""


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

    def leans(self, part: Utterance, state: Collection[str], *, first: bool) -> bool:
        """Whether some of several commands is none by itself, since it is taken back, or takes back another: "park",
        "no, go home", of which both would be done. What begins with a verb that corrects elsewhere is one: "wait ten
        seconds"."""
        words = part.words
        if not self._correction.may_stand_in(words):
            return False
        length = 0 if first else self._correction.at(words, 0)
        begins = length > 0 and not self._begins_a_sentence(part, length)
        return (begins or self._correction.ends(words) > 0) and not self._commands.accepts(words, state)

    def may_stand_in(self, words: list[str]) -> bool:
        return self._correction.may_stand_in(words)

    @step(Kind.CORRECTION)
    def corrected(self, part: Utterance, state: Collection[str], before: str = "") -> Clause | None:
        """The command that is meant at last; None if nothing is corrected or it is not clear what.

        ``before`` names an intent whose command the part goes on from: "to the bedroom, no, to the office".
        """
        pieces = list(self._split(part))
        if len(pieces) < 2:
            return self._corrected_before(part, state) if not before else None
        current = pieces[0][0].words
        if (parted := self._parted(pieces[0][0], pieces[-1][0], state, before)) is not None:
            return parted
        for piece, denies in pieces[1:]:
            if not piece.words:
                continue
            replaced = self._replace(current, piece.words, state, before)
            if opens := self._phrases.opens(piece.words):  # "no, well, the ball": not a thing called "well"
                once_more = self._replace(current, piece.words[opens:], state, before)
                ways = [(self._matcher.read(way, after=before), way) for way in (replaced, once_more) if way]
                replaced = min(ways, key=lambda way: way[0][0].free_words if way[0] else 0, default=(None, None))[1]
            if replaced is None:
                return None
            if leaves_one_of_two(current, replaced, piece.words, lambda words: self._commands.readings(words, before)):
                return None
            if denies and self._is_what_is_had(current, replaced, piece.words):
                either = (" ".join(replaced), " ".join(current))
                reason = f"'{_NONE_OF} {' '.join(piece.words)}' may correct, or say that there shall be none"
                return Clause(reason=reason, alternatives=either, ambiguous=True)
            current = replaced
        breaks = pauses_of(current, [piece for piece, _ in pieces])
        clause = self._commands.exact(current, state, breaks=breaks)
        if before and not (clause is not None and clause.accepted):
            clause = self._commands.exact(current, state, before, breaks)
        if clause is None or not clause.accepted:
            return clause
        articles = thing_words(self._matcher.grammar.language).articles
        told = [
            word for word, after in itertools.zip_longest(current, current[1:]) if word != after or word not in articles
        ]
        return Clause(clause.reading, clause.action, f"corrected to {' '.join(told)!r}")

    def _parted(self, said: Utterance, meant: Utterance, state: Collection[str], before: str) -> Clause | None:
        """Why ``said`` is no command, if that is for a pause in a name and ``meant`` only corrects a part of it:
        "release the cup, faster, no, slower". No thing is called so."""
        if True not in said.breaks[1:] or self._commands.accepts(meant.words, state):
            return None
        ways: tuple[list[bool], ...] = ([], said.breaks)
        plain, paused = (self._commands.exact(said.words, state, before, breaks) for breaks in ways)
        refused = plain is not None and plain.accepted and paused is not None and not paused.accepted
        return paused if refused else None

    def unclear(self, part: Utterance, state: Collection[str]) -> list[str]:
        """What was said in the place of a part of a command, where it is not clear of which; empty: that is not so."""
        pieces = [piece.words for piece, _ in self._split(part) if piece.words]
        if len(pieces) != 2 or not self._commands.accepts(pieces[0], state):
            return []
        return pieces[1]

    def instead(self, denied: list[str], meant: list[str], state: Collection[str]) -> list[str] | None:
        """A command that is denied, with what is meant in the place of a part of it: "go to the kitchen", "to the
        bedroom". None: that is not clear, or the same, or any words would do there ("pick up the cup", "smile")."""
        words = self._replace(denied, meant, state, "")
        if words is None:
            return None
        before, after = (self._commands.exact(some, state) for some in (denied, words))
        if before is None or after is None or after.reading is None or after.reading.free_words:
            return None
        return words if before.accepted and after.accepted and before.action != after.action else None

    def _corrected_before(self, part: Utterance, state: Collection[str]) -> Clause | None:
        """ "no, turn left", "actually go back": a whole command after a word of correction replaces an earlier one.

        Not "sorry, right": one word is as likely talk. Nor, in one breath, "no turn left", which may forbid, and "wait
        a little more" where one may be told to wait.
        """
        start = 0
        while length := self._correction.at(part.words, start):
            start += length
        forbids = _MAY_FORBID.issuperset(part.words[:start]) and not self._pause_after(part, start)
        if not start or len(part) < start + 2 or forbids:
            return None
        if not self._pause_after(part, start) and self._commands.moves(part.words[:start], state):
            return None
        clause = self._commands.exact(part.words[start:], state)
        if clause is None or not clause.accepted:
            return clause
        return replace(clause, reason=f"after {' '.join(part.words[:start])!r}")

    def _is_what_is_had(self, said: list[str], words: list[str], meant: list[str]) -> bool:
        """Whether ``meant`` has become what something is to be *with*: "with milk, no sugar" is as likely without any.

        What begins with an article, a number or the "with" itself can only correct: "no, with sugar", "no the sugar".
        """
        known = thing_words(self._matcher.grammar.language)
        leading = known.articles | known.having
        if meant[0] in leading or self._matcher.is_number(meant[0]):
            return False
        both = enumerate(zip(said, words, strict=False))  # less may be left than was said: "move up", no, "move"
        at = next((at for at, (old, new) in both if old != new), min(len(said), len(words)))
        while at and words[at - 1] in known.articles:
            at -= 1
        return at > 0 and words[at - 1] in known.having

    def _split(self, part: Utterance) -> Iterator[tuple[Utterance, bool]]:
        """What stands between the words of correction, and whether it follows a "no" in one breath."""
        start = position = 0
        denies = False
        while position < len(part):
            length = self._correction.at(part.words, position)
            if length and position == 0 and self._begins_a_sentence(part, length):
                position = length
            elif length:
                bare = position == 0 and not self._pause_after(part, position + length)
                if bare and part.words[0] in _MAY_FORBID and length == 1:
                    return  # "no go to the kitchen": who knows
                if position > start or start > 0:
                    yield part.part(start, position), denies
                denies = part.words[position : position + length] == [_NONE_OF]
                start = position = position + length
                denies = denies and not self._pause_after(part, start)
            else:
                position += 1
        yield part.part(start, len(part)), denies

    def _begins_a_sentence(self, part: Utterance, length: int) -> bool:
        """Whether the words of correction with which a part begins are those of a sentence that goes on in one breath:
        "wait for twenty, no, thirty seconds", "make it warmer, no, cooler"."""
        words = part.words[: length + 1]
        if len(words) == length or self._pause_after(part, length):
            return False
        count, reached = self._matcher.strict.walk(words)
        return reached is not None and count == len(words)

    def _pause_after(self, part: Utterance, position: int) -> bool:
        return position < len(part) and part.breaks[position]

    @step(Kind.REPLACEMENT)
    def _replace(self, said: list[str], meant: list[str], state: Collection[str], before: str) -> list[str] | None:
        """``said`` with the part that ``meant`` corrects replaced, or None if that is not clear.

        ``meant`` takes the place of one slot of ``said`` (or of the end of it), so that the intent stays and as many
        words as possible are kept; two ways that keep as many and differ are not clear. Else it is a whole command.
        Where free words would take it, a place or a number takes it first, then a slot that lists it ("the cup to Anna,
        no, the box"), then what begins with a word of the sentence: "on the shelf" is no box, but where it is put.
        """
        whole = self._commands.accepts(meant, state)
        if not said:
            return meant if whole else None
        kept: dict[tuple[bool, bool, bool, int], dict[tuple[Any, ...], list[str]]] = {}
        first = next((reading for reading in self._commands.readings(said, before) if not reading.problem), None)
        if first is not None and before and self._says_all_again(first, meant, before):
            return meant
        for words, count, at, label in self._replacements(said, meant, first, whole) if first is not None else ():
            assert first is not None
            old = first.values()
            for reading in self._commands.readings(words, before)[:1]:
                if reading.problem or reading.intent is not first.intent:
                    continue
                touched = [slot for slot in reading.slots if slot.start < at + len(meant) and slot.end > at]
                if label is not None and label not in (slot.label for slot in touched):
                    continue
                if any(self._grafted(slot, words, at, meant, whole) for slot in touched):
                    continue
                new = reading.values()
                changed = {label for label, value in new.items() if old.get(label) != value}
                if set(new) != set(old) or len(changed) > 1 or not changed <= {slot.label for slot in touched}:
                    continue
                meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
                # A place takes the place of a place, though free words would take it as well.
                known = not any(slot.slot.type in _FREE for slot in touched)
                listed = any(meant[-1] in slot.slot.known for slot in touched)
                introduced = not any(slot.start <= at for slot in touched)
                kept.setdefault((known, listed, introduced, count), {}).setdefault(meaning, words)
        if kept:
            best, known = kept[max(kept)], max(kept)[0]
            if not known and first is not None and not whole:
                # "Spell tea twice, no, honey once": "honey once" is a word only where it cannot be both again.
                several = self._replace_several(said, meant, first, before)
                if several is not None:
                    return several
                if self._says_the_rest(said, meant, first):
                    return None
            return next(iter(best.values())) if len(best) == 1 else None
        if whole:
            # One sentence, whole or begun: of two commands joined by "and", only the last is corrected.
            automaton = self._matcher.later[before][0] if before else self._matcher.strict
            _, reached = automaton.walk(said)
            return meant if reached is not None or first is not None else None  # a pattern is in no automaton
        several = self._replace_several(said, meant, first, before) if first is not None else None
        if several is not None or before:
            return several
        return self._replace_before_end(said, meant) or (self._begin_again(said, meant, first) if first else None)

    def _begin_again(self, said: list[str], meant: list[str], first: Reading) -> list[str] | None:
        """``said`` from one of its words on as ``meant`` has it, which begins with that word: "take it to the kitchen,
        no, to room five". None if it is not clear.

        That may be another sentence, since all words before it are kept; what is replaced and what replaces it both
        name something, and all that was named before and behind that stays.
        """
        found: dict[int, dict[tuple[Any, ...], list[str]]] = {}
        held = {place for slot in first.slots for place in range(slot.start, slot.end)}
        begins = [place for place in range(1, len(said)) if said[place] == meant[0] and place not in held]
        for at, after in [(begin, end) for begin in begins for end in range(begin + 1, len(said) + 1)]:
            words = said[:at] + meant + said[after:]
            reading = next(iter(self._matcher.read(words)), None)
            if reading is None or reading.problem or any(slot.slot.type in _FREE for slot in reading.slots):
                continue
            stop, moved = at + len(meant), at + len(meant) - after
            new = [slot for slot in reading.slots if slot.start >= at and slot.end <= stop]
            old = [slot for slot in first.slots if slot.start >= at and slot.end <= after]
            kept = [
                (one.label, one.value, one.start + moved * (one.start >= after))
                for one in first.slots
                if one not in old
            ]
            stay = [(one.label, one.value, one.start) for one in reading.slots if one not in new]
            if new and old and sorted(kept, key=str) == sorted(stay, key=str):
                meaning = (reading.intent.name, *sorted((slot.label, str(slot.value)) for slot in reading.slots))
                found.setdefault(len(words), {}).setdefault(meaning, words)
        best = found[max(found)] if found else {}
        return next(iter(best.values())) if len(best) == 1 else None

    def _replace_before_end(self, said: list[str], meant: list[str]) -> list[str] | None:
        """``said``, which was broken off, with its last slots replaced by what ``meant`` begins with; the rest of
        ``meant`` is how both go on: "follow the blue, no, the red line", "wait five, no, ten minutes". None if it is
        not clear.

        What was broken off must be a command with that end, and differ in nothing but those slots. Free words take any
        others in, and are none of them but for things that their slot lists: "put the cup, no, the box on the shelf".
        """
        found: dict[tuple[Any, ...], list[str]] = {}
        for length in range(1, len(meant)):
            begun = next(iter(self._matcher.read(said + meant[length:])), None)
            if begun is None or begun.problem:
                continue
            spoken = [slot for slot in sorted(begun.slots, key=lambda slot: slot.start) if slot.start < len(said)]
            for index, slot in enumerate(spoken):
                if any(one.slot.type in _FREE for one in spoken[index:]) and not (
                    slot is spoken[-1] and self._named_otherwise(slot, said, meant[:length])
                ):
                    continue
                for at in beginnings(said, meant[:length], slot.start):
                    words = said[:at] + meant
                    reading = next(iter(self._matcher.read(words)), None)
                    if reading is None or reading.problem or reading.intent is not begun.intent:
                        continue
                    if not same_but(begun, spoken[index:], len(said), reading, at, at + length):
                        continue
                    meaning = tuple(sorted((label, str(value)) for label, value in reading.values().items()))
                    found[meaning] = min(found.get(meaning, words), words, key=len)
        return next(iter(found.values())) if len(found) == 1 else None

    def _named_otherwise(self, slot: SlotReading, said: list[str], meant: list[str]) -> bool:
        """Whether ``said`` ends with a thing that a slot lists, and ``meant`` is another one: "the cup", "the red box".

        It begins with an article: "the cup, no spoon on the table" may be about a table without one.
        """
        known, articles = slot.slot.known, thing_words(self._matcher.grammar.language).articles
        return slot.end == len(said) and said[-1] in known and meant[0] in articles and meant[-1] in known

    def _says_all_again(self, first: Reading, meant: list[str], before: str) -> bool:
        """Whether what is meant is such a part itself, and says a value for all that was said."""
        again = next(iter(self._matcher.read(meant, after=before)), None)
        return again is not None and not again.problem and again.values().keys() == first.values().keys()

    def _replace_several(self, said: list[str], meant: list[str], first: Reading, before: str) -> list[str] | None:
        """``said`` with neighbouring slots replaced by ``meant``, which says each of them again: "two crates of pears,
        no, three sacks of plums"; at the end of the sentence it may say more than was said. None if it is not clear.

        Nothing that was said before may be lost, so what ``meant`` leaves out makes it unclear. Free words are replaced
        only along with something else, since alone they take any others in, or where the same words are between them:
        "the cup to Anna, no, the box to Tom".
        """
        old = first.values()
        spoken = sorted(first.slots, key=lambda slot: slot.start)
        kept: dict[int, dict[tuple[Any, ...], list[str]]] = {}
        for start, end in itertools.combinations_with_replacement(range(len(spoken)), 2):
            run = spoken[start : end + 1]
            last = end == len(spoken) - 1
            edges = itertools.product(beginnings(said, meant, run[0].start), ends(said, meant, run[-1].end))
            for at, after in edges:
                words = said[:at] + meant + said[after:]
                reading = next(iter(self._matcher.read(words, after=before)), None)
                if reading is None or reading.problem or reading.intent is not first.intent:
                    continue
                stop = at + len(meant)
                touched = [slot for slot in reading.slots if slot.start < stop and slot.end > at]
                if any(slot.start < at or slot.end > stop for slot in touched):
                    continue
                if all(slot.slot.type in _FREE for slot in run) and not self._alike(said, run, words, touched):
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

    def _says_the_rest(self, said: list[str], meant: list[str], first: Reading) -> bool:
        """Whether ``meant`` may say again all from some free words on, though these would take all of it in: "put the
        cup on the table, no, the plate in the sink" names another place, or a plate that is in the sink."""
        for slot in first.slots:
            if slot.slot.type not in _FREE:
                continue
            reading = next(iter(self._matcher.read(said[: slot.start] + meant)), None)
            if reading is None or reading.problem or reading.intent is not first.intent:
                continue
            again = [one for one in reading.slots if one.start >= slot.start]
            if len(again) > 1 and set(reading.values()) == set(first.values()):
                return True
        return False

    def _alike(self, said: list[str], run: list[SlotReading], words: list[str], again: list[SlotReading]) -> bool:
        """Whether several slots are said again in their order, with the same words between them."""
        articles = thing_words(self._matcher.grammar.language).articles

        def outline(text: list[str], slots: list[SlotReading]) -> list[object]:
            slots = sorted(slots, key=lambda slot: slot.start)
            between = [text[one.end : other.start] for one, other in itertools.pairwise(slots)]
            return [[slot.label for slot in slots], [[word for word in gap if word not in articles] for gap in between]]

        return len(run) > 1 and outline(said, run) == outline(words, again)

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
                start = slot.start - (said[slot.start - 1 : slot.start] == meant[:1])  # an article of the sentence
            else:
                ends = [end for end in range(slot.end, slot.start, -1) if self._is_whole(slot, said, end)]
                start = slot.start
            for end in ends:
                yield said[:start] + meant + said[end:], len(said) - (end - start), start, slot.label
        for start in range(len(said) - 1, 0, -1):
            if start not in within:
                yield said[:start] + meant, start, start, None

    def _is_whole(self, slot: SlotReading, said: list[str], end: int) -> bool:
        """Whether the words of a slot up to a place may be replaced by themselves: of a quantity all, or how many there
        are, which is no "four feet six" of "four feet six inches"."""
        if end == slot.end or slot.slot.type not in QUANTITY_KINDS:
            return True
        words = said[slot.start : end]
        return any(after == len(words) for _, after in counts(words, self._matcher.grammar.language))

    def _grafted(self, slot: SlotReading, words: list[str], at: int, meant: list[str], whole: bool) -> bool:
        """Whether a slot would hold what was said and what was meant as one: "point" + "20 degrees per second".

        A number alone may take the unit that was said before ("two meters, no, three"), but goes together with no other
        number ("twenty five meters, no, thirty" is no 35); a value with its unit takes the place of all. Free words
        take nothing over, and never hold what is a command by itself.
        """
        mixed = slot.start < at or slot.end > at + len(meant)
        if slot.slot.type in _FREE:
            return mixed or whole
        if not mixed:
            return False
        if slot.slot.type in QUANTITY_KINDS:
            kept = [*words[slot.start : at], *words[at + len(meant) : slot.end]]
            if any(map(self._matcher.is_number, kept)):
                return True
            if self._matcher.values.in_own_units(slot.slot, meant) is not None:
                return True
            kinds = _WITH_UNITS if slot.slot.type in _WITH_UNITS else (slot.slot.type,)
            return any(evaluate(meant, kind, self._matcher.grammar.language) is not None for kind in kinds)
        return self._matcher.values.from_words(slot.slot, slot.label, meant).status == "exact"
