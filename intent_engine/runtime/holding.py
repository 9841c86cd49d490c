"""A robot that is held while a stop word is being said, until it is known whether one was."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from intent_engine.execution.executor import Executor
from intent_engine.execution.failsafe import HANGS
from intent_engine.runtime.hands import Hands
from intent_engine.runtime.heard import HeardKind, Tell
from intent_engine.speech.audio import Samples
from intent_engine.speech.reflex import Reflex

__all__ = ["Holding"]

REFLEX_FRAMES = 11
"""Frames up to the onset which the reflex is given: a window that begins in silence holds less of the word."""


class Holding:
    """Listens for stop words with a reflex, and holds the robot. For one thread.

    Args:
        reflex: hears them; None: nothing is held.
        executor: is held.
        hands: release it.
        tell: is told of it.
    """

    def __init__(self, reflex: Reflex | None, executor: Executor, hands: Hands, tell: Tell) -> None:
        self._reflex = reflex
        self._executor = executor
        self._hands = hands
        self._tell = tell
        self.on = False
        """Whether the robot is held."""

    def begin(self, frames: Sequence[Samples], time: float) -> None:
        """An utterance has begun, with the last of these frames."""
        if self._reflex is not None:
            self._reflex.begin(list(frames[-REFLEX_FRAMES:-1]))
            self.listen(frames[-1], time)

    def listen(self, samples: Samples, time: float) -> None:
        """Hear one frame of it.

        Raises:
            TypeError: the reflex gave no yes or no. Whoever took None for a no would hear nobody say stop.
        """
        if self._reflex is None or self.on:
            return
        heard = self._reflex.heard(samples)
        if not isinstance(heard, (bool, np.bool_)):
            raise TypeError(f"a reflex says of each frame True or False, not {heard!r:.80}")
        if heard:
            self.on = True
            self._executor.hold()
            self._tell(HeardKind.HOLD, time)

    def release(self, time: float, why: str) -> None:
        """Let a robot that is held go on: no stop was said."""
        if self.on:
            self.on = False
            if self._hands.release():
                self._tell(HeardKind.RELEASE, time, detail=why)
            else:
                self._executor.stop()
                self._tell(HeardKind.ERROR, time, detail=HANGS)

    def forget(self) -> None:
        """It was stopped, or nothing is known any more of what it was held for."""
        self.on = False
