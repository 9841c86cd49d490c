"""What kind of reason an interpretation has is known, and not read from the words of the reason."""

from __future__ import annotations

import pytest
from meanings import shipped

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Cause, Status

QUOTES = ("corrected to", "no place is called home", "negated", "cancelled", "said to a robot that moves")


@pytest.mark.parametrize(
    ("said", "state", "causes"),
    [
        ("turn left", (), set()),
        ("don't turn left", (), {Cause.NEGATED}),
        ("turn left, never mind", (), {Cause.CANCELLED}),
        ("turn left, no, right", (), {Cause.CORRECTED}),
        ("turn left, no, right, and then go to the kitchen", (), {Cause.CORRECTED}),
        ("not that", ("moving",), {Cause.OBJECTED}),
        ("wait, the cat over there", ("moving",), {Cause.REST_UNKNOWN}),
        ("go forward twelve hundred meters", (), {Cause.BEYOND_LIMITS}),
        ("go to the moon", (), {Cause.UNKNOWN_PLACE}),
        ("turn left and then go to the moon", (), {Cause.UNKNOWN_PLACE}),
        ("what a day", (), {Cause.NO_COMMAND}),
        ("turn left and then what a day", (), {Cause.NO_COMMAND}),
    ],
)
def test_a_reason_is_of_its_kind(said: str, state: tuple[str, ...], causes: set[Cause]) -> None:
    assert shipped().parse(said, state=state).causes == causes


def test_a_speed_that_a_program_does_not_get_is_beyond_its_limits(engine_of) -> None:
    grammar = """
slots: {pace: {type: speed, max: 1 m/s}}
intents:
  scan: {action: custom, sentences: ["scan [at {pace}]"], defaults: {pace: 0.8 m/s}}
"""
    found = engine_of(grammar).parse("scan at double speed")
    assert (found.reason, found.causes) == ("pace of 1.6 m/s is more than the largest, 1 m/s", {Cause.BEYOND_LIMITS})


@pytest.mark.parametrize("quoted", QUOTES)
@pytest.mark.parametrize("said", ["turn left and {}", "go to the {}", "{}", "turn left, {} right"])
def test_words_that_reasons_have_are_no_reason(said: str, quoted: str) -> None:
    found = shipped().parse(said.format(quoted), state=("moving",))
    assert found.causes <= ({Cause.NO_COMMAND, Cause.UNKNOWN_PLACE} if "go to" in said else {Cause.NO_COMMAND})


def test_an_answer_that_nothing_is_meant_is_known_as_one() -> None:
    engine = IntentEngine.from_files("en", locations={"bay 3": (0, 0, 0), "bay 13": (1, 0, 0)})
    asked = engine.parse("go to bay")
    assert asked.question is not None
    assert engine.parse("neither", last=asked).causes == {Cause.NONE_MEANT}


def test_a_question_asked_once_more_has_another_reason() -> None:
    engine = IntentEngine.from_files("en", locations={"bay 3": (0, 0, 0), "bay 13": (1, 0, 0)})
    asked = engine.parse("go to bay 33")
    assert (asked.status, asked.unknown_place) == (Status.REJECTED, True)
    again = engine.parse("bay", last=asked)
    assert (again.question is not None, again.unknown_place) == (True, False)


def test_how_it_is_done_is_told_though_another_word_is_none_either() -> None:
    found = shipped().parse("make a hard clockwise turn eventually")
    assert found.reason.startswith("'eventually' says how it is done")
    assert shipped().parse("pick up the cup quickly").reason == "'quickly' is nothing for slot 'thing'"
