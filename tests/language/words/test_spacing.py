"""Words written together and apart: the same command, and never what shall not be done."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.spacing import Spacing

DRONE = """
language: en
fillers: [please]
slots:
  waypoint: [alpha, "delta two"]
  mode: [sport mode, slow motion]
  note: {type: text}
phrases:
  fly: (fly to|head for)
operators:
  stop: [freeze, stand still]
intents:
  take_off: {action: {type: custom, name: take_off}, sentences: ["(take|lift) off [right now]"]}
  land: {action: {type: custom, name: land}, sentences: ["touch down ([slowly];[over there])"]}
  visit: {action: {type: custom, name: visit}, sentences: ["{fly} waypoint {waypoint}", "go a mile"]}
  mode: {action: {type: custom, name: mode}, sentences: ["use {mode}"]}
  write: {action: {type: custom, name: write}, sentences: ["note {note}"]}
"""


@pytest.fixture(scope="module")
def drone(engine_of) -> IntentEngine:
    return engine_of(DRONE)


@pytest.mark.parametrize(
    ("heard", "written"),
    [
        ("takeoff", "take off"),
        ("Liftoff rightnow", "lift off right now"),
        ("touchdown overthere slowly", "touch down over there slowly"),
        ("touch downslowly", "touch down slowly"),
        ("flyto way point alpha", "fly to waypoint alpha"),
        ("headfor waypoint delta two", "head for waypoint delta two"),
        ("please takeoff and then touchdown slowly", "take off and then touch down slowly"),
    ],
)
def test_a_command_is_the_same_together_and_apart(drone, heard, written):
    found = drone.parse(heard)
    assert found.actions == drone.parse(written).actions != ()
    assert found.confidence == 1.0
    assert f"as {written!r}" in found.reason


def test_a_stop_written_together_stops(drone):
    assert drone.parse("standstill").stops
    assert drone.parse("standstill please").stops


@pytest.mark.parametrize(
    "text", ["don't takeoff", "never takeoff", "takeoff no wait", "if you takeoff", "donot take off"]
)
def test_what_shall_not_be_done_is_not_done_together(drone, text):
    assert drone.parse(text).status is not Status.ACCEPTED


@pytest.mark.parametrize("text", ["way, point alpha", "go amile", "fly to way, point alpha", "makeoff", "off take"])
def test_what_is_another_word_or_parted_by_a_pause_is_none(drone, text):
    assert drone.parse(text).actions == ()


@pytest.mark.parametrize(
    ("said", "thing"),
    [
        ("pick up the screw driver", "screwdriver"),
        ("bring me the red note book", "red notebook"),
        ("pick up the tool box", "tool box"),
        ("pick up the toolbox", "toolbox"),
        ("pick up the tooth brush", "toothbrush"),
    ],
)
def test_a_thing_is_written_as_its_list_has_it(said, thing):
    """A program that looks for its screwdriver finds it; what no list has stays as it was said."""
    assert thing in shipped().parse(said).slots.values()
    words = Utterance.of(said)
    assert (Spacing(shipped().grammar).otherwise(words) or words).words[-1] == thing.split()[-1]


SPELLED = """
language: en
slots:
  hour: {type: number, min: 1, max: 12, whole: true}
  half: {values: {am: [%s], pm: [%s]}}
intents:
  wake: {action: custom, sentences: ["wake me [up] at {hour} [%s] [{half}]"]}
  show: {action: custom, sentences: ["switch on the %s", "plug in the %s", "tell us what you see"]}
"""
WAYS = [
    ("a m", "p m", "o clock", "t v", "u s b stick"),
    ("am", "pm", "oclock", "tv", "usb stick"),
    ("a.m.", "p.m.", "o'clock", "TV", "U.S.B. stick"),
]


@pytest.mark.parametrize("ways", WAYS)
@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("wake me at 3 {}", {"hour": 3, "half": "am"}),
        ("wake me at three {1}", {"hour": 3, "half": "pm"}),
        ("wake me up at 3 {2}", {"hour": 3}),
        ("wake me up at three {2} {1}", {"hour": 3, "half": "pm"}),
        ("switch on the {3}", {}),
        ("plug in the {4}", {}),
    ],
)
def test_what_is_spelled_is_the_same_by_its_letters_and_as_a_word(engine_of, ways, said, slots):
    engine = engine_of(SPELLED % ways)
    for other in WAYS:
        found = engine.parse(said.replace("{}", "{0}").format(*other))
        assert (found.status, dict(found.slots)) == (Status.ACCEPTED, slots), other


@pytest.mark.parametrize("said", ["wake me at am", "switch on the vt", "plug in us b stick", "plug in the usd stick"])
def test_other_letters_are_no_such_word(engine_of, said):
    assert not engine_of(SPELLED % WAYS[0]).parse(said).actions


def test_free_words_stay_as_they_were_said(drone):
    assert drone.parse("note way point takeoff").slots == {"note": "way point takeoff"}


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("takeoff", PrefixStatus.EXTENDABLE),
        ("touchdown", PrefixStatus.EXTENDABLE),
        ("headfor", PrefixStatus.INCOMPLETE),
        ("fly to way point", PrefixStatus.INCOMPLETE),
        ("makeoff", PrefixStatus.IMPOSSIBLE),
    ],
)
def test_a_beginning_is_one_together_and_apart(drone, text, status):
    assert drone.prefix(text).status is status


@given(st.data())
def test_words_of_the_shipped_grammar_that_follow_each_other_may_be_written_together(data):
    """With what they mean, unless the grammar has that word, or one of them changes what is meant."""
    grammar = shipped().grammar
    commands = [
        "pick up the cup",
        "put down the ball",
        "turn around",
        "move straight ahead",
        "come back here",
        "stop right there",
        "let go of the bottle",
        "turn left and then go back two meters",
    ]
    words = data.draw(st.sampled_from(commands)).split()
    meant = shipped().parse(" ".join(words)).actions
    known = Spacing(grammar)
    joints = [place for place, (one, other) in enumerate(pairwise(words)) if known.otherwise(Utterance.of(one + other))]
    at = data.draw(st.sampled_from(joints))
    said = [*words[:at], words[at] + words[at + 1], *words[at + 2 :]]
    assert shipped().parse(" ".join(said)).actions == meant != ()


@given(st.lists(st.sampled_from(["take", "off", "takeoff", "way", "point", "waypoint", "touchdown", "sport", "mode"])))
def test_what_is_written_as_the_grammar_has_it_is_not_written_otherwise(drone, words):
    spacing = Spacing(drone.grammar)
    once = spacing.otherwise(Utterance.of(" ".join(words)))
    assert once is None or spacing.otherwise(once) is None
    assert once is None or "".join(once.words) == "".join(words)
    assert once is None or len(once.words) == len(once.breaks)
