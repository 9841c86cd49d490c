"""Everything at once: speech that is joined, corrected, refused or lost, typed text, stops, holds, the key of
push-to-talk, states that change and a robot that fails, in every order on a virtual clock; and the laws that hold."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine import Executor, IntentEngine, Runtime
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.events import Event, EventKind
from intent_engine.execution.limits import Limits
from intent_engine.interpretation import Status
from intent_engine.runtime.heard import Heard, HeardKind
from intent_engine.speech.audio import FRAME_SAMPLES, FRAME_SECONDS, Frame
from intent_engine.speech.recognizer import Transcript

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "execution"))

from execution_stage import MAP, FailingRobot  # noqa: E402

GRAMMAR = f"""
language: en
include: [{ROOT / "grammars" / "en.yaml"}]
intents:
  beep: {{action: custom, sentences: [beep]}}
  undock: {{action: custom, requires: [docked], sentences: [undock yourself]}}
  hatch: {{action: custom, excludes: [docked], sentences: [open the hatch]}}
"""
SAID = (
    "go forward two meters",
    "turn left",
    "ninety degrees",
    "no, right",
    "and then beep",
    "go to the kitchen, then open the hatch and beep",
    "when you get there, undock yourself",
    "undock yourself",
    "open the hatch",
    "beep",
    "don't beep",
    "stop",
    "no, wait",
    "going forward",
    "what lovely weather",
    "",
)
said = st.sampled_from(SAID)
lasting = st.sampled_from([0.2, 0.4, 0.9])
steps = st.one_of(
    st.tuples(st.just("say"), said, lasting, st.booleans()),
    st.tuples(st.just("say"), said, lasting, st.booleans()),
    st.tuples(st.just("wait"), st.sampled_from([0.1, 0.3, 0.6, 1.0, 4.0, 12.0])),
    st.tuples(st.just("type"), said),
    st.tuples(st.sampled_from(["stop", "estop", "hold", "release", "pause", "resume"])),
    st.tuples(st.just("states"), st.sampled_from([(), ("docked",)])),
    st.tuples(st.just("push"), st.booleans()),
    st.tuples(st.just("talk"), st.booleans()),
    st.tuples(st.just("robot fails"), st.integers(0, 9)),
    st.tuples(st.sampled_from(["lost", "deaf"])),
)


class Ears:
    """A recogniser and a voice detector for frames that hold nothing but the number of their utterance."""

    def __init__(self, texts: list[str]) -> None:
        self._texts = texts

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        numbers = dict.fromkeys(np.rint(samples[samples > 0] * 1000).astype(int).tolist())
        text = ", ".join(filter(None, (self._texts[number - 1] for number in numbers)))
        return Transcript(text, free_text=text, gap=0.0)

    def probability(self, samples: np.ndarray) -> float:
        return float(samples.max() > 0)

    def reset(self) -> None: ...

    def close(self) -> None: ...


class Jumpy:
    """A reflex that hears a stop word in some utterances."""

    def __init__(self) -> None:
        self.numbers: set[int] = set()

    def begin(self, frames: object) -> None: ...

    def heard(self, samples: np.ndarray) -> bool:
        return round(float(samples.max()) * 1000) in self.numbers

    def close(self) -> None: ...


class Session:
    """A session that plays its steps, and is its own source of sound."""

    def __init__(self, engine: IntentEngine, plan: list[tuple], speculate: bool, ramps: bool, closes: bool) -> None:
        self.engine, self.plan, self.closes = engine, plan, closes
        self.clock = VirtualClock()
        self.robot = FailingRobot(self.clock, locations=MAP)
        self.texts: list[str] = []
        self.states: tuple[str, ...] = ()
        self.heard: list[Heard] = []
        self.events: list[Event] = []
        self.typed: list = []
        self.did: list[str] = []
        self.forbidden: list[str] = []
        self.frame = 0
        limits = Limits(linear_acceleration=0.8, angular_acceleration=1.6) if ramps else None
        self.reflex = Jumpy()
        ears = Ears(self.texts)
        self.executor = Executor(self.robot, limits, on_event=self.events.append, handle_sigterm=False)
        self.executor.register("custom", self.do)
        self.runtime = Runtime(
            engine,
            self.executor,
            ears,
            voice=ears,
            reflex=self.reflex,
            noise_filter=None,
            on_event=self.listen,
            state=lambda: self.states,
            speculate=speculate,
        )

    def run(self) -> None:
        self.runtime.run(self)
        if self.closes:
            self.close_all()
        else:
            self.executor.release()
            self.executor.resume()
            self.executor.run_until_idle()
            assert self.executor.idle
            assert self.robot.speed() == (0.0, 0.0), "what is done ends at rest"
            self.close_all()

    def close_all(self) -> None:
        self.runtime.close()
        self.runtime.close()
        self.executor.close()
        assert self.robot.speed() == (0.0, 0.0)
        assert self.executor.snapshot().velocity == (0.0, 0.0)
        before = len(self.robot.written)
        self.clock.advance(5.0)
        assert not [each for each in self.robot.written[before:] if each.linear or each.angular]

    # -- what it hears, and what it is told --------------------------------------------------------------------------

    def close(self) -> None: ...

    def frames(self) -> Iterator[Frame]:
        for kind, *more in self.plan:
            if kind == "say":
                yield from self.say(*more)
            elif kind == "wait":
                yield from self.sound(more[0])
            elif kind in ("lost", "deaf"):
                yield self.next(0.0, **{kind: 0.3 if kind == "lost" else True})
            else:
                self.act(kind, *more)
                self.laws()
        if not self.closes:
            yield from self.sound(2.0)

    def say(self, text: str, seconds: float, jumpy: bool) -> Iterator[Frame]:
        self.texts.append(text)
        number = len(self.texts)
        if jumpy or text == "stop":
            self.reflex.numbers.add(number)
        yield from self.sound(seconds, number / 1000)
        yield from self.sound(0.1)

    def sound(self, seconds: float, level: float = 0.0) -> Iterator[Frame]:
        for _ in range(round(seconds / FRAME_SECONDS)):
            yield self.next(level)

    def next(self, level: float, **trouble) -> Frame:
        self.laws()
        self.frame += 1
        return Frame(np.full(FRAME_SAMPLES, level, np.float32), self.frame * FRAME_SECONDS, **trouble)

    def act(self, kind: str, *given) -> None:
        if kind == "type":
            found = self.engine.parse(given[0], state=(*self.states, "moving"))
            if found.status is Status.ACCEPTED:
                self.typed.append(found)
                self.executor.submit(found.actions, guards=found.guards(lambda: self.states), text=found.text)
        elif kind == "states":
            (self.states,) = given
        elif kind == "push":
            self.runtime.push_to_talk(given[0])
        elif kind == "talk":
            self.runtime.talk(given[0])
        elif kind == "robot fails":
            (self.robot.fail_in,) = given
        else:
            getattr(self.executor, kind)()
            if kind in ("stop", "estop"):
                assert self.executor.idle
                assert self.robot.speed() == (0.0, 0.0)
            if kind == "estop":
                self.executor.reset()

    def do(self, action) -> None:
        self.did.append(action.name)
        if (action.name, "docked" in self.states) in (("undock", False), ("hatch", True)):
            self.forbidden.append(action.name)  # what a handler raises goes no further

    def listen(self, event: Heard) -> None:
        self.heard.append(event)
        found = event.interpretation
        if event.kind is HeardKind.INTERPRETATION and found is not None and found.stops:
            assert self.executor.idle, "a stop is done before anybody is told of it"
            assert self.robot.speed() == (0.0, 0.0)
        if event.kind is HeardKind.SUBMITTED:
            assert found is not None
            assert found.status is Status.ACCEPTED
        if event.kind is HeardKind.HOLD:
            assert self.robot.speed() == (0.0, 0.0)

    # -- the laws ----------------------------------------------------------------------------------------------------

    def laws(self) -> None:
        now = self.executor.snapshot()
        if now.held:
            assert self.robot.speed() == (0.0, 0.0)
        if now.goal is None and not now.queued and any(self.robot.speed()):
            assert not self.stopped_last(), "nothing moves after a stop, until something new is begun"

    def stopped_last(self) -> bool:
        for event in reversed(self.events):
            if event.kind in (EventKind.STOP, EventKind.ESTOP):
                return True
            if event.kind is EventKind.GOAL and event.state == "executing":
                return False
        return True

    def check(self) -> None:
        goals = list(dict.fromkeys(event.goal for event in self.events if event.goal is not None))
        for goal in goals:
            told = [event.state for event in self.events if event.goal is goal and event.kind is EventKind.GOAL]
            assert goal.done
            assert [state.ended for state in told] == [False] * (len(told) - 1) + [True], "each ends once, and is told"
        assert [event.time for event in self.events] == sorted(event.time for event in self.events)
        times = [event.time for event in self.heard]
        assert times == sorted(times)
        kinds = [event.kind for event in self.heard]
        for place, kind in enumerate(kinds):
            if kind is HeardKind.INTERPRETATION:
                assert kinds[place - 1] is HeardKind.TRANSCRIPT
        holding = [kind for kind in kinds if kind in (HeardKind.HOLD, HeardKind.RELEASE)]
        assert not any(one is two is HeardKind.RELEASE for one, two in pairwise(holding))
        assert self.forbidden == [], "nothing is done that is refused in these states"
        done = sum(text.count("beep") for text in self.texts if "don't" not in text)
        done += sum(found.text.count("beep") for found in self.typed)
        assert self.did.count("beep") <= done, "nothing is done twice, nor what was refused"
        stops = [event.time for event in self.events if event.kind in (EventKind.STOP, EventKind.ESTOP)]
        begun = [event.time for event in self.events if event.state == "executing"]
        for write in self.robot.written:
            last = max((time for time in stops if time < write.time), default=-1.0)
            if write.linear or write.angular:
                assert any(last <= time <= write.time for time in begun), "nothing moves after a stop"


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR, locations=ROOT / "locations" / "home.yaml")


def play(engine, plan, speculate, ramps, closes) -> Session:
    session = Session(engine, plan, speculate, ramps, closes)
    session.run()
    session.check()
    return session


plans = st.lists(steps, min_size=1, max_size=10)


@settings(max_examples=60, deadline=None)
@given(plans, st.booleans(), st.booleans(), st.booleans())
def test_the_laws_hold_whatever_comes_in_whatever_order(engine, plan, speculate, ramps, closes):
    play(engine, plan, speculate, ramps, closes)


@pytest.mark.slow
@settings(max_examples=1500, deadline=None)
@given(plans, st.booleans(), st.booleans(), st.booleans())
def test_the_laws_hold_in_many_more_orders(engine, plan, speculate, ramps, closes):
    play(engine, plan, speculate, ramps, closes)


def test_the_session_is_heard_and_done(engine):
    """The stage works: what is said and typed is done, or the laws would hold of nothing."""
    plan = [
        ("say", "go to the kitchen, then open the hatch and beep", 0.9, False),
        ("wait", 4.0),
        ("say", "and then beep", 0.4, True),
        ("wait", 60.0),
        ("states", ("docked",)),
        ("type", "undock yourself"),
        ("type", "open the hatch"),
        ("wait", 1.0),
    ]
    session = play(engine, plan, True, True, False)
    assert session.did == ["hatch", "beep", "beep", "undock"]
    kinds = [event.kind for event in session.heard]
    assert kinds.count(HeardKind.HOLD) == kinds.count(HeardKind.RELEASE) == 1
