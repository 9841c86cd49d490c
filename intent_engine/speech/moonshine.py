"""Moonshine through ONNX Runtime: a small English model of another make than Whisper.

It hears other things than Whisper does, and not what Whisper mishears, so it is worth much as a second opinion
(:mod:`~intent_engine.speech.second_opinion`). Its encoder takes as long as the sound is, with no padding. By Useful
Sensors, MIT licence, https://arxiv.org/abs/2410.15608.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.errors import WeightsError
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.loops import fold_loop
from intent_engine.speech.moonshine_graphs import BEGIN, ENCODER, STEP
from intent_engine.speech.moonshine_pieces import BEGINNING, END, MoonshinePieces
from intent_engine.speech.moonshine_weights import find_moonshine
from intent_engine.speech.onnx_sessions import load_graph
from intent_engine.speech.recognizer import Encoded, Transcript
from intent_engine.speech.scoring import Scoring

__all__ = ["MoonshineRecognizer", "ScoringMoonshine"]

LEAST_SECONDS = 0.5
"""Shorter sound is padded: the first layers of the encoder need some."""
MOST_SECONDS = 20.0
"""Longer sound is cut, as an utterance is."""
PIECES_PER_SECOND = 7
"""More than anybody speaks (its authors take 6.5 words); bounds a decode that runs away."""
RETRY_MARGIN = 0.5
"""s of silence after the speech with which it is tried again."""
AT_ONCE = 8
"""Texts that are scored in one call."""


class MoonshineRecognizer:
    """Free decoding with a Moonshine model, in English. Life cycle: made (loaded) -> ``transcribe`` ... -> ``close()``.

    Args:
        model: "moonshine-base", or a folder as Moonshine publishes it: ``encoder_model.ort``,
            ``decoder_model_merged.ort``, ``tokenizer.bin``.
        threads: of the processor; a small model is fastest with one.
        tell: is told what takes long: that the weights are made ready, once on a machine.

    Raises:
        WeightsError: the model cannot be found or loaded.
    """

    language: str | None = "en"
    multilingual = False
    device = "cpu"

    def __init__(
        self, model: str = "moonshine-base", *, threads: int = 1, tell: Callable[[str], object] | None = None
    ) -> None:
        folder = find_moonshine(model, tell)
        try:
            self._encoder, self._begin, self._step = (
                load_graph(str(folder.graphs / name), threads) for name in (ENCODER, BEGIN, STEP)
            )
            self._tokenizer = MoonshinePieces(folder.tokenizer)
        except Exception as error:  # ONNX Runtime's errors have no common class
            raise WeightsError(
                f"model {model} cannot be loaded from {folder.graphs}: {error}\n"
                "    delete that folder; it is made again"
            ) from None
        self._last: tuple[Encoded, npt.NDArray[np.float32], dict[str, Any]] | None = None
        """What was begun last."""
        self._told = [output.name.removeprefix("told_") for output in self._begin.get_outputs()[1:]]
        self._told_by_step = [output.name.removeprefix("told_") for output in self._step.get_outputs()[1:]]

    def tokenizer(self, language: str | None = None) -> Any:
        """The pieces that it writes in."""
        return self._tokenizer

    def encode(self, samples: Samples, seconds: float = 0.0) -> Encoded:
        """Encode speech, padded to at least ``seconds``."""
        samples = samples[: int(MOST_SECONDS * SAMPLE_RATE)]
        least = int(max(seconds, LEAST_SECONDS) * SAMPLE_RATE)
        if samples.size < least:
            samples = np.pad(samples, (0, least - samples.size))
        (states,) = self._encoder.run(None, {"input_values": samples[np.newaxis].astype(np.float32)})
        return Encoded(states, samples.size / SAMPLE_RATE)

    def detect(self, encoded: Encoded) -> str:
        """The language of the speech: the only one that it knows."""
        return "en"

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        if samples.size == 0:
            return Transcript("")
        began = time.perf_counter()
        return replace(self._heard(samples, final=final), decode_seconds=time.perf_counter() - began)

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        text, score, _ = self.greedy(self.encode(samples))
        return Transcript(text, score, free_text=text, language="en")

    def greedy(self, encoded: Encoded, language: str | None = None) -> tuple[str, float, bool]:
        """The likeliest words: (text, mean log probability, whether it went round in a loop)."""
        pieces, rows = self._greedy(encoded)
        score = sum(float(row.max()) for row in rows) / len(rows)
        text = self._tokenizer.decode(pieces)
        folded = fold_loop(text)
        return folded, score, folded != text

    def _greedy(self, encoded: Encoded) -> tuple[list[int], list[npt.NDArray[np.float32]]]:
        """The likeliest pieces, and the log probabilities of every piece in the place of each, and after the last."""
        first, past = self._begun(encoded)
        pieces: list[int] = []
        rows = [first]
        for _ in range(int(encoded.seconds * PIECES_PER_SECOND) + 7):
            piece = int(rows[-1].argmax())
            if piece == END:
                break
            pieces.append(piece)
            onward, *known = self._step.run(None, {"input_ids": [[piece]], **past})
            past |= {_past(name): value for name, value in zip(self._told_by_step, known, strict=True)}
            rows.append(_log_probabilities(onward[0, -1]))
        return pieces, rows

    def _begun(self, encoded: Encoded) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        """The log probabilities of every first piece, and what a step needs to know before it: what every layer hears
        of the sound, above all, which takes as long as a text."""
        if self._last is None or self._last[0] is not encoded:
            asked = {"input_ids": [[BEGINNING]], "encoder_hidden_states": encoded.features}
            begun, *known = self._begin.run(None, asked)
            past = {_past(name): value for name, value in zip(self._told, known, strict=True)}
            self._last = encoded, _log_probabilities(begun[0, -1]), past
        _, first, past = self._last
        return first.copy(), dict(past)

    def rows(self, encoded: Encoded, beginnings: Sequence[Sequence[int]]) -> Iterator[list[npt.NDArray[np.float32]]]:
        """For each of some beginnings of a text, the log probabilities of every piece at each of its places, and after
        it: ``(vocabulary,)`` each."""
        first, past = self._begun(encoded)
        for start in range(0, len(beginnings), AT_ONCE):
            some = beginnings[start : start + AT_ONCE]
            longest = max(map(len, some))
            if not longest:
                yield from ([first] for _ in some)
                continue
            asked: dict[str, Any] = {name: np.repeat(value, len(some), axis=0) for name, value in past.items()}
            asked["input_ids"] = [[*one, *[END] * (longest - len(one))] for one in some]
            (onward,) = self._step.run([self._step.get_outputs()[0].name], asked)
            for own, one in zip(onward, some, strict=True):
                yield [first, *_log_probabilities(own[: len(one)])]

    def close(self) -> None:
        """Nothing to let go of but memory."""


class ScoringMoonshine(MoonshineRecognizer, Scoring):
    """A Moonshine model that is asked what it thinks of words. Made and closed as :class:`MoonshineRecognizer`.

    It ends a sentence with a full stop or without, so what ends one is all of that together.
    """

    def longer(self, seconds: float) -> float:
        return seconds + RETRY_MARGIN

    def _greedy(self, encoded: Encoded) -> tuple[list[int], list[npt.NDArray[np.float32]]]:
        pieces, rows = super()._greedy(encoded)
        self._decoded = (encoded, {tuple(pieces[:place]): row for place, row in enumerate(rows)})
        return pieces, rows

    def end_piece(self, language: str | None = None) -> int:
        return END

    def next_pieces(
        self, encoded: Encoded, beginnings: Sequence[tuple[int, ...]], length: int, language: str | None = None
    ) -> Iterator[tuple[tuple[int, ...], Any]]:
        for beginning, rows in zip(beginnings, self.rows(encoded, beginnings), strict=True):
            for place, row in enumerate(rows):
                ended = row.copy()
                ended[END] = self._ended(row)
                yield beginning[:place], ended

    def _pieces(self, encoded: Encoded, texts: Sequence[str], language: str | None) -> list[Any]:
        plain = [text.strip().rstrip(".!?") for text in texts]
        pieces = [self._tokenizer.encode(" " + text) if text else [] for text in plain]
        return [
            np.array([*(rows[place][piece] for place, piece in enumerate(own)), self._ended(rows[len(own)])])
            for own, rows in zip(pieces, self.rows(encoded, pieces), strict=True)
        ]

    def _ended(self, row: npt.NDArray[np.float32]) -> float:
        """Log probability that the sentence ends here."""
        ends = [END, *(piece for sign in ".?!" for piece in self._tokenizer.encode(sign))]
        return float(np.logaddexp.reduce(row[ends]))


def _past(name: str) -> str:
    """What a step is told as, of what was told before it."""
    return name.replace("present", "past_key_values")


def _log_probabilities(rows: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Of logits, in their place: there are millions of them."""
    rows -= rows.max(axis=-1, keepdims=True)
    rows -= np.log(np.exp(rows).sum(axis=-1, keepdims=True))
    return rows
