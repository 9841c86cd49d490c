"""Where the commands of an utterance may part: at a joint or a pause, and not within a number."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.numbers.units import units
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Joints"]


class Joints:
    """The joints of utterances.

    Args:
        matcher: of the grammar.
        sequence: its words between commands.
    """

    def __init__(self, matcher: Matcher, sequence: PhraseSet) -> None:
        self._is_number = matcher.is_number
        self._language = matcher.grammar.language
        self._sequence = sequence

    def boundaries(self, core: Utterance, start: int) -> Iterator[tuple[int, int]]:
        """(end of this part, start of the next), the longest part first."""
        words = core.words
        yield len(words), len(words)
        for end in range(len(words) - 1, start, -1):
            ends = [end + length for length in self._sequence.lengths_at(words, end)]
            ends += [more for after in ends for more in self._ends_of_clauses(words, after)]
            for after in (*ends, end) if core.breaks[end] else ends:
                if after < len(words):
                    yield end, after

    def part_numbers(self, words: Sequence[str], end: int, after: int, clause: Clause, onward: Clause) -> bool:
        """Whether no number goes on behind a joint: both commands name the same and end alike, "*two* cups for table
        *3* and *ten* plates for table *4*", and what meets at the joint is no number together.

        "Bay 3 and 2 meters back" may still be a bay of two numbers.
        """
        if not self.may_be_one_number(words, end, after):
            return True
        one, other = clause.reading, onward.reading
        if one is None or other is None or not one.slots or not other.slots:
            return False
        is_number, language = self._is_number, self._language
        begin = next((at + 1 for at in range(end - 1, -1, -1) if not is_number(words[at])), 0)
        stop = next((at for at in range(after, len(words)) if not is_number(words[at])), len(words))
        if evaluate(words[begin:stop], "number", language) is not None:
            return False
        last, first = max(one.slots, key=lambda slot: slot.end), min(other.slots, key=lambda slot: slot.start)
        ends, begins = last.end == len(one.words) and after > end, first.start == 0 and last.label != first.label
        return ends and begins and last.label in other.values() and first.label in one.values()

    def may_be_one_number(self, words: Sequence[str], end: int, after: int) -> bool:
        """Whether a number before a pause or an "and", and one behind it, may be one: "turn 15 and 20 degrees", "turn
        100, 80 degrees". Behind a "then" it is another, and no number ends with a "point"."""
        if after == len(words):
            return False
        is_number, said = self._is_number, units(self._language)
        joins, points = (said.words["and"], said.words.get("point", ("point",))) if said is not None else (None, ())
        if joins is not None and not set(words[end:after]).issubset(joins):
            return False
        return is_number(words[end - 1]) and is_number(words[after]) and words[end - 1] not in points

    def _ends_of_clauses(self, words: list[str], start: int) -> Iterator[int]:
        """Where words of sequence end that are more than one, behind others: "and *once you are there*"."""
        for length in self._sequence.lengths_at(words, start):
            if length > 1:
                yield start + length
