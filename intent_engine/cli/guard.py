"""Every verb ends through here: results, errors, bugs, Ctrl-C and a lost output, each with its exit code.

Nothing that a user can do gives a traceback. A robot is stopped by the ``with`` that holds it, before this is reached.
"""

from __future__ import annotations

import contextlib
import errno
import functools
import math
import os
import shlex
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from types import FrameType
from typing import TYPE_CHECKING, ParamSpec

import typer

from intent_engine.cli.streams import OutputError, drop_output
from intent_engine.cli.terminal import error_block
from intent_engine.errors import ConfigError, IntentEngineError

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

__all__ = [
    "DEBUG",
    "EXIT_BUG",
    "EXIT_INTERRUPTED",
    "EXIT_NOT_ACCEPTED",
    "EXIT_PIPE_CLOSED",
    "EXIT_TERMINATED",
    "Terminated",
    "output_lost",
    "robot_verb",
    "verb",
]

P = ParamSpec("P")

EXIT_NOT_ACCEPTED = 1
"""What was asked for was done, and the answer is no: not a command, a failed example, a failed drill."""
EXIT_OUTPUT = 2
"""Standard output cannot be written: as any other file that cannot."""
EXIT_BUG = 70
"""A fault of ours (EX_SOFTWARE of sysexits.h)."""
EXIT_INTERRUPTED = 130
"""Ctrl-C, as shells have it: 128 + SIGINT."""
EXIT_PIPE_CLOSED = 141
"""The reader of standard output went away: 128 + SIGPIPE."""
EXIT_TERMINATED = 143
"""128 + SIGTERM."""

DEBUG = "INTENT_ENGINE_DEBUG"
"""Set by ``--debug``: show tracebacks."""


class Terminated(BaseException):
    """SIGTERM, made an exception so that every ``with`` on the way out stops its robot, and what was found is told."""


def verb(function: Callable[P, int | None]) -> Callable[P, None]:
    """Make a command of a function that returns its exit code (None: 0)."""
    return _guarded(function, "")


def robot_verb(function: Callable[P, int | None]) -> Callable[P, None]:
    """The same of a function that moves a robot: however it ends, it is told that the robot is stopped."""
    return _guarded(function, "; the robot is stopped")


def _guarded(function: Callable[P, int | None], stopped: str) -> Callable[P, None]:
    @functools.wraps(function)
    def guarded(*args: P.args, **kwargs: P.kwargs) -> None:
        with _signals_raise():
            code = _run(functools.partial(function, *args, **kwargs), stopped)
        raise typer.Exit(code)

    return guarded


def _run(function: Callable[[], int | None], stopped: str) -> int:
    try:
        return _unmasked(function)
    except typer.Exit:
        raise
    except IntentEngineError as error:
        _trace()
        error_block(str(error))
        return error.exit_code
    except KeyboardInterrupt:
        error_block(f"interrupted{stopped}")
        return EXIT_INTERRUPTED
    except Terminated:
        error_block(f"terminated{stopped}")
        return EXIT_TERMINATED
    except OutputError as error:
        return output_lost(error)
    except BrokenPipeError:
        # Python flushes standard output once more at exit; give it somewhere to go.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return EXIT_PIPE_CLOSED
    except Exception as error:
        _trace()
        if isinstance(error, OSError) and error.errno == errno.ENAMETOOLONG:
            error_block(f"{str(error.filename)[:60]}...: no file has so long a name\n    give the path of a file")
            return ConfigError.exit_code
        error_block(
            f"intent-engine failed in a way it should not: {type(error).__name__}: {error}\n"
            f"{'The robot is stopped. ' if stopped else ''}This is a fault of the program, not of what you gave it.\n"
            f"To see where it happened, repeat the command as: intent-engine --debug {shlex.join(sys.argv[1:])}"
        )
        return EXIT_BUG


def _unmasked(function: Callable[[], int | None]) -> int:
    """Call a function. Where an interruption became another error on its way, as in a library that was being loaded
    ("initialization failed"), it is raised again as what it was."""
    try:
        return function() or 0
    except Exception as error:
        if (ending := _interruption(error)) is not None:
            raise ending from None
        raise


def _interruption(error: BaseException) -> KeyboardInterrupt | Terminated | None:
    """The interruption that an error was made of; None of any other, as of one in what is done because of it."""
    link: BaseException | None = error
    while link is not None:
        if isinstance(link.__cause__, KeyboardInterrupt | Terminated):
            return link.__cause__
        link = link.__cause__ or link.__context__
    return None


def output_lost(error: OutputError) -> int:
    """Tell that standard output cannot be written; the exit code."""
    _trace()
    drop_output()
    error_block(f"standard output cannot be written: {error}")
    return EXIT_OUTPUT


def _trace() -> None:
    if os.environ.get(DEBUG):
        traceback.print_exc()


def _signal_main_thread(number: int) -> None:
    """Give the main thread a signal, which ends what it waits for."""
    if sys.platform == "win32":
        signal.raise_signal(number)
    else:
        signal.pthread_kill(threading.main_thread().ident or 0, number)


PATIENCE = 3.0
"""s after a Ctrl-C or SIGTERM in which another one changes nothing: what stops the robot is not to be interrupted."""
AGAIN = 0.005
"""s until a signal whose exception was dropped, or would be, is given once more."""
LOADING = 3.0
"""s for which a signal waits until a module is loaded; many a library takes what is raised there for a package that is
not installed, and goes on without it."""
_IMPORTING = "<frozen importlib._bootstrap>"


def _loads(frame: FrameType | None) -> bool:
    """Whether a module is being loaded where the main thread is."""
    while frame is not None:
        if frame.f_code.co_filename == _IMPORTING:
            return True
        frame = frame.f_back
    return False


@contextlib.contextmanager
def _signals_raise() -> Iterator[None]:
    """Make exceptions of SIGINT and SIGTERM, one at a time."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    raised_at, interrupted, dropping = -math.inf, False, False
    waits_since = math.inf
    told_before = sys.unraisablehook

    def interrupt(signum: int, frame: FrameType | None) -> None:
        nonlocal raised_at, interrupted, waits_since
        now = time.monotonic()
        if now - raised_at < PATIENCE:
            return
        waits_since = min(waits_since, now)
        if now - waits_since < LOADING and _loads(frame):
            threading.Timer(AGAIN, _signal_main_thread, [signum]).start()
            return
        raised_at, interrupted, waits_since = now, True, math.inf
        raise KeyboardInterrupt if signum == signal.SIGINT else Terminated

    def once_more(lost: UnraisableHookArgs) -> None:
        """Python drops what is raised in a destructor; a robot that was to be stopped would drive on."""
        nonlocal dropping
        if not issubclass(lost.exc_type, KeyboardInterrupt | Terminated):
            told_before(lost)
            return
        number = signal.SIGINT if issubclass(lost.exc_type, KeyboardInterrupt) else signal.SIGTERM
        dropping = True
        try:
            # From another thread, a little later: raised in here it would be dropped again, and so it would be of
            # another signal that comes meanwhile, which changes nothing as long as this one was raised just now.
            threading.Timer(AGAIN, raise_again, [number]).start()
        finally:
            dropping = False

    def raise_again(number: int) -> None:
        nonlocal raised_at
        if dropping:
            threading.Timer(AGAIN, raise_again, [number]).start()
            return
        raised_at = -math.inf
        _signal_main_thread(number)

    # Who started this program with SIGINT ignored (a shell does, with "&") wants it ignored.
    numbers = [number for number in (signal.SIGINT, signal.SIGTERM) if signal.getsignal(number) is not signal.SIG_IGN]
    before = {number: signal.signal(number, interrupt) for number in numbers}
    sys.unraisablehook = once_more
    try:
        yield
    finally:
        sys.unraisablehook = told_before
        for number, handler in before.items():
            # The program is on its way out when it was interrupted; the rest of it is not worth a traceback either.
            signal.signal(number, signal.SIG_IGN if interrupted else handler)
