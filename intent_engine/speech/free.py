"""A recogniser that hears freely, without the help of a grammar."""

from __future__ import annotations

from collections.abc import Callable

from intent_engine.speech.acoustic.moonshine import MoonshineRecognizer
from intent_engine.speech.acoustic.moonshine_weights import is_moonshine
from intent_engine.speech.acoustic.whisper import WhisperRecognizer
from intent_engine.speech.models import usual_model

__all__ = ["free_recognizer"]


def free_recognizer(
    model: str | None = None, *, language: str | None = "en", tell: Callable[[str], object] | None = None
) -> WhisperRecognizer | MoonshineRecognizer:
    """The recogniser of a model, Whisper or Moonshine.

    Args:
        model: a name, or a folder; None: :func:`~intent_engine.speech.models.usual_model` of the language.
        language: as for :class:`~intent_engine.speech.acoustic.whisper.WhisperRecognizer`; Moonshine knows English
            only.
        tell: is told what takes long: weights that are made ready, once on a machine.

    Raises:
        WeightsError: the model cannot be found or loaded.
    """
    model = model or usual_model((), language)
    if is_moonshine(model):
        return MoonshineRecognizer(model, tell=tell)
    return WhisperRecognizer(model, language=language)
