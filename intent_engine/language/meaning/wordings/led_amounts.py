"""Little words around an amount that a grammar has otherwise: "turn left *by* thirty degrees", "descend to *a depth
of* ten meters", "two liters *a* minute"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import QUANTITY_KINDS, Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.numbers.units import units
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["LedAmounts"]

_NOTHING = Utterance([], [])
_CHANGES = frozenset({"distance", "angle", "number"})
"""What is said to change by so much, and not to be so much: "set the speed" differs from "speed up by"."""
_AMOUNTS = frozenset({*QUANTITY_KINDS, "number"})


class LedAmounts:
    """Reads an utterance with such words as a grammar has them.

    Args:
        grammar: whose they are.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: frozenset[str]) -> None:
        self._by = grammar.wording.led_by
        self._sizes = grammar.wording.sizes
        self._articles = thing_words(grammar.language).articles
        table = units(grammar.language)
        rates = sorted(table.words["per"]) if table is not None else []
        self._rates = [words for rate in rates if len(words := rate.split()) == 1]
        self._times = frozenset(words[0] for words in table.by_kind.get("duration", {})) if table is not None else ()
        self._own = own
        self._measures = thing_words(grammar.language).measures
        self._of_own = sorted(self._sizes.keys() & own)

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without what leads an amount, and with other words between a unit and a time."""
        words, breaks = core.words, core.breaks
        for at in range(1, len(words) - 1):
            if words[at] in self._by and not any(breaks[at : at + 2]):
                yield Rewording(core.with_other(at, at + 1, _NOTHING), _Behind(words[at + 1], _CHANGES))
            end = at + 3
            sized = (
                end < len(words) and words[at] in self._articles and words[at + 1] in self._sizes.get(words[at + 2], ())
            )
            if sized and not any(breaks[at + 1 : end + 1]):
                yield Rewording(core.with_other(at, end, _NOTHING), _Behind(words[end], _AMOUNTS))
            if words[at] in self._measures and words[at + 1] not in self._of_own and not breaks[at + 1]:
                for of in self._of_own:  # "twenty milliliters lime juice"
                    yield Rewording(core.with_other(at + 1, at + 1, Utterance.in_one_breath([of])))
            if [words[at]] in self._rates and words[at + 1] in self._times:
                for other in self._rates:
                    if other != [words[at]] and other[0] in self._own:
                        yield Rewording(core.with_other(at, at + 1, Utterance.in_one_breath(other)))


class _Behind:
    """Whether an amount begins with a word."""

    def __init__(self, word: str, kinds: Collection[str]) -> None:
        self._word = word
        self._kinds = kinds

    def __call__(self, reading: Reading) -> bool:
        return any(slot.slot.type in self._kinds and reading.words[slot.start] == self._word for slot in reading.slots)
