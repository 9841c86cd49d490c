"""Graphs in ONNX Runtime, as small models are quickest and exact."""

from __future__ import annotations

from typing import Any

__all__ = ["load_graph"]

EXACT_SUMS = "session.x64quantprecision"
"""Setting of ONNX Runtime: on a processor without VNNI (before 2019 or so, and many small ones), the quick way to add
up products of bytes cuts large sums off. There a sentence was 3 nats less likely or likelier than it is, and in noise
six of ten transcripts of Moonshine were others; summed up whole it is half a nat, as with VNNI, and takes a quarter
longer."""
ERRORS = 3
"""The least severe messages that are written."""


def load_graph(graph: str | bytes, threads: int = 1) -> Any:
    """An ``InferenceSession`` on the processor.

    Args:
        graph: a file, or what would be in it.
        threads: of the processor; a small model is fastest with one.

    Raises:
        Exception: ONNX Runtime's errors have no common class.
    """
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    options.inter_op_num_threads = 1
    options.log_severity_level = ERRORS
    options.add_session_config_entry(EXACT_SUMS, "1")
    return onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
