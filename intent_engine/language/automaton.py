"""The word automaton: one graph for matching, prefix states, steering, sampling and checking.

The networks of a grammar are walked as one non-deterministic automaton whose states are pairs (place in a network,
networks to return to). It is made deterministic lazily: a set of such pairs, ordered by preference, is a
:class:`WordState`, and the step from one set to the next on a word is computed once and kept. So a sentence costs
its words, not the grammar's size, and the time is linear in the words for every grammar.

Each kept step remembers, for every member of the new set, which member of the old one it came from and what was
passed on the way (slots opened and closed, values). Reading back from an accepting member therefore gives the slots,
as in Laurikari, "NFAs with tagged transitions" (2000), with preference in place of leftmost-longest.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Any

from intent_engine.errors import ConfigError
from intent_engine.language.networks.network import Edge, Networks, State
from intent_engine.language.networks.word_state import (
    Entry,
    Mark,
    Member,
    Passed,
    Reached,
    Stack,
    Taken,
    Trace,
    Ways,
    WordState,
    traced,
)

__all__ = ["SOUND", "Automaton"]

MAX_MEMBERS = 20_000
"""Members of one set. Shipped grammars need hundreds; a grammar beyond this doubles at every optional."""
MAX_KEPT = 30_000
"""Sets kept before the store is emptied, so that endless new sentences cannot fill the memory."""

MAX_OTHER_WORDS = 2_000
"""Steps of one set beyond which words that no arc names are looked up by their kind each time."""

SOUND = ("sound",)
"""Mark of a call to sounds that may be made anywhere."""

TOO_AMBIGUOUS = "the grammar is too ambiguous: more than 20,000 ways to go on after the same words"


class Automaton:
    """Deterministic walks over networks. Thread-safe: kept steps are read without a lock, new ones made under it.

    Args:
        networks: the networks that calls name.
        root: where every walk begins; its calls and edges lead to the sentences.
        loose: also enter the networks for names that may be misspelled, and read sound-alikes.
        traced: whether sentences are read back, and ways on; else it is only walked, and new states are made faster,
            since two ways that differ in preference lead to one state.
        refusing: whether no free slot swallows what is nothing for it, so that no sentence is found that would be
            refused; else it is read, and told.
        is_numeral: tells whether a word is a numeral.
        is_number_word: tells whether a word is a number word of the language.
        closed_words: words that a free slot never swallows.
        sound_alikes: heard word -> words that may have been meant.
    """

    def __init__(
        self,
        networks: Networks,
        root: State,
        *,
        loose: bool = False,
        traced: bool = True,
        refusing: bool = False,
        is_numeral: Callable[[str], bool],
        is_number_word: Callable[[str], bool],
        closed_words: frozenset[str] = frozenset(),
        sound_alikes: Mapping[str, tuple[str, ...]] | None = None,
    ) -> None:
        self._networks = networks
        self._root = root
        self._loose = loose
        self._traced = traced
        self._refusing = refusing
        self._is_numeral = is_numeral
        self._is_number_word = is_number_word
        self._closed = closed_words
        self._alikes = sound_alikes or {}
        self._lock = networks.lock
        self._bottom = Stack(None, None, None)
        self._forget()

    def _forget(self) -> None:
        self._kept: dict[tuple[int, ...] | frozenset[int], WordState] = {}
        self._start: WordState | None = None
        # Of these there are few, in very many sets and steps: each is kept once.
        self._members: dict[tuple[int, int], Member] = {}
        self._passed: dict[Passed, Passed] = {}
        self._ways: dict[tuple[Passed, ...], tuple[Passed, ...]] = {}
        self._meetings: dict[tuple[tuple[int, int], tuple[Mark, ...]], Reached] = {}
        self._closures: dict[tuple[int, int], tuple[Reached, ...]] = {}
        self._places: dict[tuple[int, int], dict[int, Member]] = {}

    # -- walking ----------------------------------------------------------------------------------------------

    def start(self) -> WordState:
        """The state before the first word."""
        start = self._start
        if start is None:
            with self._lock:
                state, passed = self._close([(self._root, self._bottom, 0, ())])
                # A copy of its own: a start remembers what was passed before any word.
                start = WordState(state.members, state.accepts)
                start.came_from = passed
                self._start = start
        return start

    def step(self, state: WordState, word: str) -> WordState | None:
        """The state after one more word, or None if no sentence goes on so."""
        taken = self._taken(state, word)
        return taken[0] if taken else None

    def walk(self, words: Iterable[str]) -> tuple[int, WordState | None]:
        """How many words could be read, and the state after them (None if a word was impossible)."""
        state = self.start()
        count = 0
        for word in words:
            taken = self._taken(state, word)
            if taken is None:
                return count, None
            state = taken[0]
            count += 1
        return count, state

    def read(self, words: list[str]) -> list[Trace]:
        """Every way in which the words are a whole sentence, most wanted first; one for each sentence."""
        walked = self._walked(words)
        if walked is None:
            return []
        state, came_from = walked
        if not state.accepts:
            return []
        backwards = list(enumerate(came_from))[::-1]
        return [traced(backwards, at) for at in state.accepts]

    def _walked(self, words: Iterable[str]) -> tuple[WordState, list[tuple[Passed, ...]]] | None:
        """The state after some words, and how the members of each state on the way were come by; None: no sentence
        begins so."""
        state = self.start()
        came_from = [state.came_from]
        for word in words:
            taken = state.steps.get(word) or self._taken(state, word)
            if taken is None:
                return None
            state, passed = taken
            came_from.append(passed)
        return state, came_from

    def _taken(self, state: WordState, word: str) -> Taken | None:
        steps = state.steps
        if word in steps:
            return steps[word]
        with self._lock:
            key, ways = word, state.ways
            onward = ways.reading(word)
            if not onward and not any(ways.names(one) for one in (word, *self._alikes.get(word, ()))):
                # A word that no arc names is like any other such word: keep one step for all of them.
                kind = (
                    state.numerals and self._is_numeral(word),
                    self._is_number_word(word),
                    word in self._closed,
                )
                key = f"\0{kind}"
                if key in steps:
                    if len(steps) < MAX_OTHER_WORDS:
                        steps[word] = steps[key]
                    return steps[key]
            taken = self._advance(ways, word, onward)
            steps[key] = taken
            return taken

    def _advance(self, ways: Ways, word: str, onward: list[Entry]) -> Taken | None:
        """The step on a word, which some members read by an arc, ``onward``."""
        named = len(onward)
        if ways.numeral and self._is_numeral(word):
            onward += [(target, stack, index, ()) for place, stack, index in ways.numeral for target in place.numeral]
        if ways.number and self._is_number_word(word):
            onward += [(target, stack, index, ()) for place, stack, index in ways.number for target in place.number]
        if len(onward) > named:
            onward.sort(key=lambda entry: entry[2])  # as they are preferred in the set
        guessed: list[Entry] = [
            (target, stack, index, (("alike", meant),))
            for meant in self._alikes.get(word, ())
            for arcs, stack, index in ways.arcs
            for target in arcs.get(meant, ())
        ]
        guessed.sort(key=lambda entry: entry[2])
        free = word not in self._closed
        swallowed: list[Entry] = [
            (target, stack, index, ())
            for place, stack, index in ways.wild
            if (free or word in place.allowed)
            and not (self._refusing and word in place.refused)
            and not (named and word in place.yielded)
            for target in place.swallowed(word)
        ]
        if not (onward or guessed or swallowed):
            return None
        # A word of the grammar is read as such before it is taken for another, or a free slot takes it: "the cup from
        # the table" is a thing and where it is, "lift up the cup" no "up the cup". Read as it is said, "play another
        # love" has a title before "another" is "a".
        entries = onward + (guessed + swallowed if self._loose else swallowed + guessed)
        return self._close(entries) if self._traced else (self._merge(entries), ())

    def _close(self, entries: Iterable[Entry]) -> Taken:
        """Follow every step that reads no word, in order of preference; keep the places where a word is read."""
        seen: set[int] = set()
        members: list[Member] = []
        passed: list[Passed] = []
        for place, stack, origin, marks in entries:
            for member, further in self._closure(place, stack):
                if id(member) not in seen:
                    seen.add(id(member))
                    members.append(member)
                    came = (origin, (*marks, *further) if further else marks)
                    passed.append(self._passed.setdefault(came, came))
        state = self._state(tuple(map(id, members)), members)
        ways = tuple(passed)
        return state, self._ways.setdefault(ways, ways)

    def _merge(self, entries: Iterable[Entry]) -> WordState:
        """The same without what is passed on the way, nor the order."""
        members: dict[int, Member] = {}
        for place, stack in {(id(place), id(stack)): (place, stack) for place, stack, *_ in entries}.values():
            reached = self._places.get((id(place), id(stack)))
            if reached is None:
                reached = {id(member): member for member, _ in self._reached(place, stack)}
                self._places[id(place), id(stack)] = reached
            members.update(reached)
        return self._state(frozenset(members), members.values())

    def _state(self, key: tuple[int, ...] | frozenset[int], members: Collection[Member]) -> WordState:
        if len(members) > MAX_MEMBERS:
            raise ConfigError(TOO_AMBIGUOUS)
        state = self._kept.get(key)
        if state is None:
            if len(self._kept) >= MAX_KEPT:
                self._forget()
            accepts = tuple(at for at, (place, stack) in enumerate(members) if place.final and stack.target is None)
            state = self._kept[key] = WordState(tuple(members), accepts)
        return state

    def _closure(self, place: State, stack: Stack) -> tuple[Reached, ...]:
        """The places where a word is read that are reached from one without reading any, most wanted first, with what
        is passed on the way. Many sets meet in the same few, so it is kept."""
        closure = self._closures.get((id(place), id(stack)))
        if closure is None:
            closure = self._closures[id(place), id(stack)] = tuple(self._reached(place, stack))
        return closure

    def _reached(self, place: State, stack: Stack) -> Iterator[Reached]:
        seen: set[tuple[int, int]] = set()
        pending: list[tuple[State, Stack, tuple[Mark, ...]]] = [(place, stack, ())]
        while pending:
            place, stack, marks = pending.pop()
            identity = (id(place), id(stack))
            if identity in seen:
                continue
            seen.add(identity)
            if len(seen) > MAX_MEMBERS:
                raise ConfigError(TOO_AMBIGUOUS)
            if place.expand is not None:
                expand, place.expand = place.expand, None
                expand(place)
            if place.arcs or place.numeral or place.number or place.wild or (place.final and stack.target is None):
                reached = (self._members.setdefault(identity, (place, stack)), marks)
                yield self._meetings.setdefault((identity, marks), reached)
            if place.final and stack.target is not None and stack.parent is not None:
                left = marks if stack.call_mark is None else (*marks, ("close", stack.call_mark))
                pending.append((stack.target, stack.parent, left))
            for edge in reversed(place.edges):
                self._follow(edge, stack, marks, pending)

    def _follow(
        self,
        edge: Edge,
        stack: Stack,
        marks: tuple[Mark, ...],
        pending: list[tuple[State, Stack, tuple[Mark, ...]]],
    ) -> None:
        if edge.mark is not None:
            marks = (*marks, edge.mark)
        call = edge.call
        if call is None:
            pending.append((edge.target, stack, marks))
            return
        for key, loose in ((call.loose, True), (call.network, False)):
            if key is None or (loose and not self._loose):
                continue
            inner = stack.calls.get((id(edge), loose))
            if inner is None:
                inner = stack.calls[(id(edge), loose)] = Stack(edge.target, stack, call.mark, stack.apart or call.apart)
            opened = marks if call.mark is None else (*marks, ("open", call.mark, loose))
            pending.append((self._networks[key].start, inner, opened))

    # -- looking ahead ----------------------------------------------------------------------------------------

    def next_words(self, state: WordState, *, sounds: bool = True) -> set[str]:
        """The words that may follow, without numerals and without what a free slot would take.

        Args:
            state: after the words so far.
            sounds: with those that may be made anywhere, as "uh".
        """
        words: set[str] = set()
        for place, stack in state.members:
            if sounds or stack.call_mark is not SOUND:
                words.update(place.arcs)
        return words

    def known_words(self, state: WordState) -> frozenset[str]:
        """The words that are likely in a free slot that is open."""
        found = [place.known for place, _ in state.members if place.known]
        return frozenset[str]().union(*found) if len(found) != 1 else found[0]

    def allows_digits(self, state: WordState) -> bool:
        """Whether a numeral may follow."""
        return state.numerals

    def free(self, state: WordState) -> bool:
        """Whether any word may follow, because a free slot is open."""
        return state.wild

    def accepting(self, state: WordState) -> bool:
        """Whether the words so far are a whole sentence."""
        return bool(state.accepts)

    def ways_on(self, words: Iterable[str]) -> Iterator[tuple[State, list[tuple[State, Any, bool]], Trace]]:
        """Places at which a sentence that was begun may go on or be over after some words, each with the networks that
        it was entered through, innermost first: where they return to, their mark, and whether no word of them was said;
        and with what was passed on the way there.
        """
        walked = self._walked(words)
        if walked is None:
            return
        state, came_from = walked
        backwards = list(enumerate(came_from))[::-1]
        for at, (place, stack) in enumerate(state.members):
            if stack.apart or stack.parent is None:
                continue
            _, marks = came_from[-1][at]
            entered = {mark[1] for mark in marks if mark[0] == "open"}
            calls: list[tuple[State, Any, bool]] = []
            within: Stack | None = stack
            while within is not None and within.target is not None:
                calls.append((within.target, within.call_mark, within.call_mark in entered))
                within = within.parent
            yield place, calls, traced(backwards, at)

    def inside(self, state: WordState) -> bool:
        """Whether a sentence that was begun could go on (not only a further one begin)."""
        return any(
            stack.parent is not None and not stack.apart and (place.arcs or place.numeral or place.number or place.wild)
            for place, stack in state.members
        )
