"""rhasspy-nlu: JSGF sentences as a finite-state graph; strict, and its default, which skips words at a cost."""

from __future__ import annotations

import sys
from functools import partial
from importlib.metadata import version
from typing import Any
from unittest import mock

from benchmarks.peers import HERE, Peer, Places, Step, plain

# The networkx that rhasspy-nlu pins asks NumPy, if there is one, for names that NumPy 2 no longer has; it needs none.
with mock.patch.dict(sys.modules, {"numpy": None}):
    from rhasspynlu.fsticuffs import recognize
    from rhasspynlu.ini_jsgf import parse_ini
    from rhasspynlu.jsgf import Expression, Sentence
    from rhasspynlu.jsgf_graph import intents_to_graph
    from rhasspynlu.numbers import number_to_words, replace_numbers

QUANTITIES = ("distance", "duration", "speed", "angle")
STOP_WORDS = {
    "uh", "um", "er", "erm", "hmm", "well", "so", "like", "ok", "okay", "alright", "hey", "hi", "hello", "robot", "now",
    "please", "kindly", "thanks", "just", "could", "can", "would", "will", "you", "i", "want", "need", "to",
}  # fmt: skip
"""Words that cost it little to skip: its place for fillers."""


def load(places: Places, text: str | None = None) -> Any:
    """The graph of all sentences."""
    intents = parse_ini(text or (HERE / "rhasspy.ini").read_text("utf-8"))
    slots = {
        "$place": [f"({spoken}):({name})" for spoken, name in places.items()],
        "$number": [_number(value) for value in range(101)],
        "$degrees": [_number(value) for value in range(361)],
    }
    replacements: dict[str, list[Expression]] = {
        name: [Sentence.parse(line) for line in lines] for name, lines in slots.items()
    }
    return intents_to_graph(intents, replacements)


def _number(value: int) -> str:
    return f"({' '.join(number_to_words(value))}):{value}"


def peers(places: Places) -> list[Peer]:
    graph = load(places)
    name = f"rhasspy-nlu {version('rhasspy-nlu')}"
    strict = partial(recognize, graph=graph, fuzzy=False, stop_words=STOP_WORDS)
    fuzzy = partial(recognize, graph=graph, fuzzy=True, stop_words=STOP_WORDS)
    return [
        Peer(f"{name}, strict", lambda text: strict(_words(text)), lambda text: _steps(strict(_words(text)))),
        Peer(f"{name}, fuzzy", lambda text: fuzzy(_words(text)), lambda text: _steps(fuzzy(_words(text)))),
    ]


def _words(text: str) -> list[str]:
    return list(replace_numbers(plain(text).replace("'", "").split()))


def _steps(results: Any) -> list[Step]:
    if not results:
        return []
    result = results[0]
    found = {entity.entity: entity.value for entity in result.entities}
    slots: dict[str, Any] = {
        name: value for name, value in found.items() if name.rpartition("_")[0] not in QUANTITIES and name != "angle"
    }
    for name in QUANTITIES:
        if f"{name}_n" in found:
            number = float(found[f"{name}_n"]) + float(found.get(f"{name}_half", 0.0))
            slots[name] = number * float(found[f"{name}_unit"])
    if "angle" in found:
        slots["angle"] = float(found["angle"])
    return [(result.intent.name, slots)]
