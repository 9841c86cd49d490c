"""The search for utterances like what was heard: what it finds, and how little of the automaton it looks at."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.approximate import MOST_MOVES, nearest_utterances

SENTENCES = (
    "go forward two meters",
    "turn left ninety degrees",
    "go to the kitchen",
    "stop",
)

HEARD = ("go", "turn", "left", "right", "the", "movement", "starts", "ten", "minutes", "crow", "driver", "what", "can")


@pytest.fixture(scope="module")
def engine(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")


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
    found = nearest_utterances(engine.matcher().likely, sentence.split())
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
    found = nearest_utterances(engine.matcher().likely, heard.split())
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
    found = nearest_utterances(graph, heard, 5)
    # Three rounds for each number of words heard; steps that lead nowhere count as well.
    assert graph.steps <= 2 * 3 * MOST_MOVES * (len(heard) + 1)
    assert len(found) <= 5
    assert len({words for words, _ in found}) == len(found)
    for words, cost in found:
        state = graph.start()
        for word in words:
            state = graph.step(state, word)
            assert state is not None
        assert graph.accepting(state)
        assert cost >= 0
