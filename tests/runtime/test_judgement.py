"""What a transcript may move: nothing, where it is not sure that it was said; a stop, from less."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status
from intent_engine.runtime.judgement import CLEARLY, HARDLY_A_WORD, SURE_BESIDE_A_STOP, SURE_THOUGH_HELD, Judge
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import (
    ANOTHER_WORD,
    SURE_ENOUGH,
    SURE_ENOUGH_OF_SEVERAL,
    SURE_ENOUGH_TO_STOP,
)

ROOT = Path(__file__).resolve().parent.parent.parent
ONE, SEVERAL, STOP = "go forward two meters", "go forward two meters and turn left", "stop"


@pytest.fixture(scope="module")
def judge(engine) -> Judge:
    return Judge(engine)


def heard(text: str, confidence: float | None, free: str = "oh forward to me does") -> Transcript:
    return Transcript(text, free_text=free, gap=1.0, confidence=confidence)


@pytest.mark.parametrize(
    ("text", "enough"), [(ONE, SURE_ENOUGH), (SEVERAL, SURE_ENOUGH_OF_SEVERAL), (STOP, SURE_ENOUGH_TO_STOP)]
)
def test_it_is_done_from_this_confidence_on(judge, text, enough):
    assert judge.meaning(heard(text, enough), (), ()).status is Status.ACCEPTED
    refused = judge.meaning(heard(text, enough - 0.01), (), ())
    assert refused.status is Status.REJECTED
    assert refused.actions == ()
    assert refused.text == "oh forward to me does", "what was heard, not what was looked for"
    assert refused.alternatives == (text,)
    assert refused.reason


@pytest.mark.parametrize(("confidence", "reason"), [(0.5, "perhaps 'go forward two meters'"), (0.1, "too different")])
def test_what_it_may_have_been_is_told_if_that_is_worth_it(judge, confidence, reason):
    assert reason in judge.meaning(heard(ONE, confidence), (), ()).reason


MOON = "Go to the moon."


@pytest.mark.parametrize("text", ["go to the lounge", "go", "go two miles and turn left", "burn a leaf", MOON])
def test_a_place_that_is_not_on_the_map_is_told_as_if_it_were_typed(judge, text):
    typed = judge.engine.parse(MOON)
    told = judge.meaning(heard(text, 0.1, MOON), (), ())
    assert (told.status, told.text, told.actions) == (Status.REJECTED, MOON, ())
    assert told.reason == typed.reason == "no place is called 'moon'"
    assert told.alternatives == typed.alternatives


@pytest.mark.parametrize(
    ("transcript", "reason"),
    [
        (heard("go to the lounge", 0.5, MOON), "perhaps 'go to the lounge'"),
        (replace(heard("go to the lounge", 0.1, MOON), score=CLEARLY - 0.01), "too different"),
        (heard("go to the lounge", 0.1, "we went to the moon"), "too different"),
        (heard("go to the lounge", 0.1, "don't go to the moon"), "too different"),
        (heard("do not go to the lounge", 0.1, MOON), "negated"),
    ],
    ids=["it is asked back", "hardly heard", "a story", "not to be done", "not to be done, perhaps"],
)
def test_but_only_where_it_was_clearly_said_and_nothing_else_is_worth_telling(judge, transcript, reason):
    assert reason in judge.meaning(transcript, (), ()).reason


WORDS = ["go to mars and turn left", "go to the", "turn left two", "don't go to the moon", "go to the kitchen", ""]
SENTENCES = st.sampled_from([ONE, SEVERAL, STOP, MOON, *WORDS])


@given(SENTENCES, SENTENCES, st.one_of(st.none(), st.floats(0, 1)), st.floats(-3, 0))
def test_only_the_wording_of_a_rejection_hangs_on_the_words_that_were_heard(judge, text, free, confidence, score):
    transcript = Transcript(text, score, free, gap=1.0, confidence=confidence)
    told = judge.meaning(transcript, (), ())
    otherwise = judge.meaning(replace(transcript, free_text="oh forward to me does"), (), ())
    assert (told.status, told.actions) == (otherwise.status, otherwise.actions)


@pytest.mark.parametrize(("gap", "status"), [(ANOTHER_WORD, Status.ACCEPTED), (ANOTHER_WORD + 0.01, Status.REJECTED)])
def test_a_stop_must_be_surer_where_another_word_is_much_likelier(judge, gap, status):
    wow = Transcript("whoa", free_text="Wow", gap=gap, confidence=SURE_ENOUGH_TO_STOP)
    assert judge.meaning(wow, (), ()).status is status
    sure = Transcript("whoa", free_text="Wow", gap=gap, confidence=SURE_ENOUGH)
    assert judge.meaning(sure, (), ()).status is Status.ACCEPTED


@pytest.mark.parametrize("text", [ONE, SEVERAL, STOP])
def test_a_recogniser_that_is_not_steered_is_believed(judge, text):
    assert judge.meaning(heard(text, None, text), (), ()).status is Status.ACCEPTED


@pytest.mark.parametrize(("text", "done"), [("turn left fifteen degrees", False), ("stop", True)])
def test_a_word_that_was_not_heard_clearly_is_asked_back(judge, text, done):
    meaning = judge.meaning(Transcript(text, free_text=text, confidence=1.0, unclear=("fifteen",)), (), ())
    assert (meaning.status is Status.ACCEPTED) is done
    assert done or "say it again" in meaning.reason


@pytest.mark.parametrize(
    ("unclear", "reason"),
    [
        (("sixteen",), "'sixteen' may have been 'sixty'; say it again"),
        (("turn",), "'turn' was not heard clearly; say it again"),
        (("turn", "turn"), "'turn' was not heard clearly; say it again"),
        (("turn", "left"), "'turn' and 'left' were not heard clearly; say it again"),
        (("turn", "forty"), "'forty' may have been 'fourteen', 'turn' was not heard clearly; say it again"),
    ],
)
def test_what_was_not_clear_is_told_with_what_it_may_have_been(judge, unclear, reason):
    text = "turn left sixteen degrees"
    assert judge.meaning(Transcript(text, free_text=text, confidence=1.0, unclear=unclear), (), ()).reason == reason


def test_what_was_left_out_is_told_with_the_command_it_is_no_part_of(judge):
    text = "go to the kitchen"
    meaning = judge.meaning(Transcript(text, free_text=text, confidence=0.95, left_out=("do you",)), (), ())
    assert meaning.status is Status.REJECTED
    assert meaning.reason == "'do you' was said too, and is no part of 'go to the kitchen'; say it again"


OWN_RISK = """
intents:
  order: {action: {type: custom, name: order}, sentences: ["a large latte"], min_confidence: 0.4}
  launch: {action: {type: custom, name: launch}, sentences: ["launch the rocket"], min_confidence: 0.95}
  wave: {action: {type: custom, name: wave}, sentences: ["wave at me"]}
  halt: {action: stop, sentences: ["cut it"], min_confidence: 0.95}
"""


@pytest.mark.parametrize(
    ("text", "enough"),
    [
        ("a large latte", 0.4),
        ("launch the rocket", 0.95),
        ("wave at me", SURE_ENOUGH),
        ("a large latte and wave at me", SURE_ENOUGH_OF_SEVERAL),
        ("a large latte and launch the rocket", 0.95),
        ("cut it", SURE_ENOUGH_TO_STOP),
    ],
)
def test_an_intent_says_how_sure_it_must_be_but_a_stop_is_never_harder(tmp_path, text, enough):
    (tmp_path / "own.yaml").write_text(OWN_RISK, encoding="utf-8")
    judge = Judge(IntentEngine.from_files(tmp_path / "own.yaml"))
    assert judge.meaning(heard(text, enough), (), ()).status is Status.ACCEPTED
    assert judge.meaning(heard(text, enough - 0.01), (), ()).actions == ()


@pytest.mark.parametrize(
    ("text", "free_text", "score", "confidence", "stops"),
    [
        ("go", "Oh", HARDLY_A_WORD - 0.1, 0.74, True),
        ("go", "Oh", HARDLY_A_WORD - 0.1, SURE_THOUGH_HELD, False),
        ("go", "Go!", HARDLY_A_WORD - 0.1, 0.9, True),
        ("go", "Go!", HARDLY_A_WORD + 0.1, 0.9, True),
        ("lets go", "Let's go!", HARDLY_A_WORD + 0.1, 0.78, True),
        ("lets go", "Let's go!", HARDLY_A_WORD + 0.1, SURE_THOUGH_HELD, False),
        ("moving on", "moving of moving,", -0.5, 0.79, True),
        ("moving on", "moving of moving,", -0.5, SURE_THOUGH_HELD, False),
        ("go two meters", "Go 2 meters", HARDLY_A_WORD + 0.1, 0.74, False),
        ("back", "Oh", HARDLY_A_WORD - 0.1, 0.09, True),
        ("seven", "7", -0.3, 0.0, False),
        ("stop", "Oh", HARDLY_A_WORD - 0.1, 0.46, True),
        ("go back", "start spreading", HARDLY_A_WORD - 0.1, 0.34, True),
        ("go back", "please now take one", HARDLY_A_WORD - 0.1, 0.34, False),
        ("don't stop", "Oh", HARDLY_A_WORD - 0.1, 1.0, True),
    ],
)
def test_a_stop_that_was_felt_stays_one_unless_another_was_heard(judge, text, free_text, score, confidence, stops):
    """What was "stop" in noise became "go" (0.74), and the robot drove on."""
    transcript = Transcript(text, score, free_text, gap=1.0, confidence=confidence)
    alone = judge.meaning(transcript, (), ())
    held = judge.held(transcript, alone)
    assert held.stops is stops
    if not stops or alone.stops:
        assert held is alone


@pytest.mark.parametrize(
    ("text", "alternatives", "behind", "confidence", "done"),
    [
        ("go", ("come", "stop"), (), SURE_BESIDE_A_STOP - 0.01, False),
        ("go", ("come", "stop"), (1.0, 6.0), SURE_BESIDE_A_STOP - 0.01, False),
        ("go", ("come", "stop"), (1.0, 7.0), SURE_ENOUGH, True),
        ("go", ("come", "stop"), (), SURE_BESIDE_A_STOP, True),
        ("go", ("come", "right"), (), SURE_ENOUGH, True),
        ("go back two meters", ("stop",), (), SURE_ENOUGH, True),
    ],
)
def test_a_word_that_may_have_been_a_stop_must_be_surer(judge, text, alternatives, behind, confidence, done):
    """Of 464 "stop" in noise four were heard "go", and the robot drove off. But any word is compared with a "stop"."""
    transcript = Transcript(text, -2.0, text, alternatives=alternatives, behind=behind, confidence=confidence)
    assert bool(judge.meaning(transcript, (), ()).actions) is done


@pytest.mark.parametrize(
    ("freely", "state", "stops"),
    [
        ("No, no, the bedroom.", ["moving"], True),
        ("No, the bedroom.", ["moving"], True),
        ("No, no, the bedroom.", [], False),
        ("No, that is the bedroom.", ["moving"], False),
    ],
)
def test_a_no_with_what_is_meant_stops_whatever_sentence_is_the_nearest(judge, freely, state, stops):
    """Of "no, no, the left door" the nearest sentence was "do not the left four", and the robot drove on."""
    transcript = Transcript("do not the left four", -0.2, freely, confidence=0.15)
    assert judge.meaning(transcript, state, judge.engine.parse("go to the kitchen")).stops is stops
