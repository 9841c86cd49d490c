"""Whisper's decoder as three graphs for ONNX Runtime, from the weights of a CTranslate2 model.

CTranslate2 decodes whole texts: what is asked about many texts that begin alike is computed anew for each. Here a piece
after a beginning is one row, told which other rows come before it, so that a row is computed once
(:mod:`~intent_engine.speech.whisper_decoder`).

Weights are bytes, with a scale for each output; what they are multiplied with becomes bytes row by row, as CTranslate2
does it, so that a row is the same whatever else is asked about beside it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["DecoderShape", "listening", "stepping", "telling"]

OPSET = 18
IR_VERSION = 9
EPSILON = 1e-5
"""Of layer normalisation, as OpenAI's code has it."""
BYTES = 127.0
LEAST = 1e-9
"""Least scale of a row, of one that is nothing but zeros."""
MIDDLE = 128
"""What zero is as a byte without sign."""

Variables = Mapping[str, npt.NDArray[Any]]
"""Of a model's decoder, by name."""


@dataclass(frozen=True, slots=True)
class DecoderShape:
    """How large a decoder is."""

    layers: int
    heads: int
    width: int
    pieces: int

    @classmethod
    def of(cls, variables: Variables) -> DecoderShape:
        """Raises:
        ValueError: these are not the variables of a decoder with unquantised weights.
        """
        try:
            pieces, width = variables["embeddings/weight"].shape
            heads = int(variables["num_heads"])
        except (KeyError, TypeError) as error:
            raise ValueError(f"no decoder of Whisper: {error}") from None
        if variables["embeddings/weight"].dtype.kind != "f":
            raise ValueError("the weights are quantised")
        layers = 0
        while f"layer_{layers}/ffn/linear_0/weight" in variables:
            layers += 1
        return cls(layers, heads, width, pieces)


def listening(variables: Variables) -> bytes:
    """What the layers hear: ``features`` (sounds, width) -> for each layer ``heard_keys_0`` (heads, head, sounds) and
    ``heard_values_0`` (heads, sounds, head)."""
    shape = DecoderShape.of(variables)
    graph = _Graph(variables, shape)
    outputs = []
    for layer in range(shape.layers):
        both = graph.linear("features", f"layer_{layer}/attention/linear_1")
        keys, values = graph.split(both, 2)
        for name, one, axes in ((f"heard_keys_{layer}", keys, (1, 2, 0)), (f"heard_values_{layer}", values, (1, 0, 2))):
            outputs.append(graph.op("Transpose", graph.headed(one), name=name, perm=axes))
    return graph.written({"features": ("sounds", shape.width)}, outputs)


def stepping(variables: Variables) -> bytes:
    """Some pieces more: ``rows`` (n, width), what they are; ``hidden`` (n, known + n), 0 where one sees another and far
    below where not; for each layer what it knows (``keys_0``, ``values_0``: (known, width)) and what it hears
    (:func:`listening`) -> ``thoughts`` (n, width), for :func:`telling`, and ``own_keys_0``, ``own_values_0`` (n,
    width), which each layer is to know from now on."""
    shape = DecoderShape.of(variables)
    graph = _Graph(variables, shape)
    inputs: dict[str, tuple[Any, ...]] = {"rows": ("n", shape.width), "hidden": ("n", "all")}
    outputs = ["thoughts"]
    rows = "rows"
    for layer in range(shape.layers):
        name = f"layer_{layer}"
        keys, values = f"own_keys_{layer}", f"own_values_{layer}"
        inputs |= dict.fromkeys((f"keys_{layer}", f"values_{layer}"), ("known", shape.width))
        inputs[f"heard_keys_{layer}"] = (shape.heads, shape.width // shape.heads, "sounds")
        inputs[f"heard_values_{layer}"] = (shape.heads, "sounds", shape.width // shape.heads)
        outputs += [keys, values]

        asked = graph.linear(graph.normal(rows, f"{name}/self_attention/layer_norm"), f"{name}/self_attention/linear_0")
        asks, _, _ = graph.split(asked, 3, names=("", keys, values))
        all_keys = graph.op("Concat", f"keys_{layer}", keys, axis=0)
        all_values = graph.op("Concat", f"values_{layer}", values, axis=0)
        seen = graph.attention(
            asks,
            graph.op("Transpose", graph.headed(all_keys), perm=(1, 2, 0)),
            graph.op("Transpose", graph.headed(all_values), perm=(1, 0, 2)),
            "hidden",
        )
        rows = graph.op("Add", rows, graph.linear(seen, f"{name}/self_attention/linear_1"))

        asks = graph.linear(graph.normal(rows, f"{name}/attention/layer_norm"), f"{name}/attention/linear_0")
        heard = graph.attention(asks, f"heard_keys_{layer}", f"heard_values_{layer}")
        rows = graph.op("Add", rows, graph.linear(heard, f"{name}/attention/linear_2"))

        inner = graph.linear(graph.normal(rows, f"{name}/ffn/layer_norm"), f"{name}/ffn/linear_0")
        rows = graph.op("Add", rows, graph.linear(graph.gelu(inner), f"{name}/ffn/linear_1"))
    graph.normal(rows, "layer_norm", to="thoughts")
    return graph.written(inputs, outputs)


def telling(variables: Variables) -> bytes:
    """What comes next: ``thoughts`` (n, width) -> ``chances`` (n, pieces), the log probability of each piece, and
    ``totals`` (n, 1): the product of a thought with the embedding of a piece, less its total, is that as well."""
    shape = DecoderShape.of(variables)
    graph = _Graph(variables, shape)
    scores = graph.linear("thoughts", "embeddings")
    totals = graph.op("ReduceLogSumExp", scores, graph.constant(np.array([-1])), name="totals", keepdims=1)
    return graph.written({"thoughts": ("n", shape.width)}, [graph.op("Sub", scores, totals, name="chances"), "totals"])


class _Graph:
    """A graph that is being written."""

    def __init__(self, variables: Variables, shape: DecoderShape) -> None:
        self._variables = variables
        self._shape = shape
        self._nodes: list[Any] = []
        self._constants: list[Any] = []
        self._heads = self.constant(np.array([-1, shape.heads, shape.width // shape.heads]))
        self._flat = self.constant(np.array([-1, shape.width]))

    def constant(self, value: npt.NDArray[Any]) -> str:
        from onnx import numpy_helper

        name = f"constant_{len(self._constants)}"
        self._constants.append(numpy_helper.from_array(np.ascontiguousarray(value), name))
        return name

    def op(self, kind: str, *inputs: str, name: str = "", **attributes: Any) -> str:
        """What an operation gives; under a name if it has one."""
        from onnx import helper

        output = name or f"value_{len(self._nodes)}"
        self._nodes.append(helper.make_node(kind, inputs, [output], **attributes))
        return output

    def split(self, value: str, count: int, names: tuple[str, ...] = ()) -> list[str]:
        """Parts of the width of the model."""
        from onnx import helper

        names = names or ("",) * count
        outputs = [name or f"value_{len(self._nodes)}_{place}" for place, name in enumerate(names)]
        sizes = self.constant(np.full(count, self._shape.width))
        self._nodes.append(helper.make_node("Split", [value, sizes], outputs, axis=1))
        return outputs

    def linear(self, value: str, name: str) -> str:
        """``value`` by the weights of a name, with its bias if it has one."""
        weights = self._variables[f"{name}/weight"].astype(np.float32)
        scales = np.maximum(np.abs(weights).max(axis=1) / BYTES, LEAST).astype(np.float32)
        # In place, and the other way round in memory afterwards: an embedding has twenty million weights.
        np.divide(weights, scales[:, np.newaxis], out=weights)
        small = np.round(weights, out=weights).astype(np.int8).T
        most = self.op("ReduceMax", self.op("Abs", value), self.constant(np.array([-1])), keepdims=1)
        scale = self.op("Div", self.op("Max", most, self._number(LEAST)), self._number(BYTES))
        rounded = self.op("Add", self.op("Round", self.op("Div", value, scale)), self._number(MIDDLE))
        sums = self.op(
            "MatMulInteger",
            self.op("Cast", rounded, to=_type("UINT8")),
            self.constant(small),
            self.constant(np.array(MIDDLE, np.uint8)),
            self.constant(np.array(0, np.int8)),
        )
        scaled = self.op("Mul", self.op("Cast", sums, to=_type("FLOAT")), scale)
        product = self.op("Mul", scaled, self.constant(scales))
        bias = self._variables.get(f"{name}/bias")
        return product if bias is None else self.op("Add", product, self.constant(bias.astype(np.float32)))

    def normal(self, value: str, name: str, to: str = "") -> str:
        gamma, beta = (self.constant(self._variables[f"{name}/{one}"].astype(np.float32)) for one in ("gamma", "beta"))
        return self.op("LayerNormalization", value, gamma, beta, name=to, axis=-1, epsilon=EPSILON)

    def gelu(self, value: str) -> str:
        """By the error function, as Whisper has it."""
        above = self.op("Add", self.op("Erf", self.op("Mul", value, self._number(0.5**0.5))), self._number(1.0))
        return self.op("Mul", self.op("Mul", value, above), self._number(0.5))

    def headed(self, value: str) -> str:
        """(n, width) -> (n, heads, head)"""
        return self.op("Reshape", value, self._heads)

    def attention(self, asks: str, keys: str, values: str, hidden: str = "") -> str:
        head = self._shape.width // self._shape.heads
        asks = self.op("Mul", asks, self._number(head**-0.5))
        scores = self.op("MatMul", self.op("Transpose", self.headed(asks), perm=(1, 0, 2)), keys)
        if hidden:
            scores = self.op("Add", scores, hidden)
        found = self.op("MatMul", self.op("Softmax", scores, axis=-1), values)
        return self.op("Reshape", self.op("Transpose", found, perm=(1, 0, 2)), self._flat)

    def _number(self, value: float) -> str:
        return self.constant(np.array(value, np.float32))

    def written(self, inputs: Mapping[str, tuple[Any, ...]], outputs: list[str]) -> bytes:
        """The graph in ONNX."""
        from onnx import helper

        graph = helper.make_graph(
            self._nodes,
            "decoder",
            [helper.make_tensor_value_info(name, _type("FLOAT"), shape) for name, shape in inputs.items()],
            [helper.make_tensor_value_info(name, _type("FLOAT"), None) for name in outputs],
            self._constants,
        )
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR_VERSION)
        return bytes(model.SerializeToString())


def _type(name: str) -> int:
    from onnx import TensorProto

    return int(TensorProto.DataType.Value(name))
