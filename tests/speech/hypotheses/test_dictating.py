"""A dictated text: the words before it must have been heard, and the text is what both models find likelier."""

from __future__ import annotations

from dataclasses import replace

import pytest
from two_models import LIKELY, SOUND, Thinks, heard, two

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.runtime.expectation import Expectation
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.hypotheses.dictating import DICTATED
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.steered import SteeredMoonshine, SteeredWhisper

GRAMMAR = """
language: en
slots:
  note: {type: text, dictation: true}
intents:
  note: {action: {type: custom, name: note}, sentences: ["write down [that] {note}", "go {note}"]}
  back: {action: {type: move, direction: backward}, sentences: ["drive back"]}
"""
MILK, SILK = "Write down buy fifteen bottles of milk.", "write down buy fifteen bottles of silk"


@pytest.fixture(scope="module")
def notes(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


class Writer(Thinks):
    """One whose words are counted without the signs that it writes."""

    @property
    def heard(self) -> list[str]:
        return self.transcript.free_text.lower().strip(".").split()


class Thinker(Writer):
    """One who thought of the command though the words before its text were heard otherwise."""

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return (("write", "down", DICTATED), ("drive", "back"))


def wrote(text: str, finds: dict[str, float], clear: dict[str, float] | None = None) -> Writer:
    words = text.lower().strip(".")
    dictated = ("write", "down") if words.startswith("write down") else ()
    confidence = 1.0 if dictated else 0.3
    return Writer(
        heard(text, confidence), {words: LIKELY}, clear or {}, settled=bool(dictated), dictated=dictated, finds=finds
    )


def both_heard(notes: IntentEngine, first: Writer, second: Writer) -> Transcript:
    both, *_ = two(notes, first, second)
    return both.transcribe(SOUND)


def meant(notes: IntentEngine, found: Transcript) -> Interpretation:
    return Judge(notes).meaning(found, (), ())


@pytest.mark.parametrize(("milk", "silk"), [((-4.0, -9.0), (-6.0, -5.0)), ((-7.0, -9.0), (-4.0, -9.0))])
def test_the_text_is_the_one_that_both_together_find_likelier(notes, milk, silk):
    """As that model wrote it."""
    first = wrote(MILK, {MILK: milk[0], SILK: silk[0]})
    second = wrote(SILK, {MILK: milk[1], SILK: silk[1]})
    likelier = MILK if sum(milk) > sum(silk) else SILK
    found = both_heard(notes, first, second)
    assert found.text == likelier
    meaning = meant(notes, found)
    assert (meaning.status, meaning.intent) == (Status.ACCEPTED, "note")
    assert meaning.slots == {"note": likelier[len("write down ") :].rstrip(".")}


def test_a_text_may_go_on(notes):
    found = both_heard(notes, wrote(MILK, {}), wrote(MILK, {}))
    assert Expectation(Judge(notes)).outlook(found, (), (), amendable=False)[1] is Outlook.EXTENDABLE


def test_what_may_have_been_a_dont_is_not_written(notes):
    clear = {"write": -4.0}
    found = both_heard(notes, wrote(MILK, {}, clear), wrote(SILK, {}, clear))
    assert found.unclear == ("write",)
    assert not meant(notes, found).actions


def test_where_one_heard_other_words_before_it_they_are_weighed_as_a_command(notes):
    words = "write down buy fifteen bottles of milk"
    first = wrote(MILK, {})
    second = replace(wrote("right down by fifteen bottles of milk", {}), scores={words: LIKELY - 2.0})
    assert meant(notes, both_heard(notes, first, second)).slots == {"note": "buy fifteen bottles of milk"}
    second = replace(second, scores={words: LIKELY - 60.0, "drive back": LIKELY})
    assert not meant(notes, both_heard(notes, replace(first, scores={words: -20.0}), second)).actions


@pytest.mark.parametrize(("behind", "done"), [(2.9, True), (3.1, False)])
def test_what_none_heard_before_a_text_must_be_nearly_as_likely(notes, behind, done):
    """ "Not the left one" is no "note the left one"."""
    text, words = "right down buy a bottle of milk", "write down buy a bottle of milk"
    both = Writer(heard(text, 0.3), {words: LIKELY - behind, "drive back": -30.0})
    both = replace(both, finds={"write down buy a bottle of milk": LIKELY})
    first, second = (Thinker(**vars(both)) for _ in range(2))
    found = both_heard(notes, first, second)
    assert found.unclear == (() if done else ("write down",))
    assert bool(meant(notes, found).actions) is done


@pytest.mark.parametrize("model", [SteeredWhisper, SteeredMoonshine])
def test_a_model_alone_writes_what_it_heard(notes, spoken, model):
    """Of "go forward two meters" all that follows "go"."""
    recognizer = model(notes)
    try:
        found = recognizer.transcribe(spoken)
    finally:
        recognizer.close()
    assert meant(notes, found).slots["note"].lower().replace("two", "2") == "forward 2 meters"


def test_words_before_a_text_that_were_hardly_heard_are_no_command(notes, spoken, monkeypatch):
    whisper = SteeredWhisper(notes)
    try:
        monkeypatch.setattr(whisper, "greedy", lambda *_args, **_options: (MILK, -0.3, False))
        found = whisper.transcribe(spoken)
    finally:
        whisper.close()
    assert set(found.unclear) >= {"write", "down"}
    assert not meant(notes, found).actions
