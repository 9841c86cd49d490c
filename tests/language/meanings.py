"""What an utterance would make a robot do, in one short line: for tables of sentences."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status

ROOT = Path(__file__).resolve().parents[2]


@cache
def shipped() -> IntentEngine:
    """The shipped English grammar with the shipped home."""
    return IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=ROOT / "locations" / "home.yaml")


def in_short(action: Action) -> str:
    match action:
        case Stop():
            return "stop"
        case Move(velocity, distance):
            return f"{'back' if velocity < 0 else 'forward'} {distance:g}"
        case Turn(angle):
            return f"{'left' if angle > 0 else 'right'} {abs(math.degrees(angle)):.0f}"
        case Navigate(location):
            return f"to {location}"
        case Pick(thing):
            return f"pick {thing}"
        case Place(thing, where):
            return " ".join(filter(None, ("place", thing, where)))
        case Custom(name):
            return name
    raise AssertionError(action)


def done(found: Interpretation) -> str:
    """The actions, or the status if there are none. Nothing but an accepted interpretation has actions."""
    assert bool(found.actions) == (found.status is Status.ACCEPTED), found
    return ", ".join(in_short(action) for action in found.actions) or found.status.value


def does(text: str, *state: str) -> str:
    """What the shipped grammar makes of a text."""
    return done(shipped().parse(text, state=state))
