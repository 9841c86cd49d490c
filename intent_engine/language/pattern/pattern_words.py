"""The words of a pattern, as a network beside those of templates.

A pattern is written letter by letter ("lights?( on| off)"); an automaton of letters is walked from one space to the
next, and what is read on the way is a word.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from intent_engine.language.networks.network import Call, Edge, Network, State
from intent_engine.language.numbers.spelled import number_otherwise
from intent_engine.language.pattern.pattern_tree import (
    Letters,
    Named,
    Number,
    OneOf,
    Part,
    Repeat,
    Row,
    Text,
    UnsayableError,
    Words,
)

__all__ = ["Enter", "pattern_network"]

MOST_WORDS = 600
"""Words that a pattern may have in one place."""
MOST_PLACES = 400
"""Places between two words of a pattern."""
LONGEST = 24
"""Letters of a word."""

_Whole: TypeAlias = Number | Words | Named
"""What is no text, but words of a kind."""
Enter: TypeAlias = Callable[[_Whole], Call | None]
"""Asked for the network of such words; None: the part itself says what they are."""


def pattern_network(part: Part, enter: Enter, *, numbers: bool) -> Network:
    """The network of what a pattern may be said as.

    Args:
        part: the pattern.
        enter: says what is called for a number, any words and slots.
        numbers: whether numbers in digits are said in English words as well.

    Raises:
        UnsayableError: it has too many words, or none.
    """
    letters = _LetterWays(enter)
    letters.lay(part, letters.begin, letters.end)
    return _Spaces(letters, numbers=numbers).network()


class _LetterWays:
    """An automaton of letters."""

    def __init__(self, enter: Enter) -> None:
        self._enter = enter
        self.freely: list[list[int]] = []
        """Where each state leads without a letter,"""
        self.steps: list[list[tuple[str | Call, int]]] = []
        """and with one, or with words of a kind."""
        self.anything: set[Call] = set()
        """Of these such as may be any words."""
        self.begin, self.end = self._state(), self._state()

    def _state(self) -> int:
        self.freely.append([])
        self.steps.append([])
        return len(self.steps) - 1

    def lay(self, part: Part, start: int, end: int) -> None:
        match part:
            case Text(letters):
                for letter in letters:
                    after = self._state()
                    self.steps[start].append((letter, after))
                    start = after
                self.freely[start].append(end)
            case Letters(letters) if not part.many:
                for letter in sorted(letters):
                    self.steps[start].append((letter, end))
            case Letters():
                self.lay(Words(single=True), start, end)
            case Number() | Words() | Named():
                call = self._enter(part)
                if call is not None:
                    if isinstance(part, Words):
                        self.anything.add(call)
                    self.steps[start].append((call, end))
                elif isinstance(part, Named):
                    self.lay(part.part, start, end)
            case Row(parts):
                for inner in parts:
                    after = self._state()
                    self.lay(inner, start, after)
                    start = after
                self.freely[start].append(end)
            case OneOf(parts):
                for inner in parts:
                    self.lay(inner, start, end)
            case Repeat(inner, least, most):
                for _ in range(least):
                    after = self._state()
                    self.lay(inner, start, after)
                    start = after
                if most is None:
                    again = self._state()
                    self.freely[start].append(again)
                    self.lay(inner, again, again)
                    start = again
                for _ in range((most or least) - least):
                    after = self._state()
                    self.freely[start].append(end)
                    self.lay(inner, start, after)
                    start = after
                self.freely[start].append(end)

    def closed(self, states: set[int]) -> frozenset[int]:
        """States and those that they lead to without a letter."""
        found, waiting = set(states), list(states)
        while waiting:
            for after in self.freely[waiting.pop()]:
                if after not in found:
                    found.add(after)
                    waiting.append(after)
        return frozenset(found)

    def onward(self, states: frozenset[int]) -> dict[str | Call, frozenset[int]]:
        """Where states lead, by letter or kind of words."""
        found: dict[str | Call, set[int]] = {}
        for state in sorted(states):
            for sign, after in self.steps[state]:
                found.setdefault(sign, set()).add(after)
        return {sign: self.closed(after) for sign, after in found.items()}


class _Spaces:
    """The same from word to word."""

    def __init__(self, letters: _LetterWays, *, numbers: bool) -> None:
        self._letters = letters
        self._numbers = numbers
        self._places: dict[frozenset[int], State] = {}
        self._waiting: list[frozenset[int]] = []
        self._ends = False
        """Whether some words lead to the end."""
        self._end = State()
        self._end.final = True
        self._start = self._place(letters.closed({letters.begin}))

    def network(self) -> Network:
        while self._waiting:
            states = self._waiting.pop()
            self._words_from(states, self._places[states])
        if not self._ends:
            raise UnsayableError("no words to its end")
        return Network(self._start, self._end)

    def _place(self, states: frozenset[int]) -> State:
        if states not in self._places:
            if len(self._places) >= MOST_PLACES:
                raise UnsayableError("too many places")
            self._places[states] = State()
            self._waiting.append(states)
        return self._places[states]

    def _words_from(self, states: frozenset[int], place: State) -> None:
        """All words that may come next, each with where it leads."""
        pending = [(states, "")]
        seen = {(states, "")}
        while pending:
            here, word = pending.pop()
            for sign, after in self._letters.onward(here).items():
                if isinstance(sign, Call):
                    # "bay\d+" is a word that goes on as a number: nobody knows which words those are.
                    if not word:
                        self._step(place, sign, after)
                    continue
                if sign == " ":
                    if word:  # of two blanks, or one at the beginning, nobody says a word between
                        self._say(place, word, self._place(after))
                    continue
                following = (after, word + sign)
                if following not in seen and len(word) < LONGEST:
                    seen.add(following)
                    pending.append(following)
            if word and self._letters.end in here:
                self._ends = True
                self._say(place, word, self._end)
            if len(seen) > MOST_WORDS * LONGEST or len(place.arcs) > MOST_WORDS:
                raise UnsayableError("too many words")

    def _step(self, place: State, call: Call, after: frozenset[int]) -> None:
        if place is self._start and call in self._letters.anything:
            return  # else whatever anybody says would be the beginning of ".* dance"
        onward = self._letters.onward(after)
        if self._letters.end in after:
            self._ends = True
            place.edges.append(Edge(self._end, call=call))
        if " " in onward:
            place.edges.append(Edge(self._place(onward[" "]), call=call))

    def _say(self, place: State, word: str, target: State) -> None:
        if target not in place.arcs.get(word, ()):
            place.add(word, target)
            if self._numbers:
                for way in number_otherwise((word,))[1]:
                    here = place
                    for one in way[:-1]:
                        there = State()
                        here.add(one, there)
                        here = there
                    here.add(way[-1], target)
