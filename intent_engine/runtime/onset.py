"""What an utterance begins with: the last sounds before it, the wake word said just before, and what it may lack."""

from __future__ import annotations

from collections import deque

from intent_engine.runtime.talk_key import TalkKey
from intent_engine.speech.audio import FRAME_SECONDS, Samples
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.spoken_utterance import SpokenUtterance

__all__ = ["Onset"]

TORN = 0.5
"""s after a gap in the sound, within which begins what may be the rest of a sentence."""


class Onset:
    """What was heard, and not heard, right before somebody speaks.

    Args:
        settings: waits of the endpoint.
        key: of push-to-talk.
    """

    def __init__(self, settings: Settings, key: TalkKey) -> None:
        self._key = key
        self._wake_lasts = settings.wake_lasts
        self._recent: deque[Samples] = deque(maxlen=int(settings.pre_roll / FRAME_SECONDS) + 2)
        self._called: SpokenUtterance | None = None
        """In which nothing but the wake word was said, right before what is said now."""
        self._torn = -1.0
        """s since the source began: until when what begins may be the rest of a sentence of which sound was lost."""

    def reset(self) -> None:
        """A source begins."""
        self._recent.clear()
        self._called = None
        self._torn = -1.0

    @property
    def recent(self) -> list[Samples]:
        """The last sounds, with which an utterance may have begun."""
        return list(self._recent)

    def take(self, samples: Samples) -> None:
        """One frame more."""
        self._recent.append(samples)

    def pass_over(self) -> None:
        """A frame is not heard, since the key is up."""
        self._recent.clear()

    def lost(self, time: float) -> None:
        """Sound is missing up to ``time``, or belongs to what was said before: a "don't" may be in it."""
        self._recent.clear()
        self._called = None
        self._torn = time + TORN

    def begin(self, time: float) -> SpokenUtterance:
        """The utterance that begins: with a little of the sound before it, and with the wake word, if that was all that
        was said just before."""
        called, self._called = self._called, None
        late = called is None or time - called.last_voice > self._wake_lasts
        frames = self.recent if called is None or late else [*called.voice(), *self._recent]
        utterance = SpokenUtterance(frames, time, time, torn=time <= self._torn)
        utterance.passed_over = self._key.late(time)
        return utterance

    def over(self, utterance: SpokenUtterance, time: float) -> None:
        """An utterance is over. What was said already is no part of what follows: "turn left" would be done, and then
        "left"."""
        silent = round((time - utterance.last_voice) / FRAME_SECONDS)
        for _ in range(0 if utterance.short else len(self._recent) - silent):
            self._recent.popleft()

    def keep(self, utterance: SpokenUtterance) -> None:
        """Keep the wake word, if an utterance that has ended is nothing else."""
        self._called = utterance if utterance.called and not utterance.torn else None
