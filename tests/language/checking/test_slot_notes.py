"""What slots take, or never take, that their author may not have thought of."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.language.checking.slot_notes import slot_notes

GRAMMAR = """
slots:
  level: percent
  share: {type: percent, max: 100 %}
  message: {type: text, max_words: 8}
  said: {type: text, max_words: 8, dictation: true}
  thing: {type: text, max_words: 2}
  topic: {type: text, max_words: 8}
intents:
  dim: {action: custom, sentences: ["dim to {level}", "open to {share}"]}
  tell: {action: custom, sentences: ["tell Anna [that] {message}", "note {said}", "take the {thing}"]}
  talk: {action: custom, sentences: ["talk about {topic} to Anna"]}
"""


def test_a_share_without_a_largest_and_a_message_that_is_not_dictated_are_told(engine_of) -> None:
    engine: IntentEngine = engine_of(GRAMMAR)
    told = {problem.message: problem.hint for problem in slot_notes(engine.grammar)}
    assert told == {
        "slot 'level' takes 150 percent as well": "with 'max: 100 %' it does not",
        "slot 'message' takes no message with a word like 'we', 'if', 'not'": (
            "with 'dictation: true' it takes all that is said from there on"
        ),
    }


def test_it_is_as_it_tells(engine_of) -> None:
    engine: IntentEngine = engine_of(GRAMMAR)
    assert engine.parse("dim to 150 percent").slots == {"level": 1.5}
    assert not engine.parse("open to 150 percent").actions
    assert not engine.parse("tell Anna we are late").actions
    assert engine.parse("note we are late").slots == {"said": "we are late"}


@pytest.mark.parametrize("also", ['"say {message} to Anna"', '"say it [and {message}]"', '"say {body}"'])
def test_no_dictation_is_advised_where_it_would_be_an_error(engine_of, also) -> None:
    """What is dictated goes on to the end of what is said."""
    grammar = f"""
slots: {{message: {{type: text, max_words: 8}}}}
phrases: {{body: "out loud [{{message}}]"}}
intents: {{tell: {{action: custom, sentences: ["tell Anna {{message}}", {also}]}}}}
"""
    assert not list(slot_notes(engine_of(grammar).grammar))


def test_other_languages_name_no_english_word(engine_of) -> None:
    engine: IntentEngine = engine_of(
        "language: de\nslots: {text: {type: text, max_words: 8}}\n"
        "intents: {sag: {action: custom, sentences: ['sag {text}']}}\n"
    )
    assert not list(slot_notes(engine.grammar))


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("feed cage {cage} {kg}", True),
        ("feed cage {cage} [{kg} kilos]", True),
        ("feed [cage {cage}] {kg} kilos", True),
        ("feed cage {cage} with {kg} kilos", False),
        ("feed cage {cage} [with {kg} kilos]", False),
    ],
)
def test_numbers_side_by_side_are_told(engine_of, sentence, told) -> None:
    grammar = f"slots: {{cage: number, kg: number}}\nintents: {{feed: {{action: custom, sentences: ['{sentence}']}}}}"
    assert [problem.message.partition(":")[0] for problem in slot_notes(engine_of(grammar).grammar)] == [
        "{cage} and {kg} are numbers side by side"
    ] * told
