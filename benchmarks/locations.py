"""Places: how often a misheard name is understood, or taken for another; how fast among many; how fast a map loads.

Beside rapidfuzz's ``WRatio`` over all names, what one writes first, and padacioso, which has fuzzy names too.

    python -m benchmarks --only locations
"""

from __future__ import annotations

import gc
import json
import random
import statistics
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

from rapidfuzz import fuzz, process

from intent_engine.language.locations import LocationMap, load
from intent_engine.language.names import NameIndex
from intent_engine.language.slots.name_words import name_words

HERE = Path(__file__).resolve().parent
COMMAND = "python -m benchmarks --only locations"
WRATIO_CUTOFF = 80
"""What a peer accepts, of 100."""
RESPELLINGS = (
    ("ee", "ea"), ("ea", "ee"), ("oo", "u"), ("ai", "ay"), ("ay", "ai"), ("ck", "k"), ("c", "k"), ("ph", "f"),
    ("ch", "tch"), ("tch", "ch"), ("gh", "g"), ("tt", "t"), ("ll", "l"), ("l", "ll"), ("ff", "f"), ("bb", "b"),
    ("i", "y"), ("y", "i"), ("e", "i"), ("i", "e"), ("a", "e"), ("o", "a"), ("e", "a"), ("er", "or"), ("or", "er"),
)  # fmt: skip
"""Letters that sound alike in English, as recognisers and people exchange them."""
NUMBERS_HEARD = {"one": "won", "two": "to", "three": "tree", "four": "for", "eight": "ate"}
FIRST = [
    *(
        "north",
        "south",
        "east",
        "west",
        "upper",
        "lower",
        "inner",
        "outer",
        "main",
        "old",
        "new",
        "red",
        "blue",
        "green",
    ),
    *("quiet", "central", "loading", "storage", "charging", "packing", "sorting", "cooling", "meeting", "dining"),
]
SECOND = [
    *("kitchen", "office", "corridor", "bedroom", "station", "cabinet", "warehouse", "laboratory", "garden", "terrace"),
    *("workshop", "library", "gallery", "storeroom", "platform", "counter", "junction", "lobby", "canteen", "hall"),
]
SYLLABLES = [a + b for a, b in product("bdfgklmnprstvz", ("a", "e", "i", "o", "u", "ar", "en", "il"))]


def run(quick: bool) -> Iterator[list[dict[str, Any]]]:
    """The rows of this benchmark."""
    yield understood()
    for count in (10_000,) if quick else (10_000, 100_000):
        yield speed(count, 60 if quick else 300)
        yield loading(count, 3 if quick else 9)


def row(
    figure: str, value: float, unit: str, peer: str | None, peer_value: float | None, runs: int, spread: Any = None
) -> dict[str, Any]:
    ratio = peer_value / value if peer_value is not None and value else None
    return {
        "figure": figure, "value": value, "unit": unit, "peer": peer, "peer_value": peer_value, "ratio": ratio,
        "spread": spread, "runs": runs, "command": COMMAND,
    }  # fmt: skip


# -- understood or not ----------------------------------------------------------------------------------------


class Names:
    """One list of names, resolved by us and by a peer."""

    def __init__(self, entries: Iterable[tuple[str, str]]) -> None:
        self.entries = list(entries)
        self.index = NameIndex(self.entries)
        self._spoken = [spoken for spoken, _ in self.entries]

    def ours(self, heard: str) -> tuple[str | None, bool]:
        """The name, and whether we would ask."""
        match = self.index.resolve(heard)
        return match.name, match.status == "ambiguous"

    def peers(self, heard: str) -> tuple[str | None, bool]:
        found = process.extractOne(heard, self._spoken, scorer=fuzz.WRatio, score_cutoff=WRATIO_CUTOFF)
        return (self.entries[found[2]][1] if found else None), False


def _maps() -> dict[str, dict[str, Names]]:
    """Split -> map -> names."""
    data = json.loads((HERE / "heard_names.json").read_text("utf-8"))
    shipped = {name: load(HERE.parent / "locations" / f"{name}.yaml") for name in ("home", "warehouse")}
    return {
        "tuned": {name: Names(_spoken(places)) for name, places in shipped.items()},
        "held out": {name: Names([(spoken, spoken) for spoken in names]) for name, names in data["maps"].items()},
    }


def _spoken(places: LocationMap) -> Iterator[tuple[str, str]]:
    for place in places.values():
        yield place.name, place.name
        yield from ((alias, place.name) for alias in place.aliases)


def understood() -> list[dict[str, Any]]:
    """Names as a recogniser wrote them, names respelled by rule, and names that are on no map."""
    data = json.loads((HERE / "heard_names.json").read_text("utf-8"))
    rows: list[dict[str, Any]] = []
    for split, maps in _maps().items():
        heard = [item for item in data["heard"] if item["split"] == split]
        misheard = [
            (maps[item["map"]], item["heard"], maps[item["map"]].ours(item["said"])[0])
            for item in heard
            if item["map"] and name_words(item["heard"]) != name_words(item["said"])
        ]
        others = {item["heard"] for item in heard if item["map"] is None} | set(data["other places"])
        absent = [
            (names, other, None) for names, other in product(maps.values(), sorted(others)) if not _holds(names, other)
        ]
        respelled = [(names, spelled, name) for names in maps.values() for spelled, name in sorted(_respelled(names))]
        rows += _verdicts(f"names as Whisper misheard them, {split} maps", misheard)
        rows += _verdicts(f"names respelled by sound, {split} maps", respelled)
        rows += _verdicts(f"words that are no place, {split} maps", absent)
    return rows


def _holds(names: Names, words: str) -> bool:
    return names.index.resolve(words).status == "exact"


def _respelled(names: Names) -> set[tuple[str, str]]:
    """One change by sound at each place where a rule applies; a spelling that is another name's is left out."""
    known = {name_words(spoken) for spoken, _ in names.entries}
    found: dict[str, set[str]] = {}
    for spoken, name in names.entries:
        words = spoken.split(" ")
        variants = {"".join(words)} if len(words) > 1 and words[-1].isalpha() else set()
        for place, word in enumerate(words):
            changed = [word[:at] + new + word[at + len(old) :] for old, new in RESPELLINGS for at in _places(word, old)]
            changed += [word + "s"] if word.isalpha() and len(word) > 3 else []
            changed += [NUMBERS_HEARD[word]] if word in NUMBERS_HEARD and place else []
            variants |= {" ".join((*words[:place], other, *words[place + 1 :])) for other in changed}
        for variant in variants:
            found.setdefault(variant, set()).add(name)
    return {
        (variant, next(iter(meant)))
        for variant, meant in found.items()
        if len(meant) == 1 and name_words(variant) not in known
    }


def _places(word: str, piece: str) -> Iterator[int]:
    """Where a piece stands in a word, but not at its beginning: that is seldom misheard."""
    at = word.find(piece, 1)
    while at > 0:
        yield at
        at = word.find(piece, at + 1)


def _verdicts(what: str, cases: list[tuple[Names, str, str | None]]) -> list[dict[str, Any]]:
    """Percentages of wrong places, questions, and names not understood."""
    rows = []
    total = len(cases)
    ours = [names.ours(heard) for names, heard, _ in cases]
    peers = [names.peers(heard) for names, heard, _ in cases]
    peer = f"WRatio at {WRATIO_CUTOFF}"

    def share(found: list[tuple[str | None, bool]], wanted: Callable[[str | None, bool, str | None], bool]) -> float:
        hits = sum(wanted(name, asks, truth) for (name, asks), (_, _, truth) in zip(found, cases, strict=True))
        return 100 * hits / total

    def wrong(name: str | None, asks: bool, truth: str | None) -> bool:
        return name is not None and name != truth

    rows.append(row(f"{what}: taken for a place wrongly", share(ours, wrong), "%", peer, share(peers, wrong), total))
    if any(truth is not None for _, _, truth in cases):

        def missed(name: str | None, asks: bool, truth: str | None) -> bool:
            return name is None

        value = share(ours, missed)
        rows.append(row(f"{what}: not understood, or asked about", value, "%", peer, share(peers, missed), total))
    asked = share(ours, lambda name, asks, truth: asks)
    rows.append(row(f"{what}: asked about", asked, "%", None, None, total))
    return rows


# -- how fast -------------------------------------------------------------------------------------------------


def numbered_names(count: int) -> list[str]:
    """ "north kitchen 17": few words, many numbers."""
    return [f"{FIRST[k % len(FIRST)]} {SECOND[k // len(FIRST) % len(SECOND)]} {k}" for k in range(count)]


def made_up_names(count: int) -> list[str]:
    """ "dala resil": every word another, no numbers."""
    choose = random.Random(1)
    found: set[str] = set()
    while len(found) < count:
        words = ("".join(choose.choices(SYLLABLES, k=choose.randint(2, 4))) for _ in range(choose.randint(1, 3)))
        found.add(" ".join(words))
    return sorted(found)


def misspelt(name: str, choose: random.Random) -> str:
    """One letter wrong, never in a number."""
    places = [at for at, letter in enumerate(name) if letter.isalpha()]
    at = choose.choice(places)
    return name[:at] + choose.choice("aeiourst") + name[at + 1 :]


def speed(count: int, runs: int) -> list[dict[str, Any]]:
    """ms for a misspelt name, and for words that are no name."""
    rows = []
    for what, names in (("numbered", numbered_names(count)), ("made up", made_up_names(count))):
        choose = random.Random(2)
        index = NameIndex([(name, name) for name in names])
        started = time.perf_counter()
        index.prepare()
        ready = time.perf_counter() - started
        said = [misspelt(choose.choice(names), choose) for _ in range(runs)]
        ours = [_timed(partial(index.resolve, heard)) for heard in said]
        few = said[: max(5, runs // 20)]
        peers = [_timed(partial(process.extractOne, heard, names, scorer=fuzz.WRatio)) for heard in few]
        figure = f"a misspelt name among {count:,} {what} names"
        rows.append(_times(f"{figure}, median", ours, statistics.median, "WRatio over all", peers))
        rows.append(_times(f"{figure}, p95", ours, lambda times: sorted(times)[int(len(times) * 0.95)], None, []))
        unknown = [_timed(partial(index.resolve, f"somewhere quite different {k}")) for k in range(runs // 3)]
        rows.append(_times(f"words that are no name among {count:,} {what} names, median", unknown, statistics.median))
        rows.append(row(f"making ready for fuzzy names, {count:,} {what}, once", 1e3 * ready, "ms", None, None, 1))
        if what == "numbered" and count <= 10_000:
            rows[-4:-4] = _padacioso(figure, names, few, ours)
    return rows


def _padacioso(figure: str, names: list[str], said: list[str], ours: list[float]) -> list[dict[str, Any]]:
    try:
        from padacioso import IntentContainer
    except ImportError as error:
        print(f"  padacioso is left out: {error}", file=sys.stderr, flush=True)
        return []
    container = IntentContainer(fuzz=True)
    container.add_intent("go", ["go to {place}"])
    container.add_entity("place", names)
    container.calc_intent("go to nowhere")
    theirs = [_timed(lambda heard=heard: container.calc_intent(f"go to {heard}")) for heard in said[:5]]
    return [_times(f"{figure}, median", ours, statistics.median, "padacioso 1.0.0 (leaves the name as heard)", theirs)]


def _timed(call: Callable[[], object]) -> float:
    started = time.perf_counter()
    call()
    return time.perf_counter() - started


def _times(
    figure: str,
    ours: list[float],
    summary: Callable[[list[float]], float] = min,
    peer: str | None = None,
    peers: list[float] | None = None,
) -> dict[str, Any]:
    theirs = 1e3 * statistics.median(peers) if peers else None
    spread = [1e3 * min(ours), 1e3 * max(ours)]
    return row(figure, 1e3 * summary(ours), "ms", peer if theirs else None, theirs, len(ours), spread)


def loading(count: int, runs: int) -> list[dict[str, Any]]:
    """ms to load a map, as people write it and as programs do, beside PyYAML alone; and what it keeps."""
    import yaml

    rows = []
    names = numbered_names(count)
    data = {"locations": {name: {"x": k * 0.5, "y": 2.0, "yaw": 0.0} for k, name in enumerate(names)}}
    for style, what in ((None, "a line a place"), (False, "a line a value")):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "map.yaml"
            path.write_text(yaml.safe_dump(data, default_flow_style=style, width=1000), "utf-8")
            text = path.read_text("utf-8")
            loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
            theirs = [_timed(lambda text=text, loader=loader: yaml.load(text, Loader=loader))]
            load(path)
            ours = []
            for _ in range(runs):
                gc.collect()
                ours.append(_timed(lambda path=path: load(path)))
            figure = f"loading a map of {count:,} places, {what}"
            rows.append(_times(figure, ours, statistics.median, "PyYAML (C), values only", theirs))
            tracemalloc.start()
            places = load(path)
            kept = tracemalloc.get_traced_memory()[0]
            places.index.prepare()
            indexed = tracemalloc.get_traced_memory()[0]
            tracemalloc.stop()
    rows.append(row(f"memory of {count:,} places", kept / 1e6, "MB", None, None, 1))
    rows.append(
        row(f"memory of the fuzzy index of {count:,} names, besides", (indexed - kept) / 1e6, "MB", None, None, 1)
    )
    return rows
