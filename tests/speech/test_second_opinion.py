"""Two models: when the second is asked, and what becomes of what both heard."""

from __future__ import annotations

import platform
import sys
import threading
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import WeightsError
from intent_engine.judgement import ANOTHER_WORD, SURE_ENOUGH_TO_STOP
from intent_engine.runtime import SECOND_LOOK, HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.evidence import View, letters_apart
from intent_engine.speech.moonshine_weights import MOONSHINE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import NONE, SURE_TOGETHER, SecondOpinion, recognizer_for, second_model
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
    settled: bool = False
    others: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """What else may have been said in place of a sentence."""

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(tuple(text.split()) for text in self.scores)

    @property
    def heard(self) -> list[str]:
        return self.transcript.free_text.split()

    def views(self, sentences):
        return [
            View(self.scores.get(" ".join(words), UNLIKELY), LIKELY, letters_apart(words, self.heard))
            for words in sentences
        ]

    def beside(self, words, *, far=False):
        return tuple(tuple(text.split()) for text in self.others.get(" ".join(words), ()))

    def clearness(self, _words):
        return self.clear


@dataclass
class Knows(Thinks):
    """One who can say of all sentences how likely they are, and thought of few."""

    thought_of: frozenset[str] = frozenset()

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(one for one in super().sentences if " ".join(one) in self.thought_of)


class Says:
    """A recogniser that hears what it was made for, and finds that likely. What it is sure of is settled."""

    def __init__(self, engine, answer: Transcript | Thinks, found: Thinks | None = None) -> None:
        if isinstance(answer, Transcript):
            answer = Thinks(answer, {answer.text: LIKELY} if engine.parse(answer.text).actions else {})
        heard = answer.transcript
        settled = heard.confidence == 1.0 or not heard.text or engine.parse(heard.text).refuses
        self.opinion = replace(answer, settled=answer.settled or settled)
        self.found = found or answer
        self.listened: list[int] = []
        self.compared = self.searched = 0
        self.closed = False
        self.prepared = threading.Event()

    def prepare(self) -> None:
        self.prepared.set()

    def listen(self, samples: np.ndarray) -> Thinks:
        assert self.prepared.is_set()
        self.listened.append(samples.size)
        return self.opinion

    def compare(self, heard: Thinks) -> Thinks:
        self.compared += 1
        return heard

    def search(self, heard: Thinks) -> Thinks:
        self.searched += 1
        return heard if heard.settled else self.found

    def clear(self, heard: Thinks) -> Transcript:
        return heard.transcript

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        return self.search(self.listen(samples)).transcript

    def close(self) -> None:
        self.closed = True


def two(engine, first: Transcript | Thinks, second: Transcript | Thinks) -> tuple[SecondOpinion, Says, Says]:
    one, other = Says(engine, first), Says(engine, second)
    return SecondOpinion(engine, one, lambda: other), one, other


UNSURE = Thinks(heard(FORWARD, 0.5), {FORWARD: -14.0})

# -- before it is asked ------------------------------------------------------------------------------------------


def test_both_are_ready_before_the_first_words(engine):
    """So that these need not wait for what can be known before them."""
    _, one, other = two(engine, UNSURE, UNSURE)
    assert one.prepared.wait(60)
    assert other.prepared.wait(60)


# -- when it is asked --------------------------------------------------------------------------------------------


def test_who_heard_every_word_of_a_sentence_asks_nobody(engine):
    both, one, other = two(engine, heard(FORWARD, 1.0), heard(LEFT, 1.0))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == FORWARD
    assert (one.compared, other.listened) == (0, [])


@pytest.mark.parametrize(
    "first",
    [
        heard("", None),
        heard("don't go forward two meters", None, score=-0.9),
        heard("go forward, no never mind", None, score=-0.9),
        heard("what lovely weather we have", None, score=-0.2),
        heard("what lovely weather we have", 0.02, score=-0.2),
    ],
)
def test_silence_what_shall_not_be_done_and_clear_talk_need_no_second_opinion(engine, first):
    both, _, other = two(engine, first, heard(LEFT, 1.0))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == first.text
    assert other.listened == []


@pytest.mark.parametrize(
    "first",
    [
        heard(FORWARD, 0.96, score=-0.9),
        heard("oh four what", None, score=-0.9),
        heard(FORWARD, 1.0, unclear=("two",)),
        heard(FORWARD, 0.5, score=-0.1),
    ],
    ids=["hardly", "nothing", "a number", "clearly, but not this"],
)
def test_who_is_unsure_asks_at_once(engine, first):
    both, _, other = two(engine, first, heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).text == FORWARD
    assert other.listened == [SOUND.size]


def asked_during(monkeypatch, one, step: str, other, known: bool) -> threading.Event:
    """That the second is asked; it must be while the first takes a step, or must not be until then."""
    asked = threading.Event()
    monkeypatch.setattr(other, "listen", lambda _samples: asked.set() or UNSURE)

    def taken(_given):
        assert asked.wait(60 if known else 0) is known
        return UNSURE

    monkeypatch.setattr(one, step, taken)
    return asked


@pytest.mark.parametrize(
    ("words", "score", "known"),
    [
        ("forward go two meters", -0.2, True),
        ("forward go two lovely meters", -0.2, True),
        ("go what lovely weather we have", -0.2, False),
        ("go what lovely weather we have", -0.9, True),
    ],
    ids=["words of the grammar", "mostly", "other words, clearly", "hardly"],
)
def test_what_may_be_a_command_is_asked_about_while_the_first_compares(engine, monkeypatch, words, score, known):
    """And what is probably other talk only if the first finds a command in it."""
    both, one, other = two(engine, Thinks(heard(words, 0.5, score=score), {FORWARD: -14.0}), UNSURE)
    asked = asked_during(monkeypatch, one, "compare", other, known)
    both.transcribe(SOUND)
    assert asked.is_set()


FURTHER = np.concatenate((SOUND, SOUND))


@pytest.mark.parametrize(
    ("first", "then", "known"),
    [(UNSURE, FURTHER, True), (UNSURE, -FURTHER, False), (Thinks(heard(FORWARD, 1.0)), FURTHER, False)],
    ids=["in doubt", "another utterance", "sure"],
)
def test_of_an_utterance_that_was_in_doubt_both_listen_at_once_when_it_goes_on(engine, monkeypatch, first, then, known):
    both, one, other = two(engine, first, UNSURE)
    both.transcribe(SOUND, final=False)
    asked = asked_during(monkeypatch, one, "listen", other, known)
    both.transcribe(then, final=False)
    assert asked.is_set()


def test_where_both_are_sure_at_first_sight_neither_searches_the_grammar(engine):
    both, one, other = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 0.5))
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == FORWARD
    assert (one.searched, other.searched) == (0, 0)


def test_where_they_are_not_both_search_when_it_is_over(engine):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(heard("go back", 0.5), {"go back": LIKELY})
    assert both.transcribe(SOUND, final=False).draft
    assert (one.searched, other.searched) == (0, 0), "somebody may still be speaking"
    found = both.transcribe(SOUND)
    assert (one.searched, other.searched) == (1, 1)
    assert (found.text, found.draft) == ("go back", False)


@pytest.mark.parametrize(
    ("one", "other", "searched"),
    [
        ("go forward two meters", "oh four what to meet us", False),
        ("oh four what to meet us", "go forward to meters", False),
        ("oh four what to meet us", "goat for words two me does", True),
    ],
    ids=["one heard it", "the other nearly", "neither"],
)
def test_what_neither_heard_nearly_is_searched_for_a_better_one(engine, one, other, searched):
    """The likeliest of those at hand may be a sentence beside the one that was said."""
    first, second = (Thinks(replace(heard(text, 0.5), text=FORWARD), {FORWARD: LIKELY}) for text in (one, other))
    both, *_ = two(engine, first, second)
    found = both.transcribe(SOUND, final=False)
    assert found.confidence > SURE_TOGETHER
    assert found.draft is searched


@pytest.mark.parametrize(
    ("one", "other", "completed"),
    [("go forward", "go for two", False), ("go forward", FORWARD, True), ("", "go for two meet us", True)],
)
def test_of_a_sentence_that_goes_on_from_what_was_heard_one_must_have_heard_all(engine, one, other, completed):
    first = Thinks(heard(one or "p", 0.5), {"go forward": -3.0})
    first = replace(first, transcript=replace(first.transcript, free_text=one))
    second = Thinks(heard(other, 0.5), {FORWARD: LIKELY})
    found = both_think(engine, first, second)
    assert (found.text == FORWARD) is completed


def test_words_of_which_neither_heard_a_letter_are_not_added(engine):
    """Both heard all to the end; "then go forward" is what the grammar would have after it."""
    completed = f"{FORWARD} then go forward"
    first = Thinks(heard("go for what two meters", 0.5), {FORWARD: -6.0, completed: LIKELY})
    second = Thinks(heard("no forward too meters", 0.5), {FORWARD: -6.0})
    assert both_think(engine, first, second).text == FORWARD
    second = Thinks(heard("no forward too meters then no forward", 0.5), {FORWARD: -6.0, completed: LIKELY})
    assert both_think(engine, first, second).text == completed


@pytest.mark.parametrize("freely", ["pick up the flurb", "pick up the curb"])
def test_a_word_that_no_list_has_must_have_been_heard_by_both(engine, freely):
    """Nothing else tells whether it was said."""
    flurb = "pick up the flurb"
    first = Thinks(heard(flurb, 0.8), {flurb: LIKELY}, {"flurb": 0.3})
    second = Thinks(replace(heard(flurb, 0.8), free_text=freely), {flurb: LIKELY}, {"flurb": 0.3})
    found = both_think(engine, first, second)
    assert found.text == flurb
    assert found.unclear == (() if freely == flurb else ("flurb",))


def test_what_both_heard_to_the_end_is_not_left_out(engine):
    text = f"{FORWARD} at six miles"
    first = Thinks(replace(heard(FORWARD, 0.5), free_text=text), {FORWARD: LIKELY})
    for second_heard, unclear in ((text, ("miles",)), (FORWARD, ())):
        second = Thinks(replace(heard(FORWARD, 0.5), free_text=second_heard), {FORWARD: LIKELY})
        assert both_think(engine, first, second).unclear == unclear
    first = second = Thinks(replace(heard(FORWARD, 0.5), free_text=f"{FORWARD} please"), {FORWARD: LIKELY})
    assert both_think(engine, first, second).unclear == ()


def test_what_neither_thought_of_is_asked_of_both(engine):
    """ "Put down the mug" is far ahead of all others, until somebody thinks of the book."""
    mug, book, bowl = "put down the mug", "put down the book", "put down the bowl"
    alone = Thinks(heard(mug, 0.5), {mug: -4.0, book: -3.0, bowl: LIKELY})
    first = Knows(alone.transcript, alone.scores, thought_of=frozenset({mug}))
    second = replace(first)
    assert both_think(engine, first, second).confidence > SURE_TOGETHER
    second.others = {mug: (book,)}
    found = both_think(engine, first, second)
    assert (found.text, found.alternatives) == (mug, (book,))
    assert found.confidence < SURE_TOGETHER
    first.others, second.others = {bowl: (book, mug)}, {mug: (bowl,)}
    found = both_think(engine, first, second)
    assert (found.text, set(found.alternatives)) == (bowl, {mug, book}), (
        "the second time beside the one that is likelier"
    )


def test_the_same_words_are_not_heard_twice(engine):
    both, one, other = two(engine, UNSURE, UNSURE)
    both.transcribe(SOUND, final=False)
    longer = np.concatenate((SOUND, np.zeros(SAMPLE_RATE // 3, np.float32)))
    longer[SOUND.size - 800 : SOUND.size] *= 0.9  # a noise filter had not ended there
    both.transcribe(longer)
    assert (one.listened, other.listened) == ([SOUND.size], [SOUND.size])
    assert one.searched == 1


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
    both, one, other = two(engine, UNSURE, UNSURE)
    both.transcribe(SOUND, final=False)
    both.transcribe(sound)
    assert one.listened == other.listened == [SOUND.size, sound.size]


def test_a_draft_is_used_once(engine):
    both, one, _ = two(engine, UNSURE, UNSURE)
    both.transcribe(SOUND, final=False)
    both.transcribe(SOUND)
    both.transcribe(SOUND)
    assert len(one.listened) == 2


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
    first = Thinks(heard("goat bad", 0.5), {FORWARD: -1.0, "go back": -2.0, LEFT: -15.0})
    second = Thinks(heard("go pack", 0.5), {LEFT: -1.0, "go back": -2.0, FORWARD: -15.0})
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


@pytest.mark.parametrize(("confidence", "waits"), [(SURE_ENOUGH_TO_STOP, False), (SURE_ENOUGH_TO_STOP - 0.01, True)])
def test_a_stop_that_is_one_already_waits_for_no_second_opinion(engine, confidence, waits):
    both, *_ = two(engine, heard("stop", confidence, score=-0.9), heard("don't stop", None))
    assert both.transcribe(SOUND).text == ("don't stop" if waits else "stop")


def test_a_stop_waits_for_a_second_opinion_where_another_word_is_much_likelier(engine):
    wow = heard("whoa", SURE_ENOUGH_TO_STOP, score=-0.9, gap=ANOTHER_WORD + 0.1)
    both, _, other = two(engine, wow, heard("wow", None))
    both.transcribe(SOUND)
    assert other.listened


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


def test_a_doubtful_command_is_searched_for_when_it_is_over_and_done(engine, listen, go_forward):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(heard(FORWARD, 0.5), {FORWARD: LIKELY})
    found = listen(go_forward, both)
    assert (len(one.listened), len(other.listened), one.searched, other.searched) == (1, 1, 1, 1)
    assert found.robot.pose().x == pytest.approx(2.0)
    (transcript,) = (event.transcript for event in found.of(HeardKind.TRANSCRIPT))
    assert transcript.confidence > 0.7
    drafts = [event.transcript.draft for event in found.of(HeardKind.PARTIAL)]
    assert drafts == [True], "what it became is no partial: the command was over"


def test_a_command_that_was_heard_well_is_done_at_once(engine, listen, go_forward):
    both, _, other = two(engine, heard(FORWARD, 1.0), heard(LEFT, 1.0))
    found = listen(go_forward, both)
    assert other.listened == []
    assert found.robot.pose().x == pytest.approx(2.0)


def test_a_draft_is_not_done_however_sure_it_is(engine, listen, go_forward):
    mumbled = Thinks(replace(heard(FORWARD, 0.9), free_text="goat for words two me does"), {FORWARD: LIKELY})
    both, one, other = two(engine, mumbled, mumbled)
    one.found = other.found = Thinks(heard("don't go forward", None))
    found = listen(go_forward, both)
    assert found.goals == []


def test_two_that_differ_move_nothing(engine, listen, go_forward):
    both, *_ = two(engine, heard(FORWARD, 0.6), heard(LEFT, 0.6))
    found = listen(go_forward, both)
    assert found.goals == []
    (meaning,) = (event.interpretation for event in found.of(HeardKind.INTERPRETATION))
    assert meaning.actions == ()


class Stubborn:
    """A recogniser whose final word is a draft."""

    def __init__(self) -> None:
        self.asked: list[int] = []

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.asked.append(samples.size)
        return heard("nice weather", None, draft=True)

    def close(self) -> None:
        pass


def test_a_second_look_is_taken_in_the_silence_and_not_in_a_short_pause(listen, go_forward):
    """So that its answer is there when the wait is over. One whose final word is a draft is not asked for ever."""
    stubborn = Stubborn()
    found = listen(go_forward, stubborn)
    first, second = stubborn.asked
    assert 0 < second - first < (SECOND_LOOK + 0.1) * SAMPLE_RATE
    assert found.goals == []
