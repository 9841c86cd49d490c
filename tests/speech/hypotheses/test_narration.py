"""Who tells something gives no command."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.narration import (
    ASKING,
    NARRATING,
    SUBJECTS,
    TELLING,
    asks_politely,
    asks_whether,
    leaves_out,
    narrating,
    told,
    verbless,
)


@pytest.mark.parametrize(
    ("text", "story", "left_out"),
    [
        ("turn left", ["when"], True),
        ("turn left when you are there", ["when"], False),
        ("go to the kitchen", ["we"], True),
        ("put the box on the table", ["i"], True),
        ("turn left", ["you"], True),
        ("i need you to turn left", ["i"], False),
        ("id like you to turn left", ["i"], False),
        ("can you turn left", ["you"], False),
        ("i would like you to turn left", ["youd"], False),
        ("can you turn left", ["i"], True),
        ("turn left", [], False),
    ],
)
def test_a_statement_is_no_command(text, story, left_out):
    """ "We go to the kitchen" tells of somebody; who begins so and wants it done says "I want you to"."""
    assert leaves_out(text.split(), story, heard=[]) is left_out


def test_the_words_of_every_language_with_which_nothing_is_done(root):
    english, german = (
        IntentEngine.from_files(root / "grammars" / f"{name}.yaml").matcher(name).grammar for name in ("en", "de")
    )
    assert narrating(english) == NARRATING
    found = narrating(german)
    assert found >= {"nicht", "nie", "wenn", "ich", "wer"}
    # With these commands are joined, corrected, stopped and made polite.
    assert found.isdisjoint({"und", "dann", "nein", "stopp", "halt", "es"})


@pytest.mark.parametrize(
    ("text", "subject", "heard", "left_out"),
    [
        ("irrigate the lettuce", "i", "i regate the lettuce", False),
        ("weed bed six", "we", "we bet six", False),
        ("weed everything", "weve", "weve everything", False),
        ("yaw right forty five degrees", "you", "you write forty five degrees", False),
        ("ignite the burner", "i", "i night the burner", False),
        ("open the door", "i", "i open the door", True),
        ("open the door", "i", "i opened the door", True),
        ("inspect the bridge", "i", "i expect the bridge", True),
        ("wipe the table", "we", "we hide the table", True),
        ("use the key", "you", "you lose the key", True),
        ("unload nylon", "you", "you unload nylon", True),
    ],
)
def test_the_beginning_of_a_verb_may_be_heard_as_who_does_something(text, subject, heard, left_out):
    assert leaves_out(text.split(), [subject], heard=[heard.split()]) is left_out


def test_no_word_is_misheard_as_one_that_was_heard():
    """ "Please won't watch in the front room": the "front" was heard as it is, so the "won't" is none."""
    words = ["please", "walk", "in", "the", "front", "room"]
    assert leaves_out(words, ["wont"], heard=[["please", "wont", "watch", "in", "the", "front", "room"]])
    assert not leaves_out(words, ["wont"], heard=[["please", "walk", "in", "the", "wont", "room"]])


@pytest.mark.parametrize(
    ("sentence", "heard", "lead", "found"),
    [
        ("go back one meter", ["she goes back on meter"] * 2, 0, "she"),
        ("go back one meter", ["okay she goes back on meter"] * 2, 1, "okay she"),
        ("you can go forward", ["you are going forward"] * 2, 0, "you are"),
        ("keep going", ["you are going", "we are going"], 0, ""),
        ("go to the dock", ["so is the dog"] * 2, 1, "so is"),
        ("where is linda", ["where is the linda"] * 2, 0, ""),
        ("remove the camera", ["who moved the camera"] * 2, 0, "who"),
        ("remove the camera", ["who moved the camera", "remove the camera"], 0, ""),
        ("when do you open", ["what do you open"] * 2, 0, ""),
        ("pick it up", ["pick it up"] * 2, 0, ""),
        ("as the crow flies", ["has the crow flies"] * 2, 0, ""),
        ("u turn", ["you turn"] * 2, 0, ""),
        ("please u turn now", ["please you turn now"] * 2, 1, ""),
        ("turn around", ["you turn around"] * 2, 0, "you"),
        ("go back", [], 0, ""),
    ],
)
def test_what_several_heard_alike_tells_of_somebody(sentence, heard, lead, found):
    assert " ".join(told(sentence.split(), [one.split() for one in heard], lead)) == found


WORDS = st.lists(
    st.sampled_from([*sorted(TELLING | ASKING | set(SUBJECTS)), "go", "left", "please", "robot"]), max_size=6
)


@given(WORDS, st.lists(WORDS, max_size=2), st.integers(0, 2))
def test_nothing_is_told_by_a_sentence_that_was_heard(words, others, lead):
    assert not told(words, [words, *others], lead)


@given(WORDS, st.lists(WORDS, min_size=1, max_size=3), st.integers(0, 2))
def test_what_is_told_all_have_heard(words, heard, lead):
    found = list(told(words, heard, lead))
    assert all(one[: len(found)] == found for one in heard)


@pytest.mark.parametrize(
    ("sentence", "heard", "without"),
    [
        ("heat the block to ninety degrees", ["the block at ninety degrees"] * 2, True),
        ("heat the block to ninety degrees", ["the block at ninety degrees"], True),  # a model that hears alone
        ("heat the block to ninety degrees", ["the block keeps to ninety", "the blok needs to ninety"], True),
        ("heat the block to ninety degrees", ["the block at ninety degrees", "did the block at ninety degrees"], True),
        ("heat the block to ninety degrees", ["the block at ninety degrees", ""], True),
        ("heat the block to ninety degrees", ["the block at ninety degrees", "eat the block at ninety degrees"], False),
        ("heat the block to ninety degrees", ["did the block to ninety degrees"] * 2, False),  # "did" may be "heat"
        ("heat the block to ninety degrees", ["the blocks at ninety degrees", "the clock at ninety degrees"], False),
        ("heat the block to ninety degrees", [], False),
        ("switch on the pump", ["the pump is on", "the pump was on"], True),
        ("go back to the dock", ["the dock is on", "the dock was on"], False),
        ("heat block two", ["block two"] * 2, False),
        ("the block to ninety degrees", ["the block to ninety degrees"] * 2, False),
        ("heat", ["the"], False),
        ("", ["the block"], False),
    ],
)
def test_a_thing_of_which_something_is_said_is_no_command_for_it(sentence, heard, without):
    """ "Is the block at ninety degrees": nobody heard that anything is to be done."""
    assert verbless(sentence.split(), 0, [one.split() for one in heard]) is without


@pytest.mark.parametrize(
    ("sentence", "heard", "without"),
    [
        ("get two tablets for bed seven", ["two tablets for bed seven", "two tablets for beth seven"], True),
        ("get two tablets for bed seven", ["get two tablets for bed seven", "two tablets for bed seven"], False),
        ("get two tablets for bed seven", ["gate two tablets for bed seven"] * 2, False),
        ("get two tablets for bed seven", ["two cabinets for bed seven"] * 2, False),
        ("get two", ["two"] * 2, False),  # nothing is counted
        ("two tablets for bed seven", ["two tablets for bed seven"] * 2, False),
        ("get two tablets", [], False),
    ],
)
def test_a_number_of_things_without_a_verb_is_no_command_for_them(sentence, heard, without):
    assert verbless(sentence.split(), 0, [one.split() for one in heard]) is without


@pytest.mark.parametrize(
    ("heard", "asked"),
    [
        (["do you go to the kitchen", "bee go to the kitchen"], "do you"),
        (["please do you go to the kitchen", "bee go to the kitchen"], "do you"),
        (["do you go to the kitchen", "go to the kitchen"], ""),  # one of them heard nothing before it
        (["do you go to the kitchen", "please go to the kitchen"], ""),
        (["do you go to the kitchen", "be gone to the kitchen"], ""),
        (["two go to the kitchen", "bee go to the kitchen"], ""),
        (["do you go to the kitchen"], ""),
        ([], ""),
    ],
)
def test_what_asks_whether_somebody_does_it(heard, asked):
    """One model in noise hears a question, and the other some word in its place."""
    led = [(one.split(), one.startswith("please")) for one in heard]
    assert " ".join(asks_whether(["go", "to", "the", "kitchen"], 0, led)) == asked


@pytest.mark.parametrize(
    ("sentence", "heard", "asked"),
    [
        ("can you weigh the barley", ["did you wait a barley", "any way to borrow"], "did you"),
        ("could you weigh the barley", ["any way to borrow", "do you wait a barley"], "do you"),
        ("can you weigh the barley", ["did you wait a barley", "can you way the barley"], ""),
        ("can you weigh the barley", ["did you wait a barley", "could you way the barley"], ""),
        ("please weigh the barley", ["did you wait a barley", "any way to borrow"], ""),  # weighed elsewhere
        ("can you weigh the barley", ["any way to borrow", "then you way the barley"], ""),
        ("weigh the barley", ["did you wait a barley"], ""),
        ("can you weigh the barley", [], ""),
    ],
)
def test_a_question_is_no_polite_command(sentence, heard, asked):
    words = sentence.split()
    lead = words.index("weigh")
    assert " ".join(asks_politely(words, lead, [one.split() for one in heard])) == asked
