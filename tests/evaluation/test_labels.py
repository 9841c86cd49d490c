"""What recordings mean."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.labels import Expected, Row, Step, evenly, steps_in, steps_of


@pytest.mark.parametrize("limit", [1, 2, 7, 10, 11, None])
def test_a_limit_takes_rows_from_all_over_the_file(limit):
    rows: list[Row] = list(range(10))  # type: ignore[arg-type]
    taken = evenly(rows, limit)
    assert len(taken) == min(limit or 10, 10)
    assert taken == sorted(set(taken))
    assert taken[0] == 0
    assert limit != 2 or taken == [0, 5]


@pytest.mark.parametrize(
    ("text", "intents"),
    [
        ("go forward two meters", ["move"]),
        ("go forward two meters and turn left", ["move", "turn"]),
        ("what a day", []),
        ("don't turn left", []),
    ],
)
def test_the_commands_of_a_text(root, text, intents):
    engine = IntentEngine.from_files(root / "grammars" / "en.yaml")
    assert [step.intent for step in steps_of(engine.parse(text))] == intents


@pytest.mark.parametrize("slots", [{}, {"steps": 1}, {"steps": [1]}, {"steps": [{"slots": {}}]}])
def test_steps_in_another_form_are_an_error(slots):
    with pytest.raises((KeyError, TypeError, AttributeError)):
        steps_in(slots)


@pytest.mark.parametrize(
    ("expected", "command"),
    [
        (Expected(), False),
        (Expected(actions=()), False),
        (Expected((Step("stop"),)), True),
        (Expected(types=("move",)), True),
    ],
)
def test_whether_anything_is_to_be_done(expected, command):
    assert expected.command is command
