"""The words that wake the robot, in what was heard.

A wake word is a name, and models that were made for sentences rather hear something else: "nurse bot" is "no, but" or
"do not", "hey jarvis" is "let's" or "can you please". So a command that was heard without one is compared with itself
after one; and that something shall not be done is nothing to a robot that nobody has called.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from intent_engine.actions import Action
from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["UNADDRESSED", "WakeWords"]

UNADDRESSED = 3.0
"""nats by which a command without a wake word is less likely, where the grammar has one, before it was heard."""
MISHEARD_WORDS = 4
"""Words at most that a wake word is heard as: "can you please"."""
COMPARED = 4
"""Wake words of a grammar that are compared."""


class WakeWords:
    """The wake words of one grammar; it may have none."""

    def __init__(self, grammar: Grammar) -> None:
        self._phrases = Phrases(grammar)
        self._compared = grammar.wake[:COMPARED]

    @property
    def phrases(self) -> PhraseSet:
        """The wake words."""
        return self._phrases.wake

    def addressed(self, words: Sequence[str]) -> bool:
        """Whether words are for the robot: they begin with a wake word, if there is any."""
        return not self._compared or self.after(words) > 0

    def after(self, words: Sequence[str]) -> int:
        """As :meth:`~intent_engine.language.meaning.phrases.Phrases.after_wake`."""
        return self._phrases.after_wake(words)

    def before(
        self, words: Sequence[str], acts: Callable[[Sequence[str]], tuple[Action, ...]]
    ) -> Iterator[tuple[str, ...]]:
        """A sentence that is not for the robot, as it would be: after a wake word, or with one in place of its first
        words; nothing of another.

        Args:
            words: of the sentence.
            acts: what words ask for; nothing, where they are no command.
        """
        if self.addressed(words):
            return
        asked = acts(words)
        for count in range(min(MISHEARD_WORDS + 1, len(words))):
            rest = tuple(words[count:])
            found = acts(rest)
            if found and found == (asked or found):
                yield from ((*wake, *rest) for wake in self._compared)
