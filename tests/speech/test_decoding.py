"""One decode at a time beside the stream: what it returns, what it raises, and what happens when it does neither."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from intent_engine.speech import decoding
from intent_engine.speech.decoding import DecodeThread
from intent_engine.speech.recognizer import Transcript

SOUND = np.zeros(512, np.float32)


class Waits:
    """Answers when it is let go."""

    def __init__(self) -> None:
        self.go = threading.Event()
        self.heard: list[tuple[int, bool]] = []

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
        self.heard.append((samples.size, final))
        assert self.go.wait(30)
        return Transcript("go")

    def close(self) -> None: ...


@pytest.fixture
def now(monkeypatch):
    """The time, as a list of one number to be changed."""
    time = [100.0]
    monkeypatch.setattr(decoding.time, "monotonic", lambda: time[0])
    return time


def test_what_it_returns():
    waits = Waits()
    waits.go.set()
    decodes = DecodeThread(waits)
    assert decodes.begin(SOUND, final=False).result(timeout=30).text == "go"
    assert waits.heard == [(512, False)]
    assert decodes.free


@pytest.mark.parametrize("error", [RuntimeError("gone"), MemoryError(), SystemExit(2), KeyboardInterrupt()])
def test_what_it_raises_comes_back(error):
    class Raises(Waits):
        def transcribe(self, samples: np.ndarray, *, final: bool = True) -> Transcript:
            raise error

    decodes = DecodeThread(Raises())
    assert decodes.begin(SOUND, final=True).exception(timeout=30) is error
    assert decodes.free


def test_a_system_without_more_threads_is_a_failure_of_the_recogniser(monkeypatch):
    def refused(*args, **kwargs):
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(decoding, "start_beside", refused)
    decodes = DecodeThread(Waits())
    assert "can't start new thread" in str(decodes.begin(SOUND, final=True).exception(timeout=1))
    assert decodes.free


def test_it_counts_as_hung_only_after_its_patience(now):
    waits = Waits()
    decodes = DecodeThread(waits, patience=10.0)
    assert decodes.free
    assert not decodes.hung
    job = decodes.begin(SOUND, final=True)
    assert not decodes.free
    now[0] += 9.9
    assert not decodes.hung
    now[0] += 0.2
    assert decodes.hung
    decodes.give_up()
    assert decodes.free
    assert not decodes.hung
    waits.go.set()
    assert job.result(timeout=30).text == "go", "it may still end, and harms nothing"


def test_it_is_waited_for_no_longer_than_it_may_take(now):
    waits = Waits()
    decodes = DecodeThread(waits, patience=10.0)
    decodes.settle()
    job = decodes.begin(SOUND, final=True)
    now[0] += 10.0
    decodes.settle()
    assert not job.done()
    now[0] -= 10.0
    decodes.settle(0.0)
    assert not job.done()
    waits.go.set()
    decodes.settle()
    assert job.done()
