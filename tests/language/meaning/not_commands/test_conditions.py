"""A filler from which a clause goes on is a condition: "if you can turn left, go forward" asks for nothing yet."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import assert_same, does

NOTHING = ("rejected", "ambiguous", "incomplete")
COMMANDS = {
    "turn left": "left 43",
    "go forward": "forward 1",
    "go to the kitchen": "to kitchen",
    "back up a yard": "back 0.9144",
}
ONE, OTHER = st.sampled_from(sorted(COMMANDS)), st.sampled_from(sorted(COMMANDS))
FILLER = st.sampled_from(["if you can", "if you could", "please if you can", "if you could please"])
NEGATED = st.sampled_from(["if you can't", "if you can not", "if you couldn't"])


@given(FILLER, ONE, OTHER, st.sampled_from([", ", " ", " then ", ", then ", ", please "]))
def test_a_command_beside_a_condition_is_not_done(filler: str, one: str, other: str, joint: str) -> None:
    assert does(f"{filler} {one}{joint}{other}") in NOTHING


@given(ONE, OTHER, NEGATED, st.sampled_from([", ", " "]))
def test_nor_is_one_beside_what_cannot_be(one: str, other: str, negated: str, joint: str) -> None:
    assert does(f"{negated} {one}{joint}{other}") in NOTHING
    assert does(f"{one}{joint}{negated} {other}") in NOTHING


@given(ONE, OTHER)
def test_nor_one_with_its_condition_behind_it(one: str, other: str) -> None:
    assert does(f"{one} if you can {other}") in NOTHING


@given(FILLER, ONE)
def test_by_itself_it_is_a_polite_command(filler: str, one: str) -> None:
    done = COMMANDS[one]
    assert does(f"{filler}, {one}") == does(f"{filler} {one}") == done
    assert does(f"{one} {filler}") == does(f"{one}, {filler}") == done


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("if you could go to the kitchen and turn left", "to kitchen, left 43"),
        ("if you can, turn left and go forward", "left 43, forward 1"),
        ("if you can, turn left, go forward", "left 43, forward 1"),
        ("turn left if you can, and go forward", "left 43, forward 1"),
        ("turn left if you can and then go forward", "left 43, forward 1"),
        ("pick up the cup and the plate if you can", "pick cup, pick plate"),
        ("if you could turn left, no, right", "right 43"),
        ("if you could turn left and go forward, pick up the cup", "rejected"),
        ("if you can go forward two and a half meters, turn left", "rejected"),
        ("if you can turn left, stop", "stop"),
    ],
)
def test_what_is_joined_by_and_is_one_clause(said: str, done: str) -> None:
    assert does(said) == done


POLITE = {
    "en": ("lower the arm", "open the gate", "if you can", "if you can lower the arm"),
    "de": ("senke den Arm", "öffne das Tor", "wenn du kannst", "wenn du den Arm senken kannst"),
    "fr": ("baisse le bras", "ouvre la porte", "si tu peux", "si tu peux baisser le bras"),
    "es": ("baja el brazo", "abre la puerta", "si puedes", "si puedes bajar el brazo"),
    "it": ("abbassa il braccio", "apri la porta", "se puoi", "se puoi abbassare il braccio"),
}


@pytest.mark.parametrize("language", sorted(POLITE))
def test_grammars_that_list_no_fillers_know_it(engine_of, language: str) -> None:
    one, other, filler, condition = POLITE[language]
    engine = engine_of(f"""
language: {language}
intents:
  one: {{action: custom, sentences: ["{one}"]}}
  other: {{action: custom, sentences: ["{other}"]}}
""")
    for said in (f"{filler}, {one}", f"{one} {filler}", f"{one}, {filler}"):
        assert_same(engine, said, one)
    for said in (f"{condition}, {other}", condition):  # what is asked of it may follow
        assert not engine.parse(said).actions
