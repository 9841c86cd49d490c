"""Whether an action that shall not be done is the one that is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from intent_engine.actions import Action, Custom

__all__ = ["denies"]


def denies(denied: Action, done: Action) -> bool:
    """Whether what is done is what was denied, in all that was said of it: "don't put the cup down" is any place, and
    "don't clean" any room."""
    if type(denied) is not type(done):
        return False
    if isinstance(denied, Custom) and isinstance(done, Custom):
        return denied.name == done.name and _within(denied.slots, done.slots)
    return _within(_said(denied), _said(done))


def _said(action: Action) -> Mapping[str, Any]:
    return {each.name: getattr(action, each.name) for each in fields(action)}


def _within(denied: Mapping[str, Any], done: Mapping[str, Any]) -> bool:
    return all(value is None or (name in done and done[name] == value) for name, value in denied.items())
