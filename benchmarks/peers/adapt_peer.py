"""Adapt: known words anywhere in a sentence, and intents that need some of them."""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any

import yaml
from adapt.engine import IntentDeterminationEngine
from adapt.intent import IntentBuilder

from benchmarks.peers import HERE, Peer, Places, Step, plain, si

FIXED: dict[str, dict[str, Any]] = {
    "turn around": {"side": "left", "angle": math.pi},
    "turn circle": {"side": "left", "angle": 2 * math.pi},
}
"""What two of its intents mean."""
SLOTS = {
    "direction": "direction", "back_up": "direction", "side": "side", "place": "place", "thing": "thing",
    "from_surface": "source", "on_surface": "target",
}  # fmt: skip
"""Its kinds of words -> our slots."""
QUANTITIES = ("distance", "duration", "speed", "angle")


def load(places: Places) -> IntentDeterminationEngine:
    description = yaml.safe_load((HERE / "adapt.yaml").read_text("utf-8"))
    engine = IntentDeterminationEngine()
    for kind, values in description["vocabulary"].items():
        for value, spoken in values.items():
            for words in spoken:
                engine.register_entity(words, kind, alias_of=value)
    for words, name in places.items():
        engine.register_entity(words, "place", alias_of=name)
    for pattern in description["regex"]:
        engine.register_regex_entity(pattern.replace("<number>", description["number"]))
    for name, parts in description["intents"].items():
        builder = IntentBuilder(name)
        for kind in parts["require"]:
            builder.require(kind)
        for kind in parts.get("optionally", ()):
            builder.optionally(kind)
        engine.register_intent_parser(builder.build())
    return engine


def peers(places: Places) -> list[Peer]:
    engine = load(places)

    def best(text: str) -> dict[str, Any] | None:
        return next(iter(engine.determine_intent(plain(text))), None)

    return [Peer(f"adapt {version('adapt-parser')}", best, lambda text: _steps(best(text)))]


def _steps(found: dict[str, Any] | None) -> list[Step]:
    if found is None:
        return []
    name = found["intent_type"]
    slots: dict[str, Any] = {slot: found[kind] for kind, slot in SLOTS.items() if kind in found}
    slots |= {kind: si(found[kind], kind) for kind in QUANTITIES if kind in found}
    return [(name.split(" ")[0], slots | FIXED.get(name, {}))]
