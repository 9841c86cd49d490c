"""Words as Whisper writes them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.utterance import Utterance, plain
from intent_engine.speech.acoustic import writing
from intent_engine.speech.acoustic.writing import _WRITTEN, Names, spellings, written


@pytest.mark.parametrize(
    ("words", "language", "text"),
    [
        ("thats enough", "en", "That's enough"),
        ("id like you to go", "en", "I'd like you to go"),
        ("can i stop", None, "Can I stop"),
        ("fahre in die kueche", "de", "Fahre in die kueche"),
        ("das ist im flur", "de", "Das ist im flur"),
    ],
)
def test_signs_and_capitals(words, language, text):
    assert written(words.split(), language) == text


def test_within_a_sentence():
    assert written(["stop"], "en", sentence=False) == "stop"
    assert written(["i"], "en", sentence=False) == "I"


@given(st.lists(st.sampled_from([*_WRITTEN, "go", "left", "kitchen", "two"]), min_size=1))
def test_it_is_read_as_the_same_words(words):
    assert Utterance.of(written(words, "en"), "en").words == words


@pytest.mark.parametrize(
    ("words", "language", "spelled"),
    [
        ("dreh dich um fünfundvierzig grad", "de", ["45 grad", "45°"]),
        ("fahr eins komma fünf meter", "de", ["1,5 meter"]),
        ("fahr einen meter", "de", []),
        ("mit zwanzig prozent", "de", ["20%"]),
        ("avance de deux mètres", "fr", ["2 mètres"]),
        ("gira noventa grados", "es", ["90 grados", "90°"]),
        ("turn sixty percent", "en", ["60%"]),
        ("weed the twentieth row", "en", ["20th row"]),
        ("weed the fifth row in ten minutes", "en", ["fifth row in 10 minutes", "5th row in 10 minutes"]),
        ("dans la vingtième rangée", "fr", []),
        ("go to bay b three", "en", ["bay b 3", "bay B3"]),
        ("go to lab twelve a", "en", ["lab 12 a", "lab 12A"]),
    ],
)
def test_numbers_are_written_in_digits_too(words, language, spelled):
    ways = [" ".join(way) for way in spellings(words.split(), language)]
    assert ways[0] == words
    assert len(ways) == 1 + len(spelled)
    for way, end in zip(ways[1:], spelled, strict=True):
        assert way.endswith(end)


def test_a_name_is_what_the_model_has_only_so_or_the_grammar_writes_so(whisper):
    names = Names(whisper.tokenizer("en"), {"hotel": "Hotel", "mri": "MRI"})
    words = "marco julia beatles hotel mri kitchen queen b i a id two90"
    large = "Marco Julia Beatles Hotel MRI kitchen queen B i a id two90"
    assert " ".join(map(names.large, words.split(" "))) == large


@pytest.mark.parametrize(
    ("words", "spelled"),
    [
        ("go to the kitchen", ["go to the kitchen"]),
        ("tell anna", ["tell anna", "tell Anna"]),
        ("anna two", ["anna two", "anna 2", "Anna two", "Anna 2"]),
        ("call josé", ["call josé", "call José", "call jose", "call Jose"]),
        ("café two", ["café two", "café 2", "cafe two", "cafe 2"]),
    ],
)
def test_names_and_numbers_are_spelled_in_all_ways(whisper, words, spelled):
    names = Names(whisper.tokenizer("en"))
    assert [" ".join(one) for one in spellings(words.split(), "en", names)] == spelled


@given(st.lists(st.sampled_from(["go", "anna", "julia", "two", "b", "kitchen", "i"]), min_size=1))
def test_every_spelling_is_read_as_the_same_words(whisper, words):
    """The first is the words themselves."""
    spelled = spellings(words, "en", Names(whisper.tokenizer("en")))
    assert spelled[0] == tuple(words)
    assert {tuple(plain(written(one, "en"))) for one in spelled} == {tuple(plain(" ".join(words)))}


def test_what_was_heard_in_months_does_not_add_up(monkeypatch):
    """Only the words that were written last are kept."""
    monkeypatch.setattr(writing, "WORDS_KEPT", 2)
    encoded: list[str] = []

    class Tokenizer:
        def encode(self, text: str) -> list[int]:
            encoded.append(text)
            return [0]

    names = Names(Tokenizer(), {"mri": "MRI"})
    for word in ("cup", "ball", "lamp", "lamp", "mri"):
        names.large(word)
    assert encoded == [" cup", " Cup", " ball", " Ball", " lamp", " Lamp"]
    assert names.large("cup") == "cup"
    assert encoded[6:] == [" cup", " Cup"]
