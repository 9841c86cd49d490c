"""Somebody whom a list names, and who was named before: "focus on the actor and follow him"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

STUDIO = """
language: en
slots:
  subject: [actor, nurse, dog, Anna, twins]
  gift: [ball, rope]
  rest: {type: text, max_words: 6}
  place: location
  time: duration
  far: {type: distance}
  guest: {type: choice, values: {him: him, her: her, Anna: Anna}}
intents:
  focus: {action: custom, sentences: ["focus on [the] {subject}"]}
  follow: {action: custom, sentences: ["(track|follow) [the] {subject} [for {time}]"]}
  fetch: {action: custom, sentences: ["fetch [the] {gift}"]}
  give: {action: custom, sentences: ["give [the] {subject} [the] {gift}", "give [the] {gift} to [the] {subject}"]}
  near: {action: custom, sentences: ["go within {far} of [the] {subject}"]}
  say: {action: custom, sentences: ["tell {rest}", "ask [the] {subject} {rest}"]}
  go: {action: custom, sentences: ["go to [the] {place}"]}
  paint: {action: custom, sentences: ["paint [the] {subject} {gift}"]}
  greet: {action: custom, sentences: ["greet {guest}"]}
"""
MAP = {"kitchen": (0.0, 0.0, 0.0)}


@pytest.fixture(scope="module")
def studio(engine_of) -> IntentEngine:
    return engine_of(STUDIO, locations=MAP)


@pytest.mark.parametrize(
    ("said", "in_full"),
    [
        ("focus on the actor and follow him for 15 seconds", "focus on the actor and follow the actor for 15 seconds"),
        ("focus on the nurse, then follow her", "focus on the nurse, then follow the nurse"),
        ("focus on Anna. Follow her for a minute.", "focus on Anna and follow Anna for a minute"),
        ("focus on the dog, follow him and then track him",
         "focus on the dog, follow the dog and then track the dog"),
        ("please focus on the actor and give him the ball", "focus on the actor and give the actor the ball"),
        ("fetch the ball, focus on the actor and give the ball to him",
         "fetch the ball, focus on the actor and give the ball to the actor"),
        ("focus on the nurse and go within two meters of her",
         "focus on the nurse and go within two meters of the nurse"),
        # Or of whom a reason is told.
        ("the nurse is here, follow her", "follow the nurse"),
        ("Anna is hungry, give her the ball", "give Anna the ball"),
        ("the actor is leaving, follow him for ten seconds", "follow the actor for ten seconds"),
    ],
)  # fmt: skip
def test_it_is_the_one_who_was_named(studio, said: str, in_full: str) -> None:
    assert_same(studio, said, in_full)


@pytest.mark.parametrize(
    "said",
    [
        # Nobody was named, or not before, or two were.
        "follow him",
        "focus on him and follow the actor",
        "focus on the actor, focus on the nurse and follow her",
        "focus on the actor and follow her and him",
        "focus on the twins and follow him",
        "focus on the actor and follow them",
        "go to the kitchen and follow him",
        # No pronoun, but whose.
        "focus on the nurse and follow her dog",
        "focus on the nurse and paint her ball",
        "focus on the nurse and paint her rope",
        "the nurse is tired, paint her rope",
        "the nurse is tired, follow her dog",
        # No command.
        "don't focus on the actor and follow him",
        "the nurse is here, don't follow her",
        "the nurse is with the actor, follow her",
        "focus on the actor and don't follow him",
        "the actor came and I followed him",
        "if you see the actor, follow him",
        "focus on the actor and follow him home",
    ],
)
def test_nobody_knows_who_it_is(studio, said: str) -> None:
    found = [action for action in studio.parse(said).actions if action.name != "say"]
    assert len(found) <= 1, said
    assert not any(action.name == "follow" for action in found), said


def test_what_the_grammar_takes_so_stays(studio) -> None:
    _, told = studio.parse("focus on the nurse and tell her the soup is ready").actions
    assert told.slots == {"rest": "her the soup is ready"}
    _, greeted = studio.parse("focus on the nurse and greet her").actions
    assert greeted.slots == {"guest": "her"}
    for said in ("focus on the nurse and ask her to wait", "focus on the nurse and ask the actor about her"):
        assert not any("nurse" in str(action.slots.get("rest")) for action in studio.parse(said).actions)


def test_of_the_utterance_before_nobody_is_meant(studio) -> None:
    last = studio.parse("focus on the actor")
    assert not studio.parse("follow him", last=last).actions
