"""Two models: when the second is asked, and what becomes of what both heard."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import WeightsError
from intent_engine.judgement import SURE_ENOUGH_TO_STOP
from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import NONE, SecondOpinion, recognizer_for, second_model, weighed
from intent_engine.speech.steered import SteeredWhisper

SOUND = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
FORWARD, LEFT = "go forward two meters", "turn left"


def heard(text: str, confidence: float | None, **more) -> Transcript:
    return Transcript(text, free_text=text, confidence=confidence, decode_seconds=0.25, **more)


class Says:
    """A recogniser that hears what it was made for."""

    def __init__(self, *answers: Transcript) -> None:
        self.answers = answers
        self.asked: list[tuple[int, bool]] = []
        self.closed = False

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.asked.append((samples.size, final))
        return self.answers[min(len(self.asked), len(self.answers)) - 1]

    def close(self) -> None:
        self.closed = True


def two(engine, first: Transcript, second: Transcript) -> tuple[SecondOpinion, Says, Says]:
    one, other = Says(first), Says(second)
    return SecondOpinion(engine, one, lambda: other), one, other


# -- when it is asked --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("confidence", [0.9, 1.0])
def test_who_is_sure_asks_nobody(engine, confidence):
    both, _, other = two(engine, heard(FORWARD, confidence), heard(LEFT, 1.0))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == FORWARD
    assert other.asked == []


@pytest.mark.parametrize(
    "first",
    [
        heard("", None),
        heard("don't go forward two meters", None, score=-0.9),
        heard("go forward, no never mind", None, score=-0.9),
        heard("what lovely weather we have", None, score=-0.2),
        heard(FORWARD, 0.01),
    ],
)
def test_silence_what_shall_not_be_done_and_clear_talk_need_no_second_opinion(engine, first):
    both, _, other = two(engine, first, heard(LEFT, 1.0))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == first.text
    assert other.asked == []


@pytest.mark.parametrize(
    "first", [heard(FORWARD, 0.5), heard("oh four what", None, score=-0.9), heard(FORWARD, 1.0, unclear=("two",))]
)
def test_who_is_unsure_says_so_at_first_and_asks_when_it_is_over(engine, first):
    both, _, other = two(engine, first, heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).draft
    assert other.asked == [], "somebody may still be speaking"
    found = both.transcribe(SOUND)
    assert other.asked == [(SOUND.size, True)]
    assert (found.text, found.draft) == (FORWARD, False)


def test_the_first_does_not_hear_the_same_words_twice(engine):
    both, one, _ = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).decode_seconds == 0.25
    longer = np.concatenate((SOUND, np.zeros(SAMPLE_RATE // 3, np.float32)))
    longer[SOUND.size - 800 : SOUND.size] *= 0.9  # a noise filter had not ended there
    found = both.transcribe(longer)
    assert len(one.asked) == 1
    assert found.decode_seconds == 0.25, "only the second model's"


@pytest.mark.parametrize(
    "sound",
    [
        SOUND[::-1].copy(),
        SOUND[: SOUND.size // 2],
        np.concatenate((SOUND, np.zeros(3 * SAMPLE_RATE, np.float32))),
    ],
    ids=["another", "shorter", "much longer"],
)
def test_other_sound_is_heard_anew(engine, sound):
    both, one, _ = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    both.transcribe(SOUND, final=False)
    assert both.transcribe(sound).decode_seconds == 0.5, "both models'"
    assert len(one.asked) == 2


def test_a_draft_is_used_once(engine):
    both, one, _ = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    both.transcribe(SOUND, final=False)
    both.transcribe(SOUND)
    both.transcribe(SOUND)
    assert len(one.asked) == 2


def test_a_second_model_that_cannot_be_made_is_told_by_each_decode_that_needs_it(engine):
    def fails() -> Says:
        raise WeightsError("gone")

    both = SecondOpinion(engine, Says(heard(FORWARD, 0.5)), fails)
    for _ in range(2):
        with pytest.raises(WeightsError):
            both.transcribe(SOUND)
    both.close()


def test_both_are_closed(engine):
    both, one, other = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    both.close()
    assert one.closed
    assert other.closed


# -- what becomes of it ------------------------------------------------------------------------------------------

CONFIDENCES = st.one_of(st.none(), st.floats(0, 1))
TEXTS = st.sampled_from([FORWARD, LEFT, "go forward 2 m", "the weather is nice", "don't turn left", "stop"])


def both_think(engine, first: Transcript, second: Transcript) -> Transcript:
    return weighed(first, second, engine.parse(first.text), engine.parse(second.text))


@given(TEXTS, TEXTS, CONFIDENCES, CONFIDENCES)
def test_what_is_taken_was_heard_by_one_and_refused_by_none(engine, one, other, sure, surer):
    found = both_think(engine, heard(one, sure), heard(other, surer))
    assert found.text in (one, other)
    assert found.confidence is None or 0 <= found.confidence <= 1
    if "don't turn left" in (one, other):
        assert found.text == "don't turn left"
        assert found.confidence in (sure, surer)


@given(st.floats(0, 1), st.floats(0, 1))
def test_who_agrees_is_believed_sooner_than_who_differs(engine, sure, surer):
    agreed = both_think(engine, heard(FORWARD, sure), heard("go forward 2 m", surer)).confidence
    differed = both_think(engine, heard(FORWARD, sure), heard(LEFT, surer)).confidence
    assert agreed > differed


@given(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))
def test_the_surer_the_one_the_surer_both_and_the_surer_the_other_the_less(engine, sure, surer, doubt):
    low, high = sorted((sure, surer))
    doubt *= low
    weak = both_think(engine, heard(FORWARD, low), heard(LEFT, doubt))
    strong = both_think(engine, heard(FORWARD, high), heard(LEFT, doubt))
    assert weak.confidence <= strong.confidence
    assert both_think(engine, heard(FORWARD, high), heard(LEFT, 0.0)).confidence >= strong.confidence


def test_the_surer_is_taken_and_of_equals_the_larger_model(engine):
    assert both_think(engine, heard(FORWARD, 0.8), heard(LEFT, 0.3)).text == FORWARD
    assert both_think(engine, heard(FORWARD, 0.3), heard(LEFT, 0.8)).text == LEFT
    assert both_think(engine, heard(FORWARD, 0.5), heard(LEFT, 0.5)).text == LEFT


@pytest.mark.parametrize(
    ("first", "second", "other", "unclear"),
    [
        (("fifteen",), (), "turn left fifteen degrees", ()),
        ((), ("fifteen",), "turn left fifteen degrees", ()),
        (("fifteen",), ("fifteen",), "turn left fifteen degrees", ("fifteen",)),
        (("fifteen",), (), "turn left fifty degrees", ("fifteen",)),
        (("fifteen",), ("fifty",), "turn left fifty degrees", ("fifty", "fifteen")),
        ((), (), "turn left fifty degrees", ()),
    ],
)
def test_a_number_that_one_is_unsure_of_must_be_what_the_other_heard(engine, first, second, other, unclear):
    found = both_think(
        engine, heard("turn left fifteen degrees", 1.0, unclear=first), heard(other, 1.0, unclear=second)
    )
    assert found.unclear == unclear


def test_both_must_be_surer_of_a_stop_that_the_first_did_not_take_for_one(engine):
    doubtful = heard("whoa", 0.3)
    assert both_think(engine, doubtful, heard("whoa", 0.5)) is doubtful, "wow"
    sure = both_think(engine, doubtful, heard("whoa", 0.97))
    assert sure.confidence > 0.7


@pytest.mark.parametrize(("confidence", "asked"), [(SURE_ENOUGH_TO_STOP, 0), (SURE_ENOUGH_TO_STOP - 0.01, 1)])
def test_a_stop_that_is_one_already_needs_no_second_opinion(engine, confidence, asked):
    both, _, other = two(engine, heard("stop", confidence), heard("go", 1.0))
    both.transcribe(SOUND)
    assert len(other.asked) == asked


def test_a_single_word_is_believed_less_than_a_sentence(engine):
    word = both_think(engine, heard("go", 0.6), heard("go", 0.7)).confidence
    sentence = both_think(engine, heard(FORWARD, 0.6), heard(FORWARD, 0.7)).confidence
    assert word < 0.7 < sentence


def test_where_neither_heard_a_command_the_words_of_the_first_are_told(engine):
    assert both_think(engine, heard("nice weather", None), heard("ice leather", None)).text == "nice weather"


# -- which models ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("model", "second", "found"),
    [("tiny.en", None, "base"), ("tiny.en", NONE, None), ("base", None, None), ("base", "tiny.en", "tiny.en")],
)
def test_the_second_model(model, second, found):
    assert second_model(model, second) == found


def test_a_second_model_that_was_named_must_be_there():
    with pytest.raises(WeightsError):
        second_model("tiny.en", "/nowhere/at/all")


def test_without_a_second_the_first_is_all_there_is(engine):
    recognizer = recognizer_for(engine, second=NONE)
    assert isinstance(recognizer, SteeredWhisper)
    recognizer.close()


# -- in a robot --------------------------------------------------------------------------------------------------


def test_a_doubtful_command_is_heard_again_when_it_is_over_and_done(engine, listen, go_forward):
    both, one, other = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 0.9))
    found = listen(go_forward, both)
    assert (len(one.asked), len(other.asked)) == (1, 1)
    assert found.robot.pose().x == pytest.approx(2.0)
    (transcript,) = (event.transcript for event in found.of(HeardKind.TRANSCRIPT))
    assert transcript.confidence > 0.7
    (partial,) = (event.transcript for event in found.of(HeardKind.PARTIAL))
    assert partial.draft


def test_a_command_that_was_heard_well_is_done_at_once(engine, listen, go_forward):
    both, _, other = two(engine, heard(FORWARD, 0.8), heard(LEFT, 1.0))
    found = listen(go_forward, both)
    assert other.asked == [], "0.8 is enough for one command"
    assert found.robot.pose().x == pytest.approx(2.0)


def test_two_that_differ_move_nothing(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 0.6), heard(LEFT, 0.6))
    found = listen(go_forward, both)
    assert found.goals == []
    (meaning,) = (event.interpretation for event in found.of(HeardKind.INTERPRETATION))
    assert meaning.actions == ()


def test_a_recogniser_whose_final_word_is_a_draft_is_not_asked_for_ever(engine, listen, go_forward):
    stubborn = Says(replace(heard("nice weather", None), draft=True))
    found = listen(go_forward, stubborn)
    assert len(stubborn.asked) == 2
    assert found.goals == []
