"""Names of a list or a map that a later command points back to: "fly to tank 2 and photograph it"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine

PLANT = """
language: en
slots:
  place: location
  valve: [inlet valve, drain valve]
  level: percent
intents:
  fly: {action: custom, sentences: ["fly to [the] {place}"]}
  photograph: {action: custom, sentences: ["photograph [the] {place}", "take (a|one) photo of [the] {place}"]}
  open: {action: custom, sentences: ["open [the] {valve} [to {level}]"]}
  check: {action: custom, sentences: ["check [the] {valve}"]}
  hover: {action: custom, sentences: [hover]}
"""
MAP = {"tank 1": (0.0, 0.0, 0.0), "tank 2": (1.0, 0.0, 0.0), "flare stack": (2.0, 0.0, 0.0)}


@pytest.fixture(scope="module")
def plant(engine_of) -> IntentEngine:
    return engine_of(PLANT, locations=MAP)


@pytest.mark.parametrize(
    ("said", "in_full"),
    [
        ("fly to tank 2 and photograph it", "fly to tank 2 and photograph tank 2"),
        ("fly to the flare stack, hover, and then take a photo of it",
         "fly to the flare stack, hover, and then take a photo of the flare stack"),
        ("fly to tank 2, photograph it and take a photo of it",
         "fly to tank 2, photograph tank 2 and take a photo of tank 2"),
        ("fly to tank 1, no, tank 2 and photograph it", "fly to tank 2 and photograph tank 2"),
        ("check the drain valve and then open it to ten percent",
         "check the drain valve and then open the drain valve to ten percent"),
        ("fly to tank 2 and open the drain valve and check it",
         "fly to tank 2 and open the drain valve and check the drain valve"),
    ],
)  # fmt: skip
def test_the_one_name_that_fits_is_meant(plant: IntentEngine, said: str, in_full: str) -> None:
    assert plant.parse(said).actions == plant.parse(in_full).actions != ()


STORES = {
    "en": """
language: en
slots: {thing: [test tubes, box], place: [lab, hall]}
intents:
  get: {action: custom, sentences: ["get [the] {thing}"]}
  take: {action: custom, sentences: ["take [the] {thing} to the {place}"]}
""",
    "de": """
language: de
slots: {ding: [Röhrchen, Zange, Kasten], ort: [Labor, Halle]}
intents:
  hol: {action: custom, sentences: ["hol (die|den|das) {ding}"]}
  bring: {action: custom, sentences: ["bring (die|den|das) {ding} (ins|in die) {ort}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "in_full"),
    [
        ("en", "get the test tubes and take them to the lab", "get the test tubes and take the test tubes to the lab"),
        ("de", "hol die Röhrchen und bring sie ins Labor", "hol die Röhrchen und bring die Röhrchen ins Labor"),
        ("de", "hol die Zange und bring sie dann in die Halle", "hol die Zange und bring die Zange in die Halle"),
        ("de", "hol den Kasten und bring ihn dann ins Labor", "hol den Kasten und bring den Kasten ins Labor"),
    ],
)
def test_more_than_one_of_a_name_is_them(engine_of, language: str, said: str, in_full: str) -> None:
    engine = engine_of(STORES[language])
    assert engine.parse(said).actions == engine.parse(in_full).actions != ()


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "get the box and take them to the lab"),
        ("en", "get the test tubes, get the box and take them to the lab"),
        ("en", "take them to the lab"),
        ("de", "hol den Kasten und bring sie ins Labor"),
        ("de", "hol die Zange, hol die Röhrchen und bring sie ins Labor"),
    ],
)
def test_of_one_or_of_two_names_nobody_knows_what_they_are(engine_of, language: str, said: str) -> None:
    assert not engine_of(STORES[language]).parse(said).actions


@pytest.mark.parametrize(
    "said",
    [
        "photograph it",
        "photograph it and fly to tank 2",
        "hover and photograph it",
        "fly to tank 1, then fly to tank 2 and photograph it",
        "fly to tank 2 and photograph them",
        "fly to tank 2 and don't photograph it",
        "fly to tank 2 and photograph it if it is open",
        "check the drain valve and photograph it",
        "don't fly to tank 2 and photograph it",
        "is tank 2 open and photograph it",
    ],
)
def test_nothing_is_done_where_none_or_several_may_be_meant(plant: IntentEngine, said: str) -> None:
    assert not plant.parse(said).actions


@given(st.lists(st.sampled_from(sorted(MAP)), min_size=1, max_size=3))
def test_it_is_clear_only_where_one_was_named(plant: IntentEngine, places: list[str]) -> None:
    said = ", ".join(f"fly to {place}" for place in places)
    done = plant.parse(f"{said} and photograph it").actions
    clear = len(set(places)) == 1 and plant.parse(said).actions
    assert (done[-1].slots if done else None) == ({"place": places[0]} if clear else None)
