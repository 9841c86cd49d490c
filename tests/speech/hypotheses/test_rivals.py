"""What else may have been said in place of one word: laws of the search, and what the real models make of it."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speech_stage import ROOT

from intent_engine.engine import IntentEngine
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.numbers.spelled import in_digits
from intent_engine.speech.acoustic.moonshine import ScoringMoonshine
from intent_engine.speech.acoustic.moonshine_weights import moonshine_package
from intent_engine.speech.acoustic.writing import Writer, written
from intent_engine.speech.hypotheses.rivals import AT_A_PLACE, NUMBERS, Rivals
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

NEAR = 3.0
SENTENCES = [
    "go forward two meters",
    "pick up the blue box",
    "turn left one hundred and twenty degrees",
    "please put down the mug",
    "go to the kitchen then pick up the ball",
    "stop",
]


@pytest.fixture(scope="module")
def tokenizer(whisper):
    return whisper.tokenizer("en")


@pytest.fixture(scope="module")
def rivals(whisper, tokenizer) -> Rivals:
    return Rivals(whisper.grammar.search("en"), Writer(tokenizer, "en"))


def rows_of(tokenizer, text: str, likely: dict[str, float]) -> dict[tuple[int, ...], np.ndarray]:
    """What a model would make of every place of a text, to which some words are as likely as is said, and no others."""
    row = np.full(51864, -50.0, np.float32)
    for word, score in likely.items():
        row[tokenizer.encode(" " + word)[0]] = score
    pieces = tuple(tokenizer.encode(" " + text))
    return {pieces[:count]: row for count in range(len(pieces) + 1)}


def beside(rivals, tokenizer, sentence: str, text: str, likely: dict[str, float]) -> list[str]:
    found = rivals.beside(sentence.split(), rows_of(tokenizer, text, likely), NEAR)
    return [" ".join(words) for words in found]


def test_words_that_are_hardly_less_likely_are_found_the_likeliest_first(rivals, tokenizer):
    likely = {"box": -9.0, "pick": -9.0, "up": -9.0, "the": -9.0, "green": -2.0, "blue": -1.0, "red": -1.5, "old": -4.5}
    found = beside(rivals, tokenizer, "pick up the blue box", "Pick up the blue box", likely)
    found = [one for one in found if one.startswith("pick up the ") and one.endswith(" box")]
    assert found == ["pick up the red box", "pick up the green box"]
    # "old" is behind by more


def test_the_word_in_question_is_named(rivals, tokenizer):
    rows = rows_of(tokenizer, "Put down the mug", {"book": -1.0, "mug": -1.0})
    assert rivals.beside(["put", "down", "the", "mug"], rows, NEAR)["put", "down", "the", "book"] == "mug"


@pytest.mark.parametrize(
    "text", ["Go forward 2 meters", "go forward two meters", "Go forward two meters", "go forward 2"]
)
def test_however_it_is_written(rivals, tokenizer, text):
    found = beside(rivals, tokenizer, "go forward two meters", text, {"2": -1.0, "two": -8.0, "ten": -2.0, "go": 0.0})
    assert "go forward ten meters" in found


def test_of_a_number_of_several_words_nothing_is_said(rivals, tokenizer):
    likely = {"two": 0.0, "thirty": 0.0, "3": 0.0, "50": 0.0}
    words = ["turn", "left", "one", "hundred", "twenty", "degrees"]
    rows = rows_of(tokenizer, "Turn left 120 degrees", likely)
    assert rivals.before(words, rows).keys() == {0, 1, 5}
    assert all(one[2:5] == tuple(words[2:5]) for one in rivals.beside(words, rows, NEAR))


@pytest.mark.parametrize(
    ("likely", "other"),
    [
        ({"one": 0.0, "two": -1.0}, "two hundred twenty"),
        ({"twenty": 0.0, "thirty": -1.0}, "one hundred thirty"),
        ({"degrees": 0.0, "five": -1.0}, "one hundred twenty five"),
        ({"hundred": 0.0, "twenty": 0.0}, "one twenty"),
        ({"twenty": 0.0, "degrees": -1.0}, "one hundred"),
    ],
    ids=["another first", "another last", "one more", "one less", "the last less"],
)
def test_a_number_of_several_words_may_be_another_in_one_word(rivals, tokenizer, likely, other):
    """Where the model was asked about it in words; most write it in digits."""
    words = ["turn", "left", "one", "hundred", "twenty", "degrees"]
    rows = rows_of(tokenizer, "Turn left one hundred twenty degrees", likely)
    found = [" ".join(one) for one in rivals.beside(words, rows, NEAR, widely=True)]
    assert f"turn left {other} degrees" in found
    assert f"turn left {other} degrees" not in beside(rivals, tokenizer, " ".join(words), " ".join(words), likely)


@pytest.mark.parametrize(("near", "found"), [(-1.0, True), (-9.0, False)])
def test_a_number_of_several_words_may_be_one_of_a_single_word(rivals, tokenizer, near, found):
    """ "Ninety" sounds like "a hundred", and "seventy" like "seven ten"."""
    words = ["turn", "left", "one", "hundred", "degrees"]
    rows = rows_of(tokenizer, "Turn left one hundred degrees", {"100": 0.0, "90": near})
    beside = rivals.beside(words, rows, NEAR, widely=True)
    assert (("turn", "left", "ninety", "degrees") in beside) is found


@pytest.mark.parametrize(
    ("sentence", "likely", "other", "found"),
    [
        ("put down the mug", {"mug": 0.0, "red": -1.0}, "put down the red mug", True),
        ("put down the red mug", {"red": 0.0, "mug": -1.0}, "put down the mug", True),
        ("put down the red mug", {"mug": 0.0, "the": -1.0}, "put down the red the mug", False),
    ],
    ids=["one more", "one less", "no article more"],
)
def test_a_word_more_or_one_less_may_have_been_said(rivals, tokenizer, sentence, likely, other, found):
    rows = rows_of(tokenizer, sentence.capitalize(), likely)
    widely = [" ".join(one) for one in rivals.beside(sentence.split(), rows, NEAR, widely=True)]
    assert (other in widely) is found
    assert other not in beside(rivals, tokenizer, sentence, sentence.capitalize(), likely)


def test_a_number_in_digits_tells_nothing_of_its_words(rivals, tokenizer):
    words = ["turn", "left", "one", "hundred", "twenty", "degrees"]
    rows = rows_of(tokenizer, "Turn left 120 degrees", {})
    before = rivals.before(words, rows, widely=True)
    assert [place for place, row in before.items() if row is None] == [3, 4]


@pytest.fixture(scope="module")
def one_by_one(whisper):
    """The rivals of a model that writes numbers digit by digit, and its tokenizer."""
    if moonshine_package() is None:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    tokenizer = ScoringMoonshine().tokenizer("en")
    return Rivals(whisper.grammar.search("en"), Writer(tokenizer, "en")), tokenizer


@pytest.mark.parametrize(
    ("first", "second", "numbers"),
    [
        ({"9": -0.4, "1": -1.2}, {"9": {"0": 0.0}, "1": {"0": -0.1, "8": -3.0}}, ["ninety", "eighteen"]),
        ({"1": 0.0, "4": -0.7}, {"1": {"0": -0.5, "5": -1.0}, "4": {"0": 0.0}}, ["forty", "fifteen"]),
    ],
)
def test_a_number_that_is_written_digit_by_digit_has_the_likeliest_beside_it(one_by_one, first, second, numbers):
    """All begin with the same piece: by that alone they would be as likely."""
    rivals, tokenizer = one_by_one
    words = ("go", "back", "ten", "inches")
    sign = tokenizer.encode(" 10")[0]

    def row(likely: dict[str, float]) -> np.ndarray:
        found = np.full(32768, -50.0, np.float32)
        for digit, score in likely.items():
            found[tokenizer.encode(" " + digit)[1]] = score
        return found

    start = rivals.pieces(("go", "back"))
    begun = np.full(32768, -50.0, np.float32)
    begun[sign] = 0.0
    rows = rows_of(tokenizer, "Go back ten inches", {}) | {start: begun}
    assert rivals.digits(words, rows) == [(*start, sign)]
    rows[*start, sign] = row(first)
    asked = rivals.digits(words, rows)
    assert {(*start, sign, tokenizer.encode(" " + digit)[1]) for digit in first} <= set(asked)
    rows |= {one: row(second.get(tokenizer.decode([one[-1]]), {})) for one in asked}
    assert rivals.digits(words, rows) == []
    found = [other[2] for other in rivals.beside(words, rows, NEAR + 1.0) if other[2] != "ten"]
    assert found[: len(numbers)] == numbers


def test_a_place_that_was_not_asked_about_is_told(rivals, tokenizer):
    rows = rows_of(tokenizer, "Pick up, the box", {})
    before = rivals.before(["pick", "up", "the", "box"], rows)
    assert [place for place, row in before.items() if row is None] == [3]
    assert rivals.beside(["pick", "up", "the", "box"], rows, NEAR) is not None


def test_among_very_many_names_those_like_the_one_said_are_asked_about(tokenizer, tmp_path):
    syllables = ["ba", "do", "fi", "gu", "ke", "lo", "mi", "nu", "po", "ra", "se", "ti", "vo"]
    others = ("".join(three) + " room" for three in itertools.product(syllables, repeat=3))
    lines = [f"  {name}: {{x: 1.0, y: {at}.0}}\n" for at, name in enumerate(["berlin hall", "merlin hall", *others])]
    (tmp_path / "map.yaml").write_text("frame: map\nlocations:\n" + "".join(lines))
    grammar = SpokenGrammar(IntentEngine.from_files(ROOT / "grammars" / "en.yaml", locations=tmp_path / "map.yaml"))
    words = ("go", "to", "merlin", "hall")
    rows = rows_of(tokenizer, "Go to Merlin Hall", {"berlin": -1.0, "merlin": -1.0, "mer": -1.0, "ber": -1.0})
    found = Rivals(grammar.search("en"), Writer(tokenizer, "en")).beside(words, rows, NEAR)
    assert found["go", "to", "berlin", "hall"] == "merlin"


@given(st.sampled_from(SENTENCES), st.integers(0, 2**32 - 1), st.booleans())
@settings(deadline=None, max_examples=40)
def test_every_rival_is_a_sentence_that_differs_in_one_word(rivals, whisper, tokenizer, sentence, seed, digits):
    """Whatever the model thinks of the pieces."""
    words = tuple(sentence.split())
    pieces = tuple(tokenizer.encode(" " + written(in_digits(words) if digits else words, "en")))
    chance = np.random.default_rng(seed)
    rows = {pieces[:count]: chance.normal(0.0, 3.0, 51864).astype(np.float32) for count in range(len(pieces) + 1)}
    found = rivals.beside(words, rows, NEAR)
    graph = whisper.grammar.search("en").graph
    places: list[int] = []
    for other, word in found.items():
        assert len(other) == len(words)
        (place,) = [at for at in range(len(words)) if other[at] != words[at]]
        assert words[place] == word
        places.append(place)
        state = graph.start()
        for each in other:
            state = graph.step(state, each)
        assert graph.accepting(state)
    most = {place: AT_A_PLACE + NUMBERS * (words[place] in NUMBER_WORDS) for place in places}
    assert all(places.count(place) <= most[place] for place in places)


# -- what the models make of it -----------------------------------------------------------------------------------


def test_what_was_heard_freely_needs_no_other_call(whisper, spoken, monkeypatch):
    """What the model thought on the way is kept."""
    monkeypatch.setattr(whisper, "next_pieces", None)
    heard = whisper.listen(spoken)
    assert heard.settled
    assert heard.transcript.unclear == ()
    assert () in whisper.decoded(heard.encoded)
    assert whisper.decoded(whisper.encode(spoken)) == {}, "of another sound nothing is known"


def test_what_it_thought_on_the_way_is_what_it_says_when_asked(whisper, spoken):
    """Up to a constant, and to the silence that is cut off for it."""
    encoded = whisper.encode(spoken)
    whisper.greedy(encoded, "en")
    kept = whisper.decoded(encoded)
    tokens = max(kept, key=len)
    asked = dict(whisper.next_pieces(encoded, [tokens], 1, "en"))
    for beginning, row in kept.items():
        words = np.flatnonzero((asked[beginning] > -6.0) & (row > -1e30))  # it never writes "[" of itself
        assert np.ptp((row - asked[beginning])[words]) < 1.5
        assert row.argmax() == asked[beginning].argmax()


def test_a_command_with_a_close_rival_is_not_sure(whisper, spoken, monkeypatch):
    """ "Go forward ten meters" is not what was said, but if it were nearly as likely, the number would be unclear."""
    real = whisper.score_words
    close = ("go", "forward", "ten", "meters")

    def scored(encoded, sentences, language=None):
        scores = dict(zip(map(tuple, sentences), real(encoded, sentences, language), strict=True))
        if close in scores:
            scores[close] = max(scores.values()) - 1.0
        return [scores[tuple(one)] for one in sentences]

    monkeypatch.setattr(whisper, "score_words", scored)
    monkeypatch.setattr(whisper, "_rivals", lambda *_: {close: "two"})
    heard = whisper.listen(spoken)
    assert heard.transcript.unclear == ("two",)
    assert heard.sentences == (("go", "forward", "two", "meters"), close)


def test_a_stop_has_no_rival(whisper, spoken):
    encoded = whisper.encode(spoken)
    assert whisper._rivals(encoded, ("robot", "stop"), "en", 50.0, bool) == {}
    assert whisper._rivals(encoded, ("go", "forward", "two", "meters"), "en", 50.0, bool)
