"""Intent Engine: a person speaks, a robot does it.

The names below are all that a program needs, in the order in which it meets them. Each is loaded when it is first
used, so that text is understood without audio libraries, and nothing here ever loads ROS.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from intent_engine.actions import (
        Action,
        ChangeSpeed,
        Custom,
        Move,
        Navigate,
        Pick,
        Place,
        Stop,
        Turn,
        from_json,
        to_json,
    )
    from intent_engine.engine import IntentEngine
    from intent_engine.errors import IntentEngineError, RobotError
    from intent_engine.execution.executor import Executor
    from intent_engine.execution.goal import Goal, GoalState, Reason
    from intent_engine.execution.policy import Policy
    from intent_engine.execution.robots.robot import Capability, Pose, Robot
    from intent_engine.execution.robots.simulated import SimulatedRobot
    from intent_engine.interpretation import Cause, Interpretation, Question, Status
    from intent_engine.prefix import Prefix, PrefixStatus
    from intent_engine.runtime import Runtime

__all__ = [
    "Action",
    "Capability",
    "Cause",
    "ChangeSpeed",
    "Custom",
    "Executor",
    "Goal",
    "GoalState",
    "IntentEngine",
    "IntentEngineError",
    "Interpretation",
    "Move",
    "Navigate",
    "Pick",
    "Place",
    "Policy",
    "Pose",
    "Prefix",
    "PrefixStatus",
    "Question",
    "Reason",
    "Robot",
    "RobotError",
    "Runtime",
    "SimulatedRobot",
    "Status",
    "Stop",
    "Turn",
    "__version__",
    "from_json",
    "to_json",
]

_HOMES = {
    "engine": ("IntentEngine",),
    "prefix": ("Prefix", "PrefixStatus"),
    "interpretation": ("Cause", "Interpretation", "Question", "Status"),
    "actions": (
        "Action", "Move", "Turn", "Stop", "Navigate", "Pick", "Place", "ChangeSpeed", "Custom", "from_json",
        "to_json",
    ),
    "errors": ("IntentEngineError", "RobotError"),
    "execution.executor": ("Executor",),
    "execution.policy": ("Policy",),
    "execution.goal": ("Goal", "GoalState", "Reason"),
    "execution.robots.robot": ("Robot", "Capability", "Pose"),
    "execution.robots.simulated": ("SimulatedRobot",),
    "runtime": ("Runtime",),
}  # fmt: skip
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("intent-engine")
    if name in _HOME_OF:
        value = getattr(import_module(f"intent_engine.{_HOME_OF[name]}"), name)
        globals()[name] = value
        return value
    raise AttributeError(f"module 'intent_engine' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
