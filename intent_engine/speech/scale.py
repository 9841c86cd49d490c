"""Sound at a wrong scale: integers that are called floats, and 16 bits in 32. It would be heard as one roar, or not at
all, without a word."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.errors import AudioError

__all__ = ["check_scale", "faint", "holds_16_bits"]

FEW = 16
"""Samples that may be whole numbers, or loud, by chance."""
LARGEST_INTEGER = 2.0**31
"""In which sound is recorded."""
TOO_LOUD = 32.0
"""Beyond it no float of a sound is, however loud: 30 dB above what any converter gives."""
OVERSHOOT = 2.0
"""How far above its loudest sample a sound may be that was resampled or filtered."""
LOUD_SHARE = 0.05
"""Of samples beyond -1 to 1: fewer are what a broken driver sends between good ones."""
FAINT = 2.0**-16
"""Of full scale, -96 dB: less than any microphone hears in a quiet room. All that 16 bits reach within 32."""
LEAST_OF_16_BITS = 2**10
"""Below it the integers may be the dither of silence."""
LOW_BYTE = 0xFF
"""Of an integer of 32 bits, empty in what converters of 24 bits give."""


def check_scale(samples: npt.NDArray[Any], what: str, hint: str) -> None:
    """See that floats are from -1 to 1, or near it: what is somewhat too loud may be clipped.

    Args:
        samples: of any shape; integers are not looked at.
        what: holds them, and a verb: "the stream was given".
        hint: what to do.

    Raises:
        AudioError: they are the integers in which sound was recorded, as ``astype(float)`` or resampling leaves them:
            nearly all would be clipped.
    """
    if samples.dtype.kind != "f" or samples.size < FEW:
        return
    loudness = np.abs(np.nan_to_num(samples, nan=0.0, posinf=0.0, neginf=0.0))
    peak = float(loudness.max())
    if not 1.0 < peak <= OVERSHOOT * LARGEST_INTEGER:  # beyond it is what a broken driver sends
        return
    if peak <= LARGEST_INTEGER and np.array_equal(loudness, np.rint(loudness)):
        raise AudioError(f"{what} floats that are whole numbers, where sound is from -1 to 1\n    {hint}")
    if peak > TOO_LOUD and np.count_nonzero(loudness > 1.0) >= max(FEW, LOUD_SHARE * loudness.size):
        raise AudioError(f"{what} floats up to {peak:.0f}, where sound is from -1 to 1\n    {hint}")


def faint(samples: npt.NDArray[Any]) -> bool:
    """Whether nothing can be heard in sound of any type: floats from -1 to 1, or signed integers."""
    if not samples.size:
        return True
    full = 1.0 if samples.dtype.kind == "f" else -float(np.iinfo(samples.dtype).min)
    return max(float(samples.max()), -float(samples.min())) <= FAINT * full


def holds_16_bits(samples: npt.NDArray[np.int32]) -> bool:
    """Whether faint integers of 32 bits are those of 16 bits, not made larger, which would be heard as silence. What is
    as quiet with 24 bits, whose lowest byte is empty, is a quiet recording, and so is dither."""
    if not samples.size:
        return False
    peak = max(int(samples.max()), -int(samples.min()))
    return LEAST_OF_16_BITS <= peak <= LARGEST_INTEGER * FAINT and bool(np.any(samples & LOW_BYTE))
