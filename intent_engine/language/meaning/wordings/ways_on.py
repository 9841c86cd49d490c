"""Words of a way that say no more of it than what follows: "bring the tray *over* to the lab", "put the tray *down* in
the sink", "turn the lamp *back* on"."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.thing_words import thing_words

__all__ = ["WaysOn"]

_PLACES = ("location", "choice", "object")
_NUMBERED = ("number", "ordinal")
_MOST_ARTICLES = 1
_MOST_IN_A_NAME = 3
"""Words before the number of a place: "to the second gate", "to gate number seven"."""


class WaysOn:
    """Reads an utterance without such words."""

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._words = wording.ways_on
        self._to = wording.ways_to
        self._back = {words[0] for words in wording.ways_back if len(words) == 1}
        self._up = wording.up_to
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
        ways = self._ways(core)
        if ways:
            yield _cut(core, ways)
        before = [way[:-1] for way in ways if len(way) > 1 and core.words[way[-1]] in self._back]
        if before:
            yield _cut(core, before)

    def means(self, core: Utterance, readings: Sequence[Reading]) -> bool:
        """Whether a place stands behind each of them, or what something is switched to: "turn it *down* to ten percent"
        says more than how far. None of two opposite ways is left out."""
        words, ways = core.words, self._ways(core)
        left_out = {words[at] for way in ways for at in way}
        kept = {word for reading in readings for word in reading.words}
        if any(not (kept | left_out).isdisjoint(opposed(word, self._language)) for word in left_out & self._back):
            return False
        if any(not left_out.isdisjoint(opposed(word, self._language)) for word in left_out):
            return False
        names = {words[way.start - 1] for way in ways if self.may_be_a_name(words, way)}
        switched, led = set[str](), Counter[str]()
        for reading in readings:
            if any(reading.words[slot.end - 1] in names for slot in reading.slots if slot.slot.type in FREE_KINDS):
                return False
            own = self._particles.get(reading.words[0], frozenset[str]())
            free = [slot for slot in reading.slots if slot.slot.type in FREE_KINDS]
            listed = {at for slot in reading.slots if slot not in free for at in range(slot.start, slot.end)}
            within = {at for slot in free for at in range(slot.start, slot.end)}
            switched |= {
                word for at, word in enumerate(reading.words) if at in listed or (at not in within and word in own)
            }
            places = self._leading(reading, {words[way.stop] for way in ways})
            led.update(reading.words[place] for place in places)
        for way in ways:
            after = words[way.stop]
            if self._leads(words, way[-1]) and led[after]:
                led[after] -= 1
            elif not (self._switches(words, way[-1]) and after in switched):
                return False
        return True

    def behind_a_name(self, reading: Reading) -> range | None:
        """Where such words end what is free of a reading, behind a verb of bringing or putting: of "bring a bucket up
        to room 12" no bucket is called "bucket up". None: there are none."""
        words = reading.words
        for slot in reading.slots:
            free = slot.slot.type in FREE_KINDS and not slot.slot.dictation
            if not free or slot.end == len(words) or words[slot.end - 1] not in self._any:
                continue
            before = words[: slot.start]
            brings = self._leads(words, slot.end - 1) and not self._brings.isdisjoint(before)
            over = slot.end + 1 == len(words) or any(one.start == slot.end for one in reading.slots)
            switches = words[slot.end - 1] in self._back and words[slot.end] in _of_verb(before, self._particles)
            if not (brings or (over and switches)):  # "play baby come back on the radio"
                continue
            begin = next((at for at in range(slot.start, slot.end) if words[at] not in self._articles), slot.end)
            name = words[begin : slot.end]
            named = [word for word in name if word not in self._any and not is_number(word, self._language)]
            if not named or name in slot.slot.known_names:
                continue  # "the back up", "a 7 up"
            start = next(at for at in range(slot.end, begin, -1) if words[at - 1] not in self._any)
            return range(start, slot.end)
        return None

    def may_be_a_name(self, words: Sequence[str], way: range) -> bool:
        """Whether a word and what stands behind it may be a thing together: "the print out", "the pick up"."""
        own = self._particles.get(words[way.start - 1], frozenset[str]())
        return words[way.start] in own

    def _leading(self, reading: Reading, ways: Collection[str]) -> set[int]:
        """Where some words lead to a place: of a slot, or one that the sentence names itself ("to base")."""
        words = reading.words
        most = {at: _MOST_ARTICLES for at in range(1, len(words)) if words[at] not in self._articles}
        for slot in reading.slots:
            for at in range(slot.start, slot.end):
                most.pop(at, None)
            if slot.slot.type in (*_PLACES, *_NUMBERED):
                most[slot.start] = _MOST_IN_A_NAME if slot.slot.type in _NUMBERED else _MOST_ARTICLES
        found: set[int] = set()
        for at, names in most.items():
            before = range(max(at - 1 - names, 0), at)
            led = next((place for place in before if words[place] in ways), None)
            if led is not None and (names > _MOST_ARTICLES or self._articles.issuperset(words[led + 1 : at])):
                found.add(led)
        return found

    def _ways(self, core: Utterance) -> list[range]:
        """Where such words stand, behind the first word and with others behind, in one breath; the last first."""
        words, breaks = core.words, core.breaks
        found: list[range] = []
        at = len(words) - 1
        while at > 1:
            end = at
            if not (breaks[end] or breaks[end - 1]) and self._says_no_more(words, end - 1):
                at -= 1
                while at > 1 and words[at - 1] in self._any and not breaks[at - 1]:
                    at -= 1
                found.append(range(at, end))
            at -= 1
        return found

    def _says_no_more(self, words: Sequence[str], at: int) -> bool:
        return self._leads(words, at) or self._switches(words, at)

    def _leads(self, words: Sequence[str], at: int) -> bool:
        """Whether a word says no more than the preposition behind it."""
        word, after = words[at], words[at + 1]
        if at + 2 == len(words):
            return False
        if word in self._up and is_number(words[at + 2], self._language):
            return False  # "down to ten": the amount tells the way
        if after not in self._into:
            particle = word in self._switched and word in _of_verb(words[:at], self._particles)
            return word in self._words and after in self._to and not particle  # "turn the lamp on to ..."
        return word in self._back or word in _of_verb(words[:at], self._puts)  # "put the tray back on the shelf"

    def _switches(self, words: Sequence[str], at: int) -> bool:
        """Whether it is a "back" before what belongs to a verb, or switches something: "turn it *back* on"."""
        after = words[at + 1]
        if words[at] not in self._back:
            return False
        return after in self._switched or after in _of_verb(words[:at], self._particles)


def _of_verb(before: Sequence[str], by_verb: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """What the last word has that is a verb with any."""
    return next((by_verb[word] for word in reversed(before) if word in by_verb), frozenset())


def _cut(said: Utterance, ways: Sequence[range]) -> Utterance:
    """An utterance without some of its words, the last first."""
    for way in ways:
        said = said.cut(way.start, way.stop)
    return said
