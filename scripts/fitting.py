"""What the scripts that fit confidences share: recordings in, examples of being right or wrong, weights out."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from intent_engine.engine import IntentEngine
from intent_engine.evaluation.label_files import find_labels, read_labels
from intent_engine.evaluation.labels import Row, evenly
from intent_engine.evaluation.sound import Noise

__all__ = ["Example", "fit", "gather", "options", "report"]

LOCATIONS = Path("locations/home.yaml")
FOLDS = 5
LEVELS = (0.5, 0.6, 0.7, 0.8, 0.9)
PULL = 0.0005
"""How strongly weights are drawn to zero, for each example."""


class Example(Protocol):
    """One utterance in one condition; a dataclass."""

    @property
    def id(self) -> str: ...

    @property
    def kind(self) -> str: ...

    @property
    def right(self) -> bool: ...

    @property
    def weighed(self) -> Sequence[float]:
        """What is weighed; the last is the 1 of the bias."""
        ...


Examples = Callable[[IntentEngine, list[Row], float | None, Noise | None, bool, str], Iterator[Any]]
"""Examples of some recordings: engine, recordings, SNR in dB, noise, whether they are commands of the engine, name."""


def options(doc: str | None, save: Path) -> argparse.Namespace:
    """What the command line says."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--other", nargs=2, action="append", default=[], metavar=("GRAMMAR", "FOLDER"))
    parser.add_argument("--noise", type=Path, action="append", default=[])
    parser.add_argument("--snr", type=float, action="append", default=[])
    parser.add_argument("--limit", type=int, help="recordings of each folder")
    parser.add_argument("--save", type=Path, default=save)
    parser.add_argument("--load", type=Path, nargs="*", help="examples that were saved, instead of recordings")
    return parser.parse_args()


def gather(given: argparse.Namespace, kind_of_example: type[Any], examples: Examples) -> list[Any]:
    """The examples of all recordings, or those that were saved."""
    if given.load:
        return [kind_of_example(**json.loads(line)) for path in given.load for line in path.read_text().splitlines()]
    found: list[Any] = []
    noise = Noise.read(given.noise) if given.noise else None
    for command, (grammar, folder) in [(True, c) for c in given.case] + [(False, c) for c in given.other]:
        engine = IntentEngine.from_files(grammar, locations=str(LOCATIONS))
        labels = read_labels(find_labels(Path(folder)), engine if command else _any(folder))
        for snr in (None, *given.snr):
            kind = f"{'' if command else 'other '}{Path(folder).name} {'clean' if snr is None else f'{snr:g} dB'}"
            found += examples(engine, evenly(labels, given.limit), snr, noise, command, kind)
    given.save.write_text("".join(json.dumps(asdict(one)) + "\n" for one in found))
    return found


def fit(rows: npt.NDArray[Any], right: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Logistic regression by Newton's method, weights drawn to zero in units of their spread."""
    spread = rows.std(axis=0)
    spread[-1] = 1.0
    scaled = rows / spread
    pull = PULL * len(rows) * np.append(np.ones(rows.shape[1] - 1), 0.0)
    weights: npt.NDArray[Any] = np.zeros(rows.shape[1])
    for _ in range(50):
        chance = 1 / (1 + np.exp(-scaled @ weights))
        slope = scaled.T @ (right - chance) - pull * weights
        bend = (scaled.T * (chance * (1 - chance))) @ scaled + np.diag(pull)
        weights += np.linalg.solve(bend, slope)
    found: npt.NDArray[Any] = weights / spread
    return found


def report(found: Sequence[Example]) -> npt.NDArray[Any]:
    """The weights; and what they are worth, each example being weighed by what was fitted to others, is printed."""
    rows = np.array([one.weighed for one in found])
    right = np.array([float(one.right) for one in found])
    fold = np.array([sum(map(ord, one.id)) % FOLDS for one in found])
    chance = np.zeros(len(found))
    for number in range(FOLDS):
        chance[fold == number] = 1 / (
            1 + np.exp(-rows[fold == number] @ fit(rows[fold != number], right[fold != number]))
        )
    print("right + wrong of the examples, each weighed by what was fitted to the others, from a confidence of", LEVELS)
    for kind in dict.fromkeys(one.kind for one in found):
        mine = np.array([one.kind == kind for one in found])
        taken = [mine & (chance >= level) for level in LEVELS]
        print(f"{kind:28} of {mine.sum():3}:", *(f"{int(right[t].sum())}+{int((1 - right[t]).sum())}" for t in taken))
    return fit(rows, right)


def _any(folder: str) -> IntentEngine:
    """An engine that can read the labels of another domain."""
    coffee = "coffee" in folder
    return IntentEngine.from_files(
        "examples/coffee/coffee.yaml" if coffee else "grammars/en.yaml", locations=str(LOCATIONS)
    )
