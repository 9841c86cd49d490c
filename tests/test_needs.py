"""What an intent asks of the states of the robot."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from intent_engine.needs import MOVING, Needs

states = st.frozensets(st.sampled_from(["docked", "carrying", "on the ramp", MOVING]))


@given(states, states, states)
def test_it_is_met_where_all_that_is_required_holds_and_nothing_that_is_excluded(requires, excludes, state):
    unmet = Needs("wave", requires, excludes).unmet(state)
    assert bool(unmet) == (not requires <= state or bool(excludes & state))
    assert not unmet or unmet.startswith("wave ")


@given(states, states, states, st.booleans())
def test_a_guard_asks_the_same_of_the_states_of_its_moment_but_for_moving(requires, excludes, state, moves):
    needs = Needs("wave", requires, excludes)
    now: frozenset[str] = frozenset()
    guard = needs.guard(lambda: now)
    assert (guard is None) == ((requires | excludes) <= {MOVING})
    now = state | {MOVING} if moves else state - {MOVING}
    if guard is not None:
        assert guard() == Needs("wave", requires - {MOVING}, excludes - {MOVING}).unmet(now)
