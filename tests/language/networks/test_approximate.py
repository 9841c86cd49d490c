"""The search for utterances like what was heard: what it finds, and how little of the automaton it looks at."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.language.networks.approximate import (
    MAX_COMPARED,
    MAX_HEARD,
    MAX_SPAN,
    MOST_MOVES,
    WIDER,
    WIDTH,
    UtteranceSearch,
)

SENTENCES = (
    "go forward two meters",
    "turn left ninety degrees",
    "go to the kitchen",
    "stop",
)

HEARD = ("go", "turn", "left", "right", "the", "movement", "starts", "ten", "minutes", "crow", "driver", "what", "can")


class Counting:
    """A graph that counts the steps taken in it."""

    def __init__(self, graph) -> None:
        self.graph = graph
        self.steps = 0

    def __getattr__(self, name):
        return getattr(self.graph, name)

    def step(self, state, word):
        self.steps += 1
        return self.graph.step(state, word)


@pytest.mark.parametrize("sentence", SENTENCES)
def test_what_was_heard_exactly_comes_first_and_costs_nothing(engine, sentence):
    found = UtteranceSearch(engine.matcher().likely).nearest(sentence.split())
    assert found[0] == (tuple(sentence.split()), 0.0)
    assert [cost for _, cost in found] == sorted(cost for _, cost in found)


@pytest.mark.parametrize(
    ("heard", "meant"),
    [
        ("make left turn", "make a left turn"),
        ("please go to the mace station", "please go to the base station"),
        ("brake turn in", "brake turning"),
    ],
)
def test_missed_and_misheard_words(engine, heard, meant):
    found = UtteranceSearch(engine.matcher().likely).nearest(heard.split())
    assert " ".join(found[0][0]) == meant


@settings(max_examples=25, deadline=None)
@given(
    st.lists(
        st.sampled_from(HEARD),
        max_size=6,
    )
)
def test_all_that_is_found_are_utterances_and_few_steps_are_taken(engine, heard):
    graph = Counting(engine.matcher().likely)
    found = UtteranceSearch(graph).nearest(heard, 5, wider=True)
    # Three rounds for each number of words heard; steps that lead nowhere count as well.
    assert graph.steps <= 2 * 3 * MOST_MOVES * (WIDTH + WIDER) * (len(heard) + 1)
    assert len(found) <= 5
    assert len({words for words, _ in found}) == len(found)
    for words, cost in found:
        state = graph.start()
        for word in words:
            state = graph.step(state, word)
            assert state is not None
        assert graph.accepting(state)
        assert cost >= 0


def test_a_word_that_is_known_in_a_free_slot_is_found_in_what_sounds_like_it(engine):
    found = [
        " ".join(words)
        for words, _ in UtteranceSearch(engine.matcher().likely).nearest(["bring", "me", "the", "battle"])
    ]
    assert found[0] == "bring me the bottle"
    assert "bring me the battle" in found, "any other word may be said as well"


def test_a_known_word_is_never_put_in_where_nothing_was_heard(engine):
    for words, _ in UtteranceSearch(engine.matcher().likely).nearest(["pick", "up", "the"]):
        assert words[:3] != ("pick", "up", "the") or len(words) == 3


@pytest.mark.parametrize("heard", ["dry forward six inches", "tern left", "goat to the kitchen"])
def test_sounds_that_fit_anywhere_stand_for_no_other_word(engine, heard):
    fillers = {words[0] for words in engine.matcher().grammar.fillers if len("".join(words)) <= 4}
    for words, _ in UtteranceSearch(engine.matcher().likely).nearest(heard.split(), 5):
        assert words[0] not in fillers


def test_a_word_that_changes_everything_is_no_noise(engine):
    heard = ["when", "will", "you", "go", "to", "the", "dock"]
    lightly = dict(UtteranceSearch(engine.matcher().likely).nearest(heard))
    weightily = dict(UtteranceSearch(engine.matcher().likely).nearest(heard, weighty={"when"}))
    without = ("will", "you", "go", "to", "the", "dock")
    assert weightily.get(without, float("inf")) > 2 * lightly[without]


def test_single_words_are_whole_utterances(engine):
    graph = engine.matcher().likely
    words = UtteranceSearch(graph).single_words()
    assert {"stop", "left", "go"} <= set(words)
    assert "the" not in words
    for word in words:
        assert graph.accepting(graph.step(graph.start(), word))


@settings(max_examples=25, deadline=None)
@given(st.lists(st.sampled_from(HEARD), min_size=1, max_size=5))
def test_what_is_found_does_not_hang_on_what_was_asked_before_or_is_known_of_the_words(engine, heard):
    graph = engine.matcher().likely
    fresh = UtteranceSearch(graph)
    told = UtteranceSearch(graph, ("kitchen", "ninety", "leftwards", *HEARD))
    told.nearest(["drive", "to", "the", "kitchen"])
    assert fresh.nearest(heard) == told.nearest(heard) == fresh.nearest(heard)


def test_no_word_is_put_into_a_slot_that_does_not_take_it(engine):
    """ "The big red apple" in noise: all that was found had "right" in it, and was refused."""
    heard = ["fetch", "the", "big", "right", "up", "bolt", "to", "the", "blue", "box"]
    found = UtteranceSearch(engine.matcher().likely).nearest(heard)
    assert len(found) == 12
    assert all(engine.parse(" ".join(words)).reason != "'right' is nothing for slot 'thing'" for words, _ in found)


def test_what_was_heard_long_ago_is_forgotten(engine):
    """A robot that listens all day hears more than it can keep."""
    search = UtteranceSearch(engine.matcher().likely)
    first = search.nearest(["turn", "lefft"])
    for number in range(MAX_COMPARED):
        search.nearest([f"turn{number}"])
    assert len(search._likeness) <= MAX_COMPARED + MAX_HEARD * MAX_SPAN
    assert search.nearest(["turn", "lefft"]) == first


def test_two_threads_that_ask_at_once_are_answered_as_one(engine):
    heard = [["turn", "lefft", "ninty", "degrease"], ["drive", "too", "the", "kichen"]]
    alone = [UtteranceSearch(engine.matcher().likely).nearest(one) for one in heard]
    search = UtteranceSearch(engine.matcher().likely)
    with ThreadPoolExecutor(2) as pool:
        assert list(pool.map(search.nearest, heard * 3)) == alone * 3


def test_sentences_that_others_crowd_out_are_found_too(engine):
    """ "Going" and a number are sentences of a hundred beginnings, each of them nearer until the room is heard."""
    heard = ["going", "on", "towards", "the", "sitting", "room"]
    (nearest, _), *_ = UtteranceSearch(engine.matcher().likely).nearest(heard, wider=True)
    assert nearest == ("go", *heard[1:])


@given(st.sampled_from(SENTENCES), st.integers(0, 4), st.lists(st.sampled_from(HEARD), max_size=4))
def test_with_a_beginning_all_begin_so_and_what_was_heard_follows_it(engine, sentence, count, heard):
    search, begin = UtteranceSearch(engine.matcher().likely), sentence.split()[:count]
    found = search.nearest(heard, begin=begin)
    assert all(list(words[: len(begin)]) == begin for words, _ in found)
    if not begin:
        assert found == search.nearest(heard)
    rest = sentence.split()[count:]
    assert not rest or search.nearest(rest, begin=begin)[0] == (tuple(sentence.split()), 0.0)


def test_nothing_begins_as_no_utterance_does(engine):
    assert UtteranceSearch(engine.matcher().likely).nearest(["left"], begin=["degrees", "left"]) == []
