"""The journal: a line of JSON for everything that was done, with its times and its reason."""

from __future__ import annotations

import contextlib
import json
import logging
import logging.handlers
import os
import time
from pathlib import Path
from types import TracebackType
from typing import Any

from intent_engine.errors import ConfigError
from intent_engine.execution.events import Event, EventKind
from intent_engine.values import check_path

__all__ = ["Journal"]

log = logging.getLogger(__name__)


class Journal:
    """Writes events of an executor to a file, for ``Executor(robot, journal=Journal(path))``.

    A line for each goal that ended (action, state, reason, and its times) and one for each stop, emergency stop, hold,
    release, pause, resume, reset, denial and error. Each line has ``at``, the time of day in UTC; all other times are
    seconds on the executor's clock. The file is rotated by size; a full disk or a lost folder is told once in the
    log, and the robot drives on.

    Args:
        path: of the file; folders are made.
        max_bytes: size at which the file becomes ``path.1``, the one before it ``path.2``, ...
        backups: how many older files are kept.

    Raises:
        ConfigError: the file cannot be written.
    """

    def __init__(self, path: str | os.PathLike[str], max_bytes: int = 1_000_000, backups: int = 5) -> None:
        check_path("a journal", path)
        self.path = Path(path)
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = _Rotating(self.path, maxBytes=max_bytes, backupCount=backups, encoding="utf-8")
        except OSError as error:
            raise ConfigError(f"{path}: the journal cannot be written: {error.strerror}") from None

    def __call__(self, event: Event) -> None:
        """Take one event of an executor."""
        data: dict[str, Any]
        if event.kind is EventKind.GOAL:
            if event.goal is None or event.state is None or not event.state.ended:
                return
            data = {"event": "goal", **event.goal.to_json()}
        elif event.kind is EventKind.FEEDBACK:
            return
        else:
            data = event.to_json()
        self.write(data)

    def write(self, data: dict[str, Any]) -> None:
        """Write one line; for what else a program wants to keep beside the actions."""
        seconds, milliseconds = divmod(time.time_ns() // 1_000_000, 1000)
        at = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime(seconds)) + f".{milliseconds:03d}Z"
        line = json.dumps({"at": at, **data}, default=str)
        self._file.emit(logging.LogRecord("journal", logging.INFO, "", 0, line, None, None))

    def close(self) -> None:
        """Idempotent; a line that comes later opens the file again."""
        with contextlib.suppress(OSError):  # of a full disk was told when the line was written
            self._file.close()

    def __enter__(self) -> Journal:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


class _Rotating(logging.handlers.RotatingFileHandler):
    """The standard library's rotation, that reports trouble once and goes on."""

    _told = False

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 (the library's name)
        if not self._told:
            self._told = True
            log.exception("the journal %s cannot be written; driving goes on", self.baseFilename)
