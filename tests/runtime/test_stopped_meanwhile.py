""" "Go forward", and a button is pressed while the recogniser still thinks about it."""

from __future__ import annotations

import numpy as np
import pytest
from continuing_stage import ENGINE, Frames, Parts, Voiced, framed

from intent_engine import Executor, GoalState, Reason, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE


@pytest.mark.parametrize("pressed", [0, 1, 2])
def test_what_was_said_before_the_button_was_pressed_is_not_done(pressed):
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    decodes: list[int] = []
    events: list[Heard] = []

    class Thinking(Parts):
        def transcribe(self, samples, *, final=True):
            decodes.append(len(decodes) + 1)
            if decodes[-1] == pressed:
                executor.stop()
            return super().transcribe(samples, final=final)

    with Executor(robot, clock=clock) as executor:
        voice = Voiced((0.5, 1.0), (3.5, 4.0))
        hears = Thinking("go forward one meter", "turn left")
        Runtime(ENGINE, executor, hears, voice=voice, noise_filter=None, on_event=events.append).run(
            Frames(framed(np.zeros(6 * SAMPLE_RATE, np.float32)))
        )
        executor.wait()

    goals = [goal for event in events if event.kind is HeardKind.SUBMITTED for goal in event.goals]
    refused = [goal for goal in goals if (goal.state, goal.reason) == (GoalState.REJECTED, Reason.STOP)]
    assert [goals.index(goal) + 1 for goal in refused] == ([pressed] if pressed else [])
