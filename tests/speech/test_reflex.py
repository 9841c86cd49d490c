"""The reflex stop: with the real model, on the demo's voice and, where they are, on people's recordings."""

from __future__ import annotations

import json
from collections.abc import Iterator

import numpy as np
import pytest
import soundfile
from speech_stage import DATA, ROOT, framed

from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.reflex import WhisperReflex, reflex_for
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


def test_silence_and_noise_hold_nothing(reflex) -> None:
    noise = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE).astype(np.float32)
    for sound in (np.zeros(SAMPLE_RATE, np.float32), noise, np.full(SAMPLE_RATE, np.nan, np.float32)):
        reflex.begin([])
        assert not any(reflex.heard(frame.samples) for frame in framed(np.nan_to_num(sound)))
    assert reflex.probability(np.zeros(0, np.float32)) == 0.0


def test_longer_phrases_are_heard_at_their_beginning(reflex) -> None:
    assert ("stop",) in reflex.phrases
    assert not any(words[0] == "stop" and len(words) > 1 for words in reflex.phrases)
    with pytest.raises(ValueError, match="no stop phrase"):
        WhisperReflex([])


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
    class Jumpy:
        def begin(self, frames: object) -> None: ...

        def heard(self, samples: object) -> bool:
            return True

        def close(self) -> None: ...

    other = next(row for row in spoken if not row["action"])
    quiet = np.zeros(SAMPLE_RATE, np.float32)
    listened = listen(np.concatenate([said(demo, spoken[0]), quiet, said(demo, other), quiet]), reflex=Jumpy())
    assert [event.kind for event in listened.events if event.kind in (HeardKind.HOLD, HeardKind.RELEASE)] == [
        *(HeardKind.HOLD, HeardKind.RELEASE),
        *(HeardKind.HOLD, HeardKind.RELEASE),
    ]
    assert listened.moved == pytest.approx(2.0, abs=0.05)


@pytest.mark.data
def test_people_who_say_stop(reflex) -> None:
    labels = DATA / "gsc_words" / "labels.jsonl"
    if not labels.exists():
        pytest.skip("the recordings of ../shared/data are not here")
    rows = [json.loads(line) for line in labels.read_text().splitlines()]
    stops = [row for row in rows if row["label"] == "stop"][:20]
    others = [row for row in rows if row["label"] not in ("stop", "_silence_")][:60:2]
    quiet = np.zeros(int(0.3 * SAMPLE_RATE), np.float32)

    def held(row: dict[str, str]) -> bool:
        samples, _ = soundfile.read(DATA / "gsc_words" / row["audio"], dtype="float32")
        return held_at(reflex, np.concatenate([quiet, samples])) is not None

    assert sum(map(held, stops)) >= 19
    assert sum(map(held, others)) <= 3
