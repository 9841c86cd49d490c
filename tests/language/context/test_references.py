"""Words that point back: to the utterance before, or to the command before in the same one."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.actions import Action, Custom, Move, Navigate, Pick, Place, Stop, Turn
from intent_engine.interpretation import Status
from intent_engine.runtime.last_said import LastSaid

GREETER = """
language: en
include: [en]
intents:
  wave: {action: custom, excludes: [docked], sentences: [wave]}
  bow: {action: custom, requires: [seen, awake], sentences: [bow]}
  shout: {action: custom, excludes: [moving], sentences: [shout]}
  repeat: {action: {type: custom, name: again}, requires: [asked], sentences: ["as I said"]}
"""
STATES = st.frozensets(st.sampled_from(("docked", "seen", "awake", "moving", "asked")))


@pytest.fixture(scope="module")
def greeter(engine_of) -> IntentEngine:
    return engine_of(GREETER)


@given(st.sampled_from(("wave", "bow", "shout", "turn left")), STATES, STATES, st.sampled_from(("again", "as I said")))
def test_again_needs_what_the_command_needs_that_it_repeats(
    greeter: IntentEngine, command: str, before: frozenset[str], state: frozenset[str], again: str
) -> None:
    last, anew = greeter.parse(command, state=before), greeter.parse(command, state=state)
    repeated = greeter.parse(again, state=state, last=last)
    if last.actions and (again == "again" or "asked" in state):
        assert (repeated.actions, repeated.reason) == (anew.actions, anew.reason)
        assert greeter.parse("again", state=state, last=repeated).actions == anew.actions, "and so does another one"
    else:
        assert not repeated.actions


@given(STATES)
def test_a_repetition_is_asked_again_when_its_turn_comes(greeter: IntentEngine, state: frozenset[str]) -> None:
    """For what its command needs, and for what it needs itself."""
    both = greeter.parse("wave and then as I said", state=["asked"])
    assert [action.name for action in both.actions] == ["wave", "wave"]
    first, second = (guard is not None and guard() for guard in both.guards(lambda: state))
    assert bool(first) == ("docked" in state)
    assert bool(second) == ("docked" in state or "asked" not in state)


def test_of_mere_actions_nobody_knows_what_they_need(greeter: IntentEngine) -> None:
    waved = greeter.parse("wave")
    assert greeter.parse("again", state=["docked"], last=waved.actions).actions == waved.actions
    assert not greeter.parse("again", last=greeter.parse("what a day")).actions


LEFT = Turn(1.0, 0.5, 2.0)
FORWARD = Move(0.5, 1.0, 2.0)
CUP = Pick("red cup")
BED = Navigate("bedroom", 2.0, 8.0, 3.14)


@pytest.mark.parametrize(
    ("text", "last", "actions"),
    [
        ("do that again", [LEFT], (LEFT,)),
        ("again", [FORWARD], (FORWARD,)),
        ("keep going", [FORWARD], (FORWARD,)),
        ("one more time please", [CUP, BED], (BED,)),
        ("a little more", [LEFT], (Turn(0.5, 0.5, 1.0),)),
        ("a bit further", [FORWARD], (Move(0.5, 0.5, 1.0),)),
        ("put it on the table", [CUP], (Place("red cup", "table"),)),
        ("bring me that", [CUP], (Custom("bring", {"thing": "red cup"}),)),
        ("put it on the table", [BED], (Place("it", "table"),)),
        ("put it on the table", [CUP, BED], (Place("red cup", "table"),)),
        ("turn left again", [FORWARD], (Turn(0.75, 0.5, 1.5),)),
    ],
)
def test_what_was_said_before_is_meant(
    engine: IntentEngine, text: str, last: list[Action], actions: tuple[Action, ...]
) -> None:
    found = engine.parse(text, last=last)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.actions == actions


@pytest.mark.parametrize(
    ("text", "last"),
    [("again", []), ("keep going", []), ("a little more", [BED]), ("a little more", []), ("again", [Stop()])],
)
def test_nothing_to_point_at_does_nothing(engine: IntentEngine, text: str, last: list[Action]) -> None:
    found = engine.parse(text, last=last)
    assert found.status is Status.REJECTED
    assert not found.actions
    assert found.reason


@pytest.mark.parametrize(
    ("before", "text", "meant"),
    [
        ("look at the ball", "go to the kitchen and look at it", ""),
        ("go to the bedroom", "look at the ball, go to the kitchen and look at it", ""),
        ("look at the ball", "go to the kitchen and pick it up", "go to the kitchen and pick up the ball"),
        ("pick up the ball", "go to the kitchen and look at it", "go to the kitchen and look at the ball"),
        ("go to the kitchen", "look at the ball and look at it", "look at the ball and look at the ball"),
    ],
)
def test_it_may_be_the_place_where_it_is_said_to_go(engine: IntentEngine, before: str, text: str, meant: str) -> None:
    """Unless it is held, or no place can be meant."""
    assert engine.parse(text, last=engine.parse(before)).actions == (engine.parse(meant, last=()).actions)


def test_the_command_before_in_the_same_breath(engine: IntentEngine) -> None:
    found = engine.parse("pick up the red cup and put it on the table")
    assert found.actions == (Pick("red cup"), Place("red cup", "table"))


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("find the cup and pick it up", (Custom("look", {"target": "cup"}), Pick("cup"))),
        ("pick up the cup and look at it", (Pick("cup"), Custom("look", {"target": "cup"}))),
        (
            "bring the cup to the door and look at it",
            (Custom("bring", {"thing": "cup", "target": "door"}), Custom("look", {"target": "cup"})),
        ),
    ],
)
def test_what_was_looked_for_or_is_looked_at_is_a_thing_too(
    engine: IntentEngine, text: str, actions: tuple[Action, ...]
) -> None:
    assert engine.parse(text).actions == actions


def test_without_an_account_of_before_the_words_stay(engine: IntentEngine) -> None:
    assert engine.parse("pick it up").actions == (Pick("it"),)
    assert engine.parse("again").actions == (Custom("again"),)


@pytest.mark.parametrize("last", [LEFT, FORWARD, CUP, BED])
@pytest.mark.parametrize("text", ["don't do that again", "never do it again", "do that again, no", "again, never mind"])
def test_a_negated_again_does_nothing(engine: IntentEngine, text: str, last: Action) -> None:
    assert set(engine.parse(text, last=[last]).actions) <= {Stop()}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "wash them"),
        ("fr", "lave les"),
        ("es", "lava los"),
        ("es", "lava las"),
        ("it", "lava li"),
        ("it", "lava le"),
    ],
)
def test_of_several_things_nobody_takes_the_last_in_any_language(engine_of, language: str, said: str) -> None:
    verb = said.split()[0]
    engine = engine_of(
        f"language: {language}\nslots: {{thing: object}}\nintents:\n"
        f"  wash: {{action: {{type: custom, name: wash, thing: '{{thing}}'}}, sentences: ['{verb} {{thing}}']}}\n"
    )
    assert engine.parse(said, last=[Pick("a")]).actions == (Custom("wash", {"thing": "a"}),)
    found = engine.parse(said, last=[Pick("a"), Pick("b")])
    assert not found.actions
    assert "more than one thing" in (found.reason or "")


@pytest.mark.parametrize(
    ("texts", "denied"),
    [
        (("pick up the cup", "don't pick it up"), ["pick up the cup"]),
        (("pick up the cup", "go to the kitchen", "don't pick it up"), ["pick up the cup"]),
        (("pick up the cup and the plate", "don't pick it up"), ["pick up the cup", "pick up the plate"]),
        (("pick up the cup and the plate", "don't pick them up"), ["pick up the cup", "pick up the plate"]),
        (("pick up the cup", "put it on the table", "don't put it on the table"), ["put the cup on the table"]),
        (("pick up the cup", "put it on the table", "not the table"), ["put the cup on the table"]),
        (("pick up the red cup", "not the red one"), ["pick up the red cup"]),
        (("pick up the red cup", "not the blue one"), []),
        (("pick up the red cup", "not the problem"), []),
    ],
)
def test_what_shall_not_be_done_with_it_is_denied_by_its_name(
    engine: IntentEngine, texts: tuple[str, ...], denied: list[str]
) -> None:
    kept = LastSaid(lambda: engine.grammars)
    for text in texts[:-1]:
        kept.take(engine.parse(text, last=kept.meaning))
    found = engine.parse(texts[-1], last=kept.meaning)
    assert not found.actions
    assert set(found.denied) == {engine.parse(one).actions[0] for one in denied}


def test_another_may_be_wanted_instead_of_it(engine: IntentEngine) -> None:
    found = engine.parse("don't pick it up, pick up the plate", last=engine.parse("pick up the cup"))
    assert (found.actions, found.denied) == ((Pick("plate"),), (Pick("cup"),))
