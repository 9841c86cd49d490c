"""What an intent asks of the states of the robot."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.needs import MOVING, Needs, states_of

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


def test_a_text_is_the_one_state_of_that_name():
    guard = Needs("wave", excludes=frozenset({"docked"})).guard(lambda: "docked")
    assert guard is not None
    assert guard() == "wave cannot be done while the robot is docked"
    assert set(states_of("docked")) == {"docked"}


@pytest.mark.parametrize("wrong", [None, 5, {"docked": False}])
def test_what_are_no_states(wrong):
    with pytest.raises(TypeError, match=r"states are names in a list or a set, as \['moving'\], not"):
        states_of(wrong)
