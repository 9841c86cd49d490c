"""Numbers that name several things: "unlock drawer 3 and 4" is the command said once for each, in their order.

A number names a thing where the noun stands before it ("drawer 3") and counts where it stands behind ("3 cups"). A
"level 3" is how much there is of one thing, and no two of them. What may be one number ("a hundred and four"), a range,
one of two, or a correction is no list. Nor are digits that may be a row: in "gate three, four and five" of a slot that
is said digit by digit, two gates may be meant.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from intent_engine.actions import Custom
from intent_engine.language.context.done_again import AGAIN
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.normalize import without_accents
from intent_engine.language.numbers.digit_by_digit import said_together
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.name_words import singular
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.templates.template_tree import Node, references
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import words_in
from intent_engine.language.words.thing_words import thing_words

__all__ = ["OF_EACH", "ListedNumbers"]

OF_EACH = frozenset(("speed", "angular_speed", "angle", "percent", "ordinal", "boolean", "choice", "location"))
"""Types of slots that say how, where or which: behind a list they are meant for each of it. How many and how long may
be each one's, or that of all together."""
_LEAST_IN_A_ROW = 3
"""Words of a number that is surely said digit by digit: "one two and three four" may be four numbers."""


@dataclass(frozen=True, slots=True)
class _Listed:
    """Numbers behind a noun, in words from ``start`` to ``end``."""

    start: int
    end: int
    numbers: tuple[tuple[str, ...], ...]
    joints: tuple[tuple[str, ...], ...]
    """The words between them; none between two is a pause."""


class ListedNumbers:
    """The commands of one sentence in which a slot has several numbers."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._commands = commands
        self._sequence = phrases.sequence
        grammar = commands.matcher.grammar
        self._language = grammar.language
        self._has_names = any(slot.type == "number" and not slot.units for slot in grammar.slots.values())
        self._units = table = units(grammar.language)
        words = table.words if table is not None else {}
        self._and = words.get("and", frozenset[str]())
        self._ones_first = words.get("ones_first", frozenset[str]())
        known = thing_words(grammar.language)
        operators, wording = grammar.operators, grammar.wording
        turning = (*operators.negation, *operators.contrast)
        self._turns = wording.leaves_open.union(words[0] for words in turning if len(words) == 1)
        self._joining, self._scales = known.joining | known.binding | known.within, known.scales
        self._no_noun = self._joining | known.articles | known.alone | known.scales | operators.closed
        self._follows = self._joining | known.alone | known.where | wording.lasting.union(wording.parted)
        self._articles, self._definite, self._plurals = known.articles, known.definite, known.plurals

    def each(
        self, part: Utterance, state: Collection[str], after: str = "", *, of_each: bool = False
    ) -> list[Clause] | None:
        """The commands, one for each number of a list; or the one clause that is not accepted, where one of them cannot
        be done, or what follows the list may be meant otherwise than for each. None: there is no list.

        Args:
            part: of an utterance, with where words were removed in it.
            state: of the robot.
            after: the intent that it goes on from; empty: it is a command by itself.
            of_each: whether it was said that what follows is of each.
        """
        words = part.words
        if not self._has_names or sum(map(self._is_number, words)) < 2 or not self._turns.isdisjoint(words):
            return None
        for place in range(2, len(part) - 2):
            if self._is_number(part.words[place]) and not self._is_number(part.words[place - 1]):
                listed = self._listed(part, place)
                if listed is not None:
                    return self._commanded(part, listed, state, after, of_each=of_each)
        return None

    def _is_number(self, word: str) -> bool:
        return word not in self._and and self._commands.matcher.is_number(word)

    # -- what is a list -----------------------------------------------------------------------------------------

    def _listed(self, part: Utterance, start: int) -> _Listed | None:
        """The list that begins with the number at a place, behind its noun; None: there is none."""
        words, noun = part.words, part.words[start - 1]
        if noun in self._no_noun:
            return None
        end = self._number_end(part, start)
        numbers, joints = [tuple(words[start:end])], list[list[str]]()
        while (place := self._next_number(part, end, noun)) is not None:
            joints.append(words[end:place])
            end = self._number_end(part, place)
            numbers.append(tuple(words[place:end]))
        if not joints or not joints[-1]:
            return None  # without its last joint it may be a correction: "table 5, 6"
        if (
            end < len(words)
            and words[end] not in self._follows
            and not thing_words(self._language).is_manner(words[end])
        ):
            return None
        listed = _Listed(start, end, tuple(numbers), tuple(map(tuple, joints)))
        return listed if self._are_several(listed) else None

    def _number_end(self, part: Utterance, start: int) -> int:
        end = start + 1
        while end < len(part) and self._is_number(part.words[end]) and part.breaks[end] is False:
            end += 1
        return end

    def _next_number(self, part: Utterance, end: int, noun: str) -> int | None:
        """Where the next number of a list begins, behind a joint or only a pause; None: none does. The noun may be said
        again: "drawer 3 and drawer 4"."""
        words = part.words
        for length in (*self._sequence.lengths_at(words, end), 0):
            place = end + length
            if length == 0 and not (end < len(words) and part.breaks[end]):
                continue
            if length and words[place : place + 1] and words[place] in self._articles:
                place += 1
            if length and words[place : place + 1] == [noun]:
                place += 1
            elif place > end + length:
                continue
            if place < len(words) and self._is_number(words[place]):
                return place
        return None

    def _are_several(self, listed: _Listed) -> bool:
        """Whether the numbers are whole ones, and no two that follow one another may be one."""
        values = [evaluate(number, "number", self._language) for number in listed.numbers]
        if not any(values) and self._are_rows(listed):
            values = [evaluate(said_together(row, self._language), "number", self._language) for row in listed.numbers]
        if not all(isinstance(value, float) and value >= 0 and value.is_integer() for value in values):
            return False
        counted = [int(value) for value in values if isinstance(value, float)]
        return not any(
            self._may_be_one(listed.numbers[at : at + 2], counted[at : at + 2], joint)
            for at, joint in enumerate(listed.joints)
        )

    def _are_rows(self, listed: _Listed) -> bool:
        """Whether each number is said digit by digit, and all alike: "one two zero seven and one two zero eight"."""
        lengths = {len(number) for number in listed.numbers}
        return len(lengths) == 1 and min(lengths) >= _LEAST_IN_A_ROW

    def joins_one(self, words: Sequence[str], end: int, start: int) -> bool:
        """Whether the numbers before and behind a joint, in words from ``end`` to ``start``, may be one."""
        begin, stop = end, start
        while begin and self._is_number(words[begin - 1]):
            begin -= 1
        while stop < len(words) and self._is_number(words[stop]):
            stop += 1
        numbers = (tuple(words[begin:end]), tuple(words[start:stop]))
        values = [evaluate(number, "number", self._language) for number in numbers if number]
        if len(values) < len(numbers):
            return False
        counted = [int(value) for value in values if isinstance(value, float)]
        return len(counted) < len(numbers) or self._may_be_one(numbers, counted, words[end:start])

    def _may_be_one(self, numbers: Sequence[tuple[str, ...]], values: Sequence[int], joint: Sequence[str]) -> bool:
        """Whether two numbers may be one: "a hundred and four", "twenty and four", "fünf und zwanzig"."""
        if len(joint) > 1 or not self._and.issuperset(joint):
            return False
        one, other = numbers
        if any(evaluate((*one, *said, *other), "number", self._language) is not None for said in ((), *zip(self._and))):
            return True
        larger, smaller = values
        round_by = next((size for size in (1000, 100, 10) if larger % size == 0), 1)
        if 0 < smaller < round_by <= larger and larger > 10:
            return True
        inverted = bool(joint) and self._ones_first.issuperset(joint)
        return inverted and larger < 10 and 20 <= smaller < 100 and smaller % 10 == 0

    # -- what is commanded ------------------------------------------------------------------------------------

    def _commanded(
        self, part: Utterance, listed: _Listed, state: Collection[str], after: str, *, of_each: bool
    ) -> list[Clause] | None:
        """The commands of a list, or the clause that asks."""
        for before in self._ways_before(part, listed.start):
            first = self._clause(part, before, listed, 0, state, after, of_each=of_each)
            if first is None:
                continue
            others = range(1, len(listed.numbers))
            rest = [self._clause(part, before, listed, at, state, after, of_each=of_each) for at in others]
            clauses = [first, *(clause for clause in rest if clause is not None)]
            if (refused := next((clause for clause in clauses if not clause.accepted), None)) is not None:
                return [refused]
            if len(clauses) < len(listed.numbers) or not _differ_in_one(clauses):
                return None
            if self._may_be_a_row(part, before, listed, state, after):
                return None
            if of_each:
                return clauses
            plural = before.words[-1] != part.words[listed.start - 1]
            asked = self._asked(clauses, len(before), len(listed.numbers[0]), state, plural=plural)
            return clauses if asked is None else [asked]
        return None

    def _clause(
        self,
        part: Utterance,
        before: Utterance,
        listed: _Listed,
        at: int,
        state: Collection[str],
        after: str,
        *,
        of_each: bool = False,
    ) -> Clause | None:
        """The command with one number of a list, or why it cannot be done; None: it is none, or the number is no name
        in it."""
        number, behind = listed.numbers[at], part.part(listed.end, len(part))
        words = [*before.words, *number, *behind.words]
        breaks = [*before.breaks, *[False] * len(number), *behind.breaks]
        ways = [self._commands.exact(words, state, name, breaks) for name in dict.fromkeys(("", after))]
        found = [one for one in ways if one is not None]
        clause = next((one for one in found if one.accepted), next(iter(found), None))
        if clause is None or clause.reading is None:
            return None
        if before.words[-1] in self._joined_by_grammar:
            return None
        does = not clause.accepted or (isinstance(clause.action, Custom) and clause.action.name != AGAIN)
        named = self._is_named(clause.reading, len(before), len(number), of_each=of_each)
        return clause if does and named else None

    def _may_be_a_row(
        self, part: Utterance, before: Utterance, listed: _Listed, state: Collection[str], after: str
    ) -> bool:
        """Whether two numbers that only a pause parts are one of the same command: "three, four" may be 34."""
        for at, joint in enumerate(listed.joints):
            if not joint:
                one = (*listed.numbers[at], *listed.numbers[at + 1])
                row = self._clause(part, before, replace(listed, numbers=(one,)), 0, state, after)
                if row is not None and row.accepted:
                    return True
        return False

    @cached_property
    def _joined_by_grammar(self) -> frozenset[str]:
        """Words of sentences with an "and" and two numbers: of "clear table {one} [and {other}]" the grammar itself
        says how many there may be, and what each is."""
        found: set[str] = set()
        for intent in self._commands.matcher.grammar.intents.values():
            for sentence in intent.all_sentences:
                words, numbers = self._words_and_numbers(sentence.template)
                if numbers > 1 and not self._and.isdisjoint(words):
                    found |= words
        return frozenset(found)

    def _words_and_numbers(self, template: Node) -> tuple[set[str], int]:
        """The words of a template, with those of its phrases, and how many numbers it names."""
        grammar = self._commands.matcher.grammar
        nodes, words, numbers = [template], set[str](), 0
        while nodes:
            node = nodes.pop()
            words.update(words_in(node))
            for name in (one.name for one in references(node)):
                slot = grammar.slots.get(name)
                numbers += slot is not None and slot.type == "number"
                nodes += [grammar.phrases[name]] if slot is None else []
        return words, numbers

    def _is_named(self, reading: Reading, start: int, length: int, *, of_each: bool) -> bool:
        """Whether a number is what a slot holds, the word before it is of the sentence, and what was named before it is
        of each: "the cup to table 3 and 4" is one cup, and so much may be of all together unless it was said that it is
        ``of_each``."""
        slot = _slot_at(reading, start)
        if slot is None or slot.end != start + length or slot.slot.type != "number" or slot.slot.units:
            return False
        before = [other for other in reading.slots if other.start < start]
        amounts = any(other.slot.type not in OF_EACH for other in before) and not of_each
        if amounts or any(other.end >= start or other.slot.type in FREE_KINDS for other in before):
            return False
        shared = [other.end for other in before if other.slot.type == "choice"]
        return not shared or self._joining.isdisjoint(reading.words[max(shared) : start - 1])

    def _ways_before(self, part: Utterance, start: int) -> Iterator[Utterance]:
        """The words before a list, and the same with its noun as one where more than one was said: "the drawers 3 and
        4". Its article may be another then: "die Tische", "den Tisch"."""
        words, breaks = part.words[:start], part.breaks[:start]
        yield Utterance(words, breaks)
        if words[-1] in self._own_words.values():
            return
        for one in self._singular(words[-1]):
            yield Utterance([*words[:-1], one], breaks)
            if words[-2] in self._articles:
                for article in sorted(self._definite or self._articles):
                    yield self._commands.matcher.as_written(Utterance([*words[:-2], article, one], breaks))
                yield Utterance([*words[:-2], one], [*breaks[:-2], breaks[-2]])

    def _singular(self, word: str) -> Iterator[str]:
        """The words of the grammar that one of what a word names may be called."""
        found = (self._own_words.get(without_accents(one)) for (one,) in singular((word,), self._plurals))
        yield from dict.fromkeys(one for one in found if one is not None and one not in self._no_noun)

    @cached_property
    def _own_words(self) -> dict[str, str]:
        """The words of the grammar by how they are without their accents."""
        return {without_accents(word): word for word in sorted(own_words(self._commands.matcher.grammar))}

    def _asked(
        self, clauses: Sequence[Clause], start: int, length: int, state: Collection[str], *, plural: bool
    ) -> Clause | None:
        """The clause that asks what is meant by what follows a list; None: it is for each."""
        reading = clauses[0].reading
        assert reading is not None
        behind = [slot for slot in reading.slots if slot.start > start]
        if not behind:
            return None
        said = " ".join(reading.words[start + length :])
        each = tuple(described(clause.reading) for clause in clauses if clause.reading is not None)
        shared = [slot for slot in behind if not self.is_of_each(slot, reading)]
        if shared:
            reason = f"{said!r} may be for each of them, or for all together; say each command in full"
            return Clause(reading, reason=reason, alternatives=each, ambiguous=True)
        alone = self._commands.exact(list(reading.words[: start + length]), state)
        if plural or alone is None or not alone.accepted:
            return None
        reason = f"{said!r} may be meant for each of them, or for the last; say each command in full"
        return Clause(reading, reason=reason, alternatives=each, ambiguous=True)

    def is_of_each(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether what is said behind a list is of each: it says how or which, as the number of a thing does ("the
        weight and the noise of hive 6"), or how much each is to have of something."""
        return slot.slot.type in OF_EACH or self.is_name(slot, reading) or self._is_level(slot, reading)

    def _is_level(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether a number says how much each has of something: "to 20 *degrees*", but not "for 20 minutes"."""
        words, end = reading.words, slot.end
        durations = self._units.by_kind.get("duration", {}) if self._units is not None else {}
        scale = end < len(words) and words[end] in self._scales and (words[end],) not in durations
        return slot.slot.type == "number" and scale and words[slot.start - 1] in self._joining

    def is_name(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether another number names a thing as well: "pallet 3 and 4 to *bay 5*"."""
        if slot.slot.type != "number" or slot.slot.units:
            return False
        noun, rest = reading.words[slot.start - 1], reading.words[slot.end :]
        bare = not rest or rest[0] in self._follows
        return bare and noun not in self._no_noun and not any(other.end == slot.start for other in reading.slots)

    def is_of_a_letter(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether a number and the letter of a list before it are one name: "well A2"."""
        if slot.slot.type != "number" or slot.slot.units:
            return False
        words, rest = reading.words, reading.words[slot.end :]
        before = (other for other in reading.slots if other.end == slot.start and other.slot.type == "choice")
        lettered = any(other.end == other.start + 1 and len(words[other.start]) == 1 for other in before)
        return lettered and (not rest or rest[0] in self._follows)


def _slot_at(reading: Reading, start: int) -> SlotReading | None:
    return next((slot for slot in reading.slots if slot.start == start), None)


def _differ_in_one(clauses: Sequence[Clause]) -> bool:
    """Whether commands are of one sentence, and each does something else."""
    actions = [clause.action for clause in clauses]
    sentences = [clause.reading.sentence for clause in clauses if clause.reading is not None]
    alike = all(one is sentences[0] for one in sentences)
    return alike and all(action not in actions[:place] for place, action in enumerate(actions))
