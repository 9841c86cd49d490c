"""A command in other words of two kinds at once, each of which is understood alone."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable

import pytest

from intent_engine.engine import IntentEngine

KITCHEN = """
language: en
slots:
  lamp: [desk lamp, fan]
  st: boolean
  oven: [top oven, stone oven]
  bread: [rolls, buns]
  time: duration
  level: {type: percent, unit: percent}
  side: [left, right]
  angle: {type: angle, unit: deg}
  item: [tray, basket]
  room: [lab, hall]
  height: distance
intents:
  lamp: {action: custom, sentences: ["turn the {lamp} {st}"]}
  bake: {action: custom, sentences: ["bake the {bread} [in the {oven}] [for {time}]"]}
  power: {action: custom, sentences: ["set the power to {level}"]}
  pan: {action: custom, sentences: ["pan {side} [{angle}]"]}
  bring: {action: custom, sentences: ["bring the {item} to the {room}"]}
  put: {action: custom, sentences: ["put the {item} in the {room}"]}
  lower: {action: custom, sentences: ["lower the {item} by {height}"]}
"""
COMMANDS = (
    "turn the fan off",
    "bake the rolls in the top oven for 20 minutes",
    "set the power to 40 percent",
    "pan left 30 degrees",
    "bring the tray to the lab",
    "put the basket in the hall",
    "lower the tray by 2 meters",
)
AMOUNT = r"(20 minutes|40 percent|30 degrees|2 meters)"


def _changed(pattern: str, other: str) -> Callable[[str], str]:
    return lambda said: re.sub(pattern, other, said, count=1)


WITHIN = {
    "pointing": _changed(r"\bthe ", "your "),
    "merely": _changed(AMOUNT, r"just \1"),
    "around": _changed(AMOUNT, r"about \1"),
    "roughly": _changed(AMOUNT, r"\1 or so"),
    "a side": _changed(r"\bleft", "to your left"),
    "up to": _changed(r"(power) to ", r"\1 down to "),
    "a way on": _changed(r"(tray) to ", r"\1 over to "),
    "down in": _changed(r"(basket) in ", r"\1 down in "),
    "back off": _changed(r" off$", " back off"),
    "lacks by": _changed(r" by (2 meters)", r" \1"),
    "idle": _changed(r"^lower ", "lower down "),
    "elsewhere": lambda said: re.sub(r"^(bake .*?) (in .*?) (for .*)$", r"\1 \3 \2", said),
    "later": lambda said: re.sub(r"^(pan) (.*?left) (.*)$", r"\1 \3 \2", said),
}
AROUND = {
    "again": lambda said: f"{said} again",
    "besides": lambda said: f"{said} as well",
    "next": lambda said: f"{said} next",
    "once more": lambda said: f"{said} one more time",
    "asked": lambda said: f"could you {said}",
    "asked kindly": lambda said: f"would you be so kind as to just {said}",
    "told": lambda said: f"go on and {said}",
    "permitted": lambda said: f"you can {said} now",
}


@pytest.fixture(scope="module")
def kitchen(engine_of) -> IntentEngine:
    return engine_of(KITCHEN)


@pytest.mark.parametrize("command", COMMANDS)
def test_it_is_the_same_command(kitchen: IntentEngine, command: str) -> None:
    meant = kitchen.parse(command).actions
    assert meant
    alone = [put for put in WITHIN.values() if put(command) != command]
    ways = [second(first(command)) for first, second in itertools.combinations(alone, 2)]
    ways += [around(within(command)) for within, around in itertools.product(alone, AROUND.values())]
    missed = [way for way in ways if kitchen.parse(way).actions != meant]
    assert not missed
