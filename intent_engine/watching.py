"""Reload an engine when its files change: the new grammar is taken as a whole, or the old one stays."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from intent_engine.errors import ConfigError, Problem

if TYPE_CHECKING:
    from types import TracebackType

    from intent_engine.engine import IntentEngine

__all__ = ["Watcher"]

DEBOUNCE_MS = 100
"""Changes within this are taken together: an editor writes a file in several steps."""

RETRY_SECONDS = 2.0
"""After the system refused to watch."""

_log = logging.getLogger(__name__)


def _paths(file: Path) -> tuple[Path, Path]:
    """A file by its own name and, if it is a link, by that of what it leads to: either may change."""
    return file.absolute(), file.resolve()


class Watcher:
    """Watches the files of an engine in a thread of its own.

    Life cycle: made -> ``start`` -> ``close``; or a ``with``. Both may be called twice.

    Args:
        engine: made from files.
        told: called after each attempt, from the watcher's thread: with None when the new grammar is in use, with the
            error when it was refused and the old one stays.
    """

    def __init__(self, engine: IntentEngine, told: Callable[[ConfigError | None], None] | None = None) -> None:
        if not hasattr(engine, "reload"):
            raise TypeError(f"Watcher takes an IntentEngine, not {engine!r:.80}: IntentEngine.from_files(...)")
        self._engine = engine
        self._told = told or (lambda error: None)
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None
        self._refused: frozenset[Path] = frozenset()

    @property
    def files(self) -> frozenset[Path]:
        """The files that are watched: those in use, and those that were refused."""
        return frozenset(path for file in self._engine.files for path in _paths(file)) | self._refused

    def changed(self, paths: Iterable[Path]) -> bool:
        """Reload if any of these files matters; whether it did. For those who find out about changes themselves."""
        if self.files.isdisjoint(path for changed in paths for path in _paths(changed)):
            return False
        try:
            self._engine.reload()
        except ConfigError as error:
            # What a refused grammar includes is not in use, and yet it is there that the mistake may be mended: also
            # where it is told of another file, or the file is not there yet.
            told = (one.file for one in error.problems if one.file)
            self._refused = frozenset(path for file in (*told, *error.files) for path in _paths(Path(file)))
            self._told(error)
        else:
            self._refused = frozenset()
            self._told(None)
        return True

    def start(self) -> None:
        """Begin to watch.

        Raises:
            ConfigError: the ``watchfiles`` package is not installed, or the engine was not made from files.
            RuntimeError: it was closed.
        """
        if self._stop.is_set():
            raise RuntimeError("this watcher is closed, and would watch nothing; make another")
        if self._thread is not None:
            return
        try:
            import watchfiles  # noqa: F401
        except ImportError:
            hint = "pip install 'intent-engine[watch]'"
            raise ConfigError(Problem("watching files needs the watchfiles package", hint=hint)) from None
        if not self.files:
            raise ConfigError("there are no files to watch: the engine was not made from files")
        ready = threading.Event()
        self._thread = threading.Thread(target=self._watch, args=(ready,), name="grammar-watcher", daemon=True)
        self._thread.start()
        ready.wait(5.0)

    def _watch(self, ready: threading.Event) -> None:
        while not self._stop.is_set():
            try:
                self._watch_folders(self._folders(), ready)
            except (OSError, RuntimeError) as error:
                # A folder that was removed, or a limit of the system; the grammar in use stays so.
                _log.warning("files cannot be watched: %s", error)
                ready.set()
                self._stop.wait(RETRY_SECONDS)

    def _watch_folders(self, folders: list[Path], ready: threading.Event) -> None:
        """Until others are to be watched."""
        from watchfiles import watch

        if not folders:
            raise FileNotFoundError("none of their folders is there")
        # With a timeout, so that the first round says that the watch stands, and a new folder is soon looked at.
        for changes in watch(
            *folders,
            watch_filter=None,
            debounce=DEBOUNCE_MS,
            step=DEBOUNCE_MS // 2,
            stop_event=self._stop,
            rust_timeout=DEBOUNCE_MS,
            yield_on_timeout=True,
            recursive=False,
            raise_interrupt=False,
        ):
            ready.set()
            try:
                self.changed(Path(name) for _, name in changes)
            except Exception:
                _log.exception("a change of the grammar could not be told")
            if self._folders() != folders:
                return

    def _folders(self) -> list[Path]:
        return sorted({path.parent for path in self.files if path.parent.is_dir()})

    def close(self) -> None:
        """Watch no longer."""
        self._stop.set()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(5.0)

    def __enter__(self) -> Watcher:
        self.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
