"""People: single words by many speakers, and passages of an audiobook; what is done, and how soon a stop holds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from benchmarks.recordings import DATA, Ways, accuracy_rows, hear, holds, kitchen, needs, row, some
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.scoring import Outcome, Verdict
from intent_engine.evaluation.sound import end_of_speech, load
from intent_engine.evaluation.trial import Trial
from intent_engine.resources import default_grammar, default_locations

WORD_FLOOR = 25.0
"""dB below the loudest part of a word where it counts as ended: these recordings are not quiet enough for more."""
_COMMAND = "python -m benchmarks --only speech_people"


def run(quick: bool) -> Iterator[list[dict[str, Any]]]:
    """The rows of this benchmark."""
    needs(DATA / "gsc_words", "the single words of the development data")
    engine = IntentEngine.from_files(default_grammar(), locations=default_locations())
    ways = Ways.of(engine)
    trial = Trial(kitchen(), [10.0])
    words = some(read_labels(DATA / "gsc_words" / "labels.jsonl", engine), quick)
    ours, peer = hear("single words", words, trial, (ways.ours, ways.peer))
    rows = []
    for snr, name in ((None, "clean"), (10.0, "kitchen noise at 10 dB")):
        rows += accuracy_rows(f"single words of people, {name}", _COMMAND, ours[snr], peer[snr])
        rows += reflex_rows(name, ours[snr])
    yield rows
    yield clips(engine, ways)


def reflex_rows(name: str, outcomes: list[Outcome]) -> list[dict[str, Any]]:
    """When "stop" held the robot, from the end of its sound; and what else did."""
    stops = [one for one in outcomes if one.row.text == "stop"]
    others = [one for one in outcomes if not one.row.expected.stops]
    rows = []
    if stops:
        # Their hold is told from the runtime's own idea of the end; here it is that of the sound without noise.
        times = [one.held_at - end_of_speech(load(one.row), WORD_FLOOR) for one in stops if one.held_at is not None]
        rows = holds(f'"stop" by people, {name}', _COMMAND, times, len(stops))
    held = sum(one.held_at is not None for one in others)
    figure = f"other words by people, {name}: held for a moment"
    return [*rows, row(figure, _COMMAND, 100 * held / max(len(others), 1), "%", runs=len(others))]


def clips(engine: IntentEngine, ways: Ways) -> list[dict[str, Any]]:
    """A person's command, and an audiobook that must do nothing."""
    rows = read_labels(DATA / "clips" / "labels.jsonl", engine)
    ours, peer = hear("passages", rows, Trial(), (ways.ours, ways.peer))
    wrong = [sum(one.verdict not in (Verdict.RIGHT, Verdict.QUIET) for one in heard[None]) for heard in (ours, peer)]
    figure = "a person's command and five passages of an audiobook: not as they should be"
    return [row(figure, _COMMAND, wrong[0], "", wrong[1], runs=len(rows))]
