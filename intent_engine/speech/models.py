"""Which models hear the commands of an engine: the first by its language, the second by what is installed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.moonshine_weights import (
    MOONSHINE,
    find_moonshine,
    find_moonshine_files,
    is_moonshine,
    moonshine_package,
)
from intent_engine.speech.recognizer import Recognizer
from intent_engine.speech.second_opinion import SecondOpinion
from intent_engine.speech.steered import SteeredMoonshine, SteeredWhisper
from intent_engine.speech.weights import find_weights, is_called, no_such_model, on_this_machine

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = [
    "ENGLISH",
    "FIRST",
    "NONE",
    "OTHER",
    "SECOND",
    "find_model",
    "installed_second",
    "recognizer_for",
    "second_model",
    "usual_model",
]

NONE = "none"
"""As a second model: none."""
ENGLISH = "tiny.en"
"""What English is heard with first,"""
OTHER = "base"
"""and every other language, and several at once."""
FIRST = ("tiny", ENGLISH)
"""Models beside which there is a second one without being asked for."""
SECOND = (MOONSHINE, "base")
"""The usual second models: the first that is installed. Moonshine knows English only."""


def usual_model(languages: Sequence[str], language: str | None = None) -> str:
    """The model that hears a language first, where none is named.

    Args:
        languages: of the grammars.
        language: of the speech; None: any of these.
    """
    return ENGLISH if (language or "".join(languages)) == "en" else OTHER


def recognizer_for(
    engine: IntentEngine,
    model: str | None = None,
    *,
    second: str | None = None,
    language: str | None = None,
    tell: Callable[[str], object] | None = None,
) -> Recognizer:
    """The recogniser of an engine, steered by its grammar, with a second model for what it is unsure of.

    Args:
        engine: whose grammar steers.
        model: a name, or a folder; None: :func:`usual_model`.
        second: the same, or :data:`NONE`; None: beside :data:`FIRST` the first of :data:`SECOND` that is
            installed.
        language: of the speech; None: that of the engine's only grammar, or detected.
        tell: is told what takes long: weights that are made ready, once on a machine.

    Raises:
        WeightsError: a model that was named cannot be found, or the first cannot be loaded.
    """
    model = model or usual_model(engine.languages, language)
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
        if not is_moonshine(second) and not is_called(second) and not on_this_machine(second):
            raise no_such_model(second, "--second-model", (NONE,))
        find_model(second)
        return second
    if model not in FIRST:
        return None
    english = model.endswith(".en") or (language or "".join(engine.languages)) == "en"
    return installed_second(english=english)


def find_model(model: str) -> None:
    """See that a model is on this machine, or fetch it; it is not loaded.

    Raises:
        WeightsError: it cannot be found.
    """
    if is_moonshine(model):
        find_moonshine_files(model)
    else:
        find_weights(model)


def installed_second(*, english: bool = True) -> str | None:
    """The usual second model on this machine, for English or for other languages."""
    return next((one for one in SECOND if _installed(one, english)), None)


def _installed(model: str, english: bool) -> bool:
    if is_moonshine(model):
        return english and moonshine_package() is not None
    return on_this_machine(model)


def _steered(
    engine: IntentEngine, model: str, language: str | None, tell: Callable[[str], object] | None = None
) -> SteeredWhisper | SteeredMoonshine:
    if is_moonshine(model):
        return SteeredMoonshine(engine, model, tell=tell)
    return SteeredWhisper(engine, model, language=language)
