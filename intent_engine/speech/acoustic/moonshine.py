"""Moonshine through ONNX Runtime: a small English model of another make than Whisper.

It hears other things than Whisper does, and not what Whisper mishears, so it is worth much as a second opinion
(:mod:`~intent_engine.speech.second_opinion`). Its encoder takes as long as the sound is, with no padding. By Useful
Sensors, MIT licence, https://arxiv.org/abs/2410.15608.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.drafts import NOTHING_DRAFTED, Draft
from intent_engine.speech.acoustic.loops import fold_loop, goes_round
from intent_engine.speech.acoustic.moonshine_decoder import MoonshineDecoder
from intent_engine.speech.acoustic.moonshine_pieces import BEGINNING, END, MoonshinePieces
from intent_engine.speech.acoustic.moonshine_unfold import ENCODER
from intent_engine.speech.acoustic.moonshine_weights import find_moonshine
from intent_engine.speech.acoustic.onnx_sessions import load_graph
from intent_engine.speech.acoustic.prefix_tree import Beginning, PrefixTree, RecentTrees
from intent_engine.speech.acoustic.scoring import Scoring
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.leaving import Leaving
from intent_engine.speech.recognizer import Encoded, Transcript

__all__ = ["MoonshineModel", "MoonshineRecognizer", "ScoringMoonshine"]

_Floats: TypeAlias = npt.NDArray[np.float32]

LEAST_SECONDS = 0.5
"""Shorter sound is padded: the first layers of the encoder need some."""
MOST_SECONDS = 20.0
"""Longer sound is cut, as an utterance is."""
PIECES_PER_SECOND = 7
"""More than anybody speaks (its authors take 6.5 words); bounds a decode that runs away."""
RETRY_MARGIN = 0.5
"""s of silence after the speech with which it is tried again."""

SURELY_NOTHING = math.log(0.93)
"""Log probability of no word at all, from which nothing was said. It is asked about nothing but what a voice detector
took for speech, and yet ends 6 of 100 commands of synthetic voices that tiny.en was in doubt of before the first word,
clean and at 10 dB, with 0.2 to 0.9; of 75 pieces of kitchen noise all but one, with 0.96 and more."""

WORD_SECONDS = 1.25
"""s of sound up to which it may be a single word, of which what it hears with some effort is worth nothing."""


@dataclass(frozen=True, slots=True)
class MoonshineModel:
    """A model that is loaded. It knows nothing of what it hears, so recognisers in several threads may share it."""

    encoder: Any
    decoder: MoonshineDecoder
    tokenizer: MoonshinePieces

    @classmethod
    def load(cls, model: str, *, threads: int = 1, tell: Callable[[str], object] | None = None) -> MoonshineModel:
        """Load a model; the arguments are those of :class:`MoonshineRecognizer`.

        Raises:
            WeightsError: it cannot be found or loaded.
        """
        folder = find_moonshine(model, tell)
        try:
            return cls(
                load_graph(str(folder.graphs / ENCODER), threads),
                MoonshineDecoder(folder.graphs, threads),
                MoonshinePieces(folder.tokenizer),
            )
        except Exception as error:  # ONNX Runtime's errors have no common class
            raise WeightsError(
                f"model {model} cannot be loaded from {folder.graphs}: {error}\n"
                "    delete that folder; it is made again"
            ) from None


class MoonshineRecognizer(Leaving):
    """Free decoding with a Moonshine model, in English. Life cycle: made (loaded) -> ``transcribe`` ... -> ``close()``.

    Args:
        model: "moonshine-base", or a folder as Moonshine publishes it: ``encoder_model.ort``,
            ``decoder_model_merged.ort``, ``tokenizer.bin``. Or one that is loaded.
        threads: of the processor; a small model is fastest with one.
        tell: is told what takes long: that the weights are made ready, once on a machine.

    Raises:
        WeightsError: the model cannot be found or loaded.
    """

    language: str | None = "en"
    multilingual = False
    device = "cpu"
    draft: Draft = NOTHING_DRAFTED
    """As of :class:`~intent_engine.speech.acoustic.scoring.Scoring`."""

    def __init__(
        self,
        model: str | MoonshineModel = "moonshine-base",
        *,
        threads: int = 1,
        tell: Callable[[str], object] | None = None,
    ) -> None:
        self.model = MoonshineModel.load(model, threads=threads, tell=tell) if isinstance(model, str) else model
        self._trees = RecentTrees()

    def tokenizer(self, language: str | None = None) -> Any:
        """The pieces that it writes in."""
        return self.model.tokenizer

    def encode(self, samples: Samples, seconds: float = 0.0) -> Encoded:
        """Encode speech, padded to at least ``seconds``."""
        samples = samples[: int(MOST_SECONDS * SAMPLE_RATE)]
        least = int(max(seconds, LEAST_SECONDS) * SAMPLE_RATE)
        if samples.size < least:
            samples = np.pad(samples, (0, least - samples.size))
        (states,) = self.model.encoder.run(None, {"input_values": samples[np.newaxis].astype(np.float32)})
        return Encoded(states, samples.size / SAMPLE_RATE)

    def detect(self, encoded: Encoded, among: Collection[str] = ()) -> dict[str, float]:
        """The language of the speech: the only one that it knows."""
        return {"en": 0.0}

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        if samples.size == 0:
            return Transcript("")
        began = time.perf_counter()
        return replace(self._heard(samples, final=final), decode_seconds=time.perf_counter() - began)

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        self.stay()
        text, score, _ = self.greedy(self.encode(samples))
        return Transcript(text, score, free_text=text, language="en")

    def greedy(self, encoded: Encoded, language: str | None = None) -> tuple[str, float, bool]:
        """The likeliest words: (text, mean log probability, whether it went round in a loop)."""
        pieces, rows = self._greedy(encoded)
        score = sum(float(row.max()) for row in rows.values()) / len(rows)
        text = self.model.tokenizer.decode(list(pieces))
        folded = fold_loop(text)
        return folded, score, folded != text

    def _greedy(self, encoded: Encoded) -> tuple[Beginning, dict[Beginning, _Floats]]:
        """The likeliest pieces, and the log probabilities of every piece after each of their beginnings."""
        tree = self._tree(encoded)
        pieces: Beginning = ()
        rows: dict[Beginning, _Floats] = {}
        drafted: dict[Beginning, _Floats] = {}
        for _ in range(int(encoded.seconds * PIECES_PER_SECOND) + 8):
            if pieces not in drafted:
                drafted |= tree.along(pieces, self.draft.after(pieces))
            row = drafted[pieces]
            if not pieces and encoded.seconds > WORD_SECONDS:
                row = _something(row)
            rows[pieces] = row
            piece = int(row.argmax())
            if piece == END:
                break
            pieces += (piece,)
            if goes_round(self.model.tokenizer.decode(list(pieces))):
                break
        return pieces, rows

    def chances(self, encoded: Encoded, beginning: Beginning) -> _Floats:
        """The log probability of every next piece, ``(pieces,)``, after those that a text begins with."""
        return self._tree(encoded).chances([beginning])[beginning]

    def _tree(self, encoded: Encoded) -> PrefixTree:
        prompt = (BEGINNING,)
        return self._trees.of(
            encoded, prompt, lambda: PrefixTree(self.model.decoder, encoded.features[0], prompt, self.check)
        )

    def close(self) -> None:
        """Let go of what is known of sounds; nothing else is held."""
        self._trees.clear()


def _something(row: _Floats) -> _Floats:
    """How likely every first piece is, ``(pieces,)`` log probabilities, given that anything was said at all; unchanged,
    where surely nothing was."""
    nothing = float(row[END])
    if nothing >= SURELY_NOTHING:
        return row
    said: _Floats = row - np.float32(np.log1p(-np.exp(nothing)))
    said[END] = -np.inf
    return said


class ScoringMoonshine(MoonshineRecognizer, Scoring):
    """A Moonshine model that is asked what it thinks of words. Made and closed as :class:`MoonshineRecognizer`.

    It ends a sentence with a full stop or without, so what ends one is all of that together.
    """

    def longer(self, seconds: float) -> float:
        return seconds + RETRY_MARGIN

    def _greedy(self, encoded: Encoded) -> tuple[Beginning, dict[Beginning, _Floats]]:
        pieces, rows = super()._greedy(encoded)
        self._decoded = (encoded, rows)
        return pieces, rows

    def end_piece(self, language: str | None = None) -> int:
        return END

    def next_pieces(
        self, encoded: Encoded, beginnings: Sequence[tuple[int, ...]], length: int, language: str | None = None
    ) -> Iterator[tuple[tuple[int, ...], Any]]:
        for beginning, row in self._tree(encoded).onward(beginnings, length, END):
            ended = row.copy()
            ended[END] = np.logaddexp.reduce(row[self._ends])
            yield beginning, ended

    def _pieces(self, encoded: Encoded, texts: Sequence[str], language: str | None) -> list[Any]:
        plain = [text.strip().rstrip(".!?") for text in texts]
        pieces = [self.model.tokenizer.encode(" " + text) if text else [] for text in plain]
        tree = self._tree(encoded)
        tree.learn([*own, END] for own in pieces)
        return [np.append(tree.likelihood(own), np.logaddexp.reduce(tree.after(own, self._ends))) for own in pieces]

    @cached_property
    def _ends(self) -> list[int]:
        """Pieces after which a sentence is over."""
        return [END, *(piece for sign in ".?!" for piece in self.model.tokenizer.encode(sign))]
