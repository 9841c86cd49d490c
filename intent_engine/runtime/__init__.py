"""From sound to robot: what leads from one room to the next.

:class:`Runtime` wires it. The names below are loaded when they are first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from intent_engine.runtime.heard import Heard, HeardKind, Summary
    from intent_engine.runtime.runtime import Runtime

__all__ = ["Heard", "HeardKind", "Runtime", "Summary"]

_HOME_OF = {"Heard": "heard", "HeardKind": "heard", "Runtime": "runtime", "Summary": "heard"}


def __getattr__(name: str) -> Any:
    if name in _HOME_OF:
        return getattr(import_module(f"intent_engine.runtime.{_HOME_OF[name]}"), name)
    raise AttributeError(f"module 'intent_engine.runtime' has no attribute {name!r}")
