"""What the nodes say on their topics, as text. No ROS in here."""

from __future__ import annotations

import json
from enum import StrEnum
from typing import Any

from intent_engine.actions import to_json
from intent_engine.execution.events import Event, EventKind
from intent_engine.interpretation import Interpretation, Status

__all__ = ["CommandForm", "command_texts", "event_text", "interpretation_text", "status_text"]


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


def status_text(event: str, time: float, **data: Any) -> str:
    """One message of ``voice_commands/status``."""
    return json.dumps({"event": event, "time": round(time, 3), **data})
