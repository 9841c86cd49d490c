"""The table of docs/safety.md, "Said against what it does": what each text makes a robot do that moves."""

from __future__ import annotations

import pytest
from page_tables import quoted, rows

from intent_engine import IntentEngine, Stop

PAGE = "safety.md"
ROWS = [pytest.param(row, id=f"{PAGE}:{row.line}") for row in rows(PAGE) if row.head[-1] == "then it"]
PLACES = dict.fromkeys(["kitchen", "bar", "lab"], (0.0, 0.0, 0.0))


@pytest.fixture(scope="module")
def engine():
    return IntentEngine.from_files("en", locations=PLACES)


@pytest.mark.parametrize("row", ROWS)
def test_what_is_said_against_what_a_robot_does(row, engine):
    does, said, then = row.cells
    last = engine.parse(quoted(does)[0])
    assert last.actions
    assert quoted(said)
    for text in quoted(said):
        found = engine.parse(text, state=["moving"], last=last)
        stops = found.stops or any(action in found.denied for action in last.actions)
        assert stops == then.startswith("stops"), (text, found)
        instead = quoted(then)
        wanted = engine.parse(instead[0]).actions if instead else ()
        assert tuple(action for action in found.actions if action != Stop()) == wanted, text
