"""Sentences of patterns: what is sampled of them, and what ``check`` finds in them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status
from intent_engine.language.checker import check_grammar
from intent_engine.language.sampler import RandomChoices, Sampler, sample
from intent_engine.testing import sentences

PATTERNS = """
language: en
slots:
  code: {type: text, max_words: 4}
  room: {type: number, min: 3, max: 12}
  far: {type: distance, max: 50 m}
  nth: {type: ordinal, max: 30}
  colour: {values: {red: [red, crimson], blue: blue}}
  place: location
  state: boolean
  thing: object
intents:
  ticket: {action: custom, regex: "ticket (?P<code>[a-z] \\\\d+)"}
  room: {action: custom, regex: ["(?:open|close) room (?P<room>\\\\d+)( now)?", "seal room (?P<room>[0-9]{1,2})"]}
  creep: {action: custom, regex: "creep (?P<far>.+) (?:forth|onward)"}
  lights: {action: custom, regex: "lights? (?P<state>on|off)"}
  visit: {action: custom, regex: "pay a visit to (?P<place>.+)"}
  grab: {action: custom, regex: "grab (?P<thing>the cup|a ball|it)"}
  near: {action: custom, regex: "drive near (?P<place>kitchen|bay 3)"}
  row: {action: custom, regex: "weed the (?P<nth>\\\\w+) row"}
  stack:
    action: custom
    lark: |
      start: ("stack" | "pile") " " colour (" on " colour)*
      colour: "red" | "blue" | "crimson"
"""


def engine_of(text: str, folder: Path) -> IntentEngine:
    path = folder / "patterns.yaml"
    path.write_text(text)
    return IntentEngine.from_files(path, locations={"kitchen": (1.0, 2.0), "bay 3": (2.0, 2.0)})


@pytest.fixture(scope="module")
def engine(tmp_path_factory) -> IntentEngine:
    return engine_of(PATTERNS, tmp_path_factory.mktemp("patterns"))


@settings(max_examples=200, deadline=None)
@given(st.integers(0, 10_000), st.data())
def test_a_sentence_of_a_pattern_means_what_its_sample_says(engine, seed, data):
    intent = data.draw(st.sampled_from(list(engine.grammar.intents)))
    (one,) = sample(engine.grammar, engine.locations, 1, intent=intent, seed=seed)
    found = engine.parse(one.text)
    assert (found.status, found.intent, dict(found.slots)) == (Status.ACCEPTED, intent, dict(one.slots)), one.text
    assert found.actions == one.actions


def test_everything_that_a_pattern_has_is_said(engine):
    said = {one.text for one in sample(engine.grammar, engine.locations, 400, seed=1)}
    assert {"light on", "lights off"} <= said
    assert any(text.endswith(" now") for text in said)
    assert {text.split()[0] for text in said} >= {
        "ticket",
        "open",
        "close",
        "seal",
        "creep",
        "pay",
        "stack",
        "pile",
        "grab",
        "drive",
    }
    rooms = {int(text.split()[2]) for text in said if text.split()[1] == "room"}
    assert rooms >= {4, 7, 12}
    assert rooms <= set(range(3, 13)), "within the limits of its slot"


def test_the_same_seed_gives_the_same_sentences(engine):
    sampler = Sampler(engine.grammar, engine.locations)
    assert sampler.draw(RandomChoices(5)).text == Sampler(engine.grammar, engine.locations).draw(RandomChoices(5)).text


def test_patterns_stand_the_tests_that_templates_do(engine):
    @settings(max_examples=60, deadline=None)
    @given(sentences(engine, noise=["fillers", "spelling"]))
    def law(sentence):
        found = engine.parse(sentence.text)
        assert (found.intent, dict(found.slots)) == (sentence.expected.intent, dict(sentence.expected.slots))

    law()


def test_a_pattern_of_which_nobody_knows_how_it_is_said(tmp_path):
    engine = engine_of("intents: {x: {action: custom, regex: 'x{30} go'}}", tmp_path)
    with pytest.raises(ConfigError, match="nobody knows how they are said"):
        sample(engine.grammar, None, 1, intent="x")
    (finding,) = check_grammar(engine.grammar, None).findings
    assert (finding.level, finding.topic) == ("note", "pattern")


def test_of_what_is_heard_in_other_words_no_sentence_is_drawn(tmp_path):
    engine = engine_of("intents: {x: {action: custom, regex: 'go [0-9](m| meters)'}}", tmp_path)
    drawn = {one.text for one in sample(engine.grammar, None, 20)}
    assert drawn
    assert all(text.endswith(" meters") for text in drawn)


HEAD = "slots: {code: text, far: distance}\nintents:\n"


@pytest.mark.parametrize(
    ("rows", "levels", "says"),
    [
        ("a: {action: custom, regex: 'open (it|that)'}", [], ""),
        (
            "a: {action: custom, regex: 'open it'}\n  b: {action: custom, sentences: [open it]}",
            ["warning"],
            "would ask",
        ),
        (
            "a: {action: custom, regex: 'open it', priority: -1}\n  b: {action: custom, sentences: [open it]}",
            ["warning"],
            "is never understood",
        ),
        (
            "a: {action: custom, regex: 'open (it|that)', priority: -1}\n  b: {action: custom, sentences: [open it]}",
            ["note"],
            "is understood as 'b'",
        ),
        ("a: {action: custom, regex: 'drive (?P<far>[0-9]+) there'}", ["warning"], "is not a distance"),
        ("a: {action: custom, regex: 'code (?P<code>[hij] [0-9]+)'}", ["warning"], "is refused"),
        ("a: {action: custom, regex: '.*open it'}", ["warning"], "any words before it"),
        ("a: {action: custom, regex: '(now )?.*open (?P<far>.+)'}", ["warning"], "any words before it"),
        ("a: {action: custom, regex: 'open it.*'}", ["warning"], "any words behind it"),
        ("a: {action: custom, regex: 'drive to (?P<code>.+)'}", [], ""),
        ("a: {action: custom, regex: 'open bay[0-9]'}", ["warning"], "is heard as 'open bay [0-9]"),
        ("a: {action: custom, regex: 'open bay ?[0-9]'}", [], ""),
        ("a: {action: custom, regex: '\\böffne das'}", ["warning", "note"], "ends of English words|cannot be told"),
        ("a: {action: custom, regex: 'open  it'}", ["warning", "note"], "blank beside another|cannot be told"),
        ("a: {action: custom, lark: 'start: \"Open it\"'}", ["warning", "note"], "asks for 'Open it'|cannot be told"),
    ],
)
def test_what_check_finds_in_patterns(tmp_path, rows, levels, says):
    engine = engine_of(f"{HEAD}  {rows}\n", tmp_path)
    used = [one for one in check_grammar(engine.grammar, None).findings if "is used by no sentence" not in str(one)]
    assert [one.level for one in used] == levels
    assert all(re.search(says, one.problem.message) for one in used)


def test_a_word_that_a_slot_does_not_allow_is_told_with_what_to_do(tmp_path):
    engine = engine_of(f"{HEAD}  a: {{action: custom, regex: 'code (?P<code>[hij] [0-9]+)'}}\n", tmp_path)
    hints = [one.problem.hint for one in check_grammar(engine.grammar, None).findings if one.topic == "pattern"]
    assert hints == ["if that is meant, give its slot allow: [i]"]
