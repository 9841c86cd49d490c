"""One recording through the runtime, as ``run`` does it: what was heard, what would be done, and when."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import Literal

from intent_engine.actions import Action
from intent_engine.engine import IntentEngine
from intent_engine.execution.clock import Clock, VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.robots.robot import Pose
from intent_engine.execution.robots.robot_file import RobotFile
from intent_engine.execution.showing import show_own_actions
from intent_engine.interpretation import Interpretation
from intent_engine.language.utterance import plain
from intent_engine.runtime.heard import Heard, HeardKind
from intent_engine.runtime.runtime import Runtime
from intent_engine.speech.audio import FRAME_SECONDS, AudioSource, Samples
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.leaving import Leavable
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.reflex import Reflex
from intent_engine.speech.rnnoise import NoiseFilter
from intent_engine.speech.voice import SileroVoice, VoiceDetector

__all__ = ["Act", "Hearing", "Listener"]

LEAVES = 0.05
"""s after which a decode that is left has ended, as nine of ten do (half within 13 ms)."""


@dataclass(frozen=True, slots=True)
class Act:
    """An utterance that was acted on."""

    meaning: Interpretation
    time: float
    """s since the sound began: when it was acted on, decoding included."""
    speech_ended: float
    """s since the sound began: the last frame that the voice detector took for speech."""


@dataclass(slots=True)
class Hearing:
    """What came of one recording."""

    texts: list[str] = field(default_factory=list)
    """What was taken to be said, utterance by utterance."""
    free_texts: list[str] = field(default_factory=list)
    """The same without the help of the grammar."""
    transcripts: list[Transcript] = field(default_factory=list)
    """All that the recogniser made of each."""
    meanings: list[Interpretation] = field(default_factory=list)
    acts: list[Act] = field(default_factory=list)
    decodes: list[float] = field(default_factory=list)
    """s that each decode took."""
    holds: list[float] = field(default_factory=list)
    """s since the sound began: when the reflex held the robot."""
    errors: list[str] = field(default_factory=list)

    @property
    def actions(self) -> tuple[Action, ...]:
        """Everything that was done."""
        return tuple(action for act in self.acts for action in act.meaning.actions)


class Listener:
    """Plays recordings to a robot of its own: each to a fresh one, on a virtual clock, as fast as it goes.

    The virtual clock stands still while the recogniser decodes. In an act's time it does not: the decode began when it
    was asked for, or the one before had ended or been left, and its result is taken up at once, as that of a live
    source is.

    Args:
        engine: understands.
        recognizer: hears.
        robot: what to simulate.
        settings: waits of the endpoint; None: the runtime's own.
        speculate: decode at the first silent frame already.
        reflex: listens for stop words, in the thread that it is called from; None: no reflex.
        noise_filter: as for :class:`~intent_engine.runtime.Runtime`.
        states: in which the robot is all the time, besides moving.
    """

    def __init__(
        self,
        engine: IntentEngine,
        recognizer: Recognizer,
        robot: RobotFile,
        *,
        voice: VoiceDetector | None = None,
        settings: Settings | None = None,
        speculate: bool = True,
        reflex: Reflex | None = None,
        noise_filter: NoiseFilter | Literal["auto"] | None = "auto",
        states: Collection[str] = (),
    ) -> None:
        self._engine = engine
        self._recognizer = recognizer
        self._robot = robot
        self._voice = voice or SileroVoice()
        self._settings = settings
        self._speculate = speculate
        self._reflex = _Timed(reflex) if reflex is not None else None
        self._noise_filter: NoiseFilter | Literal["auto"] | None = noise_filter
        self._states = states
        self._places = {
            name: Pose(place.x, place.y, place.yaw, place.frame) for name, place in (engine.locations or {}).items()
        }

    def hear(self, source: AudioSource) -> Hearing:
        """Play one recording.

        Raises:
            AudioError: it cannot be read.
        """
        notes = _Notes(self._reflex, leaves=isinstance(self._recognizer, Leavable))
        self.play(source, VirtualClock(), notes.take)
        return notes.hearing

    def play(self, source: AudioSource, clock: Clock, tell: Callable[[Heard], object]) -> None:
        """Play a sound on any clock: on the machine's own it takes as long as it is.

        Args:
            source: of the sound.
            clock: of the robot.
            tell: is told all that is heard.

        Raises:
            AudioError: it cannot be read.
        """
        robot = self._robot.simulated(clock, self._places)
        options = self._robot.executor_options()
        with Executor(robot, clock=clock, handle_sigterm=False, **options) as executor:
            runtime = Runtime(
                self._engine,
                executor,
                self._recognizer,
                voice=self._voice,
                reflex=self._reflex,
                settings=self._settings,
                noise_filter=self._noise_filter,
                speculate=self._speculate,
                on_event=tell,
                state=lambda: self._states,
            )
            show_own_actions(executor)  # whoever has a grammar of his own carries its actions out
            runtime.run(source)


class _Timed:
    """A reflex whose looks are timed."""

    def __init__(self, reflex: Reflex) -> None:
        self._reflex = reflex
        self.seconds = 0.0
        """s that the last look took."""

    def begin(self, frames: Sequence[Samples]) -> None:
        self._reflex.begin(frames)

    def heard(self, samples: Samples) -> bool:
        began = time.perf_counter()
        found = self._reflex.heard(samples)
        self.seconds = time.perf_counter() - began
        return found

    def close(self) -> None:
        self._reflex.close()


def _next_frame(time: float) -> float:
    """When something that is ready at this time is looked at."""
    return math.ceil(time / FRAME_SECONDS - 1e-6) * FRAME_SECONDS


class _Notes:
    """Listens to the runtime's events."""

    def __init__(self, reflex: _Timed | None, *, leaves: bool) -> None:
        self.hearing = Hearing()
        self._reflex = reflex
        self._leaves = leaves
        """Whether a decode is left when somebody speaks on."""
        self._began = 0.0
        """s: when the recogniser began the last decode,"""
        self._busy = 0.0
        """and until when it decodes."""
        self._places: list[int] = []
        """Of each act, among the texts."""
        self._partial: Transcript | None = None
        self._ready = 0.0
        """s: when the transcript is there, in real time."""

    def take(self, event: Heard) -> None:
        if event.kind is HeardKind.PARTIAL and event.transcript is not None and event.speech_ended is not None:
            self._decoded(event.transcript, event.time)
            self._partial = event.transcript
        elif event.kind is HeardKind.OUTDATED and self._leaves:
            self._busy = min(self._busy, max(self._began, event.time) + LEAVES)
        elif event.kind is HeardKind.TRANSCRIPT and event.transcript is not None:
            if not self._known(event.transcript):
                self._decoded(event.transcript, event.time)
            self.hearing.free_texts.append(event.transcript.free_text or event.transcript.text)
            self.hearing.transcripts.append(event.transcript)
        elif event.kind is HeardKind.INTERPRETATION and event.interpretation is not None:
            # Its text is what was heard after all, where the grammar had steered the recogniser too far from the sound.
            if event.goes_on:
                self._drop_texts(self._begun(event.interpretation))
            self.hearing.texts.append(event.interpretation.text)
            self.hearing.meanings.append(event.interpretation)
        elif event.kind is HeardKind.SUBMITTED and event.interpretation is not None:
            ended = event.speech_ended if event.speech_ended is not None else event.time
            if event.goes_on:  # what is done counts, and when all of it was
                begun = self._begun(event.interpretation)
                del self.hearing.acts[begun:], self._places[begun:]
            self._places.append(len(self.hearing.texts) - 1)
            self.hearing.acts.append(Act(event.interpretation, max(event.time, self._ready), ended))
        elif event.kind is HeardKind.HOLD:
            look = self._reflex.seconds if self._reflex is not None else 0.0
            self.hearing.holds.append(_next_frame(event.time + look))
        elif event.kind is HeardKind.ERROR:
            self.hearing.errors.append(event.detail)

    def _known(self, transcript: Transcript) -> bool:
        """Whether what is told is what was told of in part, perhaps with the words heard freely for its text."""
        if self._partial is None or transcript is self._partial:
            return transcript is self._partial
        return transcript == self._partial.as_heard() != self._partial

    def _begun(self, whole: Interpretation) -> int:
        """Which act the whole of a command goes on from: the last that it begins with, as after "no, wait!", or else
        the last."""
        words = plain(whole.text)
        texts = [plain(act.meaning.text) for act in self.hearing.acts]
        found = [index for index, text in enumerate(texts) if words[: len(text)] == text]
        return found[-1] if found else max(len(texts) - 1, 0)

    def _drop_texts(self, begun: int) -> None:
        """Leave out what was heard since an act began, that included: it was heard anew, all in one. What the whole was
        decoded as is there already."""
        at = self._places[begun] if begun < len(self._places) else len(self.hearing.texts)
        del self.hearing.texts[at:], self.hearing.meanings[at:]
        del self.hearing.free_texts[at:-1], self.hearing.transcripts[at:-1]

    def _decoded(self, transcript: Transcript, asked: float) -> None:
        self._began = max(asked, self._busy)
        self._busy = self._began + transcript.decode_seconds
        self._ready = self._busy
        self.hearing.decodes.append(transcript.decode_seconds)
