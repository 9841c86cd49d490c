"""A pronoun in a text of its own, for what a command before named from a list or in its own words: "close it"."""

from __future__ import annotations

from functools import reduce

import pytest
from meanings import shipped

from intent_engine.actions import Custom, Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status

GRAMMAR = """
language: en
slots:
  hatch: [front hatch, side hatch, weights]
  valve: {type: number, min: 1, max: 40, whole: true}
  time: duration
  side: [left, right]
  limb: [arm, leg]
  device: [pump, siren]
  state: boolean
intents:
  open: {action: custom, sentences: ["open the {hatch}"]}
  close: {action: custom, sentences: ["close the {hatch}", "shut [the] {hatch} [for {time}]"]}
  unscrew: {action: custom, sentences: ["unscrew valve {valve} [for {time}]"]}
  screw: {action: custom, sentences: ["screw valve {valve}"]}
  raise: {action: custom, sentences: ["raise the (forks|mast)", "raise your {side} {limb}"]}
  lower: {action: custom, sentences: ["lower the (forks|mast)", "lower your {side} {limb}"]}
  switch: {action: custom, sentences: ["turn {state} the {device}", "turn the {device} {state}"]}
  honk: {action: custom, sentences: [honk]}
  drop: {action: custom, sentences: ["drop the {hatch}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def one_by_one(engine: IntentEngine, *texts: str) -> Interpretation:
    return reduce(lambda last, text: engine.parse(text, last=last), texts[1:], engine.parse(texts[0], last=()))


@pytest.mark.parametrize(
    ("texts", "meant"),
    [
        (("open the side hatch", "close it"), "close the side hatch"),
        (("open the side hatch", "could you close it again please"), "close the side hatch"),
        (("open the side hatch", "and then shut it for ten seconds"), "shut the side hatch for ten seconds"),
        (("open the side hatch", "close it", "open it"), "open the side hatch"),
        (("open the side hatch", "close it, I mean the front hatch"), "close the front hatch"),
        (("open the weights", "close them"), "close the weights"),
        (("unscrew valve 12 for a minute", "screw it"), "screw valve 12"),
        (("raise the forks", "lower them"), "lower the forks"),
        (("raise the mast", "lower it"), "lower the mast"),
        (("raise your left arm", "lower it"), "lower your left arm"),
        (("turn on the pump", "turn it off"), "turn the pump off"),
    ],
)
def test_it_is_what_was_named_before(engine: IntentEngine, texts: tuple[str, ...], meant: str) -> None:
    found = one_by_one(engine, *texts)
    assert found.actions == engine.parse(meant).actions
    assert found.actions


@pytest.mark.parametrize(
    ("before", "text"),
    [
        ("honk", "close it"),
        ("open the side hatch", "did you close it"),
        ("open the side hatch", "I'll close it"),
        ("open the side hatch", "close it, he said"),
        ("open the side hatch", "you closed it"),
        ("open the side hatch", "close it if it rains"),
        ("open the side hatch", "close them"),
        ("open the side hatch", "open it or close it"),
        ("open the side hatch", "it"),
        ("open the side hatch", "turn it off"),
        ("open the front hatch and open the side hatch", "close it"),
        ("raise your left arm and your right arm", "lower it"),
        ("raise the mast", "lower them"),
        ("open the side hatch", "take it from the top"),
        ("open the side hatch", "drop it"),  # which takes back what was said
    ],
)
def test_nothing_is_done_where_nobody_knows_or_it_is_talk(engine: IntentEngine, before: str, text: str) -> None:
    first = engine.parse(before, last=())
    assert first.actions
    assert not engine.parse(text, last=first).actions


@pytest.mark.parametrize("before", ["go to the kitchen", "pick up the cup", "look at the door"])
@pytest.mark.parametrize(
    "text",
    [
        "take it slow",
        "take it from the top",
        "take it down a notch",
        "okay, let's take it from here",
        "drop it, go to the lab",
        "go forward drop it",
        "place it box",
        "look at it this way",
        "no turn left",
        "no nope no no turn left",
    ],
)
def test_no_name_is_put_into_free_words(before: str, text: str) -> None:
    """Of which more is refused than a pronoun."""
    assert not shipped().parse(text, last=shipped().parse(before)).actions


@pytest.mark.parametrize(
    ("before", "text", "answer", "meant"),
    [
        ("turn on the pump and the siren", "turn it off", "the siren", "turn the siren off"),
        ("open the front hatch, then open the side hatch", "close it", "the second one", "close the side hatch"),
        ("open the front hatch, then open the side hatch", "close it", "neither", ""),
    ],
)
def test_of_several_it_is_asked_which(engine: IntentEngine, before: str, text: str, answer: str, meant: str) -> None:
    asked = engine.parse(text, last=engine.parse(before))
    assert asked.status is Status.AMBIGUOUS
    assert not asked.actions
    assert len(asked.alternatives) == 2
    assert engine.parse(answer, last=asked).actions == (engine.parse(meant).actions if meant else ())


@pytest.mark.parametrize(
    ("before", "text", "denied"),
    [
        ("open the side hatch", "don't open it", ["open the side hatch"]),
        ("open the side hatch", "no, don't open it!", ["open the side hatch"]),
        ("turn on the pump", "don't turn it on", ["turn on the pump"]),
        ("unscrew valve 12", "never unscrew it", ["unscrew valve 12"]),
        ("turn on the pump, then turn on the siren", "don't turn it on", ["turn on the pump", "turn on the siren"]),
    ],
)
def test_what_shall_not_be_done_with_it_is_denied(
    engine: IntentEngine, before: str, text: str, denied: list[str]
) -> None:
    found = engine.parse(text, last=engine.parse(before))
    assert not found.actions
    assert found.denied == tuple(engine.parse(one).actions[0] for one in denied)


def test_whoever_is_told_nothing_of_before_puts_nothing_in(engine: IntentEngine) -> None:
    assert not engine.parse("close it").actions
    assert not engine.parse("close it", last=()).actions
    assert not engine.parse("close it", last=Custom("open", {"hatch": "side hatch"})).actions


@pytest.mark.parametrize("text", ["don't raise it", "no, don't raise it!"])
def test_a_robot_that_moves_stops_at_what_forbids_what_it_does(engine: IntentEngine, text: str) -> None:
    """Be it that the mast is raised by a command without slots, of which whatever is forbidden of it stops it."""
    found = engine.parse(text, last=engine.parse("raise the mast"), state=["moving"])
    assert found.actions == (Stop(),) or found.denied == (Custom("raise", {}),)


def test_it_is_told_what_was_put_in(engine: IntentEngine) -> None:
    told = engine.explain("close it", last=engine.parse("open the side hatch"))
    assert told.interpretation.text == "close the side hatch"
    assert "heard 'close it'" in told.interpretation.reason
