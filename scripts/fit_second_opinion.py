"""Fit how two models' opinions are weighed (``intent_engine/speech/second_opinion.py``), and say what it is worth.

Recordings are heard as a runtime hears them. Every utterance for which the second model was asked gives one example:
what both thought, and whether what the surer one heard was said. What is printed goes into ``second_opinion.py`` by
hand.

    python scripts/fit_second_opinion.py --case grammars/en.yaml out/speech_set \\
        --case examples/coffee/coffee.yaml ../shared/data/coffee --other grammars/en.yaml ../shared/data/coffee \\
        --noise ../shared/data/noise/audio/doing_the_dishes.flac --snr 6 --snr 12
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from fit_confidence import LOCATIONS, any_engine, fit
from rich.progress import track

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Act, Hearing, Listener
from intent_engine.evaluation.labels import Row, evenly, find_labels, read_labels
from intent_engine.evaluation.scoring import Condition, Verdict, judge
from intent_engine.evaluation.sound import Noise, SamplesSource, load, mix
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.interpretation import Status
from intent_engine.resources import default_robot
from intent_engine.speech.audio import Samples
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.second_opinion import LEAST, SecondOpinion, confidence
from intent_engine.speech.steered import SteeredWhisper

FOLDS = 5


@dataclass(frozen=True)
class Example:
    """One utterance in doubt."""

    id: str
    kind: str
    sure: float
    """Confidence of the surer model in what it heard."""
    other: float
    """Of the other model, in what it heard."""
    agree: bool
    right: bool

    @property
    def weighed(self) -> list[float]:
        likely = math.log(max(self.sure, LEAST) / max(1 - self.sure, LEAST))
        return [likely, float(self.agree), 0.0 if self.agree else self.other, 1.0]


class Noted:
    """A recogniser whose last answer is kept."""

    def __init__(self, real: Recognizer) -> None:
        self._real = real
        self.last: Transcript | None = None

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        self.last = self._real.transcribe(samples, final=final)
        return self.last

    def close(self) -> None:
        self._real.close()


def examples(
    engine: IntentEngine, rows: list[Row], snr: float | None, noise: Noise | None, command: bool, kind: str
) -> Iterator[Example]:
    """What both models think of each recording that the first is not sure of."""
    first, second = Noted(SteeredWhisper(engine)), Noted(SteeredWhisper(engine, "base", language="en"))
    listener = Listener(engine, SecondOpinion(engine, first, lambda: second), load_robot(default_robot()))
    for row in track(rows, kind):
        sound = load(row)
        if snr is not None and noise is not None:
            sound = mix(sound, noise.piece(row.id, sound.size), snr)
        first.last = second.last = None
        listener.hear(SamplesSource(sound))
        if first.last is None or second.last is None:
            continue
        heard = [(one, engine.parse(one.text)) for one in (second.last, first.last)]
        (sure, meaning), (other, differing) = sorted(
            ((confidence(one, meant), meant) for one, meant in heard), key=lambda pair: -pair[0]
        )
        if meaning.status is not Status.ACCEPTED:
            continue
        verdict = judge(row, Condition("both", snr), Hearing(acts=[Act(meaning, 0.0, 0.0)])).verdict
        agree = meaning.actions == differing.actions
        yield Example(row.id, kind, sure, other, agree, command and verdict is Verdict.RIGHT)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--other", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--noise", type=Path, action="append", default=[])
    parser.add_argument("--snr", type=float, action="append", default=[])
    parser.add_argument("--limit", type=int, help="recordings of each folder")
    parser.add_argument("--save", type=Path, default=Path("out/opinions.jsonl"))
    parser.add_argument("--load", type=Path, nargs="*", help="examples that were saved, instead of recordings")
    given = parser.parse_args()
    found: list[Example] = []
    if given.load:
        found = [Example(**json.loads(line)) for path in given.load for line in path.read_text().splitlines()]
    else:
        noise = Noise.read(given.noise) if given.noise else None
        for command, (grammar, folder) in [(True, c) for c in given.case] + [(False, c) for c in given.other]:
            engine = IntentEngine.from_files(grammar, locations=str(LOCATIONS))
            labels = read_labels(find_labels(Path(folder)), engine if command else any_engine(folder))
            for snr in (None, *given.snr):
                kind = f"{'' if command else 'other '}{Path(folder).name} {'clean' if snr is None else f'{snr:g} dB'}"
                found += examples(engine, evenly(labels, given.limit), snr, noise, command, kind)
        given.save.write_text("".join(json.dumps(asdict(one)) + "\n" for one in found))
    rows: Any = np.array([one.weighed for one in found])
    right = np.array([float(one.right) for one in found])
    print("SURER, BOTH, DIFFER, BIAS =", [round(float(weight), 2) for weight in fit(rows, right)])
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


if __name__ == "__main__":
    main()
