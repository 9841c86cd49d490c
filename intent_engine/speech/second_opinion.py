"""A second model for what the first is not sure of.

Most commands are heard well by a small model in a few hundredths of a second. In noise it is often unsure, and then the
person would have to say it again; a model of another make knows the answer sooner than they could. It is asked only
when the utterance is over and was not acted on, so nobody waits for it who need not.

Each says which sentences of the grammar it may have been, and what it thinks of the other's. Two models that hear the
same are seldom both wrong: what both think of a sentence, in the mean, becomes one confidence.
"""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

import numpy as np

from intent_engine.errors import WeightsError
from intent_engine.interpretation import Interpretation
from intent_engine.judgement import SURE_ENOUGH, SURE_ENOUGH_TO_STOP
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.evidence import View
from intent_engine.speech.moonshine_weights import (
    MOONSHINE,
    find_moonshine,
    find_moonshine_files,
    is_moonshine,
    moonshine_package,
)
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.steered import SteeredMoonshine, SteeredWhisper
from intent_engine.speech.steering import RIVAL_MARGIN, Opinion, Reading, as_read
from intent_engine.speech.weights import find_weights

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["FIRST", "NONE", "SECOND", "SecondOpinion", "installed_second", "recognizer_for", "second_model"]

NONE = "none"
"""As a second model: none."""
FIRST = ("tiny", "tiny.en")
"""Models beside which there is a second one without being asked for."""
SECOND = (MOONSHINE, "base")
"""The usual second models: the first that is installed. Moonshine knows English only."""
SURE = 0.95
"""Confidence of the first model from which the second is not asked."""
SURE_TOGETHER = 0.9
"""Confidence of both from which the second does not search the grammar for more."""
HOPELESS = 0.03
"""Confidence below which it is not asked either: of 132 utterances among commands and other talk it found one."""
CLEAR = -0.5
"""Mean log probability of words, in which nothing of the grammar was found, from which they were heard clearly."""
LATER = 1.5
"""s by which an utterance may have gone on since it was heard with less care, all of them silent."""
UNSETTLED = 0.1
"""s at the end of such a sound that a noise filter may still change."""


class Steered(Recognizer, Protocol):
    """A recogniser that says what it makes of a sound beside what it takes it for."""

    @property
    def opinion(self) -> Opinion | None:
        """Of what it heard last."""
        ...

    def glance(self, samples: Samples) -> Opinion:
        """As :meth:`~intent_engine.speech.steering.Steering.glance`."""
        ...

    def ranked(self, views: Mapping[tuple[str, ...], Sequence[View]], language: str | None = None) -> list[Reading]:
        """As :meth:`~intent_engine.speech.steering.Steering.ranked`."""
        ...


class SecondOpinion:
    """Two recognisers of one engine, of which the second is asked where the first is unsure.

    Args:
        engine: whose grammar steers both.
        first: hears everything.
        second: makes the one that is asked in doubt. It is called at once, in a thread beside, since a model
            takes a second to load; what it raises is raised by every doubtful decode.
    """

    def __init__(self, engine: IntentEngine, first: Steered, second: Callable[[], Steered]) -> None:
        self._engine = engine
        self._first = first
        self._second = _beside(second)
        self._draft: tuple[Samples, Transcript, Opinion | None] | None = None
        """What was last heard with less care."""

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        known = self._known(samples) if final else None
        heard, opinion = known or (self._first.transcribe(samples, final=final), self._first.opinion)
        doubtful = self._doubtful(heard)
        if not final:
            self._draft = (samples, heard, opinion)
            return replace(heard, draft=doubtful)
        self._draft = None
        if not doubtful or opinion is None:
            return heard if known is None else replace(heard, decode_seconds=0.0)
        began = time.perf_counter()
        second = self._second.result()
        both = self._weighed(opinion, second.glance(samples))
        if (both.confidence or 0.0) < SURE_TOGETHER:
            other = second.transcribe(samples)
            both = other if second.opinion is None else self._weighed(opinion, second.opinion)
        spent = time.perf_counter() - began + (0.0 if known else heard.decode_seconds)
        return replace(both, decode_seconds=spent)

    def close(self) -> None:
        self._first.close()
        with contextlib.suppress(Exception):  # a second that was never made has nothing to let go of
            self._second.result().close()

    def _weighed(self, first: Opinion, second: Opinion) -> Transcript:
        """What two models heard in the same sound, as one.

        Where one heard that something shall not be done, nothing shall.
        """
        heard = first.transcript
        for one in (first, second):
            if self._meant(one.transcript).refuses:
                return one.transcript
        readings = self.joint(first, second)
        if not readings:
            return heard
        best = readings[0]
        unclear = _unclear(first.clearness(best.words), second.clearness(best.words), best.unknown > 0)
        both = as_read(heard, readings, unclear)
        if best.evidence.confidence < SURE_ENOUGH and self._meant(both).stops:
            # From less the first alone is believed, but not two: "wow" is "whoa" to both.
            return heard
        return both

    def joint(self, first: Opinion, second: Opinion) -> list[Reading]:
        """The sentences that one of two models thought of, with what both think of them, likeliest first."""
        sentences = tuple(dict.fromkeys((*first.sentences, *second.sentences)))
        if not sentences:
            return []
        views = zip(first.views(sentences), second.views(sentences), strict=True)
        return self._first.ranked(dict(zip(sentences, views, strict=True)), first.transcript.language)

    def _known(self, samples: Samples) -> tuple[Transcript, Opinion | None] | None:
        """What was heard in this utterance when it seemed to be over."""
        if self._draft is None:
            return None
        sound, heard, opinion = self._draft
        same = sound.size - int(UNSETTLED * SAMPLE_RATE)
        if not 0 < same <= samples.size <= sound.size + int(LATER * SAMPLE_RATE):
            return None
        return (heard, opinion) if np.allclose(samples[:same], sound[:same], atol=1e-4) else None

    def _doubtful(self, heard: Transcript) -> bool:
        if not heard.text.strip():
            return False
        if heard.confidence is not None:
            if heard.confidence >= SURE_ENOUGH_TO_STOP and self._meant(heard).stops:
                return False
            return HOPELESS <= heard.confidence < SURE or bool(heard.unclear)
        return heard.score < CLEAR and not self._meant(heard).refuses

    def _meant(self, heard: Transcript) -> Interpretation:
        language = heard.language if heard.language in self._engine.languages else None
        return self._engine.parse(heard.text, language=language)


def _unclear(one: Mapping[str, float], other: Mapping[str, float], unknown: bool) -> tuple[str, ...]:
    """Words that two models together did not hear clearly.

    A word that no list has must be clear in the mean. Of a number that sounds like another, what both have heard adds
    up, if neither would rather have heard the other.
    """
    least, enough = (-math.inf, 0.0) if unknown else (-RIVAL_MARGIN, -RIVAL_MARGIN)
    both = {word: (clear, other.get(word, clear)) for word, clear in one.items()}
    return tuple(word for word, clear in both.items() if min(clear) < least or sum(clear) < enough)


def recognizer_for(
    engine: IntentEngine,
    model: str = "tiny.en",
    *,
    second: str | None = None,
    language: str | None = None,
    tell: Callable[[str], object] | None = None,
) -> Recognizer:
    """The recogniser of an engine, steered by its grammar, with a second model for what it is unsure of.

    Args:
        engine: whose grammar steers.
        model: a name, or a folder.
        second: the same, or :data:`NONE`; None: beside :data:`FIRST` the first of :data:`SECOND` that is
            installed.
        language: of the speech; None: that of the engine's only grammar, or detected.
        tell: is told what takes long: weights that are made ready, once on a machine.

    Raises:
        WeightsError: a model that was named cannot be found, or the first cannot be loaded.
    """
    first = _steered(engine, model, language, tell)
    other = second_model(engine, model, second, language=language)
    if other is not None and is_moonshine(other):
        try:
            find_moonshine(other, tell)  # what takes long happens now, and not at the first word
        except WeightsError as error:
            if second is not None:
                raise
            if tell is not None:
                tell(f"no second model: {error}")
            return first
    if other is None:
        return first
    spoken = first.language if first.multilingual else "en"
    return SecondOpinion(engine, first, lambda: _steered(engine, other, spoken))


def second_model(
    engine: IntentEngine, model: str, second: str | None = None, *, language: str | None = None
) -> str | None:
    """The model beside a first one: as :func:`recognizer_for` was told, or as is installed; None: there is none.

    Raises:
        WeightsError: the one that was named cannot be found.
    """
    if second is not None:
        if second == NONE:
            return None
        if is_moonshine(second):
            find_moonshine_files(second)
        else:
            find_weights(second)
        return second
    if model not in FIRST:
        return None
    english = model.endswith(".en") or (language or "".join(engine.languages)) == "en"
    return installed_second(english=english)


def installed_second(*, english: bool = True) -> str | None:
    """The usual second model on this machine, for English or for other languages."""
    return next((one for one in SECOND if _installed(one, english)), None)


def _installed(model: str, english: bool) -> bool:
    if is_moonshine(model):
        return english and moonshine_package() is not None
    try:
        find_weights(model, download=False)
    except WeightsError:
        return False
    return True


def _steered(
    engine: IntentEngine, model: str, language: str | None, tell: Callable[[str], object] | None = None
) -> SteeredWhisper | SteeredMoonshine:
    if is_moonshine(model):
        return SteeredMoonshine(engine, model, tell=tell)
    return SteeredWhisper(engine, model, language=language)


def _beside(make: Callable[[], Steered]) -> Future[Steered]:
    """What is made in a thread of its own, at once."""
    pool = ThreadPoolExecutor(1, thread_name_prefix="second model")
    future = pool.submit(make)
    pool.shutdown(wait=False)
    return future
