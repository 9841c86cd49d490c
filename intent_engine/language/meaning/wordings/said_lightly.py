"""Words that soften an order and say nothing of it: "ouvre *voir* la porte", "avvia *pure* il programma", "abre la
puerta, *anda*"; and those that say vaguely how much or how long, beside an amount: "tourne *un peu* de dix degrés"."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.parts import next_begins
from intent_engine.language.reading import Reading
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["SaidLightly"]

_PACES = ("speed", "angular_speed")
_PACED = ("move", "turn", "change_speed")
"""Actions that are done at a speed."""
_LEAST_BEFORE = 2
"""Words of an order before such a one behind it."""
_AMOUNTS = frozenset({*QUANTITY_KINDS, "number", "ordinal"})


class SaidLightly:
    """Reads an order without such words.

    Args:
        grammar: whose language has them.
        phrases: of the grammar.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        own = vocabulary(grammar)
        wording = grammar.wording
        paces = any(slot.type in _PACES for slot in grammar.slots.values())
        hurries = [phrase for phrase in wording.hurries if not paces and own.isdisjoint(phrase)]
        self._hurries = PhraseSet(hurries)
        self._softens = PhraseSet((*wording.softens, *hurries))
        self._behind = wording.softens  # none that hurries: "dos cafés más rápido" tells how
        self._vague = wording.vaguely
        self._urges = wording.urges
        self._namely = wording.namely
        self._behind_verb = wording.for_whom | wording.asked
        # Where verbs are parted or stand last, such a word stands anywhere before their end.
        further = (*(phrase for phrase in wording.softens if own.isdisjoint(phrase)), *hurries)
        self._within = PhraseSet(further if wording.parted else ())
        self._switched = wording.switched.union(wording.parted)
        self._phrases = phrases
        self._language = grammar.language

    def without(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """The same without them; None: there are none.

        Args:
            core: what was said, without its fillers.
            verbs: words with which a command may begin.
        """
        said = core
        for start, length in sorted({*self._places(core, verbs), *self._further_on(core, verbs)}, reverse=True):
            said = said.cut(start, start + length)
        return said if len(said) and said.words != core.words else None

    def means(self, core: Utterance, verbs: Collection[str], readings: Sequence[Reading]) -> bool:
        """Whether what was left out says nothing: how much or how long "a bit" is, only an amount tells; and how fast
        something is driven is no matter of hurry."""
        places = {*self._places(core, verbs)}
        if self._softener_behind(core, verbs) and any(reading.free_words for reading in readings):
            return False
        if any(reading.free_words for reading in readings) and not places.issuperset(self._further_on(core, verbs)):
            return False
        if self._hurries.find(core.words) and any(reading.intent.action.type in _PACED for reading in readings):
            return False  # "fahr schnell zwei Meter vor" says how fast
        vague = any(self._vague.at(core.words, start) for start, _ in places)
        return not vague or all(any(slot.slot.type in _AMOUNTS for slot in one.slots) for one in readings)

    def _further_on(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[int, int]]:
        """Where they stand before the end of a command: "die Kiste *eben* abstellen". Without its verb it may tell of
        something: "das Licht *schon* aus"."""
        last = core.words[-1]
        has_a_verb = core.words[0] in verbs or (last.endswith("n") and last not in self._switched)
        found = self._within.find(core.words) if has_a_verb else None
        while found is not None:
            at, end = found[0], sum(found)
            ends = end == len(core) or any(core.breaks[at + 1 : end + 1]) or self._phrases.goes_on(core.words[end:])
            numbers = all(is_number(word, self._language) for word in core.words[at - 1 : end + 1 : end - at + 1])
            if not ends and not (at and numbers):  # of "hundert, lieber fünfzig" are no 150 left
                yield found
            found = self._within.find(core.words, end)

    def _places(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[int, int]]:
        """Where they stand, and how many: behind the verbs of commands, and at the end."""
        words, start = core.words, max(self._hurries.at(core.words, 0), self._urges.at(core.words, 0))
        if 0 < start < len(core) and core.breaks[start] and words[0] not in verbs:
            yield 0, start  # "vite, ouvre la porte"
        else:
            start = 0
        while start < len(core):
            rest = words[start:]
            at = start + max(self._phrases.goes_on(rest), self._phrases.opens(rest))
            if at < len(core) and words[at] in verbs:
                at += 1 + (words[at + 1 : at + 2] != [] and words[at + 1] in self._behind_verb)
                length = max(self._softens.at(words, at), self._vague.at(words, at))
                if length and at + length < len(core) and not any(core.breaks[at : at + length]):
                    yield at, length
            start = next_begins(core, max(at, start), self._phrases)
        for at in range(2, len(core) - 1):  # "roll forward *a bit*, twenty centimeters"
            length = self._vague.at(words, at)
            if length and any(core.breaks[at + length : at + length + 1]) and not any(core.breaks[at : at + length]):
                yield at, length
        namely = next((at for at in range(2, len(core) - 1) if core.breaks[at] and self._namely.at(words, at)), None)
        if namely is not None and not any(core.breaks[namely + 1 :]):
            yield namely, self._namely.at(words, namely)
        elif last := self._urge_behind(core, verbs) or self._softener_behind(core, verbs):
            yield len(core) - last, last
        for at in (at for at in range(2, len(core) - 1) if core.breaks[at] and words[at] not in verbs):
            length = self._urges.at(words, at)  # "engrasa la cadena, *anda*, que chirría"
            if length and any(core.breaks[at + length : at + length + 1]):
                yield at, length

    def _urge_behind(self, core: Utterance, verbs: Collection[str]) -> int:
        """Words that urge at the end of an order: "abre la puerta, *anda*"."""
        last = self._urges.ends(core.words)
        return last if len(core) - last > 1 and last and core.words[-last] not in verbs else 0

    def _softener_behind(self, core: Utterance, verbs: Collection[str]) -> int:
        """Words that soften an order behind the whole of it: "bind sie *noch*", "spegni il motore *pure*". None that
        correct ("mejor"), and none behind a number, of which they may tell more."""
        length = self._behind.ends(core.words) if core.words[0] in verbs else 0
        at = len(core) - length
        if not length or at < _LEAST_BEFORE or any(core.breaks[at:]) or core.words[at] in verbs:
            return 0
        corrects = self._phrases.correction.at(core.words, at)
        return 0 if corrects or is_number(core.words[at - 1], self._language) else length
