"""The weights in a model file of CTranslate2, which itself does not give them away.

The format is that of ``ModelSpec.save`` in CTranslate2 4 (``ctranslate2/specs/model_spec.py``, binary version 6): a
head, then variables by name with their shapes and types.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["read_variables"]

VERSION = 6
_TYPES = {0: np.float32, 1: np.int8, 2: np.int16, 3: np.int32, 4: np.float16}
"""bfloat16, the fifth, NumPy has not."""


class _Reader:
    """Takes one value after the other from a file's bytes."""

    def __init__(self, data: npt.NDArray[np.uint8]) -> None:
        self.data = data
        self.at = 0

    def take(self, layout: str) -> tuple[Any, ...]:
        end = self.at + struct.calcsize("<" + layout)
        found = struct.unpack("<" + layout, self.data[self.at : end].tobytes())
        self.at = end
        return found

    def text(self) -> str:
        """With its length before and a zero behind."""
        (length,) = self.take("H")
        (found,) = self.take(f"{length}s")
        return bytes(found).rstrip(b"\0").decode()


def read_variables(path: Path, prefix: str) -> dict[str, npt.NDArray[Any]]:
    """The variables whose names begin so, by the rest of their names. They stay in the file until they are looked at.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is of another form.
    """
    try:
        return dict(_variables(_Reader(np.memmap(path, np.uint8, "r")), prefix))
    except (struct.error, ValueError) as error:
        raise ValueError(f"{path} is no model of CTranslate2 that can be read: {error}") from None


def _variables(reader: _Reader, prefix: str) -> Iterator[tuple[str, npt.NDArray[Any]]]:
    (version,) = reader.take("I")
    if version != VERSION:
        raise ValueError(f"it is of binary version {version}, not {VERSION}")
    reader.text()  # the name of the kind of model
    _revision, count = reader.take("II")
    for _ in range(count):
        name = reader.text()
        (axes,) = reader.take("B")
        shape = reader.take("I" * axes)
        kind, size = reader.take("BI")
        if name.startswith(prefix) and kind in _TYPES:
            values = reader.data[reader.at : reader.at + size].view(_TYPES[kind])
            yield name.removeprefix(prefix), values.reshape(shape)
        reader.at += size
