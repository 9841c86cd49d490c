"""A second language is a YAML file: the German grammar, by its own examples and by what must never move a robot."""

from __future__ import annotations

import pytest
from meanings import german

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.checker import check_grammar
from intent_engine.testing.examples import grammar_cases, run_case


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return german()


def test_its_examples_hold(engine):
    outcomes = [run_case(engine, case) for case in grammar_cases(engine)]
    assert len(outcomes) > 30
    assert [(outcome.case.text, outcome.differences) for outcome in outcomes if not outcome.passed] == []


def test_it_has_no_errors_or_warnings(engine):
    report = check_grammar(engine.grammar, engine.locations)
    assert [str(one.problem) for one in report.findings if one.level != "note"] == []
    assert report.figures.complete


@pytest.mark.parametrize("word", ["nicht", "nie", "niemals"])
def test_a_negation_anywhere_moves_nothing(engine, word):
    for case in grammar_cases(engine):
        if case.status is not Status.ACCEPTED or "nein" in case.text or "meine" in case.text:
            continue  # what is corrected may well follow a refusal: "not left, no, right"
        words = case.text.split()
        for place in range(len(words) + 1):
            found = engine.parse(" ".join([*words[:place], word, *words[place:]]))
            assert all(isinstance(action, Stop) for action in found.actions), found


@pytest.mark.parametrize(
    "text", ["stopp", "Halt!", "stopp stopp stopp", "nein stopp", "fahr vorwärts stopp", "Nothalt"]
)
def test_stop_stops(engine, text):
    assert engine.parse(text, state=("moving",)).actions == (Stop(),)


@pytest.mark.parametrize("text", ["nein warte", "nein, nein, warte", "moment, warte", "warte warte"])
def test_who_protests_is_heard(engine, text):
    assert engine.parse(text).actions == (Stop(),)


def test_while_it_moves_a_stop_after_anything_stops_it(engine):
    text = "du fährst gegen die Wand halt an"
    assert engine.parse(text, state=("moving",)).actions == (Stop(),)
    assert not engine.parse(text).actions


@pytest.mark.parametrize(
    "text",
    [
        "ich war gestern in der Küche",
        "der Zug fährt nach rechts ab",
        "was ist vorwärts",
        "wenn du Zeit hast fahr vorwärts",
        "fahr in den Keller",
        "fahr zwei Kilogramm vorwärts",
    ],
)
def test_what_is_no_command_moves_nothing(engine, text):
    assert engine.parse(text).actions == ()


@pytest.mark.parametrize(
    "text",
    ["fahr zwei Meter vor und dreh dich dann nach rechts", "fahr zwei Meter vor, dann dreh dich nach rechts"],
)
def test_several_commands(engine, text):
    first, second = engine.parse(text).actions
    assert (first.distance, second.angle < 0) == (2.0, True)


def test_both_languages_at_once(root):
    engine = IntentEngine.from_files(
        [root / "grammars/en.yaml", root / "grammars/de.yaml"],
        locations=[root / "locations/home.yaml", root / "locations/zuhause.yaml"],
    )
    assert engine.languages == ("en", "de")
    for text, place in (("go to the kitchen", "kitchen"), ("fahr in die Küche", "küche")):
        (action,) = engine.parse(text).actions
        assert action.location == place
    assert engine.parse("fahr in die Küche", language="en").actions == ()


def test_the_command_line_knows_it_by_its_language(intent_engine):
    done = intent_engine("parse", "--language", "de", "--locations", "zuhause", "fahr bitte zwei Meter vorwärts")
    assert done.returncode == 0
    assert "move forward 2.00 m" in done.stdout
