"""Garbage is collected seldom, and still collected."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
import gc, weakref
from intent_engine.pauses import YOUNG, avoid_pauses

class Knot:
    def __init__(self):
        self.itself = self

kept = [Knot() for _ in range(1000)]
for _ in range(2):
    avoid_pauses()
frozen = gc.get_freeze_count()
assert frozen > len(kept), frozen
looked = []
gc.callbacks.append(lambda phase, info: looked.append(info["generation"]))
for _ in range(200_000):
    [[], {}]  # dropped at once: there is nothing to look for
assert looked == [], looked
gone = weakref.ref(Knot())
more = [[] for _ in range(2 * YOUNG)]
assert gone() is None, "what is cyclic is still found"
assert max(looked) == 0
"""


def test_what_is_loaded_is_not_looked_at_again_and_garbage_is_found() -> None:
    """In a process of its own, since it changes the whole process."""
    subprocess.run([sys.executable, "-c", PROGRAM], check=True, timeout=60)
