"""What several models make of a sound, taken together: laws of the search for what else fits, with scripted models."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import pytest
from hypothesis import given
from hypothesis import strategies as st
from speech_stage import ROOT

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.evidence import View, letters_apart
from intent_engine.speech.hypotheses.ranking import ranked
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.hypotheses.weighing import ROUNDS, begun_otherwise, crossed, doubted, opposed_too
from intent_engine.speech.recognizer import Transcript

DRINKS = ("espresso", "latte", "mocha", "iced mocha", "coffee", "iced coffee", "americano")


@pytest.fixture(scope="module")
def orders() -> SpokenGrammar:
    return SpokenGrammar(IntentEngine.from_files(ROOT / "examples" / "coffee" / "coffee.yaml"))


def order(drink: str) -> tuple[str, ...]:
    return ("make", "me", "a", *drink.split())


@dataclass
class Scripted:
    """A model that thinks of some orders, and of which it is said how likely it finds each."""

    thought_of: Sequence[str]
    scores: Mapping[str, float]
    others: Mapping[str, Sequence[str]]
    """What it has beside each order."""
    heard: tuple[str, ...] = ("make", "me", "a", "drink")
    transcript: Transcript = field(default_factory=lambda: Transcript("make me a drink", language="en"))
    asked: list[str] = field(default_factory=list)

    def heard_beside(self, _words: Sequence[str]) -> Sequence[str]:
        return self.heard

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(map(order, self.thought_of))

    def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
        return [View(self.scores[" ".join(words[3:])], -1.0, letters_apart(words, self.heard)) for words in sentences]

    def beside(self, words: tuple[str, ...], *, far: bool = False) -> tuple[tuple[str, ...], ...]:
        drink = " ".join(words[3:])
        self.asked.append(drink)
        return tuple(map(order, self.others.get(drink, ())))


def likeliest(orders: SpokenGrammar, *models: Scripted) -> str:
    return " ".join(doubted(orders, models)[0].words[3:])  # type: ignore[arg-type]  # as good as an opinion


def test_what_is_beside_what_was_found_beside_is_looked_for_too(orders):
    """Or "a mocha" would be sure where "an iced mocha" was said, of which nobody thought at first."""
    scores = {"espresso": -4.0, "latte": -3.5, "mocha": -3.0, "iced mocha": -1.5}
    others = {"espresso": ["latte"], "latte": ["mocha"], "mocha": ["iced mocha"]}
    model = Scripted(["espresso"], scores, others)
    assert likeliest(orders, model) == "iced mocha"
    assert model.asked == ["espresso", "latte", "mocha", "iced mocha"]


def test_what_is_not_worth_a_doubt_is_not_asked_about(orders):
    model = Scripted(["espresso"], {"espresso": -60.0, "latte": -1.0}, {"espresso": ["latte"]})
    assert likeliest(orders, model) == "espresso"
    assert model.asked == []


def test_one_model_thinks_of_it_and_both_say_how_likely_it_is(orders):
    scores = {"coffee": -3.0, "iced coffee": -2.0}
    first, second = Scripted(["coffee"], scores, {}), Scripted([], {**scores, "iced coffee": -30.0}, {})
    second.others = {"coffee": ["iced coffee"]}
    assert likeliest(orders, first, second) == "coffee"
    second.scores = scores
    assert likeliest(orders, first, second) == "iced coffee"


@given(
    st.lists(st.sampled_from(DRINKS), min_size=1, max_size=3, unique=True),
    st.fixed_dictionaries({drink: st.floats(-6.0, -1.0) for drink in DRINKS}),
    st.fixed_dictionaries({drink: st.lists(st.sampled_from(DRINKS), max_size=3) for drink in DRINKS}),
)
def test_the_likeliest_of_all_that_was_asked_about_comes_first(orders, thought_of, scores, others):
    model = Scripted(thought_of, scores, others)
    readings = doubted(orders, [model])
    found = [" ".join(one.words[3:]) for one in readings]
    assert set(thought_of) <= set(found)
    assert len(model.asked) <= ROUNDS
    assert len(set(model.asked)) >= len(model.asked) - 1, "asked again about one that stays the likeliest, and done"
    margins = [one.evidence.margin for one in readings]
    assert margins[0] >= 0
    assert len(found) == len(set(found))


def test_a_beginning_that_one_thought_of_is_asked_of_both(orders):
    short, long = ("a", "mocha"), ("make", "me", "a", "mocha")

    @dataclass
    class Begins(Scripted):
        begins: Sequence[tuple[str, ...]] = ()

        def begun(self, words: tuple[str, ...]) -> Sequence[tuple[str, ...]]:
            return self.begins if words == short else ()

        def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
            return [View(self.scores[" ".join(one)], -1.0, letters_apart(one, self.heard)) for one in sentences]

    scores = {"a mocha": -3.0, "make me a mocha": -2.5}
    heard = ("making", "a", "mocha")
    first, second = Begins((), scores, {}, heard, begins=[long]), Begins((), scores, {}, heard)
    known = ranked(orders, {short: first.views([short])})
    for opinions in ([first, second], [second, first]):
        assert begun_otherwise(orders, known, opinions)[0].words == long  # type: ignore[arg-type]
    first.begins = [short]
    assert begun_otherwise(orders, known, [first, second]) == known  # type: ignore[arg-type]


@dataclass
class Finds(Scripted):
    """One that finds a sentence as likely as its words are like those heard."""

    def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
        apart = {words: letters_apart(words, self.heard) for words in sentences}
        return [View(-1.0 - apart[words] / 2, -1.0, apart[words]) for words in sentences]


@pytest.mark.parametrize(
    ("likeliest", "other", "found"),
    [
        # Each has what the other leaves out.
        ("make me a large mocha", "a large mocha with brown sugar", "make me a large mocha with brown sugar"),
        ("a large mocha with brown sugar", "make me a large mocha", "make me a large mocha with brown sugar"),
        # What is nothing of the grammar, or leaves out something all the same, is not looked at.
        ("make me a large mocha", "brew a latte", "make me a large mocha"),
        # Nor is anything else, where nothing is left out.
        ("make me a large mocha with brown sugar", "brew a large latte", "make me a large mocha with brown sugar"),
    ],
)
def test_where_the_likeliest_leaves_something_out_it_is_crossed_with_others(orders, likeliest, other, found):
    heard = ("make", "me", "a", "large", "mocha", "with", "brown", "sugar")
    opinions = [Finds((), {}, {}, heard), Finds((), {}, {}, heard)]
    known = [tuple(likeliest.split()), tuple(other.split())]
    views = {words: View(-20.0 * place, 0.0, 0.0) for place, words in enumerate(known)}
    readings = ranked(orders, {words: (view, view) for words, view in views.items()})
    assert " ".join(readings[0].words) == likeliest
    best, *_ = crossed(orders, readings, opinions)  # type: ignore[arg-type]
    assert " ".join(best.words) == found


@dataclass
class Driving(Scripted):
    """As :class:`Scripted`, of commands to drive."""

    heard: tuple[str, ...] = ("move", "forward", "one", "meter")

    @property
    def sentences(self) -> tuple[tuple[str, ...], ...]:
        return tuple(tuple(one.split()) for one in self.thought_of)

    def views(self, sentences: Sequence[tuple[str, ...]]) -> list[View]:
        self.asked += map(" ".join, sentences)
        return [View(self.scores.get(" ".join(words), -20.0), -1.0, 0.0) for words in sentences]


FORWARD, BACKWARD = "move forward one meter", "move backward one meter"


def driven(engine: IntentEngine, forward: float, backward: float) -> list[str]:
    grammar = SpokenGrammar(engine)
    model = Driving([FORWARD], {FORWARD: forward, BACKWARD: backward}, {})
    opinions = (model, model)
    readings = opposed_too(grammar, doubted(grammar, opinions), opinions)  # type: ignore[arg-type]
    assert [one.behind for one in readings] == sorted(one.behind for one in readings)
    return [" ".join(one.words) for one in readings]


def test_what_would_drive_the_other_way_is_compared_though_nobody_thought_of_it(engine):
    assert driven(engine, -1.0, -3.0)[:2] == [FORWARD, BACKWARD]
    assert driven(engine, -3.0, -1.0)[:2] == [BACKWARD, FORWARD]


def test_of_what_is_not_done_nothing_more_is_compared(engine):
    assert driven(engine, -40.0, -1.0) == [FORWARD]
