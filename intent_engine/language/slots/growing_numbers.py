"""Whether a number may still become another one: "table twenty" of forty may, "table fourteen" may not."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from intent_engine.language.grammar import Slot
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.reading import SlotReading

__all__ = ["GrowingNumbers"]

LOOK_AHEAD = 2
"""Words that a number goes on with at most until it is one again: "two hundred" + "and" + "four"."""
MOST_KEPT = 1024


class GrowingNumbers:
    """Says which numbers may go on to another that their slot takes. Thread-safe.

    Args:
        read: the value of a slot: of the words of an utterance, from one to another.
        following: the number words that may follow the beginning of an utterance.
        language: two letters.
    """

    def __init__(
        self,
        read: Callable[[Slot, str, list[str], int, int], SlotReading],
        following: Callable[[Sequence[str]], Iterable[str]],
        language: str,
    ) -> None:
        self._read = read
        self._following = following
        self._language = language
        self._known: dict[tuple[str, tuple[str, ...]], bool] = {}

    def may_grow(self, slot: Slot, label: str, words: Sequence[str], begin: int) -> bool:
        """Whether some words more would make a larger number of the last ones.

        Args:
            slot: of the number.
            label: of the slot in its sentence.
            words: said so far.
            begin: where the number begins; it goes to their end.
        """
        key = slot.name, tuple(words[begin:])
        if key not in self._known:
            said = [*words[:begin], *in_words(words[begin:], self._language)]
            value = self._read(slot, label, said, begin, len(said)).value
            if len(self._known) >= MOST_KEPT:
                self._known.clear()
            number = isinstance(value, int | float)
            self._known[key] = not number or self._grows(slot, label, said, begin, value, LOOK_AHEAD)
        return self._known[key]

    def _grows(self, slot: Slot, label: str, words: list[str], begin: int, value: float, ahead: int) -> bool:
        for word in self._following(words):
            longer = [*words, word]
            found = self._read(slot, label, longer, begin, len(longer))
            # "Eight quarters" are two, which nobody says in two pieces.
            larger = not isinstance(found.value, int | float) or abs(found.value) > abs(value)
            if not found.problem and larger:
                return True
            # What is no number yet may be one with the next word; what is beyond the limits only becomes more so.
            unread = found.status == "unknown"
            if unread and ahead > 1 and self._grows(slot, label, longer, begin, value, ahead - 1):
                return True
        return False
