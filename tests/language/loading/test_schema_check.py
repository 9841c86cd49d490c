"""The quick look at a file's shape says what jsonschema says."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from intent_engine.language.loading.schema_check import surely_valid

ROOT = Path(__file__).parents[3]
PACKAGE = ROOT / "intent_engine"
FILES = {
    "grammar": [*sorted((ROOT / "grammars").glob("*.yaml")), ROOT / "examples" / "coffee" / "coffee.yaml"],
    "locations": sorted((ROOT / "locations").glob("*.yaml")),
}
SCHEMAS = {name: json.loads((PACKAGE / "language" / f"{name}.schema.json").read_text("utf-8")) for name in FILES}
OTHERS = {
    path.name: json.loads(path.read_text("utf-8"))
    for path in (PACKAGE / "execution" / "robots" / "robot.schema.json", PACKAGE / "testing" / "tests.schema.json")
}
SMALL = {
    "grammar": {
        "language": "en", "include": ["other.yaml"], "fillers": ["please"], "wake": ["robot"],
        "phrases": {"go": "(go|move)", "from": ["a", "b"]},
        "slots": {
            "far": {"type": "distance", "min": 0.5, "max": "20 m", "unit": "m", "usual_step": 1},
            "side": ["left", "right"],
            "thing": {"type": "text", "max_words": 4, "without": ["it"], "fuzzy": False}, "free": "text",
            "colour": {"values": {"red": ["red", "crimson"], "blue": "blue"}},
        },
        "operators": {"stop": ["halt"], "closed": ["now"]},
        "sound_alikes": {"bae": ["bay"]},
        "intents": {
            "move": {
                "action": {"type": "move", "speed": 0.5, "name": "move"}, "priority": 3, "description": "drives",
                "sentences": ["{go} {far}", {"say": "back", "slots": {"side": "left", "far": 1}}],
                "defaults": {"speed": "0.5 m/s", "fast": True}, "requires": ["ready"], "regex": "go (?P<far>.+)",
                "when": [{"slots": {"side": "left"}, "defaults": {"speed": 1}}], "examples": [], "lark": "start: X",
            },
            "halt": {"action": "stop"},
        },
    },
    "locations": {
        "frame": "map",
        "locations": {"kitchen": {"x": 1, "y": 2.0, "yaw": 0.5, "aliases": ["galley"], "tags": ["room"]}},
    },
}  # fmt: skip
VALUES = (
    st.none() | st.booleans() | st.integers(-200, 200) | st.floats() | st.sampled_from([3.0, 12, 13, 0, 1, 10**30])
) | (
    st.text(max_size=3)
    | st.sampled_from(["en", "en-GB", "name", "a b", "1a", "distance", "move", "type", "ünï", "a\n"])
)
JUNK = st.recursive(
    VALUES,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=4,
)


def places(value: Any) -> list[tuple[Any, Any]]:
    """Every (container, key) of a document."""
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [found for key, item in pairs for found in ((value, key), *places(item))]


@st.composite
def changed(draw: st.DrawFn, document: Any) -> Any:
    """A document with up to two values replaced, removed or renamed."""
    document = copy.deepcopy(document)
    for _ in range(draw(st.integers(0, 2))):
        holder, key = draw(st.sampled_from(places(document) or [([document], 0)]))
        change = draw(st.sampled_from(("replace", "remove", "rename", "take")))
        if change == "replace":
            holder[key] = draw(JUNK)
        elif change == "remove":
            del holder[key]
        elif change == "take":
            holder[key] = copy.deepcopy(draw(st.sampled_from(places(document)))[0])
        elif isinstance(holder, dict):
            holder[draw(st.sampled_from(["type", "max", "say", "slots", "1a", "a b", "name", "é"]))] = holder.pop(key)
    return document


@pytest.mark.parametrize("name", FILES)
def test_what_is_shipped_is_surely_right(name):
    """Else every start would load jsonschema."""
    for file in FILES[name]:
        assert surely_valid(yaml.safe_load(file.read_text("utf-8")), SCHEMAS[name]), file
    assert surely_valid(SMALL[name], SCHEMAS[name])


@settings(max_examples=400, deadline=None)
@given(st.data())
@pytest.mark.parametrize("name", FILES)
def test_it_says_what_jsonschema_says(name, data):
    document = data.draw(changed(SMALL[name]) | JUNK)
    assert surely_valid(document, SCHEMAS[name]) == Draft202012Validator(SCHEMAS[name]).is_valid(document)


@pytest.mark.parametrize("name", OTHERS)
@given(document=JUNK)
def test_a_keyword_that_it_does_not_know_is_never_passed_over(name, document):
    if surely_valid(document, OTHERS[name]):
        assert Draft202012Validator(OTHERS[name]).is_valid(document)


def test_an_unknown_keyword_is_no_yes():
    assert surely_valid("a", {"type": "string"})
    assert not surely_valid("a", {"type": "string", "format": "date"})
    assert not surely_valid("a", {"$ref": "https://example.org/schema"})
    assert not surely_valid(["a"], {"type": "array", "items": True})
