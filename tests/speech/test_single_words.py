"""Single words by many people: they stop, move and turn the simulated robot, and other words do not."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import pytest
import soundfile
from speech_stage import DATA

from intent_engine.actions import Action, Move, Stop, Turn
from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import SAMPLE_RATE

LABELS = DATA / "gsc_words" / "labels.jsonl"
pytestmark = [
    pytest.mark.data,
    pytest.mark.skipif(not LABELS.exists(), reason="the recordings of ../shared/data are not here"),
]
MEANT = {
    "stop": lambda action: isinstance(action, Stop),
    "left": lambda action: isinstance(action, Turn) and action.angle > 0,
    "right": lambda action: isinstance(action, Turn) and action.angle < 0,
    "forward": lambda action: isinstance(action, Move) and action.linear_velocity > 0,
    "backward": lambda action: isinstance(action, Move) and action.linear_velocity < 0,
}


def actions(listen, row: dict[str, str], quiet: float = 0.5) -> list[Action]:
    """What is done of a word with so many s of silence before it."""
    samples, rate = soundfile.read(DATA / "gsc_words" / row["audio"], dtype="float32")
    assert rate == SAMPLE_RATE
    before, after = (np.zeros(int(seconds * SAMPLE_RATE), np.float32) for seconds in (quiet, 0.5))
    heard = listen(np.concatenate([before, samples, after]))
    return [action for event in heard.of(HeardKind.SUBMITTED) for action in event.interpretation.actions]


def some(labels: set[str], most: int) -> list[dict[str, str]]:
    rows = [json.loads(line) for line in LABELS.read_text().splitlines()]
    return [row for row in rows if row["label"] in labels][:: max(1, len(rows) // 200)][:most]


def test_words_stop_move_and_turn_it(listen) -> None:
    heard_well(lambda row: actions(listen, row), 8)


def test_a_recording_may_begin_with_the_word(listen) -> None:
    heard_well(lambda row: actions(listen, row, 0.0), 4)


def heard_well(hear: Callable[[dict[str, str]], list[Action]], people: int) -> None:
    said = [(word, hear(row)) for word in MEANT for row in some({word}, people)]
    right = sum(len(done) == 1 and MEANT[word](done[0]) for word, done in said)
    wrong = [(word, done) for word, done in said if done and not all(map(MEANT[word], done))]
    assert not wrong, "another thing was done"
    assert right >= 0.8 * len(said)


def test_other_words_move_nothing(listen) -> None:
    others = some({"yes", "no", "house", "bird", "happy", "nine", "wow", "zero"}, 12)
    assert sum(bool(actions(listen, row)) for row in others) <= 1
