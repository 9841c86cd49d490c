"""What is said of what a robot is doing: that it is to rest ("hold on"), or that it is not meant ("no, not that")."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.grammar import Grammar
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Objections"]


class Objections:
    """Tells it from words that say more.

    Args:
        grammar: whose words they are.
    """

    def __init__(self, grammar: Grammar) -> None:
        operators, wording = grammar.operators, grammar.wording
        self.hold = PhraseSet(operators.hold)
        self.objection = PhraseSet(operators.objection)
        self._held = PhraseSet((*operators.hold, *operators.correction, *wording.agreeing))
        self._objecting = PhraseSet((*operators.objection, *operators.correction))
        self._thanking = wording.thanking
        self._standing_for = wording.standing_for

    def only_hold(self, words: list[str]) -> bool:
        """Whether nothing is said but that what goes on is to rest: "wait", "no, hold on", "fine, hold on"."""
        return self.hold.find(words) is not None and self._held.cover(words)

    def only_objects(self, said: Utterance, core: Utterance) -> bool:
        """Whether nothing is said but that what goes on is not meant: "no", "no, that's wrong". "No, thanks" is said to
        somebody who offers something. ``core`` is what was said without its fillers, of which some are a part of an
        objection: "not *so* far"."""
        ways = (core.words, said.words)
        objects = any(self.objection.find(words) is not None and self._objecting.cover(words) for words in ways)
        return objects and not self.thanks(said)

    def thanks(self, said: Utterance) -> bool:
        """Whether somebody is thanked."""
        return self._thanking.find(said.words) is not None

    def without_standing_for(self, words: Sequence[str]) -> list[str]:
        """Words without those that only stand for a thing: "the right", of "the right one"."""
        return [word for word in words if word not in self._standing_for]

    def objected(self, core: Utterance) -> tuple[int, int]:
        """How many words at the beginning take back what was said before or object to what is done, and how often they
        object in one breath: twice in "no no, the lab", once in "no. No problem"."""
        words, position, counts = core.words, 0, [0]
        while length := self._objecting.at(words, position):
            single = [self.objection.at([words[at]], 0) for at in range(position, position + length)]
            for at, objects in enumerate(single, position):
                if core.breaks[at] and at:
                    counts.append(0)
                counts[-1] += objects
            if not any(single):
                counts[-1] += self.objection.at(words, position) > 0
            position += length
        return position, max(counts)
