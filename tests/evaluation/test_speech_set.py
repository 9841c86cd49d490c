"""The set of synthetic commands: what its sentences mean, and that it comes out the same each time."""

from __future__ import annotations

import json
import random
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from intent_engine.actions import to_json
from intent_engine.evaluation.label_files import read_labels
from intent_engine.evaluation.sameness import same
from intent_engine.evaluation.sound import end_of_speech

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from make_speech_set import LEAD, recorded
from speech_sentences import others, plain, sampled
from synthetic_voices import find_voices


def test_three_hundred_commands_and_no_sentence_twice(engine):
    usual, odd = plain(engine, 240, random.Random(1)), sampled(engine, 120, 1)
    texts = [sentence["text"] for sentence in usual + odd]
    assert len(texts) >= 300
    assert len(texts) - len(set(texts)) <= 5  # a sample may happen to be a plain one
    assert {sentence.get("intent") for sentence in usual} >= {"stop", "move", "turn", "navigate", "pick", "place"}
    assert plain(engine, 240, random.Random(1)) == usual
    assert sampled(engine, 120, 1) == odd


def test_the_engine_understands_a_sample_as_the_sampler_meant_it(engine):
    for sentence in sampled(engine, 120, 1):
        understood = [to_json(action) for action in engine.parse(sentence["text"]).actions]
        assert len(understood) == len(sentence["actions"]), sentence["text"]
        assert all(map(same, understood, sentence["actions"])), sentence["text"]


def test_its_labels_are_such_as_are_read(engine, tmp_path):
    sentences = [*plain(engine, 240, random.Random(1)), *sampled(engine, 120, 1), *others(engine)]
    lines = [json.dumps({"audio": "one.flac", **sentence}) for sentence in sentences]
    soundfile.write(tmp_path / "one.flac", np.zeros(1600, np.float32), 16_000)
    (tmp_path / "labels.jsonl").write_text("\n".join(lines), "utf-8")
    rows = read_labels(tmp_path / "labels.jsonl", engine)
    assert len(rows) == len(sentences)
    for row, sentence in zip(rows, sentences, strict=True):
        assert bool(row.expected.actions) == bool(sentence.get("actions")), row


def test_talk_is_no_command(engine, capsys):
    found = others(engine)
    assert len(found) >= 70
    assert all(sentence["intent"] is None for sentence in found)
    assert capsys.readouterr().err == ""


def test_a_recording_has_its_own_level_and_knows_its_end():
    tone = np.sin(np.arange(16_000) / 10).astype(np.float32)
    first, end = recorded(tone, random.Random(3))
    again, _ = recorded(tone, random.Random(3))
    other, _ = recorded(tone, random.Random(30))
    assert np.array_equal(first, again)
    assert np.abs(first).max() != pytest.approx(np.abs(other).max(), rel=0.01)
    assert end == pytest.approx(LEAD + 1.0, abs=0.011)
    assert np.abs(first).max() <= 1.0


@pytest.mark.skipif(shutil.which("flite") is None, reason="needs flite, a synthesiser")
def test_a_voice_speaks():
    voice = next(voice for voice in find_voices() if voice.name == "flite-slt")
    slow, fast = voice.say("go forward", 0.9), voice.say("go forward", 1.2)
    assert slow.dtype == np.float32
    assert slow.size > fast.size > 4_000
    assert 0.3 < end_of_speech(slow) < 3.0
