"""Whisper through CTranslate2, its encoder fed only with what was said.

``WhisperModel.transcribe`` of faster-whisper always pads to 30 s; a command has two. The encoder's cost grows with its
input, so it is given the speech padded to four seconds, and ten only when the first try went wrong.
"""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Collection
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.loops import fold_loop
from intent_engine.speech.acoustic.mel import MelFilters
from intent_engine.speech.acoustic.pieces import mended
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.recognizer import Encoded, Transcript
from intent_engine.speech.weights import Weights, find_weights

__all__ = ["WhisperRecognizer", "logits_row", "max_length"]

_Answer = TypeVar("_Answer")

FRAMES_PER_SECOND = 100
MIN_SECONDS = 4.0
"""Shortest encoder input. With 3, 3.5, 4 and 5 s 446, 453, 455 and 457 of 688 commands of synthetic voices are heard
word for word, and 18, 12, 11 and 10 % come back as a loop of themselves; it takes 36, 41, 46 and 58 ms (one core of an
AMD EPYC without VNNI)."""
RETRY_SECONDS = 10.0
MARGIN_SECONDS = 0.5
"""Silence after the speech in the encoder's input, so that the end is heard as an end."""
MAX_SECONDS = 28.0
MIN_SCORE = -1.0
"""Mean log probability below which a decode is tried again with a longer input (faster-whisper's own threshold)."""
SMALL_MODEL = 200_000_000
"""Bytes of a model (tiny and base are smaller) whose threads wait for each other longer than they work: of 16 commands
one thread decoded "base" in 78 ms (median), two in 85, and in 0.11 s against 0.15 where it took longest."""
TOKENS_PER_SECOND = 7
"""More than anybody speaks; bounds a decode that runs away."""
LEAST = 1e-9
"""Probability of a language that is none."""
MAX_LENGTH = 448
"""Tokens that Whisper's decoder can hold."""


class WhisperRecognizer:
    """Free decoding with a Whisper model. Life cycle: made (model loaded) -> ``transcribe`` ... -> ``close()``.

    Args:
        model: a name ("tiny.en"), or the path of a CTranslate2 Whisper model.
        device: "auto" (CUDA if there is one), "cpu" or "cuda".
        compute_type: "int8" by default on a CPU, "float16" on CUDA.
        language: fixed language, or None to let a multilingual model detect it.
        threads: of the CPU; 0: one for a small model, else CTranslate2 chooses.

    Raises:
        WeightsError: the model cannot be found or loaded.
    """

    def __init__(
        self,
        model: str = "tiny.en",
        *,
        device: str = "auto",
        compute_type: str | None = None,
        language: str | None = "en",
        threads: int = 0,
    ) -> None:
        self.weights: Weights = find_weights(model)
        self.language = language
        file = self.weights.path / "model.bin"
        self.small = file.is_file() and file.stat().st_size < SMALL_MODEL
        """Whether one thread is fastest."""
        self._threads = threads or int(self.small)
        self._model, self.device = _load(self.weights, device, compute_type, self._threads)
        self.multilingual: bool = bool(self._model.model.is_multilingual)
        self._tokenizers: dict[str, Any] = {}

    # -- the parts ---------------------------------------------------------------------------------

    def tokenizer(self, language: str | None = None) -> Any:
        """faster-whisper's tokenizer of a language."""
        from faster_whisper.tokenizer import Tokenizer

        key = (language or self.language or "en") if self.multilingual else "en"
        if key not in self._tokenizers:
            self._model.hf_tokenizer = mended(self._model.hf_tokenizer)
            self._tokenizers[key] = Tokenizer(
                self._model.hf_tokenizer, self.multilingual, task="transcribe", language=key
            )
        return self._tokenizers[key]

    def prompt(self, language: str | None = None) -> list[int]:
        """The tokens before the first word: start, language and task where there are several, no time stamps."""
        tokenizer = self.tokenizer(language)
        return [*tokenizer.sot_sequence, tokenizer.no_timestamps]

    def encode(self, samples: Samples, seconds: float = MIN_SECONDS) -> Encoded:
        """Encode speech, padded to at least ``seconds``."""
        import ctranslate2

        spoken = samples.size / SAMPLE_RATE
        wanted = min(max(seconds, spoken + MARGIN_SECONDS), 30.0)
        mel = self._model.feature_extractor(samples[: int(MAX_SECONDS * SAMPLE_RATE)])
        frames = int(wanted * FRAMES_PER_SECOND)
        frames += frames % 2
        mel = mel[:, :frames]
        mel = np.pad(mel, ((0, 0), (0, frames - mel.shape[1])))
        storage = ctranslate2.StorageView.from_array(np.ascontiguousarray(mel[np.newaxis], dtype=np.float32))
        return Encoded(self._model.model.encode(storage, to_cpu=self.device == "cuda"), spoken)

    @property
    def engine(self) -> Any:
        """The CTranslate2 model."""
        return self._model.model

    def detect(self, encoded: Encoded, among: Collection[str] = ()) -> dict[str, float]:
        """The languages that the speech may be, each with its log probability, the likeliest first.

        Args:
            encoded: the speech.
            among: those that it may be; empty, or none that the model knows: any. Of a short command a model may think
                of all.
        """
        if not self.multilingual:
            return {"en": 0.0}
        (likely,) = self._model.model.detect_language(encoded.features)
        found = {str(token).strip("<|>"): math.log(max(chance, LEAST)) for token, chance in likely}
        return {one: chance for one, chance in found.items() if one in among} or found

    # -- the whole ---------------------------------------------------------------------------------

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        if samples.size == 0:
            return Transcript("")
        began = time.perf_counter()
        heard = self.despite_cuda(lambda: self._heard(samples, final=final))
        return replace(heard, decode_seconds=time.perf_counter() - began)

    def despite_cuda(self, ask: Callable[[], _Answer]) -> _Answer:
        """What the model is asked; where CUDA fails at it the processor answers, and all that is asked from then on."""
        try:
            return ask()
        except RuntimeError as error:
            if self.device != "cuda":
                raise
            self._leave_cuda(error)
        return ask()

    def _heard(self, samples: Samples, *, final: bool) -> Transcript:
        encoded = self.encode(samples)
        language = self.language or next(iter(self.detect(encoded)))
        text, score, looped = self.greedy(encoded, language)
        if final and (looped or score < MIN_SCORE):
            again, better, loops = self.greedy(self.encode(samples, RETRY_SECONDS), language)
            if not loops and (looped or better > score):
                text, score = again, better
        return Transcript(text, score, free_text=text, language=language)

    def _leave_cuda(self, error: RuntimeError) -> None:
        """CUDA ran out of memory, or its device was lost: go on with the processor, for good."""
        warnings.warn(f"CUDA failed ({error}); recognising on the CPU from now on", RuntimeWarning, stacklevel=4)
        self._model, self.device = _load(self.weights, "cpu", None, self._threads)
        self._tokenizers.clear()

    def greedy(self, encoded: Encoded, language: str | None = None) -> tuple[str, float, bool]:
        """The likeliest words: (text, mean log probability, whether it went round in a loop)."""
        tokenizer = self.tokenizer(language)
        tokens, score = self.greedy_tokens(encoded, language)
        text = tokenizer.decode([token for token in tokens if token < tokenizer.eot]).strip()
        folded = fold_loop(text)
        return folded, score, folded != text

    def greedy_tokens(self, encoded: Encoded, language: str | None = None) -> tuple[list[int], float]:
        """The likeliest tokens, with their mean log probability."""
        result = self._greedy(encoded, language)
        return list(result.sequences_ids[0]), float(result.scores[0])

    def _greedy(self, encoded: Encoded, language: str | None, **options: Any) -> Any:
        prompt = self.prompt(language)
        limit = self.most_pieces(encoded)
        return self._model.model.generate(
            encoded.features,
            [prompt],
            beam_size=1,
            max_length=max_length(len(prompt), limit),
            return_scores=True,
            **options,
        )[0]

    @staticmethod
    def most_pieces(encoded: Encoded) -> int:
        """Tokens after which a decode has run away."""
        return int(encoded.seconds * TOKENS_PER_SECOND) + 8

    def close(self) -> None:
        unload = getattr(self._model.model, "unload_model", None)
        if unload is not None:
            unload()


def logits_row(logits: Any) -> npt.NDArray[np.float32]:
    """CTranslate2's logits of one place, ``(vocabulary,)``, from wherever the model is."""
    import ctranslate2

    if logits.device != "cpu":
        logits = logits.to_device(ctranslate2.Device.cpu)
    return np.asarray(logits, dtype=np.float32).reshape(-1)


def max_length(prompt: int, wanted: int) -> int:
    """CTranslate2's ``max_length`` for so many tokens after a prompt of so many: it gives at most half of it, as
    OpenAI's code does, and no more than the prompt leaves of it."""
    return min(max(2 * wanted, prompt + wanted), MAX_LENGTH)


def _load(weights: Weights, device: str, compute_type: str | None, threads: int) -> tuple[Any, str]:
    import ctranslate2
    from faster_whisper import WhisperModel

    wanted = device
    if device == "auto":
        wanted = "cuda" if ctranslate2.get_cuda_device_count() > 0 else "cpu"
    try:
        model = WhisperModel(
            str(weights.path),
            device=wanted,
            compute_type=compute_type or ("float16" if wanted == "cuda" else "int8"),
            cpu_threads=threads,
        )
        sound: Any = model.feature_extractor
        sound.mel_filters = MelFilters(sound.mel_filters)
        return model, wanted
    except Exception as error:  # those of the tokenizer have no class of their own
        if wanted == "cuda" and isinstance(error, RuntimeError | ValueError):
            warnings.warn(f"CUDA cannot be used ({error}); recognising on the CPU", RuntimeWarning, stacklevel=3)
            able = ctranslate2.get_supported_compute_types("cpu")
            return _load(weights, "cpu", compute_type if compute_type in able else None, threads)
        raise WeightsError(
            f"model {weights.name} at {weights.path} cannot be loaded: {error}\n"
            "    copy, download or convert its files again; another model: --model NAME"
        ) from None
