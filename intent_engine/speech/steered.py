"""Whisper steered by the grammar: free words first, and only where they are no command a search among commands.

The free decode is the draft. Where every piece of it may stand in the grammar nothing more is asked. Where it leaves
the grammar, the best allowed pieces are tried instead, each followed by a free decode that is walked in the same way;
so the number of model calls is the number of places where grammar and draft part, not the number of pieces.
"""

from __future__ import annotations

import heapq
import itertools
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from intent_engine.interpretation import Status
from intent_engine.speech.audio import Samples
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.steering import Cursor, Steering
from intent_engine.speech.whisper import RETRY_SECONDS, TOKENS_PER_SECOND, Encoded, WhisperRecognizer, fold_loop

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["SteeredWhisper"]

BRANCHES = 3
"""Allowed pieces tried at each place where draft and grammar part, and branches decoded together."""
ROUNDS = 6
"""Calls of the model for one search."""
REACH = 14.0
"""nats below the free decode beyond which a branch is not worth a call: it would be rejected anyway."""
ENDINGS = (".", "!", "?", ",", ";")

Rows = npt.NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class _Draft:
    """Pieces decoded freely, with the log probabilities at each place."""

    pieces: list[int]
    rows: Rows
    """``(pieces + 1 or fewer, vocabulary)``, log probabilities before each piece."""


@dataclass(frozen=True, slots=True)
class _Branch:
    pieces: tuple[int, ...]
    cursor: Cursor
    score: float


@dataclass(frozen=True, slots=True)
class _Whole:
    words: tuple[str, ...]
    score: float


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
        self._steering: tuple[Any, str | None, Steering] | None = None
        self._pieces: dict[str, list[str]] = {}

    def steering(self, language: str | None = None) -> Steering:
        """The grammar as it is now, in this model's pieces."""
        graph = self._engine.matcher(language if language in self._engine.languages else None).spoken
        kept = self._steering
        if kept is None or kept[0] is not graph:
            tokenizer = self.tokenizer(language)
            pieces = self._texts(language)
            kept = self._steering = (graph, language, Steering(graph, tokenizer.encode, pieces))
        return kept[2]

    def _texts(self, language: str | None) -> list[str]:
        key = language or "en"
        if key not in self._pieces:
            tokenizer = self.tokenizer(language)
            self._pieces[key] = [tokenizer.decode([number]) for number in range(tokenizer.eot)]
        return self._pieces[key]

    # -- recognising -------------------------------------------------------------------------------

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        began = time.perf_counter()
        if samples.size == 0:
            return Transcript("")
        best = self._once(samples, None)
        if best.gap is None or best.gap > 4.0:
            again = self._once(samples, RETRY_SECONDS)
            if again.gap is not None and (best.gap is None or again.gap < best.gap):
                best = again
        return Transcript(
            best.text,
            best.score,
            best.free_text,
            best.gap,
            best.alternatives,
            best.language,
            time.perf_counter() - began,
        )

    def _once(self, samples: Samples, seconds: float | None) -> Transcript:
        encoded = self.encode(samples, seconds) if seconds is not None else self.encode(samples)
        language = self.language or self.detect(encoded)
        tokenizer = self.tokenizer(language)
        limit = int(encoded.seconds * TOKENS_PER_SECOND) + 8
        draft = self._drafts(encoded, [[]], limit, language)[0]
        words = [piece for piece in draft.pieces if piece < tokenizer.eot]
        whole_text = tokenizer.decode(words).strip()
        free = fold_loop(whole_text)
        score = _score_of(draft, tokenizer.eot)
        mean = score / max(len(draft.pieces), 1)
        meaning = self._engine.parse(free)
        if meaning.status is Status.ACCEPTED and meaning.confidence == 1.0:
            return Transcript(free, mean, free, 0.0, language=language)
        if meaning.reason.startswith(("negated", "cancelled")):
            return Transcript(free, mean, free, None, language=language)
        if free != whole_text:
            # A loop: only its first round was said, and only that is compared.
            once = len(tokenizer.encode(" " + free))
            draft = _Draft(draft.pieces[:once], draft.rows[: once + 1])
            score = _score_of(draft, tokenizer.eot)
        found = self._search(encoded, draft, score, limit, language)
        if not found:
            return Transcript(free, mean, free, None, language=language)
        text = " ".join(found[0].words)
        others = tuple(" ".join(one.words) for one in found[1:4])
        return Transcript(text, mean, free, max(score - found[0].score, 0.0), others, language)

    # -- the search --------------------------------------------------------------------------------

    def _search(
        self, encoded: Encoded, draft: _Draft, free_score: float, limit: int, language: str | None
    ) -> list[_Whole]:
        """Whole utterances of the grammar, likeliest first."""
        steering = self.steering(language)
        ends = self._endings(language)
        wholes: dict[tuple[str, ...], float] = {}
        order = itertools.count()
        queue: list[tuple[float, int, _Branch]] = []
        floor = free_score - REACH

        def walk(branch: _Branch, decoded: _Draft) -> None:
            cursor, score, pieces = branch.cursor, branch.score, branch.pieces
            for place, row in enumerate(decoded.rows):
                worst = max([floor, *([max(wholes.values())] if wholes else [])])
                words = steering.whole(cursor)
                if words is not None:
                    total = score + float(row[ends].max())
                    if total > wholes.get(words, -np.inf):
                        wholes[words] = total
                allowed = steering.allowed(cursor)
                drafted = decoded.pieces[place] if place < len(decoded.pieces) else None
                onward = steering.advance(cursor, drafted) if drafted is not None else None
                if allowed.size:
                    scores = row[allowed]
                    count = min(BRANCHES + 1, allowed.size)
                    for index in np.argpartition(-scores, count - 1)[:count]:
                        piece, gain = int(allowed[index]), float(scores[index])
                        if score + gain <= worst or (onward is not None and piece == drafted):
                            continue
                        after = steering.advance(cursor, piece)
                        if after is not None:
                            total = score + gain
                            heapq.heappush(queue, (-total, next(order), _Branch((*pieces, piece), after, total)))
                if onward is None or drafted is None:
                    return
                score += float(row[drafted])
                pieces = (*pieces, drafted)
                cursor = onward

        walk(_Branch((), steering.start(), 0.0), draft)
        for _ in range(ROUNDS):
            best = max(wholes.values()) if wholes else -np.inf
            batch = []
            while queue and len(batch) < BRANCHES:
                _, _, branch = heapq.heappop(queue)
                if branch.score > max(best, floor):
                    batch.append(branch)
            if not batch:
                break
            drafts = self._drafts(encoded, [list(branch.pieces) for branch in batch], limit, language)
            for branch, decoded in zip(batch, drafts, strict=True):
                walk(branch, decoded)
        return sorted((_Whole(words, score) for words, score in wholes.items()), key=lambda whole: -whole.score)

    def _endings(self, language: str | None) -> npt.NDArray[np.int64]:
        tokenizer = self.tokenizer(language)
        single = [tokenizer.encode(mark) for mark in ENDINGS]
        return np.array([tokenizer.eot, *(pieces[0] for pieces in single if len(pieces) == 1)], np.int64)

    def _drafts(self, encoded: Encoded, prefixes: list[list[int]], limit: int, language: str | None) -> list[_Draft]:
        """Free decodes after each prefix, with log probabilities of what follows it."""
        import ctranslate2

        prompt = self.prompt(language)
        tokenizer = self.tokenizer(language)
        longest = max(len(prefix) for prefix in prefixes)
        features = encoded.features
        if len(prefixes) > 1:
            array = np.repeat(np.asarray(features), len(prefixes), axis=0)
            features = ctranslate2.StorageView.from_array(np.ascontiguousarray(array))
        results = self.engine.generate(
            features,
            [[*prompt, *prefix] for prefix in prefixes],
            beam_size=1,
            max_length=min(2 * (longest + limit), 448),
            return_scores=True,
            return_logits_vocab=True,
            suppress_blank=False,
            suppress_tokens=[],
        )
        drafts = []
        for prefix, result in zip(prefixes, results, strict=True):
            rows = np.asarray(result.logits[0], np.float32)
            pieces = list(result.sequences_ids[0])
            rows = _log_softmax(rows[len(prefix) :])
            pieces = pieces[len(prefix) :]
            if len(rows) > len(pieces):
                pieces = [*pieces, tokenizer.eot]
            drafts.append(_Draft(pieces, rows))
        return drafts


def _log_softmax(rows: Rows) -> Rows:
    if not rows.size:
        return rows
    peak = rows.max(axis=1, keepdims=True)
    shifted = rows - peak
    result: Rows = shifted - np.log(np.exp(shifted).sum(axis=1, keepdims=True))
    return result


def _score_of(draft: _Draft, end: int) -> float:
    """Log probability of a draft, its end included where it has one."""
    total = 0.0
    for row, piece in zip(draft.rows, draft.pieces, strict=False):
        total += float(row[piece])
    if len(draft.rows) > len(draft.pieces):
        total += float(draft.rows[len(draft.pieces)][end])
    return total
