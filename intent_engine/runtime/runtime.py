"""Sound to robot: wires source, voice detector, endpoint, recogniser, engine and executor.

What it does with each frame, in this order: the reflex listens for a stop word and may hold the robot; the endpoint
decides whether an utterance began, paused or ended; at a pause what was said so far is decoded, to be ready; at the
end it is understood and carried out. Whatever fails on the way stops the robot and listening goes on.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Generator, Iterator
from typing import Any, Literal

from intent_engine.engine import IntentEngine
from intent_engine.execution.clock import SteppedClock
from intent_engine.execution.executor import Executor
from intent_engine.runtime.acting import Acting
from intent_engine.runtime.continuing import Continuing
from intent_engine.runtime.expectation import Expectation
from intent_engine.runtime.hands import Hands
from intent_engine.runtime.heard import Heard, HeardKind, Summary
from intent_engine.runtime.holding import Holding
from intent_engine.runtime.judgement import Judge
from intent_engine.runtime.last_asked import LastAsked
from intent_engine.runtime.onset import Onset
from intent_engine.runtime.parts import check_parts
from intent_engine.runtime.taking_up import TakingUp
from intent_engine.runtime.talk_key import TalkKey, same_voice
from intent_engine.speech.audio import FRAME_SECONDS, AudioSource, Frame, Wakeable, checked_frame
from intent_engine.speech.endpoint import Endpointer, Settings, Signal
from intent_engine.speech.recognizer import Recognizer
from intent_engine.speech.reflex import Reflex
from intent_engine.speech.rnnoise import NoiseFilter, installed_filter
from intent_engine.speech.spoken_utterance import SpokenUtterance
from intent_engine.speech.utterance_decoder import UtteranceDecoder
from intent_engine.speech.voice import SileroVoice, VoiceDetector

__all__ = ["Heard", "HeardKind", "Runtime", "Summary"]

SECOND_LOOK = 0.1
"""s of silence after which a draft is decoded again with all care: three of four sentences have no such pause."""
LAST_DECODE = 2.0
"""s that are given to a decode which is under way when listening ends, before it is left behind."""


class Runtime:
    """A whole robot that listens.

    Life cycle: made -> ``run(source)`` (blocks until the source ends or ``close()``; may be called again) ->
    ``close()``. Events come in the thread of ``run``. With an executor on a virtual clock a recording is played as fast
    as possible and always in the same way; else in its own time, with recognition in a thread beside.

    What ``on_event`` raises ends listening: the robot is stopped, the source let go, and the exception raised by
    ``run``, with a note that says so. An executor logs what its listeners raise and goes on, since they have threads of
    their own and nobody to raise to. Here somebody waits for ``run``, and a program whose own part of the work has
    failed, or that cannot tell any more what is going on, is to decide itself whether to listen again.

    Args:
        engine: understands.
        executor: acts. It is not closed with the runtime.
        recognizer: hears; None: Whisper tiny.en, steered by the engine's grammar, and base for what
            that is not sure of, where it is installed.
        voice: tells speech from silence; None: Silero.
        reflex: listens for stop words; None: no reflex.
        settings: waits of the endpoint.
        noise_filter: takes noise out of what is recognised; "auto": RNNoise, where it is installed; None: nothing does.
        on_event: is told everything, in order; what it raises stops the robot and ends listening.
        state: gives the states in which the robot is besides "moving", as the grammar's ``requires`` and ``excludes``
            name them. Asked, in the thread of ``run``, whenever it matters what words mean, so it is to answer at once;
            what it raises ends listening in the same way. Asked once more in the executor's thread, and under its lock,
            when what waited its turn begins; if it raises there, that is not done. None: the robot is in none of them.
        speculate: decode at the first silent frame already.
        patience: s after which a recogniser counts as hung.

    Raises:
        TypeError: one of them is not what it should be; says what is.
        ValueError: ``patience`` is no time.
    """

    def __init__(
        self,
        engine: IntentEngine,
        executor: Executor,
        recognizer: Recognizer | None = None,
        *,
        voice: VoiceDetector | None = None,
        reflex: Reflex | None = None,
        settings: Settings | None = None,
        noise_filter: NoiseFilter | Literal["auto"] | None = "auto",
        on_event: Callable[[Heard], object] | None = None,
        state: Callable[[], Collection[str]] | None = None,
        speculate: bool = True,
        patience: float = 10.0,
    ) -> None:
        if not hasattr(engine, "languages") or not hasattr(executor, "submit"):
            kinds = f"{type(engine).__name__} and {type(executor).__name__}"
            raise TypeError(f"Runtime takes an IntentEngine and then an Executor, not {kinds}")
        check_parts(
            settings,
            on_event,
            state,
            patience,
            recognizer=recognizer,
            voice=voice,
            reflex=reflex,
            noise_filter=noise_filter,
        )
        self.engine = engine
        self.executor = executor
        self._endpoint = Endpointer(settings)
        judge = Judge(engine)
        self._expectation = Expectation(judge)
        self._continuing = Continuing(judge, self._endpoint.settings.wait_continued)
        self.join_sentences()
        if recognizer is None:
            from intent_engine.speech.models import recognizer_for

            recognizer = recognizer_for(engine)
        self._stepped = isinstance(executor.clock, SteppedClock)
        self._decoding = UtteranceDecoder(recognizer, patience, stepped=self._stepped)
        self._voice = voice if voice is not None else SileroVoice()
        hands = Hands(executor, stepped=self._stepped)
        self._holding = Holding(reflex, executor, hands, self._tell)
        self._closing = threading.Event()
        self._asked = LastAsked(self._endpoint.settings.question_lasts)
        self._acting = Acting(
            executor,
            hands,
            judge,
            self._continuing,
            self._holding,
            self._tell,
            self._asked,
            state or tuple,
            over=self._closing.is_set,
        )
        self._taking_up = TakingUp(
            self._decoding,
            self._endpoint,
            self._expectation,
            self._continuing,
            self._acting,
            self._holding,
            self._tell,
            stepped=self._stepped,
            over=self._closing.is_set,
        )
        self._noise_filter = installed_filter() if noise_filter == "auto" else noise_filter
        self._on_event = on_event
        self._speculate = speculate
        self._listening: dict[str, object] = {}
        """``run``: the call that listens."""
        self._key = TalkKey()
        self._deaf = False
        self._onset = Onset(self._endpoint.settings, self._key)
        self._source: AudioSource | None = None
        self._base = 0.0

    # -- controls ----------------------------------------------------------------------------------

    def push_to_talk(self, on: bool = True) -> None:
        """Listen only while :meth:`talk` is on."""
        self._key.on = on

    def talk(self, pressed: bool) -> None:
        """The key of push-to-talk went down or up. From any thread."""
        self._key.press(pressed)

    def join_sentences(self, on: bool = True) -> None:
        """Whether what is said right after a motion may belong to it, as it may unless ``Settings.wait_continued`` is
        0. For a program that takes the interpretations of this runtime and cannot put right what it has begun."""
        self._continuing.on = on and self._endpoint.settings.wait_continued > 0

    def close(self) -> None:
        """End :meth:`run` and stop the robot, for good: a later ``run`` ends at once. Idempotent, from any thread."""
        self._closing.set()
        self._decoding.close()
        source = self._source
        if source is not None:
            source.close()
        self.executor.stop()

    # -- the loop ----------------------------------------------------------------------------------

    def run(self, source: AudioSource) -> Summary:
        """Listen until the source ends.

        Raises:
            AudioError: the source cannot be read; the robot is stopped.
            DeviceError: the device is missing; the robot is stopped.
            BaseException: whatever ``on_event`` or ``state`` raised; the robot is stopped.
            TypeError: ``source`` is none; a path is not. Or it gives something else than frames; the robot is stopped.
            RuntimeError: it listens already, to another source or in the listener that calls this.
        """
        if not hasattr(source, "frames"):
            raise TypeError(f"run takes a source of sound, not {source!r}: FileSource(path), Microphone() or another")
        call, finished = object(), False
        frames: Iterator[Frame] = iter(())
        unsubscribe: Callable[[], None] | None = None
        try:  # from here on, whenever Ctrl-C comes
            if self._listening.setdefault("run", call) is not call:
                raise RuntimeError(
                    "this runtime listens already, and hears one source at a time: wait for its run() to end, or make "
                    "another Runtime"
                )
            unsubscribe = self.executor.subscribe(self._asked.happened)
            self._begin(source)
            # Who closed it before the source was known has not closed that, which may give its first frame late.
            if not self._closing.is_set():
                frames = source.frames()
            self._listen(frames)
            finished = True
        finally:
            if self._listening.get("run") is call:
                try:
                    self._leave(frames, unsubscribe, finished)
                finally:
                    del self._listening["run"]
        return self._acting.summary

    def _listen(self, frames: Iterator[Frame]) -> None:
        """To the end of the sound."""
        utterance: SpokenUtterance | None = None
        for given in frames:
            if self._closing.is_set():
                break
            frame = checked_frame(given)
            self._move_clock(frame.time)
            if frame.samples.size:  # else it was woken by a decode that has ended
                if frame.lost or frame.deaf or (frame.cut and utterance and not self._endpoint.silence):
                    self._gap(frame, utterance)
                    utterance = None
                self._taking_up.collect(frame.time, utterance)  # the endpoint decides by what is known now
                if not frame.deaf:
                    self._deaf = False
                    utterance = self._frame(frame, utterance)
                self._acting.summary.seconds = frame.time
            self._taking_up.collect(frame.time, utterance)
            if utterance is not None and self._over(self._endpoint.due(), frame.time, utterance):
                utterance = None
        if not self._closing.is_set():
            if utterance is not None:
                self._break_off(utterance, self._acting.summary.seconds)
            self._taking_up.drain()
            self._holding.release(self._acting.summary.seconds, "the sound ended")

    def _leave(self, frames: Iterator[Frame], unsubscribe: Callable[[], None] | None, finished: bool) -> None:
        """Let go of what :meth:`run` has taken; the robot is stopped where it was broken off."""
        if not finished or self._closing.is_set():
            self.executor.stop()
        if unsubscribe is not None:
            unsubscribe()
        self._source = None
        if not finished or self._closing.is_set():
            self._decoding.leave()
            if isinstance(frames, Generator):  # who holds the exception would hold the device open, too
                frames.close()
        # A thread that is still inside the model when the interpreter ends would abort the process.
        self._decoding.settle(LAST_DECODE)

    def _begin(self, source: AudioSource) -> None:
        """Forget what an earlier source has left."""
        self._source = source
        self._base = self.executor.clock.now()
        self._voice.reset()
        self._endpoint.reset()
        self._acting.begin(self._base)
        self._deaf = False
        self._onset.reset()
        self._key.reset()
        self._decoding.begin_source()
        self._decoding.on_end = source.wake if isinstance(source, Wakeable) and not self._stepped else None
        self._taking_up.forget()

    def _move_clock(self, time: float) -> None:
        if self._stepped:
            self.executor.clock.advance_to(self._base + time)  # type: ignore[attr-defined]

    def _frame(self, frame: Frame, utterance: SpokenUtterance | None) -> SpokenUtterance | None:
        probability = self._voice.probability(frame.samples)
        if self._key.up:
            if utterance is not None:
                self._key.let_go(frame.time)
                self._break_off(utterance, frame.time)
            self._endpoint.reset()
            self._onset.pass_over()
            self._key.pass_over(frame.samples, frame.time, voice=probability >= self._endpoint.settings.onset)
            return None
        signal = self._endpoint.frame(probability)
        self._onset.take(frame.samples)
        if signal is Signal.STARTED:
            utterance = self._onset.begin(frame.time)
            if self._noise_filter is not None:
                utterance.filtered = self._noise_filter.begin(utterance.frames)
            self._holding.begin(self._onset.recent, frame.time)
            self._tell(HeardKind.SPEECH, frame.time)
            return utterance
        if utterance is None:
            return None
        utterance.take(frame.samples)
        self._holding.listen(frame.samples, frame.time)
        if self._endpoint.silence == 0 and self._endpoint.speaking:
            utterance.voiced(frame.time)
        if signal is Signal.PAUSED and utterance.glance and self._endpoint.faded_long:
            self._taking_up.outdated(utterance, frame.time)
        if signal is Signal.FADING and self._speculate:
            self._decoding.look(utterance)
        elif signal is Signal.RESUMED:
            self._taking_up.outdated(utterance, frame.time)
        elif self._over(signal, frame.time, utterance):
            return None
        elif self._speculate and self._endpoint.silence and utterance.job is None:
            self._decoding.decode(utterance, final=False)
        elif utterance.draft and self._endpoint.silence + FRAME_SECONDS / 2 >= SECOND_LOOK:
            self._decoding.decode(utterance, final=True)
        elif self._speculate and utterance.job is None and (heard := self._decoding.follow(utterance)):
            if self._expectation.begins_nothing(heard):
                self._decoding.rest()
            self._tell(HeardKind.PARTIAL, frame.time, transcript=heard)
        return utterance

    def _over(self, signal: Signal, time: float, utterance: SpokenUtterance) -> bool:
        """End an utterance, if the signal says so."""
        if signal not in (Signal.ENDED, Signal.SHORT, Signal.CUT):
            return False
        utterance.short = signal is Signal.SHORT
        self._onset.over(utterance, time)
        self._end(utterance, time)
        if signal is Signal.CUT:
            self._onset.lost(time)
        return True

    def _break_off(self, utterance: SpokenUtterance, time: float) -> None:
        """End an utterance before it is known to be over, which makes it no longer than it was."""
        utterance.short = self._endpoint.short
        self._end(utterance, time)

    def _gap(self, frame: Frame, utterance: SpokenUtterance | None) -> None:
        """Sound is missing, and a "don't" may be what is missing: the utterance under way is not acted on.

        While no sound comes at all, nobody could stop the robot, so it is stopped.
        """
        self._onset.lost(frame.time)
        self._endpoint.reset()
        self._voice.reset()
        self._continuing.forget()
        self._asked.forget()  # a "no" may be what is missing
        if utterance is not None:
            self._decoding.forget(utterance)
        missing = f"{frame.lost:.2f} s of sound were lost" if frame.lost else "the sound ended in the midst of a word"
        if frame.deaf:
            if not self._deaf:
                self._deaf = True
                self._taking_up.forget()
                self._acting.failed(frame.time, "no sound comes, and a robot that nobody can stop must not move")
        elif utterance is not None and self._holding.on:
            self._acting.failed(frame.time, f"{missing} while a stop word was being said")
        elif utterance is not None:
            why = f"{missing}, so what was being said is not acted on"
            self._acting.summary.lost += 1
            self._tell(HeardKind.LOST, frame.time, detail=why)

    def _end(self, utterance: SpokenUtterance, time: float) -> None:
        """The utterance is over."""
        utterance.ended = True
        self._onset.keep(utterance)
        utterance.torn = utterance.torn or same_voice(utterance.passed_over, utterance.frames)
        self._taking_up.ended(utterance, time)

    def _tell(self, kind: HeardKind, time: float, /, **details: Any) -> None:
        if self._on_event is None:
            return
        try:
            self._on_event(Heard(kind, time, **details))
        except Exception as error:
            error.add_note(f"raised by on_event, told of {kind.value!r}; the robot is stopped and listening has ended")
            raise
