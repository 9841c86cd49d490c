"""What the benchmarks of speech share: the two ways of hearing, where recordings are, and how rows are made.

Ours is what ``run`` is. Beside it stands what the tutorials do: the same voice detector, a fixed wait of 0.6 s for
the end, then faster-whisper's ``transcribe`` as its documentation shows it. Its text goes through the same grammar, so
that what differs is the hearing alone.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from intent_engine.cli.terminal import progress
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Listener
from intent_engine.evaluation.labels import Row, evenly
from intent_engine.evaluation.report import write_csv
from intent_engine.evaluation.scoring import Outcome, Score, quantile, score
from intent_engine.evaluation.sound import Noise
from intent_engine.evaluation.trial import Trial
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.pauses import avoid_pauses
from intent_engine.resources import default_robot
from intent_engine.speech.audio import SAMPLE_RATE, Samples
from intent_engine.speech.endpoint import Settings
from intent_engine.speech.models import recognizer_for, usual_model
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.reflex import reflex_for
from intent_engine.speech.weights import find_weights

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT.parent / "shared" / "data"
"""Recordings that are not the project's own."""
MODEL = "tiny.en"
PEER = "transcribe, 0.6 s endpoint"
PEER_WAIT = 0.6
LIMIT = "SPEECH_BENCH_LIMIT"
"""Environment variable: recordings of each set, to measure a part of it; the table says how many they were."""
QUICK = 12


class Transcribe:
    """faster-whisper as its documentation shows it, with the same weights and compute type as ours."""

    def __init__(self, model: str = MODEL, language: str = "en") -> None:
        from faster_whisper import WhisperModel

        self._model: Any = WhisperModel(str(find_weights(model).path), device="cpu", compute_type="int8")
        self._language = language

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        began = time.perf_counter()
        segments, _ = self._model.transcribe(samples, language=self._language)
        text = " ".join(segment.text.strip() for segment in segments)
        return Transcript(text, free_text=text, decode_seconds=time.perf_counter() - began)

    def close(self) -> None:
        self._model.model.unload_model()


@dataclass(frozen=True)
class Ways:
    """The two ways of hearing one grammar."""

    ours: Listener
    peer: Listener

    @classmethod
    def of(cls, engine: IntentEngine, *, reflex: bool = True, live: bool = False) -> Ways:
        """Both ways; ``live``: for sound in its own time, beside which the reflex listens in a thread."""
        robot = load_robot(default_robot())
        (language,) = engine.languages
        model = usual_model([language])
        ours = recognizer_for(engine, model)
        peer: Recognizer = Transcribe(model, language)
        late = Settings(**{f"wait_{kind}": PEER_WAIT for kind in WAITS} | {"wait_continued": 0.0})
        avoid_pauses()
        return cls(
            Listener(engine, ours, robot, reflex=reflex_for(engine, background=live, beside=ours) if reflex else None),
            Listener(engine, peer, robot, settings=late, speculate=False, noise_filter=None),
        )


WAITS = tuple(name.removeprefix("wait_") for name in Settings.__dataclass_fields__ if name.startswith("wait_"))
Heard = dict[float | None, list[Outcome]]
"""SNR in dB, or None for without noise -> one outcome for each recording."""


def kitchen() -> Noise | None:
    """The kitchen noises of the development data; None where that is not."""
    if not (DATA / "noise").exists():
        return None
    return Noise.read([DATA / "noise" / "audio" / f"{name}.flac" for name in ("running_tap", "doing_the_dishes")])


def some(rows: list[Row], quick: bool) -> list[Row]:
    """All rows; few in a quick run, or as many as the environment says."""
    limit = QUICK if quick else int(os.environ.get(LIMIT, "0")) or None
    return evenly(rows, limit)


def hear(what: str, rows: Sequence[Row], trial: Trial, ways: Iterable[Listener]) -> list[Heard]:
    """Every recording by every way, one after the other, so that all meet the same machine."""
    found: list[Heard] = [{} for _ in ways]
    with progress(what, len(rows)) as step:
        for row in rows:
            for heard, way in zip(found, ways, strict=True):
                (outcomes,) = trial.hear([row], way, MODEL)
                for outcome in outcomes:
                    heard.setdefault(outcome.condition.snr, []).append(outcome)
            step()
    # What ours heard, recording by recording: a figure that is worse than it was can be listened to.
    write_csv(ROOT / "out" / f"heard {what}.csv", [one for outcomes in found[0].values() for one in outcomes])
    return found


def needs(path: Path, what: str) -> None:
    """Raise if recordings are not there; the collector then tells it and goes on."""
    if not path.exists():
        raise FileNotFoundError(f"no {path}: {what}")


def speech_set(kind: str = "speech", language: str = "en") -> Path:
    """The labels of a synthesised set, ``speech`` or ``paused``; made, if it is not there yet.

    Raises:
        FileNotFoundError: it cannot be made here.
    """
    other = "" if language == "en" else f"_{language}"
    labels = ROOT / "out" / f"{kind}_set{other}" / "labels.jsonl"
    if not labels.exists():
        options = ["--language", language, *([] if kind == "speech" else [f"--{kind}"])]
        done = subprocess.run([sys.executable, str(ROOT / "scripts" / "make_speech_set.py"), *options], check=False)
        if done.returncode:
            raise FileNotFoundError("the set of synthetic commands: scripts/make_speech_set.py says what to install")
    return labels


# -- rows --------------------------------------------------------------------------------------------------------------


def share(figure: str, command: str, ours: tuple[int, int], peer: tuple[int, int]) -> dict[str, Any]:
    """A row of a share in %, the smaller the better; (how many, of how many)."""
    value, other = (100 * part / whole if whole else 0.0 for part, whole in (ours, peer))
    return row(figure, command, value, "%", other, runs=ours[1])


def row(
    figure: str,
    command: str,
    value: float,
    unit: str,
    peer_value: float | None = None,
    *,
    peer: str = PEER,
    spread: list[float] | None = None,
    runs: int = 1,
) -> dict[str, Any]:
    """A row as the collector wants it."""
    return {
        "figure": figure,
        "value": value,
        "unit": unit,
        "peer": peer if peer_value is not None else None,
        "peer_value": peer_value,
        "ratio": peer_value / value if peer_value is not None and value > 0 else None,
        "spread": spread,
        "runs": runs,
        "command": command,
    }


def accuracy_rows(what: str, command: str, ours: Sequence[Outcome], peer: Sequence[Outcome]) -> list[dict[str, Any]]:
    """What matters of one condition: not exact, wrong, acted on by mistake, and how late."""
    one, other = score(ours), score(peer)
    rows = []
    if one.commands:
        failed = [(found.commands - found.right, found.commands) for found in (one, other)]
        rows.append(share(f"{what}: commands not carried out exactly", command, *failed))
        wrong = [(found.wrong, found.commands) for found in (one, other)]
        rows.append(share(f"{what}: commands answered by another action", command, *wrong))
    if one.others:
        mistaken = [(found.false_accepts, found.others) for found in (one, other)]
        rows.append(share(f"{what}: other speech acted on", command, *mistaken))
        danger = [(_more_than_stopped(heard), found.others) for heard, found in ((ours, one), (peer, other))]
        rows.append(share(f"{what}: other speech answered by more than a stop", command, *danger))
    return rows + latency_rows(what, command, one, other, ours)


def _more_than_stopped(heard: Sequence[Outcome]) -> int:
    return sum(one.unasked for one in heard if not one.row.expected.command)


def latency_rows(what: str, command: str, one: Score, other: Score, ours: Sequence[Outcome]) -> list[dict[str, Any]]:
    times = [outcome.latency for outcome in ours if outcome.latency is not None]
    if not times:
        return []
    spread = [1000 * min(times), 1000 * max(times)]
    rows = []
    for name in ("p50", "p90", "p99"):
        mine, theirs = getattr(one, f"latency_{name}"), getattr(other, f"latency_{name}")
        figure = f"{what}: end of speech to action, {name}"
        theirs = 1000 * theirs if theirs is not None else None
        rows.append(row(figure, command, 1000 * mine, "ms", theirs, spread=spread, runs=len(times)))
    return rows


def holds(figure: str, command: str, times: Sequence[float], words: int) -> list[dict[str, Any]]:
    """Rows of a reflex: how many stop words it missed, and when it held after the word's end."""
    rows = [row(f"{figure}: stop words that held nothing", command, 100 * (1 - len(times) / words), "%", runs=words)]
    for name, part in (("p50", 0.5), ("p90", 0.9)):
        value = quantile(times, part)
        if value is not None:
            spread = [1000 * min(times), 1000 * max(times)]
            what = f"{figure}: end of the word to the hold, {name} (negative: before it)"
            rows.append(row(what, command, 1000 * value, "ms", spread=spread, runs=len(times)))
    return rows


def minute(pieces: Iterable[Samples]) -> Samples:
    """Sounds one after the other, cut off at a minute."""
    import numpy as np

    whole = np.concatenate(list(pieces))[: 60 * SAMPLE_RATE]
    return np.pad(whole, (0, 60 * SAMPLE_RATE - whole.size))
