"""Sound that wants to do harm, through the whole engine: nothing is done, and the next command is heard."""

from __future__ import annotations

import threading

import numpy as np
import pytest
import soundfile
from noises import beat, chords, clicks, pink, sweep, white
from speech_stage import DATA, framed

from intent_engine import Status
from intent_engine.runtime import HeardKind
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Frame
from intent_engine.speech.sources.stream import StreamSource

QUIET = np.zeros(SAMPLE_RATE, np.float32)
HOSTILE = {
    "no samples": np.zeros(0),
    "one sample": np.ones(1),
    "silence": np.zeros(20 * SAMPLE_RATE),
    "not numbers": np.full(3 * SAMPLE_RATE, np.nan),
    "infinite": np.where(np.arange(3 * SAMPLE_RATE) % 2, np.inf, -np.inf),
    "huge": white(3, 1e30),
    "full scale at half the rate": np.where(np.arange(3 * SAMPLE_RATE) % 2, 1.0, -1.0),
    "direct current": np.full(5 * SAMPLE_RATE, 0.9),
    "denormal": np.full(3 * SAMPLE_RATE, 1e-42),
    "white noise, soft": white(6, 0.01),
    "white noise, loud": white(6, 0.4),
    "pink noise": pink(8, 0.2),
    "chords": chords(8, 0.6),
    "drums": beat(8, 0.8),
    "siren": sweep(6, 0.5),
    "clicks": clicks(6, 0.9),
    "random bits": np.random.default_rng(5).integers(-32_768, 32_768, 4 * SAMPLE_RATE) / 32_768,
}


def gated(noise: np.ndarray) -> np.ndarray:
    """In the rhythm of syllables, four a second, with pauses: what a detector of voices may take for one."""
    moments = np.arange(noise.size) / SAMPLE_RATE
    return noise * (np.sin(2 * np.pi * 4 * moments) > 0) * (moments % 2 < 1.2)


HOSTILE["noise that talks"] = gated(pink(8, 0.3))
HOSTILE["chords that talk"] = gated(chords(8, 0.7))


@pytest.mark.parametrize("name", HOSTILE)
def test_nothing_is_done_and_the_next_command_is_heard(listen, go_forward, name):
    sound = HOSTILE[name].astype(np.float64)
    found = listen(streamed(sound, QUIET, go_forward))
    before = sound.size / SAMPLE_RATE
    assert [event for event in found.of(HeardKind.SUBMITTED) if event.time < before + 1.0] == []
    assert found.of(HeardKind.ERROR) == []
    assert len(found.goals) == 1, found.texts
    assert found.robot.pose().x == pytest.approx(2.0)


def streamed(*blocks: np.ndarray, rate: int = SAMPLE_RATE) -> StreamSource:
    """A recording that a program pushes from its own thread."""
    source = StreamSource(rate, live=False)

    def push() -> None:
        for block in blocks:
            source.push(block)
        source.end()

    threading.Thread(target=push, daemon=True).start()
    return source


@pytest.mark.parametrize("gain", [20.0, 1_000.0])
def test_a_clipped_command_is_that_command_or_none(listen, go_forward, gain):
    found = listen(streamed(np.clip(gain * go_forward, -1.0, 1.0)))
    assert found.of(HeardKind.ERROR) == []
    assert all(goal.action.distance == 2.0 for goal in found.goals), found.texts


@pytest.mark.parametrize("offset", [0.3, -0.8])
def test_a_command_on_top_of_direct_current(listen, go_forward, offset):
    found = listen(streamed(0.5 * go_forward + offset))
    assert found.of(HeardKind.ERROR) == []
    assert all(goal.action.distance == 2.0 for goal in found.goals), found.texts


@pytest.mark.parametrize("rate", [8_000, 11_025, 22_050, 44_100, 96_000])
def test_a_command_at_any_rate(listen, go_forward, rate):
    import soxr

    found = listen(streamed(soxr.resample(go_forward, SAMPLE_RATE, rate), rate=rate))
    assert found.robot.pose().x == pytest.approx(2.0), found.texts


@pytest.mark.parametrize(
    ("begin", "end"), [(13.0, 19.0), pytest.param(0.0, 60.0, marks=pytest.mark.slow)], ids=["6 s", "a minute"]
)
def test_speech_backwards_is_no_command(listen, demo, begin, end):
    found = listen(streamed(demo[int(begin * SAMPLE_RATE) : int(end * SAMPLE_RATE)][::-1]))
    assert found.summary.utterances > 0, "somebody seems to speak"
    assert found.goals == [], found.texts


def test_a_frame_from_a_source_that_does_not_clean(listen, go_forward):
    """A source of one's own may give anything; frames are checked where they are heard."""
    broken = [Frame(np.full(512, np.nan, np.float32), FRAME_SECONDS * (n + 1)) for n in range(30)]
    found = listen([*broken, *framed(go_forward)])
    assert found.of(HeardKind.ERROR) == []
    assert found.robot.pose().x == pytest.approx(2.0)


AUSTEN = sorted((DATA / "clips" / "audio").glob("*austen*.flac"))


@pytest.mark.data
@pytest.mark.skipif(not AUSTEN, reason="needs the recordings of shared/data, which are not part of the repository")
@pytest.mark.parametrize("clips", [1, pytest.param(5, marks=pytest.mark.slow)])
def test_a_novel_that_is_read_aloud_is_no_command(listen, clips):
    sound = [soundfile.read(path, dtype="float32")[0] for path in AUSTEN[:clips]]
    found = listen(streamed(*(part for clip in sound for part in (clip, QUIET))))
    assert found.summary.utterances >= clips
    assert found.goals == [], found.texts
    assert not [e for e in found.of(HeardKind.INTERPRETATION) if e.interpretation.status is Status.ACCEPTED]
