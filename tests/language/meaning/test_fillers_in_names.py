"""A filler that tells which thing is meant is a part of its name: between the article and the rest, in one breath."""

from __future__ import annotations

import pytest
from meanings import does, shipped


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("pick up the first aid kit", "pick first aid kit"),
        ("pick up the first box and put it on the table", "pick first box, place first box table"),
        ("turn left and pick up the first box", "left 43, pick first box"),
        ("pick up the good scissors please", "pick good scissors"),
        ("put the cup in the cool box", "place cup cool box"),
        ("okay robot pick up that robot toy", "pick robot toy"),
        ("take the more expensive bottle", "pick more expensive bottle"),
        ("Grab a nice big apple from the table.", "pick nice big apple"),
        ("pick up the hello kitty mug", "pick hello kitty mug"),
        # Between pauses, at an end or before another filler they say nothing, nor do those that only hesitate.
        ("pick up the, great, cup", "pick cup"),
        ("pick up the toy robot", "pick toy"),
        ("pick up the uh cup", "pick cup"),
        ("pick up the like red cup", "pick red cup"),
        ("pick up the cup first", "pick cup"),
        ("look for the good in people", "rejected"),
        ("first pick up the cup", "pick cup"),
        # Nor where the sentence has the next word, or no thing is named.
        ("take a good look at the cup", "look"),
        ("make a nice left turn", "left 43"),
        ("turn the robot left", "left 43"),
        ("go to the nice kitchen", "to kitchen"),
    ],
)
def test_names(said: str, meant: str) -> None:
    assert does(said) == meant


def test_a_name_of_what_is_brought() -> None:
    assert shipped().parse("bring me the first aid kit").slots == {"thing": "first aid kit"}


def test_other_grammars(engine_of) -> None:
    engine = engine_of("""
    slots:
      part: {type: text, known: [bolt, arm]}
    intents:
      fetch: {action: custom, sentences: ["fetch {part} [quickly]"]}
    """)
    assert engine.parse("fetch the first bolt").slots == {"part": "first bolt"}
