"""Little words around an amount that a grammar has otherwise: "turn left *by* thirty degrees", "descend to *a depth
of* ten meters", "two liters *a* minute"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.amounts_read import AMOUNTS, Begins, Ends
from intent_engine.language.meaning.wordings.counted import amounts
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.numbers.units import units
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["LedAmounts"]

_CHANGES = frozenset({"distance", "angle", "number"})
"""What is said to change by so much, and not to be so much: "set the speed" differs from "speed up by"."""
_LASTS = frozenset({"duration"})


class LedAmounts:
    """Reads an utterance with such words as a grammar has them.

    Args:
        grammar: whose they are.
        own: the words that it is written in.
    """

    def __init__(self, grammar: Grammar, own: frozenset[str]) -> None:
        wording, known, table = grammar.wording, thing_words(grammar.language), units(grammar.language)
        self._wording = wording
        self._around = {words[0] for words in grammar.around if len(words) == 1}
        self._articles = known.articles
        self._measures = known.measures
        self._own = own
        self._contracted = {one: to for one, (to, _) in known.contracted.items() if to in own}
        self._in_two = set(known.contracted.values())
        self._by_own = sorted(wording.led_by & own)
        self._lasting_own = sorted(wording.lasting & own)
        self._lasting_behind = sorted(wording.lasting_behind & own)
        self._of_own = sorted(wording.sizes.keys() & own)
        self._rates = table.words["per"] if table is not None else frozenset[str]()
        self._times = {words[0] for words in table.by_kind.get("duration", {})} if table is not None else set[str]()
        self._language = grammar.language

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without a word, with one more, and with another."""
        counted = amounts(core.words, self._language)
        begin = {amount.start for amount in counted}
        for amount in counted if self._lasting_behind else ():  # "spül zwei Minuten", of "spül {zeit} lang"
            if core.words[amount.stop : amount.stop + 1] != self._lasting_behind[:1]:
                said = core.with_other(amount.stop, amount.stop, Utterance.in_one_breath(self._lasting_behind[:1]))
                yield Rewording(said, Begins([core.words[amount.start]], _LASTS, free=False))
        for at in range(1, len(core)):
            if not core.breaks[at]:
                yield from self._left_out(core, at)
                yield from self._put_in(core, at, counts=at in begin)
                yield from self._exchanged(core, at)

    def _left_out(self, core: Utterance, at: int) -> Iterator[Rewording]:
        words, wording = core.words, self._wording
        word, after, *_ = (*words[at : at + 2], "")
        if word in wording.sized and word not in self._own:  # "two meters deep", but "zwei Meter hoch" may be a way
            yield Rewording(core.cut(at, at + 1), Ends([words[at - 1]]))
        if any(core.breaks[at + 1 : at + 2]) or not after:
            return
        without = Rewording(core.cut(at, at + 1), Begins(words[at + 1 : at + 3], AMOUNTS))
        if word in wording.led_by or word in wording.lasting:
            kinds = _CHANGES if word in wording.led_by else _LASTS
            yield Rewording(without.said, Begins([after], kinds))
        if (words[at - 1], word) in self._in_two and is_number(after, self._language):  # "a il venti per cento"
            yield Rewording(without.said, Begins([after], {"percent"}))
        if word in self._articles and after in wording.coming and words[at - 1] in wording.lasting:
            yield from self._without_coming(core, at)
        about = word in self._around and (after in self._articles or after in wording.led_by)  # "about a meter"
        if about:
            yield without
        sizes = wording.sizes.get(words[at + 2], ()) if at + 3 < len(words) else ()
        if word in self._articles and after in sizes and not any(core.breaks[at + 2 : at + 4]):
            yield Rewording(core.cut(at, at + 3), Begins([words[at + 3]], AMOUNTS))

    def _without_coming(self, core: Utterance, at: int) -> Iterator[Rewording]:
        """ "For *the next* two hours", and "for *the next* hour", which is one."""
        first = core.words[at + 2] if at + 2 < len(core) else ""
        one = [] if is_number(first, self._language) or first not in self._times else ["one"]
        said = core.with_other(at, at + 2, Utterance.in_one_breath(one))
        yield Rewording(said, Begins([*one, first], _LASTS))

    def _put_in(self, core: Utterance, at: int, *, counts: bool) -> Iterator[Rewording]:
        words = core.words
        led = words[at - 1] in self._wording.led_by or words[at - 1] in self._wording.lasting
        for leads, kinds in ((self._by_own, _CHANGES), (self._lasting_own, _LASTS)):
            for lead in leads if counts and not led else ():  # "turn thirty degrees", of "turn by {angle}"
                said = core.with_other(at, at, Utterance.in_one_breath([lead]))
                yield Rewording(said, Begins([words[at]], kinds, free=False))
        if words[at - 1] in self._measures and words[at] not in self._of_own:
            for of in self._of_own:  # "twenty milliliters lime juice"
                yield Rewording(core.with_other(at, at, Utterance.in_one_breath([of])))

    def _exchanged(self, core: Utterance, at: int) -> Iterator[Rewording]:
        words = core.words
        word, after, *_ = (*words[at : at + 2], "")
        for other in sorted(self._wording.levels.get(words[0], ())) if after else ():  # "set the pressure at two bar"
            if word in self._wording.levels[words[0]] and other != word:
                said = core.with_other(at, at + 1, Utterance.in_one_breath([other]))
                yield Rewording(said, Begins([after], AMOUNTS))
        if word in self._contracted and after and is_number(after, self._language):  # "all'otto per cento"
            said = core.with_other(at, at + 1, Utterance.in_one_breath([self._contracted[word]]))
            yield Rewording(said, Begins([after], {"percent"}))
        for often in self._wording.how_often.get(word, ()):
            yield Rewording(core.with_other(at, at + 1, Utterance.in_one_breath(often.split())))
        for other in sorted(self._rates & self._own) if word in self._rates and after in self._times else ():
            if other != word:  # "two liters a minute"
                yield Rewording(core.with_other(at, at + 1, Utterance.in_one_breath([other])))
