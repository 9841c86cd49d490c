"""States that only the program knows decide what is done about what was said."""

from __future__ import annotations

import numpy as np
import pytest
from speech_stage import ROOT, Frames, Says, Voiced, framed

from intent_engine import Executor, IntentEngine, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.events import Event
from intent_engine.speech.audio import SAMPLE_RATE

GRAMMAR = """
language: en
intents:
  undock: {action: custom, requires: [docked], sentences: [let us leave]}
  wave: {action: custom, excludes: [docked], sentences: [wave]}
  bow: {action: custom, requires: [moving], sentences: [bow]}
"""


def done(engine: IntentEngine, said: str, **options: object) -> list[str]:
    clock = VirtualClock()
    names: list[str] = []
    with Executor(SimulatedRobot(clock), clock=clock) as executor:
        executor.register("custom", lambda action: names.append(action.name))
        runtime = Runtime(
            engine, executor, Says(said), voice=Voiced((0.5, 1.5)), noise_filter=None, speculate=False, **options
        )
        runtime.run(Frames(framed(np.zeros(3 * SAMPLE_RATE, np.float32))))
        executor.wait()
        assert executor.idle
    return names


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "docked", "names"),
    [
        ("let us leave", True, ["undock"]),
        ("let us leave", False, []),
        ("wave", False, ["wave"]),
        ("wave", True, []),
        ("bow", True, []),  # no other state is "moving"
    ],
)
def test_what_a_state_forbids_is_not_done(engine, said, docked, names):
    assert done(engine, said, state=lambda: ["docked"] if docked else []) == names


def test_a_text_is_the_one_state_of_that_name(engine):
    assert done(engine, "wave", state=lambda: "docked") == []
    assert done(engine, "let us leave", state=lambda: "docked") == ["undock"]


def test_without_a_program_that_tells_it_is_in_none(engine):
    assert done(engine, "wave") == ["wave"]
    assert done(engine, "let us leave") == []


def test_a_state_that_cannot_be_told_ends_listening(engine):
    """Nothing is done that may be forbidden."""

    def unknown() -> list[str]:
        raise LookupError("who knows")

    with pytest.raises(LookupError, match="who knows"):
        done(engine, "wave", state=unknown)


def test_again_is_not_done_in_a_state_that_forbids_what_it_repeats(engine_of):
    greeter = engine_of(
        "language: en\ninclude: [en]\nintents: {wave: {action: custom, excludes: [docked], sentences: [wave]}}\n"
    )

    def names(*docked: bool) -> list[str]:
        """What is done of "wave", at 0.5 s, and "again", at 4 s, by a robot that may dock in between."""
        clock = VirtualClock()
        waved: list[str] = []
        with Executor(SimulatedRobot(clock), clock=clock) as executor:
            executor.register("wave", lambda action: waved.append(action.name))
            runtime = Runtime(
                greeter,
                executor,
                Says("wave", "again"),
                voice=Voiced((0.5, 1.5), (4.0, 5.0)),
                noise_filter=None,
                speculate=False,
                state=lambda: ["docked"] if docked[clock.now() > 3.0] else [],
            )
            runtime.run(Frames(framed(np.zeros(7 * SAMPLE_RATE, np.float32))))
            executor.wait()
        return waved

    assert names(False, False) == ["wave", "wave"]
    assert names(False, True) == ["wave"]


# -- what waits its turn -----------------------------------------------------------------------------------------------

LATER = f"""
language: en
include: [{ROOT / "grammars" / "en.yaml"}]
intents:
  undock: {{action: custom, requires: [docked], sentences: [let us leave]}}
  open: {{action: custom, excludes: [docked], sentences: [open the hatch]}}
  close: {{action: custom, requires: [carrying], sentences: [close the hatch]}}
  bow: {{action: custom, excludes: [moving], sentences: [bow]}}
  hurry: {{action: custom, requires: [moving], sentences: [hurry along]}}
"""


class Later:
    """Sentences at 0.5 s, 3 s, ..., and a robot that comes into other states at 5 s, when it is still under way."""

    def __init__(self, engine: IntentEngine, *said: str, before: tuple[str, ...] = (), after: tuple[str, ...] = ()):
        clock = VirtualClock()
        self.names: list[str] = []
        self.events: list[Event] = []
        self.states = before
        robot = SimulatedRobot(clock)
        with Executor(robot, clock=clock, on_event=self.events.append) as executor:
            executor.register("custom", lambda action: self.names.append(action.name))
            voice = Voiced(*((0.5 + 2.5 * count, 1.5 + 2.5 * count) for count in range(len(said))))
            runtime = Runtime(
                engine, executor, Says(*said), voice=voice, noise_filter=None, speculate=False, state=self.tell
            )
            runtime.run(Frames(framed(np.zeros(5 * SAMPLE_RATE, np.float32))))
            assert not executor.idle
            self.states = after
            executor.wait()
            assert robot.speed() == (0.0, 0.0)
        self.goals = list(dict.fromkeys(event.goal for event in self.events if event.goal is not None))

    def tell(self) -> tuple[str, ...]:
        if "gone" in self.states:
            raise LookupError("who knows")
        return self.states


DRIVE = "go forward five meters"


@pytest.fixture(scope="module")
def later(engine_of) -> IntentEngine:
    return engine_of(LATER)


@pytest.mark.parametrize(
    "said",
    [
        (f"{DRIVE}, then open the hatch and turn left",),
        (DRIVE, "then open the hatch and turn left"),
        (DRIVE, "when you get there, open the hatch and turn left"),
    ],
)
def test_what_waits_its_turn_is_asked_for_its_states_when_it_comes(later, said):
    done = Later(later, *said)
    assert done.names == ["open"]
    assert [goal.state.value for goal in done.goals] == ["succeeded"] * 3
    refused = Later(later, *said, after=("docked",))
    assert refused.names == []
    assert [goal.state.value for goal in refused.goals] == ["succeeded", "aborted", "canceled"]
    assert refused.goals[1].reason == "forbidden"
    assert refused.goals[1].detail == "open cannot be done while the robot is docked"
    assert refused.goals[2].reason == "earlier_failed"


def test_what_a_state_requires_must_hold_when_its_turn_comes(later):
    said = f"{DRIVE}, then close the hatch"
    assert Later(later, said, before=("carrying",), after=("carrying",)).names == ["close"]
    dropped = Later(later, said, before=("carrying",))
    assert dropped.names == []
    assert dropped.goals[1].detail == "close needs the robot to be carrying"


def test_the_part_of_a_sentence_that_came_later_has_needs_of_its_own(later):
    """ "Go forward five meters", and a moment later "and then close the hatch, and open the hatch"."""
    part = "and then close the hatch, and open the hatch"
    assert Later(later, DRIVE, part, before=("carrying",), after=("carrying",)).names == ["close", "open"]
    both = Later(later, DRIVE, part, before=("carrying",), after=("carrying", "docked"))
    assert both.names == ["close"]
    assert [goal.state.value for goal in both.goals] == ["succeeded", "succeeded", "aborted"]


def test_what_is_meant_by_moving_is_asked_when_it_is_said_and_not_again(later):
    assert Later(later, f"{DRIVE}, then bow").names == ["bow"]
    assert Later(later, f"{DRIVE}, then bow", after=("moving",)).names == ["bow"]
    assert Later(later, DRIVE, "then hurry along").names == ["hurry"]
    assert Later(later, DRIVE, "then bow").names == []


def test_where_the_states_cannot_be_told_any_more_what_asks_for_some_is_not_done(later):
    lost = Later(later, f"{DRIVE}, then open the hatch and turn left", after=("gone",))
    assert lost.names == []
    assert [goal.state.value for goal in lost.goals] == ["succeeded", "aborted", "canceled"]
    assert lost.goals[1].detail.endswith("LookupError: who knows")
    assert [goal.state.value for goal in Later(later, f"{DRIVE}, then turn left", after=("gone",)).goals] == [
        "succeeded",
        "succeeded",
    ]
