"""A busy machine."""

from __future__ import annotations

import contextlib
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator

__all__ = ["busy", "deaf_to_ctrl_c"]

SPIN = "import os; parent = os.getppid()\nwhile os.getppid() == parent: pass"


@contextlib.contextmanager
def deaf_to_ctrl_c() -> Iterator[None]:
    """What is started in this block does not hear the terminal's Ctrl-C, from its first moment on: whoever started it
    does, and ends it. A Ctrl-C that comes meanwhile is raised at the end of the block."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextlib.contextmanager
def busy(processes: int = 0, threads: int = 0) -> Iterator[None]:
    """Keep the machine busy: with processes beside this one, and with Python threads inside it."""
    others: list[subprocess.Popen[bytes]] = []
    done = threading.Event()

    def spin() -> None:
        value = 0
        while not done.is_set():
            for _ in range(10_000):
                value = (value * 31 + 7) % 1_000_003

    own = [threading.Thread(target=spin, daemon=True) for _ in range(threads)]
    for thread in own:
        thread.start()
    try:
        for _ in range(processes):
            with deaf_to_ctrl_c():
                others.append(subprocess.Popen([sys.executable, "-c", SPIN]))
        if others:
            time.sleep(0.3)  # until they have started, they load the disk and not the processor
        yield
    finally:
        done.set()
        for process in others:
            process.kill()
            process.wait()
        for thread in own:
            thread.join()
