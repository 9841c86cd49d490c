"""How likely given words are, as a model hears a sound: whole texts, their words, and what may come next."""

from __future__ import annotations

import math
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.language.phrase_set import PhraseSet
from intent_engine.speech.acoustic.drafts import NOTHING_DRAFTED, Draft, Drafts
from intent_engine.speech.acoustic.however_written import HoweverWritten
from intent_engine.speech.acoustic.loops import goes_round
from intent_engine.speech.acoustic.prefix_tree import PrefixTree, RecentTrees
from intent_engine.speech.acoustic.rows import Rows, total
from intent_engine.speech.acoustic.whisper import RETRY_SECONDS, WhisperRecognizer, logits_row, max_length
from intent_engine.speech.acoustic.whisper_decoder import WhisperDecoder, own_decoder
from intent_engine.speech.acoustic.writing import Names, spellings, written
from intent_engine.speech.audio import Samples
from intent_engine.speech.leaving import Leaving
from intent_engine.speech.recognizer import Encoded, Transcript

__all__ = ["Rows", "Scoring", "ScoringWhisper", "total"]

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

_NONE: Mapping[str, str] = MappingProxyType({})
_NOTHING = PhraseSet(())


class Scoring(Leaving, ABC):
    """A model that is asked what it thinks of words."""

    _scored: tuple[Encoded | None, dict[str, float]] = (None, {})
    """The sound that was asked about last, and what was said of it."""

    _decoded: tuple[Encoded | None, Rows] = (None, {})
    """The sound that was last heard freely, and what the model made of it on the way."""

    draft: Draft = NOTHING_DRAFTED
    """What may be heard freely next. Its pieces are computed in one call, and those that the model would write are not
    asked for one by one."""

    language: str | None
    """Of the speech; None: detected."""

    _names: tuple[Any, Mapping[str, str], Names] | None = None
    """Of the tokenizer and the grammar that were used last."""

    @abstractmethod
    def encode(self, samples: Samples, seconds: float = 0.0) -> Encoded:
        """The sound as the model needs it, padded to at least so many seconds."""

    @abstractmethod
    def detect(self, encoded: Encoded, among: Collection[str] = ()) -> dict[str, float]:
        """The languages that the speech may be (empty: any), each with its log probability, the likeliest first."""

    @abstractmethod
    def greedy(self, encoded: Encoded, language: str | None = None) -> tuple[str, float, bool]:
        """The likeliest words: (text, mean log probability, whether it went round in a loop)."""

    @abstractmethod
    def longer(self, seconds: float) -> float:
        """Length of the encoder's input, in s, with which speech of so many seconds is tried again."""

    @abstractmethod
    def tokenizer(self, language: str | None = None) -> Any:
        """The pieces in which it writes a language; as faster-whisper's tokenizer."""

    @abstractmethod
    def end_piece(self, language: str | None = None) -> int:
        """The piece that stands for the end of a sentence in :meth:`next_pieces`."""

    @abstractmethod
    def next_pieces(
        self, encoded: Encoded, beginnings: Sequence[tuple[int, ...]], length: int, language: str | None = None
    ) -> Iterator[tuple[tuple[int, ...], Any]]:
        """How likely every next piece is after some beginnings of a text, and after what the model would go on with.

        Args:
            encoded: the sound.
            beginnings: tokens that the text begins with; they may differ in length.
            length: tokens up to which the model may go on.
            language: of the speech.

        Yields:
            (beginning, ``(vocabulary,)`` log probabilities).
        """

    def follow(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Following.follow`."""
        began = time.perf_counter()
        self.stay()
        if self.language is None:
            return Transcript("", draft=True)
        encoded = self.encode(samples)
        self.draft = self.drafted(samples)
        text, score, _ = self.greedy(encoded, self.language)
        self.drafts.keep(samples, self.pieces_written(encoded))
        seconds = time.perf_counter() - began
        return Transcript(text, score, text, language=self.language, decode_seconds=seconds, draft=True)

    def lose(self) -> None:
        """As :meth:`~intent_engine.speech.recognizer.Following.lose`."""
        self.drafts.lose()

    @cached_property
    def drafts(self) -> Drafts:
        """What was written of the speech so far."""
        return Drafts()

    def drafted(self, samples: Samples, told: Callable[[], str] | None = None, language: str | None = None) -> Draft:
        """What may be heard in a sound: what was written of it so far; else what somebody else hears in it.

        Args:
            samples: ``(n,)``
            told: gives the words that somebody else hears; they may become more while this model writes.
            language: of the speech.
        """
        own = self.drafts.of(samples)
        if own or told is None:
            return Draft(lambda: own)
        tokenizer = self.tokenizer(language)
        known: dict[str, tuple[int, ...]] = {"": ()}

        def pieces() -> tuple[int, ...]:
            text = told().strip()
            if text not in known:
                known[text] = tuple(tokenizer.encode(" " + text))
            return known[text]

        return Draft(pieces)

    def pieces_written(self, encoded: Encoded) -> tuple[int, ...]:
        """The pieces that it wrote when it heard a sound freely, as :meth:`decoded`."""
        return max(self.decoded(encoded), key=len, default=())

    def decoded(self, encoded: Encoded) -> Rows:
        """What the model made of a sound when it heard it freely: all that it wrote is a beginning. Nothing, if it has
        heard another since."""
        return self._decoded[1] if self._decoded[0] is encoded else {}

    def however_written(self, encoded: Encoded, language: str | None = None) -> float:
        """Mean log probability of what was heard freely, however it might be written; minus infinity: nobody knows."""
        return -math.inf

    @abstractmethod
    def _pieces(self, encoded: Encoded, texts: Sequence[str], language: str | None) -> list[Any]:
        """Log probability of each piece of each text, and of its end."""

    def score(self, encoded: Encoded, texts: Sequence[str], language: str | None = None) -> list[float]:
        """Log probability of each text given the sound, with its end."""
        if self._scored[0] is not encoded:
            self._scored = (encoded, {})
        scored = self._scored[1]
        fresh = [text for text in dict.fromkeys(texts) if text not in scored]
        if fresh:
            pieces = self._pieces(encoded, fresh, language)
            scored.update((text, float(one.sum())) for text, one in zip(fresh, pieces, strict=True))
        return [scored[text] for text in texts]

    def score_words(
        self, encoded: Encoded, sentences: Sequence[Sequence[str]], language: str | None = None
    ) -> list[float]:
        """Log probability of sentences in plain words, each in the likelier of its spellings: with numbers in words or
        in digits, and with names small or with a capital; the first word as the model began what it heard freely."""
        names, large = self.names(language), self._begins_large(encoded, language)
        texts = [
            [written(one, language, sentence=large) for one in spellings(words, language, names)] for words in sentences
        ]
        scores = iter(self.score(encoded, [text for spelled in texts for text in spelled], language))
        return [max(next(scores) for _ in spelled) for spelled in texts]

    def _begins_large(self, encoded: Encoded, language: str | None) -> bool:
        """Whether what was heard freely begins with a capital, as a sentence does."""
        heard = self.pieces_written(encoded)
        return not self.tokenizer(language).decode(list(heard[:1])).strip()[:1].islower()

    def names(self, language: str | None = None) -> Names:
        """The words that it may write with a capital."""
        kept = self.tokenizer(language), self.as_written(language)
        if self._names is None or self._names[0] is not kept[0] or self._names[1] is not kept[1]:
            self._names = (*kept, Names(*kept, self.calls(language)))
        return self._names[2]

    def as_written(self, language: str | None = None) -> Mapping[str, str]:
        """Words that are known with a capital or an apostrophe, by the same small and plain."""
        return _NONE

    def calls(self, language: str | None = None) -> PhraseSet:
        """By which words the robot is called."""
        return _NOTHING

    def word_scores(self, encoded: Encoded, text: str, language: str | None = None) -> list[tuple[str, float]]:
        """Each word of a text with the mean log probability of its pieces."""
        tokenizer = self.tokenizer(language)
        (pieces,) = self._pieces(encoded, [text], language)
        found = []
        at = 0
        for word in text.split():
            count = len(tokenizer.encode(" " + word))
            found.append((word, float(np.mean(pieces[at : at + count]))))
            at += count
        return found


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
