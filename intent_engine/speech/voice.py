"""Whether somebody speaks, frame by frame."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.onnx_sessions import onnx_runtime
from intent_engine.speech.audio import FRAME_SAMPLES, Samples

__all__ = ["SileroVoice", "VoiceDetector"]

CONTEXT_SAMPLES = 64
"""Samples of the frame before that Silero also looks at."""


class VoiceDetector(Protocol):
    """Gives each frame a probability of speech."""

    def probability(self, samples: Samples) -> float:
        """0 to 1, for the next 512 samples at 16 kHz."""
        ...

    def reset(self) -> None:
        """Forget what was heard."""
        ...


class SileroVoice:
    """Silero's detector (v6, ONNX, shipped with faster-whisper), with its state kept from frame to frame.

    Raises:
        WeightsError: the model file is not where faster-whisper keeps it.
    """

    def __init__(self) -> None:
        onnxruntime = onnx_runtime()
        options = onnxruntime.SessionOptions()
        # One thread: a frame takes half a millisecond, and a pool would fight the recogniser for the cores.
        options.inter_op_num_threads = 1
        options.intra_op_num_threads = 1
        options.enable_cpu_mem_arena = False
        options.log_severity_level = 4
        self._session: Any = onnxruntime.InferenceSession(
            str(_model_file()), providers=["CPUExecutionProvider"], sess_options=options
        )
        self.reset()

    def reset(self) -> None:
        self._hidden = np.zeros((1, 1, 128), np.float32)
        self._cell = np.zeros((1, 1, 128), np.float32)
        self._context = np.zeros(CONTEXT_SAMPLES, np.float32)

    def probability(self, samples: Samples) -> float:
        if samples.shape != (FRAME_SAMPLES,):
            raise ValueError(f"a frame has {FRAME_SAMPLES} samples, not {samples.shape}")
        sound = np.concatenate((self._context, samples))[np.newaxis]
        self._context = samples[-CONTEXT_SAMPLES:]
        output, self._hidden, self._cell = self._session.run(None, {"input": sound, "h": self._hidden, "c": self._cell})
        found = float(output.reshape(-1)[-1])
        if not 0 <= found <= 1:  # a sample that was no number would stay in the state for ever
            self.reset()
            return 0.0
        return found


def _model_file() -> Path:
    # Found without importing faster_whisper, which would load the recogniser too.
    spec = importlib.util.find_spec("faster_whisper")
    folders = list(spec.submodule_search_locations or ()) if spec else []
    for folder in folders:
        found = sorted((Path(folder) / "assets").glob("silero_vad*.onnx"))
        if found:
            return found[-1]
    raise WeightsError(
        "the voice detector's model is missing\n    install it again: pip install --force-reinstall faster-whisper"
    )
