"""What a program gave to a runtime, looked at before anything is heard: a reflex that is none would be found out at the
first word, when it should hold the robot.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from pathlib import PurePath
from types import FunctionType

from intent_engine.execution.given import check_awaitless, check_listener, check_number
from intent_engine.speech.endpoint import Settings

__all__ = ["check_parts"]

_NO_PART = (str, Real, PurePath, Mapping, Sequence, type, FunctionType)
_PARTS = {
    "recognizer": "recognizer_for(engine, 'base') of intent_engine.speech.models, or None",
    "voice": "SileroVoice(), or None",
    "reflex": "reflex_for(engine) of intent_engine.speech.reflex, or None",
    "noise_filter": "'auto', None or a noise filter",
}


def check_parts(settings: object, on_event: object, state: object, patience: object, **parts: object) -> None:
    """See that what a runtime is made of can be that; None: it was not given.

    Raises:
        TypeError: it cannot; says what can.
        ValueError: ``patience`` is below zero, or NaN.
    """
    for name, part in parts.items():
        auto = name == "noise_filter" and part == "auto"
        if part is not None and not auto and isinstance(part, _NO_PART):
            raise TypeError(f"{name} is {_PARTS[name]}, not {part!r:.80}")
    if settings is not None and not isinstance(settings, Settings):
        where = "Settings(wait_complete=0.3) of intent_engine.speech.endpoint"
        raise TypeError(f"settings are {where}, not {settings!r:.80}")
    if on_event is not None:
        check_listener("on_event", on_event)
    if state is not None and not callable(state):
        raise TypeError(f"state is a function that tells the states, not {state!r:.80}: lambda: {state!r:.80}")
    if state is not None:
        check_awaitless("state", state)
    check_number("patience", patience)
