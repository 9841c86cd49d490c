"""hassil: the sentence templates of Home Assistant."""

from __future__ import annotations

from functools import partial
from importlib.metadata import version
from typing import Any

import yaml
from hassil import Intents, SlotList, TextSlotList, recognize

from benchmarks.peers import HERE, Peer, Places, Step

QUANTITIES = ("distance", "duration", "speed", "angle")


def load(places: Places, text: str | None = None) -> tuple[Intents, dict[str, SlotList]]:
    """The grammar, and the map as a list of values."""
    source = text or (HERE / "hassil.yaml").read_text("utf-8")
    intents = Intents.from_dict(yaml.load(source, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)))
    # Names are no templates: told so, hassil keeps them in a trie.
    return intents, {"place": TextSlotList.from_tuples(list(places.items()), allow_template=False, name="place")}


def peers(places: Places) -> list[Peer]:
    intents, lists = load(places)
    verb = partial(recognize, intents=intents, slot_lists=lists, language="en")
    return [Peer(f"hassil {version('hassil')}", verb, lambda text: _steps(verb(text)))]


def _steps(result: Any) -> list[Step]:
    if result is None:
        return []
    found = {name: entity.value for name, entity in result.entities.items()}
    slots = {name: value for name, value in found.items() if name.rpartition("_")[0] not in QUANTITIES}
    for name in QUANTITIES:
        if f"{name}_n" in found:
            number = float(found[f"{name}_n"]) + float(found.get(f"{name}_half", 0.0))
            slots[name] = number * float(found[f"{name}_unit"])
    return [(result.intent.name, slots)]
