"""What a grammar says of words that may have been spoken, before any sound is asked: which sentences are like them, and
which may be meant at all.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from statistics import fmean
from typing import TYPE_CHECKING

from intent_engine.grammar_states import meant_in_some_state
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.networks.approximate import FREE, FreeWord, UtteranceSearch
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.ordinals_spelled import ordinals_in_words
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.utterance import without_enumeration
from intent_engine.language.wording import Wording
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.speech.hypotheses.corrections import as_meant, corrected_like, no_between
from intent_engine.speech.hypotheses.dictating import DICTATED, begin_of
from intent_engine.speech.hypotheses.known_grammar import KnownGrammar
from intent_engine.speech.hypotheses.narration import NARRATING, leaves_out
from intent_engine.speech.hypotheses.opposing import opposing
from intent_engine.speech.hypotheses.usual import circles
from intent_engine.speech.hypotheses.vocabulary import said_in_slots, said_of_signs
from intent_engine.speech.hypotheses.wake_words import WakeWords
from intent_engine.speech.thresholds import SURE_ENOUGH

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["SpokenGrammar"]

BEGINNING = 3
"""Words from which it is known which command was begun."""
OPENINGS = 4
"""Beginnings of commands in which something is dictated, that are looked up,"""
LONGEST_OPENING = 5
"""in so many of the first words heard."""
FAR = 0.5
"""Share of the letters heard that may differ in an utterance that is looked up."""
FAR_LETTERS = 1.7
"""Letters that may differ in any case: a short word is soon all wrong."""
UNUSUAL = 2.0
"""nats by which a number that is no multiple of its slot's ``usual_step`` is less likely for each model, one beyond its
``usual_max``, and a turn of more than a circle. Of 447 angles that people told a robot one was no multiple
(docs/decisions/speech-numbers.md)."""
BEYOND_LIMITS = 5.0
"""The same of a number that its slot does not take, where no model heard it word by word. Where one did, it is only
unusual."""


class SpokenGrammar:
    """The grammars of one engine, which may be reloaded at any time. For one thread at a time.

    Args:
        engine: whose grammars. Languages that it has no grammar for are taken for its first.
    """

    def __init__(self, engine: IntentEngine) -> None:
        self._engine = engine
        self._kept: dict[str | None, KnownGrammar] = {}

    @property
    def languages(self) -> tuple[str, ...]:
        """Of the grammars."""
        return self._engine.languages

    def parse(self, text: str, language: str | None = None) -> Interpretation:
        """What a text means, to a robot in whichever state it may be."""
        return self._known(language).meaning(text, lambda: meant_in_some_state(self._engine, text, self._own(language)))

    def fits_pattern(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether words are, as they are, a command of an intent that has patterns: of some it cannot be told what else
        they have."""
        meaning = self.parse(" ".join(words), language)
        intent = self._known(language).matcher.grammar.intents.get(meaning.intent or "")
        exact = meaning.status is Status.ACCEPTED and meaning.confidence == 1.0
        return exact and intent is not None and bool(intent.regex or intent.lark)

    def dictated(self, text: str, language: str | None = None) -> tuple[str, ...]:
        """The words before a dictated text; none where nothing is dictated."""
        found = self._engine.dictated(text, language=self._own(language))
        return found.begin if found is not None else ()

    def openings(self, heard: Sequence[str], language: str | None = None) -> list[tuple[str, ...]]:
        """Commands in which the text that follows is dictated, like the first words heard, the likest first."""
        if not self._known(language).matcher.grammar.dictates:
            return []
        found: dict[tuple[str, ...], float] = {}
        for count in range(1, min(LONGEST_OPENING, len(heard) - 1) + 1):
            most = max(FAR_LETTERS, FAR * sum(map(len, heard[:count])))
            for words, apart in self._known(language).nearest((*heard[:count], DICTATED)):
                apart -= FREE
                begin = begin_of(words)
                if begin and apart <= most and self.dictated(" ".join(words), language) == begin:
                    found[words] = min(apart, found.get(words, apart))
        return sorted(found, key=lambda words: found[words])[:OPENINGS]

    def words(self, text: str, language: str | None = None) -> list[str]:
        """The words of a text that was heard, together or apart as the grammar writes them, numbers as words."""
        matcher, text = self._engine.matcher(self._own(language)), without_enumeration(text)
        said = matcher.heard(text, language or "en")
        words = (matcher.spacing.otherwise(said) or said).words
        return ordinals_in_words(in_words(said_of_signs(words, language), language))

    def as_written(self, language: str | None = None) -> Mapping[str, str]:
        """Words that the grammar or the map writes with a capital or an apostrophe, by the same small and plain."""
        return self._known(language).as_written

    def search(self, language: str | None = None) -> UtteranceSearch:
        """The search for sentences that are like some words; another one when the grammar was reloaded."""
        return self._known(language).search

    def look_ahead(self, language: str | None = None) -> None:
        """As :meth:`~intent_engine.language.matcher.Matcher.look_ahead`."""
        self._engine.matcher(self._own(language)).look_ahead()

    def near(self, heard: Sequence[str], language: str | None = None) -> list[tuple[str, ...]]:
        """Sentences like the words heard, the likest first; then those that take something back, and those that would
        be one if their first words were a wake word."""
        return [
            *self.like(tuple(heard), language, wider=True),
            *self._corrected(heard, language),
            *self.woken(heard, language),
        ]

    def has(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether words are a sentence of the grammar just as it has it."""
        state = self._known(language).matcher.spoken.walk(words)[1]
        return state is not None and bool(state.accepts)

    def in_own_words(self, words: Sequence[str], language: str | None = None) -> tuple[str, ...]:
        """As :meth:`~intent_engine.engine.IntentEngine.in_own_words`."""
        return self._engine.in_own_words(" ".join(words), language=self._own(language))

    def without_small_words(self, words: Sequence[str], language: str | None = None) -> tuple[str, ...]:
        """Words without those that point and the small ones that the grammar has nowhere."""
        known, points = self._known(language), self.wording(language).points
        return tuple(word for word in words if word not in (points if word in known.own else known.small))

    def small_words(self, language: str | None = None) -> frozenset[str]:
        """Words that people put anywhere: "that", "by", "over"."""
        return self._known(language).small

    def letters(self, language: str | None = None) -> frozenset[str]:
        """As :attr:`KnownGrammar.letters`."""
        return self._known(language).letters

    def like(
        self,
        heard: tuple[str, ...],
        language: str | None = None,
        *,
        wider: bool = False,
        begin: tuple[str, ...] = (),
    ) -> list[tuple[str, ...]]:
        """Sentences like some words, the likest first; with a beginning, of those that begin so like what follows."""
        most = max(FAR_LETTERS, FAR * sum(map(len, (*begin, *heard))))
        found = self._known(language).nearest(heard, wider=wider, begin=begin)
        return [words for words, apart in found if apart <= most]

    def _corrected(self, heard: Sequence[str], language: str | None) -> list[tuple[str, ...]]:
        corrections = self.corrections(language)
        meant = as_meant(heard, corrections, self._known(language).matcher.grammar.sound_alikes)
        if corrections.find(meant, 1) is None:
            meant = no_between(meant, corrections, language)
        like = corrected_like(meant, corrections, lambda words, begin: self.like(words, language, begin=begin))
        return [words for words in like if self.parse(" ".join(words), language).corrected]

    def possible(
        self, words: Sequence[str], story: Iterable[str] = (), language: str | None = None, *, heard: Sequence[str] = ()
    ) -> bool:
        """Whether a sentence may be meant: what would not be accepted was not said, except that something shall not be
        done, and numbers beyond their limits ("gate seventy" is not to be "gate seven"); nobody says hardly anything
        but "oh", "now" and "so", except to stop ("halt" is such a word in German); and who tells a story gives no
        command.

        Args:
            words: of the sentence.
            story, heard: as for :func:`~intent_engine.speech.hypotheses.narration.leaves_out`.
            language: of the speech.
        """
        if leaves_out(words, story, [heard]):
            return False
        meaning = self.parse(" ".join(words), language)
        # Whether "duck" could be the dock is for the sound to say; which of two rooms is meant, for the person.
        asks = meaning.status is Status.AMBIGUOUS and len(meaning.alternatives) > 1
        known = meaning.status is Status.ACCEPTED or asks or meaning.refuses or meaning.beyond_limits
        return known and (meaning.stops or not self._mostly_noise(words, language))

    def opposing(
        self, words: Sequence[str], heard: Sequence[Sequence[str]], language: str | None = None
    ) -> list[tuple[str, ...]]:
        """As :func:`~intent_engine.speech.hypotheses.opposing.opposing`."""
        found = opposing(self.search(language), lambda text: self.parse(text, language), words, heard, language)
        return [sentence for sentence in found if self.possible(sentence, (), language)]

    def corrections(self, language: str | None = None) -> PhraseSet:
        """Phrases that take back what was said before them."""
        return self._known(language).corrections

    def taking_back(
        self, sentences: Sequence[tuple[str, ...]], heard: Sequence[Sequence[str]], language: str | None = None
    ) -> list[tuple[str, ...]]:
        """Those sentences that take something back, where each of several models heard that ("to the lounge, know the
        duck"), and one of them in its own words: what does all of it is not what was meant, however much likelier. All,
        if none does.

        Args:
            sentences: that may have been said.
            heard: the words that each model heard.
            language: of the speech.
        """
        corrections = self.corrections(language)
        alikes = self._known(language).matcher.grammar.sound_alikes
        taken_back = all(corrections.find(as_meant(one, corrections, alikes), 1) for one in heard)
        # Of a "cappuccino" both may hear "as you know".
        if len(heard) < 2 or not (taken_back and any(corrections.find(one, 1) for one in heard)):
            return list(sentences)
        return [words for words in sentences if corrections.find(words, 1)] or list(sentences)

    def narrating(self, language: str | None = None) -> frozenset[str]:
        """Words with which a sentence is no command, wherever they stand: "when", "not"."""
        return self._known(language).narrating

    def negated(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether any of some words make a sentence that is not done, or no command: "never"."""
        if language in (None, "en") and not NARRATING.isdisjoint(words):
            return True
        return any(self._known(language).negations.at(words, place) for place in range(len(words)))

    def wording(self, language: str | None = None) -> Wording:
        """How its language puts things."""
        return self._known(language).matcher.grammar.wording

    def means_else(self, words: Sequence[str], meaning: Interpretation, language: str | None = None) -> bool:
        """Whether a sentence asks for something else."""
        return self.parse(" ".join(words), language).actions != meaning.actions

    def wake(self, language: str | None = None) -> WakeWords:
        """Its wake words."""
        return self._known(language).wake

    def woken(self, words: Sequence[str], language: str | None = None) -> list[tuple[str, ...]]:
        """A command without a wake word as it would be with one: see :meth:`WakeWords.before`."""
        return list(self.wake(language).before(words, lambda rest: self.parse(" ".join(rest), language).actions))

    def acted_on(self, confidence: float, language: str | None = None) -> bool:
        """Whether a sentence that is so sure may be acted on. (A stop is, from less, and however unclear.)"""
        return confidence >= self._known(language).least

    def forgiving(self, language: str | None = None) -> bool:
        """Whether something of it is acted on from less than is usual: to be wrong costs less than to be asked."""
        return self._known(language).least < SURE_ENOUGH

    def lead(self, words: Sequence[str], language: str | None = None) -> int:
        """How many words at the beginning of a sentence say nothing: "and then please"."""
        leading = self._known(language).leading
        count = 0
        while count < len(words) - 1:
            length = leading.at(words, count)
            if not length:
                break
            count += length
        return count if count < len(words) else 0

    def begins(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether a sentence begins with the first of some words: no free ones, and no article or number at first."""
        matcher, first = self._known(language).matcher, words[:BEGINNING]
        states = [matcher.strict.walk(first[:place])[1] for place in range(len(first))]
        own = [state and word in matcher.strict.next_words(state) for word, state in zip(first, states, strict=True)]
        return bool(first) and all(own) and first[0] not in ARTICLES and not matcher.is_number(first[0])

    def joins(self, word: str, language: str | None = None) -> bool:
        """Whether a word alone joins commands: "and"."""
        return self._known(language).sequence.at([word], 0) == 1

    def says_nothing(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether words change nothing, wherever they stand: "please"."""
        return self._known(language).leading.cover(words)

    def settled(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether no more of a sentence may follow than the manner of it."""
        return self._known(language).matcher.settled(words)

    def put_otherwise(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether a sentence is one that its grammar has in another way: "turn the lamp on", "open the door and the
        window"."""
        matcher = self._known(language).matcher
        there = (one.walk(words)[1] for one in (matcher.begun, matcher.spoken))
        whole = [state is not None and bool(state.accepts) for state in there]
        return whole == [True, False]

    def plain(self, words: Sequence[str], meaning: Interpretation, language: str | None = None) -> bool:
        """Whether an exact sentence is what people say: without words in free slots that no list has, and without a
        turn of more than a circle ("five fourteen degrees" was "by fourteen"), or more than a whole of what has no
        limit. Else it may be another that was heard a little wrong; so it may with words that are
        :meth:`empty_inside`."""
        much = circles(meaning) or self._known(language).usual.more_than_whole(meaning)
        return not (much or self.unknown(words, meaning, language))

    def empty_inside(self, words: Sequence[str], language: str | None = None) -> list[str]:
        """The words that say nothing and stand between others of a sentence: "turn like by sixteen degrees"."""
        nothing = self._known(language).empty
        inside = range(self.lead(words, language) + 1, len(words))
        phrases = [(at, nothing.at(words, at)) for at in inside]
        return [
            word
            for at, length in phrases
            if length and not self.says_nothing(words[at:], language)
            for word in words[at : at + length]
        ]

    def unknown(self, words: Sequence[str], meaning: Interpretation, language: str | None = None) -> bool:
        """Whether an exact sentence has words in free slots that no list has."""
        there = self._known(language).words | self._known(language).besides(words, meaning)
        is_number = self._known(language).matcher.is_number
        known = there.issuperset(word for word in words if not is_number(word))
        if known and not self.unlisted(meaning, language):
            return False
        heard = tuple(words)
        as_heard = next((said for said, _ in self._known(language).nearest(heard) if said == heard), ())
        return not as_heard or any(isinstance(word, FreeWord) for word in as_heard)

    def takes_as_heard(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether words are a sentence, or several that are joined, with a slot that has no list, which holds all words
        that the grammar does not have: whoever may be called can be called anything."""
        matcher, known = self._known(language).matcher, self._known(language).words
        said = list(words[self.lead(words, language) :])
        joined = self._known(language).joined_slots(said) or []
        if len(joined) > 1 and not self.parse(" ".join(said), language).actions:
            return False
        taken = {
            start + place
            for start, slots in joined
            for slot in slots
            if not slot.slot.known
            for place in range(slot.start, slot.end)
        }
        strange = {place for place, word in enumerate(said) if word not in known and not matcher.is_number(word)}
        return bool(taken) and strange <= taken

    def holds_any_words(self, words: Sequence[str], language: str | None = None) -> bool:
        """Whether words are a sentence with a slot that could hold any others as well, with a list or without; or are
        none that is known."""
        said = words[self.lead(words, language) :]
        return self._known(language).free_slots(said) != []

    def share_known(self, words: Sequence[str], language: str | None = None) -> float:
        """Share of some words that the grammar has, anywhere; 1 of none."""
        known = self._known(language).words
        return fmean([float(word in known or is_numeral(word)) for word in words] or [1.0])

    def unlisted(self, meaning: Interpretation, language: str | None = None) -> list[str]:
        """The words in the slots of a sentence that no list has there: "yellow to the box" is no list's thing."""
        if self.dictated(meaning.text, language):
            return []
        known = self.in_slots(language)
        unlisted = (word for word in said_in_slots(meaning.slots) if word not in known)
        return [word for one in unlisted for word in self.words(one, language) if word not in known]

    def telling(self, words: Sequence[str], language: str | None = None) -> int:
        """How many of some words show that the grammar was spoken: neither a free slot's, nor such as people put
        anywhere."""
        return self._known(language).telling(words)

    def in_slots(self, language: str | None = None) -> frozenset[str]:
        """The words of the lists of its slots."""
        return self._known(language).in_slots

    def unusual(self, meaning: Interpretation, language: str | None = None, *, heard: bool = True) -> float:
        """nats by which a sentence is less likely for its numbers, before it was heard.

        Args:
            meaning: of the sentence.
            language: of the speech.
            heard: whether any model heard it word by word.
        """
        unusual = self._known(language).usual.unusual(meaning) + circles(meaning)
        return UNUSUAL * unusual + (UNUSUAL if heard else BEYOND_LIMITS) * meaning.beyond_limits

    def _own(self, language: str | None) -> str | None:
        return language if language in self._engine.languages else None

    def _known(self, language: str | None) -> KnownGrammar:
        matcher = self._engine.matcher(self._own(language))
        known = self._kept.get(language)
        if known is None or known.matcher is not matcher:
            known = self._kept[language] = KnownGrammar.of(matcher)
        return known

    def _mostly_noise(self, words: Sequence[str], language: str | None) -> bool:
        """Whether most of an utterance is "oh", "now" and "so": made up of sounds, around a word that fits anywhere."""
        heard_anywhere = sum(not isinstance(word, FreeWord) for word in words)
        return 2 * self.telling(words, language) < heard_anywhere
