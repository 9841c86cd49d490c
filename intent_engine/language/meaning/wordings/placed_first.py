"""Where, how and how long something is done, said before what it is done to: "mach im Flur das Licht an" is "mach das
Licht im Flur an", "riega durante diez minutos la huerta" is "riega la huerta durante diez minutos", and "pan thirty
degrees to the left" is "pan to the left thirty degrees"."""

from __future__ import annotations

from collections.abc import Iterator, Set

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.counted import amounts
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["PlacedFirst"]

_MOST_IN_A_NAME = 6
"""Words of the name of a place, or of an amount."""
_LEAST, _MOST = 3, 16
"""Words of such a command."""
_AMOUNTS = ("distance", "angle", "duration", "speed", "angular_speed", "percent")
_LISTED = ("choice", "location", "number", "ordinal", *_AMOUNTS)
_ALONE = ("choice", *_AMOUNTS)
"""What needs no preposition to be told from what stands beside it: "slowly", "thirty degrees"."""


class PlacedFirst:
    """Reads such an utterance as a grammar has it, with what stands first behind what it is said of."""

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        known = thing_words(grammar.language)
        self._placed = grammar.wording.placed
        self._leads = known.joining | known.binding | known.timed | known.delaying
        self._leading = self._leads | known.articles | known.unfinished
        self._articles = known.articles
        self._broken_off = known.definite.difference(*grammar.operators.pronoun)
        """Words behind which something was to follow, at the end."""
        self._sized = grammar.wording.sized
        self._language = grammar.language
        self._phrases = phrases
        self._sides = {way for said in grammar.wording.sides for way in said.split("/") if " " not in way} - self._leads

    def ways(self, core: Utterance, verbs: Set[str]) -> Iterator[tuple[Utterance, int, int]]:
        """Ways to say one command with such words later, each with where they stand then."""
        words = core.words
        if not _LEAST <= len(words) <= _MOST or words[0] not in verbs or any(core.breaks[1:]):
            return
        if words[-1] in self._broken_off:
            return
        counting = [place for place in range(1, len(words)) if is_number(words[place], self._language)]
        if any(core.breaks[place] is None for place in counting[1:]):
            return  # "five feet, uh, five forward": it may have been said anew
        counted = amounts(words, self._language)
        within = {at for amount in counted for at in amount[1:]}
        # The "and" of "a hundred and twenty" does not. That of "four meters and half a meter per second" may have been
        # an "at".
        begins = {amount.start for amount in counted}
        apart = {at for amount in counted if amount.stop not in begins for at in amount[1:]}
        joins = [at not in apart for at in range(len(words))]
        begun = [begin for begin in range(1, len(words) - 1) if begin not in within]
        begun.sort(key=lambda begin: not (self._is_led(words, begin) or begin in begins))  # the likeliest first
        for begin in begun:
            for end in self._ends(words, begin, counts=begin in begins):
                if end in within:
                    continue
                if words[begin] not in self._articles and not verbs.isdisjoint(words[begin:end]):
                    continue  # "step one turn left" may be "step one: turn left", but "a quarter turn" is none
                numbers = all(is_number(word, self._language) for word in words[end - 1 : end + 1])
                others = [word for at, word in enumerate(words) if joins[at] and not begin <= at < end]
                if numbers or self._phrases.sequence.find(others) is not None:
                    continue  # "with 3 5" may be with 35
                places = range(end + 1, len(words) + 1) if begin == 1 else (len(words),)
                for place in (place for place in places if place not in within):
                    told = [*words[:begin], *words[end:place], *words[begin:end], *words[place:]]
                    start = begin + place - end
                    yield Utterance.in_one_breath(told), start, start + end - begin

    def _ends(self, words: list[str], begin: int, *, counts: bool) -> range:
        """Where what begins at a place may end; further behind the verb it begins with a preposition or a number, or is
        a way."""
        lead = self._is_led(words, begin)
        counts |= words[begin] in self._articles
        if not (lead or counts or begin == 1 or words[begin] in self._sides):
            return range(0)
        most = begin + 1 + lead + _MOST_IN_A_NAME if lead or counts else begin + 2
        return range(begin + 1 + lead, min(len(words), most))

    def _is_led(self, words: list[str], at: int) -> int:
        """How many words at a place lead to a place or an amount."""
        return self._placed.at(words, at) or (words[at] in self._leads)

    def means(self, reading: Reading, start: int, end: int) -> bool:
        """Whether the words are one value that no free words are said beside, with what leads it, and nothing else."""
        within = [slot for slot in reading.slots if slot.end > start and slot.start < end]
        sized = reading.words[end - 1] in self._sized  # "zwei Minuten lang", but "bei 72 Grad"
        counted = bool(within) and (within[0].slot.type == "number" or sized) and within[0].end == end - 1
        if len(within) != 1 or not (within[0].end == end or counted) or within[0].start < start:
            return False
        if end - start == 1 and reading.words[start] in self._articles:
            return False  # "on a shelf": any, and not the one called A
        led = within[0].start > start
        said_before = any(slot.end == start and slot.slot.type == "choice" for slot in reading.slots)  # "move it up"
        if not led and not said_before and reading.words[start - 1] in self._leading:
            return False  # "turn left to" leads to what was not said
        placed = self._placed.at(list(reading.words), start) > 0
        if not placed and any(slot.slot.type in FREE_KINDS for slot in reading.slots):
            return False
        return within[0].slot.type in (_LISTED if led else _ALONE)
