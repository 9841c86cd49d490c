"""Scores and outcomes for people (table), spreadsheets (CSV) and programs (JSON)."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from intent_engine.actions import Action
from intent_engine.actions import to_json as action_to_json
from intent_engine.errors import ConfigError, Problem
from intent_engine.evaluation.labels import Expected, Step
from intent_engine.evaluation.scoring import Outcome, Score, Verdict

__all__ = [
    "MISS_COLUMNS",
    "MISS_KEYS",
    "SCORE_KEYS",
    "expected_text",
    "miss_cells",
    "miss_table",
    "misses",
    "outcome_json",
    "reflex_text",
    "score_table",
    "write_csv",
]

COLUMNS = (
    "model",
    "noise",
    "commands right",
    "95 % sure",
    "wrong",
    "missed",
    "slots right",
    "talk acted on",
    "word errors",
    "p50",
    "p90",
    "p99",
)
"""The last three: time from the end of speech to the action."""
SCORE_KEYS = 2
"""Of these at the left: which condition it is."""
MISS_COLUMNS = ("recording", "noise", "what came of it", "said", "heard", "expected", "done")
MISS_KEYS = 3
"""Of these at the left: which recording, and how it ended."""


def score_table(scores: Sequence[Score]) -> tuple[list[str], list[list[str]]]:
    """Heads and rows, one for each condition; a column that has nothing to tell is left out."""
    rows = [_cells(found) for found in scores]
    told = [index for index in range(len(COLUMNS)) if any(row[index] != "-" for row in rows)]
    return [COLUMNS[index] for index in told], [[row[index] for index in told] for row in rows]


def _cells(found: Score) -> list[str]:
    sure = "-"
    if found.accuracy_low is not None and found.accuracy_high is not None:
        sure = f"{100 * found.accuracy_low:.0f}-{100 * found.accuracy_high:.0f} %"
    return [
        found.model,
        found.noise,
        f"{_percent(found.accuracy)} ({found.right}/{found.commands})" if found.commands else "-",
        sure,
        str(found.wrong),
        str(found.missed),
        _percent(found.slot_accuracy),
        f"{found.false_accepts}/{found.others}" if found.others else "-",
        _percent(found.word_error_rate),
        _milliseconds(found.latency_p50),
        _milliseconds(found.latency_p90),
        _milliseconds(found.latency_p99),
    ]


def reflex_text(found: Score) -> str:
    """What the reflex did; empty if it did nothing and had nothing to do."""
    if not found.stops and not found.others_held:
        return ""
    text = f"{found.model}, noise {found.noise}: the reflex held the robot at {found.stops_held} of {found.stops} stops"
    if found.held_p50 is not None:
        text += f" (p50 {_milliseconds(found.held_p50)}, p90 {_milliseconds(found.held_p90)} after the end of the word)"
    rest = found.recordings - found.stops
    return f"{text}, and for a moment at {found.others_held} of {rest} other recordings"


def misses(outcomes: Sequence[Outcome]) -> list[Outcome]:
    """What did not go right, the worst kinds first."""
    order = {Verdict.WRONG: 0, Verdict.FALSE_ACCEPT: 1, Verdict.MISSED: 2}
    return sorted((one for one in outcomes if one.verdict in order), key=lambda one: order[one.verdict])


def miss_table(shown: Sequence[Outcome], every: Sequence[Outcome]) -> tuple[list[str], list[list[str]], int]:
    """Heads and rows of what went wrong, and how many columns at the left say which recording it is: by which model it
    was heard, where every outcome is not of the same.

    Args:
        shown: the rows.
        every: outcome of the run.
    """
    heads, rows = list(MISS_COLUMNS), [miss_cells(outcome) for outcome in shown]
    if len({outcome.condition.model for outcome in every}) < 2:
        return heads, rows, MISS_KEYS
    heads.insert(1, "model")
    for row, outcome in zip(rows, shown, strict=True):
        row.insert(1, outcome.condition.model)
    return heads, rows, MISS_KEYS + 1


def miss_cells(outcome: Outcome) -> list[str]:
    """One row of the table of what went wrong."""
    return [
        outcome.row.id,
        outcome.condition.noise,
        outcome.verdict.value,
        outcome.row.text or "",
        outcome.heard,
        expected_text(outcome.row.expected),
        _done_text(outcome),
    ]


def expected_text(expected: Expected) -> str:
    """What a label wants, with its values: actions where it has them, else intents and slots."""
    listed: list[str] = []
    if expected.steps and not expected.by_text:
        listed.append(_steps_text(expected.steps))
    if expected.actions:
        listed.append(_actions_text(expected.actions))
    if expected.types:
        listed.append("; ".join(expected.types))
    return " and ".join(listed) or "nothing"


def _done_text(outcome: Outcome) -> str:
    """What was done, in the terms of its label."""
    expected = outcome.row.expected
    if expected.steps and expected.actions is None and expected.types is None and outcome.steps:
        return _steps_text(outcome.steps)
    return _actions_text(outcome.actions) or ", ".join(outcome.intents) or "nothing"


def _steps_text(steps: Sequence[Step]) -> str:
    return "; ".join(_named(step.intent, step.slots) for step in steps)


def _actions_text(actions: Sequence[Action]) -> str:
    return "; ".join(_action(action_to_json(action)) for action in actions)


def _expected_json(expected: Expected) -> dict[str, Any]:
    wanted: list[Any] | None = None
    if expected.types is not None:
        wanted = list(expected.types)
    elif expected.actions is not None:
        wanted = [action_to_json(action) for action in expected.actions]
    elif not expected.steps:
        wanted = []  # no command
    return {"steps": [{"intent": step.intent, "slots": dict(step.slots)} for step in expected.steps], "actions": wanted}


def outcome_json(outcome: Outcome) -> dict[str, Any]:
    """One recording in one condition."""
    latency = outcome.latency
    return {
        "recording": outcome.row.id,
        "line": outcome.row.line,
        "model": outcome.condition.model,
        "snr": outcome.condition.snr,
        "verdict": outcome.verdict.value,
        "text": outcome.row.text,
        "heard": outcome.heard,
        "free": outcome.free,
        "alternatives": [one for heard in outcome.transcripts for one in heard.alternatives_to_json()],
        "expected": _expected_json(outcome.row.expected),
        "intents": list(outcome.intents),
        "actions": [action_to_json(action) for action in outcome.actions],
        "slots": outcome.slots,
        "slots_right": outcome.slots_right,
        "latency": round(latency, 4) if latency is not None else None,
        "decode_seconds": round(outcome.decode, 4),
        "held": round(outcome.held, 4) if outcome.held is not None else None,
        "held_at": round(outcome.held_at, 4) if outcome.held_at is not None else None,
        "errors": list(outcome.errors),
    }


def write_csv(path: Path, outcomes: Sequence[Outcome]) -> None:
    """Every recording in every condition, one a line; lists are joined by ``; ``.

    Raises:
        ConfigError: the file cannot be written.
    """
    rows = [
        {
            **outcome_json(outcome),
            "alternatives": [text for heard in outcome.transcripts for text in heard.alternatives],
            "expected": expected_text(outcome.row.expected),
        }
        for outcome in outcomes
    ]
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]) if rows else [])
            writer.writeheader()
            for row in rows:
                writer.writerow({key: _cell(value) for key, value in row.items()})
    except OSError as error:
        raise ConfigError(Problem(f"cannot be written: {error.strerror or error}", str(path))) from None


def _cell(value: Any) -> Any:
    if isinstance(value, list):
        value = "; ".join(item if isinstance(item, str) else _action(item) for item in value)
    if isinstance(value, str) and value.lstrip()[:1] in ("=", "+", "-", "@"):
        return f"'{value}"  # a spreadsheet would run it as a formula, and what was heard is anybody's
    return value


def _action(data: dict[str, Any]) -> str:
    return _named(data["type"], {name: value for name, value in data.items() if name != "type"})


def _named(name: str, values: Mapping[str, Any]) -> str:
    rest = (f"{key}={value:.4g}" if isinstance(value, float) else f"{key}={value}" for key, value in values.items())
    return " ".join([name, *rest])


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100 * share:.1f} %"


def _milliseconds(seconds: float | None) -> str:
    return "-" if seconds is None else f"{1000 * seconds:.0f} ms"
