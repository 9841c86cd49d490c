"""German: commands and talk by synthetic voices, heard by the model that knows the language."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from benchmarks.recordings import Ways, accuracy_rows, hear, some, speech_set
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.trial import Trial
from intent_engine.resources import default_grammar, find

_COMMAND = "python -m benchmarks --only speech_german"
VOICES = {"pico": "a voice of recordings (SVOX Pico)", "espeak": "formant synthesis (eSpeak NG)"}


def run(quick: bool) -> Iterator[list[dict[str, Any]]]:
    """The rows of this benchmark."""
    engine = IntentEngine.from_files(default_grammar("de"), locations=find("locations", "zuhause"))
    labels = speech_set(language="de")
    voices = {
        str(label["id"]): str(label["voice"]) for label in map(json.loads, labels.read_text("utf-8").splitlines())
    }
    ways = Ways.of(engine)
    ours, peer = hear("German", some(read_labels(labels, engine), quick), Trial(), (ways.ours, ways.peer))
    for prefix, name in VOICES.items():
        pair = [[one for one in heard[None] if voices[one.row.id].startswith(prefix)] for heard in (ours, peer)]
        if pair[0]:
            yield accuracy_rows(f"German, {name}, clean", _COMMAND, *pair)
