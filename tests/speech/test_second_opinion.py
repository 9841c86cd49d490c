"""Two models: when the second is asked."""

from __future__ import annotations

import threading
from dataclasses import replace

import numpy as np
import pytest
from two_models import FORWARD, LEFT, LIKELY, SOUND, UNSURE, Says, Thinks, heard, two

from intent_engine.errors import WeightsError
from intent_engine.speech import second_opinion
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.leaving import LeftError
from intent_engine.speech.second_opinion import SURE_TOGETHER, SecondOpinion


def test_both_are_ready_before_the_first_words(engine):
    """So that these need not wait for what can be known before them."""
    _, one, other = two(engine, UNSURE, UNSURE)
    assert one.prepared.wait(60)
    assert other.prepared.wait(60)


@pytest.fixture(autouse=True)
def two_cores(monkeypatch):
    """Wherever these tests run."""
    monkeypatch.setattr(second_opinion, "cores", lambda: 2)


# -- when it is asked --------------------------------------------------------------------------------------------

ALL_HEARD = Thinks(heard(FORWARD, 1.0))
FURTHER = np.concatenate((SOUND, SOUND))
TALK = "go what lovely weather we have"


def asked_during(monkeypatch, one, step: str, other, known: bool) -> threading.Event:
    """That the second is asked; it must be while the first takes a step, or must not be until then."""
    asked = threading.Event()
    monkeypatch.setattr(other, "listen", lambda _samples, **_told: asked.set() or UNSURE)

    def taken(_given):
        assert asked.wait(60 if known else 0) is known
        return one.opinion

    monkeypatch.setattr(one, step, taken)
    return asked


def leaves_only_if_asked_to(monkeypatch, other) -> threading.Event:
    """That the second, which listens for ever, was told to leave that."""
    told = threading.Event()

    def listen(_samples, **_told):
        assert other.left is not None
        if other.left.wait(60):
            told.set()
        raise LeftError

    monkeypatch.setattr(other, "listen", listen)
    return told


@pytest.mark.parametrize("first", [UNSURE, ALL_HEARD], ids=["unsure", "sure"])
def test_both_listen_at_once(engine, monkeypatch, first):
    """What the first will hear is not known yet."""
    both, one, other = two(engine, first, UNSURE)
    asked = asked_during(monkeypatch, one, "listen", other, known=True)
    both.transcribe(SOUND, final=False)
    assert asked.is_set()


def test_on_one_core_the_first_listens_alone(engine, monkeypatch):
    """Beside another it would take twice as long."""
    monkeypatch.setattr(second_opinion, "cores", lambda: 1)
    both, one, other = two(engine, UNSURE, UNSURE)
    asked = asked_during(monkeypatch, one, "listen", other, known=False)
    both.transcribe(SOUND, final=False)
    assert asked.is_set()


def test_who_heard_every_word_of_a_sentence_waits_for_nobody(engine, monkeypatch):
    both, one, other = two(engine, ALL_HEARD, heard(LEFT, 1.0))
    told = leaves_only_if_asked_to(monkeypatch, other)
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == FORWARD
    assert one.compared == 0
    assert told.wait(60)


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
def test_silence_what_shall_not_be_done_and_clear_talk_need_no_second_opinion(engine, monkeypatch, first):
    both, _, other = two(engine, first, heard(LEFT, 1.0))
    told = leaves_only_if_asked_to(monkeypatch, other)
    assert not both.transcribe(SOUND, final=False).draft
    assert both.transcribe(SOUND).text == first.text
    assert told.wait(60)


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
def test_who_is_unsure_waits_for_the_second(engine, first):
    both, _, other = two(engine, first, heard(FORWARD, 1.0))
    assert both.transcribe(SOUND, final=False).text == FORWARD
    assert other.listened == [SOUND.size]


@pytest.mark.parametrize(
    ("words", "score", "again"),
    [
        ("forward go two meters", -0.2, False),
        ("forward go two lovely meters", -0.2, False),
        (TALK, -0.2, True),
        (TALK, -0.9, False),
    ],
    ids=["words of the grammar", "mostly", "other words, clearly", "hardly"],
)
def test_what_is_probably_other_talk_is_left_and_asked_about_anew_if_it_may_be_a_command(engine, words, score, again):
    both, _, other = two(engine, Thinks(heard(words, 0.5, score=score), {FORWARD: -14.0}), UNSURE)
    both.transcribe(SOUND, final=False)
    assert len(other.listened) == 1 + again


@pytest.mark.parametrize(
    ("first", "at_once"),
    [(UNSURE, True), (Thinks(heard(TALK, 0.5, score=-0.2), {FORWARD: -14.0}), False)],
    ids=["in doubt", "other words, clearly"],
)
def test_of_clear_talk_at_a_glance_the_first_listens_alone(engine, monkeypatch, first, at_once):
    """Until that finds a command in it. The next sound is another."""
    both, one, other = two(engine, first, UNSURE)
    assert both.glance(SOUND).draft
    assert other.listened == [], "a glance is the first's alone"
    with monkeypatch.context() as patched:
        asked_during(patched, one, "listen", other, known=at_once)
        both.transcribe(FURTHER, final=False)
    asked_during(monkeypatch, one, "listen", other, known=True)
    both.transcribe(SOUND, final=False)


def test_the_second_is_told_what_the_first_hears(engine, monkeypatch):
    """At a glance, then as it listens; and nothing of that when something else is said."""
    both, one, other = two(engine, UNSURE, UNSURE)
    words: list[str] = []
    asked, compared = threading.Event(), threading.Event()

    def listens(_samples, *, told):
        words.append(told())
        asked.set()
        assert compared.wait(60)
        words.append(told())
        return UNSURE

    def hears(_samples):
        assert asked.wait(60)
        return Thinks(heard("go forwards", 0.5))

    def compares(_heard):
        compared.set()
        return one.opinion

    monkeypatch.setattr(other, "listen", listens)
    monkeypatch.setattr(one, "listen", hears)
    monkeypatch.setattr(one, "compare", compares)
    both.glance(SOUND)
    both.transcribe(SOUND)
    assert words[:2] == [FORWARD, "go forwards"]
    asked.clear(), compared.clear(), words.clear()
    both.transcribe(FURTHER)
    assert words[:2] == ["", "go forwards"], "another sound"


def test_who_leaves_leaves_both(engine, monkeypatch):
    both, one, other = two(engine, UNSURE, UNSURE)
    told = leaves_only_if_asked_to(monkeypatch, other)

    def speaks_on(_heard):
        both.leave()
        return one.opinion

    monkeypatch.setattr(one, "compare", speaks_on)
    with pytest.raises(LeftError):
        both.transcribe(SOUND, final=False)
    assert told.is_set()
    assert one.left.is_set()


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


def test_both_dig_for_what_would_be_asked_back(engine):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(replace(heard(LEFT, 0.3), free_text="goat bad"), {LEFT: -12.0})
    one.buried = other.buried = Thinks(replace(heard("go back", 0.5), free_text="goat bad"), {"go back": LIKELY})
    found = both.transcribe(SOUND)
    assert (found.text, one.dug, other.dug) == ("go back", 1, 1)


def test_where_a_search_takes_long_already_nobody_digs(engine, monkeypatch):
    monkeypatch.setattr(second_opinion, "SOON", -1.0)
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(replace(heard(LEFT, 0.3), free_text="goat bad"), {LEFT: -12.0})
    one.buried = other.buried = Thinks(replace(heard("go back", 0.5), free_text="goat bad"), {"go back": LIKELY})
    assert both.transcribe(SOUND).sureness < SURE_TOGETHER
    assert (one.dug, other.dug) == (0, 0)


@pytest.mark.parametrize("found", [heard("go back", 0.5), heard("don't go back", None)], ids=["sure", "refused"])
def test_where_a_search_says_enough_nobody_digs(engine, found):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(found, {"go back": LIKELY})
    one.buried = other.buried = Thinks(heard(LEFT, 0.5), {LEFT: LIKELY})
    assert both.transcribe(SOUND).text == found.text
    assert (one.dug, other.dug) == (0, 0)


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


def test_the_same_words_are_not_heard_twice(engine):
    both, one, other = two(engine, UNSURE, UNSURE)
    one.found = other.found = Thinks(heard("go back", 0.5), {"go back": LIKELY})
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


@pytest.mark.parametrize("lost", [(1, 0), (0, 1), (1, 1)])
def test_a_model_whose_cuda_device_is_lost_goes_on_with_the_processor(engine, lost):
    both, one, other = two(engine, UNSURE, UNSURE)
    whole = both.transcribe(SOUND)
    one.lost, other.lost = lost
    assert replace(both.transcribe(SOUND), decode_seconds=0.0) == replace(whole, decode_seconds=0.0)
    both.close()


def test_both_are_closed(engine):
    both, one, other = two(engine, heard(FORWARD, 0.5), heard(FORWARD, 1.0))
    both.close()
    assert one.closed
    assert other.closed
    with pytest.raises(RuntimeError, match="it is closed"):
        both.transcribe(SOUND)
    both.close()
