"""Whether ONNX Runtime multiplies by blocks quickly on this machine, and exactly."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.graph_writer import BLOCK, BYTES, GraphWriter
from intent_engine.speech.acoustic.onnx_sessions import load_graph

__all__ = ["blocks_are_quick"]

QUICK = ("avx512_vnni", "avx_vnni")
"""Of a processor that sums up products of bytes at once; on others nothing was measured."""
PROCESSOR = Path("/proc/cpuinfo")
"""Where Linux tells of it. Elsewhere nobody does."""
WIDTH, OUTPUTS = 3 * BLOCK // 2, 16
"""Of the product that is tried: a whole block and a half."""


@cache
def blocks_are_quick() -> bool:
    """Whether to multiply by blocks here."""
    return _sums_bytes() and _exact()


def _sums_bytes() -> bool:
    try:
        told = PROCESSOR.read_text("utf-8", "replace")
    except OSError:
        return False
    flags = next((line.split() for line in told.splitlines() if line.startswith("flags")), [])
    return any(flag in flags for flag in QUICK)


def _exact() -> bool:
    """Whether this ONNX Runtime can do it, and sums up whole: before 1.22 or so it cannot. Tried with numbers that are
    bytes themselves, and the largest there are, so that the product must be right but for the last bits."""
    rng = np.random.default_rng(0)
    most = int(BYTES)
    weights, rows = (rng.integers(-most, most, (count, WIDTH)).astype(np.float32) for count in (OUTPUTS, 4))
    weights[0], rows[0] = BYTES, BYTES
    for one in (weights, rows):
        one[:, 0], one[:, BLOCK] = BYTES, -BYTES  # the scale of each block is 1
    try:
        (product,) = load_graph(_product(weights)).run(None, {"rows": rows})
    except Exception:  # ONNX Runtime's errors have no common class
        return False
    right = rows @ weights.T
    return bool(np.allclose(product, right, rtol=1e-3, atol=1e-3 * np.abs(right).max()))


def _product(weights: npt.NDArray[np.float32]) -> bytes:
    """Nothing but a product by blocks: ``rows`` (n, inputs) -> ``product`` (n, outputs)."""
    graph = GraphWriter({"tried/weight": weights}, blocks=True)
    graph.op("Identity", graph.linear("rows", "tried"), name="product")
    return graph.written({"rows": ("n", weights.shape[1])}, ["product"])
