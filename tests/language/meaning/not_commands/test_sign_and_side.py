"""A side and a sign at once: "turn left minus thirty degrees" is no turn, to whichever side."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does

from intent_engine.engine import IntentEngine

CRANE = """
language: en
slots:
  far: {type: distance, max: 1 m}
  angle: {type: angle, unit: deg}
  heat: {type: number, min: -20, max: 90}
  side: [left, right]
  axis: [x, y, z]
intents:
  jog: {action: custom, sentences: ["jog {axis} [by] {far}", "move up [by] {far}", "jog {side} {far}"]}
  pan: {action: custom, sentences: ["pan {side} [by] {angle}", "pan [by] {angle}", "pan {angle} to the {side}"]}
  cool: {action: custom, sentences: ["turn on the cooler at {heat} degrees"]}
"""


@pytest.fixture(scope="module")
def crane(engine_of) -> IntentEngine:
    return engine_of(CRANE)


@pytest.mark.parametrize(
    "said",
    [
        "move up minus 5 mm",
        "move up by -5 mm",
        "jog left -5 mm",
        "pan left by minus thirty",
        "pan -30 degrees to the right",
        "pan left 30 degrees, no, -40",
        "pan left -30 degrees and jog x 5 mm",
    ],
)
def test_a_side_and_a_sign_are_not_done(crane: IntentEngine, said: str) -> None:
    assert crane.parse(said).actions == ()


@pytest.mark.parametrize("said", ["jog x -5 mm", "jog x by minus 5 mm", "pan -30", "turn on the cooler at -5 degrees"])
def test_a_sign_alone_says_which_way(crane: IntentEngine, said: str) -> None:
    assert len(crane.parse(said).actions) == 1


@given(st.sampled_from(["left", "right"]), st.integers(1, 180))
def test_whichever_side_and_however_far(side: str, degrees: int) -> None:
    assert does(f"turn {side} minus {degrees} degrees") == "rejected"
    assert does(f"turn {side} {degrees} degrees") == f"{side} {degrees}"
