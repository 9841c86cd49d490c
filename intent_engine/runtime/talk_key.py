"""The key of push-to-talk, and whether somebody spoke already when it was pressed.

Who presses late has said "don't" before the key was down, and "go forward" is not what was meant. While the key is up
nothing is recognised, only the voice detector runs on.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence

from intent_engine.speech.audio import FRAME_SECONDS, Samples

__all__ = ["TalkKey", "same_voice"]

LATE = 0.5
"""s from the last word that was passed over to an onset, within which begins what may be the rest of its sentence."""
TAIL = 0.3
"""s after the key was let go, within which a voice may be the end of what was heard: the detector is late to let go."""
AT_ONCE = 3.5 * FRAME_SECONDS
"""s to the onset of what goes on in the same breath, when the key is down again before the voice has ended."""
APART = 12.0
"""dB by which a voice that was passed over is quieter than the one that is heard, if it is another's, farther off. Of
436 cuts through 150 sentences of synthetic voices and 84 through clips of people, in one the loudest moment of the half
second before the cut was more than 9 dB below the loudest after it."""


class TalkKey:
    """Its state, from any thread; and, for one thread, what was passed over while it was up."""

    def __init__(self) -> None:
        self.on = False
        """Whether what is said counts only while the key is down."""
        self._down = threading.Event()
        self._until = -1.0
        """s since the source began: until when what begins may be the rest of a sentence."""
        self._loudness = 0.0
        """Of that sentence: mean square of its loudest frame."""
        self._let_go: float | None = None
        """s since the source began: when the key was let go in the midst of a voice that has not ended since."""

    @property
    def up(self) -> bool:
        """Whether nothing is to be heard now."""
        return self.on and not self._down.is_set()

    def press(self, down: bool) -> None:
        """It went down or up."""
        if down:
            self._down.set()
        else:
            self._down.clear()

    def reset(self) -> None:
        """A source begins."""
        self._until, self._loudness, self._let_go = -1.0, 0.0, None

    def let_go(self, time: float) -> None:
        """It went up, while something was being said."""
        self._let_go = time

    def pass_over(self, samples: Samples, time: float, *, voice: bool) -> None:
        """A frame that ends at ``time`` is not heard; ``voice``: somebody speaks in it."""
        if not voice:
            self._let_go = None
            return
        if time > self._until:
            self._loudness = 0.0
        tail = self._let_go is not None and time - self._let_go < TAIL
        self._until = time + (AT_ONCE if tail else LATE)
        self._loudness = max(self._loudness, _loudness(samples))

    def late(self, onset: float) -> float:
        """Loudness of the sentence of which the rest may begin at ``onset``; 0: of none."""
        return self._loudness if onset <= self._until else 0.0


def same_voice(passed_over: float, frames: Sequence[Samples]) -> bool:
    """Whether a voice of such a loudness may be the one in some frames; 0: there was none."""
    return passed_over > 0 and passed_over * 10 ** (APART / 10) >= max(map(_loudness, frames))


def _loudness(samples: Samples) -> float:
    return float((samples.astype("float64") ** 2).mean())
