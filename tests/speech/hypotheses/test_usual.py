"""Which numbers people say, and what that is worth beside what was heard."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.evidence import View
from intent_engine.speech.hypotheses.ranking import ranked
from intent_engine.speech.hypotheses.spoken_grammar import UNUSUAL, SpokenGrammar
from intent_engine.speech.hypotheses.usual import UsualNumbers

GRAMMAR = """
language: en
slots:
  level: {type: percent, usual_step: 10 percent}
  far: {type: distance, unit: m, usual_step: 2}
  near: {type: distance}
  turned: {type: angle, usual_step: [5 deg, 45 deg]}
  wide: {type: distance, usual_max: 20 m}
  count: {type: number}
  boost: {type: percent, max: 300 percent}
  blend: {type: percent, usual_max: 400 percent}
intents:
  dim: {action: {type: custom}, sentences: ["dim to {level}", "dim {level:much} more"]}
  swim: {action: {type: custom}, sentences: ["swim {far}", "swim back {near:far}"]}
  spin: {action: {type: custom}, sentences: ["spin {turned}"]}
  wade: {action: {type: custom}, sentences: ["wade {wide}"]}
  hop: {action: {type: custom}, sentences: ["hop {count} times"]}
  boost: {action: {type: custom}, sentences: ["boost to {boost}", "blend {blend}"]}
  dive: {action: {type: custom}, regex: "dive to (?P<level>.+)"}
"""


@pytest.fixture(scope="module")
def own(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def unusual(engine: IntentEngine, text: str) -> int:
    meaning = engine.parse(text)
    assert meaning.actions, meaning.reason
    return UsualNumbers(engine.matcher().grammar).unusual(meaning)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("dim to 40 percent", 0),
        ("dim to 14 percent", 1),
        ("dim 40 percent more", 0),
        ("dim 14 percent more", 1),
        ("swim 4 meters", 0),
        ("swim 4", 0),
        ("swim 3", 1),
        ("swim 400 centimeters", 0),
        ("swim a meter and a half", 1),
        ("wade 20 meters", 0),
        ("wade 21 meters", 1),
        ("wade 99 meters", 1),
        ("wade 101 meters", 2),
        ("wade 1000 meters", 3),
        ("spin ninety degrees", 0),
        ("spin a hundred degrees", 1),
        ("spin ninety two degrees", 2),
        ("hop 17 times", 0),
        ("dim to a hundred percent", 0),
        ("dim to 110 percent", 1),  # nothing is more than a whole,
        ("dim to 2000 percent", 2),
        ("boost to 200 percent", 0),  # unless its slot says so
        ("blend 200 percent", 0),
        ("dive to 14 percent", 1),
        ("dim to 14 percent and then dim to 40 percent and swim 3 meters", 2),
    ],
)
def test_numbers_beside_their_step(own, text, count):
    assert unusual(own, text) == count


@given(st.integers(1, 144), st.sampled_from(["degrees", "deg", "°"]), st.sampled_from(["left", "right"]))
def test_every_fifth_degree_is_usual_and_every_fortyfifth_more_so(engine, fifth, unit, side):
    assert unusual(engine, f"turn {side} {5 * fifth} {unit}") == int(fifth % 9 != 0)
    if fifth < 144:
        assert unusual(engine, f"turn {side} {5 * fifth + 1} {unit}") == 2


def test_a_step_in_rad_is_one_in_degrees(engine):
    assert unusual(engine, "a quarter turn to the left") == 0
    assert unusual(engine, "turn left a little") == 0


SIXTY, SIXTEEN = (("turn", "left", number, "degrees") for number in ("sixty", "sixteen"))


@given(st.floats(-40, 0), st.floats(-8, 8))
def test_of_two_numbers_the_usual_one_is_likelier_until_the_other_was_heard_far_more_clearly(engine, score, ahead):
    def views(behind: float) -> tuple[View, View]:
        return (View(score + behind, score, 0.0),) * 2

    best, _ = ranked(SpokenGrammar(engine), {SIXTY: views(0.0), SIXTEEN: views(ahead)})
    assert best.words == (SIXTEEN if ahead > UNUSUAL else SIXTY) or ahead == pytest.approx(UNUSUAL)
    assert best.evidence.margin == pytest.approx(min(8.0, abs(ahead - UNUSUAL)))


def test_a_number_that_is_alone_costs_nothing(engine):
    """Whoever wants sixteen degrees gets them as surely as sixty."""
    found = [ranked(SpokenGrammar(engine), {words: (View(-2.0, -2.0, 0.0),)}) for words in (SIXTY, SIXTEEN)]
    assert found[0][0].evidence == found[1][0].evidence


def test_more_than_a_circle_is_less_likely(engine):
    grammar = SpokenGrammar(engine)
    said = [grammar.parse(f"turn left {angle} degrees") for angle in (355, 360, 365, 356, 366)]
    assert [grammar.unusual(one) / UNUSUAL for one in said] == [1, 0, 2, 2, 3]


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("dim to two thousand percent", False),
        ("dim to two thirds", True),
        ("boost to two hundred percent", True),
        ("blend five hundred percent", True),  # said of what has a limit of its own
        ("wade a hundred meters", True),
    ],
)
def test_more_than_a_whole_may_be_another_number_though_it_was_heard_word_by_word(own, text, plain):
    assert SpokenGrammar(own).plain(text.split(), own.parse(text)) is plain
