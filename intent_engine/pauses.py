"""The pauses in which Python collects garbage: short ones only, in a process that listens."""

from __future__ import annotations

import gc

__all__ = ["avoid_pauses"]

YOUNG = 50_000
"""Objects that are made, and not dropped, before the youngest are looked at."""
OLDER, OLDEST = 20, 100
"""Looks at these before the older ones are looked at, and before all are."""


def avoid_pauses() -> None:
    """Let Python collect garbage seldom, and never among what is there now.

    A grammar that has been listened to for a while is two hundred thousand objects. Python looked at all of them every
    few commands, for 0.13 to 0.25 s in which nothing was heard and no velocity was sent. Nearly everything is dropped
    without that, since little of it is cyclic.

    It is for the whole process, so a program that embeds the engine calls it itself, when everything is loaded. It may
    be called again, when another grammar or model was.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(YOUNG, OLDER, OLDEST)
