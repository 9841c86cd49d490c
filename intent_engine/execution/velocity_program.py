"""How the process that owns the velocity is started: what it drives, within which limits, and what it is told."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Rates

__all__ = ["VelocityProgram"]

_RAMPS = ("linear_acceleration", "linear_deceleration", "angular_acceleration", "angular_deceleration")


@dataclass(frozen=True, slots=True)
class VelocityProgram:
    """What :mod:`~intent_engine.execution.velocity_loop` is run with."""

    sink: str
    """What it drives, as ``package.module:name``."""
    options: Mapping[str, Any]
    """Arguments of that, of JSON types."""
    limits: Limits
    rates: Rates
    priority: int
    """Of SCHED_FIFO; 0: ordinary scheduling."""
    pass_fds: tuple[int, ...]
    """Descriptors that the sink needs."""

    def start(self, line: socket.socket) -> subprocess.Popen[bytes]:
        """A process that speaks with this one through a socket; OSError: there could be none."""
        settings = {
            "sink": self.sink,
            "options": self.options,
            "line": line.fileno(),
            "parent": os.getpid(),
            "limits": {name: getattr(self.limits, name) for name in _RAMPS if getattr(self.limits, name) is not None},
            "rates": asdict(self.rates),
            "priority": self.priority,
        }
        return subprocess.Popen(
            [sys.executable, "-m", "intent_engine.execution.velocity_loop", json.dumps(settings)],
            stdin=subprocess.DEVNULL,
            pass_fds=(line.fileno(), *self.pass_fds),
            # Not in the terminal's foreground: Ctrl-Z would freeze the program and its guardian at once.
            process_group=0,
        )
