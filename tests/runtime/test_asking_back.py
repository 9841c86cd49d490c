"""What may have been said as well, and does something else."""

from __future__ import annotations

from dataclasses import replace

import pytest

from intent_engine.runtime.asking_back import OTHER_WAY
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.recognizer import Transcript


@pytest.fixture(scope="module")
def judge(engine) -> Judge:
    return Judge(engine)


@pytest.mark.parametrize(
    ("text", "other", "nats", "done"),
    [
        ("going forward slowly", "going rearward slowly", OTHER_WAY - 0.1, False),
        ("going forward slowly", "going rearward slowly", OTHER_WAY, True),
        ("going forward slowly", "going onward slowly", 0.1, True),
        ("turn left", "turn right", 0.5, False),
        ("turn left and go back", "turn left and go forward", 0.5, False),
        ("go to the kitchen", "go back", 0.5, True),
        ("stop", "go back", 0.5, True),
    ],
)
def test_what_may_as_well_have_been_the_other_way_is_asked_back(judge, text, other, nats, done):
    transcript = Transcript(text, -0.9, "go wound", gap=0.4, confidence=0.95, alternatives=(other,), behind=(nats,))
    found = judge.meaning(transcript, (), ())
    assert bool(found.actions) is done
    if not done:
        assert found.alternatives == (text, other)
        assert found.reason == f"{text!r} or {other!r}, the other way? say it again"
    exactly = replace(transcript, text=text, free_text=text, gap=0.0, confidence=1.0)
    assert judge.meaning(exactly, (), ()).actions, "word by word there is nothing to ask"


def test_the_other_way_is_asked_back_in_a_state_that_both_need(engine_of):
    judge = Judge(
        engine_of(
            "intents:\n  crawl:\n    action: {type: move, direction: '{way}'}\n    requires: [docked]\n"
            "    sentences: ['crawl {way}']\nslots:\n  way: {type: choice, values: [forward, backward]}\n"
        )
    )
    words, other = "crawl forward", "crawl backward"
    transcript = Transcript(words, -0.9, "all forward", gap=0.4, confidence=0.95, alternatives=(other,), behind=(0.5,))
    assert judge.meaning(transcript, ("docked",), ()).reason.endswith("the other way? say it again")
    assert "docked" in judge.meaning(transcript, (), ()).reason


BOX = """
language: en
intents:
  fold: {action: custom, sentences: ["fold it [now]"]}
  unfold: {action: custom, sentences: ["unfold it [now]"]}
  wrap: {action: custom, sentences: ["wrap it"]}
  undo: {action: {type: custom, name: fold}, sentences: ["unlace it"]}
  lace: {action: {type: custom, name: fold}, sentences: ["lace it"]}
"""


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("and fold it", "unfold it"),
        ("And fold it now.", "unfold it now"),
        ("then fold it", None),
        ("fold it", None),
        ("unfold it", None),
        ("and wrap it", None),
        ("wrap it and fold it", None),
        ("and lace it", None),  # both do the same
    ],
)
@pytest.mark.parametrize("state", [(), ("docked",)])
def test_an_and_that_may_be_the_beginning_of_another_verb_is_asked_back(engine_of, text, other, state):
    grammar = BOX.replace("action: custom,", "action: custom, requires: [docked],") if state else BOX
    found = Judge(engine_of(grammar)).meaning(Transcript(text, free_text=text, confidence=1.0), state, ())
    assert bool(found.actions) is (other is None)
    if other is not None:
        assert found.reason == f"{text!r} or {other!r}? say it again"
        assert found.alternatives == (text, other)


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("do a full circle turn and clockwise", "do a full circle turn anticlockwise"),
        ("turn left and clockwise", None),  # one command with "anticlockwise" does not exist
        ("do a full circle turn then clockwise", None),
        ("go forward and turn left", None),
    ],
)
def test_so_is_one_between_two_commands_if_the_same_sound_is_one(judge, text, other):
    found = judge.meaning(Transcript(text, free_text=text, confidence=1.0), (), ())
    assert found.alternatives == ((text, other) if other else ())
    assert len(found.actions) == (0 if other else 2)
