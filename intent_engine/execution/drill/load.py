"""A busy machine."""

from __future__ import annotations

import contextlib
import subprocess
import sys
import threading
import time
from collections.abc import Iterator

__all__ = ["busy"]


@contextlib.contextmanager
def busy(processes: int = 0, threads: int = 0) -> Iterator[None]:
    """Keep the machine busy: with processes beside this one, and with Python threads inside it."""
    others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(processes)]
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
