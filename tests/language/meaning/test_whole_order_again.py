"""A correction that is a whole command with its verb takes back all that was said, also where that had no verb."""

from __future__ import annotations

import pytest
from meanings import done, shipped

from intent_engine.engine import IntentEngine


@pytest.fixture(scope="module")
def coffee(root) -> IntentEngine:
    return IntentEngine.from_files(root / "examples/coffee/coffee.yaml")


@pytest.mark.parametrize("correction", ["I mean,", "no,", "sorry,", "no"])
@pytest.mark.parametrize("order", ["can I get iced coffee", "make me a small latte"])
def test_an_order_that_begins_with_its_verb_is_a_whole_one(coffee, correction, order):
    found = coffee.parse(f"americano with some milk, {correction} {order}")
    assert found.actions == coffee.parse(order).actions != ()


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("americano with some milk, no, iced coffee", "iced coffee with some milk"),
        ("americano with some milk, I mean, an iced coffee", "an iced coffee with some milk"),
        ("can I get a large latte with milk, no, with cream", "can I get a large latte with cream"),
    ],
)
def test_without_its_verb_it_takes_the_place_of_a_part(coffee, said, meant):
    assert coffee.parse(said).actions == coffee.parse(meant).actions != ()


def test_so_it_is_with_a_verb_before():
    engine = shipped()
    whole = done(engine.parse("go backward"))
    assert done(engine.parse("go forward two meters, no, go backward")) == whole
    assert done(engine.parse("forward two meters, no, go backward")) == whole
    assert done(engine.parse("left ninety degrees, no, turn right")) == done(engine.parse("turn right"))
