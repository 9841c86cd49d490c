"""Whisper steered by the grammar: hear freely, then ask which sentence of the grammar the sound fits best.

A free decode gives words, nearly right. If they are a sentence of the grammar nothing more is asked. Else the
utterances of the grammar that sound most like them are looked up in the automaton, and the model scores all of them
against the sound in one pass each: teacher forcing, ten times cheaper than writing them piece by piece. The gap
between the free words and the best utterance says whether a command was said at all.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from rapidfuzz.distance import Levenshtein

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.approximate import FreeWord, UtteranceSearch
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import in_digits, in_words
from intent_engine.language.utterance import Utterance
from intent_engine.speech.audio import Samples
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.vocabulary import known_words, vocabulary
from intent_engine.speech.whisper import RETRY_SECONDS, Encoded, WhisperRecognizer

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.language.automaton import Automaton
    from intent_engine.language.matcher import Matcher

__all__ = ["SteeredWhisper"]

CANDIDATES = 12
"""Utterances of the grammar that are scored against the sound."""
SCORED = 16
"""The most of them, from all drafts."""
SEARCHES = 64
"""Searches whose results are kept."""
FAR = 0.5
"""Share of the letters heard, without any hint, that may differ; beyond it something else was said."""
FAR_HINTED = 0.65
"""The same for a sentence that was heard with the grammar's vocabulary as a hint: it must still be like the free words,
or a hint would turn silence into a command."""
FAR_LETTERS = 1.7
"""Letters that may differ in any case: a short word is soon all wrong."""
LETTER = 0.35
"""nats that a letter of difference from the free words weighs beside the model's own score: the free words were heard
too, and an utterance that leaves half of them out is cheap in pieces but wrong."""
UNKNOWN_WORD = 4.0
"""nats by which a word that no list has is less likely than those that are."""
CLEAR = 0.6
"""Geometric mean of the probabilities of an unknown word's pieces, from which it is taken."""
NARRATING = frozenset(
    {"when", "why", "how", "what", "where", "who", "which", "if", "unless", "until", "because", "did", "didnt", "was"}
    | {"were", "had", "has", "should", "he", "she", "they", "not", "never", "no", "dont", "cannot", "cant", "wont"}
)
"""English words with which a sentence is no command. A command that leaves them out of what was heard was not said."""
RIVALS = {
    short + end: short + other
    for short in ("thir", "four", "fif", "six", "seven", "eigh", "nine")
    for end, other in (("teen", "ty"), ("ty", "teen"))
    if short != "four"
} | {"fourteen": "forty", "forty": "fourteen"}
"""Numbers that even people ask back about."""
RIVAL_MARGIN = 3.0
"""nats by which such a number must be likelier than its like."""
GLANCE = 3
"""Utterances that are scored first, to see whether it is worth to look further."""
HOPELESS_GAP = 4.0
"""Gap of the best of them beyond which it is not. Of commands that were found it was at most 2.6 in noise, of other
speech that had come so far it was above 4 in three of four cases."""
RETRY_MARGIN = 2.0
"""s of silence after the speech in a longer encoder input."""
SCORED_MARGIN = 0.5
"""s of silence after the speech that texts are scored against."""
ENCODED_PER_SECOND = 50
"""Vectors of Whisper's encoder."""
RETRY_GAP = 0.5
"""Gap beyond which a longer encoder input is tried."""
RUNAWAY = 1.5
"""Words of a hinted draft for each word heard without the hint, beyond which it has gone round in a loop: scoring what
is like it would take seconds."""
DOUBTFUL_SCORE = -0.6
"""Mean log probability of the free words below which others are looked at, though they are a sentence already."""
POOR_SCORE = -0.7
"""Mean log probability of the free words below which they are tried again though no command is near them."""


@dataclass(frozen=True, slots=True)
class _Candidate:
    words: tuple[str, ...]
    letters: float
    """Difference from the free words."""
    score: float
    """Log probability of the sound's being these words."""
    text: str
    """As the model was asked."""

    @property
    def rank(self) -> float:
        return self.score - LETTER * self.letters - UNKNOWN_WORD * self.unknown

    @property
    def unknown(self) -> int:
        return sum(isinstance(word, FreeWord) for word in self.words)


class SteeredWhisper(WhisperRecognizer):
    """A recogniser for one engine's grammar.

    Args:
        engine: whose grammar steers; it may be reloaded at any time.
        model, device, compute_type, threads: as for :class:`WhisperRecognizer`.
        language: None: the language of the engine's only grammar, or detected where it has several.
    """

    def __init__(
        self,
        engine: IntentEngine,
        model: str = "tiny.en",
        *,
        device: str = "auto",
        compute_type: str | None = None,
        language: str | None = None,
        threads: int = 0,
    ) -> None:
        if language is None and len(engine.languages) == 1:
            language = engine.languages[0]
        super().__init__(model, device=device, compute_type=compute_type, language=language, threads=threads)
        self._engine = engine
        self._hinted: tuple[Any, str] | None = None
        self._known: tuple[Any, frozenset[str]] | None = None
        self._scored: tuple[Any, dict[str, float]] = (None, {})
        self._search: UtteranceSearch | None = None
        self._searched: dict[tuple[str, ...], list[tuple[tuple[str, ...], float]]] = {}

    def _hint(self, language: str | None) -> str:
        """The grammar's vocabulary, for a second draft."""
        matcher = self._matcher(language)
        if self._hinted is None or self._hinted[0] is not matcher:
            self._hinted = (matcher, vocabulary(matcher))
        return self._hinted[1]

    def _matcher(self, language: str | None) -> Matcher:
        return self._engine.matcher(language if language in self._engine.languages else None)

    def _parse(self, text: str, language: str | None = None) -> Interpretation:
        return self._engine.parse(text, language=language if language in self._engine.languages else None)

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        encoded = self.encode(samples)
        language = self.language or self.detect(encoded)
        found: Transcript | None = None
        best_rank = -math.inf
        drafts: list[str] = []
        hints: list[str] = []
        for attempt in range(2):
            if attempt:
                encoded = self.encode(samples, max(RETRY_SECONDS, encoded.seconds + RETRY_MARGIN))
            free, mean, _ = self.greedy(encoded, language)
            meaning = self._parse(free, language)
            if not free or _is_refusal(meaning):
                return Transcript(free, mean, free, None, language=language)
            exact = meaning.status is Status.ACCEPTED and meaning.confidence == 1.0
            words = self._words(free, language)
            if exact and mean > DOUBTFUL_SCORE and not self._unknown(words, language):
                unclear = self._rivalled(encoded, words, language)
                return Transcript(free, mean, free, 0.0, unclear=unclear, language=language)
            drafts.append(free)
            near = self._near([free], language)
            if not near or self._hopeless(encoded, free, near, language):
                found = found or Transcript(free, mean, free, None, language=language)
                if mean > POOR_SCORE:
                    break
                continue
            ranked = self._ranked(encoded, drafts, hints, language)
            gap = self._gap(encoded, drafts, ranked, language)
            if gap >= RETRY_GAP and not exact:
                hints += self._second_draft(encoded, free, language)
                ranked = self._ranked(encoded, drafts, hints, language)
                gap = self._gap(encoded, drafts, ranked, language)
            if not ranked:
                found = found or Transcript(free, mean, free, None, language=language)
                continue
            best = ranked[0]
            if best.rank > best_rank:
                others = tuple(" ".join(one.words) for one in ranked[1:4])
                unclear = self._unclear(encoded, best, language)
                found = Transcript(" ".join(best.words), mean, free, gap, others, unclear, language)
                best_rank = best.rank
            if gap < RETRY_GAP:
                break
        assert found is not None
        return found

    # -- the sentences of the grammar --------------------------------------------------------------

    def _near(self, drafts: list[str], language: str | None) -> dict[tuple[str, ...], float]:
        """Utterances of the grammar like any of the drafts, with the letters by which they differ."""
        graph = self._matcher(language).likely
        differ: dict[tuple[str, ...], float] = {}
        for draft in dict.fromkeys(drafts):
            heard = self._words(draft, language)
            most = max(FAR_LETTERS, FAR * sum(map(len, heard)))
            for words, apart in self._nearest(graph, tuple(heard)):
                if apart <= most and apart < differ.get(words, math.inf):
                    differ[words] = apart
        return differ

    def _words(self, draft: str, language: str | None) -> list[str]:
        words = Utterance.of(draft, language or "en").words
        return in_words(words) if language in (None, "en") else words

    def _nearest(self, graph: Automaton, heard: tuple[str, ...]) -> list[tuple[tuple[str, ...], float]]:
        """The utterances like some words; the drafts of one utterance are asked for again and again."""
        if self._search is None or self._search.graph is not graph:
            self._search, self._searched = UtteranceSearch(graph), {}
        if len(self._searched) > SEARCHES:
            self._searched.clear()
        found = self._searched.get(heard)
        if found is None:
            found = self._searched[heard] = self._search.nearest(heard, CANDIDATES, NARRATING)
        return found

    def _telling(self, words: Sequence[str], language: str | None) -> int:
        """Words that show that the grammar was spoken: neither a free slot's, nor such as people put anywhere."""
        matcher = self._matcher(language)
        return sum(not isinstance(word, FreeWord) and (word,) not in matcher.grammar.fillers for word in words)

    def _mostly_noise(self, words: Sequence[str], language: str | None) -> bool:
        """Whether most of an utterance is "oh", "now" and "so": made up of sounds, around a word that fits anywhere."""
        heard_anywhere = sum(not isinstance(word, FreeWord) for word in words)
        return 2 * self._telling(words, language) < heard_anywhere

    def _second_draft(self, encoded: Encoded, free: str, language: str | None) -> list[str]:
        """What is heard with the grammar's vocabulary as a hint, if that is of use."""
        hinted, _, _ = self.greedy(encoded, language, hint=self._hint(language))
        runaway = len(hinted.split()) > RUNAWAY * len(free.split()) + 2
        if not hinted or hinted == free or runaway or _is_refusal(self._parse(hinted, language)):
            return []
        return [hinted]

    # -- what was not heard clearly ----------------------------------------------------------------

    def _unknown(self, words: Sequence[str], language: str | None) -> bool:
        """Whether an exact sentence has words in free slots that no list has."""
        matcher = self._matcher(language)
        if self._known is None or self._known[0] is not matcher:
            self._known = (matcher, known_words(matcher))
        if self._known[1].issuperset(word for word in words if not is_numeral(word)):
            return False
        heard = tuple(words)
        as_heard = next((said for said, _ in self._nearest(matcher.likely, heard) if said == heard), ())
        return not as_heard or any(isinstance(word, FreeWord) for word in as_heard)

    def _unclear(self, encoded: Encoded, best: _Candidate, language: str | None) -> tuple[str, ...]:
        """Words of an utterance on which its meaning hangs, and that the sound does not tell from others."""
        if not best.unknown:
            return self._rivalled(encoded, best.words, language)
        tokenizer = self.tokenizer(language)
        (tokens,) = self._token_scores(encoded, [" ".join(best.words)], language)
        unclear = []
        at = 0
        for word in best.words:
            count = len(tokenizer.encode(" " + word))
            if isinstance(word, FreeWord) and float(np.mean(tokens[at : at + count])) < math.log(CLEAR):
                unclear.append(str(word))
            at += count
        return tuple(unclear)

    def _rivalled(self, encoded: Encoded, words: Sequence[str], language: str | None) -> tuple[str, ...]:
        """Numbers that sound like others, where the sound does not decide for them: "fifteen" and "fifty". Where the
        grammar has only one of them ("sixteen ounce") there is nothing to decide."""
        if language not in (None, "en"):
            return ()
        rivals = {
            word: other
            for at, word in enumerate(words)
            if word in RIVALS
            and self._possible(" ".join(other := [*words[:at], RIVALS[word], *words[at + 1 :]]), language)
        }
        if not rivals:
            return ()
        said, *others = (self._best_score(encoded, one, language) for one in (words, *rivals.values()))
        return tuple(word for word, other in zip(rivals, others, strict=True) if said - other < RIVAL_MARGIN)

    def _best_score(self, encoded: Encoded, words: Sequence[str], language: str | None) -> float:
        """Log probability of words, written in words or in digits."""
        spellings = dict.fromkeys((" ".join(words), " ".join(in_digits(words))))
        return max(self.score(encoded, [text[:1].upper() + text[1:] for text in spellings], language))

    def _hopeless(self, encoded: Encoded, free: str, near: dict[tuple[str, ...], float], language: str | None) -> bool:
        """Whether the sentences nearest by their letters are so unlike the sound that no hint will help."""
        nearest = sorted(near, key=lambda words: (near[words], words))[:GLANCE]
        spelled = [" ".join(words).capitalize() for words in nearest]
        heard, *scores = self.score(encoded, [free, *spelled], language)
        return all(
            heard - score > HOPELESS_GAP * (1 + self._telling(words, language))
            for words, score in zip(nearest, scores, strict=True)
        )

    def _ranked(self, encoded: Encoded, drafts: list[str], hints: list[str], language: str | None) -> list[_Candidate]:
        """Utterances of the grammar that the sound may be, likeliest first."""
        found = self._near(drafts, language)
        free = ["".join(self._words(draft, language)) for draft in drafts]
        for words, apart in self._near(hints, language).items():
            said = "".join(words)
            if min(Levenshtein.normalized_distance(said, heard) for heard in free) <= FAR_HINTED:
                found[words] = min(apart, found.get(words, math.inf))
        # What would not be accepted was not said, except that something shall not be done.
        near = [
            row
            for row in sorted(found.items(), key=lambda row: (row[1], row[0]))
            if self._possible(" ".join(row[0]), language) and not self._mostly_noise(row[0], language)
        ][:SCORED]
        if not near:
            return []
        texts: list[str] = []
        owners: list[int] = []
        # The model writes numbers in digits or in words, and is asked for them as it does.
        figures = any(letter.isdigit() for draft in (*drafts, *hints) for letter in draft)
        for index, (words, _) in enumerate(near):
            digits = in_digits(words) if language in (None, "en") else words
            for text in dict.fromkeys([" ".join(digits)] if figures else [" ".join(words), " ".join(digits)]):
                texts.append(text[:1].upper() + text[1:])
                owners.append(index)
        scores = [(-math.inf, "")] * len(near)
        for owner, text, score in zip(owners, texts, self.score(encoded, texts, language), strict=True):
            scores[owner] = max(scores[owner], (score, text))
        ranked = [_Candidate(words, apart, *score) for (words, apart), score in zip(near, scores, strict=True)]
        return sorted(ranked, key=lambda one: -one.rank)

    def _gap(self, encoded: Encoded, drafts: list[str], ranked: list[_Candidate], language: str | None) -> float:
        """Gap between the free words and the likeliest utterance; infinite where there is none."""
        if not ranked:
            return math.inf
        free = max(self.score(encoded, list(dict.fromkeys(drafts)), language))
        return max(free - ranked[0].score, 0.0) / (1 + self._telling(ranked[0].words, language))

    def _possible(self, text: str, language: str | None) -> bool:
        meaning = self._parse(text, language)
        return meaning.status in (Status.ACCEPTED, Status.AMBIGUOUS) or _is_refusal(meaning)

    def score(self, encoded: Encoded, texts: list[str], language: str | None = None) -> list[float]:
        """Log probability of each text given the sound, with the full stop that ends it.

        The model's own end of text is no part of it: ``align`` gives it no probability.
        """
        if self._scored[0] is not encoded:
            self._scored = (encoded, {})
        scored = self._scored[1]
        fresh = [text for text in dict.fromkeys(texts) if text not in scored]
        if fresh:
            tokens = self._token_scores(encoded, fresh, language)
            scored.update((text, float(one.sum())) for text, one in zip(fresh, tokens, strict=True))
        return [scored[text] for text in texts]

    def _token_scores(self, encoded: Encoded, texts: list[str], language: str | None) -> list[Any]:
        """Log probability of each piece of each text."""
        import ctranslate2

        tokenizer = self.tokenizer(language)
        stop = tokenizer.encode(".")
        pieces = []
        for text in texts:
            plain = tokenizer.encode(" " + text.strip())
            pieces.append(plain if text.strip()[-1:] in ".!?" else [*plain, *stop])
        # Every text gets a copy of the sound, so the silence that the encoder wanted is left out: the first stays the
        # first (40 of 40 compared) and a quarter of the recogniser's time is saved.
        spoken = math.ceil((encoded.seconds + SCORED_MARGIN) * ENCODED_PER_SECOND)
        features: Any = np.repeat(np.asarray(encoded.features)[:, :spoken], len(pieces), axis=0)
        storage = ctranslate2.StorageView.from_array(np.ascontiguousarray(features))
        results = self.engine.align(storage, list(tokenizer.sot_sequence), pieces, features.shape[1] * 2)
        return [np.log(np.maximum(result.text_token_probs, 1e-12)) for result in results]


def _is_refusal(meaning: Interpretation) -> bool:
    return meaning.reason.startswith(("negated", "cancelled"))
