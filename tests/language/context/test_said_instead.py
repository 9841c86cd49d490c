"""What is typed in the place of what was said before: "no, the heater", after "turn on the lamp"."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.actions import Custom, Navigate
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation

DEVICES = ["lamp", "heater", "fan"]
GRAMMAR = """
language: en
slots:
  device: [lamp, heater, fan]
  level: percent
  message: {type: text, max_words: 8}
intents:
  light: {action: custom, sentences: ["turn on [the] {device}"]}
  quench: {action: custom, sentences: ["turn off [the] {device}"]}
  dim: {action: custom, sentences: ["dim [the] {device} to {level}"]}
  say: {action: custom, sentences: ["say {message}"]}
"""


@pytest.fixture(scope="module")
def own(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def done(found: Interpretation) -> list[tuple[str, dict[str, object]]]:
    return [(action.name, dict(action.slots)) for action in found.actions if isinstance(action, Custom)]


@pytest.mark.parametrize(
    ("before", "text", "instead"),
    [
        ("turn on the lamp", "no, the heater", ("light", {"device": "heater"})),
        ("turn on the lamp", "I mean the heater", ("light", {"device": "heater"})),
        ("turn on the lamp", "sorry, the fan", ("light", {"device": "fan"})),
        ("turn on the lamp", "no, off", ("quench", {"device": "lamp"})),
        ("turn on the lamp", "no, the fan instead", ("light", {"device": "fan"})),
        ("turn on the lamp", "the fan instead.", ("light", {"device": "fan"})),
        ("turn on the lamp", "not the lamp, the fan", ("light", {"device": "fan"})),
        ("turn on the lamp", "no, not the lamp, the fan", ("light", {"device": "fan"})),
        ("turn on the lamp", "not the lamp but the fan", ("light", {"device": "fan"})),
        ("dim the lamp to 20 percent", "no, thirty", ("dim", {"device": "lamp", "level": 0.3})),
        ("dim the lamp to 20 percent", "no, the fan", ("dim", {"device": "fan", "level": 0.2})),
    ],
)
def test_it_is_done_and_what_was_said_is_denied(own, before, text, instead):
    first = own.parse(before)
    found = own.parse(text, last=first)
    assert done(found) == [instead]
    assert found.denied == first.actions


@pytest.mark.parametrize("text", ["no, the heater", "I mean the heater"])
def test_of_what_was_added_alone_another_takes_the_place(own, text):
    added = own.parse("and the fan", last=own.parse("turn on the lamp"))
    found = own.parse(text, last=added)
    assert (done(found), found.denied) == ([("light", {"device": "heater"})], added.actions)
    assert (found.intent, found.slots) == ("light", {"device": "heater"})


def test_what_was_said_with_a_pronoun_is_corrected(engine_of):
    library = engine_of("""
language: en
slots: {book: {type: object}, shelf: {type: number, min: 1, max: 80, whole: true}}
intents:
  fetch: {action: {type: pick, object: "{book}"}, sentences: ["fetch {book}"]}
  shelve: {action: custom, sentences: ["put {book} on shelf {shelf}"]}
""")
    fetched = library.parse("fetch the atlas")
    shelved = library.parse("put it on shelf 14", last=fetched)
    found = library.parse("no, shelf 15", last=shelved)
    assert done(found) == [("shelve", {"book": "atlas", "shelf": 15})]
    assert found.denied == shelved.actions


@given(st.lists(st.sampled_from(DEVICES), min_size=2, max_size=5))
def test_each_takes_the_place_of_the_one_before(own, devices):
    last = own.parse(f"turn on the {devices[0]}")
    for before, device in pairwise(devices):
        found = own.parse(f"no, the {device}", last=last)
        if device == before:
            assert not found.actions
        else:
            assert done(found) == [("light", {"device": device})]
            last = found


@pytest.mark.parametrize(
    ("before", "text"),
    [
        ("turn on the lamp", "no, thanks"),
        ("turn on the lamp", "no, the lamp"),
        ("turn on the lamp", "no, the weather"),
        ("turn on the lamp", "no turn on the fan"),  # which may forbid it
        ("turn on the lamp", "no no dim the fan to ten percent"),
        ("turn on the lamp", "the heater"),
        ("turn on the lamp", "no, the heater?"),
        ("turn on the lamp", "the weather instead"),
        ("turn on the lamp", "instead"),
        ("turn on the lamp and the fan", "no, the heater"),
        ("say hello", "no, it was late"),
        ("say hello", "sorry, my bad"),
    ],
)
def test_other_words_put_nothing_in_its_place(own, before, text):
    first = own.parse(before)
    assert first.actions
    assert not own.parse(text, last=first).actions


def test_what_is_spoken_has_its_time(own):
    first = own.parse("turn on the lamp")
    assert not own.parse("no, the heater", last=first, heard=True).actions


def test_a_program_that_gives_no_last_hears_no_correction(own):
    assert not own.parse("no, the heater").actions


def test_a_robot_that_has_arrived_goes_on_and_one_that_moves_stops():
    engine = shipped()
    first = engine.parse("go to the kitchen")
    there = engine.parse("no, the bedroom", last=first)
    assert [action.location for action in there.actions if isinstance(action, Navigate)] == ["bedroom"]
    assert engine.parse("no, the bedroom", last=first, state=["moving"]).stops
    assert engine.parse("the bedroom instead", last=first, state=["moving"]).stops


def test_a_drive_that_was_driven_cannot_be_another():
    assert not shipped().parse("no, back", last=shipped().parse("go forward")).actions
