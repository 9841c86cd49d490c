"""Fit the confidence of what two models think in the mean (``speech/hypotheses/evidence.py``), and say what it is
worth.

Recordings are heard as a runtime hears them. Every utterance for which the second model was asked gives one example:
what speaks for the sentence that is the likeliest for both, and whether it was said. What is printed goes into
``evidence.py`` by hand.

    python scripts/fit_second_opinion.py --case grammars/en.yaml out/speech_set \\
        --case examples/coffee/coffee.yaml ../shared/data/coffee --case grammars/en.yaml ../shared/data/gsc_words \\
        --other grammars/en.yaml ../shared/data/coffee \\
        --noise ../shared/data/noise/audio/doing_the_dishes.flac --snr 6 --snr 12
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

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
from intent_engine.speech.hypotheses.combination import Combination
from intent_engine.speech.hypotheses.evidence import WEIGHTS_OF_SEVERAL
from intent_engine.speech.hypotheses.opinion import Opinion, Reading, Steered
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.second_opinion import SecondOpinion
from intent_engine.speech.steered import SteeredMoonshine, SteeredWhisper


@dataclass(frozen=True)
class Example:
    """One utterance in doubt."""

    id: str
    kind: str
    said: str
    taken: str
    """The sentence that is the likeliest for both."""
    evidence: dict[str, float]
    alone: bool
    right: bool

    @property
    def weighed(self) -> list[float]:
        return [*(self.evidence[name] for name in WEIGHTS_OF_SEVERAL), 1.0]


class Noting(Combination):
    """Keeps the likeliest sentence of each sound."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.noted: dict[str, Reading] = {}

    def joint(self, first: Opinion, second: Opinion, *, far: bool = False) -> list[Reading]:
        found = super().joint(first, second, far=far)
        if found:
            self.noted[" ".join(found[0].words)] = found[0]
        return found


class Noted(SecondOpinion):
    """Two models, whose likeliest sentence is kept."""

    last: Reading | None = None
    """Of what was heard last: before the end of an utterance others were looked at, and for what was heard word by word
    none was."""

    def __init__(self, engine: IntentEngine, first: Steered, second: Callable[[], Steered]) -> None:
        super().__init__(engine, first, second)
        self._both = self._noting = Noting(self._grammar, self._each)

    def transcribe(self, samples: Samples, *, final: bool = True) -> Transcript:
        heard = super().transcribe(samples, final=final)
        self.last = self._noting.noted.get(heard.text)
        return heard

    def forget(self) -> None:
        """As if nothing had been heard."""
        self._noting.noted.clear()
        self.last = None


def examples(
    engine: IntentEngine, rows: list[Row], snr: float | None, noise: Noise | None, command: bool, kind: str
) -> Iterator[Example]:
    """What both models think of each recording that the first is not sure of."""
    second = SteeredMoonshine(engine)
    both = Noted(engine, SteeredWhisper(engine), lambda: second)
    listener = Listener(engine, both, load_robot(default_robot()))
    for row in track(rows, kind):
        sound = load(row)
        if snr is not None and noise is not None:
            sound = mix(sound, noise.piece(row.id, sound.size), snr)
        both.forget()
        listener.hear(SamplesSource(sound))
        best = both.last
        if best is None or best.unknown:  # whether a word that no list has was heard is judged apart
            continue
        meaning = engine.parse(" ".join(best.words))
        right = (
            command
            and meaning.status is Status.ACCEPTED
            and judge(row, Condition("both", snr), Hearing(acts=[Act(meaning, 0.0, 0.0)])).verdict is Verdict.RIGHT
        )
        yield Example(
            row.id, kind, row.text or "", " ".join(best.words), best.evidence.weighed, best.evidence.alone, right
        )


def main() -> None:
    found = gather(options(__doc__, Path("out/opinions.jsonl")), Example, examples)
    for alone, name in ((False, "OF_SEVERAL"), (True, "ALONE")):
        print(f"\n{'single words' if alone else 'sentences'}")
        *weights, bias = (round(float(weight), 2) for weight in report([one for one in found if one.alone is alone]))
        print(f"BIAS_{name} =", bias)
        print(f"WEIGHTS_{name} =", dict(zip(WEIGHTS_OF_SEVERAL, weights, strict=True)))


if __name__ == "__main__":
    main()
