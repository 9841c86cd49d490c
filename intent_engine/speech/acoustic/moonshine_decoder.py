"""The decoder of a Moonshine model: its three graphs and what its pieces are, as they were made ready."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.moonshine_graphs import PLACES
from intent_engine.speech.acoustic.moonshine_unfold import LISTENING, PIECES, SCALES, STEPPING, TELLING
from intent_engine.speech.acoustic.onnx_sessions import load_graph

__all__ = ["MoonshineDecoder"]

_Floats: TypeAlias = npt.NDArray[np.float32]


class MoonshineDecoder:
    """The decoder of a Moonshine model.

    Args:
        folder: as :func:`~intent_engine.speech.acoustic.moonshine_unfold.unfold` wrote it.
        threads: of the processor.

    Raises:
        Exception: a file is missing or not what it should be; ONNX Runtime's errors have no common class.
    """

    def __init__(self, folder: Path, threads: int = 1) -> None:
        # Of 32,768 rows a sound needs a hundred: they are read from the file when they are needed.
        self.small, self.scales = (np.load(folder / name, mmap_mode="r") for name in (PIECES, SCALES))
        self.listening, self.stepping, self.telling = (
            load_graph(str(folder / name), threads) for name in (LISTENING, STEPPING, TELLING)
        )

    def rows(self, pieces: Sequence[int], places: Sequence[int]) -> Mapping[str, _Floats]:
        """What a step is told of pieces at some places."""
        return {
            "rows": self.small[pieces] * self.scales[pieces],
            PLACES: np.array(places, np.float32).reshape(-1, 1, 1),
        }
