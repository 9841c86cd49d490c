"""Which way something goes until it is so much: "set the power down to forty percent"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

STUDIO = """
language: en
slots:
  level: {type: percent, unit: percent}
  volume: {type: number, whole: true, max: 10}
  degrees: number
  angle: {type: angle, unit: deg}
  height: distance
  pace: speed
  time: duration
  part: [boom, oven]
intents:
  power: {action: custom, sentences: ["set [the] power to {level}", "zoom to {level}", "speed to {level}"]}
  volume: {action: custom, sentences: ["turn [the] volume to {volume}", "turn [the] light to {level}"]}
  heat: {action: custom, sentences: ["heat the {part} to {degrees} degrees"]}
  pan: {action: custom, sentences: ["turn [the] camera to {angle}"]}
  raise: {action: custom, sentences: ["raise the {part} to {height}"]}
  pace: {action: custom, sentences: ["set [the] speed to {pace}"]}
  timer: {action: custom, sentences: ["set [the] timer to {time}"]}
"""


@pytest.fixture(scope="module")
def studio(engine_of) -> IntentEngine:
    return engine_of(STUDIO)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("set the power down to forty percent", "set the power to forty percent"),
        ("set your power up to a level of forty percent", "set the power to forty percent"),
        ("speed up to 40 percent", "speed to 40 percent"),
        ("zoom in to 80 percent", "zoom to 80 percent"),
        ("could you zoom back out to a quarter", "zoom to a quarter"),
        ("turn the volume down to 3", "turn the volume to 3"),
        ("turn the light down to ten percent", "turn the light to ten percent"),
        ("set the speed back to 2 m/s", "set the speed to 2 m/s"),
        ("set the speed back down to just 2 m/s", "set the speed to 2 m/s"),
        ("heat the oven up to eighty degrees", "heat the oven to eighty degrees"),
        ("raise the boom up to two meters", "raise the boom to two meters"),
    ],
)
def test_the_amount_tells_the_way(studio: IntentEngine, said: str, meant: str) -> None:
    assert_same(studio, said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "set the power down",
        "set the power down by forty percent",
        "zoom in 80 percent",
        "zoom off to 80 percent",
        "turn the camera down to thirty degrees",  # another angle
        "turn the light on to ten percent",
        "raise the boom down to two meters",
        "heat the oven down to eighty degrees",
        "set the timer up to ten minutes",  # at most
        "the power went down to forty percent",
        "don't set the power down to forty percent",
    ],
)
def test_what_may_be_another_way_is_none(studio: IntentEngine, said: str) -> None:
    assert not studio.parse(said).actions
