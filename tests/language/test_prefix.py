"""A beginning of a sentence is known as one, and what is complete needs no waiting for more."""

from __future__ import annotations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from meanings import commands, does, shipped

from intent_engine.engine import Prefix, PrefixStatus

WHOLE = (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)
FILLERS = {words[0] for words in shipped().grammar.fillers if words}
few = settings(max_examples=80, deadline=None)


def leads_on(found: Prefix, word: str) -> bool:
    numeral = word[0].isdigit()
    return word in found.next_words or "<any>" in found.next_words or (numeral and "<number>" in found.next_words)


BEGUN = {
    "pick up the": PrefixStatus.INCOMPLETE,
    "pick up a": PrefixStatus.INCOMPLETE,
    "please pick up my": PrefixStatus.INCOMPLETE,
    "pick up a cup of": PrefixStatus.INCOMPLETE,
    "put the cup on the": PrefixStatus.INCOMPLETE,
    "turn left and pick up the": PrefixStatus.INCOMPLETE,
    "pick up the cup": PrefixStatus.EXTENDABLE,
    "pick up box a": PrefixStatus.EXTENDABLE,
    "pick up that": PrefixStatus.EXTENDABLE,
    "go to the": PrefixStatus.INCOMPLETE,
    "go to the kitchen": PrefixStatus.COMPLETE,
    "continue": PrefixStatus.EXTENDABLE,
    "continue to the": PrefixStatus.INCOMPLETE,
    "love": PrefixStatus.IMPOSSIBLE,
}


@pytest.mark.parametrize(
    ("heard", "said"),
    [
        ("go back for meters", "go back four meters"),
        ("please go back to meters", "please go back two meters"),
        ("turn left and go back to feet", "turn left and go back two feet"),
    ],
)
def test_a_command_with_a_word_that_only_sounds_like_its_own_ends_as_it_does(heard, said):
    engine = shipped()
    assert engine.prefix(heard).status is PrefixStatus.IMPOSSIBLE, "as it is written"
    assert engine.prefix(heard, spoken=True) == engine.prefix(said)


@pytest.mark.parametrize("text", ["go back for kitchens", "we go back to meters of it", "go back for"])
def test_what_is_no_command_with_it_stays_what_it_is(text):
    assert shipped().prefix(text, spoken=True) == shipped().prefix(text)


@pytest.mark.parametrize(("text", "status"), BEGUN.items())
def test_how_far_words_have_come(text: str, status: PrefixStatus) -> None:
    assert shipped().prefix(text).status is status


@few
@given(commands(), st.sampled_from(["the", "my", "an", "of"]))
def test_nothing_ends_in_an_article(command: str, word: str) -> None:
    found = shipped().prefix(f"{command} {word}")
    assert found.status in (PrefixStatus.INCOMPLETE, PrefixStatus.IMPOSSIBLE)


@few
@given(commands())
def test_every_beginning_of_a_command_leads_to_its_next_word(command: str) -> None:
    engine = shipped()
    words = command.split()
    for count, word in enumerate(words):
        found = engine.prefix(" ".join(words[:count]))
        assert found.status is not PrefixStatus.IMPOSSIBLE
        assert found.known_words == count
        assert leads_on(found, word), word
    assert engine.prefix(command).status in WHOLE


@few
@given(commands(), st.sampled_from(["uh {}", "{} please", "please {} now", "{} and then go forward", "don't {}"]))
def test_an_utterance_is_more_than_a_sentence(command: str, form: str) -> None:
    assert shipped().prefix(form.format(command)).status in WHOLE


@few
@given(commands())
def test_only_fillers_and_further_commands_follow_what_is_complete(command: str) -> None:
    engine = shipped()
    found = engine.prefix(command)
    if found.status is PrefixStatus.COMPLETE:
        grammar = engine.grammar
        joints = {word for words in (*grammar.fillers, *grammar.operators.sequence) for word in words}
        assert set(found.next_words) <= joints


@few
@given(commands(), st.sampled_from(["degrees", "meters", "at", "slowly", "for", "left", "forward", "the", "two", "up"]))
def test_one_more_word_never_changes_what_is_complete(command: str, word: str) -> None:
    """What is complete is acted on in the first silence: nothing that is said next may have been part of it."""
    assume(FILLERS.isdisjoint(command.split()))  # "about face": with something unknown after it, "about" is taken out
    if shipped().prefix(command).status is PrefixStatus.COMPLETE:
        after = does(f"{command} {word}")
        assert after in (does(command), "rejected", "incomplete", "ambiguous"), after
