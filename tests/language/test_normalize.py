"""What people type and recognisers write, as plain words."""

from __future__ import annotations

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from intent_engine.language.normalize import CONTRACTIONS, TITLES, elided, plain_words, tokenize


def said(text: str) -> str:
    return " ".join(token.word for token in tokenize(text))


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("Go forward.", "go forward"),
        ("GO   FORWARD!!", "go forward"),
        ("go\tforward\nnow", "go forward now"),
        ("Let's go", "lets go"),
        ("I'd go", "id go"),
        ("Don't go", "do not go"),
        ("don’t go", "do not go"),
        ("dont go", "do not go"),
        ("don\u02bct go", "do not go"),
        ("won't", "will not"),
        ("can't", "can not"),
        ("cannot", "can not"),
        ("shouldn't", "should not"),
        ("ain't", "is not"),
        ("E-Stop", "e stop"),
        ("va à l'entrée", "va à l entrée"),
        ("Va à L’Hôtel, n’avance pas", "va à l hôtel n avance pas"),
        ("jusqu'à l'aéroport d'ici", "jusqu à l aéroport d ici"),
        ("dell'ufficio, dov'è?", "dell ufficio dov è"),
        ("s'il n'y a pas", "s il n y a pas"),
        ("aujourd'hui", "aujourdhui"),
        ("D'Angelo's desk", "dangelos desk"),
        ("D’Souza", "dsouza"),
        ("D'eau", "d eau"),
        ("rock'n'roll at five o'clock, d'you hear", "rocknroll at five oclock dyou hear"),
        ("ten-meters", "ten meters"),
        ("twenty-five", "twenty five"),
        ("to the “kitchen”", "to the kitchen"),
        ("ｇｏ　ｆｏｒｗａｒｄ", "go forward"),
        ("café", "café"),
        ("cafe\u0301", "café"),
        ("for\u00adward", "forward"),  # a soft hyphen, a joiner, a mark of direction, one of byte order
        ("\ufeffgo\u200e for\u200dward\u2069", "go forward"),
        ("stop\u200bnow", "stop now"),
        ("ﬁnd", "find"),
        ("", ""),
        ("...", ""),
        ("—", ""),
        ("\x00\x1b[31m", "31 m"),
        ("Dr. Miller", "doctor miller"),
        ("mr brown and Mrs. Smith", "mister brown and missus smith"),
        ("Prof Schmidt", "professor schmidt"),
        ("MRI, dr", "mri doctor"),
        # Numbers.
        ("2m", "2 m"),
        ("10 m.", "10 m"),
        ("10-meters", "10 meters"),
        ("2.5m", "2.5 m"),
        (".5 m", "0.5 m"),
        ("1,200 m", "1200 m"),
        ("1,234,567.5", "1234567.5"),
        ("1,3 m", "1.3 m"),
        ("0,125 m", "0.125 m"),
        ("2,50 m", "2.50 m"),
        ("bays 1, 3", "bays 1 3"),
        ("1,2,3", "1 2 3"),
        ("192.168.1.2", "192 168 1 2"),
        ("1/2 meter", "1/2 meter"),
        ("1⁄2 meter", "1/2 meter"),
        ("½ meter", "1/2 meter"),
        ("2½ meters", "2-1/2 meters"),
        ("2-1/2", "2-1/2"),
        ("2 1/2", "2-1/2"),
        ("2 - 1/2", "2-1/2"),
        ("-3", "-3"),
        ("− 3", "-3"),
        ("turn -90 degrees", "turn -90 degrees"),
        ("10-12", "10 12"),
        ("75 -300 mm", "75 300 mm"),
        ("3rd", "3rd"),
        ("1 200 m".replace(" ", "\u202f", 1), "1200 m"),
        # Signs.
        ("90°", "90 degrees"),
        ("90 °", "90 degrees"),
        ("20°/s", "20 degrees per s"),
        ("0.3 m/s", "0.3 m per s"),
        ("2 km/h", "2 km per h"),
        ("50%", "50 percent"),
        ("R&D", "r and d"),
        ("the T.V.", "the tv"),
        ("a U.S.B. cable", "a usb cable"),
        ("the U.S.B cable", "the usb cable"),
        ("go to bay B. Stop.", "go to bay b stop"),
        ("at 7 p.m.", "at 7 pm"),
        ("stop.i.go", "stop i go"),
        ("go to A.B12", "go to a b 12"),
        ("turn left & stop", "turn left and stop"),
        ("5'6\"", "5 feet 6 inches"),
        ("5′ 6″", "5 feet 6 inches"),
        # A quotation ends with the sign of a unit.
        ('"go forward 2"', "go forward 2"),
        ("“go forward 2”, she said", "go forward 2 she said"),
        ("say 'don't wait 5'", "say do not wait 5"),
        ('go "2" meters', "go 2 meters"),
        ('"go forward 2" and 5" back', "go forward 2 and 5 inches back"),
        ('"go forward 2""', "go forward 2 inches"),
        ('"go forward 5\'"', "go forward 5 feet"),
        ("don't go 5'", "do not go 5 feet"),
        ("and/or", "and per or"),
        ('he said "go"', "he said go"),
    ],
)
def test_writing(written: str, words: str) -> None:
    assert said(written) == words


@pytest.mark.parametrize(
    ("written", "places"),
    [
        ("go, stop", [1]),
        ("go. Stop", [1]),
        ("go - stop", [1]),
        ("go -- stop", [1]),
        ("go… stop", [1]),
        ("go\nstop", [1]),
        ("go! stop? wait", [1, 2]),
        ("e-stop", []),
        ("go 2.5 m", []),
        ("don't, no", [2]),
        (", go", [0]),
    ],
)
def test_pauses_are_known(written: str, places: list[int]) -> None:
    assert [place for place, token in enumerate(tokenize(written)) if token.breaks] == places


texts = st.one_of(st.text(max_size=60), st.text("ab2 .,-/'°½\n1", max_size=40))


@settings(max_examples=300)
@given(texts)
@example("İSTANBUL")
@example("\ud800go")
@example("e\u0301\u0301 go")
def test_every_word_has_a_place_and_places_are_in_order(text: str) -> None:
    last = 0
    for token in tokenize(text):
        assert token.word
        assert token.word == token.word.lower() or len(token.word.lower()) != len(token.word)
        assert last <= token.start < token.end <= len(text)
        last = token.start


@settings(max_examples=300)
@given(st.text(st.characters(max_codepoint=127), max_size=60))
def test_a_plain_word_stands_where_its_place_says(text: str) -> None:
    for token in tokenize(text):
        piece = text[token.start : token.end].lower()
        if token.word.isalpha() and piece.isalpha() and piece not in CONTRACTIONS and piece not in TITLES:
            assert token.word == piece


@pytest.mark.parametrize(
    ("text", "language", "breaks"),
    [
        ("find Dr. Miller", "en", [False, False, False]),
        ("find Dr, Miller", "en", [False, False, True]),
        ("find Dr . Miller", "en", [False, False, True]),
        ("find dr miller. go", "en", [False, False, False, True]),
        ("find Dr.... go", "en", [False, False, True]),
        ("frag Dr. Braun", "de", [False, False, False]),
        ("chiama Dott.ssa Rossi", "it", [False, False, False, False]),
        ("vraag Dr. Braun", "nl", [False, False, True]),
    ],
)
def test_the_full_stop_of_a_title_is_no_pause(text: str, language: str, breaks: list[bool]) -> None:
    assert [token.breaks for token in tokenize(text, language)] == breaks


@settings(max_examples=300)
@given(texts)
def test_words_stay_what_they_are(text: str) -> None:
    words = [token.word for token in tokenize(text) if not any(character.isdigit() for character in token.word)]
    assert said(" ".join(words)).split() == words


@settings(max_examples=200)
@given(
    st.one_of(
        st.text("abdnot' ", max_size=20),
        st.text("aDr 12.,!?-/", max_size=12),
        st.lists(st.sampled_from(["go", "Go", "dont", "cannot", "a", "2", "30", "m.", "1/2", "dr", "2nd"])).map(
            " ".join
        ),
    ),
    st.sampled_from(["en", "de", "fr"]),
)
def test_the_short_way_and_the_long_way_are_the_same(text: str, language: str) -> None:
    tokens = tokenize(text, language)
    assert plain_words(text) in (None, [token.word for token in tokens])
    assert plain_words(text) is None or not any(token.breaks for token in tokens)


def test_what_recognisers_write_goes_the_short_way() -> None:
    for text in ("go forward", "go to room 1204", "Go forward 2 meters.", "Turn left by 90 degrees!", "go to bay 3"):
        assert plain_words(text) is not None
    for text in ("1. Go", "go 2.5 meters", "go 1 2/3 meters", "go 1 500 m", "don't", "turn left, go", "Dr. Miller"):
        assert plain_words(text) is None


@pytest.mark.parametrize(
    "unit", ["1,", "1,1", "111,", "1 ", "1/", "-", " -", "- ", "'", "a'", "½", "e\u0301", ".", "1-", "\u202f1"]
)
def test_a_long_text_is_taken_apart_in_one_go(unit: str) -> None:
    """A pattern that looked back or ahead over the rest of the text would not come to an end here."""
    assert len(tokenize(unit * 100_000)) <= 200_000


@pytest.mark.parametrize(
    ("words", "language", "written"),
    [
        ("va à l entrée de l hôtel", "fr", "va à l'entrée de l'hôtel"),
        ("l entrée", "fr", "l'entrée"),
        ("salle l b", "fr", "salle l b"),
        ("vai all ufficio un altro", "it", "vai all'ufficio un altro"),
        ("room l is a room", "en", "room l is a room"),
    ],
)
def test_words_that_lost_a_vowel_are_written_with_the_next(words, language, written):
    assert elided(words, language) == written
    if language != "en":
        assert said(written) == words
