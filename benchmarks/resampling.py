"""Resampling of a stream: how much of the sound is held back, and what it costs, beside soxr's stream.

A command is over when its last word was heard, and a robot stops when "stop" was: what a resampler holds back comes on
top of both. Noise is pushed in blocks of 20 ms, as a driver gives it.

    python -m benchmarks --only resampling
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import soxr

from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.resampling import StreamResampler

COMMAND = "python -m benchmarks --only resampling"
RATES = (8_000, 22_050, 44_100, 48_000, 96_000)
BLOCK_SECONDS = 0.02
SECONDS = 20.0
RUNS = 5

Push = Callable[[npt.NDArray[np.float32]], npt.NDArray[np.float32]]


def soxr_stream(rate: int) -> Push:
    stream = soxr.ResampleStream(rate, SAMPLE_RATE, 1, dtype="float32")
    return lambda block: np.asarray(stream.resample_chunk(block))


def measure(rate: int, push: Push, seconds: float) -> tuple[list[float], float]:
    """ms that were held back after each block, and core-ms for a second of sound."""
    size = round(rate * BLOCK_SECONDS)
    noise = np.random.default_rng(0).normal(0, 0.1, size).astype(np.float32)
    came, lags = 0, []
    began = time.process_time()
    for count in range(1, round(seconds / BLOCK_SECONDS) + 1):
        came += push(noise).size
        lags.append(1e3 * (count * size / rate - came / SAMPLE_RATE))
    return lags[round(1 / BLOCK_SECONDS) :], 1e3 * (time.process_time() - began) / seconds


def run(quick: bool) -> list[dict[str, Any]]:
    rows = []
    for rate in RATES:
        runs = 1 if quick else RUNS
        seconds = 4.0 if quick else SECONDS
        ours = [measure(rate, StreamResampler(rate, SAMPLE_RATE).push, seconds) for _ in range(runs)]
        theirs = [measure(rate, soxr_stream(rate), seconds) for _ in range(runs)]
        for what, of in (("mean", statistics.fmean), ("worst", max)):
            rows.append(
                _row(
                    f"held back of a stream at {rate:,} Hz, {what}",
                    "ms",
                    [of(lags) for lags, _ in ours],
                    [of(lags) for lags, _ in theirs],
                )
            )
        rows.append(
            _row(f"a second of sound at {rate:,} Hz, core time", "ms", [c for _, c in ours], [c for _, c in theirs])
        )
    return rows


def _row(figure: str, unit: str, ours: list[float], theirs: list[float]) -> dict[str, Any]:
    value, peer = statistics.median(ours), statistics.median(theirs)
    return {
        "figure": figure,
        "value": value,
        "unit": unit,
        "peer": "soxr.ResampleStream",
        "peer_value": peer,
        "ratio": peer / value,
        "spread": [min(ours), max(ours)],
        "runs": len(ours),
        "command": COMMAND,
    }
