"""Where one part of a sentence ends and the next begins."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status


@pytest.mark.parametrize(
    ("text", "slots"),
    [
        # A word of the grammar is read as such before a free slot takes it.
        ("lift up the bottle", {"thing": "bottle"}),
        ("take hold of the cup", {"thing": "cup"}),
        ("fetch me the cup from the table", {"thing": "cup", "source": "table"}),
        ("lay down the cup beside the plate", {"thing": "cup", "target": "plate"}),
        ("lay the cup on to the tray", {"thing": "cup", "target": "tray"}),
        ("take the cup off of the shelf", {"thing": "cup", "source": "shelf"}),
        # A unit of one letter is no stutter.
        ("t turn left", {"side": "left"}),
        ("start going for 2s straight", {"direction": "forward", "duration": 2.0}),
        ("2 m/s straight", {"direction": "forward", "speed": 2.0}),
        # A number is never cut in two.
        ("turn right seventy five dps", {"side": "right", "turn_speed": math.radians(75)}),
        ("turn left ninety degrees slowly", {"side": "left", "angle": math.pi / 2, "turn_speed": 0.5}),
        ("go forward four meters half a meter per second", {"direction": "forward", "distance": 4.0, "speed": 0.5}),
        (
            "go forward four meters and a half at a meter per second",
            {"direction": "forward", "distance": 4.5, "speed": 1},
        ),
        # A quarter is one of a turn.
        ("take a quarter turn left", {"side": "left", "angle": math.pi / 2}),
        ("make a 90 turn left", {"side": "left", "angle": math.pi / 2}),
        ("make a 2 turn left", {"side": "left", "angle": 4 * math.pi}),
    ],
)
def test_each_word_belongs_to_one_part(engine, text, slots):
    found = engine.parse(text)
    assert found.status is Status.ACCEPTED, found.reason
    assert set(found.slots) == set(slots)
    for label, value in slots.items():
        assert found.slots[label] == (value if isinstance(value, str) else pytest.approx(value))


@pytest.mark.parametrize(
    ("text", "slots"),
    [
        # Fillers stand in no free words, and take nothing from a sentence that needs them.
        ("pick up uh the cup please", {"thing": "cup"}),
        ("put the um cup on like the table", {"thing": "cup", "target": "table"}),
        ("wait for me uh in the kitchen", {"place": "kitchen"}),
        ("okay turn about", {"side": "left", "angle": math.pi}),
        ("uh again please", {}),
        # A value with its unit takes the place of all that was said before, a number alone that of the number.
        ("back up point seven five meters no three meters", {"direction": "backward", "distance": 3.0}),
        ("go forward for 1 minute and 45 seconds oh no three minutes", {"direction": "forward", "duration": 180.0}),
        ("go forward two meters no three", {"direction": "forward", "distance": 3.0}),
        ("spin anti clockwise no clockwise", {"side": "right"}),
        # Free words hold no command that is meant instead, and no words that take something back.
        ("pick the hammer up, no, pick up the box", {"thing": "box"}),
        ("check on the ball, scratch that, go to the dock", {"place": "dock"}),
    ],
)
def test_fillers_and_corrections_touch_only_what_they_mean(engine, text, slots):
    test_each_word_belongs_to_one_part(engine, text, slots)


@pytest.mark.parametrize(
    "text",
    [
        "lift behind you",
        "leave it a bit to the counterclockwise",
        "take two degrees",
        # However it is measured, an amount is no thing,
        "carry eighty pounds to the kitchen",
        "bring me half a kilo",
        "grab 5 ml",
        # and one that is not finished is none.
        "bring me a couple of feet about half a",
        "bring me half a",
        "pick up the cup, no, less",
        "put it on the table at least",
        # "That" is all that is named.
        "take that back",
        "take those back",
    ],
)
def test_directions_and_amounts_are_nothing_to_hold(engine, text):
    assert not engine.parse(text).actions


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ("bring me five pounds of flour", "five pounds of flour"),
        ("pick up the 5 kg weight", "5 kg weight"),
        ("fetch half a melon", "half a melon"),
        ("bring me box a", "box a"),
        ("take that back wheel", "back wheel"),
        ("take that", "that"),
    ],
)
def test_what_is_measured_or_pointed_at_is_a_thing(engine, text, thing):
    assert engine.parse(text).slots["thing"] == thing


@pytest.mark.parametrize("joint", ["and half", "and a half", "and a quarter of"])
def test_half_of_one_quantity_is_no_beginning_of_the_next(engine, joint):
    """ "At half a meter per second" is often heard so."""
    found = engine.parse(f"go forward four meters {joint} a meter per second")
    assert found.status is not Status.ACCEPTED
    assert not found.actions


@pytest.mark.parametrize(
    "text", ["get hold of the parcel sorry locate the umbrella", "check the ball scratch that home"]
)
def test_what_replaces_what_is_not_guessed(engine, text):
    thing = engine.parse(text).slots.get("thing", "")
    assert "locate" not in thing
    assert "scratch" not in thing


def test_no_filler_takes_a_part_of_an_operator(tmp_path):
    (tmp_path / "doch.yaml").write_text(
        "language: de\nfillers: [doch, bitte]\noperators: {correction: [doch lieber]}\n"
        "slots: {side: {type: choice, values: {left: [links], right: [rechts]}}}\n"
        "intents: {turn: {action: {type: turn, direction: '{side}'}, sentences: ['nach {side}']}}\n",
        "utf-8",
    )
    engine = IntentEngine.from_files(tmp_path / "doch.yaml")
    assert engine.parse("doch nach links bitte").slots == {"side": "left"}
    assert engine.parse("nach rechts doch lieber links").slots == {"side": "left"}


def test_a_correction_may_hold_a_word_that_negates(tmp_path):
    (tmp_path / "es.yaml").write_text(
        "language: es\nslots: {lado: {type: choice, values: {left: [izquierda], right: [derecha]}}}\n"
        "intents: {girar: {action: {type: turn, direction: '{lado}'}, sentences: ['gira a la {lado}']}}\n",
        "utf-8",
    )
    engine = IntentEngine.from_files(tmp_path / "es.yaml")
    assert engine.parse("gira a la izquierda no espera derecha").slots == {"lado": "right"}
    for text in ("no gira a la izquierda", "no no gira a la izquierda", "gira a la izquierda no no gira a la derecha"):
        assert not engine.parse(text).actions, text


def test_a_place_is_corrected_by_a_place(tmp_path):
    (tmp_path / "meet.yaml").write_text(
        "language: en\nslots: {who: {type: text, max_words: 1}, where: {type: location}, n: {type: number}}\n"
        "intents:\n  meet: {action: {type: custom, name: meet}, sentences: ['meet {who} at {where}', 'count {n}']}\n",
        "utf-8",
    )
    engine = IntentEngine.from_files(tmp_path / "meet.yaml", locations={"home": (0, 0), "front room": (1, 1)})
    assert engine.parse("meet anna at front room actually home").slots == {"who": "anna", "where": "home"}
    assert engine.parse("count one point two five no seventeen").slots == {"n": 17.0}


@pytest.mark.parametrize(
    "text", ["get bay three", "get bay 3", "wait for me in bay three", "go to the dock no bay three"]
)
def test_numbers_in_names_are_exact_in_words_and_digits(root, text):
    """Where nothing is guessed: beside a sentence with free words, and in a correction."""
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml", locations={"bay 3": (1.0, 2.0), "dock": (0.0, 0.0)})
    found = engine.parse(text)
    assert (found.intent, found.slots) == ("navigate", {"place": "bay 3"})
    assert found.confidence == 1.0
    assert engine.parse("go to bay").status is not Status.ACCEPTED


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("turn right then go forward", [("turn", "right"), ("move", "forward")]),
        ("turn right, then go forward", [("turn", "right"), ("move", "forward")]),
        ("go right then left", [("turn", "right"), ("turn", "left")]),
        ("right, then turn left", [("turn", "right"), ("turn", "left")]),
        ("right then left", [("turn", "right"), ("turn", "left")]),
        ("turn left then right then left", [("turn", "left"), ("turn", "right"), ("turn", "left")]),
        ("turn left and right then go forward", [("turn", "left"), ("turn", "right"), ("move", "forward")]),
        ("right then right then drive", [("turn", "right"), ("turn", "right"), ("move", "forward")]),
        ("turn left, right then go forward", [("turn", "left"), ("turn", "right"), ("move", "forward")]),
        ("right then, right then left", [("turn", "right"), ("turn", "left")]),
        ("okay right then left, then right", [("turn", "right"), ("turn", "left"), ("turn", "right")]),
        ("turn left and go ahead and turn right", [("turn", "left"), ("turn", "right")]),
    ],
)
def test_a_filler_that_joins_commands_is_none_between_them(engine, text, steps):
    found = engine.parse(text)
    assert [(step["intent"], *step["slots"].values()) for step in found.slots["steps"]] == steps


@pytest.mark.parametrize(
    "text",
    [
        "right then, turn left",
        "right then, right then, turn left",
        "okay, right then, turn left",
        "please go ahead and turn left",
    ],
)
def test_but_it_opens_one(engine, text):
    assert engine.parse(text).slots == {"side": "left"}


@pytest.mark.parametrize("text", ["right then turn left", "right then go forward", "uh right then turn left go on"])
def test_where_it_may_be_a_command_or_open_one_nothing_is_done(engine, text):
    found = engine.parse(text)
    assert found.status is Status.AMBIGUOUS
    assert len(found.alternatives) == 2
    assert found.alternatives[0] == f"turn (side: right), then {found.alternatives[1]}"
    assert "pause" in found.reason


@pytest.mark.parametrize(("text", "status"), [("right then", "rejected"), ("right then don't go", "rejected")])
def test_nor_is_it_one_without_another(engine, text, status):
    assert engine.parse(text).status == status


@pytest.mark.parametrize("text", ["right then stop", "right then left stop", "right then stop turning"])
def test_a_stop_is_one_whatever_opens_it(engine, text):
    assert engine.parse(text).actions == (Stop(),)


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("turn left and do that again", "turn left and turn left"),
        ("turn left then again then go forward", "turn left, turn left and go forward"),
        ("turn left and then once more, please", "turn left and turn left"),
        ("turn left again and go forward", "turn left and go forward"),
        ("turn left and again turn right", "turn left and turn right"),
    ],
)
def test_a_filler_may_be_a_command_of_a_list(engine, text, same):
    assert engine.parse(text).actions == engine.parse(same).actions != ()


@pytest.mark.parametrize(
    "begin", ["but", "and", "and then", "but then", "instead", "okay but", "but please", "but can you", "rather"]
)
@pytest.mark.parametrize("text", ["turn left", "go to the kitchen and turn left", "pick up the cup", "stop"])
def test_what_goes_on_from_before_says_nothing_where_an_utterance_begins(engine, begin, text):
    assert engine.parse(f"{begin} {text}").actions == engine.parse(text).actions


@pytest.mark.parametrize(
    "text",
    ["but", "and then", "but we go to the kitchen", "but don't turn left", "turn left but", "but the kitchen is cold"],
)
def test_nor_does_it_make_a_command(engine, text):
    assert not engine.parse(text).actions


@pytest.mark.parametrize(
    ("text", "angle"),
    [
        ("turn left one oh five degrees", 105),
        ("please turn left one oh five degrees", 105),
        ("oh turn left fifteen degrees oh", 15),
        ("turn left one, oh, five degrees", None),
        ("uh turn left one, oh, five degrees", None),
        ("turn left one uh five degrees", None),
    ],
)
def test_an_oh_between_two_numbers_is_a_digit_unless_there_is_a_pause(engine, text, angle):
    slots = engine.parse(text).slots
    assert slots == ({} if angle is None else {"side": "left", "angle": pytest.approx(math.radians(angle))})


@given(st.integers(1, 720), st.sampled_from(["rotate", "turn left", "turn by", "turn right"]), st.booleans())
def test_degrees_need_not_be_said_to_either_side(degrees, how, minus):
    """From five on: "the right one" turns by no degree, nor does "rotate minus one"."""
    said = f"{how} {'minus ' * minus}{degrees}"
    bare, whole = shipped().parse(said), shipped().parse(f"{said} degrees")
    sided = minus and not {"left", "right"}.isdisjoint(how.split())  # which of both ways?
    assert bool(whole.actions) != sided
    assert bare.actions == (whole.actions if degrees >= 5 else ())
