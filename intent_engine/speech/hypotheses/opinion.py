"""What a model makes of a sound: sentences of the grammar that it may have been, and what speaks for each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from threading import Event
from typing import TYPE_CHECKING, Protocol, TypeVar

from intent_engine.actions import Action
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.language.numbers.spelled import first_figure_apart
from intent_engine.speech.audio import Samples
from intent_engine.speech.hypotheses.dictating import DICTATED, as_heard, as_written, begin_of, text_of
from intent_engine.speech.hypotheses.evidence import Evidence, View, letters_apart
from intent_engine.speech.recognizer import Encoded, Recognizer, Transcript
from intent_engine.ways import opposite_ways

if TYPE_CHECKING:
    from intent_engine.speech.steering import Steering

__all__ = ["Opinion", "Reading", "Steered", "as_read", "read_alone"]

_Answer = TypeVar("_Answer")

ALTERNATIVES = 3
"""Further readings of a transcript; and the likeliest that goes the other way."""


@dataclass(frozen=True, slots=True)
class Reading:
    """A sentence of the grammar that may have been said."""

    words: tuple[str, ...]
    evidence: Evidence
    actions: tuple[Action, ...] = ()
    behind: float = 0.0
    """nats by which it is less likely than the likeliest."""

    @property
    def unknown(self) -> int:
        """Words that a free slot took as they were heard."""
        return sum(isinstance(word, FreeWord) for word in self.words)


@dataclass(frozen=True, slots=True, eq=False)
class Opinion:
    """What one model makes of one stretch of sound."""

    model: Steering
    samples: Samples
    encoded: Encoded
    transcript: Transcript
    sentences: tuple[tuple[str, ...], ...] = ()
    """Of the grammar, that it may have been."""
    settled: bool = False
    """Whether the model has nothing more to find."""
    dictated: tuple[str, ...] = ()
    """The words before a dictated text, if one was heard."""

    @property
    def clear(self) -> bool:
        """Whether it is a command that was heard word by word, with no word in question."""
        return self.settled and self.transcript.confidence == 1.0 and not (self.transcript.unclear or self.dictated)

    @property
    def heard(self) -> list[str]:
        """The words heard freely, numbers as words."""
        return self.model.grammar.words(self.transcript.free_text, self.transcript.language)

    def heard_beside(self, words: Sequence[str]) -> list[str]:
        """The same, of the ways to read a number in figures the one that is the most like a sentence."""
        return min(self._hearings, key=lambda heard: letters_apart(words, heard))

    @property
    def _hearings(self) -> list[list[str]]:
        free, language = self.transcript.free_text, self.transcript.language
        texts = dict.fromkeys((free, first_figure_apart(free, language)))
        return [self.model.grammar.words(text, language) for text in texts]

    def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
        """What the model thinks of sentences, its own or others'."""
        heard = self.heard
        said = [as_heard(words, heard) for words in sentences]
        scores = self.model.score_words(self.encoded, said, self.transcript.language)
        viewed = self.viewed(dict(zip(said, scores, strict=True)))
        return [
            replace(viewed[one], words=len(one) if begin_of(words) else 0)
            for one, words in zip(said, sentences, strict=True)
        ]

    def written(self, begin: Sequence[str]) -> str:
        """A dictated text as the model wrote it, after the words that are before it."""
        language = self.transcript.language
        return as_written(begin, self.transcript.free_text, lambda text: self.model.grammar.words(text, language))

    def likelihoods(self, texts: Sequence[str]) -> list[float]:
        """Log probability of texts, as they are written, given the sound."""
        return self.model.score(self.encoded, texts, self.transcript.language)

    def viewed(self, scores: Mapping[tuple[str, ...], float]) -> dict[tuple[str, ...], View]:
        """What the model thinks of sentences of which it has said how likely they are. One that it heard word by word
        is as likely as what it wrote, however it wrote that ("Touchdown!")."""
        hearings = self._hearings
        (free_score,) = self.model.score(self.encoded, [self.transcript.free_text], self.transcript.language)
        if (said := tuple(hearings[0])) in scores:
            scores = {**scores, said: max(scores[said], free_score)}
        return {
            words: View(score, free_score, min(letters_apart(words, one) for one in hearings))
            for words, score in scores.items()
        }

    def beside(self, words: tuple[str, ...], *, far: bool = False) -> tuple[tuple[str, ...], ...]:
        """As :meth:`Steering.beside`."""
        return self.model.beside(self, words, far=far)

    def begun(self, words: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
        """As :meth:`Steering.begun`."""
        return self.model.begun(self, words)

    def clearness(self, words: Sequence[str], others: Sequence[Sequence[str]] = ()) -> dict[str, float]:
        """As :meth:`Steering.clearness`."""
        heard = self.heard
        said = as_heard(words, heard)
        language, word_by_word = self.transcript.language, heard == list(said)
        return self.model.clearness(self.encoded, said, language, heard=word_by_word, others=others)


class Steered(Recognizer, Protocol):
    """A recogniser that says what it makes of a sound beside what it takes it for, step by step."""

    left: Event | None
    """As of :class:`~intent_engine.speech.leaving.Leaving`."""

    def prepare(self) -> None:
        """As :meth:`~intent_engine.speech.steering.Steering.prepare`."""
        ...

    def glance(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Glancing.glance`."""
        ...

    def follow(self, samples: Samples) -> Transcript:
        """As :meth:`~intent_engine.speech.recognizer.Following.follow`."""
        ...

    def lose(self) -> None:
        """As :meth:`~intent_engine.speech.recognizer.Following.lose`."""
        ...

    def despite_cuda(self, ask: Callable[[], _Answer]) -> _Answer:
        """As :meth:`~intent_engine.speech.acoustic.scoring.Scoring.despite_cuda`."""
        ...

    def stay(self) -> None:
        """As :meth:`~intent_engine.speech.leaving.Leaving.stay`."""
        ...

    def leave(self) -> None:
        """As :meth:`~intent_engine.speech.leaving.Leavable.leave`."""
        ...

    def listen(self, samples: Samples, *, told: Callable[[], str] | None = None) -> Opinion:
        """As :meth:`~intent_engine.speech.steering.Steering.listen`."""
        ...

    def compare(self, heard: Opinion) -> Opinion:
        """As :meth:`~intent_engine.speech.steering.Steering.compare`."""
        ...

    def search(self, heard: Opinion) -> Opinion:
        """As :meth:`~intent_engine.speech.steering.Steering.search`."""
        ...

    def dig(self, heard: Opinion, searched: Opinion) -> Opinion:
        """As :meth:`~intent_engine.speech.steering.Steering.dig`."""
        ...

    def clear(self, heard: Opinion) -> Transcript:
        """As :meth:`~intent_engine.speech.steering.Steering.clear`."""
        ...


def as_read(
    opinions: Sequence[Opinion],
    readings: Sequence[Reading],
    *,
    unclear: tuple[str, ...] = (),
    left_out: tuple[str, ...] = (),
) -> Transcript:
    """What one or several models heard, the first of them freely, taken for the likeliest of some sentences, of whose
    words some were not clear, and which leaves some out that were heard."""
    best, *others = readings[: 1 + ALTERNATIVES]
    opposite = next((one for one in readings if opposite_ways(best.actions, one.actions)), None)
    if opposite is not None and opposite not in others:
        others.append(opposite)
    return replace(
        opinions[0].transcript,
        text=text_of(best.words, opinions),
        gap=best.evidence.gap,
        alternatives=tuple(" ".join(one.words).replace(DICTATED, "...") for one in others),
        behind=tuple(one.behind for one in others),
        unclear=unclear,
        left_out=left_out,
        confidence=best.evidence.confidence,
    )


def read_alone(heard: Opinion, readings: Sequence[Reading]) -> Opinion:
    """What was heard, taken for the likeliest of some sentences; if there are none, for nothing."""
    transcript = as_read([heard], readings) if readings else heard.transcript
    return replace(heard, transcript=transcript, sentences=tuple(one.words for one in readings))
