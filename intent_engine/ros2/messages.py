"""What the nodes say on their topics, as text. No ROS in here."""

from __future__ import annotations

import json
from collections.abc import Collection
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Any

from intent_engine.actions import Stop, json_schema, to_json
from intent_engine.execution.events import Event, EventKind
from intent_engine.execution.goal import GoalState
from intent_engine.interpretation import Interpretation, Status

__all__ = [
    "CommandForm",
    "action_message_schema",
    "action_text",
    "command_texts",
    "event_text",
    "interpretation_text",
    "status_text",
]


class CommandForm(StrEnum):
    """How an understood command is published on ``voice_commands/command``."""

    JSON = "json"
    """The interpretation as JSON: intent, slots, actions in SI units."""
    TUTORIAL = "tutorial"
    """``intent:what was said``, as the tutorials have it: ``navigate:go to the kitchen``."""


def command_texts(found: Interpretation, form: CommandForm) -> list[str]:
    """The messages that an interpretation is published as; none unless it was accepted.

    In the tutorials' form each step of a compound command is a message of its own, in the order said.
    """
    if found.status is not Status.ACCEPTED:
        return []
    if form is CommandForm.JSON:
        return [json.dumps(found.to_json())]
    steps = found.slots.get("steps")
    intents = [step["intent"] for step in steps] if isinstance(steps, list) else [found.intent]
    return [f"{intent}:{found.text}" for intent in intents]


def interpretation_text(found: Interpretation, time: float) -> str:
    """What ``voice_commands/status`` says of a text that came in, understood or not."""
    return status_text("interpretation", time, interpretation=found.to_json())


def event_text(event: Event, time: float) -> str:
    """What ``voice_commands/status`` says of an event of the executor.

    Args:
        event: whatever it told.
        time: s, of the node's clock.
    """
    data = event.to_json()
    del data["event"], data["time"]
    if event.kind is EventKind.GOAL and event.goal is not None:
        data["action"] = to_json(event.goal.action)
    return status_text(event.kind.value, time, **data)


def action_text(event: Event, handed_over: Collection[str]) -> str | None:
    """What ``voice_commands/action`` says of an event of the executor to those who do actions for it; None: nothing.

    An action whose turn has come is said as it is, and what is to end as ``stop`` (all of it) or as ``cancel`` with the
    actions that were denied. All three come from the executor's events and so in the order in which they happened: a
    cancel cannot overtake the action that it ends.

    Args:
        event: whatever it told.
        handed_over: types of the actions that others do.
    """
    if event.kind is EventKind.GOAL and event.goal is not None and event.state is GoalState.EXECUTING:
        action = event.goal.action
        return json.dumps(to_json(action)) if action.type in handed_over else None
    if event.kind in (EventKind.STOP, EventKind.ESTOP):
        return json.dumps(to_json(Stop()))
    denied = [to_json(action) for action in event.denied if action.type in handed_over]
    return json.dumps({"type": "cancel", "actions": denied}) if denied else None


@cache
def action_message_schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of one message on ``voice_commands/action``, that of the actions included."""
    text = (Path(__file__).parent / "action_message.schema.json").read_text("utf-8")
    schema: dict[str, Any] = json.loads(text)
    return {**schema, "$defs": {"actions": json_schema()}}


def status_text(event: str, time: float, **data: Any) -> str:
    """One message of ``voice_commands/status``."""
    return json.dumps({"event": event, "time": round(time, 3), **data})
