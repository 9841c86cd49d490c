"""Moonshine's published graphs, unfolded and quantised for this machine, once.

In the published files the weights are bytes that the graph itself turns into floats, anew for every word, and both ways
to go on (from a beginning, or by one word) hang on a switch in one graph. Unfolded, with products of bytes, a word
takes 9 ms on one core instead of 120, and what is heard is the same.
"""

from __future__ import annotations

import logging
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

__all__ = ["BEGIN", "ENCODER", "STEP", "unfold"]

ENCODER = "encoder.onnx"
"""Sound -> states."""
BEGIN = "begin.onnx"
"""Words and states -> what may come after each of them, and what the next step needs to know."""
STEP = "step.onnx"
"""One word more, and what is known -> what may come next."""
WORK = "unfolding-"
"""How the folders begin in which graphs are made."""
ABANDONED = 3600.0
"""s after which such a folder is of a program that was killed: it takes half a minute."""
_BRANCHES = {BEGIN: "else_branch", STEP: "then_branch"}
"""Of the switch ``use_cache_branch`` in the published decoder."""


def unfold(encoder: Path, decoder: Path, target: Path) -> None:
    """Write the three graphs into a folder, whole or not at all.

    Args:
        encoder, decoder: as published, in ONNX Runtime's own format.
        target: the folder; it must not be there.

    Raises:
        OSError: there is no room.
        Exception: whatever ``onnx`` and ``onnxruntime`` raise at a file that is not what it should be.
    """
    import onnx

    target.parent.mkdir(parents=True, exist_ok=True)
    _clear_abandoned(target.parent)
    work = Path(tempfile.mkdtemp(prefix=WORK, dir=target.parent))
    try:
        read, folded = work / "read.onnx", work / "folded.onnx"

        def finish(name: str) -> None:
            # ONNX Runtime computes beforehand what it can only of a graph that is not in its own format.
            _written(read, folded)
            _quantised(folded, work / name)

        _written(encoder, read)
        finish(ENCODER)
        _written(decoder, read)
        whole = onnx.load(str(read))
        for name, branch in _BRANCHES.items():
            onnx.save(_branch(whole, branch), str(read))
            finish(name)
        read.unlink()
        folded.unlink()
        try:
            work.rename(target)
        except OSError:
            if not target.is_dir():  # else another program was faster
                raise
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _clear_abandoned(folder: Path) -> None:
    """Remove what programs left that were killed before they were done: hundreds of megabytes each."""
    for left in folder.glob(f"{WORK}*"):
        with suppress(OSError):  # another program is removing it
            if time.time() - left.stat().st_mtime > ABANDONED:
                shutil.rmtree(left, ignore_errors=True)


def _written(graph: Path, to: Path) -> None:
    """A graph as ONNX Runtime has it when it is loaded, in ONNX."""
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.graph_optimization_level = onnxruntime.GraphOptimizationLevel.ORT_ENABLE_BASIC
    options.log_severity_level = 3
    options.optimized_model_filepath = str(to)
    options.add_session_config_entry("session.save_model_format", "ONNX")
    onnxruntime.InferenceSession(str(graph), options, providers=["CPUExecutionProvider"])


def _branch(whole: Any, branch: str) -> Any:
    """One branch of the switch, as a graph of its own."""
    from onnx import TensorProto, helper

    (switch,) = [node for node in whole.graph.node if node.op_type == "If"]
    (inner,) = [attribute.g for attribute in switch.attribute if attribute.name == branch]
    nodes = [node for node in whole.graph.node if node is not switch and node.op_type != "If"] + list(inner.node)
    pairs = list(zip(inner.output, whole.graph.output, strict=True))
    needed = {name for node in nodes for name in node.input}
    # A step changes nothing of what is known of the sound.
    told = [(own, whole_) for own, whole_ in pairs if branch == "else_branch" or ".encoder." not in whole_.name]
    nodes += [helper.make_node("Identity", [own.name], [f"told_{whole_.name}"]) for own, whole_ in told]
    graph = helper.make_graph(
        nodes,
        branch,
        [value for value in whole.graph.input if value.name in needed],
        [helper.make_tensor_value_info(f"told_{whole_.name}", TensorProto.FLOAT, None) for _, whole_ in told],
        [*whole.graph.initializer, *inner.initializer],
    )
    domains = [one for one in whole.opset_import if one.domain in ("", "com.microsoft")]
    return helper.make_model(graph, opset_imports=domains, ir_version=whole.ir_version)


def _quantised(graph: Path, to: Path) -> None:
    """The same with weights of bytes, and sums of products of bytes."""
    from onnxruntime.quantization import QuantType, quantize_dynamic

    with _quiet():
        quantize_dynamic(graph, to, weight_type=QuantType.QInt8, per_channel=True, op_types_to_quantize=["MatMul"])


@contextmanager
def _quiet() -> Iterator[None]:
    """Without the advice that ONNX Runtime's quantisation gives through the root logger."""
    before = logging.root.manager.disable
    logging.disable(logging.WARNING)
    try:
        yield
    finally:
        logging.disable(before)
