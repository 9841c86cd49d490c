"""A model steered by the grammar: hear freely, then ask which sentence of the grammar the sound fits best.

A free decode gives words, nearly right. If they are a sentence of the grammar nothing more is asked. Else sentences of
the grammar are found in two ways: those that sound most like the words heard are looked up in the automaton and scored
against the sound, in one pass each; and where none of them is sure, the model is led along the automaton
(:mod:`~intent_engine.speech.guided`). What speaks for and against the best is weighed in
:mod:`~intent_engine.speech.evidence`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from rapidfuzz.distance import Levenshtein

from intent_engine.actions import Action
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.approximate import FreeWord, UtteranceSearch
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.utterance import Utterance
from intent_engine.speech.audio import Samples
from intent_engine.speech.evidence import FAR_AHEAD, Evidence, View, letters_apart
from intent_engine.speech.guided import WORD, GuidedSearch, word_count
from intent_engine.speech.recognizer import Encoded, Transcript
from intent_engine.speech.scoring import Scoring
from intent_engine.speech.vocabulary import known_in_slots, known_words, said_in_slots
from intent_engine.speech.writing import written

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.language.matcher import Matcher

__all__ = ["Opinion", "Reading", "Steering", "as_read"]

CANDIDATES = 8
"""Utterances of the grammar, like the words heard, that are scored against the sound."""
SEARCHES = 64
"""Searches whose results are kept."""
DRAFTS = 3
"""Utterances from which the model is led along the automaton."""
FAR = 0.5
"""Share of the letters heard that may differ in an utterance that is looked up."""
FAR_LETTERS = 1.7
"""Letters that may differ in any case: a short word is soon all wrong."""
UNKNOWN_WORD = 8.0
"""nats by which a word that no list has is less likely than those that are."""
CLEAR = 0.6
"""Geometric mean of the probabilities of a word's pieces, from which it was heard clearly."""
NARRATING = frozenset(
    {"when", "why", "how", "what", "where", "who", "which", "if", "unless", "until", "because", "did", "didnt", "was"}
    | {"were", "had", "has", "should", "he", "she", "they", "not", "never", "no", "dont", "cannot", "cant", "wont"}
    | {"without", "except", "neither", "nor", "nobody", "nothing", "nowhere"}
)
"""English words with which a sentence is no command. A command that leaves them out of what was heard was not said."""
DO_NOT = "Do not", "Don't"
NOT_SAID = 5.0
"""nats by which a sentence must be likelier than the same with one of these before it, where a "don't" was heard,
though not clearly. Of 12 that were said without, in kitchen noise, all were ahead by 7 and more."""
MISHEARD = 0.4
"""Share of the letters in which a word of a command differs at most from such a word that was heard in its place."""
RIVALS = {
    short + end: short + other
    for short in ("thir", "four", "fif", "six", "seven", "eigh", "nine")
    for end, other in (("teen", "ty"), ("ty", "teen"))
    if short != "four"
} | {"fourteen": "forty", "forty": "fourteen"}
"""Numbers that even people ask back about."""
RIVAL_MARGIN = 3.0
"""nats by which such a number must be likelier than its like."""
SURE = 0.9
"""Confidence from which no other sentence is looked for,"""
CLOSE_GAP = 0.3
"""unless the free words are likelier by this gap: then there may be one that was not found yet."""
CLEAR_TALK = -0.4
"""Mean log probability of the free words from which they were heard clearly,"""
FARFETCHED = 0.02
"""and confidence of the nearest sentence below which such words are other talk, so that nothing more is looked for: of
347 commands whose words were no sentence, half of them in noise, none was lost that would have been done, and of 60
orders of coffee given to a robot 49 are left at this."""
RETRY_SCORE = -1.0
"""Mean log probability of the free words below which a longer encoder input is tried, if nothing sure was found."""
DOUBTFUL_SCORE = -0.6
"""Mean log probability of the free words below which others are looked at, though they are a sentence already."""


@dataclass(frozen=True, slots=True)
class Reading:
    """A sentence of the grammar that may have been said."""

    words: tuple[str, ...]
    score: float
    """Log probability of the words given the sound."""
    apart: float
    """Letters by which they differ from what was heard freely."""
    evidence: Evidence
    actions: tuple[Action, ...] = ()

    @property
    def unknown(self) -> int:
        """Words that a free slot took as they were heard."""
        return sum(isinstance(word, FreeWord) for word in self.words)


@dataclass(slots=True)
class _Searches:
    """The two ways to find sentences of one grammar, and what the first has found."""

    near: UtteranceSearch
    guided: GuidedSearch
    found: dict[tuple[str, ...], list[tuple[tuple[str, ...], float]]] = field(default_factory=dict)


class Steering(Scoring):
    """What a model that can be asked what it thinks of words becomes with a grammar: a recogniser for one engine."""

    language: str | None
    """Of the speech; None: detected."""
    _engine: IntentEngine
    """Whose grammar steers."""

    def steer(self, engine: IntentEngine) -> None:
        """By the grammar of an engine; it may be reloaded at any time."""
        self._engine = engine
        self._known: tuple[Any, frozenset[str], frozenset[str]] | None = None
        self._searches: dict[str | None, _Searches] = {}
        self.opinion: Opinion | None = None
        """What it made of the sound that it heard last."""

    def _matcher(self, language: str | None) -> Matcher:
        return self._engine.matcher(language if language in self._engine.languages else None)

    def _parse(self, text: str, language: str | None = None) -> Interpretation:
        return self._engine.parse(text, language=language if language in self._engine.languages else None)

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        encoded = self.encode(samples)
        language = self.language or self.detect(encoded)
        best: Opinion | None = None
        for attempt in range(2):
            if attempt:
                encoded = self.encode(samples, self.longer(encoded.seconds))
            free, mean, _ = self.greedy(encoded, language)
            found = self._opinion(encoded, free, mean, language)
            # What was heard at last to be refused is not done, however sure it seemed before.
            if best is None or found.settled or _confidence(found.transcript) > _confidence(best.transcript):
                best = found
            if found.settled or mean > RETRY_SCORE or _confidence(best.transcript) >= SURE:
                break
        assert best is not None
        self.opinion = best
        return best.transcript

    def glance(self, samples: Samples) -> Opinion:
        """What it makes of a sound at first sight: of the sentences that are like the words heard, without the search
        along the grammar, which takes most of the time."""
        encoded = self.encode(samples)
        language = self.language or self.detect(encoded)
        free, mean, _ = self.greedy(encoded, language)
        return self._opinion(encoded, free, mean, language, near_only=True)

    def _opinion(
        self, encoded: Encoded, free: str, mean: float, language: str | None, *, near_only: bool = False
    ) -> Opinion:
        """What the model makes of a sound in which it heard some words."""
        as_heard = Transcript(free, mean, free, language=language)
        meaning = self._parse(free, language)
        if not free or self._refused(encoded, free, meaning, language):
            return Opinion(self, encoded, as_heard, settled=True)
        words = self._words(free, language)
        exact = meaning.status is Status.ACCEPTED and meaning.confidence == 1.0
        if exact and mean > DOUBTFUL_SCORE and not self._unknown(words, meaning, language):
            unclear = self._unclear(encoded, words, language)
            sure = replace(as_heard, gap=0.0, unclear=unclear, confidence=1.0)
            return Opinion(self, encoded, sure, (tuple(words),), settled=True)
        readings = self.readings(encoded, free, language, clear=mean > CLEAR_TALK, near_only=near_only)
        sentences = tuple(one.words for one in readings)
        if not readings or not self._wanted(encoded, free, readings[0], language):
            return Opinion(self, encoded, as_heard, sentences)
        read = as_read(as_heard, readings, self._unclear(encoded, readings[0].words, language))
        return Opinion(self, encoded, read, sentences)

    def _refused(self, encoded: Encoded, free: str, meaning: Interpretation, language: str | None) -> bool:
        """Whether it was heard that something shall not be done. In noise a "don't" is heard where "go" was said, so
        what was not heard clearly may have been a command."""
        negated = meaning.reason.startswith("negated") and not NARRATING.isdisjoint(self._words(free, language))
        return meaning.refuses and not (negated and not self._story(encoded, free, language))

    def _wanted(self, encoded: Encoded, free: str, best: Reading, language: str | None) -> bool:
        """Whether a sentence was rather said than that it shall not be done, where something like that was heard."""
        if not best.actions or not self._parse(free, language).refuses:
            return True
        refusals = [f"{no} {written(best.words, language, sentence=False)}" for no in DO_NOT]
        said, *refused = self.score(encoded, [written(best.words, language), *refusals], language)
        return said - max(refused) >= NOT_SAID

    # -- the sentences of the grammar --------------------------------------------------------------

    def readings(
        self,
        encoded: Encoded,
        free: str,
        language: str | None = None,
        *,
        clear: bool = False,
        near_only: bool = False,
    ) -> list[Reading]:
        """Sentences of the grammar that the sound may be, likeliest first.

        Args:
            encoded: the sound.
            free: what was heard freely.
            language: of the speech.
            clear: whether that was heard clearly, so that what is far from the grammar is no command.
            near_only: whether those are enough that are like the words heard.
        """
        heard = self._words(free, language)
        story = self._story(encoded, free, language)

        def possible(words: Sequence[str]) -> bool:
            added = len(words) > len(heard) and list(words[: len(heard)]) == heard  # nobody said the rest
            return not added and self._possible(words, story, language)

        near = [words for words in self._near(heard, language) if possible(words)]
        found = dict(zip(near, self.score_words(encoded, near, language), strict=True))
        readings = self._ranked(encoded, free, heard, found, language)
        if near_only or (readings and readings[0].evidence.confidence >= SURE and readings[0].evidence.gap < CLOSE_GAP):
            return readings
        if clear and (not readings or readings[0].evidence.confidence < FARFETCHED):
            return readings
        drafts = [written(reading.words, language) for reading in readings[:DRAFTS]]
        guided = self._search(language).guided.likeliest(
            lambda beginnings, length: self.next_pieces(encoded, beginnings, length, language),
            heard,
            free,
            self.score(encoded, [free], language)[0],
            drafts,
        )
        for words, score in guided:
            if words in found or possible(words):
                found[words] = max(score, found.get(words, score))
        return self._ranked(encoded, free, heard, found, language)

    def _ranked(
        self,
        encoded: Encoded,
        free: str,
        heard: list[str],
        scores: dict[tuple[str, ...], float],
        language: str | None,
    ) -> list[Reading]:
        """Sentences with what speaks for and against them, likeliest first."""
        free_score = self.score(encoded, [free], language)[0]
        views = {words: (View(score, free_score, letters_apart(words, heard)),) for words, score in scores.items()}
        return self.ranked(views, language)

    def ranked(self, views: Mapping[tuple[str, ...], Sequence[View]], language: str | None = None) -> list[Reading]:
        """Sentences, with what one or several models think of each, likeliest first, and what speaks for them.

        Several models are taken together as one that thinks what they do in the mean.
        """
        rows = []
        for words, seen in views.items():
            unknown = sum(isinstance(word, FreeWord) for word in words)
            rank = _mean([view.value for view in seen]) - UNKNOWN_WORD * unknown + WORD * word_count(words)
            rows.append((rank, words, seen, unknown, self._parse(" ".join(words), language).actions))
        rows.sort(key=lambda row: (-row[0], row[1]))
        readings = []
        for place, (rank, words, seen, unknown, actions) in enumerate(rows):
            other = next((row[0] for row in rows[place + 1 :] if row[-1] != actions), -math.inf)
            telling = 1 + self._telling(words, language)
            gaps = [max(0.0, view.free_score - view.score) / telling for view in seen]
            score, apart = _mean([view.score for view in seen]), _mean([view.apart for view in seen])
            evidence = Evidence(
                # As the gap is weighed.
                gap=math.expm1(_mean([math.log1p(gap) for gap in gaps])),
                margin=min(FAR_AHEAD, rank - other),
                cost=-score / (1 + len(words)),
                apart=apart / telling,
                unknown=unknown,
                models=len(seen),
                alone=len(words) == 1,
            )
            readings.append(Reading(words, score, apart, evidence, actions))
        return readings

    def _near(self, heard: list[str], language: str | None) -> list[tuple[str, ...]]:
        """Utterances of the grammar like the words heard, the likest first."""
        most = max(FAR_LETTERS, FAR * sum(map(len, heard)))
        return [words for words, apart in self._nearest(tuple(heard), language) if apart <= most]

    def _story(self, encoded: Encoded, free: str, language: str | None) -> list[str]:
        """Words with which a sentence is no command, of those that were heard clearly: in noise anything is heard."""
        words = [NARRATING.intersection(Utterance.of(word, language or "en").words) for word in free.split()]
        if not any(words):
            return []
        heard = self.word_scores(encoded, free, language)
        return [word for said, (_, score) in zip(words, heard, strict=True) if score > math.log(CLEAR) for word in said]

    def _possible(self, words: Sequence[str], story: Sequence[str], language: str | None) -> bool:
        """Whether an utterance may be meant: what would not be accepted was not said, except that something shall not
        be done; nobody says hardly anything but "oh", "now" and "so", except to stop ("halt" is such a word in German);
        and who tells a story gives no command."""
        if any(not _stands_for(word, words) for word in story):
            return False
        meaning = self._parse(" ".join(words), language)
        known = meaning.status in (Status.ACCEPTED, Status.AMBIGUOUS) or meaning.refuses
        return known and (meaning.stops or not self._mostly_noise(words, language))

    def _words(self, draft: str, language: str | None) -> list[str]:
        words = Utterance.of(draft, language or "en").words
        return in_words(words) if language in (None, "en") else words

    def _nearest(self, heard: tuple[str, ...], language: str | None) -> list[tuple[tuple[str, ...], float]]:
        """The utterances like some words; those of one utterance are asked for again and again."""
        searches = self._search(language)
        if len(searches.found) > SEARCHES:
            searches.found.clear()
        found = searches.found.get(heard)
        if found is None:
            found = searches.found[heard] = searches.near.nearest(heard, CANDIDATES, NARRATING)
        return found

    def _search(self, language: str | None) -> _Searches:
        """The searches in the grammar of a language; what they learn of it is kept until it is reloaded."""
        graph = self._matcher(language).likely
        searches = self._searches.get(language)
        if searches is None or searches.near.graph is not graph:
            near = UtteranceSearch(graph)
            searches = self._searches[language] = _Searches(
                near, GuidedSearch(near, self.tokenizer(language), language, self.end_piece(language))
            )
        return searches

    def _telling(self, words: Sequence[str], language: str | None) -> int:
        """Words that show that the grammar was spoken: neither a free slot's, nor such as people put anywhere."""
        matcher = self._matcher(language)
        return sum(not isinstance(word, FreeWord) and (word,) not in matcher.grammar.fillers for word in words)

    def _mostly_noise(self, words: Sequence[str], language: str | None) -> bool:
        """Whether most of an utterance is "oh", "now" and "so": made up of sounds, around a word that fits anywhere."""
        heard_anywhere = sum(not isinstance(word, FreeWord) for word in words)
        return 2 * self._telling(words, language) < heard_anywhere

    # -- what was not heard clearly ----------------------------------------------------------------

    def _unknown(self, words: Sequence[str], meaning: Interpretation, language: str | None) -> bool:
        """Whether an exact sentence has words in free slots that no list has."""
        matcher = self._matcher(language)
        if self._known is None or self._known[0] is not matcher:
            self._known = (matcher, known_words(matcher), known_in_slots(matcher))
        _, known, in_slots = self._known
        if known.issuperset(word for word in words if not is_numeral(word)) and in_slots.issuperset(
            said_in_slots(meaning.slots)
        ):
            return False
        heard = tuple(words)
        as_heard = next((said for said, _ in self._nearest(heard, language) if said == heard), ())
        return not as_heard or any(isinstance(word, FreeWord) for word in as_heard)

    def _unclear(self, encoded: Encoded, words: Sequence[str], language: str | None) -> tuple[str, ...]:
        """Words of an utterance on which its meaning hangs, and that the sound does not tell from others."""
        return tuple(word for word, clear in self.clearness(encoded, words, language).items() if clear < 0)

    def clearness(self, encoded: Encoded, words: Sequence[str], language: str | None = None) -> dict[str, float]:
        """The words of an utterance on which its meaning hangs, each with the nats by which it was heard more clearly
        than it must be: words of free slots that no list has, or else numbers that sound like others. Where the grammar
        has only one of two such numbers ("sixteen ounce") there is nothing to tell."""
        if any(isinstance(word, FreeWord) for word in words):
            heard = self.word_scores(encoded, " ".join(words), language)
            return {
                text: score - math.log(CLEAR)
                for word, (text, score) in zip(words, heard, strict=True)
                if isinstance(word, FreeWord)
            }
        if language not in (None, "en"):
            return {}
        rivals = {
            word: other
            for at, word in enumerate(words)
            if word in RIVALS and self._possible(other := (*words[:at], RIVALS[word], *words[at + 1 :]), (), language)
        }
        if not rivals:
            return {}
        said, *others = self.score_words(encoded, [words, *rivals.values()], language)
        return {word: said - other - RIVAL_MARGIN for word, other in zip(rivals, others, strict=True)}


@dataclass(frozen=True, slots=True)
class Opinion:
    """What one model makes of one stretch of sound."""

    model: Steering
    encoded: Encoded
    transcript: Transcript
    sentences: tuple[tuple[str, ...], ...] = ()
    """Of the grammar, that it may have been."""
    settled: bool = False
    """Whether no sentences were looked for: nothing, a refusal, or a sentence of the grammar was heard."""

    def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
        """What the model thinks of sentences, its own or others'."""
        model, language = self.model, self.transcript.language
        free = self.transcript.free_text
        heard = model._words(free, language)
        (free_score,) = model.score(self.encoded, [free], language)
        scores = model.score_words(self.encoded, sentences, language)
        return [
            View(score, free_score, letters_apart(words, heard)) for words, score in zip(sentences, scores, strict=True)
        ]

    def clearness(self, words: Sequence[str]) -> dict[str, float]:
        """As :meth:`Steering.clearness`."""
        return self.model.clearness(self.encoded, words, self.transcript.language)


def as_read(heard: Transcript, readings: Sequence[Reading], unclear: tuple[str, ...]) -> Transcript:
    """What was heard freely, taken for the likeliest of some sentences, of whose words some were not clear."""
    best, *others = readings
    return replace(
        heard,
        text=" ".join(best.words),
        gap=best.evidence.gap,
        alternatives=tuple(" ".join(one.words) for one in others[:3]),
        unclear=unclear,
        confidence=best.evidence.confidence,
    )


def _confidence(transcript: Transcript) -> float:
    return transcript.confidence or 0.0


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)


def _stands_for(heard: str, words: Sequence[str]) -> bool:
    """Whether a word that was heard is one of these, or may have been: "had" for "head"."""
    return any(Levenshtein.normalized_distance(heard, word) <= MISHEARD for word in words)
