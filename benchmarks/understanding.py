"""What people really said, understood or not: spoken commands to a robot, talk that is none of them, and quantities.

Reads ``../shared/data`` (see its README); without it there is nothing to measure. The peers hear the same sentences
with the grammars of ``peers/``.

    python -m benchmarks --only understanding
"""

from __future__ import annotations

import json
import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any

from benchmarks import judging
from benchmarks.peers import Peer, Step, all_peers
from benchmarks.report import Report, Table
from intent_engine.language.quantities import find

COMMAND = "python -m benchmarks --only understanding"
DATA = Path(__file__).resolve().parents[2] / "shared" / "data"
MOTIONS = frozenset(("move", "turn", "stop"))
TOLERANCE = 0.011
"""Of distances and angles: labels are rounded feet."""
RIGHT, WRONG, REFUSED = "right", "wrong", "refused"
Label = dict[str, Any]


def run(quick: bool) -> Report:
    """Rows, and how each speaker was understood."""
    if not DATA.is_dir():
        raise FileNotFoundError(f"there is no {DATA}: the sentences of other projects are not kept in this one")
    everyone = [judging.ours(), *all_peers(judging.places())]
    sets = judged_sets(10 if quick else 1)
    found = {peer.name: [share(peer, items) for items in sets.values()] for peer in everyone}
    own, *others = found
    peer = next((name for name in others if name.startswith("hassil")), None)
    rows = [
        row(figure, found[own][place], peer, found[peer][place] if peer else None, len(items))
        for place, (figure, items) in enumerate(sets.items())
    ]
    missed, total = quantities_missed()
    rows.append(row("quantities of other projects' tests read wrongly", 100 * missed / total, None, None, total))
    return Report(rows, [engines(found, sets), speakers(everyone[0])])


def row(figure: str, value: float, peer: str | None, peer_value: float | None, runs: int) -> dict[str, Any]:
    ratio = peer_value / value if peer_value is not None and value else None
    return {
        "figure": figure, "value": value, "unit": "%", "peer": peer, "peer_value": peer_value, "ratio": ratio,
        "spread": None, "runs": runs, "command": COMMAND,
    }  # fmt: skip


# -- what counts as a fault -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Item:
    """A text, and whether what was done about it is a fault."""

    text: str
    fault: Callable[[Sequence[Step]], bool]


def share(peer: Peer, items: Sequence[Item]) -> float:
    """Percent of the items that an engine got wrong."""
    return 100 * sum(item.fault(peer.steps(item.text)) for item in items) / len(items)


def judged_sets(every: int) -> dict[str, list[Item]]:
    """Figure -> what is judged for it; every n-th row only, to try it out."""
    commands, rest = scout()
    slurp = [Item(each["text"], bool) for each in read("slurp_negative/utterances.jsonl")]
    sets = {
        "spoken commands to move, turn and stop (SCOUT): not done as meant": commands,
        "the same, as a recogniser wrote them live": live(),
        "other utterances to the same robot: acted on wrongly": rest,
        "requests to a home assistant (SLURP): acted on": slurp,
        "household instructions (ALFRED): done as another command": household(),
    }
    return {figure: items[::every] for figure, items in sets.items()}


@cache
def read(name: str) -> tuple[Label, ...]:
    return tuple(json.loads(line) for line in (DATA / name).read_text("utf-8").splitlines())


def scout() -> tuple[list[Item], list[Item]]:
    """Commands in our scope, and all others.

    Of the others nothing is to be done, but for two kinds: to go to a place is right where it is understood, though the
    place is not on our map; and where the label says that a command was cancelled, to stop is right.
    """
    commands, rest = [], []
    for label in read("scout/commands.jsonl"):
        meant, text = label["steps"], label["text"]
        if all(step["intent"] in MOTIONS for step in meant):
            commands.append(Item(text, partial(not_as_meant, meant)))
            continue
        allowed = {step["intent"] for step in meant} & {"navigate", "stop"}
        if any(step["slots"].get("what") == "cancel command" for step in meant):
            allowed.add("stop")
        rest.append(Item(text, partial(other_than, allowed)))
    return commands, rest


def live() -> list[Item]:
    """The speech recogniser's own text of spoken commands in our scope, with its mistakes."""
    labels = [label for label in read("scout/asr_pairs.jsonl") if label["intent"] in MOTIONS]
    return [Item(label["asr"], partial(not_as_meant, [label])) for label in labels]


def household() -> list[Item]:
    """Go, turn, pick and place, as crowd workers wrote it: to refuse is no fault, to do another thing is.

    "take the clock to the desk" is labelled as the way to the desk: bringing is no other thing.
    """
    near = {"navigate": {"navigate", "bring", "turn", "move"}, "pick": {"pick", "bring"}, "place": {"place", "bring"}}
    labels = read("alfred_steps/short_in_scope.jsonl")
    return [Item(label["text"], partial(other_than, near[label["project_intent"]])) for label in labels]


def other_than(allowed: AbstractSet[str], found: Sequence[Step]) -> bool:
    """Whether anything was done but these."""
    return not {intent for intent, _ in found} <= allowed


def not_as_meant(meant: Sequence[Label], found: Sequence[Step]) -> bool:
    return not as_meant(found, meant)


def as_meant(found: Sequence[Step], meant: Sequence[Label]) -> bool:
    return len(found) == len(meant) and all(map(_step_as_meant, found, meant))


def _step_as_meant(found: Step, meant: Label) -> bool:
    intent, slots = found
    wanted = meant["slots"]
    if intent != meant["intent"]:
        return False
    if intent == "move":
        same_way = wanted.get("direction", "forward") in (slots.get("direction", "forward"), None)
        return same_way and _near(slots.get("distance"), wanted.get("distance_m"))
    if intent == "turn":
        angle = slots.get("angle")
        half = isinstance(angle, (int, float)) and math.isclose(abs(angle), math.pi, rel_tol=TOLERANCE)
        same_way = half or wanted.get("direction") in (slots.get("side"), None)
        degrees = wanted.get("angle_deg")
        return same_way and _near(angle, None if degrees is None else math.radians(degrees))
    return True


def _near(found: Any, meant: float | None) -> bool:
    if meant is None:
        return True
    return isinstance(found, (int, float)) and math.isclose(abs(found), abs(meant), rel_tol=TOLERANCE)


# -- the rest ---------------------------------------------------------------------------------------------------


def quantities_missed() -> tuple[int, int]:
    """How many of the unambiguous quantities are not found with their value. Angles are labelled in degrees there."""
    rows = [label for label in read("numbers_units/en_values.jsonl") if label["robot_scope"]]

    def right(label: Label) -> bool:
        return any(
            found.kind == label["kind"] or label["kind"] == "number"
            for found in find(label["text"])
            if math.isclose(
                math.degrees(found.value) if found.kind == "angle" else found.value,
                label["value_norm"],
                rel_tol=1e-6,
                abs_tol=1e-6,
            )
        )

    return sum(not right(label) for label in rows), len(rows)


def engines(found: dict[str, list[float]], sets: dict[str, list[Item]]) -> Table:
    """Every engine on every set."""
    cells = [[name, *(f"{value:.2f} %" for value in values)] for name, values in found.items()]
    note = (
        "Share of faults, the smaller the better: of commands those not done exactly as meant (refused or wrong), of "
        "all other utterances those on which something was done. An engine whose free slots take any words picks up "
        "a picture when it is told to take one; ours can be told what is no thing, and the shipped grammar does."
    )
    return Table("What people said, by engine", ["engine", *sets], cells, note)


def speakers(own: Peer) -> Table:
    """Our engine, one row a speaker: nobody must be worse off than the others."""
    counts: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0])
    for label in read("scout/commands.jsonl"):
        if all(step["intent"] in MOTIONS for step in label["steps"]):
            found = own.steps(label["text"])
            verdict = 0 if as_meant(found, label["steps"]) else 1 if found else 2
            counts[label["speaker"]][verdict] += 1
    cells = [
        [speaker, str(sum(each)), *map(str, each), f"{100 * each[0] / sum(each):.1f} %"]
        for speaker, each in sorted(counts.items())
    ]
    total = [sum(column) for column in zip(*counts.values(), strict=True)]
    cells.append(["all", str(sum(total)), *map(str, total), f"{100 * total[0] / sum(total):.1f} %"])
    note = (
        "Commands to move, turn and stop of the SCOUT corpus (people speaking to a mobile robot, transcribed): intent, "
        "direction and value all as the robot's operator understood them. *Wrong*: something else was done; *refused*: "
        "nothing was. The sentences are a development split; others are kept apart."
    )
    return Table(
        "Spoken commands by speaker", ["speaker", "commands", RIGHT, WRONG, REFUSED, "share right"], cells, note
    )
