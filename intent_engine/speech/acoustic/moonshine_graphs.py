"""The decoder of a Moonshine model as graphs (:mod:`~intent_engine.speech.acoustic.decoder_graphs`)."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from intent_engine.speech.acoustic.decoder_graphs import DecoderGraph

__all__ = ["PLACES", "TURNS", "MoonshineGraph", "looking"]

PLACES = "places"
"""Of rows in their texts, from 0, (n, 1, 1)."""
TURNS = "rotary_emb/weight"
"""Name of how fast each pair of a head's first columns turns from place to place, in rad."""


def looking(layer: int) -> str:
    """Name of what rows ask of each other, and are to each other as keys and values, in one."""
    return f"layers.{layer}/self_attn/qkv_proj"


class MoonshineGraph(DecoderGraph):
    """With the published names of the weights. What rows ask of each other, and are to each other, is turned by their
    places (rotary embedding, https://arxiv.org/abs/2104.09864), in pairs of neighbouring columns."""

    last = "norm"
    beside: ClassVar = {PLACES: ("n", 1, 1)}

    def heard(self, features: str, layer: int) -> tuple[str, str]:
        keys, values = (self.linear(features, f"layers.{layer}/encoder_attn/{one}_proj") for one in "kv")
        return keys, values

    def looks(self, rows: str, layer: int) -> tuple[str, str, str]:
        asked = self.linear(self.normal(rows, f"layers.{layer}/input_layernorm"), looking(layer))
        asks, keys, values = self.split(asked, (self.shape.width,) * 3)
        return self._turned(asks), self._turned(keys), values

    def seen_by(self, layer: int) -> str:
        return f"layers.{layer}/self_attn/dense"

    def listens(self, rows: str, layer: int) -> str:
        normal = self.normal(rows, f"layers.{layer}/post_attention_layernorm")
        return self.linear(normal, f"layers.{layer}/encoder_attn/q_proj")

    def heard_by(self, layer: int) -> str:
        return f"layers.{layer}/encoder_attn/dense"

    def thinks(self, rows: str, layer: int) -> str:
        """By a gated linear unit (SwiGLU, https://arxiv.org/abs/2002.05202)."""
        name = f"layers.{layer}/mlp"
        wide = self.linear(self.normal(rows, f"layers.{layer}/final_layernorm"), f"{name}/up_proj")
        half = self._variables[f"{name}/up_proj/weight"].shape[0] // 2
        value, gate = self.split(wide, (half, half))
        opened = self.op("Mul", gate, self.op("Sigmoid", gate))
        return self.linear(self.op("Mul", opened, value), f"{name}/down_proj")

    @cached_property
    def _angles(self) -> tuple[str, str, str]:
        """Cosine and sine of what each column of a head is turned by, and which column is the other of its pair."""
        speeds = self._variables[TURNS].ravel()
        each, sign = np.zeros((2, 1, 1, self.shape.head), np.float32)
        each[..., : 2 * speeds.size] = np.repeat(speeds, 2)
        sign[..., : 2 * speeds.size] = np.tile([-1.0, 1.0], speeds.size)
        other: Any = np.arange(self.shape.head)
        other[: 2 * speeds.size] ^= 1
        angles = self.op("Mul", PLACES, self.constant(each))
        sine = self.op("Mul", self.op("Sin", angles), self.constant(sign))
        return self.op("Cos", angles), sine, self.constant(other)

    def _turned(self, value: str) -> str:
        cosine, sine, other = self._angles
        headed = self.headed(value)
        across = self.op("Mul", self.op("Gather", headed, other, axis=2), sine)
        return self.flat(self.op("Add", self.op("Mul", headed, cosine), across))
