"""What the grammar makes of what was nearly heard, and what it leaves undone because it was not heard clearly."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from speech_stage import framed

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.approximate import FreeWord
from intent_engine.runtime import HeardKind
from intent_engine.speech import steering
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript

NOT = "Do not ", "Don't ", "Never "


def unclear_words(whisper, *asked) -> tuple[str, ...]:
    return tuple(word for word, clear in whisper.clearness(*asked).items() if clear < 0)


@pytest.fixture
def hears(whisper, monkeypatch):
    """The real model, but its free words are given: what it thinks of the grammar's sentences is its own."""

    def hear(words: str, score: float = -0.3):
        monkeypatch.setattr(whisper, "greedy", lambda *_args, **_options: (words, score, False))
        return whisper

    return hear


@pytest.fixture
def spoken(go_forward) -> np.ndarray:
    return go_forward[int(1.2 * SAMPLE_RATE) : int(3.6 * SAMPLE_RATE)]


def test_what_was_made_ready_is_not_made_at_the_first_words(engine, whisper, spoken, monkeypatch):
    whisper.steer(engine)
    whisper.prepare()
    monkeypatch.delattr(steering, "GuidedSearch")
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
    ("words", "unclear"),
    [
        (("grab", "the", FreeWord("florble")), ("florble",)),
        (("go", "forward", "two", FreeWord("meters")), ()),
        (("go", FreeWord("forward"), "two", FreeWord("screwdrivers")), ("screwdrivers",)),
    ],
)
def test_a_word_that_nobody_knows_must_be_heard_clearly(whisper, spoken, words, unclear):
    found = whisper.clearness(whisper.encode(spoken), words, "en")
    assert tuple(word for word in found if isinstance(word, FreeWord) and found[word] < 0) == unclear


def test_a_number_that_sounds_like_another(whisper, spoken, monkeypatch):
    encoded = whisper.encode(spoken)
    words = ["turn", "left", "fifteen", "degrees"]

    def heard(number: str, digits: str, margin: float) -> None:
        def score(text: str) -> float:
            if text.startswith(NOT):
                return -20.0
            return -1.0 if number in text.lower() or digits in text else -1.0 - margin

        monkeypatch.setattr(whisper, "score", lambda _encoded, texts, _language=None: [score(text) for text in texts])

    for margin, unclear in ((0.1, ("fifteen",)), (3.9, ("fifteen",)), (4.0, ())):
        heard("fifteen", "15", margin)
        assert unclear_words(whisper, encoded, words, "en") == unclear
    for margin, unclear in ((1.9, ("fifty",)), (2.0, ())):
        heard("fifty", "50", margin)
        assert unclear_words(whisper, encoded, ["turn", "left", "fifty", "degrees"], "en") == unclear
    assert unclear_words(whisper, encoded, ["go", "to", "the", "kitchen"], "en") == ()
    heard("fifteen", "15", 0.0)
    assert unclear_words(whisper, encoded, words, "en") == ("fifteen",)
    assert unclear_words(whisper, encoded, ["serve", "sixteen", "ounces"], "en") == (), (
        "the grammar has no sixty of them"
    )


@pytest.fixture
def parts(whisper, monkeypatch):
    """What the model made of each place of a text while it heard it: another piece is so many nats less likely."""

    def part(text: str, others: Mapping[str, float]) -> None:
        encode = whisper.tokenizer("en").encode
        heard = tuple(encode(" " + text))
        row = np.full(whisper.tokenizer("en").eot + 1, -30.0, np.float32)
        row[list(heard)] = -1.0
        for other, ahead in others.items():
            row[encode(" " + other)[0]] = -1.0 - ahead
        rows = {heard[:length]: row for length in range(len(heard) + 1)}
        monkeypatch.setattr(whisper, "decoded", lambda _encoded: rows)

    return part


@pytest.mark.parametrize(("ahead", "asked"), [(4.4, True), (4.5, False)])
def test_a_number_that_is_far_ahead_is_not_compared(whisper, parts, monkeypatch, ahead, asked):
    """What the model thought of the two while it heard one of them is as good as what it thinks of whole sentences."""
    parts("Turn left 15 degrees.", {"50": ahead})
    compared = []

    def score(_encoded, sentences, _language=None):
        compared.extend(sentences)
        return [-2.0, -2.5]

    monkeypatch.setattr(whisper, "score_words", score)
    found = whisper._known_clearly(None, ["turn", "left", "fifteen", "degrees"], "en", heard=True)
    assert bool(compared) is asked
    assert found["fifteen"] == pytest.approx((0.5 if asked else 4.5) - 4.0)


@pytest.mark.parametrize(
    ("free", "score", "refused"),
    [
        ("Don't go forward.", -0.1, True),
        ("Don't go forward.", -0.9, False),
        ("Never go to the kitchen.", -0.1, True),
        ("Go without me.", -0.1, True),
        ("Go forward, no, forget it.", -0.9, True),
        ("Go forward two meters.", -0.1, False),
    ],
    ids=["clear", "unclear", "never", "without", "cancelled", "a command"],
)
def test_a_refusal_is_one_where_it_was_heard_clearly(engine, whisper, monkeypatch, free, score, refused):
    """In noise "go to" is heard as "don't do"."""
    monkeypatch.setattr(whisper, "word_scores", lambda _sound, text, _language: [(w, score) for w in text.split()])
    assert whisper._refused(None, free, engine.parse(free), "en") is refused


def test_a_refusal_in_another_language_is_always_one(whisper):
    meaning = Interpretation("fahr nicht", Status.REJECTED, reason="negated: nicht")
    assert whisper._refused(None, "Fahr nicht.", meaning, "de")


@pytest.mark.parametrize(
    ("text", "ahead", "unclear"),
    [
        ("go forward two meters", 5.4, ("go",)),
        ("go forward two meters", 5.5, ()),
        ("then well go to the bedroom", -6.0, ("then well",)),
        ("stop", -6.0, ()),
        ("the orchestra played", -6.0, ()),
    ],
)
def test_a_command_must_be_far_likelier_than_that_it_shall_not_be_done(whisper, monkeypatch, text, ahead, unclear):
    """In noise "never go" is heard as "then we'll go", word by word."""

    def score(_encoded, texts, _language=None):
        return [-9.0 - ahead if text.startswith(NOT) else -9.0 for text in texts]

    monkeypatch.setattr(whisper, "score", score)
    assert unclear_words(whisper, None, text.split(), "en") == unclear


@pytest.mark.parametrize(
    ("text", "heard", "others", "asked"),
    [
        ("Go forward two meters.", True, {"Don't": 6.5, "Never": 6.5}, False),
        ("Go forward two meters.", True, {"Don't": 6.5, "Never": 6.4}, True),
        ("Go forward two meters.", False, {}, True),
        ("Please go forward two meters.", True, {}, False),
        ("Please go forward two meters.", True, {"don't": 6.4}, True),
        ("Please go forward two meters.", True, {"Do": 6.4}, True),
    ],
    ids=lambda value: str(value),
)
def test_a_command_that_is_far_ahead_of_a_dont_is_not_compared(whisper, parts, monkeypatch, text, heard, others, asked):
    """At the place where a "don't" would be, whatever says nothing before it."""
    parts(text, others)
    compared = []
    monkeypatch.setattr(whisper, "score", lambda _sound, texts, _language: compared.append(1) or [0.0] * len(texts))
    ahead = whisper._ahead(None, text.lower().strip(".").split(), "en", heard=heard)
    assert bool(compared) is asked
    assert asked or ahead >= 6.5


@pytest.mark.parametrize(("score", "looked"), [(-0.1, False), (-0.9, True)], ids=["clear", "mumbled"])
def test_nothing_more_is_looked_for_in_clear_talk(hears, spoken, monkeypatch, score, looked):
    whisper = hears("The orchestra played a waltz by an unknown composer", score)
    asked = []
    monkeypatch.setattr(type(whisper._guide("en").guided), "likeliest", lambda *_: asked.append(1) or [], raising=True)
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
