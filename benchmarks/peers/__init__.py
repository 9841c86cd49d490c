"""The peers: other engines for sentences, each with a grammar of the same commands, written as its own docs write them.

Each module has ``peers(places) -> list[Peer]``: the engine in its strict and, where it has one, its forgiving way.
The grammars know the same intents, names, numbers and units as the shipped grammar as far as the engine can express
them, and its fillers where it has a place for them. Where a peer hands on a quantity as words, our own reader turns
them into SI units: what is compared is which command was understood, not who can count.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, TypeAlias

from intent_engine.language.quantities import evaluate

HERE = Path(__file__).resolve().parent
MODULES = ("hassil_peer", "rhasspy_peer", "adapt_peer", "padacioso_peer")

Step: TypeAlias = tuple[str, dict[str, Any]]
"""(intent, slots): one command."""
Places: TypeAlias = Mapping[str, str]
"""What is said (lower case) -> the name on the map."""


@dataclass(frozen=True)
class Peer:
    """One engine, loaded."""

    name: str
    recognize: Callable[[str], Any]
    """The engine's own verb, on text as its docs want it: what is timed."""
    steps: Callable[[str], list[Step]]
    """What it would do, in our words: what is judged."""


def all_peers(places: Places) -> list[Peer]:
    """Every peer that is installed."""
    return [peer for name in MODULES for peer in peers_of(name, places)]


def peers_of(name: str, places: Places) -> list[Peer]:
    """A peer in its ways; none, and a word about it on standard error, where it is not installed."""
    try:
        module = import_module(f"benchmarks.peers.{name}")
    except ImportError as error:
        print(f"  {name} is left out: {error}; make bench installs what can be had", file=sys.stderr, flush=True)
        return []
    found: list[Peer] = module.peers(places)
    return found


def plain(text: str) -> str:
    """Lower case, without punctuation but decimal points and apostrophes, for peers that take plain words."""
    return " ".join(re.sub(r"(?<!\d)[.]|[.](?!\d)|[^\w.' ]", " ", text.lower().replace("°", " degrees")).split())


def si(words: str, kind: str) -> float | None:
    """The SI value of a quantity in words ("two meters", kind "distance")."""
    value = evaluate(words.split(), kind, "en", None)
    return value if isinstance(value, float) else None
