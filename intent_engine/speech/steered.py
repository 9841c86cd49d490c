"""The models that are steered by a grammar: Whisper and Moonshine."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from intent_engine.speech.acoustic.moonshine import ScoringMoonshine
from intent_engine.speech.acoustic.scoring_whisper import ScoringWhisper
from intent_engine.speech.steering import Steering

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine

__all__ = ["SteeredMoonshine", "SteeredWhisper"]


class SteeredWhisper(Steering, ScoringWhisper):
    """Whisper as a recogniser for one engine's grammar.

    Args:
        engine: whose grammar steers; it may be reloaded at any time.
        model, device, compute_type, threads: as for :class:`~intent_engine.speech.acoustic.whisper.WhisperRecognizer`.
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
        self.steer(engine)


class SteeredMoonshine(Steering, ScoringMoonshine):
    """Moonshine as a recogniser for one engine's grammar, in English.

    Args:
        engine: whose grammar steers; it may be reloaded at any time.
        model, threads, tell: as for :class:`~intent_engine.speech.acoustic.moonshine.MoonshineRecognizer`.
    """

    def __init__(
        self,
        engine: IntentEngine,
        model: str = "moonshine-base",
        *,
        threads: int = 1,
        tell: Callable[[str], object] | None = None,
    ) -> None:
        super().__init__(model, threads=threads, tell=tell)
        self.steer(engine)
