"""How likely given words are to a Whisper model."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.however_written import HoweverWritten
from intent_engine.speech.acoustic.loops import goes_round
from intent_engine.speech.acoustic.prefix_tree import PrefixTree, RecentTrees
from intent_engine.speech.acoustic.rows import total
from intent_engine.speech.acoustic.scoring import Scoring
from intent_engine.speech.acoustic.whisper import RETRY_SECONDS, WhisperRecognizer, logits_row, max_length
from intent_engine.speech.acoustic.whisper_decoder import WhisperDecoder, own_decoder
from intent_engine.speech.recognizer import Encoded

__all__ = ["ScoringWhisper"]

SCORED_MARGIN = 1.5
"""s of silence after the speech that texts are scored against. With half a second one text in ten was taken for three
nats less likely than it is, or more than that; of utterances of little more than a second four in ten."""
RETRY_MARGIN = 2.0
"""s of silence after the speech in a longer encoder input."""
ENCODED_PER_SECOND = 50
"""Vectors of Whisper's encoder."""
LEAST = 1e-12
"""Least probability of a piece."""
MEASURED = (None, "en", "de")
"""Languages of which it was measured how clear words are, however they are written."""
MOST_KEPT = 64
"""Pieces of what was heard freely, beyond which it is no command, and 0.2 MB for each are not kept."""
ONWARD = 3
"""Pieces with which the model goes on after a beginning, where it is asked about many."""


class ScoringWhisper(WhisperRecognizer, Scoring):
    """A Whisper model that is asked what it thinks of words. Made and closed as :class:`WhisperRecognizer`.

    A small model on the processor is asked through a decoder of our own
    (:mod:`~intent_engine.speech.acoustic.whisper_decoder`), any other through CTranslate2.
    """

    def __init__(self, model: str = "tiny.en", **options: Any) -> None:
        super().__init__(model, **options)
        self._decoder = own_decoder(self) if options.get("compute_type") in (None, "int8") else None
        self._trees = RecentTrees()
        self._writing: dict[str | None, HoweverWritten] = {}

    def longer(self, seconds: float) -> float:
        return max(RETRY_SECONDS, seconds + RETRY_MARGIN)

    def greedy_tokens(self, encoded: Encoded, language: str | None = None) -> tuple[list[int], float]:
        if self._decoder is not None:
            return self._written(self._decoder, encoded, language)
        result = self._greedy(encoded, language, return_logits_vocab=True)
        tokens = tuple(result.sequences_ids[0])
        told = result.logits[0] if len(tokens) <= MOST_KEPT else ()
        self._decoded = (encoded, {tokens[:place]: logits_row(logits) for place, logits in enumerate(told)})
        return list(tokens), float(result.scores[0])

    def _written(self, decoder: WhisperDecoder, encoded: Encoded, language: str | None) -> tuple[list[int], float]:
        """What the model writes, piece by piece, until it ends or goes round in a loop."""
        tree, tokenizer = self._tree(encoded, language), self.tokenizer(language)
        rows: dict[tuple[int, ...], npt.NDArray[np.float32]] = {}
        pieces: tuple[int, ...] = ()
        scores = []
        drafted: dict[tuple[int, ...], npt.NDArray[np.float32]] = {}
        for _ in range(self.most_pieces(encoded)):
            if pieces not in drafted:
                drafted |= tree.along(pieces, self.draft.after(pieces))
            row = rows[pieces] = drafted[pieces]
            able = decoder.able(row, first=not pieces)
            piece = int(able[: tokenizer.no_timestamps].argmax())
            scores.append(float(able[piece]))
            if piece == tokenizer.eot:
                break
            pieces += (piece,)
            if goes_round(tokenizer.decode(list(pieces))):
                break
        self._decoded = (encoded, rows if len(rows) <= MOST_KEPT else {})
        return list(pieces), sum(scores) / max(len(pieces), 1)

    def however_written(self, encoded: Encoded, language: str | None = None) -> float:
        if language not in MEASURED:
            return -math.inf
        if language not in self._writing:
            self._writing[language] = HoweverWritten(self.tokenizer(language), language)
        return self._writing[language].clearness(self.decoded(encoded))

    def end_piece(self, language: str | None = None) -> int:
        end: int = self.tokenizer(language).eot
        return end

    def _signs(self, language: str | None) -> list[int]:
        """Pieces that end a sentence: a full stop, or a question or exclamation mark."""
        tokenizer = self.tokenizer(language)
        return [piece for sign in ".?!" for piece in tokenizer.encode(sign)]

    def next_pieces(
        self, encoded: Encoded, beginnings: Sequence[tuple[int, ...]], length: int, language: str | None = None
    ) -> Iterator[tuple[tuple[int, ...], Any]]:
        if self._decoder is not None:
            # For a few pieces: more can be asked for soon.
            (stop, *_) = self._signs(language)
            found = self._tree(encoded, language).onward(beginnings, length, stop, ONWARD)
        else:
            found = self._generated(encoded, beginnings, length, language)
        end, signs = self.end_piece(language), self._signs(language)
        for beginning, row in found:
            ended = row.copy()
            ended[end] = np.logaddexp.reduce(row[signs])
            yield beginning, ended

    def _generated(
        self, encoded: Encoded, beginnings: Sequence[tuple[int, ...]], length: int, language: str | None
    ) -> Iterator[tuple[tuple[int, ...], Any]]:
        self.check()
        prompt = self.prompt(language)
        longest = max(length, 1 + max(map(len, beginnings)))
        results = self.engine.generate(
            self._copies(encoded, len(beginnings)),
            [[*prompt, *beginning] for beginning in beginnings],
            beam_size=1,
            max_length=max_length(len(prompt), longest),
            return_logits_vocab=True,
            suppress_blank=False,
            suppress_tokens=None,
        )
        for beginning, result in zip(beginnings, results, strict=True):
            # What is given back leaves out the beginning's last piece or so, which is known.
            tokens = (*beginning, *result.sequences_ids[0][len(beginning) :])
            for place, logits in enumerate(result.logits[0]):
                if place > len(tokens):
                    break
                row = logits_row(logits)
                yield tokens[:place], row - total(row)

    def _pieces(self, encoded: Encoded, texts: Sequence[str], language: str | None) -> list[Any]:
        """With the sign that ends a text, whichever: "Could you go back?" is far likelier with a question mark, and a
        command now and then with an exclamation mark. Whisper's own end is no part: ``align`` gives it no probability.
        """
        tokenizer, signs = self.tokenizer(language), self._signs(language)
        pieces = [tokenizer.encode(" " + text.strip().rstrip(".!?")) for text in texts]
        if self._decoder is not None:
            tree = self._tree(encoded, language)
            tree.learn([*own, signs[0]] for own in pieces)
            return [np.append(tree.likelihood(own), np.logaddexp.reduce(tree.after(own, signs))) for own in pieces]
        pieces = [[*own, self._sign_heard(encoded, signs)] for own in pieces]
        copies = self._copies(encoded, len(pieces))
        results = self.engine.align(copies, list(tokenizer.sot_sequence), pieces, copies.shape[1] * 2)
        return [np.log(np.maximum(result.text_token_probs, LEAST)) for result in results]

    def _sign_heard(self, encoded: Encoded, signs: Sequence[int]) -> int:
        """The sign with which the model ended what it heard freely; else a full stop."""
        heard = self.pieces_written(encoded)
        return heard[-1] if heard and heard[-1] in signs else signs[0]

    def _copies(self, encoded: Encoded, count: int) -> Any:
        """The encoded sound, once for each text, without the silence that the encoder wanted: the likeliest text stays
        the likeliest (40 of 40 compared) and a quarter of the time is saved."""
        import ctranslate2

        features = np.repeat(self._spoken(encoded), count, axis=0)
        return ctranslate2.StorageView.from_array(np.ascontiguousarray(features))

    def _tree(self, encoded: Encoded, language: str | None) -> PrefixTree:
        decoder, prompt = self._decoder, self.prompt(language)
        assert decoder is not None

        def plant() -> PrefixTree:
            return PrefixTree(decoder, self._spoken(encoded)[0], prompt, self.check)

        return self._trees.of(encoded, prompt, plant)

    @staticmethod
    def _spoken(encoded: Encoded) -> npt.NDArray[np.float32]:
        """The encoded sound, without the silence that the encoder wanted."""
        spoken = math.ceil((encoded.seconds + SCORED_MARGIN) * ENCODED_PER_SECOND)
        return np.ascontiguousarray(np.asarray(encoded.features)[:, :spoken])

    def close(self) -> None:
        self._trees.clear()
        self._decoder = None
        super().close()
