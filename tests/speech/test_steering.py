"""What the grammar makes of what was nearly heard, and what it leaves undone because it was not heard clearly."""

from __future__ import annotations

import numpy as np
import pytest
from speech_stage import framed

from intent_engine.interpretation import Status
from intent_engine.runtime import HeardKind
from intent_engine.speech.acoustic.whisper import RETRY_SECONDS
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.hypotheses import guide
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.steering import CLEAR_TALK


@pytest.fixture
def hears(whisper, monkeypatch):
    """The real model, but its free words are given: what it thinks of the grammar's sentences is its own."""

    def hear(words: str, score: float = -0.3):
        monkeypatch.setattr(whisper, "greedy", lambda *_args, **_options: (words, score, False))
        return whisper

    return hear


def test_what_was_made_ready_is_not_made_at_the_first_words(engine, whisper, spoken, monkeypatch):
    whisper.steer(engine)
    whisper.prepare()
    monkeypatch.delattr(guide, "GuidedSearch")
    assert whisper.transcribe(spoken).text == "go forward 2 meters"
    whisper.steer(engine)
    with pytest.raises(NameError):
        whisper.transcribe(spoken)


@pytest.mark.parametrize("misheard", ["Go for word two meters.", "Goat forward 2 meters", "Oh forward to me does"])
def test_what_was_nearly_heard_becomes_the_sentence(engine, hears, spoken, misheard):
    found = hears(misheard).transcribe(spoken)
    assert engine.parse(found.text).actions == engine.parse("go forward two meters").actions
    assert found.gap == 0
    assert found.unclear == ()
    assert found.free_text == misheard


@pytest.mark.parametrize(
    ("words", "settled"),
    [
        ("Go forward two meters.", True),
        ("Right.", False),
        ("Stop.", True),
        ("Stop like now.", True),
        ("Go like two meters.", False),
        ("Turn right 514 degrees.", False),
        ("Go forward two meters and " * 8 + "stop.", False),
    ],
)
def test_an_exact_sentence_is_looked_at_again_where_nobody_says_it_so(hears, spoken, words, settled):
    """It is too short or too long for its sound, has a word inside that says nothing, or turns in circles."""
    assert hears(words).listen(spoken).settled is settled


@pytest.mark.parametrize(
    ("words", "score", "settled"),
    [
        ("Go forward two meters.", -0.79, True),
        ("Go forward two meters.", -0.81, False),
        ("Turn left.", -0.59, True),
        ("Turn left.", -0.61, False),
        ("Please stop now.", -0.61, False),
    ],
)
def test_an_exact_sentence_is_looked_at_again_where_it_was_hardly_heard(hears, spoken, words, score, settled):
    """The sooner the fewer words it has; and what would be a stop, which nothing else would be asked about."""
    sound = spoken[:SAMPLE_RATE] if len(words) < 12 else spoken
    assert hears(words, score).listen(sound).settled is settled


def test_what_was_heard_word_by_word_is_as_likely_as_it_was_written(hears, spoken, monkeypatch):
    """ "Touchdown!" is "touch down" to a grammar, and nobody would write it so."""
    heard = hears("Go forward, two METERS!", -0.9).listen(spoken)
    monkeypatch.setattr(type(heard.model), "score", lambda *_: [-1.0])
    said, other = ("go", "forward", "two", "meters"), ("go", "forward", "ten", "meters")
    views = heard.viewed({said: -7.0, other: -5.0})
    assert [view.score for view in views.values()] == [-1.0, -5.0]


@pytest.mark.parametrize(("score", "looked"), [(-0.1, False), (-0.9, True)], ids=["clear", "mumbled"])
def test_nothing_more_is_looked_for_in_clear_talk(hears, spoken, monkeypatch, score, looked):
    whisper = hears("The orchestra played a waltz by an unknown composer", score)
    asked = []
    monkeypatch.setattr(type(whisper.guide("en").guided), "likeliest", lambda *_: asked.append(1) or [], raising=True)
    whisper.transcribe(spoken)
    assert bool(asked) is looked


@pytest.mark.parametrize("again", ["Don't go forward two meters.", ""])
def test_a_refusal_or_nothing_at_the_second_try_stands(whisper, spoken, monkeypatch, again):
    heard = iter([("Goat fall were to meet us", -1.5, False), (again, -0.1, False)])
    monkeypatch.setattr(whisper, "greedy", lambda *_: next(heard))
    monkeypatch.setattr(whisper, "word_scores", lambda _sound, text, _language: [(w, -0.1) for w in text.split()])
    found = whisper.transcribe(spoken)
    assert (found.text, found.confidence) == (again, None)
    assert whisper.opinion.sentences == ()


STUCK = "Go forward two meter meter meter meter meter"


def test_where_the_model_could_not_go_on_it_is_given_more_silence(whisper, spoken, monkeypatch):
    inputs, texts = [], iter([(STUCK, -0.1, False), ("Go forward two meters.", -0.1, False)])
    encode = whisper.encode
    monkeypatch.setattr(whisper, "encode", lambda sound, *seconds: inputs.append(seconds) or encode(sound, *seconds))
    monkeypatch.setattr(whisper, "greedy", lambda *_: next(texts))
    opinion = whisper.listen(spoken)
    assert opinion.transcript.text == "Go forward two meters."
    assert inputs[0] == ()
    assert inputs[1][0] >= RETRY_SECONDS


def test_what_goes_round_is_no_clear_talk_however_likely_it_is(whisper, spoken, monkeypatch):
    monkeypatch.setattr(whisper, "greedy", lambda *_: (STUCK, -0.1, False))
    opinion = whisper.listen(spoken)
    assert not opinion.settled
    assert opinion.transcript.score < CLEAR_TALK


def test_a_stop_is_done_at_once_however_often_it_was_said(hears, spoken):
    assert hears("Stop stop stop stop!", -0.1).listen(spoken).transcript.score == -0.1


@pytest.mark.parametrize("free", ["Go forward", "Go forward two", "Turn left by"])
def test_nobody_said_the_words_that_would_make_a_command_of_its_beginning(hears, spoken, free):
    whisper = hears(free, -0.9)
    found = [" ".join(one.words) for one in whisper.readings(whisper.listen(spoken))]
    assert not [text for text in found if text.startswith(free.lower() + " ")], found


@pytest.mark.parametrize(("free", "found"), [("Tree.", True), ("Tree, tree.", True), ("Tree, tree, tree.", False)])
def test_of_a_word_or_two_the_single_words_that_the_sound_may_be_are_looked_at(hears, spoken, free, found):
    whisper = hears(free, -1.5)
    heard = whisper.compare(whisper.listen(spoken[: int(0.5 * SAMPLE_RATE)]))
    assert (heard.sentences[:1] == (("go",),)) is found, heard.sentences
    assert (("left",) in heard.sentences) is found, heard.sentences


def test_a_dont_is_looked_for_in_other_words_of_the_same_command(engine, hears, spoken, monkeypatch):
    whisper = hears("Goat forward 2 meters")
    compared = []

    def clearness(_encoded, words, _language, *, heard, others):
        compared.append([words, *others])
        return {}

    monkeypatch.setattr(whisper, "clearness", clearness)
    whisper.transcribe(spoken)
    ((said, *others),) = compared
    assert others
    meanings = {engine.parse(" ".join(one)).actions for one in (said, *others)}
    assert meanings == {engine.parse("go forward two meters").actions}


def test_what_means_the_same_may_have_begun_otherwise_but_for_a_please(engine, whisper, spoken):
    heard = whisper.listen(spoken)
    meant = engine.parse("forward two meters").actions
    found = heard.begun(("forward", "two", "meters"))
    assert ("go", "forward", "two", "meters") in found
    for words in found:
        assert words[0] != "forward"
        assert engine.parse(" ".join(words)).actions == meant
        assert not whisper.grammar.lead(words, "en")


@pytest.mark.parametrize(("clearly", "left_out"), [(-0.1, ("do you",)), (-2.0, ())])
def test_what_one_model_heard_clearly_before_a_command_is_not_left_out(hears, spoken, monkeypatch, clearly, left_out):
    """In noise one alone hears anything before it."""
    whisper = hears("Do you go forward two meters")
    monkeypatch.setattr(whisper, "word_scores", lambda _sound, text, _language: [(w, clearly) for w in text.split()])
    found = whisper.transcribe(spoken)
    assert (found.text, found.left_out) == ("go forward two meters", left_out)


class Says:
    """A recogniser that heard this."""

    def __init__(self, transcript: Transcript) -> None:
        self.transcript = transcript

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        return self.transcript

    def close(self) -> None: ...


@pytest.mark.parametrize(
    ("text", "unclear", "done"),
    [
        ("turn left fifteen degrees", (), True),
        ("turn left fifteen degrees", ("fifteen",), False),
        ("pick up the florble", ("florble",), False),
        ("stop fifteen", ("fifteen",), False),
    ],
)
def test_what_was_not_heard_clearly_is_asked_back_and_not_done(listen, go_forward, text, unclear, done):
    found = listen(framed(go_forward), Says(Transcript(text, -0.2, text, 0.0, unclear=unclear)))
    assert bool(found.goals) is done
    (told,) = found.of(HeardKind.INTERPRETATION)
    assert (told.interpretation.status is Status.ACCEPTED) is done
    if unclear and "stop" not in text:
        assert repr(unclear[0]) in told.interpretation.reason


def test_a_stop_is_taken_however_unclear(listen, go_forward):
    found = listen(framed(go_forward), Says(Transcript("stop", -2.0, "stop", 0.0, unclear=("stop",))))
    assert found.summary.accepted == 1
