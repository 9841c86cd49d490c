"""Whether a sound that ended was over, or was cut off."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Ending"]

REMEMBERED = 1.0
"""s of sound that the end is compared with."""
MOMENT = 0.02
"""s whose loudness is one."""
FADED = 25.0
"""dB below the loudest moment, where words have ended. 32 commands of four synthetic voices, with no silence after
them, end 43 dB and more below it; of the moments within them seven in ten are less than 20 dB below it."""


class Ending:
    """Remembers the end of a sound while it comes.

    Args:
        rate: Hz.
    """

    def __init__(self, rate: int) -> None:
        self._size = max(int(rate * MOMENT), 1)
        self._most = int(rate * REMEMBERED)
        self._last: npt.NDArray[Any] = np.zeros((0, 1))

    def take(self, samples: npt.NDArray[Any]) -> None:
        """Take ``(n, channels)`` more, -1 to 1."""
        joined = np.concatenate((self._last, samples)) if self._last.size else samples
        self._last = joined[-self._most :]

    @property
    def abrupt(self) -> bool:
        """Whether it is as loud at its end as only the midst of a word is."""
        count = len(self._last) // self._size
        if count < 2:
            return False
        sound = np.nan_to_num(self._last[-count * self._size :], nan=0.0, posinf=0.0, neginf=0.0)
        loudness = np.square(sound, dtype=np.float64).reshape(count, -1).mean(axis=1)
        return bool(loudness[-1] > loudness.max() * 10 ** (-FADED / 10))
