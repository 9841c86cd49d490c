"""Run-on commands: "turn left go forward two meters", with no word and no pause between.

Nothing says where one ends and the next begins but the commands themselves. So it is done only if that is certain:
every part is a whole command, exactly, and begins with its verb ("turn left two meters ahead" is one), and there is one
way to part them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import pairwise

from intent_engine.actions import Custom, Stop
from intent_engine.language.context.done_again import AGAIN
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import LEAST_WORDS, Commands
from intent_engine.language.meaning.compound import MAX_PARTS
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import any_articles, thing_words

__all__ = ["RunOns"]

NAME_WORDS = 2
"""Of a thing, besides its article: with more, nobody knows which of them is its name ("the cup it is red")."""

_Ends = tuple[int, ...]


class RunOns:
    """The commands of an utterance in which nothing stands between them."""

    def __init__(self, phrases: Phrases, commands: Commands) -> None:
        self._phrases = phrases
        self._commands = commands
        self._relating = thing_words(commands.matcher.grammar.language).relating

    @step(Kind.RUN_ON)
    def split(self, core: Utterance, state: Collection[str]) -> list[Clause] | None:
        """The commands that follow one another, or None if that is not certain."""
        words = core.words
        if not self._commands.may_begin_in(words[LEAST_WORDS:]) or self._phrases.operate_in(words):
            return None
        ways = self._ways(core)
        if len(ways) != 1 or not 2 <= len(ways[0]) <= MAX_PARTS:
            return None
        parts: list[Clause] = []
        start = 0
        for end in ways[0]:
            clause = self._commands.exact(words[start:end], state, breaks=core.breaks[start:end])
            if clause is None or not self._is_certain(clause, start):
                return None
            parts.append(clause)
            start = end
        return None if self._said_twice(parts) else parts

    def may_be(self, core: Utterance) -> bool:
        """Whether the words are commands in some way, be it certain or not: for a stop beside them."""
        return bool(self._ways(core))

    def _ways(self, core: Utterance) -> list[_Ends]:
        """Up to two ways to part the words: where each part ends."""
        ends: dict[int, list[int]] = {}
        begins = {0}
        for start in range(len(core)):
            if start in begins:
                ends[start] = list(self._ends(core, start))
                begins.update(ends[start])
        ways: dict[int, list[_Ends]] = {len(core): [()]}
        for start in sorted(ends, reverse=True):
            ways[start] = [(end, *rest) for end in ends[start] for rest in ways.get(end, ())][:2]
        return ways[0]

    def _ends(self, core: Utterance, start: int) -> Iterator[int]:
        """Where a whole command that begins at a place may end, no pause being in it."""
        limit = next((place for place in range(start + 1, len(core)) if core.breaks[place]), len(core))
        words = core.words[start:limit]
        for length, readings in self._commands.whole_from(words, 0):
            if not all(self._commands.holds_command(reading, words) for reading in readings):
                yield start + length

    def _is_certain(self, clause: Clause, start: int) -> bool:
        """Whether a part is a command to be done here, shows where it begins, and names things plainly."""
        reading, action = clause.reading, clause.action
        again = isinstance(action, Custom) and action.name == AGAIN  # "keep going go forward": one thing, or two?
        if action is None or reading is None or again or isinstance(action, Stop):
            return False
        if start > 0 and not self._commands.opens_with_a_verb(reading):  # "turn left, two meters ahead"
            return False
        named = [slot for slot in reading.slots if slot.slot.type in FREE_KINDS]
        if start > 0 and any(self._may_tell_more(slot, reading) for slot in named):
            return False
        return all(self._is_thing(slot, reading) for slot in named)

    def _may_tell_more(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether what stands behind a verb may tell more of the thing before it, of which that is a part: "find a
        pizza place *that delivers*". "Put that cup down" has a thing that the slot knows."""
        first, *rest = reading.words[slot.start : slot.end]
        return first in self._relating and not slot.slot.known.issuperset(rest)

    def _is_thing(self, slot: SlotReading, reading: Reading) -> bool:
        """Whether free words are plainly a name: few, and none of them could begin a command."""
        said = [word for word in reading.words[slot.start : slot.end] if word not in any_articles()]
        return 0 < len(said) <= NAME_WORDS and self._commands.first_words.isdisjoint(said)

    def _said_twice(self, parts: list[Clause]) -> bool:
        """Whether a part may correct or repeat another: "go to the kitchen go to the lab", "turn left turn left"."""
        intents = [part.reading.intent.name for part in parts if part.reading is not None]
        actions = [part.action for part in parts]
        return any(one == other for one, other in pairwise(intents)) or any(
            action in actions[:place] for place, action in enumerate(actions)
        )
