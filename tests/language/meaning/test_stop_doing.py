""" "Stop stirring the soup": what is a command of a grammar is ended in its own words."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Stop
from intent_engine.language.meaning.negations.doing import verbs

GRAMMAR = """
language: en
slots:
  thing: {type: text, max_words: 2, known: [soup, onions]}
  time: duration
intents:
  work:
    action: custom
    sentences: ["(stir|chop|slice|whisk|tie) [[the] {thing}] [for {time}]", "open the oven"]
  film: {action: custom, sentences: ["film", "stop filming"]}
  blend:
    action: custom
    regex: "(?:please )?blend(?: the (?P<thing>.+))?"
  knead:
    action: custom
    lark: |
      start: verb " the dough" (" for " time)?
      verb: "knead" | "roll out"
      time: /\\d+ minutes/
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    "said",
    [
        "stop stirring",
        "stop stirring the soup",
        "please stop chopping onions now",
        "stop slicing",
        "halt, stop whisking for ten minutes",
        "no, stop tying",
        "stop opening",
        "stop blending",
        "please stop blending the soup",
        "stop kneading",
        "stop kneading the dough",
        "stop rolling out the dough",
        "stop stirring, open the oven",
        "stop stirring and open the oven",
        "stop kneading. Open the oven.",
        "open the oven, stop stirring",
        "open the oven and stop stirring the soup",
        "the soup is ready, stop stirring",
        "don't open the oven, stop stirring",
    ],
)
def test_what_it_does_is_ended_by_its_name(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == (Stop(),)


@pytest.mark.parametrize(
    "said",
    [
        "stop talking about the soup",
        "stop kneading is what he said",
        "he should stop kneading",
        "stop kneading, he said",
        "don't stop kneading, open the fridge",
        "if you stop kneading, open the oven",
        "don't open the oven and stop stirring",
        "stop stirring and tell me about the oven",
        "stop doughing",
        "don't stop stirring",
        "never stop stirring",
        "the bus stop stirring",
        "he should stop stirring",
        "stop sing",
        "stirring",
        "open the oven, don't stop stirring",
        "we open the oven and stop stirring",
        # How it ends, or later.
        "stir for ten minutes and stop stirring",
        "open the oven and then stop stirring",
    ],
)
def test_what_is_no_command_ends_nothing(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == ()


@pytest.mark.parametrize(
    ("form", "verb"),
    [("stirring", "stir"), ("driving", "drive"), ("opening", "open"), ("tying", "tie"), ("rolling", "roll")],
)
def test_the_verb_of_a_form(form: str, verb: str) -> None:
    assert verb in verbs(form, "en")


@given(st.text("abcdefgino", max_size=8))
def test_a_verb_is_never_longer_than_its_form(word: str) -> None:
    assert all(len(verb) < len(word) for verb in verbs(word, "en"))
    assert not list(verbs(word, "de"))


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("stop filming, open the oven", ["film", "work"]),
        ("open the oven and stop filming", ["work", "film"]),
    ],
)
def test_what_a_grammar_has_a_sentence_for_is_that_command(engine: IntentEngine, said: str, done: list[str]) -> None:
    assert [getattr(action, "name", "") for action in engine.parse(said).actions] == done
