"""The reflex stop: while somebody speaks, is the word being said a word that stops the robot?

A small Whisper is shown the last half second of sound every 64 ms and asked for one thing only: how likely the first
words are a stop phrase. It need not be likely, only far likelier than in any other speech: a stop word half said is
guessed at one in a hundred, other words below one in ten thousand. So "stop" is heard before it has ended, also after
other words, since in so short a window it soon comes first. The robot is then only *held*; the recogniser, which hears
the whole utterance, confirms the stop or releases the robot.
"""

from __future__ import annotations

import logging
import math
import threading
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from intent_engine.speech.acoustic.whisper import WhisperRecognizer, logits_row, max_length
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.beside import start_beside
from intent_engine.speech.stop_phrases import MoonshineStops, StopPhrases
from intent_engine.speech.weights import on_this_machine

if TYPE_CHECKING:
    from intent_engine.engine import IntentEngine
    from intent_engine.speech.acoustic.moonshine import MoonshineModel
    from intent_engine.speech.recognizer import Recognizer

__all__ = ["Reflex", "WhisperReflex", "reflex_for"]

THRESHOLD = 0.01
"""Probability of a stop phrase in one look above which the robot is held. Measured: docs/decisions/speech-reflex.md."""
AGREED = 1 / 3
"""Part of the threshold that is enough as the geometric mean of looks in a row: in noise no look is sure, but of other
words few are taken for a stop again and again."""
LOOKS = 3
"""Looks that must agree."""
LATER = 5.0
"""Times as likely it must be once an utterance has gone on: cut anywhere, words are guessed at more wildly."""
WINDOW_FRAMES = 16
"""Frames of sound that are looked at, half a second. In a second "stop" after other words was heard 200 ms later, since
those stood before it."""
INPUT_SECONDS = 1.0
"""Length of the encoder's input, which is what a look costs most."""
EVERY_FRAMES = 2
"""Frames between two looks."""
EARLY_FRAMES = 20
"""Frames after the onset in which the first word is being said, 0.64 s."""
LATER_FRAMES = 3
"""Frames between two looks after that."""
QUIET_FRAMES = 3
"""Frames without sound after which nothing new is to be heard. The "p" of "stop" is silent for shorter."""
QUIET = 0.03
"""RMS of such frames, as a part of the loudest frame's in the window: 30 dB below."""
MAX_LEADS = 80
"""Words before a stop that are known; more would only slow the start."""
MULTILINGUAL = ("tiny", "base")
"""Models for other languages than English: the first that is on this machine, else the first."""
OPEN_QUESTION = 0.005
"""Part of the threshold from which the second model is asked: of other words by people 3 in 5 looks."""


class Reflex(Protocol):
    """Listens for stop words in the stream. Fed every frame of an utterance, in order."""

    def begin(self, frames: Sequence[Samples]) -> None:
        """A new utterance begins, with this sound."""
        ...

    def heard(self, samples: Samples) -> bool:
        """Whether a stop word is being said, as of this frame."""
        ...

    def close(self) -> None:
        """Let go of model and thread. Idempotent."""
        ...


class WhisperReflex:
    """A Whisper model that only listens for stop phrases.

    Life cycle: made (model loaded) -> ``begin``, ``heard`` ... for each utterance -> ``close``. Used by one thread.

    Args:
        stop_phrases: what stops the robot.
        leads: what may stand before a stop of one word ("please", "robot").
        model: a name or a path; the smallest is the quickest, and good enough.
        device: as for :class:`~intent_engine.speech.acoustic.whisper.WhisperRecognizer`.
        language: of the phrases.
        background: look in a thread beside, so that listening never waits; False on a virtual clock, where the same
            sound must always give the same.
        threshold: probability in one look that holds the robot.
        second: another model, as soon as it is loaded, that is asked about a first word which may be a stop.

    Raises:
        WeightsError: the model cannot be found or loaded.
        ValueError: there is no stop phrase.
    """

    def __init__(
        self,
        stop_phrases: Iterable[Sequence[str]],
        leads: Iterable[str] = (),
        *,
        model: str = "tiny.en",
        device: str = "cpu",
        language: str | None = "en",
        background: bool = True,
        threshold: float = THRESHOLD,
        second: Future[MoonshineModel | None] | None = None,
    ) -> None:
        self._whisper = WhisperRecognizer(model, device=device, language=language, threads=1)
        self._threshold = threshold
        self._prompt = self._whisper.prompt()
        phrases = _shortest(stop_phrases)
        if not phrases:
            raise ValueError("no stop phrase")
        self.phrases = phrases
        self._leads = tuple(dict.fromkeys(leads))
        self._pieces = StopPhrases(phrases, self._leads, self._whisper.tokenizer().encode)
        self._second = second
        self._second_ears: MoonshineStops | None = None
        self._sound: deque[Samples] = deque(maxlen=WINDOW_FRAMES)
        self._whole: list[Samples] = []
        """All since the onset, as long as the first word is being said."""
        self._length = 0
        self._since = 0
        self._looked = 0
        self._evidence: deque[float] = deque(maxlen=LOOKS)
        self._worker = _Worker(self._look) if background else None

    def begin(self, frames: Sequence[Samples]) -> None:
        self._sound.clear()
        self._sound.extend(np.nan_to_num(samples, posinf=0.0, neginf=0.0) for samples in frames)
        self._whole = list(self._sound)
        self._length = 0
        self._since = EVERY_FRAMES
        self._looked = 0
        if self._worker is not None:
            self._worker.reset()

    def heard(self, samples: Samples) -> bool:
        self._sound.append(np.nan_to_num(samples, posinf=0.0, neginf=0.0))
        self._length += 1
        self._since += 1
        early = self._length <= EARLY_FRAMES
        if early:
            self._whole.append(self._sound[-1])
        due = self._since >= (EVERY_FRAMES if early else LATER_FRAMES) and not self._quiet()
        if not due:
            return self._worker is not None and self._worker.found
        view = _View(tuple(self._sound), self._looked == 0, tuple(self._whole) if early else ())
        if self._worker is None:
            found = self._look(view)
        elif self._worker.offer(view):
            found = self._worker.found
        else:
            return self._worker.found
        self._looked += 1
        self._since = 0
        return found

    def _quiet(self) -> bool:
        """Whether nothing has been said since before the last look; then there is nothing new to hear."""
        if self._looked < LOOKS:
            return False  # a word that the detector was late for is over, but has not been looked at
        levels = [float(np.sqrt(np.mean(np.square(samples)))) for samples in self._sound]
        return max(levels[-QUIET_FRAMES:]) <= QUIET * max(levels)

    def _look(self, view: _View) -> bool:
        """Whether this look, or the last few together, are enough."""
        if view.first:
            self._evidence.clear()
        found = self.probability(np.concatenate(view.frames))
        threshold = self._threshold * (1.0 if view.whole else LATER)
        if view.whole and threshold * OPEN_QUESTION <= found < threshold:
            second = self._asked_second()
            if second is not None:
                found = (found + second.probability(np.concatenate(view.whole))) / 2
        self._evidence.append(math.log(max(found, 1e-9)))
        together = len(self._evidence) == LOOKS and sum(self._evidence) / LOOKS >= math.log(threshold * AGREED)
        return found >= threshold or together

    def probability(self, samples: Samples) -> float:
        """How likely a stop phrase is being said, or has just been said, at the beginning of this sound."""
        if samples.size < SAMPLE_RATE // 10:
            return 0.0
        encoded = self._whisper.encode(samples, INPUT_SECONDS)
        return self._pieces.chance(lambda begun: self._next(encoded.features, begun), self._threshold * LATER)

    def _asked_second(self) -> MoonshineStops | None:
        """The second model; None: there is none, or it is not loaded yet."""
        ready = self._second is not None and (self._worker is None or self._second.done())
        if self._second is not None and ready:
            loaded = None if self._second.exception() else self._second.result()
            if loaded is not None:
                self._second_ears = MoonshineStops(loaded, self.phrases, self._leads)
            self._second = None
        return self._second_ears

    def _next(self, features: Any, begun: Sequence[int]) -> Any:
        """Probability of each token after a beginning, ``(tokens,)``."""
        told = [*self._prompt, *begun]
        result = self._whisper.engine.generate(
            features, [told], max_length=max_length(len(told), 1), beam_size=1, return_logits_vocab=True
        )[0]
        scores = logits_row(result.logits[0][0])
        scores = np.exp(scores - scores.max())
        return scores / scores.sum()

    def close(self) -> None:
        if self._worker is not None:
            self._worker.close()
        self._whisper.close()


@dataclass(frozen=True, slots=True)
class _View:
    """What one look is given."""

    frames: tuple[Samples, ...]
    first: bool
    """Of its utterance."""
    whole: tuple[Samples, ...]
    """All since the onset, if the utterance has only begun; else empty."""


class _Worker:
    """Looks in a thread of its own, always at the newest sound; what came while it was busy is passed over."""

    def __init__(self, look: Callable[[_View], bool]) -> None:
        self._look = look
        self._condition = threading.Condition()
        self._task: tuple[int, _View] | None = None
        self._utterance = 0
        self._failed = -1
        """The utterance in which it was last told that a look failed."""
        self._busy = False
        self._closed = False
        self.found = False
        """Whether a stop phrase was found in this utterance."""
        self._thread = start_beside(self._work, "reflex", self._end)

    def reset(self) -> None:
        with self._condition:
            self._utterance += 1
            if self._task is not None:
                self._task, self._busy = None, False
            self.found = False

    def offer(self, view: _View) -> bool:
        """Take this sound, unless still busy with older."""
        with self._condition:
            if self._busy or self._closed:
                return False
            self._task = (self._utterance, view)
            self._busy = True
            self._condition.notify_all()
            return True

    def _work(self) -> None:
        while True:
            with self._condition:
                self._condition.wait_for(lambda: self._closed or self._task is not None)
                if self._closed:
                    return
                task, self._task = self._task, None
            assert task is not None
            utterance, view = task
            try:
                found = self._look(view)
            except Exception:  # a reflex that fails must go on: the recogniser still hears the stop
                if self._failed != utterance:  # some fifteen looks a second would fail as the first
                    logging.getLogger(__name__).exception("the reflex could not look at the sound")
                self._failed, found = utterance, False
            with self._condition:
                self._busy = False
                if found and utterance == self._utterance:
                    self.found = True
                self._condition.notify_all()

    def close(self) -> None:
        self._end()
        self._thread.join(timeout=2.0)

    def _end(self) -> None:
        with self._condition:
            self._closed = True
            self._condition.notify()


def reflex_for(
    engine: IntentEngine,
    *,
    language: str | None = None,
    model: str | None = None,
    background: bool = True,
    beside: Recognizer | None = None,
) -> WhisperReflex:
    """The reflex of an engine: the stop phrases of its grammar, after any of its fillers and wake words.

    Args:
        engine: whose grammar.
        language: of the grammar; None: its first.
        model: None: tiny.en for English, for other languages tiny, or base where only that is on this machine.
        background: see :class:`WhisperReflex`.
        beside: the recogniser of the same robot; if its second model is Moonshine, the reflex asks that too.

    Raises:
        WeightsError: the model cannot be found or loaded.
    """
    from intent_engine.speech.second_opinion import SecondOpinion

    grammar = engine.matcher(language).grammar
    leads = [" ".join(words) for words in (*grammar.wake, *grammar.operators.correction, *grammar.fillers)]
    return WhisperReflex(
        grammar.operators.stop,
        leads[:MAX_LEADS],
        model=model or _usual_model(grammar.language),
        language=grammar.language,
        background=background,
        second=beside.second_weights() if isinstance(beside, SecondOpinion) and grammar.language == "en" else None,
    )


def _usual_model(language: str) -> str:
    """The smallest model of a language; a larger one, if it is there and that is not."""
    if language == "en":
        return "tiny.en"
    return next((model for model in MULTILINGUAL if on_this_machine(model)), MULTILINGUAL[0])


def _shortest(phrases: Iterable[Sequence[str]]) -> tuple[tuple[str, ...], ...]:
    """Phrases that begin with no other: "stop right there" is heard at "stop"."""
    known = {tuple(words) for words in phrases if words}
    return tuple(
        sorted(words for words in known if not any(words[:length] in known for length in range(1, len(words))))
    )
