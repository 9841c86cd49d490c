"""What an utterance is besides its words."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.language.normalize import tokenize
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.phrase_set import PhraseSet

words = st.sampled_from("abc")
phrases = st.lists(st.lists(words, max_size=3), max_size=5)
said = st.lists(words, max_size=8)


@given(phrases, said, st.data())
def test_what_is_left_without_phrases(given: list[list[str]], text: list[str], data: st.DataObject) -> None:
    breaks = data.draw(st.lists(st.booleans(), min_size=len(text), max_size=len(text)))
    found = PhraseSet(given)
    left = Utterance(text, breaks).without(found)
    expected, pauses, place, pause, removed = [], [], 0, False, False
    while place < len(text):
        length = found.at(text, place)
        pause = pause or any(breaks[place : place + max(length, 1)])
        if not length:
            expected.append(text[place])
            pauses.append(pause or (None if removed and len(expected) > 1 else False))
            pause = removed = False
        removed = removed or length > 0
        place += max(length, 1)
    assert left.words == expected
    assert left.breaks == pauses, "no pause is lost, and none is made; what was taken out leaves its place"
    assert left.part(1, len(left)).breaks == pauses[1:]
    assert all(0 < place < len(left) for place in left.joined)


@given(st.text(max_size=60))
def test_an_utterance_has_the_words_of_its_text(text: str) -> None:
    found = Utterance.of(text)
    assert len(found) == len(found.breaks) == len(found.words)
    if not any(bracket in text for bracket in "[(<*"):
        every = [token.word for token in tokenize(text)]
        assert len(found) <= len(every)
        rest = iter(every)
        assert all(word in rest for word in found.words), "only stutters are left out"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("t turn left", "turn left"),
        ("turn f forty degrees", "turn forty degrees"),
        ("go to a aisle", "go to a aisle"),
        ("i insist", "i insist"),
        ("2 m meters", "2 m meters"),
        ("go to bay b", "go to bay b"),
        ("b b", "b b"),
        ("turn le- left", "turn left"),
        ("turn le- turn left", "turn turn left"),
        ("le- left turn", "left turn"),
        ("turn thir- thirty degrees", "turn thirty degrees"),
        ("pre- and post-processing", "pre and post processing"),
        ("six- sixteen degrees", "six sixteen degrees"),
        ("a left- left", "a left left"),
        ("[BLANK_AUDIO] go (laughs) forward *coughing* <noise>", "go forward"),
        ("[stop]", "stop"),
        ("(go forward)", "go forward"),
        ("", ""),
    ],
)
def test_noises_and_stutters(text: str, words: str) -> None:
    assert Utterance.of(text).words == words.split()


def test_a_pause_that_a_noise_makes_is_kept() -> None:
    assert Utterance.of("go forward [noise] turn left").breaks == [False, False, True, False]


def test_a_part_keeps_its_pauses() -> None:
    found = Utterance.of("go, stop, wait")
    assert found.part(1, 3) == Utterance(["stop", "wait"], [True, True])


@given(st.lists(st.tuples(words, st.booleans())), st.lists(st.tuples(words, st.booleans()), min_size=1), st.data())
def test_other_words_in_the_place_of_some_keep_all_pauses(
    said: list[tuple[str, bool]], other: list[tuple[str, bool]], data: st.DataObject
) -> None:
    start = data.draw(st.integers(0, len(said)))
    end = data.draw(st.integers(start, len(said)))

    def utterance(given: list[tuple[str, bool]]) -> Utterance:
        return Utterance([word for word, _ in given], [pause for _, pause in given])

    told = utterance(said).with_other(start, end, utterance(other))
    assert told.words == [word for word, _ in said[:start] + other + said[end:]]
    assert len(told.breaks) == len(told.words)
    kept = (told.part(0, start), told.part(start + len(other), len(told)))
    assert [part.breaks for part in kept] == [[pause for _, pause in some] for some in (said[:start], said[end:])]
    assert told.breaks[start + 1 : start + len(other)] == [pause for _, pause in other[1:]]


def test_where_a_word_was_taken_out_is_remembered() -> None:
    fillers = PhraseSet([("uh",), ("you", "know")])
    assert Utterance.of("nine uh forty you know degrees").without(fillers).joined == {1, 2}
    assert Utterance.of("uh go forward uh").without(fillers).joined == frozenset()


@pytest.mark.parametrize("text", ["turn twenty, five degrees", "five. ten degrees", "one, eighty"])
def test_a_pause_in_a_number(text):
    assert Utterance.of(text).paused_in_number()


@pytest.mark.parametrize(
    "text", ["two thousand, five hundred", "turn, twenty five degrees", "twenty five", "bay two, three"]
)
def test_no_pause_in_a_number(text):
    assert not Utterance.of(text).paused_in_number()
