"""The reflex stop: with the real model, on the demo's voice and, where they are, on people's recordings."""

from __future__ import annotations

import json
from collections.abc import Iterator
from concurrent.futures import Future

import numpy as np
import pytest
import soundfile
from speech_stage import DATA, ROOT, Jumpy, framed

from intent_engine.engine import IntentEngine
from intent_engine.errors import WeightsError
from intent_engine.runtime import HeardKind
from intent_engine.speech.acoustic.moonshine import MoonshineModel
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.models import recognizer_for
from intent_engine.speech.reflex import (
    AGREED,
    EARLY_FRAMES,
    EVERY_FRAMES,
    LATER,
    LATER_FRAMES,
    LOOKS,
    OPEN_QUESTION,
    QUIET,
    THRESHOLD,
    WINDOW_FRAMES,
    WhisperReflex,
    _View,
    _Worker,
    reflex_for,
)
from intent_engine.speech.voice import SileroVoice


@pytest.fixture(scope="module")
def reflex(engine) -> Iterator[WhisperReflex]:
    made = reflex_for(engine, background=False)
    yield made
    made.close()


@pytest.fixture(scope="module")
def spoken() -> list[dict[str, object]]:
    return [json.loads(line) for line in (ROOT / "examples" / "demo.jsonl").read_text().splitlines()]


def held_at(reflex: WhisperReflex, samples: np.ndarray) -> float | None:
    """s at which the reflex hears a stop phrase; the detector opens the utterance, as in a runtime."""
    voice, voiced, before, begun = SileroVoice(), 0, [], False
    for frame in framed(np.concatenate([samples, np.zeros(SAMPLE_RATE // 2, np.float32)])):
        before.append(frame.samples)
        if not begun:
            voiced = voiced + 1 if voice.probability(frame.samples) >= 0.5 else 0
            if voiced == 2:
                reflex.begin(before[-11:-1])
                begun = True
        if begun and reflex.heard(frame.samples):
            return frame.time
    return None


def said(demo: np.ndarray, row: dict[str, object]) -> np.ndarray:
    return demo[int((row["start"] - 0.4) * SAMPLE_RATE) : int((row["end"] + 0.2) * SAMPLE_RATE)]


def test_only_stop_phrases_hold(reflex, demo, spoken) -> None:
    for row in spoken:
        held = held_at(reflex, said(demo, row))
        if row["action"] == "stop":
            assert held is not None, row["text"]
            assert held <= row["end"] - row["start"] + 0.4, "after the words had ended"
        else:
            assert held is None, row["text"]


def test_for_other_languages_it_is_the_model_that_is_there(demo, spoken) -> None:
    """A multilingual model is told the language, and what to do, before the first word."""
    german = IntentEngine.from_files(ROOT / "grammars" / "de.yaml")
    reflex = reflex_for(german, background=False)
    stop = next(row for row in spoken if row["action"] == "stop")
    held = held_at(reflex, said(demo, stop))
    assert held is not None
    assert held <= stop["end"] - stop["start"] + 0.4, "after the word had ended"
    reflex.close()


def test_a_stop_right_after_other_words_holds_as_early(reflex, demo, spoken) -> None:
    go = next(row for row in spoken if row["action"] == "move")
    stop = next(row for row in spoken if row["action"] == "stop")
    begun = demo[int((go["start"] - 0.4) * SAMPLE_RATE) : int(go["end"] * SAMPLE_RATE)]
    word = demo[int(stop["start"] * SAMPLE_RATE) : int((stop["end"] + 0.3) * SAMPLE_RATE)]
    held = held_at(reflex, np.concatenate([begun, word]))
    assert held is not None
    assert held > begun.size / SAMPLE_RATE, "before it was said"
    assert held <= (begun.size + word.size) / SAMPLE_RATE - 0.3 + 0.064, "after the words had ended"


def test_silence_and_noise_hold_nothing(reflex) -> None:
    noise = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
    for sound in (np.zeros(SAMPLE_RATE, np.float32), noise, np.full(SAMPLE_RATE, np.nan, np.float32)):
        reflex.begin([])
        assert not any(reflex.heard(frame.samples) for frame in framed(np.nan_to_num(sound)))
    assert reflex.probability(np.zeros(0, np.float32)) == 0.0


def looked(reflex: WhisperReflex, monkeypatch, found: list[float], sound: list[np.ndarray]) -> list[int]:
    """Frames of an utterance at which the robot is held, if its looks find these probabilities in turn."""
    looks = iter(found)
    monkeypatch.setattr(reflex, "probability", lambda samples: next(looks, 0.0))
    reflex.begin([])
    return [number for number, samples in enumerate(sound) if reflex.heard(samples)]


LOUD = [np.full(512, 0.1, np.float32)] * 60


def test_one_sure_look_or_three_that_agree(reflex, monkeypatch) -> None:
    sure, likely = THRESHOLD * 1.1, THRESHOLD * AGREED * 1.1
    assert looked(reflex, monkeypatch, [0.0, sure], LOUD) == [EVERY_FRAMES]
    assert looked(reflex, monkeypatch, [0.0, likely, likely], LOUD) == []
    assert looked(reflex, monkeypatch, [likely, likely], LOUD) == [], "looks of another utterance do not count"
    assert looked(reflex, monkeypatch, [0.0, likely, likely, likely], LOUD) == [3 * EVERY_FRAMES]


def test_more_is_asked_of_the_middle_of_an_utterance(reflex, monkeypatch) -> None:
    early = EARLY_FRAMES // EVERY_FRAMES
    assert looked(reflex, monkeypatch, [0.0] * early + [THRESHOLD * 1.1], LOUD) == []
    (held,) = looked(reflex, monkeypatch, [0.0] * early + [THRESHOLD * LATER * 1.1], LOUD)
    assert EARLY_FRAMES <= held <= EARLY_FRAMES + LATER_FRAMES


def test_where_nothing_new_is_heard_nothing_is_looked_at(reflex, monkeypatch) -> None:
    counted = []
    monkeypatch.setattr(reflex, "probability", lambda samples: counted.append(samples.size) or 0.0)

    def looks(sound: list[np.ndarray]) -> int:
        counted.clear()
        reflex.begin([])
        assert not any(map(reflex.heard, sound))
        return len(counted)

    quiet = [np.full(512, 0.1 * QUIET / 2, np.float32)] * 8
    assert looks(LOUD[:8] + quiet) < looks(LOUD[:16])
    assert looks(LOUD[:1] + quiet) >= LOOKS, "a word that was over when the detector heard it"
    assert max(counted) <= 512 * WINDOW_FRAMES


class Second:
    """Another model, which finds a stop phrase with this probability."""

    def __init__(self, found: float) -> None:
        self.found = found
        self.asked: list[int] = []

    def probability(self, samples: np.ndarray) -> float:
        self.asked.append(samples.size // 512)
        return self.found


@pytest.mark.parametrize(
    ("first", "second", "held", "asked"),
    [
        (THRESHOLD * 0.6, THRESHOLD * 1.5, [0], [1]),
        (THRESHOLD * 0.6, THRESHOLD * 0.5, [4], [1, 3, 5]),
        (THRESHOLD * 0.6, 0.0, [], [1, 3, 5, 7, 9, 11, 13, 15, 17, 19]),
        (THRESHOLD * OPEN_QUESTION * 0.9, 1.0, [], []),
        (THRESHOLD * 1.1, 0.0, [0], []),
    ],
    ids=["sure", "likely thrice", "another word", "not asked about what is clear", "nor about what is sure"],
)
def test_a_second_model_has_a_say_in_the_first_word(reflex, monkeypatch, first, second, held, asked):
    other = Second(second)
    monkeypatch.setattr(reflex, "_asked_second", lambda: other)
    frames = looked(reflex, monkeypatch, [first] * 10, LOUD)
    assert frames[:1] == held
    assert other.asked[: len(asked)] == asked
    if not held:
        assert other.asked == asked, "of what comes later it is not asked"


def test_a_second_model_is_asked_once_it_is_there(engine, spoken, demo):
    row = next(row for row in spoken if row["action"] == "stop")
    sound = said(demo, row)
    coming: Future[MoonshineModel | None] = Future()
    made = WhisperReflex([("stop",)], second=coming)
    try:
        assert made._asked_second() is None
        coming.set_result(MoonshineModel.load("moonshine-base"))
        second = made._asked_second()
        assert second is made._asked_second()
        assert second.probability(sound) > 0.5
        assert second.probability(np.zeros(SAMPLE_RATE // 2, np.float32)) < THRESHOLD
    finally:
        made.close()


@pytest.mark.parametrize("outcome", ["none", "broken"])
def test_without_a_second_model_it_goes_on_alone(outcome):
    coming: Future[MoonshineModel | None] = Future()
    if outcome == "none":
        coming.set_result(None)
    else:
        coming.set_exception(WeightsError("the weights are damaged"))
    made = WhisperReflex([("stop",)], second=coming, background=False)
    assert made._asked_second() is None
    assert made._asked_second() is None
    made.close()


def test_longer_phrases_are_heard_at_their_beginning(reflex) -> None:
    assert ("stop",) in reflex.phrases
    assert not any(words[0] == "stop" and len(words) > 1 for words in reflex.phrases)
    with pytest.raises(ValueError, match="no stop phrase"):
        WhisperReflex([])


def test_a_look_that_fails_is_told_once_for_an_utterance_and_the_next_is_looked_at(caplog):
    def fails(view) -> bool:
        raise RuntimeError("gone")

    worker = _Worker(fails)
    for _ in range(2):
        worker.reset()
        for _ in range(3):
            assert worker.offer(_View((), True, ()))
            with worker._condition:
                assert worker._condition.wait_for(lambda: not worker._busy, timeout=60.0)
    worker.close()
    assert not worker.found
    assert [record.message for record in caplog.records] == ["the reflex could not look at the sound"] * 2


def test_in_the_background_the_same_is_heard(engine, reflex, demo, spoken) -> None:
    row = next(row for row in spoken if row["action"] == "stop")
    frames = framed(said(demo, row))
    made = reflex_for(engine, background=True)
    try:
        made.begin([frame.samples for frame in frames[:8]])
        found = False
        for frame in frames[8:]:
            found = made.heard(frame.samples) or found
            with made._worker._condition:  # until it has looked: this test has no clock to keep up with
                made._worker._condition.wait_for(lambda: not made._worker._busy, timeout=60.0)
        assert found
        made.begin([])
        assert not made._worker.found
    finally:
        made.close()
        made.close()


def test_a_robot_that_drives_is_held_and_stopped(listen, reflex, demo, spoken) -> None:
    stop = next(row for row in spoken if row["action"] == "stop")
    go = spoken[0]
    quiet = np.zeros(SAMPLE_RATE, np.float32)
    listened = listen(np.concatenate([said(demo, go), quiet, said(demo, stop), quiet]), reflex=reflex)
    held = listened.of(HeardKind.HOLD)
    assert len(held) == 1
    submitted = listened.of(HeardKind.SUBMITTED)
    assert [event.interpretation.intent for event in submitted] == ["move", "stop"]
    assert submitted[1].time > held[0].time
    assert listened.goals[0].state.value == "canceled"
    assert listened.moved < 1.9


def test_a_false_alarm_is_released_and_the_robot_goes_on(listen, demo, spoken) -> None:
    other = next(row for row in spoken if not row["action"])
    quiet = np.zeros(SAMPLE_RATE, np.float32)
    listened = listen(np.concatenate([said(demo, spoken[0]), quiet, said(demo, other), quiet]), reflex=Jumpy())
    assert [event.kind for event in listened.events if event.kind in (HeardKind.HOLD, HeardKind.RELEASE)] == [
        *(HeardKind.HOLD, HeardKind.RELEASE),
        *(HeardKind.HOLD, HeardKind.RELEASE),
    ]
    assert listened.moved == pytest.approx(2.0, abs=0.05)


def kitchen_noise(samples: np.ndarray, snr: float, seed: int) -> np.ndarray:
    """Noise for these samples, by the rule of the data's own README: the loudest 2,048 samples are compared."""
    noise, _ = soundfile.read(DATA / "noise" / "audio" / "doing_the_dishes.flac", dtype="float32")
    start = int(np.random.default_rng(seed).integers(0, noise.size - samples.size))
    noise = noise[start : start + samples.size]

    def loudest(sound: np.ndarray) -> float:
        return float(max(np.square(sound[at : at + 2048]).sum() for at in range(0, sound.size - 2047, 1024)))

    return samples + noise * np.float32(np.sqrt(loudest(samples) / loudest(noise) / 10 ** (snr / 10)))


@pytest.mark.data
@pytest.mark.parametrize(("snr", "most_missed", "most_others"), [(None, 0, 1), (10.0, 1, 2)])
def test_people_who_say_stop(engine, snr, most_missed, most_others) -> None:
    labels = DATA / "gsc_words" / "labels.jsonl"
    if not labels.exists():
        pytest.skip("the recordings of ../shared/data are not here")
    rows = [json.loads(line) for line in labels.read_text().splitlines()]
    stops = [row for row in rows if row["label"] == "stop"][:24]
    others = [row for row in rows if row["label"] not in ("stop", "_silence_")][::15]
    quiet = np.zeros(int(0.5 * SAMPLE_RATE), np.float32)
    recognizer = recognizer_for(engine)
    reflex = reflex_for(engine, background=False, beside=recognizer)

    def held(numbered: tuple[int, dict[str, str]]) -> bool:
        seed, row = numbered
        samples, _ = soundfile.read(DATA / "gsc_words" / row["audio"], dtype="float32")
        samples = np.concatenate([quiet, samples])
        return held_at(reflex, samples if snr is None else kitchen_noise(samples, snr, seed)) is not None

    assert sum(map(held, enumerate(stops))) >= len(stops) - most_missed
    assert sum(map(held, enumerate(others))) <= most_others
    recognizer.close()
    reflex.close()
