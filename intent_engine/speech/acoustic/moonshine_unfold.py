"""Moonshine's published graphs, made ready for this machine, once.

In the published files the weights are bytes that the graph itself turns into floats, anew for every word, and both ways
to go on (from a beginning, or by one word) hang on a switch in one graph: a word takes 120 ms on one core. Of the
encoder the products are made of bytes; of the decoder the weights are taken, for graphs of our own
(:mod:`~intent_engine.speech.acoustic.moonshine_graphs`), with which a word takes 9 ms.
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

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.decoder_graphs import EMBEDDINGS, DecoderShape, listening, stepping, telling
from intent_engine.speech.acoustic.graph_writer import Variables, as_bytes
from intent_engine.speech.acoustic.moonshine_graphs import MoonshineGraph, looking
from intent_engine.speech.acoustic.onnx_sessions import onnx_runtime

__all__ = ["ENCODER", "LISTENING", "PIECES", "SCALES", "STEPPING", "TELLING", "unfold"]

ENCODER = "encoder.onnx"
"""Sound -> states."""
LISTENING, STEPPING, TELLING = "listening.onnx", "stepping.onnx", "telling.onnx"
"""The decoder (:mod:`~intent_engine.speech.acoustic.decoder_graphs`)."""
PIECES, SCALES = "pieces.npy", "scales.npy"
"""What pieces are, as bytes: ``(pieces, width)``, and by which scales, ``(pieces, 1)``."""
WORK = "unfolding-"
"""How the folders begin in which graphs are made."""
ABANDONED = 3600.0
"""s after which such a folder is of a program that was killed: it takes ten seconds."""
WHOLE = "else_branch"
"""Of the switch ``use_cache_branch`` in the published decoder: what begins a text, with all weights in it."""
PLACE = "/model/decoder/"
"""How the names of nodes begin."""


def unfold(encoder: Path, decoder: Path, target: Path, *, blocks: bool = False) -> None:
    """Write the graphs into a folder, whole or not at all.

    Args:
        encoder, decoder: as published, in ONNX Runtime's own format.
        target: the folder; it must not be there.
        blocks: whether the decoder multiplies by blocks.

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

        # ONNX Runtime computes beforehand what it can only of a graph that is not in its own format, so each is
        # written twice.
        _written(encoder, read)
        _written(read, folded)
        _quantised(folded, work / ENCODER)
        _written(decoder, read)
        published = onnx.load(str(read))
        onnx.save(_branch(published, WHOLE), str(read))
        _written(read, folded)
        variables = dict(_weights(onnx.load(str(folded)).graph))
        shape = _shape(published.graph, variables)
        for layer in range(shape.layers):
            parts = [variables[f"layers.{layer}/self_attn/{one}_proj/weight"] for one in "qkv"]
            variables[f"{looking(layer)}/weight"] = np.concatenate(parts)
        for name, write in ((LISTENING, listening), (STEPPING, stepping), (TELLING, telling)):
            (work / name).write_bytes(write(MoonshineGraph(variables, shape, blocks=blocks)))
        small, scales = as_bytes(variables[f"{EMBEDDINGS}/weight"])
        np.save(work / PIECES, small)
        np.save(work / SCALES, scales)
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
    onnxruntime = onnx_runtime()
    options = onnxruntime.SessionOptions()
    options.graph_optimization_level = onnxruntime.GraphOptimizationLevel.ORT_ENABLE_BASIC
    options.log_severity_level = 3
    options.optimized_model_filepath = str(to)
    options.add_session_config_entry("session.save_model_format", "ONNX")
    onnxruntime.InferenceSession(str(graph), options, providers=["CPUExecutionProvider"])


def _branch(published: Any, branch: str) -> Any:
    """One branch of the switch, as a graph of its own."""
    from onnx import TensorProto, helper

    (switch,) = [node for node in published.graph.node if node.op_type == "If"]
    (inner,) = [attribute.g for attribute in switch.attribute if attribute.name == branch]
    nodes = [node for node in published.graph.node if node.op_type != "If"] + list(inner.node)
    needed = {name for node in nodes for name in node.input}
    graph = helper.make_graph(
        nodes,
        branch,
        [value for value in published.graph.input if value.name in needed],
        [helper.make_tensor_value_info(output.name, TensorProto.FLOAT, None) for output in inner.output],
        [*published.graph.initializer, *inner.initializer],
    )
    domains = [one for one in published.opset_import if one.domain in ("", "com.microsoft")]
    return helper.make_model(graph, opset_imports=domains, ir_version=published.ir_version)


def _weights(graph: Any) -> Iterator[tuple[str, npt.NDArray[Any]]]:
    """The weights by the names of the nodes that have them: "layers.0/self_attn/q_proj/weight", (outputs, inputs)."""
    from onnx import numpy_helper

    constants = {one.name: one for one in graph.initializer}
    kinds = {"MatMul": "weight", "Add": "bias", "Mul": "gamma"}
    for node in graph.node:
        owner, _, last = node.name.removeprefix(PLACE).rpartition("/")
        own = [numpy_helper.to_array(constants[name]) for name in node.input if name in constants]
        if node.op_type == "Gather" and owner == "embed_tokens":
            yield f"{EMBEDDINGS}/weight", own[0]
        elif own and last in kinds and (last != "Mul" or owner.endswith("norm")):
            yield f"{owner}/{kinds[last]}", own[0].T


def _shape(published: Any, variables: Variables) -> DecoderShape:
    """How large the decoder is."""
    (known,) = [value for value in published.input if value.name == "past_key_values.0.decoder.key"]
    heads = known.type.tensor_type.shape.dim[1].dim_value
    layers = sum(name.endswith("self_attn/q_proj/weight") for name in variables)
    return DecoderShape(layers, heads, variables[f"{EMBEDDINGS}/weight"].shape[1])


def _quantised(graph: Path, to: Path) -> None:
    """The same with weights of bytes, and sums of products of bytes."""
    onnx_runtime()
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
