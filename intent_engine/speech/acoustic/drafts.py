"""What was written of an utterance so far: a draft, when more of it is heard.

A model writes piece by piece, each after those before it. Several that are only to be looked through take little longer
than one, so what it would write again is not written again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from intent_engine.speech.audio import SAMPLE_RATE, Samples

__all__ = ["NOTHING_DRAFTED", "Draft", "Drafts"]

SAME = int(0.3 * SAMPLE_RATE)
"""Samples at the beginning of a sound by which it is known again."""
UNSETTLED = int(0.1 * SAMPLE_RATE)
"""Samples at its end that a noise filter may still change."""
LEAST = 2
"""Pieces of a draft that is worth it."""
ASTRAY = 3
"""Pieces by which a text may have become longer or shorter than its draft, and go on as that does."""


class Draft:
    """What a text may be, while it is written: its pieces, as far as somebody knows them by then.

    Args:
        told: gives the pieces. It is asked each time, since a model beside may have heard more.
    """

    def __init__(self, told: Callable[[], tuple[int, ...]]) -> None:
        self._told = told

    def after(self, written: tuple[int, ...]) -> tuple[int, ...]:
        """The pieces that may follow those written so far. Where the text has left the draft they are those behind the
        piece that was written last, if the draft has that near there."""
        draft = self._told()
        length = len(written)
        if draft[:length] == written:
            return draft[length:]
        near = range(max(length - ASTRAY, 1), min(length + ASTRAY, len(draft)) + 1)
        same = [place for place in near if draft[place - 1] == written[-1]]
        return draft[min(same, key=lambda place: abs(place - length)) :] if same else ()


NOTHING_DRAFTED = Draft(tuple)


@dataclass(frozen=True, slots=True, eq=False)
class _Draft:
    """What was written of a sound."""

    beginning: Samples
    size: int
    pieces: tuple[int, ...]

    def begins(self, samples: Samples) -> bool:
        """Whether a sound begins with this one, and is another: the same is heard to the last bit as it was."""
        same = self.beginning.size
        goes_on = 0 < same <= samples.size and samples.size != self.size <= samples.size + UNSETTLED
        return goes_on and np.array_equal(self.beginning, samples[:same])


class Drafts:
    """The last two sounds that were heard, and what was written of them. For one thread."""

    def __init__(self) -> None:
        self._kept: list[_Draft] = []

    def of(self, samples: Samples) -> tuple[int, ...]:
        """The pieces with which the text of a sound may begin: those of the last one, if it goes on from that; or
        none."""
        found = next((one.pieces for one in reversed(self._kept) if one.begins(samples)), ())
        return found if len(found) >= LEAST else ()

    def keep(self, samples: Samples, pieces: tuple[int, ...]) -> None:
        """What was written of a sound."""
        beginning = samples[: max(min(SAME, samples.size - UNSETTLED), 0)]
        self._kept = [*self._kept[-1:], _Draft(beginning, samples.size, pieces)]

    def lose(self) -> None:
        """Forget the last of them."""
        self._kept = self._kept[:-1]
