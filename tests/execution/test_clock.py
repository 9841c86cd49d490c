"""The virtual clock does what is due, in order, at its own time."""

from __future__ import annotations

import math
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.execution.clock import MonotonicClock, SteppedClock, VirtualClock


class Bell:
    def __init__(self, clock: VirtualClock, times: list[float], log: list) -> None:
        self.clock, self.times, self.log = clock, sorted(times), log

    def due(self) -> float | None:
        return self.times[0] if self.times else None

    def step(self) -> None:
        self.log.append((self.clock.now(), self.times.pop(0)))


@given(st.lists(st.floats(0, 100)), st.lists(st.floats(0, 100)), st.lists(st.floats(0, 120), min_size=1))
def test_everything_rings_at_its_time_and_in_order(first, second, moves):
    clock, log = VirtualClock(), []
    clock.attach(Bell(clock, first, log))
    clock.attach(Bell(clock, second, log))
    for moment in sorted(moves):
        clock.advance_to(moment)
        assert clock.now() == moment
        assert len(log) == sum(t <= moment for t in first + second)
    clock.run_until_idle()
    assert [at for at, _ in log] == sorted(first + second)
    assert all(at == due for at, due in log)


def test_it_never_goes_back_and_takes_no_nonsense():
    clock = VirtualClock(5.0)
    clock.advance_to(3.0)
    assert clock.now() == 5.0
    with pytest.raises(ValueError, match="nan"):
        clock.advance_to(math.nan)


def test_a_limit_ends_the_run():
    clock, log = VirtualClock(), []
    clock.attach(Bell(clock, [1.0, 9.0], log))
    assert not clock.run_until_idle(limit=5.0)
    assert (clock.now(), len(log)) == (5.0, 1)
    assert clock.run_until_idle()


def test_a_step_that_never_moves_on_is_named():
    class Stuck:
        def due(self) -> float:
            return 0.0

        def step(self) -> None:
            pass

    clock = VirtualClock()
    clock.attach(Stuck())
    with pytest.raises(RuntimeError, match="Stuck"):
        clock.advance(1.0)


def test_waiting_on_a_virtual_clock_moves_it():
    clock = VirtualClock()
    condition = threading.Condition()
    with condition:
        assert clock.wait_until(condition, 3.0)
    assert clock.now() == 3.0
    assert isinstance(clock, SteppedClock)


def test_the_monotonic_clock_hears_a_notification_before_the_deadline():
    clock, condition, heard = MonotonicClock(), threading.Condition(), []
    assert not isinstance(clock, SteppedClock)

    def wait() -> None:
        with condition:
            ready.set()
            heard.append(clock.wait_until(condition, clock.now() + 60.0))

    ready = threading.Event()
    thread = threading.Thread(target=wait)
    thread.start()
    ready.wait()
    with condition:
        condition.notify_all()
    thread.join(30.0)
    assert heard == [False]
    with condition:
        assert clock.wait_until(condition, clock.now() - 1.0)
