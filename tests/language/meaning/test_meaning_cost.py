"""The work for an utterance is bounded, however it is made."""

from __future__ import annotations

import pytest
from meanings import shipped

from intent_engine.interpretation import Status
from intent_engine.language.automaton import Automaton
from intent_engine.language.meaning import MAX_WORDS
from intent_engine.language.networks.word_state import WordState
from intent_engine.language.utterance import Utterance


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Counts the words that automata read."""
    count = [0]

    def counted(name: str) -> None:
        original = getattr(Automaton, name)

        def call(self: Automaton, words: list[str]) -> object:
            count[0] += len(words) + 1
            return original(self, words)

        monkeypatch.setattr(Automaton, name, call)

    counted("read")
    counted("walk")
    step = Automaton.step

    def one(self: Automaton, state: WordState, word: str) -> object:
        count[0] += 1
        return step(self, state, word)

    monkeypatch.setattr(Automaton, "step", one)
    return count


HARD = [
    *("turn left and", "turn left, and", "turn left,", "no turn left", "turn left no right", "don't turn left,"),
    *(
        "stop turn left",
        "stop",
        "no",
        "and",
        "uh",
        "then and",
        "one hundred",
        "go two two two",
        "never mind",
        "not but",
    ),
    *("go forward turn left", "turn left go", "pick up the cup go forward", "turn left slowly go forward"),
    *("go to the kitchen and to the dock and", "pick up the cup and the", "go to the kitchen and the", "right then"),
    *("go forward a few feet and", "some", "a few"),
    *("to the kitchen,", "go to the kitchen, the", "turn left ninety, right forty", "the cup,", "pick up the cup, the"),
    *("to the kitchen, no the dock and", "turn left ninety no right"),
    *("pick up the cup no the bottle and", "go to the kitchn and", "go to the kitchn,", "go forward stop turn left"),
]


@pytest.mark.parametrize("unit", HARD)
def test_the_work_for_the_longest_utterance_is_bounded(unit: str, steps: list[int]) -> None:
    for length in (10, 20, 40, MAX_WORDS):
        steps[0] = 0
        shipped().parse(" ".join((unit.split() * MAX_WORDS)[:length]))
        assert steps[0] <= 6 * length * length + 130 * length


@pytest.mark.parametrize("unit", [*HARD, "\x00", "½", "ß", "go forward ", "1,", "-", "("])
def test_what_is_longer_than_any_command_is_not_even_read(
    unit: str, steps: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(text: str) -> None:
        raise AssertionError("a text of a megabyte was taken apart")

    monkeypatch.setattr(Utterance, "of", never)
    found = shipped().parse((unit * (1_000_000 // len(unit) + 1))[:1_000_000])
    assert found.status is Status.REJECTED
    assert "longer than any command" in found.reason
    assert steps[0] == 0


def test_many_words_in_few_characters_are_not_parsed(steps: list[int]) -> None:
    found = shipped().parse("a " * (MAX_WORDS + 1))
    assert found.status is Status.REJECTED
    assert steps[0] == 0
