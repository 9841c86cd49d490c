"""Whether more can be expected after what was heard, and how long it is waited for."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation
from intent_engine.runtime.expectation import Expectation
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY


@pytest.fixture(scope="module")
def judge(engine) -> Judge:
    return Judge(engine)


def expected(judge: Judge, said: Transcript, amendable: bool = False) -> tuple[Interpretation | None, Outlook]:
    return Expectation(judge).outlook(said, (), (), amendable=amendable)


def test_an_unsure_sentence_is_waited_for_by_the_words_that_were_heard(judge):
    meaning, outlook = expected(judge, Transcript("go to the dock", free_text="go to the", gap=1.0, confidence=0.2))
    assert meaning is not None
    assert meaning.actions == ()
    assert outlook is Outlook.INCOMPLETE
    _, outlook = expected(judge, Transcript("go to the dock", free_text="goats eat a dog", gap=1.0, confidence=0.2))
    assert outlook is Outlook.OTHER


@pytest.mark.parametrize(
    ("confidence", "score", "outlook"),
    [
        (0.9, CLEARLY - 0.01, Outlook.DOUBTFUL),
        (0.9, CLEARLY, Outlook.EXTENDABLE),
        (1.0, CLEARLY - 0.01, Outlook.EXTENDABLE),
        (None, CLEARLY - 0.01, Outlook.EXTENDABLE),
    ],
)
def test_what_was_hardly_heard_and_could_go_on_is_waited_for_longer(judge, confidence, score, outlook):
    left = Transcript("turn left", score, "turned left", gap=0.1, confidence=confidence)
    assert expected(judge, left)[1] is outlook
    over = Transcript("go to the dock", score, "goat to the dock", gap=0.1, confidence=confidence)
    known = Outlook.SETTLED if confidence == 0.9 else Outlook.COMPLETE
    assert expected(judge, over)[1] is known, "nothing can follow what was heard word by word"


@pytest.mark.parametrize(
    ("text", "outlooks"),
    [
        ("turn left", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("go to the dock", (Outlook.COMPLETE, Outlook.COMPLETE)),
        ("turn left ninety degrees", (Outlook.COMPLETE, Outlook.COMPLETE)),
        ("turn left then turn right ninety degrees", (Outlook.SETTLED, Outlook.SETTLED)),
        ("pick up the cup", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("put down the cup", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
        ("put the cup on the table", (Outlook.AMENDABLE, Outlook.EXTENDABLE)),
        ("put the cup on the table then go forward", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
        ("turn left then go forward", (Outlook.EXTENDABLE, Outlook.DOUBTFUL)),
    ],
)
def test_a_motion_that_can_be_put_right_is_waited_for_less(judge, text, outlooks):
    for score, outlook in zip((CLEARLY, CLEARLY - 0.01), outlooks, strict=True):
        assert expected(judge, Transcript(text, score, "-", gap=0.1, confidence=0.95), amendable=True)[1] is outlook


@pytest.mark.parametrize("text", ["Move backward for meters.", "Could you go back to meters?", "go forward to feet"])
def test_a_number_that_was_written_as_a_word_of_its_sound_is_one(judge, text):
    """Else the whole sentence would be waited for as one that may go on anyhow."""
    assert expected(judge, Transcript(text, 0.0, text, gap=0.0, confidence=1.0), amendable=True)[1] is Outlook.COMPLETE


def test_a_motion_that_cannot_be_put_right_waits_for_its_manner(judge):
    assert expected(judge, Transcript("turn left ninety degrees", 0.0, "-", confidence=1.0))[1] is Outlook.SETTLED


@pytest.mark.parametrize(
    ("text", "outlook"),
    [
        ("fly north ten meters", Outlook.EXTENDABLE),  # "at two meters per second"
        ("fly north ten meters at two meters per second", Outlook.COMPLETE),
        ("climb ten meters", Outlook.SETTLED),  # "and a half"
    ],
)
def test_the_speed_of_what_a_program_does_is_a_value_like_any_other(tmp_path, text, outlook):
    file = tmp_path / "drone.yaml"
    file.write_text(
        "slots: {length: distance, pace: speed}\n"
        "intents: {fly: {action: custom, sentences: ['fly north {length} [at {pace}]', 'climb {length}']}}\n"
    )
    judge = Judge(IntentEngine.from_files(file))
    assert expected(judge, Transcript(text, 0.0, "-", confidence=1.0), amendable=True)[1] is outlook


@pytest.mark.parametrize(
    ("text", "outlook"),
    [("sleep for an hour", Outlook.EXTENDABLE), ("sleep for ten minutes", Outlook.SETTLED)],
)
def test_who_says_an_hour_may_go_on_after_a_rest(tmp_path, text, outlook):
    file = tmp_path / "timer.yaml"
    file.write_text(
        "slots: {length: duration}\nintents: {timer: {action: custom, sentences: ['sleep for {length}']}}\n"
    )
    judge = Judge(IntentEngine.from_files(file))
    assert expected(judge, Transcript(text, 0.0, "-", confidence=1.0), amendable=True)[1] is outlook


def test_a_motion_is_not_waited_for_since_it_can_be_put_right(judge):
    heard = Transcript("go forward one meter", 0.0, "-", confidence=1.0)
    assert expected(judge, heard, amendable=True)[1] is Outlook.COMPLETE
    assert expected(judge, heard)[1] is Outlook.EXTENDABLE


HOTEL = """
slots:
  room: {type: number, whole: true, min: 100, max: 400}
  place: [pool, laundry, lobby]
intents:
  bring: {action: custom, sentences: ["bring towels to (the {place}|{place}|room {room})"]}
"""


@pytest.mark.parametrize(
    ("text", "free", "outlook"),
    [
        ("bring towels to pool", "bring towels to rule", Outlook.EXTENDABLE),  # or to room ...
        ("bring towels to pool", "ring towels to rule", Outlook.EXTENDABLE),
        ("bring towels to pool", "bringing towels to rume", Outlook.EXTENDABLE),
        ("bring towels to the pool", "bring towels to room", Outlook.EXTENDABLE),
        ("bring towels to pool", "ring towels to pull", Outlook.SETTLED),
        ("bring towels to the lobby", "bring towels to the loby", Outlook.SETTLED),
        ("bring towels to the lobby", "bring towels the lobby", Outlook.SETTLED),
        ("bring towels to pool", "bring towels to pool", Outlook.COMPLETE),
    ],
)
def test_what_is_as_like_an_unfinished_sentence_is_waited_for(engine_of, text, free, outlook):
    confidence = 1.0 if text == free else 0.9
    heard = Transcript(text, CLEARLY, free, gap=0.1, confidence=confidence)
    assert expected(Judge(engine_of(HOTEL)), heard)[1] is outlook


LIBRARY = """
slots:
  shelf: {type: number, whole: true, min: 1, max: 250}
  what: {type: choice, values: ["on", "off"]}
  lamp: [flash, torch]
intents:
  count: {action: custom, sentences: ["count the books on shelf {shelf}"]}
  scan: {action: custom, sentences: ["scan the shelf [with {lamp}]"]}
  vacuum: {action: custom, sentences: ["turn the vacuum {what}"]}
"""


@pytest.mark.parametrize(
    ("text", "outlook"),
    [
        ("count the books on shelf eight", Outlook.SETTLED),  # "eight dozen" is said in one piece
        ("count the books on shelf nineteen", Outlook.SETTLED),
        ("count the books on shelf two", Outlook.EXTENDABLE),  # hundred
        ("count the books on shelf twenty", Outlook.EXTENDABLE),
        ("count books on a shelf", Outlook.OTHER),
        ("scan the shelf", Outlook.EXTENDABLE),
        ("scan a shelf", Outlook.EXTENDABLE),
        ("scan a shelf with flash", Outlook.COMPLETE),
        ("scan the shelf please", Outlook.SETTLED),
        ("scan the shelf with flash please", Outlook.COMPLETE),
    ],
)
def test_what_is_said_whole_is_not_waited_for(engine_of, text, outlook):
    heard = Transcript(text, 0.0, text, confidence=1.0)
    assert expected(Judge(engine_of(LIBRARY)), heard)[1] is outlook


def test_please_that_was_hardly_heard_ends_nothing(engine_of):
    heard = Transcript("scan the shelf please", CLEARLY, "scan the shelf wit flees", gap=0.1, confidence=0.9)
    assert expected(Judge(engine_of(LIBRARY)), heard)[1] is Outlook.EXTENDABLE


def test_nobody_rests_behind_an_article(engine_of):
    """ "Turn the vacuum a" is as like "turn the machumov", but nobody is silent there."""
    heard = Transcript("turn the vacuum off", CLEARLY, "turn the machumov", gap=0.1, confidence=0.9)
    assert expected(Judge(engine_of(LIBRARY)), heard)[1] is Outlook.SETTLED
    cut = Transcript("turn the vacuum off", CLEARLY, "turn the vacuum", gap=0.1, confidence=0.9)
    assert expected(Judge(engine_of(LIBRARY)), cut)[1] is Outlook.EXTENDABLE


OWN_WAITS = """
intents:
  order: {action: {type: custom, name: order}, sentences: ["a latte [with milk]"], wait: 450 ms}
  wave: {action: {type: custom, name: wave}, sentences: ["wave [at me]"], wait: 0.2}
  bow: {action: {type: custom, name: bow}, sentences: ["bow [low]"]}
"""


@pytest.mark.parametrize(
    ("text", "outlook"),
    [
        ("a latte", Outlook.EXTENDABLE),
        ("a latte please", Outlook.EXTENDABLE),
        ("a latte with milk", Outlook.COMPLETE),
        ("bow", Outlook.SETTLED),  # low or not is the same to the robot
        ("bow please", Outlook.SETTLED),
    ],
)
def test_an_intent_that_says_how_long_waits_for_all_that_may_follow(engine_of, text, outlook):
    heard = Transcript(text, 0.0, text, confidence=1.0)
    assert expected(Judge(engine_of(OWN_WAITS)), heard)[1] is outlook


@pytest.mark.parametrize(
    ("text", "wait"),
    [
        ("a latte", 0.45),
        ("wave", 0.2),
        ("bow", None),
        ("wave and a latte", 0.45),
        ("bow and wave", 0.2),
        ("fetch a pony", None),
        ("don't wave", None),
    ],
)
def test_an_intent_says_how_long_it_waits_for_more(tmp_path, text, wait):
    (tmp_path / "own.yaml").write_text(OWN_WAITS, encoding="utf-8")
    judge = Judge(IntentEngine.from_files(tmp_path / "own.yaml"))
    transcript = Transcript(text, free_text=text, confidence=1.0)
    meaning, _ = expected(judge, transcript)
    assert Expectation(judge).wait(transcript, meaning) == wait


@pytest.mark.parametrize(
    ("text", "nothing"),
    [
        ("go forw", False),
        ("go to the kitch", False),
        ("what a nice da", True),
        ("thought", False),  # the only word may be half of another
        ("", False),
    ],
)
def test_what_no_command_begins_with_is_known_before_it_is_over(judge, text, nothing):
    assert Expectation(judge).begins_nothing(Transcript(text, free_text=text)) is nothing
