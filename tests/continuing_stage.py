"""Commands with pauses in them, and a recogniser that is told what it hears."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from meanings import shipped
from speech_stage import Frames, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.goal import GoalState
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

ENGINE = shipped()


class Script:
    """A recogniser that is told what is heard in sounds of what length: the second utterance by itself is shorter than
    both together."""

    def __init__(
        self, first: str, second: str, together: str, score: float = 0.0, confidence: float | None = None
    ) -> None:
        self._texts = {"first": first, "second": second, "together": together}
        self._score = score
        self._confidence = confidence
        """Of the second."""
        self.asked: list[str] = []

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        seconds = samples.size / SAMPLE_RATE
        which = "first" if not self.asked or seconds < 1.0 else "together" if seconds > 2.0 else "second"
        self.asked.append(which)
        text = self._texts[which]
        confidence = self._confidence if which == "second" else None
        return Transcript(text, self._score, text, gap=0.0, confidence=confidence)

    def close(self) -> None: ...


class Said:
    """Two utterances, of 0.4 s and 0.9 s, and what came of them."""

    def __init__(
        self,
        script: Script,
        pause: float = 0.6,
        engine: IntentEngine = ENGINE,
        lost: float = 0.0,
        joined: bool = True,
        **options: object,
    ) -> None:
        begin = 0.9 + pause
        clock = VirtualClock()
        self.robot = SimulatedRobot(clock)
        self.events: list[Heard] = []
        self.orders: list[dict[str, object]] = []
        with Executor(self.robot, clock=clock) as executor:
            executor.register("order_drink", lambda action: self.orders.append(dict(action.slots)))
            runtime = Runtime(
                engine,
                executor,
                script,
                noise_filter=None,
                on_event=lambda event: self._heard(event, runtime, joined),
                **{"voice": Voiced((0.5, 0.9), (begin, begin + 0.9)), **options},
            )
            frames = framed(np.zeros(int((begin + 3.0) * SAMPLE_RATE), np.float32))
            between = next(at for at, frame in enumerate(frames) if frame.time > begin - 0.1)
            frames[between] = replace(frames[between], lost=lost)
            runtime.run(Frames(frames))
            executor.wait()
            self.pose = self.robot.pose()
            assert executor.snapshot().velocity == (0.0, 0.0)

    def _heard(self, event: Heard, runtime: Runtime, joined: bool) -> None:
        self.events.append(event)
        if event.kind is HeardKind.SPEECH:
            runtime.join_sentences(joined)

    @property
    def done(self) -> list[Heard]:
        return [event for event in self.events if event.kind is HeardKind.SUBMITTED]

    @property
    def goals(self) -> list[GoalState]:
        return [goal.state for event in self.done for goal in event.goals]


class Parts:
    """A recogniser that hears what it is told, one decode after the other."""

    def __init__(self, *texts: str) -> None:
        self._texts = list(texts)

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        text = self._texts.pop(0) if self._texts else ""
        return Transcript(text, -0.3, text, gap=0.0)

    def close(self) -> None: ...


class SaidInParts:
    """Three short utterances, and what came of them."""

    def __init__(self, *texts: str, begins: tuple[float, ...] = (0.5, 1.5, 2.5)) -> None:
        clock = VirtualClock()
        robot = SimulatedRobot(clock)
        self.events: list[Heard] = []
        recognizer = Parts(*texts)
        with Executor(robot, clock=clock) as executor:
            voice = Voiced(*((begin, begin + 0.4) for begin in begins))
            runtime = Runtime(ENGINE, executor, recognizer, voice=voice, noise_filter=None, on_event=self.events.append)
            runtime.run(Frames(framed(np.zeros(5 * SAMPLE_RATE, np.float32))))
            executor.wait()
            self.pose = robot.pose()

    @property
    def goals(self) -> list[GoalState]:
        return [goal.state for event in self.events if event.kind is HeardKind.SUBMITTED for goal in event.goals]


class Knows:
    """A recogniser that knows each utterance by its loudness, and hears several in one sound together."""

    def __init__(self, *texts: str) -> None:
        self._texts = texts

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        loud = sorted({round(float(one) * 1000) for one in np.unique(np.round(samples, 3))} - {0})
        text = ", ".join(self._texts[one - 1] for one in loud)
        return Transcript(text, 0.0, text, gap=0.0)

    def close(self) -> None: ...


class Talk:
    """Any number of utterances of 0.8 s, and what each of them gave the robot to do.

    Args:
        pause: s between two.
    """

    def __init__(self, *texts: str, engine: IntentEngine = ENGINE, pause: float = 0.8) -> None:
        begins = [0.5 + at * (0.8 + pause) for at in range(len(texts))]
        samples = np.zeros(int((begins[-1] + 4.0) * SAMPLE_RATE), np.float32)
        for at, begin in enumerate(begins, 1):
            samples[int((begin + 0.1) * SAMPLE_RATE) : int((begin + 0.7) * SAMPLE_RATE)] = at / 1000
        clock = VirtualClock()
        self.events: list[Heard] = []
        with Executor(SimulatedRobot(clock), clock=clock) as executor:
            voice = Voiced(*((begin, begin + 0.8) for begin in begins))
            runtime = Runtime(
                engine, executor, Knows(*texts), voice=voice, noise_filter=None, on_event=self.events.append
            )
            runtime.run(Frames(framed(samples)))
            executor.wait()

    @property
    def done(self) -> list[Heard]:
        return [event for event in self.events if event.kind is HeardKind.SUBMITTED]

    @property
    def last(self) -> Heard:
        """What the last utterance meant."""
        return [event for event in self.events if event.kind is HeardKind.INTERPRETATION][-1]
