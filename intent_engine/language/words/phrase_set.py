"""Plain phrases, found in the words of an utterance."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import chain

__all__ = ["PhraseSet", "SomePhrases"]


class PhraseSet:
    """Phrases of whole words, found at a position, longest first.

    Args:
        phrases: their words.
        but: others, where one of which begins none of these does.
    """

    def __init__(self, phrases: Iterable[Sequence[str]], but: Iterable[Sequence[str]] = ()) -> None:
        others = tuple(but)
        self._but = PhraseSet(others) if others else None
        self._by_first: dict[str, list[tuple[str, ...]]] = {}
        for words in sorted({tuple(words) for words in phrases if words}, key=len, reverse=True):
            self._by_first.setdefault(words[0], []).append(words)

    def __bool__(self) -> bool:
        return bool(self._by_first)

    def __iter__(self) -> Iterator[tuple[str, ...]]:
        return chain.from_iterable(self._by_first.values())

    def may_stand_in(self, words: Iterable[str]) -> bool:
        """A quick look: whether any phrase could begin in these words."""
        return not self._by_first.keys().isdisjoint(words)

    def at(self, words: Sequence[str], position: int) -> int:
        """Length of the longest phrase that begins at a position; 0 for none."""
        for phrase in self._by_first.get(words[position], ()) if position < len(words) else ():
            if tuple(words[position : position + len(phrase)]) == phrase:
                return 0 if self._but is not None and self._but.at(words, position) else len(phrase)
        return 0

    def lengths_at(self, words: Sequence[str], position: int) -> list[int]:
        """Lengths of all phrases that begin at a position, longest first."""
        begun = self._by_first.get(words[position], ()) if position < len(words) else ()
        if begun and self._but is not None and self._but.at(words, position):
            return []
        return [len(phrase) for phrase in begun if tuple(words[position : position + len(phrase)]) == phrase]

    def after(self, words: Sequence[str], position: int) -> int:
        """Where the words go on behind all phrases that stand at a position, one after the other."""
        while length := self.at(words, position):
            position += length
        return position

    def cover(self, words: Sequence[str]) -> bool:
        """Whether the words are such phrases, one after the other, and nothing else."""
        return self.after(words, 0) == len(words)

    def ends(self, words: Sequence[str]) -> int:
        """Length of the longest phrase that the words end with; 0 for none."""
        for start in range(len(words)):
            if self.at(words, start) == len(words) - start:
                return len(words) - start
        return 0

    def find(self, words: Sequence[str], start: int = 0) -> tuple[int, int] | None:
        """First (position, length) at or after ``start``."""
        if not self.may_stand_in(words):
            return None
        for position in range(start, len(words)):
            if words[position] in self._by_first and (length := self.at(words, position)):
                return position, length
        return None


class SomePhrases(PhraseSet):
    """Those of some phrases for which a test holds. Each is tested when it is first said: a test may be slow.

    Args:
        phrases: to be tested.
        test: of a phrase; the same for all time.
    """

    def __init__(self, phrases: Iterable[Sequence[str]], test: Callable[[tuple[str, ...]], bool]) -> None:
        super().__init__(phrases)
        self._test = cache(test)

    def at(self, words: Sequence[str], position: int) -> int:
        return next(iter(self.lengths_at(words, position)), 0)

    def lengths_at(self, words: Sequence[str], position: int) -> list[int]:
        lengths = super().lengths_at(words, position)
        return [length for length in lengths if self._test(tuple(words[position : position + length]))]
