"""What words right after a command have to do with it."""

from __future__ import annotations

import pytest

from intent_engine.runtime.follow_up import CORRECTED_CLEARLY, FollowUp
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY, HARDLY_A_WORD


@pytest.fixture(scope="module")
def follow_up(engine) -> FollowUp:
    return FollowUp(engine)


def heard(text: str, score: float = 0.0) -> Transcript:
    return Transcript(text, score, text, confidence=1.0)


@pytest.mark.parametrize(
    ("text", "begins", "only", "ends"),
    [
        ("no, right", True, False, False),
        ("no", True, True, True),
        ("no wait", True, True, True),
        ("turn left no", False, False, True),
        ("turn left", False, False, False),
        ("", False, False, False),
    ],
)
def test_where_a_correction_stands(follow_up, text, begins, only, ends):
    for score, found in ((0.0, (begins, only, ends)), (HARDLY_A_WORD, (False, False, False))):
        said = heard(text, score)
        told = follow_up.corrects(said), follow_up.only_corrects(said), follow_up.ends_in_correction(said)
        assert told == found, "what was hardly a word takes nothing back"


@pytest.mark.parametrize(
    ("text", "after", "later"),
    [
        ("and then turn left", True, True),
        ("and turn left", True, False),
        ("when you get there turn left", True, True),
        ("turn left and then go forward", False, False),
        ("turn left next, please", False, True),
        ("turn left after that", False, True),
        ("turn left next and go forward", False, True),
        ("turn left next to it", False, False),
        ("turn left", False, False),
    ],
)
def test_what_is_done_after_the_command_before(follow_up, text, after, later):
    assert follow_up.comes_after(heard(text)) is after
    assert follow_up.comes_later(heard(text)) is later


@pytest.mark.parametrize(
    ("text", "score", "joined"),
    [
        ("slowly", CLEARLY, True),
        ("slowly", CLEARLY - 0.01, False),
        ("no right", CLEARLY - 0.01, True),
        ("no right", CORRECTED_CLEARLY - 0.01, False),
        ("sixty degrees", CLEARLY, False),  # or sixteen
        ("what a day", CLEARLY, False),
    ],
)
def test_words_that_were_clear_are_one_command_with_those_before(follow_up, text, score, joined):
    assert (follow_up.together("turn left", heard(text, score), ()) is not None) is joined


@pytest.mark.parametrize(("text", "stops"), [("going forward", True), ("go back", False), ("what a day", False)])
def test_a_stop_may_go_on(follow_up, text, stops):
    whole = follow_up.stop_going_on("stop", heard(text), ())
    assert (whole is not None and whole.stops) is stops


def test_what_only_begins_like_a_stop_is_none(engine_of):
    follow_up = FollowUp(
        engine_of(
            "intents: {halt: {action: stop, sentences: [stop]}, mute: {action: custom, sentences: [stop it all]}}"
        )
    )
    assert follow_up.stop_going_on("stop", heard("it all"), ()) is None


def test_two_sentences_may_be_one_of_the_grammar(engine_of):
    follow_up = FollowUp(
        engine_of("intents: {quieter: {action: custom, sentences: ['too loud turn it down', turn it down]}}")
    )
    whole = follow_up.one_sentence("too loud", heard("turn it down"), ())
    assert whole is not None
    assert whole.actions
    assert follow_up.one_sentence("turn it down", heard("turn it down"), ()) is None
