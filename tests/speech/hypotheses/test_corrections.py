"""What may have been meant by words that take something back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.speech.acoustic.writing import Writer
from intent_engine.speech.hypotheses.corrections import MOST, corrected_like, no_between
from intent_engine.speech.hypotheses.rivals import Rivals
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

NO = PhraseSet([("no",), ("i", "mean")])


@pytest.mark.parametrize(
    ("heard", "meant"),
    [
        ("go to the lounge no the dark", "go to the lounge no the dock"),
        ("go to the lounge know the duck", "go to the lounge no the dock"),
        ("goat to the lounge no the dock", "go to the lounge no the dock"),
        ("go to the kitchen i mean the bed room", "go to the kitchen i mean the bedroom"),
        ("turn left sorry write", "turn left sorry right"),
        ("turn left no wait go to the kitten", "turn left no wait go to the kitchen"),
        ("go four word two no three meters", "go forward two no three meters"),
        ("turn left thirty forty degrees", "turn left thirty no forty degrees"),
    ],
)
def test_a_correction_is_found_that_is_like_what_was_heard(engine, grammar, heard, meant):
    found = [" ".join(words) for words in grammar.near(heard.split(), "en")]
    assert meant in found
    assert engine.parse(meant).corrected


OWN = """
language: en
slots: {colour: [blue, red, green]}
intents: {follow: {action: custom, sentences: ["follow the {colour} line"]}}
"""


@pytest.mark.parametrize(
    ("heard", "meant"),
    [
        ("follow the blue line know the red line", "follow the blue line no the red line"),
        ("follow the blue no the read lion", "follow the blue no the red line"),
    ],
)
def test_a_correction_is_found_in_a_grammar_that_says_nothing_of_it(tmp_path, heard, meant):
    file = tmp_path / "line.yaml"
    file.write_text(OWN, "utf-8")
    engine = IntentEngine.from_files(file)
    assert meant.split() in [list(words) for words in SpokenGrammar(engine).near(heard.split(), "en")]
    assert engine.parse(meant).corrected


@pytest.mark.parametrize(
    ("heard", "spoken"),
    [
        ("thirty forty microliters", "thirty no forty microliters"),
        ("thirty four microliters", "thirty four microliters"),
        ("two hundred and fifty meters", "two hundred and fifty meters"),
        ("go forward two meters", "go forward two meters"),
        ("drive at zero point two meters per second", "drive at zero point two meters per second"),
        ("one three hundred thirty yards", "one no three hundred thirty yards"),
        ("two meters three point five seconds", "two meters three point five seconds"),
    ],
)
def test_two_numbers_that_are_not_one_may_have_had_a_no_between_them(heard, spoken):
    assert " ".join(no_between(heard.split(), NO, "en")) == spoken
    assert no_between(heard.split(), PhraseSet([("nein",)]), "de") == heard.split()


@given(st.floats(0, 9999), st.integers(0, 3))
def test_a_number_is_not_taken_apart(value, places):
    heard = ["at", *in_words([f"{value:.{places}f}"], "en"), "meters"]
    assert no_between(heard, NO, "en") == heard


@pytest.mark.parametrize("heard", ["go to the kitchen", "no the dock", "go to the lounge no", "there is no milk left"])
def test_who_takes_nothing_back_has_said_no_correction(engine, grammar, heard):
    found = grammar.near(heard.split(), "en")
    assert not any(engine.parse(" ".join(words)).corrected for words in found)


VOCABULARY = ["go", "to", "the", "lounge", "dock", "no", "i", "mean", "turn", "left", "right", "two", "meters"]
WORDS = st.lists(st.sampled_from(VOCABULARY), max_size=9)


@given(WORDS)
def test_what_is_found_is_understood_as_a_correction(engine, grammar, heard):
    usual = set(grammar.like(tuple(heard), "en", wider=True))
    for words in set(grammar.near(heard, "en")) - usual:
        meaning = engine.parse(" ".join(words))
        assert meaning.corrected
        assert meaning.status is not Status.REJECTED


@given(WORDS, st.lists(st.lists(st.sampled_from(["go", "left"]), min_size=1).map(tuple), max_size=3))
def test_each_is_a_command_a_correction_and_what_goes_on_from_a_beginning_of_that_or_was_heard(heard, sentences):
    found = corrected_like(heard, NO, lambda _, begin: [one for one in sentences if one[: len(begin)] == begin])
    assert len(found) <= MOST
    for words in found:
        at = next(at for at in range(1, len(words)) if NO.at(words, at))
        after = words[at + NO.at(words, at) :]
        broken_off = any(one[:at] == words[:at] and one[at:] == after[-len(one[at:]) :] for one in sentences)
        assert words[:at] in sentences or broken_off
        begins = [words[:count] for count in range(at)]
        assert after == tuple(heard[-len(after) :]) or any((*begin, *after) in sentences for begin in begins)


def test_other_words_are_looked_for_after_it_as_at_a_beginning(whisper, grammar):
    """ "Turn left, no, right" beside "turn left, no, left": both go on from "turn"."""
    tokenizer = whisper.tokenizer("en")
    rivals = Rivals(grammar.search("en"), Writer(tokenizer, "en"), grammar.corrections("en"))
    row = np.full(51864, -50.0, np.float32)
    row[tokenizer.encode(" right")[0]] = row[tokenizer.encode(" left")[0]] = -1.0
    words = ["turn", "left", "no", "left"]
    rows = {rivals.pieces(words)[:count]: row for count in range(len(rivals.pieces(words)) + 1)}
    assert ("turn", "left", "no", "right") in rivals.beside(words, rows, 3.0)
    unknown = Rivals(grammar.search("en"), Writer(tokenizer, "en"))
    assert ("turn", "left", "no", "right") not in unknown.beside(words, rows, 3.0)
