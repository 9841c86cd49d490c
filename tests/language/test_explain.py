"""An explanation is told by the code that decides: it always ends in what ``parse`` says, and shows why."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language import meaning
from intent_engine.language.explain import OUTCOMES
from intent_engine.language.explanation import Explanation, Step
from intent_engine.language.meaning.steps import Kind

WORDS = st.lists(
    st.one_of(
        st.sampled_from(["go", "move", "turn", "left", "right", "forward", "back", "to", "the", "kitchen", "kitchn"]),
        st.sampled_from(
            ["two", "meters", "3", "ninety", "degrees", "at", "half", "speed", "pick", "up", "cup", "love"]
        ),
        st.sampled_from(["no", "not", "don't", "never", "then", "and", "stop", "wait", "please", "uh", "actually"]),
        st.sampled_from(["i", "mean", ",", "."]),
    ),
    max_size=12,
).map(" ".join)


@settings(max_examples=150, deadline=None)
@given(text=WORDS | st.text(max_size=60), moving=st.booleans())
def test_it_ends_in_what_parse_says(engine, text, moving):
    state = ("moving",) if moving else ()
    found = engine.explain(text, state=state)
    assert found.interpretation == engine.parse(text, state=state)
    assert json.loads(json.dumps(found.to_json()))["status"] == found.interpretation.status
    if found.interpretation.status is Status.ACCEPTED and found.interpretation.intent != "stop":
        assert len(found.slots) == len(found.interpretation.actions)
        assert any(candidate.refused == "" for step in _all(found) for candidate in step.candidates)


def _all(found: Explanation) -> list[Step]:
    steps, pending = [], list(found.steps)
    while pending:
        step = pending.pop(0)
        steps.append(step)
        pending.extend(step.steps)
    return steps


def _marked() -> list[Kind]:
    """The kind of each step that a rule takes."""
    seen: list[Kind] = []

    def watch(kind: Kind, method: Any) -> Any:
        seen.append(kind)
        return method

    shipped()._interpreter(None).watched(watch)
    return seen


def test_every_kind_of_step_is_taken_by_some_rule_and_told():
    assert set(_marked()) == set(Kind)
    assert {*OUTCOMES, Kind.CHOICE} == set(Kind)


def test_a_parse_is_not_watched(engine):
    parser = engine._interpreter(None)
    rules = [parser, *(rule for rule in vars(parser).values() if type(rule).__module__.startswith(meaning.__name__))]
    before = [dict(vars(rule)) for rule in rules]
    engine.explain("go to the kitchen")
    assert len(rules) > 5
    assert [dict(vars(rule)) for rule in rules] == before


STEPS = [
    ("uh go forward please", "sentence", "understood as move"),
    ("stop", "stop", "a command to stop"),
    ("the bus stop", "stop", "no command to stop"),
    ("don't go to the kitchen", "negation", "negated: 'not'"),
    ("don't turn left, turn right", "negation", "only this is wanted: 'turn right'"),
    ("turn left no right", "correction", "understood as turn (corrected to 'turn right')"),
    ("turn left then go forward", "compound", "2 commands"),
    ("go to the kitchn", "misheard", "understood as navigate (heard 'kitchn' as 'kitchen')"),
    ("go to the", "otherwise", "incomplete: the sentence is not finished"),
    ("turn nine uh forty degrees left", "numbers", "one number was begun twice"),
]


@pytest.mark.parametrize(("text", "name", "outcome"), STEPS, ids=[text for text, _, _ in STEPS])
def test_each_step_is_told(engine, text, name, outcome):
    assert (name, outcome) in [(step.name, step.outcome) for step in _all(engine.explain(text))]


def test_every_value_has_its_source(engine):
    (slots,) = engine.explain("turn around").slots
    assert [(slot.name, slot.source) for slot in slots] == [
        ("side", "sentence"), ("angle", "sentence"), ("speed", "default"),
    ]  # fmt: skip
    (slots,) = engine.explain("go back two meters").slots
    assert [(slot.name, slot.value, slot.source, slot.words) for slot in slots] == [
        ("direction", "backward", "said", "back"),
        ("distance", 2.0, "said", "two meters"),
        ("speed", 0.3, "condition", "direction: backward"),
    ]
    (slots,) = engine.explain("go to the kitchn").slots
    assert (slots[0].how, slots[0].rivals[0][0]) == ("fuzzy", "kitchen")
    assert engine.explain("turn love").slots[0][0].how == "unknown"


def test_what_points_back_is_told(engine):
    last = engine.parse("pick up the red cup").actions
    found = engine.explain("put it on the table", last=last)
    assert found.interpretation == engine.parse("put it on the table", last=last)
    assert found.interpretation.actions[0].object == "red cup"
    assert found.steps[-1].name == "pointing back"
    assert [step.name for step in engine.explain("put it on the table").steps if step.name == "pointing back"] == []


def test_words_keep_what_was_written(engine):
    found = engine.explain("Don't GO, please!")
    assert [(word.word, word.text) for word in found.words[:3]] == [("do", "Don't"), ("not", "Don't"), ("go", "GO")]
    assert found.words[3].pause
    assert ("negation", "not") in [(one.kind, one.words) for one in found.noticed]


def test_refused_readings_say_why(tmp_path):
    path = tmp_path / "g.yaml"
    path.write_text(
        "language: en\nslots: {thing: text}\nintents:\n"
        "  low: {action: {type: custom, name: low}, sentences: ['paint it'], priority: -1}\n"
        "  free: {action: {type: custom, name: free}, sentences: ['paint {thing}']}\n"
        "  plain: {action: {type: custom, name: plain}, sentences: ['(paint|draw) it']}\n"
        "  docked: {action: {type: custom, name: docked}, sentences: ['paint [it]'], requires: [docked]}\n"
    )
    engine = IntentEngine.from_files(path)
    step = engine.explain("paint it").steps[0]
    refused = {candidate.intent: candidate.refused for candidate in step.candidates}
    assert refused == {
        "plain": "",
        "docked": "docked needs the robot to be docked",
        "free": "more of its words fall into free text",
        "low": "intent 'plain' has a higher priority",
    }
    assert f"{path}:6" in {candidate.place for candidate in step.candidates}


def test_the_language_that_accepted_explains(tmp_path):
    files = []
    for language, words in (("en", "wave"), ("de", "winken")):
        files.append(tmp_path / f"{language}.yaml")
        files[-1].write_text(f"language: {language}\nintents: {{wave: {{action: custom, sentences: [{words}]}}}}\n")
    engine = IntentEngine.from_files(files)
    assert engine.explain("winken").language == "de"
    assert engine.explain("winken").interpretation == engine.parse("winken")
    assert engine.explain("winken", language="en").interpretation.status is Status.REJECTED


@pytest.mark.parametrize(
    ("text", "fillers"),
    [
        ("right then, turn left", ["right then"]),
        ("turn left then right then go forward", []),
        ("uh turn right then go forward please", ["uh", "please"]),
    ],
)
def test_a_filler_is_told_as_one_only_where_it_is(text: str, fillers: list[str]) -> None:
    assert [one.words for one in shipped().explain(text).noticed if one.kind == "filler"] == fillers
