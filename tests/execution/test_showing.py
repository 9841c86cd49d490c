"""What nobody carries out is shown and done at once; what somebody does is his."""

from __future__ import annotations

from intent_engine import Custom, Executor, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.showing import SHOWN_ONLY, show_own_actions


def test_only_what_has_no_handler_is_shown_only():
    clock, waved = VirtualClock(), []
    with Executor(SimulatedRobot(clock), clock=clock, handlers={"wave": waved.append}) as executor:
        show_own_actions(executor)
        own, shown = executor.submit([Custom("wave", {}), Custom("dance", {})])
        executor.wait()
    assert waved == [own.action]
    assert own.succeeded
    assert own.detail == ""
    assert shown.succeeded
    assert shown.detail == SHOWN_ONLY
    assert clock.now() == 0.0
