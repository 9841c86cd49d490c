"""Words of a way that say no more of it than what follows: "bring the tray *over* to the lab", "put the tray *down* in
the sink", "turn the lamp *back* on"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.thing_words import thing_words

__all__ = ["WaysOn"]

_PLACES = ("location", "choice")
_NUMBERED = ("number", "ordinal")
_MOST_ARTICLES = 1
_MOST_IN_A_NAME = 3
"""Words before the number of a place: "to the second gate", "to gate number seven"."""


@dataclass(frozen=True, slots=True)
class _Way:
    """Words in a row that say no more than the one behind them."""

    start: int
    end: int
    switches: bool
    """Whether what follows is no preposition of a place, but switches something: "back *on*"."""


class WaysOn:
    """Reads an utterance without such words."""

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._words = wording.ways_on
        self._to = wording.ways_to
        self._back = {words[0] for words in wording.ways_back if len(words) == 1}
        self._into = wording.back_into
        self._puts = wording.puts
        self._brings = wording.brings
        self._switched = wording.switched
        self._particles = wording.particles
        self._articles = thing_words(grammar.language).articles
        self._any = self._words | self._back | {word for words in self._puts.values() for word in words}
        self._language = grammar.language

    def without(self, core: Utterance) -> Iterator[Utterance]:
        """The same without those words, and without those before a "back" alone: "fly *on* back to base"."""
        if self._any.isdisjoint(core.words):
            return
        ways = self._ways(core.words, core.breaks)
        if ways:
            yield _cut(core, [(way.start, way.end) for way in ways])
        before = [(way.start, way.end - 1) for way in ways if core.words[way.end - 1] in self._back]
        if before := [(start, end) for start, end in before if start < end]:
            yield _cut(core, before)

    def means(self, core: Utterance, readings: Sequence[Reading]) -> bool:
        """Whether a place stands behind each of them, or what something is switched to: "turn it *down* to ten percent"
        says more than how far. None of two opposite ways is left out."""
        ways = self._ways(core.words, core.breaks)
        left_out = {word for way in ways for word in core.words[way.start : way.end]}
        if any(not left_out.isdisjoint(opposed(word, self._language)) for word in left_out):
            return False
        prepositions = [core.words[way.end] for way in ways if not way.switches]
        switched = {core.words[way.end] for way in ways if way.switches}
        for reading in readings:
            if any(not {*reading.words}.isdisjoint(opposed(word, self._language)) for word in left_out & self._back):
                return False
            free = {at for one in reading.slots if one.slot.type in FREE_KINDS for at in range(one.start, one.end)}
            switched -= {word for at, word in enumerate(reading.words) if at not in free}
            for led in self._led(reading):
                found = next((way for way in prepositions if way in led), None)
                if found is not None:
                    prepositions.remove(found)
        return not prepositions and not switched

    def behind_a_name(self, reading: Reading, breaks: Sequence[bool | None]) -> Utterance | None:
        """The words of a reading without those that end what is free of it, behind a verb of bringing or putting: of
        "bring a bucket up to room 12" no bucket is called "bucket up". None: there are none."""
        words = reading.words
        for slot in reading.slots:
            free = slot.slot.type in FREE_KINDS and not slot.slot.dictation
            if not free or slot.end == len(words) or words[slot.end - 1] not in self._any:
                continue
            brings = self._leads(words, slot.end - 1) and not self._brings.isdisjoint(words[: slot.start])
            if not (brings or self._switches(words, slot.end - 1)):
                continue
            begin = next((at for at in range(slot.start, slot.end) if words[at] not in self._articles), slot.end)
            if self._any.issuperset(words[begin : slot.end]) or words[begin : slot.end] in slot.slot.known_names:
                continue  # "the back up", "a 7 up"
            start = next(at for at in range(slot.end, begin, -1) if words[at - 1] not in self._any)
            return Utterance([*words], [*breaks] or [False] * len(words)).cut(start, slot.end)
        return None

    def _led(self, reading: Reading) -> Iterator[Sequence[str]]:
        """The words before each place, of which one may lead to it: a slot, or words of the sentence ("to base")."""
        words = reading.words
        within = {at for slot in reading.slots for at in range(slot.start, slot.end)}
        for slot in reading.slots:
            numbered = slot.slot.type in _NUMBERED
            most = _MOST_IN_A_NAME if numbered else _MOST_ARTICLES
            if numbered or slot.slot.type in _PLACES:
                yield words[max(slot.start - 1 - most, 0) : slot.start]
        for at in range(1, len(words)):
            behind = at - 1 - (words[at - 1] in self._articles)
            if at not in within and words[at] not in self._articles and behind > 0:
                yield words[behind : behind + 1]

    def _ways(self, words: Sequence[str], breaks: Sequence[bool | None]) -> list[_Way]:
        """Where such words stand, behind the first word and with others behind, in one breath."""
        found: list[_Way] = []
        at = len(words) - 1
        while at > 1:
            end = at
            if not breaks[end] and not breaks[end - 1] and self._says_no_more(words, end - 1):
                at -= 1
                while at > 1 and words[at - 1] in self._any and not breaks[at - 1]:
                    at -= 1
                found.append(_Way(at, end, not self._leads(words, end - 1)))
            at -= 1
        return found

    def _says_no_more(self, words: Sequence[str], at: int) -> bool:
        return self._leads(words, at) or self._switches(words, at)

    def _leads(self, words: Sequence[str], at: int) -> bool:
        """Whether a word says no more than the preposition behind it."""
        word, after = words[at], words[at + 1]
        if at + 2 == len(words):
            return False
        if after not in self._into:
            return word in self._words and after in self._to
        verb = next((verb for verb in reversed(words[:at]) if verb in self._puts), "")
        return word in self._back or word in self._puts.get(verb, ())  # "put the tray back on the shelf"

    def _switches(self, words: Sequence[str], at: int) -> bool:
        """Whether it is a "back" before what belongs to a verb, or switches something: "turn it *back* on"."""
        after = words[at + 1]
        if words[at] not in self._back:
            return False
        verb = next((verb for verb in reversed(words[:at]) if verb in self._particles), "")
        return after in self._switched or after in self._particles.get(verb, ())


def _cut(said: Utterance, places: Sequence[tuple[int, int]]) -> Utterance:
    """An utterance without the words between some places, the last first."""
    for start, end in places:
        said = said.cut(start, end)
    return said
