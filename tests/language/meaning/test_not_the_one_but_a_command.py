"""What is not meant by a part of a command, or objects to what is done, and then the whole command that is."""

from __future__ import annotations

import pytest
from meanings import shipped

from intent_engine.engine import IntentEngine

BAR = """
language: en
slots:
  drink: [tea, coffee]
  table: {type: number, min: 1, max: 20, whole: true}
  thing: {type: text, max_words: 3}
  lamp: [red lamp, blue lamp]
  time: duration
intents:
  serve: {action: custom, sentences: ["bring [a] {drink} to table {table}", "clear [the] table {table}"]}
  take: {action: custom, sentences: ["pick up [the] {thing}"]}
  light: {action: custom, sentences: ["light the {lamp}", "[the] {lamp} on"]}
  ring: {action: custom, sentences: [ring]}
  shake: {action: custom, sentences: ["shake the {drink} at table {table} for {time}"]}
"""


@pytest.fixture(scope="module")
def bar(engine_of) -> IntentEngine:
    return engine_of(BAR)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("not tea, bring a coffee to table 3", "bring a coffee to table 3"),
        ("no, not table 4, clear table 5", "clear table 5"),
        ("Not the red lamp, light the blue lamp please", "light the blue lamp"),
        ("not that, ring", "ring"),
        ("not like that, clear table 5", "clear table 5"),
        ("no, not there, clear table 5", "clear table 5"),
        (
            "don't shake the tea at table 3, shake the tea at table 4 for ten seconds",
            "shake the tea at table 4 for ten seconds",
        ),
        ("please don't shake the tea, but shake the coffee at table 3 for 5 s", "shake the coffee at table 3 for 5 s"),
    ],
)
def test_the_command_is_done(bar: IntentEngine, said: str, plain: str) -> None:
    assert bar.parse(said).actions == bar.parse(plain).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "not tea, bring a tea to table 3",
        "not tea bring a coffee to table 3",
        "not tea, the coffee to table 3",
        "not the red lamp, the blue lamp on",
        "never tea, bring a coffee to table 3",
        "not milk, bring a coffee to table 3",
        "not yet, pick up the cup",
        "not bad, pick up the cup",
        "not so fast, clear table 5",
        "not my fault, clear table 5",
        "not table 4, don't clear table 5",
        "not table 4, he cleared table 5",
        "it is not table 4, clear table 5",
        "not table 4, clear table 5 or 6",
        "not table 4, clear table 50",
        "not if I can help it, clear table 5",
        "not table 4",
        "don't shake the tea at table 3, clear table 5",
        "don't shake the tea at table 3, and shake the coffee at table 3 for 5 s",
        "don't shake, shake the coffee at table 3 for 5 s",
        "she doesn't shake the tea at table 3, shake the coffee at table 3 for 5 s",
    ],
)
def test_what_is_not_clear_is_none(bar: IntentEngine, said: str) -> None:
    assert not bar.parse(said).actions


@pytest.mark.parametrize(
    "said",
    ["not the kitchen, go to the bedroom", "no, not the kitchen, go to the bedroom", "not there, go to the bedroom"],
)
def test_a_way_of_the_shipped_grammar(said: str) -> None:
    assert shipped().parse(said).actions == shipped().parse("go to the bedroom").actions != ()
    assert shipped().parse(said, state=["moving"]).actions == shipped().parse("go to the bedroom").actions
    assert not shipped().parse(said.replace("go to", "he goes to")).actions
