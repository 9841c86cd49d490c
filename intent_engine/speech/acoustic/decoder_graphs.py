"""Decoders of speech models as graphs for ONNX Runtime, in which a piece after a beginning is one row.

What decodes whole texts computes beginnings that are alike anew for each. Here a row is told which other rows come
before it, so that it is computed once (:mod:`~intent_engine.speech.acoustic.prefix_tree`). A decoder is three graphs:
what its layers hear of a sound, once; some pieces more; and what may come next.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from intent_engine.speech.acoustic.graph_writer import GraphWriter, Variables

__all__ = ["EMBEDDINGS", "DecoderGraph", "DecoderShape", "listening", "stepping", "telling"]

EMBEDDINGS = "embeddings"
"""Name of what pieces are."""
EPSILON = 1e-5
"""Of layer normalisation, as OpenAI's code and Moonshine's graphs have it."""


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


class DecoderGraph(GraphWriter, ABC):
    """A decoder whose layers look at what was written, listen, and think.

    Args:
        variables: as of :class:`GraphWriter`, and ``name/gamma`` and ``name/beta`` of normalisations.
        shape: of the decoder.
        blocks: as of :class:`GraphWriter`.
    """

    def __init__(self, variables: Variables, shape: DecoderShape, *, blocks: bool = False) -> None:
        super().__init__(variables, blocks=blocks)
        self.shape = shape
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

    # -- parts of it ------------------------------------------------------------------------------

    def normal(self, value: str, name: str, to: str = "") -> str:
        """Layer normalisation; under a name if it has one."""
        known = [self._variables[of] for of in (f"{name}/gamma", f"{name}/beta") if of in self._variables]
        gamma_beta = (self.constant(one.astype(np.float32)) for one in known)
        return self.op("LayerNormalization", value, *gamma_beta, name=to, axis=-1, epsilon=EPSILON)

    def headed(self, value: str) -> str:
        """(n, width) -> (n, heads, head)"""
        return self.op("Reshape", value, self._heads)

    def flat(self, value: str) -> str:
        """(n, heads, head) -> (n, width)"""
        return self.op("Reshape", value, self._flat)

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
    ``totals`` (n, 1): the product of a thought with the embedding of a piece, less its total, is that as well, which
    is why it is never by blocks."""
    scores = graph.by_bytes("thoughts", EMBEDDINGS)
    # ONNX Runtime's ReduceLogSumExp takes half a millisecond a row, more than the product itself; LogSoftmax a tenth of
    # that, and the total is what it takes off, of the first piece as of any.
    chances = graph.op("LogSoftmax", scores, name="chances", axis=-1)
    first = [graph.constant(np.array([place])) for place in (0, 1, 1)]
    before, after = (graph.op("Slice", of, *first) for of in (scores, chances))
    totals = graph.op("Sub", before, after, name="totals")
    return graph.written({"thoughts": ("n", graph.shape.width)}, [chances, totals])
