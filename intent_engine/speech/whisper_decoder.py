"""What a Whisper model thinks of every piece after every beginning of a text, each computed once for a sound.

Sentences of a grammar begin alike, and are asked about again and again: as likely ones, beside others, after a "don't".
So the beginnings of one sound are a tree, in which a piece knows those before it; only what is new is computed, all of
it in one call.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.speech.ctranslate2_file import read_variables
from intent_engine.speech.onnx_sessions import load_graph
from intent_engine.speech.whisper import WhisperRecognizer
from intent_engine.speech.whisper_graphs import DecoderShape, listening, stepping, telling

__all__ = ["PrefixTree", "WhisperDecoder", "own_decoder"]

HIDDEN = -1e9
"""Added to how much a piece looks at another that does not come before it."""
AT_ONCE = 48
"""Pieces computed in one call: enough to fill the processor, and 10 MB of chances."""
ROOM = 256
"""Pieces for which there is room at first; it doubles."""

Beginning = tuple[int, ...]
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
        self.shape = DecoderShape.of(variables)
        self.embeddings = variables["embeddings/weight"]
        self.places = variables["position_encodings/encodings"].astype(np.float32)
        config = json.loads((folder / "config.json").read_text("utf-8"))
        self.never: npt.NDArray[np.int64] = np.array(config.get("suppress_ids", []), np.int64)
        """Pieces that are not written: noises and signs."""
        self.never_first: npt.NDArray[np.int64] = np.array(config.get("suppress_ids_begin", []), np.int64)
        """Pieces that are not written at the beginning."""
        self.listening, self.stepping, self.telling = (
            load_graph(graph(variables)) for graph in (listening, stepping, telling)
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

    def tree(self, features: _Floats, prompt: Sequence[int]) -> PrefixTree:
        """The beginnings of texts for one sound.

        Args:
            features: ``(sounds, width)``, from the encoder.
            prompt: pieces before every text.
        """
        return PrefixTree(self, features, tuple(prompt))


class PrefixTree:
    """What the model thinks of one sound. For one thread at a time. Made by :meth:`WhisperDecoder.tree`."""

    def __init__(self, decoder: WhisperDecoder, features: _Floats, prompt: Beginning) -> None:
        self._decoder = decoder
        self.prompt = prompt
        names = [output.name for output in decoder.listening.get_outputs()]
        self._heard = dict(zip(names, decoder.listening.run(None, {"features": features}), strict=True))
        width = decoder.shape.width
        self._known = [np.empty((ROOM, width), np.float32) for _ in range(2 * decoder.shape.layers)]
        """Keys and values of every layer, a row for each piece."""
        self._thoughts = np.empty((ROOM, width), np.float32)
        self._totals = np.empty(ROOM, np.float32)
        self._number: dict[Beginning, int] = {}
        self._lines: list[list[int]] = []
        """For each piece those before it and itself."""

    def chances(self, beginnings: Iterable[Beginning]) -> dict[Beginning, _Floats]:
        """The log probability of every next piece, ``(pieces,)``, after some beginnings."""
        wanted = dict.fromkeys(beginnings)
        found = {whole[len(self.prompt) :]: row for whole, row in self._grow(wanted)}
        again = [one for one in wanted if one not in found]
        if again:
            numbers = [self._number[self.prompt + one] for one in again]
            rows, _ = self._decoder.telling.run(None, {"thoughts": self._thoughts[numbers]})
            found.update(zip(again, rows, strict=True))
        return {one: found[one] for one in wanted}

    def likelihood(self, pieces: Sequence[int]) -> _Floats:
        """Log probability of each piece of a text, ``(n,)``. What it begins with must be known."""
        numbers = [self._number[self.prompt + tuple(pieces[:place])] for place in range(len(pieces))]
        embeddings = self._decoder.embeddings[np.asarray(pieces)].astype(np.float32)
        likely: _Floats = np.einsum("ij,ij->i", self._thoughts[numbers], embeddings) - self._totals[numbers]
        return likely

    def learn(self, texts: Iterable[Sequence[int]]) -> None:
        """Get to know what some texts begin with: all but the last piece of each."""
        for _ in self._grow(tuple(text[:-1]) for text in texts):
            pass

    def _grow(self, beginnings: Iterable[Beginning]) -> Iterator[tuple[Beginning, _Floats]]:
        """Compute what is new in some beginnings and in those that they begin with: (with the prompt, chances)."""
        fresh: dict[Beginning, None] = {}
        for whole in (self.prompt + beginning for beginning in beginnings):
            if whole not in self._number:
                parts = (whole[:length] for length in range(1, len(whole) + 1))
                fresh.update((part, None) for part in parts if part not in self._number)
        new = list(fresh)
        for start in range(0, len(new), AT_ONCE):
            some = new[start : start + AT_ONCE]
            yield from zip(some, self._step(some), strict=True)

    def _step(self, new: Sequence[Beginning]) -> _Floats:
        """Compute one piece each, the last of some beginnings of which all else is known or stands before them."""
        decoder, known = self._decoder, len(self._lines)
        all_ = known + len(new)
        while all_ > len(self._totals):
            self._known = [np.concatenate((one, np.empty_like(one))) for one in self._known]
            self._thoughts = np.concatenate((self._thoughts, np.empty_like(self._thoughts)))
            self._totals = np.concatenate((self._totals, np.empty_like(self._totals)))
        number = self._number | {whole: known + row for row, whole in enumerate(new)}
        lines = self._lines.copy()
        hidden = np.full((len(new), all_), HIDDEN, np.float32)
        for row, whole in enumerate(new):
            line = lines[number[whole[:-1]]] if len(whole) > 1 else []
            lines.append([*line, known + row])
            hidden[row, lines[-1]] = 0.0
        rows = decoder.embeddings[[whole[-1] for whole in new]].astype(np.float32)
        rows += decoder.places[[len(whole) - 1 for whole in new]]
        names = [f"{kind}_{layer}" for layer in range(decoder.shape.layers) for kind in ("keys", "values")]
        earlier = {name: one[:known] for name, one in zip(names, self._known, strict=True)}
        told: Mapping[str, Any] = {"rows": rows, "hidden": hidden, **self._heard, **earlier}
        thoughts, *own = decoder.stepping.run(None, told)
        chances, totals = decoder.telling.run(None, {"thoughts": thoughts})
        # Only now, since a call that fails must leave nothing half known.
        self._lines, self._number = lines, number
        self._thoughts[known:all_] = thoughts
        self._totals[known:all_] = totals[:, 0]
        for one, new_ in zip(self._known, own, strict=True):
            one[known:all_] = new_
        found: _Floats = chances
        return found


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
