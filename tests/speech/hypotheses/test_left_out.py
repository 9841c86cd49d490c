"""Words that were heard and that a sentence leaves out, and words of a sentence that nobody heard."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.speech.hypotheses.left_out import (
    begin_left_out,
    begins_unheard,
    end_left_out,
    ends_unheard,
    goes_on,
    heard_otherwise,
    passed_over,
    tells,
    unheard,
)
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

WORDS = st.lists(st.sampled_from("abc"), max_size=4)


@given(WORDS, st.lists(WORDS, max_size=3))
def test_what_somebody_heard_whole_goes_on_from_nothing(words, heard):
    assert not goes_on(words, [*heard, words])


@given(WORDS, st.lists(st.sampled_from("abc"), min_size=1, max_size=3), st.lists(WORDS, max_size=3))
def test_what_goes_on_from_all_that_one_heard_was_not_said(begun, more, others):
    said = begun + more
    assert goes_on(said, [begun, *others]) is (said not in others)


TWICE = ["go", "forward", "four", "meters", "next", "half", "a", "meter", "per", "second", "go", "forward"]


@pytest.mark.parametrize(
    ("heard", "unheard"),
    [
        (["go forward four meter next half a meter per second", "no forward four meters next half a meter"], True),
        (
            ["go forward four meter next half a meter per second", "no forward four meters go for what"],
            False,
        ),
        (["go forward four meters next half a meter per second to forward"], False),
        (["what a lovely day it is to be in the garden with all of you and nothing to do"], False),
        ([], False),
    ],
    ids=["by nobody", "by one", "nearly", "other words", "nobody asked"],
)
def test_last_words_that_are_like_nothing_that_was_heard(heard, unheard):
    assert ends_unheard(TWICE, [one.split() for one in heard]) is unheard


@pytest.mark.parametrize(
    ("heard", "left_out"),
    [
        (["go back three feet at six miles", "go black three feet and happens"], "miles"),
        (["go back three feet", "go black three feet at six"], ""),
        (["go back tree feet", "no back three feets"], ""),
        ([], ""),
    ],
    ids=["by both", "by one", "by none", "nobody asked"],
)
def test_last_words_that_were_heard_and_left_out(heard, left_out):
    """Half of what was said is not what was said."""
    found = end_left_out(["go", "back", "three", "feet"], [one.split() for one in heard])
    assert left_out in " ".join(found)
    assert bool(found) is bool(left_out)


@pytest.mark.parametrize(
    ("heard", "left_out"),
    [
        (["go to ward 3 said the nurse", "go to war free said the nurse"], "said the nurse"),
        (["go to ward 3 said the nurse"], ""),  # one model alone, as unlike as that
        (["go to ward 3 said the nurse", "go to war free said the purse"], ""),
        (["go to ward free", "go to war free"], ""),  # it may be how "three" was heard
        (["go to warder free", "go to war defree"], ""),
    ],
)
def test_last_words_that_were_heard_alike_are_not_left_out(heard, left_out):
    found = end_left_out(["go", "to", "ward", "three"], [one.split() for one in heard])
    assert " ".join(found) == left_out


@given(st.lists(st.sampled_from(["go", "left", "to", "the", "kitchen", "slowly"]), min_size=1, max_size=6), st.data())
def test_of_words_that_were_heard_none_is_unheard(words, data):
    """However many others were heard, too."""
    more = data.draw(st.lists(st.sampled_from(["robot", "please", "now"]), max_size=3))
    assert not ends_unheard(words, [more + words])
    assert not end_left_out(more + words, [words])


@pytest.fixture(scope="module")
def begins(engine):
    """The first words that were heard and that a sentence leaves out."""
    grammar = SpokenGrammar(engine)

    def found(sentence: str, *heard: str) -> str:
        words, said = sentence.split(), [one.split() for one in heard]
        left_out = begin_left_out(words, grammar.lead(words), [(one, grammar.lead(one)) for one in said])
        return " ".join(left_out)

    return found


@pytest.mark.parametrize(
    ("sentence", "heard", "left_out"),
    [
        ("go to the kitchen", ["do you go to the kitchen"] * 2, "do you"),
        ("i want you to go to the kitchen", ["i want to go to the kitchen"] * 2, "i want to"),
        ("lets put the cup on the table", ["let me put the cup on the table"] * 2, "let me"),
        ("can you pick up the cup", ["you pick up the cup"] * 2, "you"),
        ("put the box on the table", ["who put the box on the table", "who put the backs on the table"], "who"),
        ("put the box on the table", ["who put the box on the table", "peter put the backs on the table"], ""),
        ("a single shot latte", ["for a single shot lattice", "bruce single shot latte"], ""),
        ("put the box on the table", ["who put the box on the table", "put the backs on the table"], ""),
        ("put the box on the table", ["but the box on the table", "but the backs on the table"], ""),
        ("put the box on the table", ["please put the box on the table", "so put the box on the table"], ""),
        ("could you go back", ["would you go back"] * 2, ""),
        ("please go back", ["pleas go back"] * 2, ""),
        ("quarter turn left", ["the quarter turn left"] * 2, ""),
        ("pick up the cup", ["mary picks up the cup"] * 2, "mary"),
        ("pick up the cup", ["picks up the cup"] * 2, ""),
        ("would you follow me", ["who says follow me", "would he follows me"], "who says"),
        ("go back one meter", ["she goes back on meter"] * 2, "she"),
        ("go back", [], ""),
    ],
)
def test_first_words_that_were_heard_and_left_out(begins, sentence, heard, left_out):
    """What is told or asked is no command, though all words of one are in it."""
    assert begins(sentence, *heard) == left_out


SPOKEN = st.sampled_from(["go to the kitchen", "turn left", "please put it down", "could you go back one meter"])


@given(SPOKEN, st.lists(st.sampled_from(["robot", "please", "okay", "so", "um"]), max_size=3), st.integers(1, 2))
def test_who_says_please_begins_no_other_sentence(begins, sentence, before, models):
    assert not begins(sentence, *[" ".join([*before, sentence])] * models)


@pytest.mark.parametrize(
    ("heard", "unheard"),
    [
        (["for three seconds", "four three seconds"], True),
        (["for three seconds", "go for three seconds"], False),
        (["go four three seconds"], False),
        (["for three"], False),
        ([], False),
    ],
    ids=["by nobody", "by one", "heard", "not all of it", "nobody asked"],
)
def test_a_first_word_that_nobody_heard(heard, unheard):
    """Who says "for three seconds" goes on from something."""
    assert begins_unheard(["go", "for", "three", "seconds"], 0, [one.split() for one in heard]) is unheard


@given(st.lists(st.sampled_from(["turn", "left", "now", "two"]), min_size=1, max_size=4), st.integers(0, 3))
def test_a_sentence_that_was_heard_begins_with_nothing_else(words, lead):
    assert not begins_unheard(words, lead, [words])


@pytest.mark.parametrize(
    ("sentence", "heard", "otherwise"),
    [
        ("turn off the lights at once", ["turn off the lights in the office"] * 2, "in office"),
        (
            "turn off the lights immediately",
            ["turn off the lights in the office", "turn of lights in the office"],
            "in office",
        ),
        ("set it to twenty percent", ["set it to twenty degrees", "set each to twenty degrees"], "degrees"),
        ("turn on the lights", ["turning on the lights", "turning on the light"], "turning"),
        ("charge the battery", ["charging the battery"] * 2, "charging"),
        ("stop the car", ["stopping the car"] * 2, "stopping"),
        ("turn on the lights", ["turned on the light", "turned on the lights"], "turned"),
        ("turn left", ["turned left"] * 2, ""),
        ("otter one take six samples", ["otter one took six samples", "author one took six samples"], "took"),
        ("take six samples", ["took six samples", "take six samples"], ""),
        ("bring two towels", ["brought two towels"] * 2, "brought"),
        ("oh let us go to the lounge", ["i love us went to the lounge", "olavas went to the lounge"], "went"),
        ("let us go to the lounge", ["he loves us went to the lounge", "olavas go to the lounge"], ""),
        ("send in the cart", ["sent in the cart"] * 2, "sent"),
        ("send two carts", ["sent two carts"] * 2, ""),
        # One of two may have misheard,
        ("turn off the lights at once", ["turn off the lights in the office", "turn off the lights at one"], ""),
        ("turn on the lights", ["turning on the lights", "turn on the lights"], ""),
        # and both may have written it otherwise, or short words.
        ("load the pallet", ["load the palette"] * 2, ""),
        ("go to the washroom", ["go to the watch room"] * 2, ""),
        ("turn off the light would you", ["turn off the light with you"] * 2, ""),
        ("turn on the lights", ["turning the lights"] * 2, ""),
    ],
)
def test_words_that_all_heard_where_a_sentence_has_others(sentence, heard, otherwise):
    words, said = sentence.split(), [one.split() for one in heard]
    found = tells(words, said) or heard_otherwise(words, said, lambda part: part == ["at", "once"])
    assert " ".join(found) == otherwise


@given(WORDS, st.lists(WORDS, max_size=3))
def test_nothing_was_heard_otherwise_where_one_heard_the_sentence(words, heard):
    assert not heard_otherwise(words, [*heard, words])
    assert not tells(words, [*heard, words])


LIGHTS = "turn on the kitchen lights and turn on the bedroom lights"


@pytest.mark.parametrize(
    ("heard", "found"),
    [
        (
            ["turn on the kitchen lights nor the bedroom lights", "turn on the kitchen lights not the maidroom lights"],
            True,
        ),
        (["turn on the kitchen lights nor the bedroom lights", "turn on the kitchen lights and turn the bed"], False),
        (["turn on the kitchen lights and turn on the bedroom lights"] * 2, False),
        (["turn on the kitchen lights nor the bedroom lights"], False),
        (["turn on the kitchen lights nor the bedroom lights", ""], False),
    ],
    ids=["by both", "by one", "by none", "one model", "nothing was heard"],
)
def test_words_inside_that_are_like_nothing_that_was_heard(heard, found):
    assert bool(unheard(LIGHTS.split(), [one.split() for one in heard])) is found


@given(WORDS, st.lists(WORDS, max_size=3))
def test_all_was_heard_where_one_heard_the_sentence(words, heard):
    assert not unheard(words, [*heard, words])


@pytest.mark.parametrize(
    ("sentence", "heard", "more"),
    [
        ("set it to two degrees", ["set it to two more degrees"] * 2, [("more",)]),
        ("set the fan to percent", ["set a fan to ten percent", "set the fan to ten percent"], [("ten",)]),
        ("set it to two degrees", ["set it to two more degrees", "set it to two degrees"], []),
        ("set it to two degrees", ["set it to two more degrees"], []),  # one alone hears anything in noise
        ("set it to two degrees", ["set it to to two degrees"] * 2, []),
        ("set it to two degrees", ["please set it to two degrees now"] * 2, []),  # before it, and behind it
        ("set it to two degrees", ["set it to the two degrees"] * 2, []),
        ("set it to two degrees", ["set it two more degrees"] * 2, [("more",)]),
        ("set it to two degrees", ["set it true more degrees"] * 2, []),  # it was heard for another word
    ],
)
def test_words_within_a_sentence_that_all_heard(sentence, heard, more):
    found = passed_over(sentence.split(), [one.split() for one in heard])
    assert [said for said, _ in found] == more
