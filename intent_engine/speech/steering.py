"""Grammar to tokens: which word pieces may come next.

The recogniser writes word pieces, the grammar knows words. For each state of the grammar the words that may follow are
spelled in the model's own pieces and kept as a tree; a :class:`Cursor` walks both at once.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

__all__ = ["Cursor", "Steering", "WordGraph"]

State = Any
NUMERALS = tuple(
    dict.fromkeys(
        [str(number) for number in range(0, 101)]
        + [str(number) for number in range(105, 361, 5)]
        + [str(number) for number in range(100, 1001, 50)]
        + [f"{number}.5" for number in range(0, 21)]
        + [f"{number / 100:g}" for number in range(5, 100, 5)]
        + ["1.2", "1.25", "1.75", "1.8", "2.25", "2.75", "450", "540", "720", "1080", "2000", "5000", "10000"]
    )
)
"""Numbers in digits that a steered recogniser may write; words reach every other number."""
MAX_KEPT = 4_000


class WordGraph(Protocol):
    """What steering asks of a grammar. States are hashable."""

    def start(self) -> State: ...

    def step(self, state: State, word: str) -> State | None: ...

    def next_words(self, state: State) -> Collection[str]:
        """Words that may follow, in lower case."""
        ...

    def allows_digits(self, state: State) -> bool:
        """Whether a number in digits may follow."""
        ...

    def accepting(self, state: State) -> bool:
        """Whether the words so far are whole."""
        ...

    def free(self, state: State) -> bool:
        """Whether any word may follow."""
        ...


class _Node:
    """A place in the tree of word pieces of one grammar state."""

    __slots__ = ("children", "word")

    def __init__(self) -> None:
        self.children: dict[int, _Node] = {}
        self.word: str | None = None
        """The word that ends here."""


@dataclass(frozen=True, slots=True)
class Cursor:
    """Where a sequence of word pieces stands in the grammar."""

    state: State
    """After the last whole word."""
    node: _Node | None = None
    """In the tree of ``state``, inside a word; None between words or inside a word of a free slot."""
    loose: str = ""
    """The word so far, in a free slot."""
    words: tuple[str, ...] = ()
    """The whole words so far."""


class Steering:
    """A grammar seen through a tokenizer.

    Args:
        graph: the grammar.
        encode: text to pieces; called with a leading space before each word.
        pieces: text of every piece, by number; those that are no text (special ones) are empty.
        first_capital: also spell the first word with a capital, as the model likes to begin.
    """

    def __init__(
        self,
        graph: WordGraph,
        encode: Callable[[str], list[int]],
        pieces: list[str],
        *,
        first_capital: bool = True,
    ) -> None:
        self.graph = graph
        self._encode = lru_cache(maxsize=200_000)(lambda text: tuple(encode(text)))
        self._pieces = pieces
        self._first_capital = first_capital
        self._roots: dict[Hashable, _Node] = {}
        self._allowed: dict[Hashable, npt.NDArray[np.int64]] = {}
        self._begins = np.array(
            [n for n, piece in enumerate(pieces) if len(piece) > 1 and piece[0] == " " and piece[1:].isalpha()],
            np.int64,
        )
        self._goes_on = np.array([n for n, piece in enumerate(pieces) if piece.isalpha()], np.int64)

    def start(self) -> Cursor:
        return Cursor(self.graph.start())

    def _root(self, state: State, *, first: bool) -> _Node:
        key = (state, first)
        root = self._roots.get(key)
        if root is None:
            if len(self._roots) >= MAX_KEPT:
                self._roots.clear()
                self._allowed.clear()
            root = self._roots[key] = _Node()
            for word in self.graph.next_words(state):
                self._spell(root, word, first)
            if self.graph.allows_digits(state):
                for numeral in NUMERALS:
                    self._spell(root, numeral, False)
        return root

    def _spell(self, root: _Node, word: str, first: bool) -> None:
        if not word or not word[0].isalnum():
            return
        forms = {word, word.capitalize()} if first and self._first_capital else {word}
        for form in forms:
            node = root
            for piece in self._encode(" " + form):
                node = node.children.setdefault(piece, _Node())
            node.word = word

    def allowed(self, cursor: Cursor) -> npt.NDArray[np.int64]:
        """The pieces that may follow, as an array of their numbers; may be empty."""
        key = (cursor.state, id(cursor.node) if cursor.node else None, cursor.loose, not cursor.words)
        found = self._allowed.get(key)
        if found is None:
            found = self._allowed[key] = self._pieces_after(cursor)
        return found

    def _pieces_after(self, cursor: Cursor) -> npt.NDArray[np.int64]:
        groups: list[Any] = []
        if cursor.node is not None:
            groups.append(list(cursor.node.children))
        elif cursor.loose:
            groups.append(self._goes_on)
        else:
            groups.extend(self._beginnings(cursor.state, first=not cursor.words))
        if self._in_word(cursor):
            for after in self._finished(cursor):
                groups.extend(self._beginnings(after.state, first=False))
        if not groups:
            return np.zeros(0, np.int64)
        return np.unique(np.concatenate([np.asarray(group, np.int64) for group in groups]))

    def _beginnings(self, state: State, *, first: bool) -> Iterator[Any]:
        yield list(self._root(state, first=first).children)
        if self.graph.free(state):
            yield self._begins

    def _in_word(self, cursor: Cursor) -> bool:
        return bool(cursor.loose) or (cursor.node is not None and cursor.node.word is not None)

    def _finished(self, cursor: Cursor) -> Iterator[Cursor]:
        """The cursor after the word that ends here."""
        word = cursor.loose or (cursor.node.word if cursor.node is not None else None)
        if word:
            state = self.graph.step(cursor.state, word.lower())
            if state is not None:
                yield Cursor(state, words=(*cursor.words, word.lower()))

    def advance(self, cursor: Cursor, piece: int) -> Cursor | None:
        """The cursor after one more piece; None if it may not follow."""
        if cursor.node is not None:
            child = cursor.node.children.get(piece)
            if child is not None:
                return Cursor(cursor.state, child, "", cursor.words)
        text = self._pieces[piece] if piece < len(self._pieces) else ""
        if cursor.loose and text.isalpha():
            return Cursor(cursor.state, None, cursor.loose + text, cursor.words)
        if cursor.node is None and not cursor.loose:
            return self._begin(cursor, piece, text)
        for after in self._finished(cursor):
            begun = self._begin(after, piece, text)
            if begun is not None:
                return begun
        return None

    def _begin(self, cursor: Cursor, piece: int, text: str) -> Cursor | None:
        child = self._root(cursor.state, first=not cursor.words).children.get(piece)
        if child is not None:
            return Cursor(cursor.state, child, "", cursor.words)
        if self.graph.free(cursor.state) and len(text) > 1 and text[0] == " " and text[1:].isalpha():
            return Cursor(cursor.state, None, text[1:], cursor.words)
        return None

    def whole(self, cursor: Cursor) -> tuple[str, ...] | None:
        """The words, if they are a whole utterance; else None."""
        if cursor.node is None and not cursor.loose:
            return cursor.words if cursor.words and self.graph.accepting(cursor.state) else None
        for after in self._finished(cursor):
            if self.graph.accepting(after.state):
                return after.words
        return None
