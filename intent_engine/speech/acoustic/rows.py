"""What a model thinks may come next, after some beginnings of a text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

__all__ = ["Rows", "total"]

Rows: TypeAlias = Mapping[tuple[int, ...], npt.NDArray[np.float32]]
"""How likely every piece is after some beginnings of a text: ``(vocabulary,)`` log probabilities, up to a constant in
each."""


def total(row: npt.NDArray[np.float32]) -> float:
    """What all log probabilities of a row make together, in nats: the constant up to which they are such."""
    top = row.max()
    return float(top + np.log(np.exp(row - top).sum()))
