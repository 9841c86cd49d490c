"""A word of a sentence that is corrected to its opposite: "turn the lamp on, no, off", "close the left, no, the right
door". Other words of sentences say what the sentence is, and are corrected by no word alone."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.thing_words import thing_words

__all__ = ["OpposedWords"]


class OpposedWords:
    """Puts what a command was corrected to in the place of the opposite that was said."""

    def __init__(self, commands: Commands) -> None:
        self._commands = commands
        self._language = commands.matcher.grammar.language
        self._articles = thing_words(self._language).articles

    def replaced(self, said: Utterance, meant: Utterance, state: Collection[str]) -> Utterance | None:
        """``said`` with the opposite of a word of it, and with what else ``meant`` says again around that; what names
        anything else stays as it was. None: there is no such word, or it is not clear which."""
        first = self._commands.exact(said.words, state, breaks=said.breaks)
        found: dict[object, Utterance] = {}
        for at, place in self._places(said.words, meant.words):
            length = min(len(meant), len(said) - at)
            broken_off = length < len(meant)
            if broken_off == (first is not None and first.accepted):
                continue
            words = said.with_other(at, at + length, meant)
            clause = self._commands.exact(words.words, state, breaks=words.breaks)
            if clause is not None and clause.accepted and self._keeps_the_rest(first, clause, place):
                found[clause.action] = words
        return next(iter(found.values())) if len(found) == 1 else None

    def _places(self, said: list[str], meant: list[str]) -> Iterator[tuple[int, int]]:
        """Where ``meant`` says words again, to the end of them or of those that were said, but for one that is the
        opposite; and where that stands."""
        for at in range(len(said)):
            pairs = list(zip(said[at:], meant, strict=False))
            others = [place for place, (one, other) in enumerate(pairs) if one != other]
            names = [place for place in others if not self._articles.issuperset(pairs[place])]
            if len(names) == 1 and pairs[names[0]][1] in opposed(pairs[names[0]][0], self._language):
                yield at, at + names[0]

    def _keeps_the_rest(self, first: Clause | None, clause: Clause, place: int) -> bool:
        """Whether a command names what the first one named, and the opposite word is of the sentence, or of a list."""
        reading = clause.reading
        if reading is None or first is None or first.reading is None:
            return reading is not None
        held = [slot for slot in reading.slots if slot.start <= place < slot.end]
        if any(slot.slot.type in FREE_KINDS for slot in held):
            return False
        changed = {slot.label for slot in held}
        was, now = (
            {slot.label: slot.value for slot in one.slots if slot.label not in changed}
            for one in (first.reading, reading)
        )
        return was == now
