"""How clearly words were heard on which the meaning of a command hangs."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np
import pytest

from intent_engine.interpretation import Cause, Interpretation, Status
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.language.numbers.spelled import in_digits
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Transcript

NOT = "Do not ", "Don't ", "Never "
NOT_SAID = re.compile(r"\b(do not|don't|never)\b", re.IGNORECASE)


def unclear_words(whisper, *asked) -> tuple[str, ...]:
    return tuple(word for word, clear in whisper.clearness(*asked).items() if clear < 0)


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


def test_a_name_must_be_clear_as_it_is_written(whisper, spoken, monkeypatch):
    """ "Call anna" is what nobody would write, however clearly it was said."""

    def word_scores(_encoded, text, _language=None):
        return [(word, -0.1 if word in ("call", "Anna") else -5.0) for word in text.split()]

    monkeypatch.setattr(whisper, "word_scores", word_scores)
    monkeypatch.setattr(whisper, "_ahead", lambda *_, **_more: 99.0)
    assert unclear_words(whisper, whisper.encode(spoken), ("call", FreeWord("anna")), "en") == ()
    assert unclear_words(whisper, whisper.encode(spoken), ("call", FreeWord("flurb")), "en") == ("flurb",)


def test_numbers_in_free_words_are_as_clear_as_their_figures(whisper, spoken, monkeypatch):
    """ "Tell Anna about ten minutes" is written "about 10 minutes", however clearly "ten" was said."""

    def word_scores(_encoded, text, _language=None):
        likely = {"call": -0.1, "red": -0.1, "99": -0.2, "balloons": -0.1, "ninety": -2.0, "nine": -1.0, "seven": -0.1}
        return [(word, likely.get(word, -5.0)) for word in text.split()]

    monkeypatch.setattr(whisper, "word_scores", word_scores)
    monkeypatch.setattr(whisper, "_ahead", lambda *_, **_more: 99.0)
    encoded = whisper.encode(spoken)
    many = ("call", *map(FreeWord, ("ninety", "nine", "red", "balloons")))
    assert unclear_words(whisper, encoded, many, "en") == ()
    assert unclear_words(whisper, encoded, ("call", FreeWord("seven"), FreeWord("balloons")), "en") == ()
    assert unclear_words(whisper, encoded, ("call", FreeWord("ninety"), FreeWord("balloons")), "en") == ("ninety",)
    assert unclear_words(whisper, encoded, many, "de") == ("ninety", "nine"), "English figures are none of German"


def test_the_words_that_were_heard_clearly(whisper, spoken):
    encoded = whisper.encode(spoken)
    heard, *_ = whisper.greedy(encoded, "en")
    words = whisper.grammar.words(heard, "en")
    assert words == ["go", "forward", "two", "meters"]
    assert {"forward", "meters"} <= whisper.heard_clearly(encoded, heard, "en") <= set(words)
    assert "elephants" not in whisper.heard_clearly(encoded, f"{heard} elephants", "en")


@pytest.mark.parametrize(
    ("words", "score", "left_out"),
    [
        ("go two meters", -3.0, ("okmetz",)),  # it could have gone on: "backwards"
        ("go forward two meters", -3.0, ()),
        ("go forward two meters", -0.1, ("okmetz",)),
    ],
)
def test_what_was_heard_after_a_sentence_that_could_go_on_may_be_how(
    whisper, spoken, monkeypatch, words, score, left_out
):
    free = f"{words} okmetz"
    monkeypatch.setattr(whisper, "word_scores", lambda *_: [(word, score) for word in free.split()])
    heard = Transcript(free, -1.0, free, language="en")
    assert whisper.left_out(whisper.encode(spoken), words.split(), free.split(), heard) == left_out


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
    # Angles are multiples of five degrees, mostly.
    for margin, unclear in ((5.9, ("sixteen",)), (6.0, ())):
        heard("sixteen", "16", margin)
        assert unclear_words(whisper, encoded, ["turn", "left", "sixteen", "degrees"], "en") == unclear
    for margin, unclear in ((-0.1, ("sixty",)), (0.0, ())):
        heard("sixty", "60", margin)
        assert unclear_words(whisper, encoded, ["turn", "left", "sixty", "degrees"], "en") == unclear
    assert unclear_words(whisper, encoded, ["go", "to", "the", "kitchen"], "en") == ()
    heard("fifteen", "15", 0.0)
    assert unclear_words(whisper, encoded, words, "en") == ("fifteen",)
    assert unclear_words(whisper, encoded, ["serve", "sixteen", "ounces"], "en") == (), (
        "the grammar has no sixty of them"
    )


BAYS = """
language: en
slots: {bay: [A5, B5, C5, 12B, 12C]}
intents: {scan: {action: custom, sentences: ["scan [bay] {bay}"]}}
"""


@pytest.mark.parametrize(
    ("words", "other", "margin", "unclear"),
    [
        ("scan bay b five", "c", 2.9, ("b",)),
        ("scan bay b five", "c", 3.0, ()),
        ("scan bay twelve b", "c", 2.9, ("b",)),
        ("scan bay b five", "d", 0.0, ()),  # there is none
        ("scan bay twelve b", "a", 0.0, ()),
    ],
)
def test_a_letter_of_a_code_may_be_another(whisper, spoken, engine_of, monkeypatch, words, other, margin, unclear):
    def has(text: str, letter: str) -> bool:
        return re.search(rf"\b(\d+|)(?i:{letter})(\d+|)\b", text) is not None

    def score(text: str) -> float:
        if text.startswith(NOT):
            return -20.0
        return -1.0 if has(text, "b") else -1.0 - margin if has(text, other) else -20.0

    monkeypatch.setattr(whisper, "grammar", SpokenGrammar(engine_of(BAYS)))
    monkeypatch.setattr(whisper, "score", lambda _encoded, texts, _language=None: [score(text) for text in texts])
    assert unclear_words(whisper, whisper.encode(spoken), tuple(words.split()), "en") == unclear


@pytest.mark.parametrize(
    ("words", "other", "margin", "unclear"),
    [
        ("turn right for two degrees", "forty two", 1.4, ("for",)),
        ("turn right for two degrees", "forty two", 1.5, ()),
        ("turn right forty two degrees", "for two", 1.4, ("forty",)),
        ("turn right forty two degrees", "for two", 1.5, ()),
        ("go to the room for ten minutes", "forty ten", 0.0, ()),
        ("turn right forty degrees", "for degrees", 0.0, ()),
    ],
)
def test_for_and_forty_before_a_digit(whisper, spoken, monkeypatch, words, other, margin, unclear):
    said = tuple(words.split())
    digits = " ".join(in_digits(other.split()))

    def score(text: str) -> float:
        if text.startswith(NOT):
            return -20.0
        return -1.0 - margin if other in text.lower() or digits in text.lower() else -1.0

    monkeypatch.setattr(whisper, "score", lambda _encoded, texts, _language=None: [score(text) for text in texts])
    assert unclear_words(whisper, whisper.encode(spoken), said, "en") == unclear


@pytest.mark.parametrize(
    ("free", "likely", "told"),
    [
        ("We go to the kitchen.", 0.4, ["we"]),
        ("And then I'll go to the kitchen.", 0.4, ["ill"]),
        ("We go to the kitchen.", 0.2, []),
        ("He goes to the kitchen.", 0.4, []),
        ("He goes to the kitchen.", 0.7, ["he"]),
        ("Can you go to the kitchen?", 0.9, []),
        ("Go to the kitchen.", 0.9, []),
    ],
)
def test_words_that_tell_a_story_were_heard_clearly(whisper, spoken, monkeypatch, free, likely, told):
    """Words that begin a statement count from less: where a sentence begins, much else could have come."""
    monkeypatch.setattr(
        whisper, "word_scores", lambda _encoded, text, _language: [(word, np.log(likely)) for word in text.split()]
    )
    assert whisper.story(whisper.encode(spoken), free, "en") == told


@pytest.fixture
def parts(whisper, monkeypatch):
    """What the model makes of each place of a text, while it hears it or asked anew: another piece is so many nats less
    likely."""

    def part(text: str, others: Mapping[str, float]) -> None:
        encode = whisper.tokenizer("en").encode
        heard = tuple(encode(" " + text))
        row = np.full(whisper.tokenizer("en").eot + 1, -30.0, np.float32)
        row[list(heard)] = -1.0
        for other, ahead in others.items():
            row[encode(" " + other)[0]] = -1.0 - ahead
        rows = {heard[:length]: row for length in range(len(heard) + 1)}
        monkeypatch.setattr(whisper, "decoded", lambda _encoded: rows)
        monkeypatch.setattr(whisper, "next_pieces", lambda _sound, asked, *_: [(one, row) for one in asked])

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
    assert whisper.refused(None, free, engine.parse(free), "en") is refused


def test_a_refusal_in_another_language_is_always_one(whisper):
    meaning = Interpretation("fahr nicht", Status.REJECTED, causes=frozenset((Cause.NEGATED,)))
    assert whisper.refused(None, "Fahr nicht.", meaning, "de")


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
def test_a_command_must_be_far_likelier_than_that_it_shall_not_be_done(
    whisper, parts, monkeypatch, text, ahead, unclear
):
    """In noise "never go" is heard as "then we'll go", word by word."""
    parts(text.capitalize(), {"Don't": 1.0, "don't": 1.0})

    def score(_encoded, texts, _language=None):
        return [-9.0 - ahead if text.startswith(NOT) else -9.0 for text in texts]

    monkeypatch.setattr(whisper, "score", score)
    assert unclear_words(whisper, None, text.split(), "en") == unclear


@pytest.mark.parametrize(("ahead", "unclear"), [(5.4, ("go",)), (5.5, ())])
def test_a_dont_may_belong_to_the_same_command_in_other_words(whisper, parts, monkeypatch, ahead, unclear):
    """ "Don't go to the kitchen" is like "go on to the kitchen", of which no "don't go on to the kitchen" is likely."""
    words, other = ["go", "on", "to", "the", "kitchen"], ["just", "go", "to", "the", "kitchen"]
    parts("Go on to the kitchen", {"Don't": 1.0})

    def score(_encoded, texts, _language=None):
        behind = {text: 30.0 if NOT_SAID.search(text) else 0.0 for text in texts} | {"Don't go to the kitchen": ahead}
        return [-9.0 - behind[text] for text in texts]

    monkeypatch.setattr(whisper, "score", score)
    assert unclear_words(whisper, None, words, "en") == ()
    found = whisper.clearness(None, words, "en", others=[other])
    assert tuple(word for word, clear in found.items() if clear < 0) == unclear


@pytest.mark.parametrize(
    ("text", "heard", "others", "asked"),
    [
        ("Go forward two meters.", True, {"Don't": 6.5, "Never": 6.5}, False),
        ("Go forward two meters.", True, {"Don't": 6.5, "Never": 6.4}, True),
        ("Go forward two meters.", False, {"Don't": 6.5, "Never": 6.5}, False),
        ("Go forward two meters.", False, {"Don't": 6.5, "Never": 6.4}, True),
        ("Please go forward two meters.", True, {}, False),
        ("Please go forward two meters.", True, {"don't": 6.4}, True),
        ("Please go forward two meters.", True, {"Do": 6.4}, True),
        ("Please go forward two meters.", False, {"don't": 6.4}, True),
    ],
    ids=lambda value: str(value),
)
def test_a_command_that_is_far_ahead_of_a_dont_is_not_compared(whisper, parts, monkeypatch, text, heard, others, asked):
    """At the place where a "don't" would be, whatever says nothing before it."""
    parts(text, others)
    compared = []
    monkeypatch.setattr(whisper, "score", lambda _sound, texts, _language: compared.extend(texts) or [0.0] * len(texts))
    ahead = whisper._ahead(None, text.lower().strip(".").split(), "en", heard=heard)
    assert any(NOT_SAID.search(text) for text in compared) is asked
    assert asked or ahead >= 6.5
