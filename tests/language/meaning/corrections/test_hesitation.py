"""Behind an "uh" something may be said anew: two commands of one kind are asked about, unless a joint tells."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import german, shipped

from intent_engine import Status

HESITATIONS = st.sampled_from(["uh", "um", "er", "hmm", "uh, um", "uh please", "well", "I guess", "oh"])
TURNS = st.sampled_from(["turn left", "turn right ninety degrees", "left", "turn around"])
MOVES = st.sampled_from(["go forward", "backward", "go back two meters", "one meter forward"])


@given(st.one_of(st.tuples(TURNS, TURNS), st.tuples(MOVES, MOVES)), HESITATIONS)
def test_two_of_one_kind_are_asked_about(both: tuple[str, str], hesitation: str) -> None:
    first, second = both
    found = shipped().parse(f"{first}, {hesitation}, {second}")
    assert found.status is Status.AMBIGUOUS, found
    assert not found.actions
    assert len(found.alternatives) == 2


@given(TURNS, MOVES, HESITATIONS)
def test_two_of_different_kinds_are_two(first: str, second: str, hesitation: str) -> None:
    found = shipped().parse(f"{first}, {hesitation}, {second}")
    assert [type(action) for action in found.actions] == [
        type(shipped().parse(said).actions[0]) for said in (first, second)
    ]


@given(TURNS, TURNS, HESITATIONS, st.sampled_from(["{}, {}, then {}", "{}, and, {}, {}", "{} and then {} {}"]))
def test_a_joint_tells_that_both_are_meant(first: str, second: str, hesitation: str, form: str) -> None:
    words = (first, second) if form.count("{}") < 3 else (first, hesitation, second)
    assert len(shipped().parse(form.format(*words)).actions) == 2


@pytest.mark.parametrize(
    "said", ["turn left, right", "uh, turn left, turn right", "turn left, turn right, uh", "turn, uh, left, turn right"]
)
def test_an_uh_elsewhere_tells_nothing(said: str) -> None:
    assert len(shipped().parse(said).actions) == 2


@given(st.sampled_from(["move", "drive", "turn left, move"]), TURNS, HESITATIONS)
def test_a_verb_alone_may_have_been_left(first: str, second: str, hesitation: str) -> None:
    found = shipped().parse(f"{first}, {hesitation}, {second}")
    assert found.status is Status.AMBIGUOUS
    answer = shipped().parse(second, last=found)
    assert [type(action) for action in answer.actions] == [type(shipped().parse(second).actions[0])]


@pytest.mark.parametrize("said", ["stop, uh, turn left", "go, um, stop", "move, uh, stop"])
def test_a_stop_is_asked_about_beside_no_verb(said: str) -> None:
    assert shipped().parse(said).stops


@pytest.mark.parametrize("said", ["move and, uh, turn left", "move, turn left", "move, uh", "wave, uh, turn left"])
def test_a_verb_that_was_not_left_is_done(engine_of, said: str) -> None:
    waves = "language: en\ninclude: [en]\nintents: {wave: {action: custom, sentences: [wave]}}\n"
    assert engine_of(waves).parse(said).status is Status.ACCEPTED


@pytest.mark.parametrize("said", ["fahr links, äh, rechts", "fahr zwei Meter vor, ähm, fahr einen Meter zurück"])
def test_in_german(said: str) -> None:
    assert german().parse(said).status is Status.AMBIGUOUS


def test_of_several_any_may_be_said_anew() -> None:
    assert not shipped().parse("go forward, turn left, uh, turn right, go back").actions
