"""What stands at the end of two commands that share a verb may be meant for both: it is asked about, never guessed."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.interpretation import Status

LAMPS = """
language: en
slots:
  lamp: {type: choice, values: [desk lamp, ceiling light, spot]}
  level: {type: percent, min: 0, max: 100 %}
intents:
  dim:
    action: custom
    defaults: {level: 50 %}
    sentences: ["dim [the] {lamp} [to {level}]", "[the] {lamp} to {level}", "[the] {level} {lamp}"]
"""


@pytest.mark.parametrize(
    "said",
    [
        "dim the desk lamp and the spot to ten percent",
        "dim the desk lamp, the spot to ten percent",
        "please dim the desk lamp and also the spot to about ten percent",
        "dim the ceiling light to ten percent and then dim the desk lamp and the spot to 5%",
        "turn left and right ninety degrees",
        "go forward and back two meters",
        "forward, left and right ninety degrees",
    ],
)
def test_it_is_asked_for_whom_it_is_meant(engine_of, said):
    found = (engine_of(LAMPS) if "dim" in said else shipped()).parse(said)
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert "may be meant for both" in found.reason
    assert len(set(found.alternatives)) == 2


@pytest.mark.parametrize(
    ("said", "levels"),
    [
        ("dim the desk lamp and dim the spot to ten percent", [0.5, 0.1]),
        ("dim the desk lamp and then the spot to ten percent", [0.5, 0.1]),
        ("dim the desk lamp to 20 percent and the spot to ten percent", [0.2, 0.1]),
        ("dim the desk lamp and the ten percent spot", [0.5, 0.1]),
    ],
)
def test_where_it_is_clear_each_has_its_own(engine_of, said, levels):
    assert [action.slots["level"] for action in engine_of(LAMPS).parse(said).actions] == levels


@given(st.sampled_from(("left", "right")), st.sampled_from(("left", "right")), st.integers(5, 360))
def test_no_turn_by_the_default_is_done_where_a_size_was_said_for_both(one, other, degrees):
    assert not shipped().parse(f"turn {one} and {other} {degrees} degrees").actions
    assert len(shipped().parse(f"turn {one} {degrees} degrees and {other} {degrees} degrees").actions) == 2
