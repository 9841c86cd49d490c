"""Padacioso: sample sentences as regular expressions.

Only its strict way: the fuzzy one, where any one word may be another, compiles a regular expression for each word of
each sample at each utterance. And without its process pool: ``calc_intent`` sends every compiled sample to every
worker for every sentence, where it is compiled again, and takes seconds with this grammar. What is left is its
matching, in its own order.
"""

from __future__ import annotations

import math
import re
from importlib.metadata import version
from typing import Any

import yaml
from padacioso import IntentContainer

from benchmarks.peers import HERE, Peer, Places, Step, plain, si

FIXED: dict[str, dict[str, Any]] = {
    "move forward": {"direction": "forward"},
    "move backward": {"direction": "backward"},
    "turn left": {"side": "left"},
    "turn right": {"side": "right"},
    "turn around": {"side": "left", "angle": math.pi},
    "turn circle": {"side": "left", "angle": 2 * math.pi},
}
"""What its intents mean besides."""
QUANTITIES = ("distance", "duration", "speed", "angle")
CONFIDENCE = 0.8
"""What Open Voice OS asks of a match of medium confidence."""


def load(places: Places) -> IntentContainer:
    description = _description()
    container = IntentContainer()
    for name, samples in description["intents"].items():
        container.add_intent(name, samples)
        # Samples of one length stand in the order of a set, another one in each process: the most words first, always.
        container.intent_samples[name].sort(key=lambda sample: (-len(sample), -len(sample.split()), sample))
        container.exclude_keywords(name, list(description["excluded"]))
    container.add_entity("place", list(places))
    return container


def _description() -> Any:
    return yaml.safe_load((HERE / "padacioso.yaml").read_text("utf-8"))


def peers(places: Places) -> list[Peer]:
    container = load(places)
    # It has no place for fillers; its users take them out before.
    fillers = sorted(_description()["fillers"], key=len, reverse=True)
    pattern = re.compile(r"\b(?:" + "|".join(fillers) + r")\b")

    def best(text: str) -> dict[str, Any]:
        query = " ".join(pattern.sub(" ", plain(text)).split())
        excluded = container._filter(query)
        found = [
            match
            for name, samples in container.intent_samples.items()
            if name not in excluded and (match := container._match(query, name, samples))
        ]
        return max(found, key=lambda match: float(match["conf"]), default={"name": None, "conf": 0.0, "entities": {}})

    return [Peer(f"padacioso {version('padacioso')}", best, lambda text: _steps(best(text), places))]


def _steps(found: dict[str, Any], places: Places) -> list[Step]:
    """The command, if its handler can do it: a place that is on the map, a quantity that is one."""
    if not found["name"] or found["conf"] < CONFIDENCE:
        return []
    slots: dict[str, Any] = {}
    for kind, words in found["entities"].items():
        slots[kind] = si(words, kind) if kind in QUANTITIES else places.get(words) if kind == "place" else words
        if not slots[kind]:
            return []
    return [(found["name"].split(" ")[0], slots | FIXED.get(found["name"], {}))]
