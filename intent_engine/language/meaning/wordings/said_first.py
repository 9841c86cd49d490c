"""How something is to be done, said elsewhere than a grammar has it: "for ten minutes water the beds", "slowly move to
mark C"; and "turn the crank slowly" of one that has "slowly turn the crank"."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.counted import in_an_amount
from intent_engine.language.quantities import evaluate
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["SaidFirst"]

_MOST = 7
"""Words before the verb."""


class SaidFirst:
    """Reads such an utterance as a grammar has it, with its verb first.

    What stands first begins with a preposition, or is one adverb. It may not say when it is to be done: "in ten
    minutes water the beds" is no "water the beds in ten minutes", but "in German explain the mummy" has no time.
    """

    def __init__(self, grammar: Grammar, phrases: Phrases) -> None:
        self._says_when = grammar.wording.says_when
        self._leads = grammar.wording.leads | self._says_when
        self._is_manner = thing_words(grammar.language).is_manner
        self._language = grammar.language
        self._phrases = phrases

    def leads(self, core: Utterance) -> bool:
        """Whether it begins with a preposition of how something is done."""
        return core.words[0] in self._leads

    def verb_first(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[Utterance, range]]:
        """Ways to say one command with its verb first, each with the places where the words stand that came before."""
        for told, before in self._parted(core, verbs):
            for at in (len(told), *(at for at in range(2, len(told)) if told[at] in self._leads)):
                yield Utterance.in_one_breath([*told[:at], *before, *told[at:]]), range(at, at + len(before))

    def behind_the_verb(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[Utterance, range]]:
        """The same with those words straight behind the verb: "im Flur dimme das Licht" is "dimme im Flur das Licht".
        None that say in how long something is done."""
        for told, before in self._parted(core, verbs):
            if before[0] not in self._says_when or evaluate(before[1:], "duration", self._language) is None:
                yield Utterance.in_one_breath([told[0], *before, *told[1:]]), range(1, 1 + len(before))

    def _parted(self, core: Utterance, verbs: Collection[str]) -> Iterator[tuple[list[str], list[str]]]:
        """The words from the verb of one command on, and those before it."""
        words = core.words
        led = self.leads(core)
        if not led and not (len(words) > 1 and words[1] in verbs and self._is_manner(words[0])):
            return
        for place in range(1 + led, min(len(words), _MOST + 1)):
            verb = place + (0 if words[place] in verbs else self._phrases.merely.at(words, place))  # "just hover"
            told = core.part(verb, len(core))
            parted = any(core.breaks[1:place]) or any(told.breaks[1:])
            if told.words and told.words[0] in verbs and not parted and not self._joins(core):
                yield told.words, words[:place]

    def _joins(self, core: Utterance) -> bool:
        """Whether anything joins two commands: not the "and" of "an hour and a half"."""
        sequence = self._phrases.sequence
        if not sequence.may_stand_in(core.words):
            return False
        within = in_an_amount(core.words, self._language)
        return any(at not in within and sequence.at(core.words, at) for at in range(len(core)))

    def manner_first(self, core: Utterance) -> Iterator[tuple[Utterance, range]]:
        """One command with the adverb first that came last, and its place."""
        *told, manner = core.words
        if told and self._is_manner(manner) and not any(core.breaks[1:-1]):
            yield Utterance.in_one_breath([manner, *told]), range(1)

    def means(self, reading: Reading, moved: range) -> bool:
        """Whether what was moved is a part of the sentence by itself, and no piece of a name or of free words.

        Args:
            reading: of the words in their other order.
            moved: the places of those that stood elsewhere.
        """
        if reading.words[moved.start] in self._says_when and any(
            slot.slot.type == "duration" and slot.start in moved for slot in reading.slots
        ):
            return False
        return all(
            slot.end <= moved.start
            or slot.start >= moved.stop
            or (moved.start <= slot.start and slot.end <= moved.stop and slot.slot.type not in FREE_KINDS)
            for slot in reading.slots
        )
