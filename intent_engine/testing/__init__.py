"""For tests of grammars and of programs that use the engine.

``sentences`` needs Hypothesis, and the plugin pytest: ``pip install intent-engine[testing]``. Each name is loaded when
it is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from intent_engine.execution.clock import VirtualClock
    from intent_engine.testing.comparison import assert_means, difference_table, differences, moves
    from intent_engine.testing.noise import Noise
    from intent_engine.testing.robots import Command, RecordingRobot
    from intent_engine.testing.strategies import Sentence, sentences

__all__ = [
    "Command",
    "Noise",
    "RecordingRobot",
    "Sentence",
    "VirtualClock",
    "assert_means",
    "difference_table",
    "differences",
    "moves",
    "sentences",
]

_HOMES = {
    "testing.strategies": ("Sentence", "sentences"),
    "testing.noise": ("Noise",),
    "testing.comparison": ("assert_means", "difference_table", "differences", "moves"),
    "testing.robots": ("Command", "RecordingRobot"),
    "execution.clock": ("VirtualClock",),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'intent_engine.testing' has no attribute {name!r}")
    try:
        value = getattr(import_module(f"intent_engine.{_HOME_OF[name]}"), name)
    except ModuleNotFoundError as error:
        if error.name != "hypothesis":
            raise
        raise ModuleNotFoundError(
            f"intent_engine.testing.{name} needs Hypothesis: pip install 'intent-engine[testing]'", name=error.name
        ) from None
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
