"""One list of sentences, and whether an engine does what each of them asks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from benchmarks.peers import Peer, Step
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.locations import load

HERE = Path(__file__).resolve().parent
GRAMMAR = HERE.parent / "grammars" / "en.yaml"
MAP = HERE.parent / "locations" / "home.yaml"
ARTICLES = ("the ", "a ", "an ")
TOLERANCE = 1e-3
"""Of angles and distances: the list rounds them."""
RIGHT, WRONG, REFUSED = "right", "wrong", "refused"


@dataclass(frozen=True)
class Sentence:
    """A sentence and what a robot should do about it."""

    kind: str
    text: str
    steps: tuple[Step, ...]
    """In order; empty: nothing."""


@cache
def sentences() -> tuple[Sentence, ...]:
    """The list of ``sentences.yaml``."""
    data = yaml.safe_load((HERE / "sentences.yaml").read_text("utf-8"))
    return tuple(
        Sentence(kind, text, () if wanted == "nothing" else tuple(pair for step in wanted for pair in step.items()))
        for kind, rows in data["sentences"].items()
        for row in rows
        for text, wanted in row.items()
    )


@cache
def known_defects() -> dict[str, str]:
    """What our engine does with the sentences that it does not understand rightly yet."""
    data = yaml.safe_load((HERE / "sentences.yaml").read_text("utf-8"))
    return dict(data["ours"] or {})


def places() -> dict[str, str]:
    """What is said -> name, of the map that the sentences speak of."""
    return {spoken.lower(): place.name for place in load(MAP).values() for spoken in (place.name, *place.aliases)}


def engine() -> IntentEngine:
    """Our engine as shipped."""
    return IntentEngine.from_files(GRAMMAR, locations=MAP)


def ours() -> Peer:
    """Our engine as one among the peers."""
    loaded = engine()
    return Peer("Intent Engine", loaded.parse, lambda text: steps_of(loaded.parse(text)))


def steps_of(found: Interpretation) -> list[Step]:
    """The commands that would be carried out."""
    if found.status is not Status.ACCEPTED:
        return []
    if found.intent == "compound":
        return [(step["intent"], dict(step["slots"])) for step in found.slots["steps"]]
    return [(str(found.intent), dict(found.slots))]


def verdict(sentence: Sentence, steps: list[Step]) -> str:
    """``right``; ``wrong``: something was done that was not asked for; ``refused``: nothing was done that was."""
    if len(steps) == len(sentence.steps) and all(map(_same, steps, sentence.steps)):
        return RIGHT
    return WRONG if steps else REFUSED


def _same(found: Step, wanted: Step) -> bool:
    (intent, slots), (meant, values) = found, wanted
    return (
        intent == meant and slots.keys() == values.keys() and all(_equal(slots[name], values[name]) for name in slots)
    )


def _equal(found: Any, wanted: Any) -> bool:
    if isinstance(wanted, float) and isinstance(found, (int, float)):
        return abs(found - wanted) <= TOLERANCE * max(1.0, abs(wanted))
    return bool(_bare(found) == _bare(wanted))


def _bare(value: Any) -> Any:
    """Without an article: whether "the cup" or "cup" is told makes no difference to a robot."""
    if isinstance(value, str):
        return next((value[len(article) :] for article in ARTICLES if value.startswith(article)), value)
    return value


def verdicts(peer: Peer) -> dict[str, Counter[str]]:
    """Kind of sentence -> how many were right, wrong, refused."""
    found: dict[str, Counter[str]] = {}
    for sentence in sentences():
        found.setdefault(sentence.kind, Counter())[verdict(sentence, peer.steps(sentence.text))] += 1
    return found


def of_kind(kind: str) -> Iterator[str]:
    """The sentences of one kind."""
    return (sentence.text for sentence in sentences() if sentence.kind == kind)
