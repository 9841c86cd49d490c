"""Every type of slot, in every language whose numbers are known: sampled, disturbed and understood."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings

from intent_engine.engine import IntentEngine
from intent_engine.testing import assert_means, moves, sentences

GRAMMAR = """
phrases:
  put: (put|lay) [it] [right]
slots:
  n: {type: number, min: 1, max: 1000}
  pieces: {type: number, min: 1, max: 9, whole: true}
  nth: {type: ordinal}
  length: {type: distance, unit: m}
  span: {type: distance}
  walk: {type: distance, units: {30 cm: [stride, strides], 2 m: "[long] (pole|poles)"}, max: 90 m}
  stack: {type: number, units: {12: (crate|crates)}, whole: true}
  bend: {type: angle, unit: deg}
  heading: {type: angle, unit: deg, max: 360 deg, digits: true}
  channel: {type: number, whole: true, digits: true}
  reach: {type: distance, units: {25 m: (lane|lanes)}, digits: true}
  mass: {type: number, units: {1: (gram|grams), 1000: (kilo|kilos)}, digits: true}
  wait: {type: duration, unit: s, min: 1 s}
  pace: {type: speed}
  spin: {type: angular_speed}
  part: {type: percent, min: 0.01, max: 1.0}
  lamp: {type: boolean}
  tone: {type: choice, fuzzy: false, values: {low: ["(low|deep) [tone]"], high: [high, "very high"]}}
  where: {type: location}
  what: {type: text, max_words: 3}
  who: {type: object, max_words: 1}
  memo: {type: text, dictation: true}
intents:
  measure:
    action: {type: custom, name: measure}
    sentences: ["count {n}", "stack {pieces} high", "choose the {nth} one", "measure {length}", "stretch {span}"]
  count:
    action: {type: custom, name: count}
    sentences: ["walk {walk} [{pace}]", "order {stack}", "steer {heading}", "tune {channel}", "swim {reach} [ahead]",
                "weigh {mass} (now|soon)"]
  adjust:
    action: {type: custom, name: adjust}
    sentences: ["bend {bend}", "linger {wait}", "pace {pace}", "whirl {spin}", "fill {part}", "lamp {lamp}"]
  meet:
    action: {type: custom, name: meet}
    sentences: ["meet {who} at {where}", "describe {what} [to {who}]", "from {where:start} to {where:finish}"]
  remember:
    action: {type: custom, name: remember}
    sentences: ["jot [down] {memo}", "note a memo [that] {memo}", "message {who} saying {memo}"]
  arrange:
    action: {type: custom, name: arrange}
    sentences: ["sing {tone}", "{put} ({n} times;{tone};[at {where}])", "mix {n:first} with {n:second} (now|soon)",
                "range between {n:first} and {n:second} (now|soon)"]
"""
PLACES = {"bay 3": (1.0, 2.0, 0.0), "loading dock": (3.0, 2.0, 0.0), "room 101": (4.0, 0.0, 1.57)}


@cache
def engine_of(language, fillers="fillers: [please, mhm]"):
    with TemporaryDirectory() as folder:
        file = Path(folder) / "every.yaml"
        file.write_text(f"language: {language}\n{fillers}\n{GRAMMAR}", "utf-8")
        return IntentEngine.from_files(file, locations=PLACES)


@pytest.mark.parametrize("noise", [(), ("fillers", "spelling"), ("correction",), ("negation", "fillers")], ids=str)
@pytest.mark.parametrize("language", ["en", "de", "es", "fr", "it"])
def test_a_sentence_means_what_it_was_made_from(language, noise):
    engine = engine_of(language)

    @settings(max_examples=120, deadline=None, derandomize=True)
    @given(sentences(engine, noise=noise))
    def holds(said):
        found = engine.parse(said.text)
        assert_means(found, said.expected)
        assert "negation" not in noise or not moves(found)

    holds()


@pytest.mark.parametrize("noise", ["fillers", ("fillers", "spelling")], ids=str)
def test_the_usual_fillers_change_no_meaning(noise):
    engine = engine_of("en", fillers="")

    @settings(max_examples=300, deadline=None, derandomize=True)
    @given(sentences(engine, noise=noise))
    def holds(case):
        assert_means(engine.parse(case.text), case.expected)

    holds()
