"""How likely given words are, as a model hears a sound: whole texts, their words, and what may come next."""

from __future__ import annotations

import math
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any, TypeVar

import numpy as np

from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.speech.acoustic.drafts import NOTHING_DRAFTED, Draft, Drafts
from intent_engine.speech.acoustic.rows import Rows
from intent_engine.speech.acoustic.writing import Names, spellings, written
from intent_engine.speech.audio import Samples
from intent_engine.speech.leaving import Leaving
from intent_engine.speech.recognizer import Encoded, Transcript

__all__ = ["Scoring"]

_Answer = TypeVar("_Answer")
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

    def despite_cuda(self, ask: Callable[[], _Answer]) -> _Answer:
        """What the model is asked; where its device fails, answered by the processor."""
        return ask()

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
