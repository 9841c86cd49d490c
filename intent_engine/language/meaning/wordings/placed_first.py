"""Where something is, said before it: "mach im Flur das Licht an" is "mach das Licht im Flur an", in a language whose
words tell where something is from where it is to go."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["PlacedFirst"]

_MOST_IN_A_NAME = 3
"""Words of the name of a place."""
_LISTED = ("choice", "location", "number", "ordinal")


class PlacedFirst:
    """Reads such an utterance as a grammar has it, with the place behind what is there."""

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._placed = PhraseSet(grammar.wording.placed)
        self._phrases = phrases

    def ways(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[Utterance, int, int]]:
        """Ways to say one command with the place later, each with where the words of the place stand then."""
        words = core.words
        if len(words) < 4 or words[0] not in verbs or not (length := self._placed.at(words, 1)):
            return
        if any(core.breaks[1:]) or self._phrases.sequence.find(words) is not None:
            return
        for end in range(2 + length, min(len(words), 2 + length + _MOST_IN_A_NAME)):
            for place in range(end + 1, len(words) + 1):
                told = [words[0], *words[end:place], *words[1:end], *words[place:]]
                start = 1 + place - end
                yield Utterance.in_one_breath(told), start, start + end - 1

    def means(self, reading: Reading, start: int, end: int) -> bool:
        """Whether the words of the place name one that the grammar lists, and nothing else."""
        within = [slot for slot in reading.slots if slot.end > start and slot.start < end]
        return [(slot.slot.type in _LISTED, slot.end) for slot in within] == [(True, end)] and within[0].start > start
