"""A thing that may take the place of two others is asked about, however many words each of them has."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import german, shipped

from intent_engine.actions import Pick, Place

ENGLISH = shipped()
THINGS = ["it", "that", "the cup", "the red cup", "the big red cup"]
PLACES = ["the table", "the big table", "the big old table"]


@given(st.sampled_from(THINGS), st.sampled_from(PLACES), st.sampled_from(["the shelf", "the box", "the big box"]))
def test_nobody_knows_which(thing: str, place: str, meant: str) -> None:
    found = ENGLISH.parse(f"put {thing} on {place}, no, {meant}")
    assert not found.actions
    assert "not clear" in found.reason


@pytest.mark.parametrize(
    "text", ["stell ihn auf den Tisch, nein, das Regal", "stell die Tasse auf den großen Tisch, nein, den Teller"]
)
def test_in_german_whatever_the_article(text: str) -> None:
    assert not german().parse(text).actions


@given(st.sampled_from(THINGS), st.sampled_from(PLACES))
def test_where_it_is_said_it_is_clear(thing: str, place: str) -> None:
    (action,) = ENGLISH.parse(f"put {thing} on {place}, no, on the shelf").actions
    assert isinstance(action, Place)
    assert action.location == "shelf"


def test_where_only_one_was_named_it_is_clear() -> None:
    assert ENGLISH.parse("pick it up, no, the cup").actions == (Pick("cup"),)
    (action,) = ENGLISH.parse("bring the cup to Anna, no, Tom").actions
    assert dict(action.slots) == {"thing": "cup", "target": "tom"}
