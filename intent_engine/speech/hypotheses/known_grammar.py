"""What speech is compared with, of one language's grammar, until it is reloaded."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.meaning.negations.doing import verbs
from intent_engine.language.networks.approximate import FreeWord, UtteranceSearch
from intent_engine.language.reading import SlotReading
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.verb_forms import told_forms_of
from intent_engine.speech.hypotheses.narration import narrating
from intent_engine.speech.hypotheses.other_wordings import small_words
from intent_engine.speech.hypotheses.usual import UsualNumbers
from intent_engine.speech.hypotheses.vocabulary import known_in_slots, known_words, words_as_written
from intent_engine.speech.hypotheses.wake_words import WakeWords
from intent_engine.speech.thresholds import SURE_ENOUGH

if TYPE_CHECKING:
    from intent_engine.language.matcher import Matcher

__all__ = ["KnownGrammar"]

CANDIDATES = 8
"""Utterances of the grammar, like the words heard, that are looked up."""
SEARCHES = 64
"""Searches whose results are kept."""
MEANINGS = 512
"""Texts whose meaning is kept, before all are forgotten: of one utterance a hundred sentences may be asked about, most
of them three times."""


@dataclass(slots=True)
class KnownGrammar:
    """The words and phrases of a grammar, by what they do in a sentence."""

    matcher: Matcher
    words: frozenset[str]
    corrections: PhraseSet
    """"I mean", "no", "make that","""
    correcting: frozenset[str]
    """and their words, which a sentence that is corrected has besides;"""
    denying: frozenset[str]
    """and those of "don't ... but ...", of one that denies something."""
    asking: PhraseSet
    """"Would you mind", before the form of a verb that tells what somebody does."""
    sequence: PhraseSet
    """"And then"."""
    negations: PhraseSet
    """"Not", "never","""
    narrating: frozenset[str]
    """and all words with which a sentence is no command."""
    wake: WakeWords
    empty: PhraseSet
    """What says nothing: "please","""
    leading: PhraseSet
    """also at the beginning: "and then"."""
    small: frozenset[str]
    """Words that people put anywhere: "that", "by", "over","""
    own: frozenset[str]
    """and those in which sentences are written."""
    in_slots: frozenset[str]
    letters: frozenset[str]
    """Single letters in its sentences, lists and names, those of codes among them: "b" of "B3"."""
    as_written: Mapping[str, str]
    search: UtteranceSearch
    usual: UsualNumbers
    least: float
    """Confidence from which anything is acted on."""
    found: dict[tuple[tuple[str, ...], bool, tuple[str, ...]], list[tuple[tuple[str, ...], float]]] = field(
        default_factory=dict
    )
    """Of some words, looked for wider or not, the sentences that are like them, with a beginning or any."""
    meanings: dict[str, Interpretation] = field(default_factory=dict)
    """What texts mean that were asked about lately."""

    @classmethod
    def of(cls, matcher: Matcher) -> KnownGrammar:
        """What the grammar and the map of a matcher have."""
        grammar, words = matcher.grammar, known_words(matcher)
        own, in_slots = frozenset(vocabulary(grammar)), known_in_slots(matcher)
        operators = grammar.operators
        asked = [intent.min_confidence for intent in grammar.intents.values()]
        return cls(
            matcher=matcher,
            words=words,
            corrections=PhraseSet(operators.correction),
            correcting=frozenset(word for words in operators.correction for word in words),
            denying=frozenset(
                word for words in (*operators.negation, *operators.contrast, *grammar.wording.negated) for word in words
            ),
            asking=PhraseSet((*grammar.wording.asks_for_doing, *grammar.wording.asks_to_do)),
            sequence=PhraseSet(operators.sequence),
            negations=PhraseSet(operators.negation),
            narrating=narrating(grammar),
            wake=WakeWords(grammar),
            empty=PhraseSet((*grammar.fillers, *grammar.around)),
            leading=PhraseSet((*grammar.fillers, *operators.opening)),
            small=small_words(grammar.wording, grammar.language),
            own=own,
            in_slots=in_slots,
            letters=frozenset(word for word in own | in_slots if len(word) == 1 and word.isalpha()),
            as_written=words_as_written(matcher),
            search=UtteranceSearch(matcher.likely, words),
            usual=UsualNumbers(grammar),
            least=min([SURE_ENOUGH, *(one for one in asked if one is not None)]),
        )

    def meaning(self, text: str, read: Callable[[], Interpretation]) -> Interpretation:
        """What a text means, read if it was not asked about lately."""
        found = self.meanings.get(text)
        if found is None:
            if len(self.meanings) >= MEANINGS:
                self.meanings.clear()
            found = self.meanings[text] = read()
        return found

    def nearest(
        self, heard: tuple[str, ...], *, wider: bool = False, begin: tuple[str, ...] = ()
    ) -> list[tuple[tuple[str, ...], float]]:
        """The sentences like some words, as :meth:`UtteranceSearch.nearest` has them; those of one utterance are asked
        for again and again."""
        if len(self.found) > SEARCHES:
            self.found.clear()
        found = self.found.get((heard, wider, begin))
        if found is None:
            found = self.search.nearest(heard, CANDIDATES, self.narrating, wider=wider, begin=begin)
            self.found[heard, wider, begin] = found
        return found

    def besides(self, words: Sequence[str], meaning: Interpretation) -> frozenset[str]:
        """Words that a sentence may have besides those of the grammar, since it is put in a certain way."""
        found = frozenset[str]()
        if meaning.corrected:
            found |= self.correcting
        if meaning.denied:
            found |= self.denying
        if (asks := self.asking.find(words)) is not None:
            language, behind = self.matcher.grammar.language, words[sum(asks) :]
            found |= {*words[asks[0] : sum(asks)]}
            found |= {
                word
                for word in behind
                if not self.words.isdisjoint((*told_forms_of(word, language), *verbs(word, language)))
            }
        return found

    def free_slots(self, words: Sequence[str]) -> list[SlotReading] | None:
        """The slots that take any words, of a sentence with nothing before its first word; None: it is no sentence."""
        readings = self.matcher.read(list(words))
        if not readings or readings[0].problem:
            return None
        return [slot for slot in readings[0].slots if slot.slot.type in FREE_KINDS]

    def joined_slots(self, words: Sequence[str], start: int = 0) -> list[tuple[int, list[SlotReading]]] | None:
        """Where each of several sentences that are joined begins, and its slots that take any words: "wait until the
        bell rings and then go back". None: they are no such sentences."""
        if (whole := self.free_slots(words[start:])) is not None:
            return [(start, whole)]
        for end in range(start + 1, len(words) - 1):
            for length in self.sequence.lengths_at(words, end):
                first = self.free_slots(words[start:end])
                rest = self.joined_slots(words, end + length) if first is not None else None
                if first is not None and rest is not None:
                    return [(start, first), *rest]
        return None

    def telling(self, words: Sequence[str]) -> int:
        """Words that show that the grammar was spoken: neither a free slot's, nor such as people put anywhere."""
        fillers = self.matcher.grammar.fillers
        return sum(not isinstance(word, FreeWord) and (word,) not in fillers for word in words)
