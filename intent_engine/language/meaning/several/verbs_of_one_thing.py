"""Several verbs said of one thing: "open and close the first gate" is "open the first gate" and "close the first gate".

Only a thing that is named is meant for each of them: with "the" before it, or by its number ("gate 3"). What is free
words, how much, how long or where to may belong to the last alone, and so may all that no article begins: "turn and go
left".
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.actions import Custom
from intent_engine.language.context.done_again import AGAIN
from intent_engine.language.grammar import TELLING_APART
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.several.listed_numbers import ListedNumbers
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["VerbsOfOneThing"]

MOST_WORDS = 3
"""Of a verb with its particle: "switch on"."""
_LEAST = 4
_BOTH = 2


class VerbsOfOneThing:
    """The commands of one sentence that names its thing once, behind the last of two verbs."""

    def __init__(self, phrases: Phrases, commands: Commands, lists: ListedNumbers) -> None:
        self._commands = commands
        self._lists = lists
        self._sequence = phrases.sequence
        self._operate_in = phrases.change_meaning
        known = thing_words(commands.matcher.grammar.language)
        self._definite, self._articles = known.definite, known.articles

    def may_stand_in(self, part: Utterance) -> bool:
        """A quick look: whether two verbs are joined at its beginning."""
        return next(self._joints(part), None) is not None

    def each(self, part: Utterance, state: Collection[str]) -> list[Clause] | None:
        """The two commands. None: there are none, or more than one way to have them."""
        words = part.words
        found: dict[tuple[object, object], list[Clause]] = {}
        for start, end in self._joints(part):
            last = self._told(words[end:], state)
            if last is None or last[1].action is None:
                continue
            for thing in range(end + 1, min(end + MOST_WORDS, len(words) - 1) + 1):
                first = self._told([*words[:start], *words[thing:]], state)
                if first is None or not self._name_the_same(first[0], start, last[0], thing - end):
                    continue
                both = [first[1], last[1]]
                if len({one.action for one in both}) == _BOTH:
                    found[both[0].action, both[1].action] = both
        return next(iter(found.values())) if len(found) == 1 else None

    def _joints(self, part: Utterance) -> Iterator[tuple[int, int]]:
        words = part.words
        if len(words) < _LEAST or words[0] not in self._commands.verbs:
            return
        for start in range(1, min(MOST_WORDS, len(words) - _BOTH) + 1):
            end = start + self._sequence.at(words, start)
            if start < end < len(words) and words[end] in self._commands.verbs and words[end] != words[0]:
                yield start, end
                return

    def _told(self, words: list[str], state: Collection[str]) -> tuple[Reading, Clause] | None:
        clause = self._commands.exact(words, state)
        if clause is None or not clause.accepted or clause.reading is None or clause.reading.free_words:
            return None
        named = isinstance(clause.action, Custom) and clause.action.name != AGAIN
        return (clause.reading, clause) if named and len(clause.reading.words) == len(words) else None

    def _name_the_same(self, first: Reading, start: int, last: Reading, begin: int) -> bool:
        """Whether both name one thing from these words on, and nothing else."""
        one, other = first.words[start:], last.words[begin:]
        things, same = ([slot for slot in of.slots if slot.end > at] for of, at in ((first, start), (last, begin)))
        if one != other or [(slot.label, slot.value) for slot in things] != [(slot.label, slot.value) for slot in same]:
            return False
        numbered = bool(same) and all(self._lists.is_name(slot, last) for slot in same)
        articled = one[0] in self._definite and len(one) > 1 and one[1] not in self._articles
        tells = all(slot.slot.type in TELLING_APART or self._lists.is_name(slot, last) for slot in same)
        return (numbered and same[0].start > begin) or (articled and tells and len(same) <= _BOTH)
