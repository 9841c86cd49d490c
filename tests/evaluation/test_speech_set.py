"""The set of synthetic commands: what its sentences mean, and that it comes out the same each time."""

from __future__ import annotations

import importlib.util
import random
import shutil
import sys
from types import ModuleType

import numpy as np
import pytest

from intent_engine.actions import to_json
from intent_engine.engine import IntentEngine
from intent_engine.evaluation.scoring import same
from intent_engine.evaluation.sound import end_of_speech


@pytest.fixture(scope="module")
def script(root) -> ModuleType:
    spec = importlib.util.spec_from_file_location("make_speech_set", root / "scripts" / "make_speech_set.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["make_speech_set"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def engine(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")


def test_three_hundred_commands_and_no_sentence_twice(script, engine):
    plain = script.plain(engine, 240, random.Random(1))
    sampled = script.sampled(engine, 120, 1)
    texts = [sentence["text"] for sentence in plain + sampled]
    assert len(texts) >= 300
    assert len(texts) - len(set(texts)) <= 5  # a sample may happen to be a plain one
    assert {sentence["intent"] for sentence in plain} >= {"stop", "move", "turn", "navigate", "pick", "place"}
    assert script.plain(engine, 240, random.Random(1)) == plain
    assert script.sampled(engine, 120, 1) == sampled


def test_the_engine_understands_a_sample_as_the_sampler_meant_it(script, engine):
    for sentence in script.sampled(engine, 120, 1):
        understood = [to_json(action) for action in engine.parse(sentence["text"]).actions]
        assert len(understood) == len(sentence["actions"]), sentence["text"]
        assert all(map(same, understood, sentence["actions"])), sentence["text"]


def test_talk_is_no_command(script, engine, capsys):
    found = script.others(engine)
    assert len(found) >= 70
    assert all(sentence["intent"] is None for sentence in found)
    assert capsys.readouterr().err == ""


def test_a_recording_has_its_own_level_and_knows_its_end(script):
    tone = np.sin(np.arange(16_000) / 10).astype(np.float32)
    first, end = script.recorded(tone, random.Random(3))
    again, _ = script.recorded(tone, random.Random(3))
    other, _ = script.recorded(tone, random.Random(30))
    assert np.array_equal(first, again)
    assert np.abs(first).max() != pytest.approx(np.abs(other).max(), rel=0.01)
    assert end == pytest.approx(script.LEAD + 1.0, abs=0.011)
    assert np.abs(first).max() <= 1.0


@pytest.mark.skipif(shutil.which("flite") is None, reason="needs flite, a synthesiser")
def test_a_voice_speaks(script):
    voice = next(voice for voice in script.find_voices() if voice.name == "flite-slt")
    slow, fast = voice.say("go forward", 0.9), voice.say("go forward", 1.2)
    assert slow.dtype == np.float32
    assert slow.size > fast.size > 4_000
    assert 0.3 < end_of_speech(slow) < 3.0
