"""Where one name ends and the next begins is asked, where that is another action and nobody can know."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, done, german, shipped

from intent_engine import Status
from intent_engine.language.sampler import sample

THINGS = st.sampled_from(["the cup", "a red box", "my book", "the bag of rice"])
WHERE = st.sampled_from(["on", "in", "under", "next to", "inside of"])
PLACES = st.sampled_from(["the table", "the shelf", "a box", "the sink"])
BEHIND = st.sampled_from(["on", "in", "by", "near"])
"""One word, so that the place has no more than a name may have."""
PUT = st.sampled_from(["put", "place", "leave", "could you please put", "put down"])


@given(PUT, THINGS, WHERE, PLACES, BEHIND, PLACES)
def test_whose_place_it_is_is_asked(put, thing, where, place, behind, other):
    found = shipped().parse(f"{put} {thing} {where} {place} {behind} {other}")
    assert found.status is Status.AMBIGUOUS
    bare = [" ".join(word for word in name.split() if word not in ("the", "a", "my")) for name in (thing, other)]
    assert len(found.alternatives) == 2
    assert f"thing: {bare[0]}, " in found.alternatives[0]
    assert found.alternatives[1].endswith(f"target: {bare[1]})")


@given(THINGS, WHERE, PLACES)
def test_one_place_is_the_place(thing, where, place):
    assert shipped().parse(f"put {thing} {where} {place}").status is Status.ACCEPTED


@given(st.sampled_from(["it", "that", "them", "those"]), WHERE, PLACES, BEHIND, PLACES)
def test_it_is_a_whole_name(it, where, place, behind, other):
    found = shipped().parse(f"put {it} {where} {place} {behind} {other}")
    assert found.slots["thing"] == it


@given(st.sampled_from(["pick up", "grab", "take hold of"]), THINGS, st.sampled_from(["on", "in", "from"]), PLACES)
def test_where_it_is_now_may_be_said_at_length(take, thing, where, place):
    """What is taken is the same, whatever the table is in."""
    one, other = (shipped().parse(f"{take} {thing} {where} {place}{more}") for more in ("", " in the kitchen"))
    assert one.actions == other.actions


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("put the cup down on the table in the kitchen", "place cup table in the kitchen"),
        ("put the cup from the sink on the table", "place cup from the sink table"),  # nothing is put from anywhere
        ("put the cup on the edge of the table", "place cup edge of the table"),
        ("pick up the cup and put it on the table in the kitchen", "pick cup, place cup table in the kitchen"),
        ("put the cup on the table and the plate on the shelf in the kitchen", "rejected"),
        ("put the cup on the table in the kitchen and go back", "rejected"),
        ("take it to the table in the kitchen", "bring"),
        ("take the cup from the table to the kitchen", "bring"),
    ],
)
def test_what_is_clear_is_done(text, meant):
    assert does(text) == meant


def test_in_german():
    assert done(german().parse("stell die Tasse auf den Tisch in der Küche")) == "ambiguous"
    assert done(german().parse("stell die Tasse auf den Tisch")) == "place tasse tisch"


PLAIN = """
language: en
slots:
  title: {type: text, max_words: 6}
  artist: {type: text}
  thing: {type: object}
  spot: {type: text}
intents:
  play: {action: custom, sentences: ["play {title} by {artist}"]}
  load: {action: custom, sentences: ["load [the] {thing} (on|in) [the] {spot} [now]"]}
  count: {action: {type: custom, name: count}, sentences: ["count {thing} on {spot} twice"]}
"""


def test_in_other_grammars(engine_of):
    engine = engine_of(PLAIN)
    assert engine.parse("play stand by me by ben e king").slots == {"title": "stand by me", "artist": "ben e king"}
    for text in ("load the crate on the cart in the yard", "count boxes on carts on rails twice"):
        assert engine.parse(text).status is Status.AMBIGUOUS, text
    assert engine.parse("load the crate on the cart").slots == {"thing": "crate", "spot": "cart"}


LIGHTS = """
slots:
  room: [living, living room, hall]
  lamp: [light, room light, spot]
intents:
  dim: {action: custom, sentences: ["dim [the] {room} {lamp}", "swap [the] {room} and [the] {room:by}"]}
"""


@pytest.mark.parametrize(
    ("said", "ways"),
    [
        ("dim the living room light", ("dim (room: living, lamp: room light)", "dim (room: living room, lamp: light)")),
        ("dim the living room room light", ()),
        ("dim the living light", ()),
        ("dim the living room spot", ()),
        ("swap the living room and the living", ()),
    ],
)
def test_names_of_lists_of_which_one_ends_as_the_other_begins_are_asked_about(engine_of, said, ways):
    engine = engine_of(LIGHTS)
    found = engine.parse(said)
    assert set(found.alternatives) == set(ways)
    assert bool(found.actions) != bool(ways)
    assert all(one.text != "dim the living room light" for one in sample(engine.grammar, None, 60))
