"""The decoder of a small Whisper model on the processor, beside CTranslate2's."""

from __future__ import annotations

import json
import logging
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.block_products import blocks_are_quick
from intent_engine.speech.acoustic.ctranslate2_file import read_variables
from intent_engine.speech.acoustic.decoder_graphs import EMBEDDINGS, listening, stepping, telling
from intent_engine.speech.acoustic.graph_writer import as_bytes
from intent_engine.speech.acoustic.onnx_sessions import load_graph
from intent_engine.speech.acoustic.whisper import WhisperRecognizer
from intent_engine.speech.acoustic.whisper_graphs import WhisperGraph, whisper_shape

__all__ = ["WhisperDecoder", "own_decoder"]

_Floats = npt.NDArray[np.float32]


class WhisperDecoder:
    """The decoder of a Whisper model in CTranslate2's form, on one core.

    Args:
        folder: with ``model.bin``, weights in floats, and ``config.json``.

    Raises:
        OSError: a file cannot be read.
        ValueError: it is of another form.
    """

    def __init__(self, folder: Path) -> None:
        variables = read_variables(folder / "model.bin", "decoder/")
        shape = whisper_shape(variables)
        self._embeddings = variables[f"{EMBEDDINGS}/weight"]
        self.small, self.scales = as_bytes(self._embeddings)
        self._places = variables["position_encodings/encodings"].astype(np.float32)
        config = json.loads((folder / "config.json").read_text("utf-8"))
        self.never: npt.NDArray[np.int64] = np.array(config.get("suppress_ids", []), np.int64)
        """Pieces that are not written: noises and signs."""
        self.never_first: npt.NDArray[np.int64] = np.array(config.get("suppress_ids_begin", []), np.int64)
        """Pieces that are not written at the beginning."""
        blocks = blocks_are_quick()
        self.listening, self.stepping, self.telling = (
            load_graph(write(WhisperGraph(variables, shape, blocks=blocks))) for write in (listening, stepping, telling)
        )

    def able(self, chances: _Floats, *, first: bool) -> _Floats:
        """The log probability of every piece, if those that are never written are left out."""
        able = chances.copy()
        able[self.never] = -np.inf
        if first:
            able[self.never_first] = -np.inf
        # In music nearly all is on a note, which is never written, so the rest is summed up itself.
        likeliest = able.max()
        able -= likeliest + np.log(np.exp(able - likeliest).sum())
        return able

    def rows(self, pieces: Sequence[int], places: Sequence[int]) -> Mapping[str, _Floats]:
        """What a step is told of pieces at some places."""
        return {"rows": self._embeddings[pieces].astype(np.float32) + self._places[places]}


def own_decoder(recognizer: WhisperRecognizer) -> WhisperDecoder | None:
    """A decoder beside CTranslate2's, where it is quicker: of a small model on the processor. None: of no other, nor of
    a file of another form, such as one with weights in bytes."""
    if recognizer.device != "cpu" or not recognizer.small:
        return None
    try:
        return WhisperDecoder(recognizer.weights.path)
    except Exception as error:  # ONNX Runtime's errors have no common class; CTranslate2 does as well, but slower
        logging.getLogger(__name__).info("%s is asked through CTranslate2: %s", recognizer.weights.name, error)
        return None
