"""What takes the place of what in a command that was corrected: "go to the kitchen", "the lab".

Every answer is a stretch of what was said, in whose place the correction is put, so that its pauses stay where they
were.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator
from typing import Any

from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.correction_places import beginnings, ends, same_but
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.quantities import counts, evaluate
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Replacements"]

_WITH_UNITS = tuple(kind for kind in QUANTITY_KINDS if kind not in ("number", "ordinal"))

_Stretch = tuple[int, int]
"""Where the words begin that are replaced, and where what follows them begins."""
_Meaning = tuple[tuple[str, str], ...]
"""The values of a command, each as text."""
_Rank = tuple[bool, bool, bool, int]
"""How good a replacement is: whether it is none in free words, is a word that their slot lists, begins with a word of
the sentence, and how many words it keeps."""


class Replacements:
    """What of a command a correction is put in the place of."""

    def __init__(self, commands: Commands) -> None:
        self._commands = commands
        self._matcher = commands.matcher

    @step(Kind.REPLACEMENT)
    def replaced(self, said: Utterance, meant: Utterance, state: Collection[str], before: str) -> Utterance | None:
        """``said`` with the part that ``meant`` corrects replaced, or None if that is not clear.

        ``meant`` takes the place of one slot of ``said`` (or of the end of it), so that the intent stays and as many
        words as possible are kept; two ways that keep as many and differ are not clear, nor is what may take the place
        of either of two names of things. Else it is a whole command.
        A number beyond the limits of the last one said is none of those before, either.
        Where free words would take it, a place or a number takes it first, then a slot that lists it ("the cup to Anna,
        no, the box"), then what begins with a word of the sentence: "on the shelf" is no box, but where it is put.

        ``before`` names an intent whose command ``said`` goes on from; empty: it is one by itself.
        """
        stretch = self._stretch(said.words, meant.words, state, before)
        return said.with_other(*stretch, meant) if stretch is not None else None

    def _stretch(self, said: list[str], meant: list[str], state: Collection[str], before: str) -> _Stretch | None:
        all_of_it = (0, len(said))
        whole = self._commands.accepts(meant, state)
        if not said:
            return all_of_it if whole else None
        first = self._commands.likeliest(said, before)
        if first is not None and before and self._says_all_again(first, meant, before):
            return all_of_it
        if first is not None and whole and self._begins_with_its_verb(first, meant):
            return all_of_it
        kept: dict[_Rank, dict[_Meaning, _Stretch]] = {}
        labels: dict[tuple[bool, bool, bool], set[str]] = {}
        ways = self._ways(said, meant, first, whole, before) if first is not None else ()
        for rank, meaning, stretch, changed in ways:
            kept.setdefault(rank, {}).setdefault(meaning, stretch)
            labels.setdefault(rank[:3], set()).update(changed)
        if kept:
            best, known = kept[max(kept)], max(kept)[0]
            if not known and first is not None and not whole:
                # "Spell tea twice, no, honey once": "honey once" is a word only where it cannot be both again.
                several = self._several(said, meant, first, before)
                if several is not None:
                    return several
                if self._says_the_rest(said, meant, first) or (not max(kept)[1] and self._begins_another(meant)):
                    return None
                if len(labels[max(kept)[:3]]) > 1 and self._may_be_either(said, meant, best.values()):
                    return None
            return next(iter(best.values())) if len(best) == 1 else None
        if whole:
            # One sentence, whole or begun: of two commands joined by "and", only the last is corrected.
            automaton = self._matcher.later[before][0] if before else self._matcher.strict
            _, reached = automaton.walk(said)
            # A pattern is in no automaton.
            return all_of_it if reached is not None or first is not None else None
        several = self._several(said, meant, first, before) if first is not None else None
        if several is not None or before:
            return several
        return self._before_end(said, meant) or (self._begin_again(said, meant, first) if first else None)

    def _ways(
        self, said: list[str], meant: list[str], first: Reading, whole: bool, before: str
    ) -> Iterator[tuple[_Rank, _Meaning, _Stretch, set[str]]]:
        """How ``meant`` may take the place of one slot of what was said: how good that is, what the whole means then,
        which words it takes the place of, and whose value changes."""
        old = first.values()
        last = _last_quantity(first)
        units = {(self._unit_begins(slot, said, meant), slot.end) for slot in first.slots}
        for at, after, label in self._stretches(said, meant, first, whole):
            words = said[:at] + meant + said[after:]
            reading = self._commands.likeliest(words, before)
            if reading is None or reading.intent is not first.intent:
                continue
            touched = [slot for slot in reading.slots if slot.start < at + len(meant) and slot.end > at]
            if label is not None and label not in (slot.label for slot in touched):
                continue
            if (at, after) not in units and any(self._grafted(slot, words, at, meant, whole, last) for slot in touched):
                continue
            if any(slot.problem and slot.label != last for slot in touched):
                continue  # "seven thirty, no, forty": no hour, but "bay four, no, ninety" may be nothing but a bay
            new = reading.values()
            changed = {label for label, value in new.items() if old.get(label) != value}
            if set(new) != set(old) or len(changed) > 1 or not changed <= {slot.label for slot in touched}:
                continue
            # A place takes the place of a place, though free words would take it as well.
            known = not any(slot.slot.type in FREE_KINDS for slot in touched)
            listed = any(meant[-1] in slot.slot.known for slot in touched)
            introduced = not any(slot.start <= at for slot in touched)
            meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
            yield (known, listed, introduced, at + len(said) - after), meaning, (at, after), changed

    def _begins_with_its_verb(self, first: Reading, meant: list[str]) -> bool:
        """Whether ``meant``, which is a command itself, has a verb, and what was said none: "americano with milk, no,
        can I get an espresso" is a whole new order, as it is where both have one."""
        opens_with_a_verb = self._commands.opens_with_a_verb
        anew = None if opens_with_a_verb(first) else self._commands.likeliest(meant)
        return anew is not None and opens_with_a_verb(anew)

    def _begins_another(self, meant: list[str]) -> bool:
        """Whether ``meant`` begins another command, which was not ended, and is no thing: "no, add eggs"."""
        if len(meant) == 1 or meant[0] not in self._commands.verbs:
            return False
        return self._matcher.prefix(meant)[1] is not None

    def _begin_again(self, said: list[str], meant: list[str], first: Reading) -> _Stretch | None:
        """The stretch of ``said`` that begins with the word with which ``meant`` begins: "take it to the kitchen, no,
        to room five". None if it is not clear.

        That may be another sentence, since all words before it are kept; what is replaced and what replaces it both
        name something, and all that was named before and behind that stays.
        """
        found: dict[int, dict[tuple[Any, ...], _Stretch]] = {}
        held = {place for slot in first.slots for place in range(slot.start, slot.end)}
        begins = [place for place in range(1, len(said)) if said[place] == meant[0] and place not in held]
        for at, after in [(begin, end) for begin in begins for end in range(begin + 1, len(said) + 1)]:
            words = said[:at] + meant + said[after:]
            reading = next(iter(self._commands.readings(words)), None)
            if reading is None or reading.problem or any(slot.slot.type in FREE_KINDS for slot in reading.slots):
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
                found.setdefault(len(words), {}).setdefault(meaning, (at, after))
        best = found[max(found)] if found else {}
        return next(iter(best.values())) if len(best) == 1 else None

    def _before_end(self, said: list[str], meant: list[str]) -> _Stretch | None:
        """The last slots of ``said``, which was broken off, if ``meant`` begins with others; the rest of ``meant`` is
        how both go on: "follow the blue, no, the red line", "wait five, no, ten minutes". None if it is not clear.

        What was broken off must be a command with that end, and differ in nothing but those slots. Free words take any
        others in, and are none of them but for things that their slot lists: "put the cup, no, the box on the shelf".
        """
        found: dict[tuple[Any, ...], _Stretch] = {}
        articles = thing_words(self._matcher.grammar.language).articles
        for length in range(1, len(meant)):
            begun = self._commands.likeliest(said + meant[length:])
            if begun is None or begun.problem:  # "drill thirty, no, four rows": of which there are no thirty
                continue
            spoken = [slot for slot in sorted(begun.slots, key=lambda slot: slot.start) if slot.start < len(said)]
            for index, slot in enumerate(spoken):
                if any(one.slot.type in FREE_KINDS for one in spoken[index:]) and not (
                    slot is spoken[-1] and self._named_otherwise(slot, said, meant[:length])
                ):
                    continue
                unit = self._unit_begins(slot, said, meant[:length]) if slot is spoken[-1] else None
                for at in (*beginnings(said, meant[:length], slot.start, articles), *(() if unit is None else (unit,))):
                    words = said[:at] + meant
                    reading = self._commands.likeliest(words)
                    if reading is None or reading.intent is not begun.intent:
                        continue
                    if not same_but(begun, spoken[index:], len(said), reading, min(at, slot.start), at + length):
                        continue
                    meaning = tuple(sorted((label, str(value)) for label, value in reading.values().items()))
                    found[meaning] = min(found.get(meaning, (at, len(said))), (at, len(said)))
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

    def _several(self, said: list[str], meant: list[str], first: Reading, before: str) -> _Stretch | None:
        """Neighbouring slots of ``said``, if ``meant`` says each of them again: "two crates of pears, no, three sacks
        of plums"; at the end of the sentence it may say more than was said. None if it is not clear.

        Nothing that was said before may be lost, so what ``meant`` leaves out makes it unclear. Free words are replaced
        only along with something else, since alone they take any others in, or where the same words are between them:
        "the cup to Anna, no, the box to Tom".
        """
        old = first.values()
        spoken = sorted(first.slots, key=lambda slot: slot.start)
        kept: dict[int, dict[tuple[Any, ...], _Stretch]] = {}
        articles = thing_words(self._matcher.grammar.language).articles
        for start, end in itertools.combinations_with_replacement(range(len(spoken)), 2):
            run = spoken[start : end + 1]
            last = end == len(spoken) - 1
            begins = beginnings(said, meant, run[0].start, articles)
            edges = itertools.product(begins, ends(said, meant, run[-1].end))
            for at, after in edges:
                words = said[:at] + meant + said[after:]
                reading = self._commands.likeliest(words, before)
                if reading is None or reading.intent is not first.intent:
                    continue
                stop = at + len(meant)
                touched = [slot for slot in reading.slots if slot.start < stop and slot.end > at]
                if any(slot.start < at or slot.end > stop for slot in touched):
                    continue
                if all(slot.slot.type in FREE_KINDS for slot in run) and not self._alike(said, run, words, touched):
                    continue
                again, new = {slot.label for slot in touched}, reading.values()
                same = all(new.get(label) == value for label, value in old.items() if label not in again)
                if not same or not {slot.label for slot in run} <= again or (not last and set(new) != set(old)):
                    continue
                if not set(old) <= set(new) or not set(new) - set(old) <= again:
                    continue
                meaning = tuple(sorted((label, str(value)) for label, value in new.items()))
                kept.setdefault(len(words) - len(meant), {}).setdefault(meaning, (at, after))
        best = kept[max(kept)] if kept else {}
        return next(iter(best.values())) if len(best) == 1 else None

    def _says_the_rest(self, said: list[str], meant: list[str], first: Reading) -> bool:
        """Whether ``meant`` may say again all from some free words on, though these would take all of it in: "put the
        cup on the table, no, the plate in the sink" names another place, or a plate that is in the sink."""
        for slot in first.slots:
            if slot.slot.type not in FREE_KINDS:
                continue
            reading = next(iter(self._matcher.read(said[: slot.start] + meant)), None)
            if reading is None or reading.problem or reading.intent is not first.intent:
                continue
            again = [one for one in reading.slots if one.start >= slot.start]
            if len(again) > 1 and set(reading.values()) == set(first.values()):
                return True
        return False

    def _may_be_either(self, said: list[str], meant: list[str], best: Collection[_Stretch]) -> bool:
        """Whether of two free slots nobody knows which is corrected, though of one fewer words would be replaced:
        "put it on the table, no, the shelf" is about no other thing, and "the box" would be any."""
        grammar = self._matcher.grammar
        pronoun = any(tuple(said[at:after]) in grammar.operators.pronoun for at, after in best)
        return pronoun or meant[0] in thing_words(grammar.language).articles

    def _alike(self, said: list[str], run: list[SlotReading], words: list[str], again: list[SlotReading]) -> bool:
        """Whether several slots are said again in their order, with the same words between them."""
        articles = thing_words(self._matcher.grammar.language).articles

        def outline(text: list[str], slots: list[SlotReading]) -> list[object]:
            slots = sorted(slots, key=lambda slot: slot.start)
            between = [text[one.end : other.start] for one, other in itertools.pairwise(slots)]
            return [[slot.label for slot in slots], [[word for word in gap if word not in articles] for gap in between]]

        return len(run) > 1 and outline(said, run) == outline(words, again)

    def _stretches(
        self, said: list[str], meant: list[str], reading: Reading, whole: bool
    ) -> Iterator[tuple[int, int, str | None]]:
        """Each stretch of ``said`` in whose place ``meant`` could be put, and the slot that it is for."""
        within: set[int] = set()
        articles = thing_words(self._matcher.grammar.language).articles
        for slot in reading.slots:
            if slot.slot.type in FREE_KINDS:
                # Any words would do there, so all of them are replaced, and never by what is a command itself.
                within.update(range(slot.start + (not whole), slot.end))
                ends = [] if whole else [slot.end]
                first, again = said[slot.start - 1 : slot.start], meant[:1]
                # An article of the sentence: "die Tasse", "den Teller".
                start = slot.start - (first == again or articles.issuperset(first + again))
                starts = [start]
            else:
                ends = [end for end in range(slot.end, slot.start, -1) if self._is_whole(slot, said, end)]
                starts = list(beginnings(said, meant[:1], slot.start, articles))
            for start, end in itertools.product(starts, ends):
                yield start, end, slot.label
            if (unit := self._unit_begins(slot, said, meant)) is not None:
                yield unit, slot.end, slot.label
        for start in range(len(said) - 1, 0, -1):
            if start not in within:
                yield start, len(said), None

    def _unit_begins(self, slot: SlotReading, said: list[str], meant: list[str]) -> int | None:
        """Where the unit of a quantity begins, if ``meant`` is another one: "five hours, no, *minutes*". None: it is
        none, or the quantity has no unit, or several."""
        is_unit = self._matcher.values.is_unit
        if slot.slot.type not in QUANTITY_KINDS or not is_unit(slot.slot, meant):
            return None
        language = self._matcher.grammar.language
        for at in range(slot.start + 1, slot.end):
            number = said[slot.start : at]
            unit = said[at : slot.end]
            if (
                unit != meant
                and is_unit(slot.slot, unit)
                and any(end == len(number) for _, end in counts(number, language))
            ):
                return at
        return None

    def _is_whole(self, slot: SlotReading, said: list[str], end: int) -> bool:
        """Whether the words of a slot up to a place may be replaced by themselves: of a quantity all, or how many there
        are, which is no "four feet six" of "four feet six inches"."""
        if end == slot.end or slot.slot.type not in QUANTITY_KINDS:
            return True
        words = said[slot.start : end]
        return any(after == len(words) for _, after in counts(words, self._matcher.grammar.language))

    def _grafted(self, slot: SlotReading, words: list[str], at: int, meant: list[str], whole: bool, last: str) -> bool:
        """Whether a slot would hold what was said and what was meant as one: "point" + "20 degrees per second".

        A number alone may take the unit that was said before ("two meters, no, three"), but goes together with no other
        number ("twenty five meters, no, thirty" is no 35); a value with its unit takes the place of all. Free words
        take nothing over, and never hold what is a command by itself.
        """
        mixed = slot.start < at or slot.end > at + len(meant)
        if slot.slot.type in FREE_KINDS:
            return mixed or whole
        if not mixed:
            return False
        if slot.slot.type in QUANTITY_KINDS:
            kept = [*words[slot.start : at], *words[at + len(meant) : slot.end]]
            if any(map(self._matcher.is_number, kept)):
                return True
            if self._matcher.values.in_own_units(slot.slot, meant) is not None:
                return True
            language = self._matcher.grammar.language
            if slot.slot.type not in _WITH_UNITS:
                takes_unit = slot.slot.units and slot.label == last  # else "500 mg for bed 3, no, 4" may be 4 mg
                return not takes_unit and evaluate(meant, slot.slot.type, language) is not None
            begun = (meant[:end] for end in range(len(meant), 0, -1))  # "no, two meters, two and a half" takes no unit
            return any(evaluate(words, kind, language) is not None for words in begun for kind in _WITH_UNITS)
        return self._matcher.values.from_words(slot.slot, slot.label, meant).status == "exact"


def _last_quantity(reading: Reading) -> str:
    """The number or the like that was said last: one that corrects and is beyond its limits may be meant for that."""
    spoken = sorted((slot.start, slot.label) for slot in reading.slots if slot.slot.type in QUANTITY_KINDS)
    return spoken[-1][1] if spoken else ""
