"""Decoders of speech models as graphs for ONNX Runtime, in which a piece after a beginning is one row.

What decodes whole texts computes beginnings that are alike anew for each. Here a row is told which other rows come
before it, so that it is computed once (:mod:`~intent_engine.speech.acoustic.prefix_tree`). A decoder is three graphs:
what its layers hear of a sound, once; some pieces more; and what may come next.

Weights are bytes, with a scale for each output; what they are multiplied with becomes bytes row by row, as CTranslate2
does it, so that a row is the same whatever else is asked about beside it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, TypeAlias

import numpy as np
import numpy.typing as npt

__all__ = ["EMBEDDINGS", "DecoderGraph", "DecoderShape", "Variables", "as_bytes", "listening", "stepping", "telling"]

EMBEDDINGS = "embeddings"
"""Name of what pieces are."""
OPSET = 18
IR_VERSION = 9
EPSILON = 1e-5
"""Of layer normalisation, as OpenAI's code and Moonshine's graphs have it."""
BYTES = 127.0
LEAST = 1e-9
"""Least scale of a row, of one that is nothing but zeros."""
MIDDLE = 128
"""What zero is as a byte without sign."""
ROWS_AT_ONCE = 512
"""Rows that become bytes together, while they are near the processor: an embedding has twenty million weights."""

Variables: TypeAlias = Mapping[str, npt.NDArray[Any]]
"""Of a model's decoder, by name."""


@dataclass(frozen=True, slots=True)
class DecoderShape:
    """How large a decoder is."""

    layers: int
    heads: int
    width: int

    @property
    def head(self) -> int:
        """Width of a head."""
        return self.width // self.heads


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


class DecoderGraph(ABC):
    """A graph that is being written, of a decoder whose layers look at what was written, listen, and think.

    Args:
        variables: weights ``name/weight`` (outputs, inputs), biases ``name/bias``, and ``name/gamma`` and ``name/beta``
            of normalisations.
        shape: of the decoder.
    """

    def __init__(self, variables: Variables, shape: DecoderShape) -> None:
        self._variables = variables
        self.shape = shape
        self._nodes: list[Any] = []
        self._constants: list[Any] = []
        self._heads = self.constant(np.array([-1, shape.heads, shape.head]))
        self._flat = self.constant(np.array([-1, shape.width]))

    # -- what the decoder is ----------------------------------------------------------------------

    last: ClassVar[str]
    """Name of the normalisation after the last layer."""
    beside: ClassVar[Mapping[str, tuple[Any, ...]]] = {}
    """What a step is told of its rows besides, with shapes."""

    @abstractmethod
    def heard(self, features: str, layer: int) -> tuple[str, str]:
        """What a layer hears: keys and values (sounds, width)."""

    @abstractmethod
    def looks(self, rows: str, layer: int) -> tuple[str, str, str]:
        """What rows ask of those before them, and what they are to them: keys and values (n, width)."""

    @abstractmethod
    def seen_by(self, layer: int) -> str:
        """Name of what a layer makes of what it found there."""

    @abstractmethod
    def listens(self, rows: str, layer: int) -> str:
        """What rows ask of the sound (n, width)."""

    @abstractmethod
    def heard_by(self, layer: int) -> str:
        """Name of what a layer makes of what it found there."""

    @abstractmethod
    def thinks(self, rows: str, layer: int) -> str:
        """What a layer adds by itself (n, width)."""

    # -- writing ----------------------------------------------------------------------------------

    def constant(self, value: npt.NDArray[Any]) -> str:
        """A constant under a name of its own."""
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

    def split(self, value: str, columns: Sequence[int], names: tuple[str, ...] = ()) -> list[str]:
        """Parts of so many columns each."""
        from onnx import helper

        names = names or ("",) * len(columns)
        outputs = [name or f"value_{len(self._nodes)}_{place}" for place, name in enumerate(names)]
        sizes = self.constant(np.array(columns))
        self._nodes.append(helper.make_node("Split", [value, sizes], outputs, axis=1))
        return outputs

    def linear(self, value: str, name: str) -> str:
        """``value`` by the weights of a name, with its bias if it has one."""
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
        product = self.op("Mul", scaled, self.constant(scales[:, 0]))
        bias = self._variables.get(f"{name}/bias")
        return product if bias is None else self.op("Add", product, self.constant(bias.astype(np.float32)))

    def normal(self, value: str, name: str, to: str = "") -> str:
        """Layer normalisation; under a name if it has one."""
        known = [self._variables[of] for of in (f"{name}/gamma", f"{name}/beta") if of in self._variables]
        gamma_beta = (self.constant(one.astype(np.float32)) for one in known)
        return self.op("LayerNormalization", value, *gamma_beta, name=to, axis=-1, epsilon=EPSILON)

    def headed(self, value: str) -> str:
        """(n, width) -> (n, heads, head)"""
        return self.op("Reshape", value, self._heads)

    def flat(self, value: str, to: str = "") -> str:
        """(n, heads, head) -> (n, width); under a name if it has one."""
        return self.op("Reshape", value, self._flat, name=to)

    def keys(self, value: str, to: str = "") -> str:
        """(n, width) -> (heads, head, n), as attention takes keys."""
        return self.op("Transpose", self.headed(value), name=to, perm=(1, 2, 0))

    def values(self, value: str, to: str = "") -> str:
        """(n, width) -> (heads, n, head), as attention takes values."""
        return self.op("Transpose", self.headed(value), name=to, perm=(1, 0, 2))

    def attention(self, asks: str, keys: str, values: str, hidden: str = "") -> str:
        """What ``asks`` (n, width) find among keys and values, (n, width). ``hidden`` (n, all), if given: 0 where one
        sees another, far below where not."""
        asks = self.op("Mul", asks, self.number(self.shape.head**-0.5))
        scores = self.op("MatMul", self.values(asks), keys)
        if hidden:
            scores = self.op("Add", scores, hidden)
        found = self.op("MatMul", self.op("Softmax", scores, axis=-1), values)
        return self.flat(self.op("Transpose", found, perm=(1, 0, 2)))

    def number(self, value: float) -> str:
        """A constant."""
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


def listening(graph: DecoderGraph) -> bytes:
    """What the layers hear: ``features`` (sounds, width) -> for each layer ``heard_keys_0`` (heads, head, sounds) and
    ``heard_values_0`` (heads, sounds, head)."""
    outputs = []
    for layer in range(graph.shape.layers):
        keys, values = graph.heard("features", layer)
        outputs += [graph.keys(keys, f"heard_keys_{layer}"), graph.values(values, f"heard_values_{layer}")]
    return graph.written({"features": ("sounds", graph.shape.width)}, outputs)


def stepping(graph: DecoderGraph) -> bytes:
    """Some pieces more: ``rows`` (n, width), what they are; ``hidden`` (n, known + n), 0 where one sees another and far
    below where not; for each layer what it knows (``keys_0``, ``values_0``: (known, width)) and what it hears
    (:func:`listening`) -> ``thoughts`` (n, width), for :func:`telling`, and ``own_keys_0``, ``own_values_0`` (n,
    width), which each layer is to know from now on."""
    shape = graph.shape
    inputs: dict[str, tuple[Any, ...]] = {"rows": ("n", shape.width), "hidden": ("n", "all"), **graph.beside}
    outputs = []
    rows = "rows"
    for layer in range(shape.layers):
        inputs |= dict.fromkeys((f"keys_{layer}", f"values_{layer}"), ("known", shape.width))
        inputs[f"heard_keys_{layer}"] = (shape.heads, shape.head, "sounds")
        inputs[f"heard_values_{layer}"] = (shape.heads, "sounds", shape.head)

        asks, keys, values = graph.looks(rows, layer)
        outputs += [
            graph.op("Identity", own, name=f"own_{kind}_{layer}") for kind, own in (("keys", keys), ("values", values))
        ]
        all_keys = graph.op("Concat", f"keys_{layer}", keys, axis=0)
        all_values = graph.op("Concat", f"values_{layer}", values, axis=0)
        seen = graph.attention(asks, graph.keys(all_keys), graph.values(all_values), "hidden")
        rows = graph.op("Add", rows, graph.linear(seen, graph.seen_by(layer)))

        heard = graph.attention(graph.listens(rows, layer), f"heard_keys_{layer}", f"heard_values_{layer}")
        rows = graph.op("Add", rows, graph.linear(heard, graph.heard_by(layer)))
        rows = graph.op("Add", rows, graph.thinks(rows, layer))
    return graph.written(inputs, [graph.normal(rows, graph.last, to="thoughts"), *outputs])


def telling(graph: DecoderGraph) -> bytes:
    """What comes next: ``thoughts`` (n, width) -> ``chances`` (n, pieces), the log probability of each piece, and
    ``totals`` (n, 1): the product of a thought with the embedding of a piece, less its total, is that as well."""
    scores = graph.linear("thoughts", EMBEDDINGS)
    # ONNX Runtime's ReduceLogSumExp takes half a millisecond a row, more than the product itself; LogSoftmax a tenth of
    # that, and the total is what it takes off, of the first piece as of any.
    chances = graph.op("LogSoftmax", scores, name="chances", axis=-1)
    first = [graph.constant(np.array([place])) for place in (0, 1, 1)]
    before, after = (graph.op("Slice", of, *first) for of in (scores, chances))
    totals = graph.op("Sub", before, after, name="totals")
    return graph.written({"thoughts": ("n", graph.shape.width)}, [chances, totals])


def _type(name: str) -> int:
    from onnx import TensorProto

    return int(TensorProto.DataType.Value(name))
