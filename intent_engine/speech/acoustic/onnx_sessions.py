"""Graphs in ONNX Runtime, as small models are quickest and exact."""

from __future__ import annotations

import os
from typing import Any

__all__ = ["load_graph", "onnx_runtime"]

EXACT_SUMS = "session.x64quantprecision"
"""Setting of ONNX Runtime: on a processor without VNNI (before 2019 or so, and many small ones), the quick way to add
up products of bytes cuts large sums off. There a sentence was 3 nats less likely or likelier than it is, and in noise
six of ten transcripts of Moonshine were others; summed up whole it is half a nat, as with VNNI, and takes a quarter
longer."""
ERRORS = 3
"""The least severe messages that are written."""

NO_TELEMETRY = "ORT_DISABLE_TELEMETRY"
"""Since 1.29 ONNX Runtime, when it is imported, gives the machine an identifier and writes a database of what it was
used for into the user's cache, to be sent to Microsoft. This variable of the environment, read at the import alone,
keeps it from that; ``disable_telemetry_events`` comes too late for the files."""


def onnx_runtime() -> Any:
    """The module ``onnxruntime``, which tells nobody what it does; the one place where it is imported. Whoever wants it
    to tell sets ``ORT_DISABLE_TELEMETRY=0``."""
    quiet = os.environ.setdefault(NO_TELEMETRY, "1") != "0"
    import onnxruntime

    if quiet:  # where somebody imported it before, and on Windows
        onnxruntime.disable_telemetry_events()
    return onnxruntime


def load_graph(graph: str | bytes, threads: int = 1) -> Any:
    """An ``InferenceSession`` on the processor.

    Args:
        graph: a file, or what would be in it.
        threads: of the processor; a small model is fastest with one.

    Raises:
        Exception: ONNX Runtime's errors have no common class.
    """
    onnxruntime = onnx_runtime()
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    options.inter_op_num_threads = 1
    options.log_severity_level = ERRORS
    options.add_session_config_entry(EXACT_SUMS, "1")
    return onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
