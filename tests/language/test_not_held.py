"""What no hand can hold is nothing for a slot that lists things: "take your time", "get ready", "take me home"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine

GRAMMAR = """
language: {language}
slots:
  thing: {{type: text, max_words: 4, known: [{known}]}}
intents:
  take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{verbs} {{thing}} [(to|zur) (me|Theke)]"]}}
"""
VERBS = "(take|get|grab|look at)"
NOTHING = [
    "time", "your time", "care", "care of it", "a seat", "a look", "a look around", "a breath", "a deep breath",
    "a nap", "a rest", "a break", "a moment", "a minute", "turns", "aim", "a walk", "some rest", "advice", "the idea",
    "ready", "ready now", "going", "lost", "me home", "us there", "me", "us",
    "yourself", "me the cup", "us a box", "please", "the elevator", "the long way", "that path", "a detour",
    "a better view", "a reading", "a scan", "a glimpse", "your arm", "a position", "the panorama",
    "advantage of it", "control of it", "a view of it", "a scan of it", "the number", "the latest", "the address",
]  # fmt: skip
THINGS = {
    "the seat cover plate": "seat cover plate",
    "the day bed": "day bed",
    "the news stand": "news stand",
    "the seat cushion to me": "seat cushion",
    "the head of lettuce": "head of lettuce",
    "the end of it": "end of it",
    "the elevator key": "elevator key",
    "the scan table": "scan table",
    "the cover": "cover",
    "the sticky notes": "sticky notes",
    "the ready meal": "ready meal",
}
BITTE = ["rücksicht", "abschied", "abstand", "deine zeit", "eine pause", "eine auszeit"]


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR.format(language="en", known="cup, box", verbs=VERBS))


@given(
    st.sampled_from(["take", "get", "grab", "look at"]),
    st.sampled_from(NOTHING),
    st.sampled_from(["", " to me"]),
    st.sampled_from(["", " please", ", please", " right now", ", uh, please"]),
)
def test_nothing_is_taken(engine, verb, said, where, filler):
    assert not engine.parse(f"{verb} {said}{where}{filler}").actions


PERSONS = """
language: en
phrases: {{what: "[up] {{thing}}"}}
slots:
  thing: {{type: {type}, max_words: 3{more}}}
  person: text
intents:
  grab: {{action: {action}, sentences: ["(grab|take|get) {{what}}"]}}
  wave: {{action: custom, sentences: ["wave [(at|to)] {{person}}"]}}
"""


@pytest.mark.parametrize("action", ['{type: pick, object: "{thing}"}', '{type: place, object: "{thing}"}', "custom"])
@pytest.mark.parametrize("said", ["me", "us", "up me", "him", "yourself", "her the cup", "her please"])
def test_no_person_is_a_thing(engine_of, action, said):
    kind = "object" if action == "custom" else "text"
    engine = engine_of(PERSONS.format(type=kind, more="", action=action))
    assert not engine.parse(f"grab {said}").actions
    for thing in ("it", "them", "us flag", "her cup", "doll"):  # "it" was named before
        assert engine.parse(f"grab {thing}").actions, thing
    assert engine.parse("grab me the cup").actions == engine.parse("grab the cup").actions


def test_a_person_may_be_meant_where_no_hand_takes_it(engine_of):
    engine = engine_of(PERSONS.format(type="object", more=", allow: [me]", action="custom"))
    assert engine.parse("grab me").slots == {"thing": "me"}
    assert engine.parse("wave at me").slots == {"person": "me"}


@pytest.mark.parametrize("said", ["nimm mich", "nimm uns bitte", "nimm dich"])
def test_no_person_is_a_thing_in_german(engine_of, said):
    grammar = """
    language: de
    slots: {ding: text}
    intents:
      nehmen: {action: {type: pick, object: "{ding}"}, sentences: ["nimm {ding}"]}
    """
    assert not engine_of(grammar).parse(said).actions
    assert engine_of(grammar).parse("nimm ihn").actions


@pytest.mark.parametrize(("said", "thing"), THINGS.items())
def test_a_thing_may_be_called_by_such_a_word(engine, said, thing):
    (action,) = engine.parse(f"take {said}").actions
    assert action.object == thing


@pytest.mark.parametrize("word", ["seat", "break", "time"])
def test_what_a_slot_lists_is_a_thing(engine_of, word):
    engine = engine_of(GRAMMAR.format(language="en", known=f"cup, {word}", verbs=VERBS))
    (action,) = engine.parse(f"take the {word}").actions
    assert action.object == word


@pytest.mark.parametrize("said", BITTE)
def test_german(engine_of, said):
    engine = engine_of(GRAMMAR.format(language="de", known="Tasse, Kiste", verbs="(nimm|mach)"))
    assert engine.parse("nimm die Kiste").actions
    assert not engine.parse(f"nimm {said}").actions
