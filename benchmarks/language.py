"""Text to action: how fast, how that grows with the grammar, what loading costs, and who does what he is told.

Beside hassil, rhasspy-nlu, Adapt and Padacioso, with a grammar of the same commands for each (``peers/``), in the same
run and in turns, so that what else the machine does hits all of them.
"""

from __future__ import annotations

import random
import statistics
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import yaml

from benchmarks import fresh, judging
from benchmarks.clock import Parse, Times, answered, in_turns, median, no_collector, over_rounds, worst
from benchmarks.locations import numbered_names
from benchmarks.peers import Peer, all_peers, peers_of
from benchmarks.report import Plot, Report, Table
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.locations import LocationMap

COMMAND = "python -m benchmarks --only language"
PICTURE = "language-cost.svg"


def run(quick: bool) -> Iterator[Report | list[dict[str, Any]]]:
    """Rows, the table of verdicts, and the plot of cost against size; part by part."""
    everyone = [judging.ours(), *all_peers(judging.places())]
    table, judged = verdicts(everyone)
    yield Report(judged, [table])
    yield exact(everyone, 3 if quick else 15)
    yield with_a_large_map(1_000 if quick else 10_000, 3 if quick else 15)
    yield first_said(2 if quick else 5)
    grown, places = locations((20, 1_000) if quick else (20, 1_000, 10_000, 100_000), 10 if quick else 40)
    yield Report(grown, [], [places])
    more, intents = many_intents((10, 100) if quick else (10, 100, 1_000), 10 if quick else 40)
    yield Report(more, [], [intents])
    yield from cliffs(quick)
    yield loading(2 if quick else 7)


def row(
    figure: str,
    value: float,
    unit: str,
    peer: str | None = None,
    peer_value: float | None = None,
    runs: int = 1,
    spread: Sequence[float] | None = None,
) -> dict[str, Any]:
    ratio = peer_value / value if peer_value is not None and value else None
    return {
        "figure": figure, "value": value, "unit": unit, "peer": peer, "peer_value": peer_value, "ratio": ratio,
        "spread": list(spread) if spread else None, "runs": runs, "command": COMMAND,
    }  # fmt: skip


# -- the shipped grammar ------------------------------------------------------------------------------------------


def exact(everyone: list[Peer], rounds: int) -> list[dict[str, Any]]:
    """Plain sentences of the shipped grammar, said before: what an utterance costs."""
    times = in_turns({peer.name: peer.recognize for peer in everyone}, list(judging.of_kind("plain")), rounds)
    own, *others = everyone
    rows = []
    for what, summary in (("median", median), ("worst", worst)):
        spread = over_rounds(times[own.name], summary)
        value = summary(times[own.name])
        for peer in others:
            figure = f"exact words, shipped grammar, {what} utterance"
            rows.append(row(figure, value, "us", peer.name, summary(times[peer.name]), rounds, spread))
    return rows


def with_a_large_map(size: int, rounds: int) -> list[dict[str, Any]]:
    """The same sentences, where the map holds the home of the sentences and very many places besides."""
    home = judging.places()
    large = {**home, **{name: name for name in numbered_names(size)}}
    engines = {
        "ours": judging.engine().parse,
        "ours, large": IntentEngine.from_files(judging.GRAMMAR, locations=_map_of(tuple(large))).parse,
        "hassil": _hassil(home),
        "hassil, large": _hassil(large),
    }
    times = in_turns(engines, list(judging.of_kind("plain")), rounds)
    spread = over_rounds(times["ours, large"], median)
    figure = f"exact words, shipped grammar, {size:,} locations"
    slower = {name: median(times[f"{name}, large"]) / median(times[name]) for name in ("ours", "hassil")}
    return [
        row(f"{figure}, median utterance", median(times["ours, large"]), "us", "hassil",
            median(times["hassil, large"]), rounds, spread),
        row(f"{figure}, against {len(home)}", slower["ours"], "times", "hassil", slower["hassil"], rounds),
    ]  # fmt: skip


def varied(count: int, seed: int) -> list[str]:
    """Different sentences of the shipped grammar, none twice."""
    choose = random.Random(seed)
    numbers = ["two", "three", "five", "seven", "ten", "twelve", "twenty", "thirty five", "forty", "sixty", "ninety"]
    parts = [
        ("go", "move", "drive", "roll"), ("forward", "backward", "straight ahead"), numbers, ("meters", "feet"),
        ("turn", "rotate", "spin"), ("left", "right"), numbers, ("pick up", "grab", "fetch"),
        ("red", "small", "blue", "old"), ("cup", "bottle", "box", "book", "ball"),
    ]  # fmt: skip
    found: dict[str, None] = {}
    while len(found) < count:
        go, way, far, unit, turn, side, angle, pick, kind, thing = (choose.choice(part) for part in parts)
        sentence = (f"{go} {way} {far} {unit}", f"{turn} {side} {angle} degrees", f"{pick} the {kind} {thing}")
        found[choose.choice(sentence)] = None
    return list(found)


def first_said(rounds: int) -> list[dict[str, Any]]:
    """Sentences said for the first time: in a program that has just begun, and in one that runs for a while."""
    begun: Times = {"ours": [], "hassil": []}
    running: Times = {"ours": [], "hassil": []}
    plain = list(judging.of_kind("plain"))
    for seed in range(rounds):
        for name, parse in (("ours", judging.engine().parse), ("hassil", _hassil(judging.places()))):
            random.Random(seed).shuffle(plain)
            begun[name] += in_turns({name: parse}, plain, 1, warm=False)[name]
            said = varied(300, seed)
            for sentence in said[:200]:
                parse(sentence)
            running[name] += in_turns({name: parse}, said[200:], 1, warm=False)[name]
    rows = []
    for figure, times in (
        ("first time said, new program", begun),
        ("first time said, after 200 other sentences", running),
    ):
        for what, summary in (("median", median), ("worst", worst)):
            own = times["ours"]
            spread = over_rounds(own, summary)
            rows.append(
                row(f"{figure}, {what}", summary(own), "us", "hassil", summary(times["hassil"]), rounds, spread)
            )
    return rows


def _hassil(places: Mapping[str, str], text: str | None = None) -> Parse:
    from hassil import recognize

    from benchmarks.peers.hassil_peer import load

    intents, lists = load(places, text)
    return partial(recognize, intents=intents, slot_lists=lists, language="en")


# -- cost against size --------------------------------------------------------------------------------------------


def locations(sizes: Sequence[int], said: int) -> tuple[list[dict[str, Any]], Plot]:
    """ "go to the north kitchen 17", with more and more names."""
    rows: list[dict[str, Any]] = []
    series: dict[str, list[list[float]]] = {}
    smallest: float | None = None
    for size in sizes:
        names = numbered_names(size)
        engines = _with_places(names)
        choose = random.Random(size)
        sentences = [f"go to the {choose.choice(names)}" for _ in range(said)]
        for parse in engines.values():
            parse(f"go to the {names[-1]}")  # what is built at the first name is not this figure
        new = in_turns(engines, sentences, 1, warm=False)
        few = {name: parse for name, parse in engines.items() if name in ("Intent Engine", "hassil", "adapt")}
        times = new | in_turns(few, sentences, 3, warm=False)
        for name in engines:
            series.setdefault(name, []).append([size, median(times[name])])
        own = times["Intent Engine"]
        for what, summary in (("median", median), ("worst", worst)):
            figure = f"a name among {size:,}, {what}"
            rows.append(row(f"{figure}, said before", summary(own), "us", "hassil", summary(times["hassil"]), said,
                            over_rounds(own, summary)))  # fmt: skip
            first = summary(new["Intent Engine"])
            rows.append(row(f"{figure}, first time", first, "us", "hassil", summary(new["hassil"]), said))
        smallest = smallest or median(own)
        if size in (10_000, sizes[-1]):
            rows.append(row(f"a name among {size:,} against {sizes[0]}", median(own) / smallest, "times"))
    return rows, Plot("An exact name among more and more", PICTURE, "locations", "us per utterance", series)


def _with_places(names: list[str]) -> dict[str, Parse]:
    """The engines with these names; those whose cost grows with all names only as far as they can go."""
    places = {name: name for name in names}
    found: dict[str, Parse] = {"Intent Engine": _ours_with(names), "hassil": _hassil(places)}
    if adapt := peers_of("adapt_peer", places):
        found["adapt"] = adapt[0].recognize
    if len(names) <= 1_000 and (rhasspy := peers_of("rhasspy_peer", places)):
        found["rhasspy-nlu"] = rhasspy[0].recognize
    return found


def _ours_with(names: list[str]) -> Parse:
    return IntentEngine.from_files(judging.GRAMMAR, locations=_map_of(names)).parse


def many_intents(sizes: Sequence[int], said: int) -> tuple[list[dict[str, Any]], Plot]:
    """Grammars of more and more intents, each with two sentences, an optional and a choice of words."""
    rows: list[dict[str, Any]] = []
    series: dict[str, list[list[float]]] = {}
    for size in sizes:
        names = numbered_names(size)
        templates = {
            f"intent_{place}": [f"(do|run|start) the {name} [now]", f"[please] show {name}"]
            for place, name in enumerate(names)
        }
        engines = {"Intent Engine": _ours_grammar(templates), "hassil": _hassil({}, _hassil_grammar(templates))}
        choose = random.Random(size)
        sentences = [f"{choose.choice(('do', 'run', 'start'))} the {choose.choice(names)}" for _ in range(said)]
        times = in_turns(engines, sentences, 3)
        for name in engines:
            series.setdefault(name, []).append([size, median(times[name])])
        own = times["Intent Engine"]
        spread = over_rounds(own, median)
        rows.append(row(f"a grammar of {size:,} intents, median", median(own), "us", "hassil", median(times["hassil"]),
                        said, spread))  # fmt: skip
    return rows, Plot("A sentence of more and more intents", PICTURE, "intents", "us per utterance", series)


def _ours_grammar(
    templates: Mapping[str, list[str]], slots: Mapping[str, Any] | None = None, names: Sequence[str] = ()
) -> Parse:
    intents = {
        name: {"action": {"type": "custom", "name": name}, "sentences": sentences}
        for name, sentences in templates.items()
    }
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "grammar.yaml"
        path.write_text(yaml.safe_dump({"language": "en", "slots": dict(slots or {}), "intents": intents}), "utf-8")
        return IntentEngine.from_files(path, locations=_map_of(names) if names else None).parse


def _map_of(names: Sequence[str]) -> LocationMap:
    return LocationMap.from_mapping(dict.fromkeys(names, (1.0, 2.0, 0.0)))


def _hassil_grammar(templates: Mapping[str, list[str]], lists: Mapping[str, Any] | None = None) -> str:
    intents = {name: {"data": [{"sentences": sentences}]} for name, sentences in templates.items()}
    return yaml.safe_dump({"language": "en", "intents": intents, "lists": dict(lists or {})})


# -- cliffs -------------------------------------------------------------------------------------------------------


def cliffs(quick: bool) -> Iterator[list[dict[str, Any]]]:
    """Three grammars that a person may well write and that cost a backtracking matcher dearly."""
    yield _wildcard(1_000 if quick else 5_000)
    yield _numbers(10_000 if quick else 100_000)
    yield _optionals(12 if quick else 18)


def understood(result: Any) -> bool:
    """Whether an engine, ours or hassil, took a sentence."""
    return result is not None and getattr(result, "status", Status.ACCEPTED) is Status.ACCEPTED


def _once_and_again(figure: str, own: Parse, other: Parse, sentences: Sequence[str]) -> list[dict[str, Any]]:
    """The first sentence, and the worst of the ones after it, each of which is said for the first time too."""
    times: list[list[float]] = []
    for parse in (own, other):
        with no_collector():
            timed = [answered(parse, sentence) for sentence in sentences]
        assert all(understood(result) for _, result in timed), sentences
        times.append([took for took, _ in timed])
    (mine, *my_later), (theirs, *their_later) = times
    rows = [row(f"{figure}, first sentence", 1e3 * mine, "ms", "hassil", 1e3 * theirs)]
    worst_later = f"{figure}, worst of the later ones"
    return [*rows, row(worst_later, 1e3 * max(my_later), "ms", "hassil", 1e3 * max(their_later), len(my_later))]


def _wildcard(count: int) -> list[dict[str, Any]]:
    """ "bring the old blue box to the north kitchen 17": free words straight before a name."""
    names = numbered_names(count)
    templates = {"bring": ["bring {thing} [to] [the] {place}"]}
    slots = {
        "thing": {"type": "text", "max_words": 5},
        "place": {"type": "choice", "values": {name: name for name in names}},
    }
    own = _ours_grammar(templates, slots)
    other = _hassil(dict(zip(names, names, strict=True)), _hassil_grammar(templates, {"thing": {"wildcard": True}}))
    sentences = [f"bring the old blue box to the {name}" for name in names[:: count // 6]]
    return _once_and_again(f"free words before one of {count:,} names", own, other, sentences)


def _numbers(most: int) -> list[dict[str, Any]]:
    """ "set it to forty two thousand one hundred and seven": a wide range of numbers."""
    templates = {"set": ["set it to {n}"]}
    own = _ours_grammar(templates, {"n": {"type": "number", "min": 0, "max": most}})
    other = _hassil({}, _hassil_grammar(templates, {"n": {"range": {"from": 0, "to": most}}}))
    sentences = [
        f"set it to {number}" for number in ("seven", "forty two", "nine thousand one hundred", "88", "ninety")
    ]
    return _once_and_again(f"numbers to {most:,}", own, other, sentences)


def _optionals(count: int) -> list[dict[str, Any]]:
    """ "[(very|so)] [(very|so)] ... good": words that may be left out, each of which could be the one that was said."""
    templates = {"praise": ["[(very|so)] " * count + "good"]}
    own, other = _ours_grammar(templates), _hassil({}, _hassil_grammar(templates))
    sentences = [" ".join(["very", "so"] * (count // 4) + ["good"])] * 2
    return _once_and_again(f"{count} optional words, half of them said", own, other, sentences)


# -- loading ------------------------------------------------------------------------------------------------------


def loading(runs: int) -> list[dict[str, Any]]:
    """ms and MB of a new process: import, load, first sentence, first place."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        cache = Path(folder) / "byte code"
        for size in (20, 10_000):
            names = numbered_names(size)
            poses = {"locations": {name: {"x": 1.0, "y": 2.0, "yaw": 0.0} for name in names}}
            files = {"ours": Path(folder) / "map.yaml", "hassil": Path(folder) / "names.yaml"}
            files["ours"].write_text(yaml.safe_dump(poses, width=1000), "utf-8")
            files["hassil"].write_text(yaml.safe_dump(names), "utf-8")
            found = {name: fresh.in_new_processes(name, path, names[-1], runs, cache) for name, path in files.items()}
            for what, keys, unit, scale in (
                ("loading the shipped grammar", ("load",), "ms", 1e3),
                ("first sentence after it", ("first",), "ms", 1e3),
                ("first sentence with a place, after that", ("place",), "ms", 1e3),
                ("a new program up to its first answer: import, load, parse", ("import", "load", "first"), "ms", 1e3),
                ("memory of grammar and map, after a sentence", ("memory",), "MB", 1e-6),
                ("the same, after a sentence with a place", ("memory_place",), "MB", 1e-6),
            ):
                own, theirs = (
                    [scale * sum(one[key] for key in keys) for one in found[name]] for name in ("ours", "hassil")
                )
                rows.append(row(f"{what}, {size:,} locations", statistics.median(own), unit, "hassil",
                                statistics.median(theirs), runs, [min(own), max(own)]))  # fmt: skip
        for module, peer in (("intent_engine", "hassil"), ("intent_engine.engine", "hassil")):
            own, theirs = ([1e3 * one for one in fresh.imported(name, runs, cache)] for name in (module, peer))
            rows.append(row(f"import {module}", statistics.median(own), "ms", f"import {peer}",
                            statistics.median(theirs), runs, [min(own), max(own)]))  # fmt: skip
    return rows


# -- who does what he is told -------------------------------------------------------------------------------------


def verdicts(everyone: list[Peer]) -> tuple[Table, list[dict[str, Any]]]:
    """For each engine and kind of sentence: right / wrong / refused."""
    found = {peer.name: judging.verdicts(peer) for peer in everyone}
    kinds = list(dict.fromkeys(sentence.kind for sentence in judging.sentences()))
    own, *others = everyone
    cells = [
        [name, *(" / ".join(str(kinds_of[kind][one]) for one in ("right", "wrong", "refused")) for kind in kinds)]
        for name, kinds_of in found.items()
    ]
    total = len(judging.sentences())
    wrong = {name: sum(each["wrong"] for each in kinds_of.values()) for name, kinds_of in found.items()}
    missed = {name: sum(each["refused"] for each in kinds_of.values()) for name, kinds_of in found.items()}
    rows = []
    for figure, counts in (("acted on wrongly", wrong), ("refused, though commands", missed)):
        for peer in others:
            rows.append(
                row(f"of {total} sentences, {figure}", counts[own.name], "", peer.name, counts[peer.name], total)
            )
    note = (
        "Right / wrong / refused. *Wrong*: something was done that was not asked for; *refused*: nothing was done, "
        "though something was asked for. Sentences: `benchmarks/sentences.yaml`; grammars: `benchmarks/peers/`. "
        "Every peer's grammar was written until it had every plain and filler sentence right, so that what is left "
        "is the engine and not its author. Times are processor time of the parsing thread, each sentence by its "
        "median, without garbage collection."
    )
    return Table("The same sentences through every engine", ["engine", *kinds], cells, note), rows
