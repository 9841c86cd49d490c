"""Opposite words that one action stands for are told."""

from __future__ import annotations

import pytest

from intent_engine.language.checker import check_grammar
from intent_engine.language.checking.lost_opposites import lost_opposites

GRAMMAR = """
language: {language}
slots: {{does: [open, close], side: [left, right], n: number, lamp: [lamp, fan]}}
phrases: {{pull: (pull|push)}}
intents:
  it: {{action: custom, sentences: [{sentences}]}}
"""


def told(engine_of, *sentences: str, language: str = "en") -> list[str]:
    listed = ", ".join(one if one.startswith("{say") else f'"{one}"' for one in sentences)
    engine = engine_of(GRAMMAR.format(sentences=listed, language=language))
    return [problem.message.partition(" are ")[0] for problem in lost_opposites(engine.grammar)]


@pytest.mark.parametrize(
    ("sentence", "opposites"),
    [
        ("(open|close) the gripper", ["'open' and 'close'"]),
        ("switch the lamp (on|off)", ["'on' and 'off'"]),
        ("(turn on|switch off|dim) the lamp", ["'on' and 'off'"]),
        ("tilt it {n} degrees [(up|down|sideways)]", ["'up' and 'down'"]),
        ("{does} the gripper", []),
        ("(open|unlock) the gripper", []),
        ("(open|close {n} times) the gripper", []),  # the slot tells
        ("{pull} the cart", []),  # of a phrase, which may be verbs that are much the same
        ("open the gripper", []),
    ],
)
def test_alternatives(engine_of, sentence: str, opposites: list[str]) -> None:
    assert told(engine_of, sentence) == opposites


def test_sentences_that_differ_in_one_word(engine_of) -> None:
    assert told(engine_of, "open the gripper", "close the gripper") == ["'open' and 'close'"]
    assert told(engine_of, "open the gripper", "close the door") == []
    by_value = ['{say: "open the gripper", slots: {side: left}}', '{say: "close the gripper", slots: {side: right}}']
    assert told(engine_of, *by_value) == []


def test_of_other_languages(engine_of) -> None:
    assert told(engine_of, "schalte das Licht (ein|aus)", language="de") == ["'ein' and 'aus'"]


def test_check_warns_and_says_what_to_do(engine_of) -> None:
    engine = engine_of(GRAMMAR.format(sentences='"(open|close) the gripper"', language="en"))
    (found,) = [one for one in check_grammar(engine.grammar, None).findings if "opposites" in one.problem.message]
    assert found.level == "warning"
    assert "values: [open, close]" in (found.problem.hint or "")
    assert engine.parse("open the gripper").actions == engine.parse("close the gripper").actions


def test_a_stop_is_the_same_however_it_is_said(engine_of) -> None:
    stops = 'language: en\nintents: {halt: {action: stop, sentences: ["hold (on|off)"]}}\n'
    assert not [*lost_opposites(engine_of(stops).grammar)]
