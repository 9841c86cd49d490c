"""Graphs for ONNX Runtime that are being written: operations one after the other, and products with weights of bytes.

Weights are bytes, with a scale for each output; what they are multiplied with becomes bytes row by row, as CTranslate2
does it, so that a row is the same whatever else is asked about beside it. Where ONNX Runtime can multiply by blocks
quickly (:mod:`~intent_engine.speech.acoustic.block_products`), each block of a row and of a weight has a scale of its
own, which is more exact, and one operation instead of twelve.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

__all__ = ["GraphWriter", "Variables", "as_blocks", "as_bytes"]

OPSET = 18
IR_VERSION = 9
CONTRIBUTED = "com.microsoft"
"""Where ONNX Runtime's own operations are, of which products by blocks are one,"""
SUMS_OF_BYTES = 4
"""and its name for sums of products of bytes."""
BYTES = 127.0
LEAST = 1e-9
"""Least scale of a row, of one that is nothing but zeros."""
MIDDLE = 128
"""What zero is as a byte without sign."""
BLOCK = 64
"""Weights that have a scale of their own: of 16 to 128 those that take the least time."""
ROWS_AT_ONCE = 512
"""Rows that become bytes together, while they are near the processor: an embedding has twenty million weights."""

Variables: TypeAlias = Mapping[str, npt.NDArray[Any]]
"""Of a model, by name."""


def as_bytes(rows: npt.NDArray[Any]) -> tuple[npt.NDArray[np.int8], npt.NDArray[np.float32]]:
    """Rows of numbers as bytes, ``(n, width)``, and the scale of each, ``(n, 1)``, that makes them numbers again."""
    small = np.empty(rows.shape, np.int8)
    scales = np.empty((len(rows), 1), np.float32)
    for start in range(0, len(rows), ROWS_AT_ONCE):
        some = slice(start, start + ROWS_AT_ONCE)
        exact = rows[some].astype(np.float32)
        most = np.maximum(exact.max(axis=1, keepdims=True), -exact.min(axis=1, keepdims=True))
        scales[some] = np.maximum(most / np.float32(BYTES), np.float32(LEAST))
        np.divide(exact, scales[some], out=exact)
        small[some] = np.rint(exact, out=exact)
    return small, scales


def as_blocks(rows: npt.NDArray[Any]) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32]]:
    """Rows of numbers as bytes around 128, ``(n, blocks, BLOCK)``, the last block filled up with zeros, and the scale
    of each block, ``(n, blocks)``."""
    count, width = rows.shape
    blocks = -(-width // BLOCK)
    filled = np.zeros((count, blocks * BLOCK), np.float32)
    filled[:, :width] = rows
    small, scales = as_bytes(filled.reshape(-1, BLOCK))
    return (small.astype(np.int16) + MIDDLE).astype(np.uint8).reshape(count, blocks, BLOCK), scales.reshape(
        count, blocks
    )


class GraphWriter:
    """A graph that is being written.

    Args:
        variables: weights ``name/weight`` (outputs, inputs), and biases ``name/bias``.
        blocks: whether products are by blocks.
    """

    def __init__(self, variables: Variables, *, blocks: bool = False) -> None:
        self._variables = variables
        self._blocks = blocks
        self._nodes: list[Any] = []
        self._constants: list[Any] = []

    def constant(self, value: npt.NDArray[Any]) -> str:
        """A constant under a name of its own."""
        from onnx import numpy_helper

        name = f"constant_{len(self._constants)}"
        self._constants.append(numpy_helper.from_array(np.ascontiguousarray(value), name))
        return name

    def op(self, kind: str, *inputs: str, name: str = "", domain: str = "", **attributes: Any) -> str:
        """What an operation gives; under a name if it has one."""
        from onnx import helper

        output = name or f"value_{len(self._nodes)}"
        self._nodes.append(helper.make_node(kind, inputs, [output], domain=domain, **attributes))
        return output

    def split(self, value: str, columns: Sequence[int]) -> list[str]:
        """Parts of so many columns each."""
        from onnx import helper

        outputs = [f"value_{len(self._nodes)}_{place}" for place in range(len(columns))]
        sizes = self.constant(np.array(columns))
        self._nodes.append(helper.make_node("Split", [value, sizes], outputs, axis=1))
        return outputs

    def linear(self, value: str, name: str) -> str:
        """``value`` by the weights of a name, with its bias if it has one."""
        product = self._by_blocks(value, name) if self._blocks else self.by_bytes(value, name)
        bias = self._variables.get(f"{name}/bias")
        return product if bias is None else self.op("Add", product, self.constant(bias.astype(np.float32)))

    def by_bytes(self, value: str, name: str) -> str:
        """``value`` by the weights of a name, with one scale for each row and one for each output."""
        small, scales = as_bytes(self._variables[f"{name}/weight"])
        most = self.op("ReduceMax", self.op("Abs", value), self.constant(np.array([-1])), keepdims=1)
        scale = self.op("Div", self.op("Max", most, self.number(LEAST)), self.number(BYTES))
        rounded = self.op("Add", self.op("Round", self.op("Div", value, scale)), self.number(MIDDLE))
        sums = self.op(
            "MatMulInteger",
            self.op("Cast", rounded, to=_type("UINT8")),
            self.constant(small.T),
            self.constant(np.array(MIDDLE, np.uint8)),
            self.constant(np.array(0, np.int8)),
        )
        scaled = self.op("Mul", self.op("Cast", sums, to=_type("FLOAT")), scale)
        return self.op("Mul", scaled, self.constant(scales[:, 0]))

    def _by_blocks(self, value: str, name: str) -> str:
        weights = self._variables[f"{name}/weight"]
        small, scales = as_blocks(weights)
        outputs, width = weights.shape
        return self.op(
            "MatMulNBits",
            value,
            self.constant(small),
            self.constant(scales.ravel()),
            domain=CONTRIBUTED,
            K=width,
            N=outputs,
            bits=8,
            block_size=BLOCK,
            accuracy_level=SUMS_OF_BYTES,
        )

    def number(self, value: float) -> str:
        """A constant."""
        return self.constant(np.array(value, np.float32))

    def written(self, inputs: Mapping[str, tuple[Any, ...]], outputs: list[str]) -> bytes:
        """The graph in ONNX."""
        from onnx import helper

        graph = helper.make_graph(
            self._nodes,
            "graph",
            [helper.make_tensor_value_info(name, _type("FLOAT"), shape) for name, shape in inputs.items()],
            [helper.make_tensor_value_info(name, _type("FLOAT"), None) for name in outputs],
            self._constants,
        )
        known = [helper.make_opsetid("", OPSET), helper.make_opsetid(CONTRIBUTED, 1)]
        model = helper.make_model(graph, opset_imports=known, ir_version=IR_VERSION)
        return bytes(model.SerializeToString())


def _type(name: str) -> int:
    from onnx import TensorProto

    return int(TensorProto.DataType.Value(name))
