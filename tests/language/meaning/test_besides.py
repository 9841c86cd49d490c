"""Words behind a command that say only that it is done besides, or before it that somebody agrees."""

from __future__ import annotations

import pytest
from meanings import german, shipped

from intent_engine.engine import IntentEngine

SHED = """
language: en
slots:
  lamp: [red lamp, blue lamp]
  angle: {type: angle, unit: deg}
  time: duration
  note: {type: text, max_words: 6, dictation: true}
  crates: {type: number, whole: true, max: 9}
intents:
  light: {action: custom, sentences: ["light the {lamp}"]}
  tilt: {action: custom, sentences: ["tilt the shelf [{angle}]"]}
  ring: {action: custom, sentences: ["ring [for {time}]"]}
  note: {action: custom, sentences: ["note {note}"]}
  bring: {action: custom, sentences: ["bring {crates} crates", "bring the {lamp}"]}
  follow: {action: custom, sentences: ["follow [for {time}]"]}
"""


@pytest.fixture(scope="module")
def shed(engine_of) -> IntentEngine:
    return engine_of(SHED)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("light the red lamp as well", "light the red lamp"),
        ("light the red lamp too", "light the red lamp"),
        ("light the red lamp also", "light the red lamp"),
        ("and also light the red lamp as well, please", "light the red lamp"),
        ("light the red lamp as well and then ring", "light the red lamp and then ring"),
        ("ring for ten seconds as well", "ring for ten seconds"),
        ("light the red lamp next, please", "light the red lamp"),
        ("light the red lamp next, then ring", "light the red lamp, then ring"),
        ("light the red lamp and ring after that", "light the red lamp and ring"),
        ("could you light that red lamp afterwards", "light the red lamp"),
        ("light your red lamp as well", "light the red lamp"),
        ("let's get the red lamp lit again", "light the red lamp"),
        ("tilt the shelf one more time", "tilt the shelf"),
        ("ring as soon as possible", "ring"),
        ("go on and light the red lamp", "light the red lamp"),
        ("let me see you light the red lamp", "light the red lamp"),
        ("it would be great if you could just light the red lamp", "light the red lamp"),
        ("first of all, would you mind lighting the red lamp", "light the red lamp"),
        ("you'd better light the red lamp now", "light the red lamp"),
        ("yes, light the red lamp", "light the red lamp"),
        ("sure, light the red lamp and ring", "light the red lamp and ring"),
        ("Perfect. Ring for ten seconds!", "ring for ten seconds"),
        ("right, ring", "ring"),
        ("go and light the red lamp", "light the red lamp"),
        ("go light the red lamp", "light the red lamp"),
        ("do you think you could light the red lamp?", "light the red lamp"),
        ("make sure you light the red lamp", "light the red lamp"),
        ("start ringing", "ring"),
        ("light the red lamp, thank you very much", "light the red lamp"),
        ("pls light the red lamp", "light the red lamp"),
        ("light the red lamp again", "light the red lamp"),
        ("ring again for ten seconds", "ring for ten seconds"),
        ("ring for ten seconds once more, please", "ring for ten seconds"),
        ("light the red lamp again and ring", "light the red lamp and ring"),
        ("bring me three crates", "bring three crates"),
        ("bring us the red lamp", "bring the red lamp"),
        ("light the red lamp instead", "light the red lamp"),
        ("no, light the red lamp instead, please", "light the red lamp"),
        ("don't ring, light the red lamp instead", "light the red lamp"),
        ("light the red lamp, no, ring instead", "ring"),
    ],
)
def test_it_is_the_same_command(shed: IntentEngine, said: str, plain: str) -> None:
    assert shed.parse(said).actions == shed.parse(plain).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "don't light the red lamp too",
        "light the red lamp as well as you can",
        "light the red lamp next to the blue lamp",
        "light the red lamp, next to the blue lamp",
        "light the red lamp next week",
        "the red lamp is next",
        "they light the red lamp next",
        "light one more time",
        "ring for one more time",
        "as soon as possible",
        "as soon as the red lamp is lit ring",
        "let me see the red lamp",
        "let me see if you light the red lamp",
        "you'd better light the red lamp",
        "you'd better light the red lamp now?",
        "you'd better not light the red lamp now",
        "he'd better light the red lamp now",
        "light as well",
        "too",
        "yes light",
        "yes, it lights the red lamp",
        "yes, don't ring",
        "sure thing, light the red lamp",
        "good light the red lamp",
        "make sure you don't light the red lamp",
        "go and see whether the red lamp is lit",
        "they go and light the red lamp",
        "follow me for ten seconds",  # is done to somebody, and not for him
        "bring me ten seconds",
        "bring me to the red lamp",
        "light the red lamp, ring instead",  # both, or one?
        "light the red lamp and ring instead",
        "light the red lamp or the blue lamp instead",
        "don't light the red lamp instead",
        "we ring instead",
        "instead",
    ],
)
def test_what_says_something_else_is_none(shed: IntentEngine, said: str) -> None:
    assert not shed.parse(said).actions


@pytest.mark.parametrize("said", ["tilt the shelf too", "ring for 20 minutes too", "ring for two hours too"])
def test_it_may_be_a_number_that_was_heard(shed: IntentEngine, said: str) -> None:
    """Neither a tilt by two degrees, nor one as far as usual; and no 20 minutes and 2 seconds."""
    assert "may be a number" in shed.parse(said).reason
    assert shed.parse(said.replace("too", "as well")).actions


@pytest.mark.parametrize(
    "said",
    [
        "ring for 20 minutes, too",
        "tilt the shelf ten degrees, too!",
        "please ring for two hours, too, and follow",
        "bring 3 crates, too",
    ],
)
def test_behind_an_amount_and_a_pause_it_is_none(shed: IntentEngine, said: str) -> None:
    assert shed.parse(said).actions == shed.parse(said.replace(", too", "")).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "tilt the shelf, too",
        "ring, too for hours",
        "ring for 20 minutes, two",
        "don't ring for 20 minutes, too",
        "ring for 20 minutes, too long",
    ],
)
def test_behind_another_word_or_with_more_it_may_be(shed: IntentEngine, said: str) -> None:
    assert not shed.parse(said).actions


def test_the_shipped_grammar_drives_so_far_besides() -> None:
    for far in ("move forward 2 meters", "turn left 90 degrees"):
        assert shipped().parse(f"{far}, too").actions == shipped().parse(far).actions != ()
        assert not shipped().parse(f"{far} too").actions


def test_a_number_is_one_where_nothing_is_whole_without_it(shed: IntentEngine) -> None:
    assert shed.parse("bring too crates", heard=True).slots == {"crates": 2}


def test_a_dictated_text_keeps_it(shed: IntentEngine) -> None:
    assert shed.parse("note the lamp is red too").slots == {"note": "the lamp is red too"}


def test_other_languages_have_theirs() -> None:
    assert german().parse("fahr in die Küche auch").actions == german().parse("fahr in die Küche").actions != ()


def test_a_place_that_is_not_on_the_map_is_still_told_of_a_way() -> None:
    assert shipped().parse("go to the room 206").reason == "no place is called 'room 206'"


@pytest.mark.parametrize("said", ["fine, don't move", "Perfect, hold on.", "yes, wait there"])
def test_a_robot_that_moves_is_held_by_who_agrees_as_well(shed: IntentEngine, said: str) -> None:
    assert shed.parse(said, state=["moving"]).stops
    assert not shed.parse(said).actions


@pytest.mark.parametrize("said", ["pick up the red box one more time", "pick up the red box again"])
def test_how_often_is_no_part_of_a_thing(engine_of, said: str) -> None:
    engine = engine_of("""
language: en
slots: {thing: object, song: {type: text, max_words: 4}}
intents:
  pick: {action: custom, sentences: ["pick up [the] {thing}"]}
  play: {action: custom, sentences: ["play {song}"]}
""")
    assert engine.parse(said).slots == {"thing": "red box"}
    assert engine.parse("play baby one more time").slots == {"song": "baby one more time"}
