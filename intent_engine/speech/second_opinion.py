"""A second, larger model for what the first is not sure of.

Most commands are heard well by a small model in a few hundredths of a second. In noise it is often unsure, and then the
person would have to say it again; a larger model knows the answer sooner than they could. It is asked only when the
utterance is over and was not acted on, so nobody waits for it who need not.

Two models that hear the same are seldom both wrong, and of two that differ one is: what both think is weighed into one
confidence.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from operator import mul
from typing import TYPE_CHECKING

import numpy as np

from intent_engine.errors import WeightsError
from intent_engine.interpretation import Interpretation, Status
from intent_engine.judgement import SURE_ENOUGH, SURE_ENOUGH_TO_STOP
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.steered import SteeredWhisper
from intent_engine.speech.weights import find_weights

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["NONE", "SecondOpinion", "confidence", "evidence", "recognizer_for", "second_model", "weighed"]

NONE = "none"
"""As a second model: none."""
SECOND = {"tiny.en": "base", "tiny": "base"}
"""First model -> the second, where it is installed."""
SURE = 0.9
"""Confidence of the first model from which the second is not asked."""
HOPELESS = 0.03
"""Confidence below which it is not asked either: of 132 utterances among commands and other talk it found one."""
CLEAR = -0.5
"""Mean log probability of words, in which nothing of the grammar was found, from which they were heard clearly."""
LATER = 1.5
"""s by which an utterance may have gone on since it was heard with less care, all of them silent."""
UNSETTLED = 0.1
"""s at the end of such a sound that a noise filter may still change."""
BIAS, SURER, BOTH, DIFFER = -0.7, 0.7, 1.2, -1.3
"""Logistic regression, by ``scripts/fit_second_opinion.py``; see :func:`weighed`. Between what fits coffee orders of 50
people and what fits 14 synthetic voices, each in quiet and in kitchen noise."""
ONE_WORD = -0.5
"""The same for a single word that is no stop: "no" and "so" are heard as "go" by both."""
LEAST = 0.001
"""Confidences are taken to be at least so far from 0 and 1."""


class SecondOpinion:
    """Two recognisers of one engine, of which the second is asked where the first is unsure.

    Args:
        engine: whose grammar steers both.
        first: hears everything.
        second: makes the one that is asked in doubt. It is called at once, in a thread beside, since a large model
            takes a second to load; what it raises is raised by every doubtful decode.
    """

    def __init__(self, engine: IntentEngine, first: Recognizer, second: Callable[[], Recognizer]) -> None:
        self._engine = engine
        self._first = first
        self._second = _beside(second)
        self._draft: tuple[Samples, Transcript] | None = None
        """What was last heard with less care."""

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        known = self._known(samples) if final else None
        heard = known or self._first.transcribe(samples, final=final)
        doubtful = self._doubtful(heard)
        if not final:
            self._draft = (samples, heard)
            return replace(heard, draft=doubtful)
        self._draft = None
        spent = 0.0 if known else heard.decode_seconds
        if not doubtful:
            return replace(heard, decode_seconds=spent)
        other = self._second.result().transcribe(samples)
        spent += other.decode_seconds
        return replace(weighed(heard, other, self._meant(heard), self._meant(other)), decode_seconds=spent)

    def close(self) -> None:
        self._first.close()
        with contextlib.suppress(Exception):  # a second that was never made has nothing to let go of
            self._second.result().close()

    def _known(self, samples: Samples) -> Transcript | None:
        """What was heard in this utterance when it seemed to be over."""
        if self._draft is None:
            return None
        sound, heard = self._draft
        same = sound.size - int(UNSETTLED * SAMPLE_RATE)
        if not 0 < same <= samples.size <= sound.size + int(LATER * SAMPLE_RATE):
            return None
        return heard if np.allclose(samples[:same], sound[:same], atol=1e-4) else None

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


def weighed(
    first: Transcript, second: Transcript, first_meaning: Interpretation, second_meaning: Interpretation
) -> Transcript:
    """What two models heard in the same sound, as one: the surer of them, as sure as the other lets it be.

    Where one heard that something shall not be done, nothing shall. A word that one did not hear clearly is clear if
    the other heard the same command and had no doubt of it.
    """
    if first_meaning.refuses or second_meaning.refuses:
        return first if first_meaning.refuses else second
    rows = [
        (confidence(heard, meaning), heard, meaning)
        for heard, meaning in ((second, second_meaning), (first, first_meaning))
    ]
    (sure, heard, meaning), (other, differing, other_meaning) = sorted(rows, key=lambda row: -row[0])
    if meaning.status is not Status.ACCEPTED:
        return first
    agree = meaning.actions == other_meaning.actions
    value = BIAS + sum(map(mul, (SURER, BOTH, DIFFER), evidence(sure, other, agree)))
    if len(heard.text.split()) == 1 and not meaning.stops:
        value += ONE_WORD
    both = 1 / (1 + math.exp(-value))
    if meaning.stops and both < SURE_ENOUGH:
        # From less the first alone is believed, but not two: of single words by people in doubt five of five stops had
        # it, and one of 13 other words that both thought a stop ("wow").
        return first
    unclear = (*heard.unclear, *differing.unclear)
    if agree and not (heard.unclear and differing.unclear):
        unclear = ()
    return replace(heard, confidence=both, unclear=tuple(dict.fromkeys(unclear)))


def evidence(sure: float, other: float, agree: bool) -> tuple[float, float, float]:
    """What is weighed: how sure the surer model is, whether both mean the same, how sure the other is if not."""
    return math.log(max(sure, LEAST) / max(1 - sure, LEAST)), float(agree), 0.0 if agree else other


def confidence(heard: Transcript, meaning: Interpretation) -> float:
    """How sure a model is of what it heard, 0 to 1; 0 for what is no command."""
    if meaning.status is not Status.ACCEPTED:
        return 0.0
    return 1.0 if heard.confidence is None else heard.confidence


def recognizer_for(
    engine: IntentEngine, model: str = "tiny.en", *, second: str | None = None, language: str | None = None
) -> Recognizer:
    """The recogniser of an engine, steered by its grammar, with a second model for what it is unsure of.

    Args:
        engine: whose grammar steers.
        model: a name, or a folder.
        second: the same, or :data:`NONE`; None: base beside tiny and tiny.en, where it is installed.
        language: of the speech; None: that of the engine's only grammar, or detected.

    Raises:
        WeightsError: a model that was named cannot be found, or the first cannot be loaded.
    """
    first = SteeredWhisper(engine, model, language=language)
    other = second_model(model, second)
    if other is None:
        return first
    spoken = first.language if first.multilingual else "en"
    return SecondOpinion(engine, first, lambda: SteeredWhisper(engine, other, language=spoken))


def second_model(model: str, second: str | None = None) -> str | None:
    """The model beside a first one: as :func:`recognizer_for` was told, or as is installed; None: there is none.

    Raises:
        WeightsError: the one that was named cannot be found.
    """
    if second is not None:
        if second == NONE:
            return None
        find_weights(second)
        return second
    usual = SECOND.get(model)
    if usual is None:
        return None
    try:
        find_weights(usual, download=False)
    except WeightsError:
        return None
    return usual


def _beside(make: Callable[[], Recognizer]) -> Future[Recognizer]:
    """What is made in a thread of its own, at once."""
    pool = ThreadPoolExecutor(1, thread_name_prefix="second model")
    future = pool.submit(make)
    pool.shutdown(wait=False)
    return future
