"""Fillers that may be commands: "right" agrees, or turns; "right then" opens, or begins a list."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["FillersOrCommands", "before_joint"]


def before_joint(words: Sequence[str], joints: PhraseSet) -> list[str]:
    """Words without the joint with which they end."""
    return list(words[: len(words) - joints.ends(words)])


@dataclass(frozen=True, slots=True)
class FillersOrCommands:
    """Tells which of the two such words are."""

    fillers: PhraseSet
    """All that say nothing."""
    joints: PhraseSet
    """Phrases between commands."""
    listing: PhraseSet
    """Fillers that are a command and a joint: "right then"."""
    hides: PhraseSet
    """Fillers of several words of which one is a command: "right away"."""
    alone: Callable[[str], bool]
    """Whether a word is a command by itself."""
    agrees: frozenset[str]
    """Words that agree and are a command: "right"."""
    agreeing: PhraseSet
    """Fillers that only agree: "yeah"."""

    def as_a_list(self, said: Utterance) -> tuple[list[str], Utterance] | None:
        """The command that may be the first of a list, and what follows, with its joint: "right then turn left".

        None: the utterance does not begin so, or a pause tells what is meant ("right then, turn left"). Of "right, turn
        left" it tells nothing.
        """
        if (agreed := self._agreed(said)) is not None or not self.listing.may_stand_in(said.words):
            return agreed
        start, length = 0, 0
        while start < len(said) and not (length := self.listing.at(said.words, start)):
            skipped = self.fillers.at(said.words, start)
            if not skipped:
                return None
            start += skipped
        end = start + length
        if end == len(said) or any(said.breaks[start + 1 : end + 1]):
            return None
        first = before_joint(said.words[start:end], self.joints)
        return first, said.part(start + len(first), len(said))

    def _agreed(self, said: Utterance) -> tuple[list[str], Utterance] | None:
        """The command that may be only a word of agreement, before a pause, and what follows that."""
        start = 0
        while start < len(said) and said.words[start] not in self.agrees:
            if not (length := self.fillers.at(said.words, start)):
                return None
            start += length
        after = start + 1
        if after >= len(said) or not said.breaks[after] or self.joints.at(said.words, after):
            return None
        return said.words[start:after], said.part(after, len(said))

    def only_agrees(self, said: Utterance) -> bool:
        """Whether an utterance is a command that may say nothing, among words of agreement alone, or said more than
        once: "yeah right", "right, right"."""
        words = [word for word in said.words if word not in self.agrees]
        return 1 < len(said) > len(words) and self.agreeing.cover(words)

    def agrees_at_last(self, said: Utterance) -> bool:
        """Whether it ends so behind a pause: "go forward, okay right"."""
        return any(said.breaks[at] and self.only_agrees(said.part(at, len(said))) for at in range(1, len(said)))

    def in_full(self, said: Utterance) -> Utterance | None:
        """An utterance with the word that is a command in the place of each filler that has one in it, where no pause
        follows: "turn right away ninety degrees" may be "turn right ninety degrees". None: there is no such filler."""
        if self.hides.find(said.words) is None:
            return None
        words: list[str] = []
        breaks: list[bool | None] = []
        position = 0
        while position < len(said):
            length = self.hides.at(said.words, position)
            end = position + length
            if length and (end == len(said) or not said.breaks[end]):
                words.append(next(filter(self.alone, said.words[position:end])))
            else:
                end = position + 1
                words.append(said.words[position])
            breaks.append(said.breaks[position])
            position = end
        return Utterance(words, breaks) if len(words) < len(said) else None
