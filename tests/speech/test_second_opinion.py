"""Two models: when the second is asked, and what becomes of what both heard."""

from __future__ import annotations

import platform
import sys
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import WeightsError
from intent_engine.judgement import SURE_ENOUGH_TO_STOP
from intent_engine.runtime import SECOND_LOOK, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.evidence import View
from intent_engine.speech.moonshine_weights import MOONSHINE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import NONE, SecondOpinion, recognizer_for, second_model
from intent_engine.speech.steered import SteeredWhisper

SOUND = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
FORWARD, LEFT = "go forward two meters", "turn left"
LIKELY, UNLIKELY = -1.0, -20.0
MOONSHINE_CAN_BE_HAD = (sys.platform, platform.machine()) == ("linux", "x86_64")


def heard(text: str, confidence: float | None, **more) -> Transcript:
    return Transcript(text, free_text=text, confidence=confidence, decode_seconds=0.25, **more)


@dataclass
class Thinks:
    """An opinion that was made up: what is thought of each sentence, and how clear words are."""

    transcript: Transcript
    scores: dict[str, float] = field(default_factory=dict)
    clear: dict[str, float] = field(default_factory=dict)

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(tuple(text.split()) for text in self.scores)

    def views(self, sentences):
        return [View(self.scores.get(" ".join(words), UNLIKELY), LIKELY, 0.0) for words in sentences]

    def clearness(self, _words):
        return self.clear


class Says:
    """A recogniser that hears what it was made for, and finds that likely."""

    def __init__(self, engine, answer: Transcript | Thinks) -> None:
        if isinstance(answer, Transcript):
            answer = Thinks(answer, {answer.text: LIKELY} if engine.parse(answer.text).actions else {})
        self.opinion = answer
        self.asked: list[tuple[int, bool]] = []
        self.glances = 0
        self.heard = 0
        self.closed = False
        self._steering = object.__new__(SteeredWhisper)
        self._steering.steer(engine)

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.asked.append((samples.size, final))
        self.heard = samples.size
        return self.opinion.transcript

    def glance(self, samples: np.ndarray) -> Thinks:
        self.glances += 1
        self.heard = samples.size
        return self.opinion

    def ranked(self, views, language=None):
        return self._steering.ranked(views, language)

    def close(self) -> None:
        self.closed = True


def two(engine, first: Transcript | Thinks, second: Transcript | Thinks) -> tuple[SecondOpinion, Says, Says]:
    one, other = Says(engine, first), Says(engine, second)
    return SecondOpinion(engine, one, lambda: other), one, other


# -- when it is asked --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("confidence", [0.95, 1.0])
def test_who_is_sure_asks_nobody(engine, confidence):
    both, _, other = two(engine, heard(FORWARD, confidence), heard(LEFT, 1.0))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == FORWARD
    assert other.glances == 0


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
    assert other.glances == 0


@pytest.mark.parametrize(
    "first", [heard(FORWARD, 0.5), heard("oh four what", None, score=-0.9), heard(FORWARD, 1.0, unclear=("two",))]
)
def test_who_is_unsure_says_so_at_first_and_asks_when_it_is_over(engine, first):
    both, _, other = two(engine, first, heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).draft
    assert other.glances == 0, "somebody may still be speaking"
    found = both.transcribe(SOUND)
    assert other.glances == 1
    assert (found.text, found.draft) == (FORWARD, False)


@pytest.mark.parametrize(("score", "searched"), [(LIKELY, False), (-9.0, True)])
def test_the_second_searches_the_grammar_only_where_both_are_not_sure_at_first_sight(engine, score, searched):
    opinion = Thinks(heard(FORWARD, 0.5), {FORWARD: score})
    both, _, other = two(engine, opinion, opinion)
    both.transcribe(SOUND)
    assert (other.glances, other.asked) == (1, [(SOUND.size, True)] if searched else [])


def test_the_first_does_not_hear_the_same_words_twice(engine):
    both, one, _ = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).decode_seconds == 0.25
    longer = np.concatenate((SOUND, np.zeros(SAMPLE_RATE // 3, np.float32)))
    longer[SOUND.size - 800 : SOUND.size] *= 0.9  # a noise filter had not ended there
    found = both.transcribe(longer)
    assert len(one.asked) == 1
    assert found.decode_seconds < 0.25, "only the second model's"


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
    assert both.transcribe(sound).decode_seconds > 0.25, "both models'"
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

    both = SecondOpinion(engine, Says(engine, heard(FORWARD, 0.5)), fails)
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

SENTENCES = [FORWARD, LEFT, "go back", "stop", "turn left fifteen degrees"]
TEXTS = st.sampled_from([*SENTENCES, "the weather is nice", "don't turn left"])
SCORES = st.dictionaries(st.sampled_from(SENTENCES), st.floats(-30, -0.1), max_size=4)
DOUBTFUL = st.builds(Thinks, st.builds(heard, TEXTS, st.floats(0.05, 0.39), score=st.just(-0.9)), SCORES)


def both_think(engine, first: Transcript | Thinks, second: Transcript | Thinks) -> Transcript:
    both, *_ = two(engine, first, second)
    return both.transcribe(SOUND)


@given(DOUBTFUL, DOUBTFUL)
def test_what_is_taken_was_thought_of_by_one_and_refused_by_none(engine, one, other):
    found = both_think(engine, one, other)
    said = {one.transcript.text, other.transcript.text}
    assert found.text in said | set(one.scores) | set(other.scores)
    assert 0 <= found.confidence <= 1
    if "don't turn left" in said:
        assert engine.parse(found.text).refuses


@given(st.floats(-12, LIKELY), st.floats(-12, LIKELY))
def test_who_agrees_is_believed_sooner_than_who_differs(engine, score, another):
    first = Thinks(heard(FORWARD, 0.5), {FORWARD: score})
    agreed = both_think(engine, first, Thinks(heard(FORWARD, 0.5), {FORWARD: another}))
    differed = both_think(engine, first, Thinks(heard(LEFT, 0.5), {LEFT: another}))
    assert agreed.text == FORWARD
    assert agreed.confidence > differed.confidence


def test_the_likelier_for_both_is_taken_though_neither_put_it_first(engine):
    first = Thinks(heard(FORWARD, 0.5), {FORWARD: -1.0, "go back": -2.0, LEFT: -15.0})
    second = Thinks(heard(LEFT, 0.5), {LEFT: -1.0, "go back": -2.0, FORWARD: -15.0})
    assert both_think(engine, first, second).text == "go back"


@pytest.mark.parametrize(
    ("first", "second", "unclear"),
    [
        (-1.0, 2.0, ()),
        (-2.5, -0.4, ()),
        (-2.5, -0.6, ("fifteen",)),
        (-3.1, 20.0, ("fifteen",)),
        (20.0, -3.1, ("fifteen",)),
        (1.0, None, ()),
        (-2.0, None, ("fifteen",)),
    ],
    ids=["one is sure", "both a little", "too little", "one heard fifty", "the other did", "alone", "alone and unsure"],
)
def test_of_a_number_like_another_what_both_heard_adds_up_if_neither_heard_the_other(engine, first, second, unclear):
    text = "turn left fifteen degrees"
    found = both_think(
        engine,
        Thinks(heard(text, 1.0, unclear=("fifteen",)), {text: LIKELY}, {"fifteen": first}),
        Thinks(heard(text, 1.0), {text: LIKELY}, {} if second is None else {"fifteen": second}),
    )
    assert found.unclear == unclear


def test_both_must_be_surer_of_a_stop_that_the_first_did_not_take_for_one(engine):
    doubtful = Thinks(heard("whoa", 0.3), {"whoa": -12.0})
    unsure = both_think(engine, doubtful, Thinks(heard("whoa", 0.5), {"whoa": -12.0}))
    assert (unsure.text, unsure.confidence) == ("whoa", 0.3), "wow"
    assert both_think(engine, doubtful, Thinks(heard("whoa", 0.97), {"whoa": -0.5})).confidence > 0.7


@pytest.mark.parametrize(("confidence", "asked"), [(SURE_ENOUGH_TO_STOP, 0), (SURE_ENOUGH_TO_STOP - 0.01, 1)])
def test_a_stop_that_is_one_already_needs_no_second_opinion(engine, confidence, asked):
    both, _, other = two(engine, heard("stop", confidence), heard("go", 1.0))
    both.transcribe(SOUND)
    assert other.glances == asked


def test_where_neither_heard_a_command_the_words_of_the_first_are_told(engine):
    nice = heard("nice weather", None, score=-0.9)
    assert both_think(engine, nice, heard("ice leather", None)).text == "nice weather"


# -- which models ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("model", "second", "language", "found"),
    [
        ("tiny.en", None, None, MOONSHINE),
        ("tiny", None, "en", MOONSHINE),
        ("tiny", None, "de", "base"),
        ("tiny.en", NONE, None, None),
        ("base", None, None, None),
        ("base", "tiny.en", None, "tiny.en"),
        ("base", MOONSHINE, None, MOONSHINE),
    ],
)
def test_the_second_model(engine, model, second, language, found):
    if found == MOONSHINE and not MOONSHINE_CAN_BE_HAD:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    assert second_model(engine, model, second, language=language) == found


def test_where_moonshine_is_not_installed_the_second_is_base(engine, monkeypatch):
    monkeypatch.setattr("intent_engine.speech.second_opinion.moonshine_package", lambda: None)
    assert second_model(engine, "tiny.en") == "base"


def test_a_second_model_that_was_named_must_be_there(engine):
    with pytest.raises(WeightsError):
        second_model(engine, "tiny.en", "/nowhere/at/all")


def test_without_a_second_the_first_is_all_there_is(engine):
    recognizer = recognizer_for(engine, second=NONE)
    assert isinstance(recognizer, SteeredWhisper)
    recognizer.close()


def test_a_second_model_that_nobody_named_is_left_out_where_it_cannot_be_made_ready(engine, tmp_path, monkeypatch):
    if not MOONSHINE_CAN_BE_HAD:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    (tmp_path / "cache").write_text("a file")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    told: list[str] = []
    recognizer = recognizer_for(engine, tell=told.append)
    assert isinstance(recognizer, SteeredWhisper)
    recognizer.close()
    assert told[-1].startswith("no second model: ")
    with pytest.raises(WeightsError):
        recognizer_for(engine, second=MOONSHINE)


# -- in a robot --------------------------------------------------------------------------------------------------


def test_a_doubtful_command_is_heard_again_when_it_is_over_and_done(engine, listen, go_forward):
    both, one, other = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 0.9))
    found = listen(go_forward, both)
    assert (len(one.asked), other.glances) == (1, 1)
    assert found.robot.pose().x == pytest.approx(2.0)
    (transcript,) = (event.transcript for event in found.of(HeardKind.TRANSCRIPT))
    assert transcript.confidence > 0.7
    drafts = [event.transcript.draft for event in found.of(HeardKind.PARTIAL)]
    assert drafts == [True, False]


def test_a_command_that_was_heard_well_is_done_at_once(engine, listen, go_forward):
    both, _, other = two(engine, heard(FORWARD, 0.96), heard(LEFT, 1.0))
    found = listen(go_forward, both)
    assert other.glances == 0
    assert found.robot.pose().x == pytest.approx(2.0)


def test_a_draft_is_not_done_however_sure_it_is(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 0.9), heard("don't go forward", None))
    found = listen(go_forward, both)
    assert found.goals == []


def test_two_that_differ_move_nothing(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 0.6), heard(LEFT, 0.6))
    found = listen(go_forward, both)
    assert found.goals == []
    (meaning,) = (event.interpretation for event in found.of(HeardKind.INTERPRETATION))
    assert meaning.actions == ()


def test_a_second_look_is_taken_in_the_silence_and_not_in_a_short_pause(engine, listen, go_forward, demo):
    """So that its answer is there when the wait is over."""
    both, one, other = two(engine, heard("go forward", 0.5), heard("go forward", 1.0))
    listen(go_forward, both)
    assert other.glances == 1
    assert 0 < other.heard - one.heard < (SECOND_LOOK + 0.1) * SAMPLE_RATE


def test_a_recogniser_whose_final_word_is_a_draft_is_not_asked_for_ever(engine, listen, go_forward):
    stubborn = Says(engine, replace(heard("nice weather", None), draft=True))
    found = listen(go_forward, stubborn)
    assert len(stubborn.asked) == 2
    assert found.goals == []
