"""Two meanings side by side: what a test compares, and how it tells what differs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from intent_engine.actions import Action, Stop, to_json
from intent_engine.interpretation import Interpretation, Status

__all__ = ["Difference", "assert_means", "difference_table", "differences", "moves"]

RELATIVE_TOLERANCE = 1e-6
"""Two SI values are the same within this. Unit factors are exact to 1e-15; a person writes six digits of a radian."""
ABSENT = "(none)"


@dataclass(frozen=True, slots=True)
class Difference:
    """One part of a meaning that is not as expected."""

    part: str
    """``status``, ``intent``, ``slots.<label>`` or ``actions``."""
    expected: str
    found: str


def moves(found: Interpretation) -> bool:
    """Whether anything would be done but stopping.

    Raises:
        TypeError: it is no interpretation.
    """
    if not isinstance(found, Interpretation):
        raise TypeError(f"moves takes an Interpretation, not {found!r:.80}: {_instead(found)}")
    return any(not isinstance(action, Stop) for action in found.actions)


def differences(expected: Interpretation, found: Interpretation) -> tuple[Difference, ...]:
    """What differs in meaning; empty if nothing does. Text, confidence, alternatives and reason are no meaning.

    Of what is expected not to be accepted, only the status and the empty actions are compared.

    Raises:
        TypeError: one of them is no interpretation.
    """
    _two_meanings("differences", expected=expected, found=found)
    rows = []
    if expected.status is not found.status:
        rows.append(Difference("status", expected.status.value, _status(found)))
    if expected.status is Status.ACCEPTED:
        if expected.intent != found.intent:
            rows.append(Difference("intent", str(expected.intent), str(found.intent)))
        rows.extend(slot_differences(expected.slots, found.slots))
    if (expected.actions or expected.status is not Status.ACCEPTED) and not _same(
        _plain(expected.actions), _plain(found.actions)
    ):
        rows.append(actions_difference(expected.actions, found.actions))
    return tuple(rows)


def actions_difference(expected: Sequence[Action], found: Sequence[Action]) -> Difference:
    """Told of actions that are others than those expected."""
    return Difference("actions", _actions(expected), _actions(found))


def slot_differences(expected: Mapping[str, Any], found: Mapping[str, Any]) -> list[Difference]:
    """The slots that differ, by name; in the order in which they are expected."""
    rows = []
    for label in dict.fromkeys((*expected, *found)):
        wanted, got = expected.get(label), found.get(label)
        if (label in expected) != (label in found) or not _same(wanted, got):
            rows.append(Difference(f"slots.{label}", _shown(expected, label), _shown(found, label)))
    return rows


def difference_table(rows: Sequence[Difference]) -> str:
    """The differences as lines for a person, in columns."""
    cells = [("", "expected", "found"), *((row.part, row.expected, row.found) for row in rows)]
    widths = [max(len(cell[column]) for cell in cells) for column in range(2)]
    return "\n".join(f"{a:<{widths[0]}}  {b:<{widths[1]}}  {c}".rstrip() for a, b, c in cells)


def assert_means(found: Interpretation, expected: Interpretation) -> None:
    """Fail with a table of what differs, unless two interpretations mean the same.

    Raises:
        AssertionError: they do not.
        TypeError: one of them is no interpretation.
    """
    _two_meanings("assert_means", found=found, expected=expected)
    rows = differences(expected, found)
    if rows:
        raise AssertionError(f"{found.text!r} is understood otherwise\n{difference_table(rows)}")


def _two_meanings(name: str, **given: object) -> None:
    for which, one in given.items():
        if not isinstance(one, Interpretation):
            what = f"{which} is {one!r:.80}"
            raise TypeError(f"{name}({', '.join(given)}) compares two Interpretations, but {what}: {_instead(one)}")


def _instead(given: object) -> str:
    """What to write in the place of something that is no interpretation."""
    if isinstance(given, str):
        return f"give engine.parse({given!r:.60})"
    if isinstance(given, Mapping) and "status" in given:
        return "give Interpretation.from_json(...) of it"
    if isinstance(given, Mapping):
        return "compare slots with found.slots, or give an Interpretation that has them"
    if isinstance(given, Sequence | Action):
        return "compare actions with found.actions, or give an Interpretation that has them"
    return "give what engine.parse(text) returns"


def _same(wanted: Any, got: Any) -> bool:
    if isinstance(wanted, bool) or isinstance(got, bool):
        return wanted is got
    if isinstance(wanted, (int, float)) and isinstance(got, (int, float)):
        return math.isclose(wanted, got, rel_tol=RELATIVE_TOLERANCE, abs_tol=1e-12)
    if isinstance(wanted, Mapping) and isinstance(got, Mapping):
        return wanted.keys() == got.keys() and all(_same(wanted[key], got[key]) for key in wanted)
    if isinstance(wanted, (list, tuple)) and isinstance(got, (list, tuple)):
        return len(wanted) == len(got) and all(map(_same, wanted, got))
    return bool(wanted == got)


def _plain(actions: Sequence[Action]) -> list[dict[str, Any]]:
    return [to_json(action) for action in actions]


def _actions(actions: Sequence[Action]) -> str:
    return "; ".join(_action(action) for action in actions) or ABSENT


def _action(action: Action) -> str:
    values = ", ".join(f"{key}={_value(value)}" for key, value in to_json(action).items() if key != "type")
    return f"{action.type}({values})"


def _status(found: Interpretation) -> str:
    if found.status is Status.ACCEPTED:
        return f"{found.status.value} ({found.intent})"
    return f"{found.status.value} ({found.reason})" if found.reason else found.status.value


def _shown(slots: Mapping[str, Any], label: str) -> str:
    return _value(slots[label]) if label in slots else ABSENT


def _value(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
