"""Fit how two models' opinions are weighed (``intent_engine/speech/second_opinion.py``), and say what it is worth.

Recordings are heard as a runtime hears them. Every utterance for which the second model was asked gives one example:
what both thought, and whether what the surer one heard was said. What is printed goes into ``second_opinion.py`` by
hand.

    python scripts/fit_second_opinion.py --case grammars/en.yaml out/speech_set \\
        --case examples/coffee/coffee.yaml ../shared/data/coffee --other grammars/en.yaml ../shared/data/coffee \\
        --noise ../shared/data/noise/audio/doing_the_dishes.flac --snr 6 --snr 12
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from fitting import gather, options, report
from rich.progress import track

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Act, Hearing, Listener
from intent_engine.evaluation.labels import Row
from intent_engine.evaluation.scoring import Condition, Verdict, judge
from intent_engine.evaluation.sound import Noise, SamplesSource, load, mix
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.interpretation import Status
from intent_engine.resources import default_robot
from intent_engine.speech.audio import Samples
from intent_engine.speech.recognizer import Recognizer, Transcript
from intent_engine.speech.second_opinion import SecondOpinion, confidence, evidence
from intent_engine.speech.steered import SteeredWhisper


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
        return [*evidence(self.sure, self.other, self.agree), 1.0]


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
    weights = report(gather(options(__doc__, Path("out/opinions.jsonl")), Example, examples))
    print("SURER, BOTH, DIFFER, BIAS =", [round(float(weight), 2) for weight in weights])


if __name__ == "__main__":
    main()
