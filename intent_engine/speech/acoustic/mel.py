"""Whisper's mel filters, applied without threads that nobody asked for.

OpenBLAS, which comes with NumPy, gives a product of this size to threads of its own, and these spin while they wait for
the next one. A recogniser that listens asks for one every few hundredths of a second, so a whole core was spent on
nothing, and both models were slowed by it. To tell OpenBLAS would be to tell it for the whole process.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

__all__ = ["MelFilters"]

_Floats = npt.NDArray[np.float32]


class MelFilters:
    """Filters of which each hears a few neighbouring frequencies.

    Args:
        weights: ``(bands, frequencies)``, as faster-whisper's ``FeatureExtractor`` has them.
    """

    def __init__(self, weights: _Floats) -> None:
        heard = weights > 0
        heard[:, 0] |= ~heard.any(axis=1)  # a band between two frequencies hears nothing, by a weight of 0
        bands, self._frequencies = np.nonzero(heard)
        self._weights = weights[bands, self._frequencies][:, np.newaxis]
        self._starts = np.searchsorted(bands, np.arange(len(weights)))

    def __matmul__(self, magnitudes: _Floats) -> _Floats:
        """The energy in each band.

        Args:
            magnitudes: ``(frequencies, frames)``

        Returns:
            ``(bands, frames)``
        """
        bands: _Floats = np.add.reduceat(magnitudes[self._frequencies] * self._weights, self._starts, axis=0)
        return bands
