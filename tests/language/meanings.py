"""What an utterance would make a robot do, in one short line: for tables of sentences."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

from hypothesis import assume
from hypothesis import strategies as st

from intent_engine.actions import Action, ChangeSpeed, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status

ROOT = Path(__file__).resolve().parents[2]


@cache
def shipped() -> IntentEngine:
    """The shipped English grammar with the shipped home."""
    return IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=ROOT / "locations" / "home.yaml")


@cache
def german() -> IntentEngine:
    """The shipped German grammar with the same home."""
    return IntentEngine.from_files(ROOT / "grammars" / "de.yaml", locations=ROOT / "locations" / "zuhause.yaml")


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
        case ChangeSpeed(factor):
            return f"speed {factor:g}"
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


@st.composite
def commands(draw: st.DrawFn) -> str:
    """A sentence that the shipped grammar accepts, found by walking its automaton."""
    automaton = shipped().matcher().strict
    state = automaton.start()
    words: list[str] = []
    while len(words) < 14:
        if automaton.accepting(state) and draw(st.booleans()):
            break
        onward = sorted(automaton.next_words(state))
        if automaton.allows_digits(state):
            onward.append("2")
        if automaton.free(state):
            onward.append("cup")
        if not onward:
            break
        word = draw(st.sampled_from(onward))
        following = automaton.step(state, word)
        assert following is not None
        words.append(word)
        state = following
    text = " ".join(words)
    found = shipped().parse(text)
    assume(found.status is Status.ACCEPTED)
    return text


def assert_same(engine: IntentEngine, said: str, usual: str) -> None:
    """What was said does what the usual wording does, which is something."""
    wanted = engine.parse(usual).actions
    assert wanted, usual
    assert engine.parse(said).actions == wanted, said
