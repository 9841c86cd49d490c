"""What belongs to a verb may stand straight behind it, or behind what is done: whoever writes a grammar writes one."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.engine import IntentEngine

HOUSE = """
language: en
slots:
  lamp: [lamp, fan, ceiling light]
  thing: {type: text, max_words: 3}
  level: percent
  time: duration
  pump: boolean
  stall: {type: number, min: 1, max: 9}
intents:
  on: {action: custom, sentences: ["turn on [the] {lamp}"]}
  off: {action: custom, sentences: ["turn [the] {lamp} off [for {time}]"]}
  volume: {action: custom, sentences: ["turn the volume down [to {level}]"]}
  take: {action: custom, sentences: ["pick up [the] {thing}"]}
  lay: {action: custom, sentences: ["put [the] {thing} down"]}
  leave: {action: custom, sentences: ["drop off [the] parcel [at door {#}]"]}
  write: {action: custom, sentences: ["write down the time"]}
  roll: {action: custom, sentences: ["roll the ramp down"]}
  pump: {action: custom, sentences: ["switch {pump} the pump"]}
  hose: {action: custom, sentences: ["(scrape|hose down) stall {stall}"]}
  wave: {action: custom, sentences: [wave]}
"""


@pytest.fixture(scope="module")
def house(engine_of) -> IntentEngine:
    return engine_of(HOUSE)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("turn the lamp on", "turn on the lamp"),
        ("turn lamp on", "turn on lamp"),
        ("Could you turn the ceiling light on, please?", "turn on the ceiling light"),
        ("would you mind turning the lamp on", "turn on the lamp"),
        ("turn off the fan", "turn the fan off"),
        ("turn off the fan for ten minutes", "turn the fan off for ten minutes"),
        ("turn down the volume to 20%", "turn the volume down to 20%"),
        ("pick the red cup up", "pick up the red cup"),
        ("drop the parcel off at door 4", "drop off the parcel at door 4"),
        ("write the time down", "write down the time"),
        ("switch the pump off", "switch off the pump"),
        ("hose stall 4 down, would you", "hose down stall 4"),
        ("turn the lamp on and turn off the fan, then wave", "turn on the lamp and turn the fan off, then wave"),
        ("wave and turn the lamp on as well", "wave and turn on the lamp"),
        ("turn the lamp on, no, the fan", "turn on the fan"),
        ("turn the lamp on and then turn it off", "turn on the lamp and then turn the lamp off"),
        ("never mind, turn the lamp on", "turn on the lamp"),
        ("turn the lamp on and the ceiling light on", "turn on the lamp and turn on the ceiling light"),
        ("turn the lamp on and the fan off, then wave", "turn on the lamp and turn the fan off, then wave"),
    ],
)
def test_it_is_the_same_command(house: IntentEngine, said: str, plain: str) -> None:
    assert house.parse(said).actions == house.parse(plain).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "don't turn the lamp on",
        "never pick the cup up",
        "turn the lamp on if it is dark",
        "I turn the lamp on",
        "turned the lamp on",
        "who turned off the fan",
        "is the lamp turned on",
        "turn the lamp on or off",
        "turn the lamp on the table",
        "turn the lamp",
        "turn on and off",
        "turn off",
        "turn the lamp up",
        "turn up the lamp",
        "turn the kettle on",
        "turn it on",
        "turn the lamp on, said Ben",
        "pick the cup up quickly",
        "pick your brother up from school",
        "put down the road",  # free words may say where
        "put down the phone and wave at me",
        "scrape stall 4 down",
        "roll down the ramp",  # the robot itself would
        "let me turn the lamp on",
        "the pump switches off",
    ],
)
def test_what_says_something_else_is_none(house: IntentEngine, said: str) -> None:
    assert not house.parse(said).actions


LAMPS = st.sampled_from(["lamp", "fan", "ceiling light"])


@given(lamp=LAMPS, other=LAMPS, article=st.sampled_from(["the ", ""]), joint=st.sampled_from([" and ", ", then "]))
def test_every_order_of_both_is_understood(
    house: IntentEngine, lamp: str, other: str, article: str, joint: str
) -> None:
    ons = [f"turn on {article}{lamp}", f"turn {article}{lamp} on"]
    offs = [f"turn off {article}{other}", f"turn {article}{other} off"]
    done = {house.parse(f"{on}{joint}{off}").actions for on in ons for off in offs}
    assert len(done) == 1
    assert [action.name for action in done.pop()] == ["on", "off"]


def test_a_grammar_that_tells_them_apart_has_its_own(engine_of) -> None:
    engine = engine_of(
        "slots: {thing: [lamp, page]}\nintents:\n  over: {action: custom, sentences: ['turn over the {thing}']}\n"
        "  on: {action: custom, sentences: ['turn the {thing} over']}\n"
    )
    assert engine.parse("turn over the page").intent == "over"
    assert engine.parse("turn the page over").intent == "on"


def test_the_shipped_grammar_picks_up_in_either_order() -> None:
    picked = shipped().parse("pick up the red cup").actions
    assert shipped().parse("pick the red cup up").actions == picked != ()
    assert not shipped().parse("pick the speed up").actions
