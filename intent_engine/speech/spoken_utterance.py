"""The sound of one utterance, while it is being said, and what the recogniser makes of it."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import dataclass

import numpy as np

from intent_engine.speech.audio import FRAME_SAMPLES, FRAME_SECONDS, Samples
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.rnnoise import FilteredSpeech

__all__ = ["SpokenUtterance"]

KEPT_SILENCE = 3
"""Frames after the last one of speech: the end of a word is often taken for silence."""


@dataclass(slots=True)
class SpokenUtterance:
    """The sound of one utterance, and its decode.

    Life cycle: begun -> it takes frames; at a pause it is decoded, and what was decoded is forgotten if somebody
    speaks on -> ended -> its last decode is acted on.
    """

    frames: list[Samples]
    began: float
    """s since the source began"""
    last_voice: float
    """s since the source began: the last frame of speech."""
    torn: bool = False
    """Whether it may be the rest of a sentence, of which sound was lost."""
    passed_over: float = 0.0
    """Loudness, a mean square, of a voice right before it that was not heard, as the key was up; 0: there was none."""
    silent: int = 0
    """Frames since then."""
    filtered: FilteredSpeech | None = None
    job: Future[Transcript] | None = None
    final: bool = False
    """Whether the decode is one with all care."""
    glance: bool = False
    """Whether it is no more than a glance, while the voice faded."""
    ended: bool = False
    over_at: float = 0.0
    """s on the machine's clock: when it was over."""
    short: bool = False
    """Whether it was so short that it can be nothing but a stop."""
    judged: bool = False
    result: Transcript | None = None
    called: bool = False
    """Whether nothing was said but the wake word."""
    before: Samples | None = None
    """The sound of the command that it may go on from, when it is heard together with that."""
    alone: Transcript | None = None
    """What it was by itself, then."""

    @property
    def draft(self) -> bool:
        """Whether it was decoded, and the recogniser would hear it better with more care."""
        return self.result is not None and self.result.draft and not self.final

    @property
    def now(self) -> float:
        """s since the source began: its last frame."""
        return self.last_voice + self.silent * FRAME_SECONDS

    def take(self, samples: Samples) -> None:
        """One frame more."""
        self.silent += 1
        self.frames.append(samples)
        if self.filtered is not None:
            self.filtered.add(samples)

    def sound(self) -> Samples:
        """What is to be decoded."""
        said = self.filtered.sound() if self.filtered is not None else np.concatenate(self.frames)
        return said if self.before is None else np.concatenate((self.before, said))

    def voiced(self, time: float) -> None:
        """The last frame, at ``time`` s, was speech."""
        self.last_voice, self.silent = time, 0

    def said(self) -> Samples:
        """What is to be decoded, without most of the silence after it."""
        silence = max(self.silent - KEPT_SILENCE, 0) * FRAME_SAMPLES
        sound = self.sound()
        return sound[: sound.size - silence]

    def voice(self) -> list[Samples]:
        """Its frames, without most of the silence after it."""
        return self.frames[: len(self.frames) - max(self.silent - KEPT_SILENCE, 0)]

    def decoding(self, job: Future[Transcript], *, final: bool, glance: bool = False) -> None:
        """It is being decoded."""
        self.job, self.result, self.judged = job, None, False
        self.final, self.glance = final, glance

    def speaks_on(self) -> None:
        """What was decoded is out of date."""
        self.job, self.result, self.judged, self.glance = None, None, False, False
        self.called = False
        self.before, self.alone = None, None

    def together_with(self, before: Samples) -> None:
        """Hear it anew, together with the sound of the command before."""
        self.alone, self.before = self.result, before
        self.job, self.result, self.judged = None, None, False
