"""Words before what no hand can hold that make a thing of it, and what is no thing though a part of it is named."""

from __future__ import annotations

import pytest
from meanings import does


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("grab the remote control from the chair", "pick remote control"),
        ("put the remote control on the sofa", "place remote control sofa"),
        ("pick up the toy bus", "pick toy bus"),
        ("take the wooden road", "pick wooden road"),
        ("pick up the robot", "pick robot"),
        ("pick up the in tray", "pick in tray"),
        ("take the head of the doll", "pick head of the doll"),
    ],
)
def test_things(said: str, meant: str) -> None:
    assert does(said) == meant


@pytest.mark.parametrize(
    "said",
    [
        "take control", "take the control", "take remote control of the robot", "take the bus",
        "get the phone number of the pizzeria", "take the numbers of the winners", "get the model number",
        "collect data", "fetch data from the server", "pick the winner", "place a bid on the house",
        "place the stress on the syllable",
        "take the good with the bad", "take the with the bad", "pick up the from the floor",
    ],
)  # fmt: skip
def test_no_things(said: str) -> None:
    assert does(said) in ("rejected", "incomplete")
