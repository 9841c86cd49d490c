"""Words that leave open what is meant, heard by all where a sentence has none."""

from __future__ import annotations

import pytest

from intent_engine.speech.hypotheses.left_open import open_range, open_word
from intent_engine.speech.hypotheses.said_and_heard import SaidAndHeard
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

OPEN = {"or", "most"}


@pytest.mark.parametrize(
    ("sentence", "heard", "word"),
    [
        ("open the door and close the door", ["open the door or close the door"] * 2, ["or"]),
        ("dispense two tablets", ["dispense at most two tablets", "dispense it most two tablets"], ["most"]),
        ("open the door and close the door", ["open the door or close the door", "open the door and close it"], []),
        ("bring it to the or", ["bring it to the or"] * 2, []),
        ("take the risotto to table four", ["take the or sato to table for", "take the or sotto to table four"], []),
        ("add the oregano", ["add the or gano"] * 2, []),
        ("add the oregano", ["add the or gano", "add the salt or pepper"], ["or"]),
        ("take the risotto", ["take the rice or tofu"] * 2, ["or"]),
        ("open the door", ["open the window or door"] * 2, ["or"]),
        ("open the window", ["open the wind or window"] * 2, ["or"]),
        ("open the door", [], []),
    ],
)
def test_a_word_that_leaves_it_open(sentence, heard, word):
    assert list(open_word(sentence.split(), [one.split() for one in heard], OPEN)) == word


@pytest.mark.parametrize(
    ("sentence", "heard", "said"),
    [
        ("give two o four mg", ["give two to four mg"] * 2, "two to four"),
        ("give two o four mg", ["give 2 to 4 mg", "give two to four mg"], "2 to 4"),
        ("from thirty two forty two times", ["from thirty to forty two times"] * 2, "thirty to forty"),
        ("from thirty to forty two times", ["from thirty to forty two times"] * 2, ""),
        ("give two o four mg", ["give two to four mg", "give two o four mg"], ""),
        ("set row two to water", ["set row to two water"] * 2, ""),
        ("give two o four mg", [], ""),
    ],
)
def test_a_range_of_numbers(sentence, heard, said):
    assert " ".join(open_range(sentence.split(), [one.split() for one in heard], {"to"})) == said


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["Give 2-4 mg.", "Give 2 to 4 mg."], "2-4"),
        (["Give 2-4 mg.", "Give 2-4 mg."], "2-4"),
        (["Give 4/6 mg.", "Give 4-6 mg."], "4/6"),
        (["Give 1/2 mg.", "Give 1/2 mg."], ""),  # a half
        (["Give 4-2 mg.", "Give 4-2 mg."], ""),
        (["Give 2-4 mg.", "Give 24 mg."], ""),
        (["Call 555-12-34.", "Call 555-12-34."], ""),
    ],
)
def test_a_range_that_is_written_with_a_sign(texts, said):
    heard = [["give", "two", "to", "four", "mg"] if "to" in text else ["give", "two", "four", "mg"] for text in texts]
    assert " ".join(open_range(["give", "two", "o", "four", "mg"], heard, {"to"}, texts=texts)) == said


def test_in_other_languages():
    heard = [["gib", "zwei", "bis", "vier", "becher"]] * 2
    assert open_range(["gib", "zwei", "vier", "becher"], heard, {"bis"}, "de") == ("zwei", "bis", "vier")


def test_a_stop_waits_for_nothing(engine):
    grammar = SpokenGrammar(engine)
    assert SaidAndHeard(grammar, ["stop"], [["stop", "or", "go"]] * 2).left_open() == ()
    heard = [["go", "to", "the", "kitchen", "or", "the", "lab"]] * 2
    assert SaidAndHeard(grammar, ["go", "to", "the", "kitchen", "and", "the", "lab"], heard).left_open() == ("or",)


def test_every_language_knows_such_words():
    from intent_engine.language.loading.language_words import default_wording

    for language in ("de", "en", "es", "fr", "it"):
        wording = default_wording(language, tuple)
        assert wording.leaves_open, language
        assert wording.ranging, language
