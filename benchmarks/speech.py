"""Speech: a set of synthetic commands, clean and in noise; the reflex; what listening costs."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from benchmarks.live import play
from benchmarks.recordings import (
    DATA,
    Heard,
    Ways,
    accuracy_rows,
    hear,
    holds,
    kitchen,
    minute,
    row,
    some,
    speech_set,
)
from benchmarks.report import Report, Table
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.hearing import Listener
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.labels import Row
from intent_engine.evaluation.scoring import Outcome, Verdict, quantile
from intent_engine.evaluation.sound import load, read_whole
from intent_engine.evaluation.trial import Trial
from intent_engine.resources import default_grammar, default_locations
from intent_engine.runtime.heard import HeardKind
from intent_engine.speech.audio import SAMPLE_RATE, Samples

_COMMAND = "python -m benchmarks --only speech"
NOISE_SNR = 10.0
"""dB"""
FEWEST = 8
"""Stop words of which a median tells anything."""
NOTE = (
    "Right + wrong, plain commands and the grammar's rare sentences, ours. Voices named espeak are formant synthesis."
)
PAUSE = 1.0
"""s between two commands of a minute of commands."""
OWN_TIME = 40
"""Commands that are heard by the machine's clock."""


def run(quick: bool) -> Iterator[Report | list[dict[str, Any]]]:
    """The rows of this benchmark."""
    engine = IntentEngine.from_files(default_grammar(), locations=default_locations())
    labels = read_labels(speech_set(), engine)
    notes = {str(label["id"]): label for label in map(json.loads, speech_set().read_text("utf-8").splitlines())}
    chosen = some(labels, quick)
    ways = Ways.of(engine)
    trial = Trial(kitchen(), [NOISE_SNR])
    ours, peer = hear("commands", chosen, trial, (ways.ours, ways.peer))
    rows = []
    for snr in (condition.snr for condition in trial.conditions("")):
        name = "clean" if snr is None else f"kitchen noise at {snr:g} dB"
        for kind, what in (("plain", "plain commands"), ("sampled", "the grammar's rare sentences"), ("other", "talk")):
            pair = [[one for one in heard[snr] if notes[one.row.id]["kind"] == kind] for heard in (ours, peer)]
            if pair[0]:
                rows += accuracy_rows(f"{what}, {name}", _COMMAND, *pair)
        rows += reflex_rows(name, ours[snr])
    voices = {name: str(note["voice"]) for name, note in notes.items()}
    yield Report(rows, [by_voice(ours, voices)])
    paused = some(read_labels(speech_set("paused"), engine), quick)
    pausing, peer = hear("commands with a pause", paused, Trial(), (ways.ours, ways.peer))
    yield accuracy_rows("commands with a pause of 0.25 to 1.2 s in them, clean", _COMMAND, pausing[None], peer[None])
    rightly = [one.row for one in ours[None] if one.latency is not None]
    yield in_its_own_time(engine, rightly[:: max(1, len(rightly) // (4 if quick else OWN_TIME))], quick)


def by_voice(heard: Heard, voices: Mapping[str, str]) -> Table:
    """How many commands were right of each voice: some are hardly like a person's."""
    conditions = sorted(heard, key=lambda snr: -math.inf if snr is None else -snr)
    rows = []
    for voice in dict.fromkeys(voices.values()):
        cells = []
        for snr in conditions:
            mine = [one for one in heard[snr] if voices[one.row.id] == voice and one.row.expected.command]
            right, wrong = (sum(one.verdict is which for one in mine) for which in (Verdict.RIGHT, Verdict.WRONG))
            cells.append(f"{right} + {wrong} of {len(mine)}")
        rows.append([voice, *cells])
    columns = ["voice", *("clean" if snr is None else f"kitchen noise at {snr:g} dB" for snr in conditions)]
    return Table("Synthetic commands by voice", columns, sorted(rows), NOTE)


def reflex_rows(name: str, outcomes: list[Outcome]) -> list[dict[str, Any]]:
    """Of recordings that are a stop phrase and nothing else, so that the word's end is the sound's."""
    stops = [one for one in outcomes if one.row.expected.stops and len((one.row.text or "").split()) == 1]
    others = [one for one in outcomes if not one.row.expected.stops]
    rows = []
    if len(stops) >= FEWEST:
        times = [one.held for one in stops if one.held is not None]
        rows += holds(f"stop word, synthetic voices, {name}", _COMMAND, times, len(stops))
    held = sum(one.held_at is not None for one in others)
    figure = f"everything else, synthetic voices, {name}: held for a moment"
    return [*rows, row(figure, _COMMAND, 100 * held / max(len(others), 1), "%", runs=len(others))]


# -- in its own time --------------------------------------------------------------------------------------------------


def in_its_own_time(engine: IntentEngine, commands: list[Row], quick: bool) -> list[dict[str, Any]]:
    """What a virtual clock cannot tell: how late commands are by the machine's own, and what listening costs."""
    ways = Ways.of(engine, live=True)
    late = {"ours": late_by(ways.ours, commands), "peer": late_by(ways.peer, commands)}
    rows = []
    for name, part in (("p50", 0.5), ("p90", 0.9)):
        mine, theirs = (quantile(times, part) for times in late.values())
        if mine is not None and theirs is not None:
            figure = f"commands, clean, heard in their own time: end of speech to action, {name}"
            spread = [1000 * min(late["ours"]), 1000 * max(late["ours"])]
            rows.append(row(figure, _COMMAND, 1000 * mine, "ms", 1000 * theirs, spread=spread, runs=len(late["ours"])))
    return rows + cost(ways, [load(one) for one in commands], quick)


def late_by(way: Listener, commands: list[Row]) -> list[float]:
    """s from the end of speech to the action, by the machine's clock, of commands after which one thing was done."""
    play(way, load(commands[0]))  # to warm up
    times = []
    for command in commands:
        done = [time for time, event in play(way, load(command)).events if event.kind is HeardKind.SUBMITTED]
        if len(done) == 1 and command.speech_end is not None:
            times.append(done[0] - command.speech_end)
    return times


def cost(ways: Ways, commands: list[Samples], quick: bool) -> list[dict[str, Any]]:
    """Processor time for a minute of silence, of talk and of commands."""
    room = np.random.default_rng(1).normal(0.0, 0.0003, 60 * SAMPLE_RATE).astype(np.float32)
    talk = sorted((DATA / "clips" / "audio").glob("*austen*.flac"))
    gap = np.zeros(int(PAUSE * SAMPLE_RATE), np.float32)
    sounds = {
        "silence": room,
        "talk": minute([read_whole(path) for _ in range(4) for path in talk]) if talk else None,
        "commands": minute([part for sound in commands for part in (sound, gap)]),
    }
    rows = []
    for name, sound in sounds.items():
        if sound is None:
            continue
        if quick:
            sound = sound[: 15 * SAMPLE_RATE]
        mine, theirs = (core_seconds(way, sound) for way in (ways.ours, ways.peer))
        rows.append(row(f"core-seconds for a minute of {name}", _COMMAND, mine, "s", theirs))
    return rows


def core_seconds(way: Listener, sound: Samples) -> float:
    """Processor time of all threads for a minute of such sound."""
    return play(way, sound).core_seconds * 60 * SAMPLE_RATE / sound.size
