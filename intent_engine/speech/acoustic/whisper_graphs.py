"""The decoder of a Whisper model in CTranslate2's form, as :mod:`~intent_engine.speech.acoustic.decoder_graphs`."""

from __future__ import annotations

from intent_engine.speech.acoustic.decoder_graphs import DecoderGraph, DecoderShape
from intent_engine.speech.acoustic.graph_writer import Variables

__all__ = ["WhisperGraph", "whisper_shape"]


def whisper_shape(variables: Variables) -> DecoderShape:
    """How large a decoder is.

    Raises:
        ValueError: these are not the variables of a decoder with unquantised weights.
    """
    try:
        _, width = variables["embeddings/weight"].shape
        heads = int(variables["num_heads"])
    except (KeyError, TypeError) as error:
        raise ValueError(f"no decoder of Whisper: {error}") from None
    if variables["embeddings/weight"].dtype.kind != "f":
        raise ValueError("the weights are quantised")
    layers = 0
    while f"layer_{layers}/ffn/linear_0/weight" in variables:
        layers += 1
    return DecoderShape(layers, heads, width)


class WhisperGraph(DecoderGraph):
    """With CTranslate2's names of the weights."""

    last = "layer_norm"

    def heard(self, features: str, layer: int) -> tuple[str, str]:
        keys, values = self.split(self.linear(features, f"layer_{layer}/attention/linear_1"), (self.shape.width,) * 2)
        return keys, values

    def looks(self, rows: str, layer: int) -> tuple[str, str, str]:
        name = f"layer_{layer}/self_attention"
        asked = self.linear(self.normal(rows, f"{name}/layer_norm"), f"{name}/linear_0")
        asks, keys, values = self.split(asked, (self.shape.width,) * 3)
        return asks, keys, values

    def seen_by(self, layer: int) -> str:
        return f"layer_{layer}/self_attention/linear_1"

    def listens(self, rows: str, layer: int) -> str:
        name = f"layer_{layer}/attention"
        return self.linear(self.normal(rows, f"{name}/layer_norm"), f"{name}/linear_0")

    def heard_by(self, layer: int) -> str:
        return f"layer_{layer}/attention/linear_2"

    def thinks(self, rows: str, layer: int) -> str:
        name = f"layer_{layer}/ffn"
        inner = self.linear(self.normal(rows, f"{name}/layer_norm"), f"{name}/linear_0")
        return self.linear(self._gelu(inner), f"{name}/linear_1")

    def _gelu(self, value: str) -> str:
        """By the error function, as Whisper has it."""
        above = self.op("Add", self.op("Erf", self.op("Mul", value, self.number(0.5**0.5))), self.number(1.0))
        return self.op("Mul", self.op("Mul", value, above), self.number(0.5))
