"""Keys of the terminal while something else goes on: each is told as it is pressed, without Enter."""

from __future__ import annotations

import contextlib
import os
import re
import sys
import threading
from collections.abc import Callable, Iterator

from intent_engine.errors import ConfigError, Problem

__all__ = ["check_terminal", "keys"]

_REST = re.compile(r"[\[O][0-?]*[ -/]*[@-~]")
"""What a terminal sends behind an escape for an arrow or F2, which is no O and no Q."""

_NO_TERMINAL = Problem(
    "push-to-talk needs a terminal, whose space bar is the key",
    hint="without one leave out --push-to-talk; a program calls Runtime.talk(True) and Runtime.talk(False)",
)


@contextlib.contextmanager
def keys(on_key: Callable[[str], object], on_gone: Callable[[], object] = bool) -> Iterator[None]:
    """Call ``on_key`` with each key, in a thread of its own; the terminal is as before afterwards. Keys that have no
    character, as arrows, are told as an escape.

    Ctrl-C stays what it is. ``on_gone`` is called there when the terminal is no more, and no key will be pressed.

    Raises:
        ConfigError: there is no terminal, or none that can be set.
    """
    with _windows(on_key) if sys.platform == "win32" else _unix(on_key, on_gone):
        yield


@contextlib.contextmanager
def _unix(on_key: Callable[[str], object], on_gone: Callable[[], object]) -> Iterator[None]:
    import select
    import termios
    import tty

    terminal = _terminal()
    try:
        before = termios.tcgetattr(terminal)
        tty.setcbreak(terminal)
    except termios.error:  # as in the background, once the shell is gone
        os.close(terminal)
        raise ConfigError(_NO_TERMINAL) from None
    ending, end = os.pipe()

    def read() -> None:
        escaped = False
        while True:
            ready, _, _ = select.select([terminal, ending], [], [])
            if ending in ready:
                return
            try:
                pressed = os.read(terminal, 32)
            except OSError:
                pressed = b""
            if not pressed:
                on_gone()
                return
            typed = pressed.decode("utf-8", errors="replace")
            if escaped:  # its rest came later than the escape, as over a slow line
                typed = _REST.sub("", typed, count=1) if _REST.match(typed) else typed
            escaped = typed.endswith("\x1b")
            for key in re.sub(f"\x1b{_REST.pattern}", "\x1b", typed):
                on_key(key)

    thread = threading.Thread(target=read, name="keys", daemon=True)
    try:
        thread.start()
        yield
    finally:
        os.close(end)
        thread.join(timeout=1.0)
        with contextlib.suppress(termios.error):  # it is gone
            termios.tcsetattr(terminal, termios.TCSADRAIN, before)
        os.close(ending)
        os.close(terminal)


def check_terminal() -> None:
    """Raises:
    ConfigError: there is no terminal.
    """
    if sys.platform != "win32":
        os.close(_terminal())
    elif not sys.stdin.isatty():
        raise ConfigError(_NO_TERMINAL)


def _terminal() -> int:
    """A descriptor of the terminal. Standard input may be where the sound comes from; the terminal is still there."""
    try:
        if sys.stdin.isatty():
            return os.dup(sys.stdin.fileno())
        return os.open("/dev/tty", os.O_RDONLY | os.O_NOCTTY)
    except (OSError, ValueError, AttributeError):
        raise ConfigError(_NO_TERMINAL) from None


@contextlib.contextmanager
def _windows(on_key: Callable[[str], object]) -> Iterator[None]:
    import importlib

    msvcrt = importlib.import_module("msvcrt")
    if not sys.stdin.isatty():
        raise ConfigError(_NO_TERMINAL)
    ending = threading.Event()

    def read() -> None:
        while not ending.wait(0.02):
            while msvcrt.kbhit():
                on_key(msvcrt.getwch())

    thread = threading.Thread(target=read, name="keys", daemon=True)
    thread.start()
    try:
        yield
    finally:
        ending.set()
        thread.join(timeout=1.0)
