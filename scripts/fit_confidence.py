"""Fit the confidence of speech (``intent_engine/speech/evidence.py``) to recordings, and say what it is worth.

A case is a grammar and a folder of recordings with labels; ``--other`` is one whose recordings are no commands of the
grammar, whatever their labels say. Every recording that is not an exact sentence gives one example: what speaks for the
likeliest sentence of the grammar, and whether it is what was said. What is printed goes into ``evidence.py`` by hand.

    python scripts/fit_confidence.py --case grammars/en.yaml out/speech_set \\
        --case examples/coffee/coffee.yaml ../shared/data/coffee --other grammars/en.yaml ../shared/data/coffee \\
        --noise ../shared/data/noise/audio/doing_the_dishes.flac --snr 6 --snr 12
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from rich.progress import track

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Act, Hearing
from intent_engine.evaluation.labels import Row, evenly, find_labels, read_labels
from intent_engine.evaluation.scoring import Condition, Verdict, judge
from intent_engine.evaluation.sound import Noise, load, mix
from intent_engine.interpretation import Status
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Samples
from intent_engine.speech.endpoint import Endpointer, Settings, Signal
from intent_engine.speech.evidence import WEIGHTS
from intent_engine.speech.rnnoise import installed_filter
from intent_engine.speech.steered import DOUBTFUL_SCORE, SteeredWhisper
from intent_engine.speech.voice import SileroVoice

LOCATIONS = Path("locations/home.yaml")
FRAME = 512
PATIENT = Settings(wait_unknown=0.6)
FOLDS = 5
PULL = 0.0005
"""How strongly weights are drawn to zero, for each example."""


@dataclass(frozen=True)
class Example:
    """One recording in one condition."""

    id: str
    kind: str
    evidence: dict[str, float]
    right: bool


def cut(samples: Samples) -> Samples | None:
    """The first utterance, as a runtime would cut it; None where the voice detector hears none."""
    room = np.zeros(SAMPLE_RATE // 2, np.float32)
    samples = np.concatenate([room, samples, room, room])
    voice, endpoint = SileroVoice(), Endpointer(PATIENT)
    begin = pause = 0
    for number in range(samples.size // FRAME):
        signal = endpoint.frame(voice.probability(samples[number * FRAME : (number + 1) * FRAME]))
        if signal is Signal.STARTED:
            begin = number + 1
        elif signal is Signal.PAUSED:
            pause = number + 1
        elif signal in (Signal.ENDED, Signal.DROPPED):
            break
    if not pause:
        return None
    kept = int(PATIENT.pre_roll / FRAME_SECONDS) + 2
    frames = [samples[number * FRAME : (number + 1) * FRAME] for number in range(max(0, begin - kept), pause)]
    noise = installed_filter()
    if noise is None:
        return np.concatenate(frames)
    filtered = noise.begin(frames[:kept])
    for frame in frames[kept:]:
        filtered.add(frame)
    return filtered.sound()


def examples(
    engine: IntentEngine, rows: list[Row], snr: float | None, noise: Noise | None, command: bool, kind: str
) -> Iterator[Example]:
    """What the recogniser thinks of each recording that it is not sure of."""
    whisper = SteeredWhisper(engine, threads=1)
    for row in track(rows, kind):
        sound = load(row)
        if snr is not None and noise is not None:
            sound = mix(sound, noise.piece(row.id, sound.size), snr)
        spoken = cut(sound)
        if spoken is None:
            continue
        encoded = whisper.encode(spoken)
        free, mean, _ = whisper.greedy(encoded, "en")
        if not free:
            continue
        meaning = engine.parse(free, spoken=True)
        if meaning.status is Status.ACCEPTED and meaning.confidence == 1.0 and mean > DOUBTFUL_SCORE:
            continue
        readings = whisper.readings(encoded, free, "en")
        if not readings:
            continue
        found = engine.parse(" ".join(readings[0].words), spoken=True)
        if found.status is not Status.ACCEPTED:
            continue
        verdict = judge(row, Condition("tiny.en", snr), Hearing(acts=[Act(found, 0.0, 0.0)])).verdict
        if not readings[0].unknown:  # whether a word that no list has was heard is judged apart
            yield Example(row.id, kind, readings[0].evidence.weighed, command and verdict is Verdict.RIGHT)


def table(found: list[Example], names: list[str]) -> tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    return (
        np.array([[one.evidence[name] for name in names] + [1.0] for one in found]),
        np.array([float(one.right) for one in found]),
    )


def fit(rows: npt.NDArray[Any], right: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Logistic regression by Newton's method, weights drawn to zero in units of their spread."""
    spread = rows.std(axis=0)
    spread[-1] = 1.0
    scaled = rows / spread
    pull = PULL * len(rows) * np.append(np.ones(rows.shape[1] - 1), 0.0)
    weights = np.zeros(rows.shape[1])
    for _ in range(50):
        chance = 1 / (1 + np.exp(-scaled @ weights))
        slope = scaled.T @ (right - chance) - pull * weights
        bend = (scaled.T * (chance * (1 - chance))) @ scaled + np.diag(pull)
        weights += np.linalg.solve(bend, slope)
    return weights / spread


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--other", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--noise", type=Path, action="append", default=[])
    parser.add_argument("--snr", type=float, action="append", default=[])
    parser.add_argument("--limit", type=int, help="recordings of each folder")
    parser.add_argument("--save", type=Path, default=Path("out/evidence.jsonl"))
    parser.add_argument("--load", type=Path, nargs="*", help="examples that were saved, instead of recordings")
    given = parser.parse_args()
    found: list[Example] = []
    if given.load:
        found = [Example(**json.loads(line)) for path in given.load for line in path.read_text().splitlines()]
    else:
        noise = Noise.read(given.noise) if given.noise else None
        for command, (grammar, folder) in [(True, c) for c in given.case] + [(False, c) for c in given.other]:
            engine = IntentEngine.from_files(grammar, locations=str(LOCATIONS))
            rows = evenly(
                read_labels(find_labels(Path(folder)), engine if command else any_engine(folder)), given.limit
            )
            for snr in (None, *given.snr):
                kind = f"{'' if command else 'other '}{Path(folder).name} {'clean' if snr is None else f'{snr:g} dB'}"
                found += examples(engine, rows, snr, noise, command, kind)
        given.save.write_text("".join(json.dumps(asdict(one)) + "\n" for one in found))
    names = list(WEIGHTS)
    rows, right = table(found, names)
    weights = fit(rows, right)
    print("WEIGHTS =", {name: round(float(weight), 2) for name, weight in zip(names, weights, strict=False)})
    print("BIAS =", round(float(weights[-1]), 2))
    fold = np.array([sum(map(ord, one.id)) % FOLDS for one in found])
    chance = np.zeros(len(found))
    for number in range(FOLDS):
        chance[fold == number] = 1 / (
            1 + np.exp(-rows[fold == number] @ fit(rows[fold != number], right[fold != number]))
        )
    levels = (0.5, 0.6, 0.7, 0.8, 0.9)
    print("right + wrong of the examples, each weighed by what was fitted to the others, from a confidence of", levels)
    for kind in dict.fromkeys(one.kind for one in found):
        mine = np.array([one.kind == kind for one in found])
        taken = [mine & (chance >= level) for level in levels]
        print(f"{kind:28} of {mine.sum():3}:", *(f"{int(right[t].sum())}+{int((1 - right[t]).sum())}" for t in taken))


def any_engine(folder: str) -> IntentEngine:
    """An engine that can read the labels of another domain."""
    coffee = "coffee" in folder
    return IntentEngine.from_files(
        "examples/coffee/coffee.yaml" if coffee else "grammars/en.yaml", locations=str(LOCATIONS)
    )


if __name__ == "__main__":
    main()
