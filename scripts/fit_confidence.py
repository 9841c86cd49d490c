"""Fit the confidence of speech (``speech/hypotheses/evidence.py``) to recordings, and say what it is worth.

A case is a grammar and a folder of recordings with labels; ``--other`` is one whose recordings are no commands of the
grammar, whatever their labels say. Every recording that is not an exact sentence gives one example: what speaks for the
likeliest sentence of the grammar, and whether it is what was said. What is printed goes into ``evidence.py`` by hand.

    python scripts/fit_confidence.py --case grammars/en.yaml out/speech_set \\
        --case examples/coffee/coffee.yaml ../shared/data/coffee --other grammars/en.yaml ../shared/data/coffee \\
        --noise ../shared/data/noise/audio/doing_the_dishes.flac --snr 6 --snr 12
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fitting import gather, options, report
from rich.progress import track

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Act, Hearing
from intent_engine.evaluation.labels import Row
from intent_engine.evaluation.scoring import Condition, Verdict, judge
from intent_engine.evaluation.sound import Noise, load, mix
from intent_engine.interpretation import Status
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Samples
from intent_engine.speech.endpoint import Endpointer, Settings, Signal
from intent_engine.speech.hypotheses.evidence import WEIGHTS
from intent_engine.speech.rnnoise import installed_filter
from intent_engine.speech.steered import SteeredWhisper
from intent_engine.speech.voice import SileroVoice

FRAME = 512
PATIENT = Settings(wait_unknown=0.6)


@dataclass(frozen=True)
class Example:
    """One recording in one condition."""

    id: str
    kind: str
    evidence: dict[str, float]
    right: bool

    @property
    def weighed(self) -> list[float]:
        return [*(self.evidence[name] for name in WEIGHTS), 1.0]


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
        elif signal in (Signal.ENDED, Signal.SHORT):
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
        heard = whisper.listen(spoken)
        readings = [] if heard.settled else whisper.readings(heard)
        if not readings:
            continue
        found = engine.parse(" ".join(readings[0].words), spoken=True)
        if found.status is not Status.ACCEPTED:
            continue
        verdict = judge(row, Condition("tiny.en", snr), Hearing(acts=[Act(found, 0.0, 0.0)])).verdict
        if not readings[0].unknown:  # whether a word that no list has was heard is judged apart
            yield Example(row.id, kind, readings[0].evidence.weighed, command and verdict is Verdict.RIGHT)


def main() -> None:
    weights = report(gather(options(__doc__, Path("out/evidence.jsonl")), Example, examples))
    print("WEIGHTS =", {name: round(float(weight), 2) for name, weight in zip(WEIGHTS, weights, strict=False)})
    print("BIAS =", round(float(weights[-1]), 2))


if __name__ == "__main__":
    main()
