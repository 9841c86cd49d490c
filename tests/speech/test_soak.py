"""Hours: of silence, and of commands among talk and noise. Slow, so `make test-slow` runs them."""

from __future__ import annotations

import gc
import resource
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from noises import chords, pink, white
from speech_stage import Frames

from intent_engine import Executor, Runtime, SimulatedRobot
from intent_engine.execution.clock import VirtualClock
from intent_engine.runtime import Heard, HeardKind, Summary
from intent_engine.speech.audio import FRAME_SAMPLES, FRAME_SECONDS, SAMPLE_RATE, Frame

pytestmark = pytest.mark.slow

HOUR = int(3600 / FRAME_SECONDS)
MOST = 8.0
"""MB that memory may grow by in an hour, or the second half of the first. What it holds for an utterance is 1 MB."""


def used() -> float:
    """MB of memory that the process has now."""
    if sys.platform.startswith("linux"):
        return int(Path("/proc/self/statm").read_text("ascii").split()[1]) * resource.getpagesize() / 1e6
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6


def hour_of(sounds: list[np.ndarray], watch: Callable[[float], None]) -> Iterator[Frame]:
    """One sound a minute, by turns, with room noise between them; ``watch`` is called each minute."""
    room = white(60, 0.001).astype(np.float32)
    minute = int(60 / FRAME_SECONDS)
    for count in range(HOUR):
        at = (count % minute) * FRAME_SAMPLES
        block = room[at : at + FRAME_SAMPLES].copy()
        if block.size < FRAME_SAMPLES:
            block = np.zeros(FRAME_SAMPLES, np.float32)
        sound = sounds[(count // minute) % len(sounds)] if sounds else room[:0]
        part = sound[at : at + FRAME_SAMPLES]
        block[: part.size] += part
        if count % minute == 0:
            watch(count * FRAME_SECONDS)
        yield Frame(block, (count + 1) * FRAME_SECONDS)


def play(engine, whisper, sounds: list[np.ndarray]) -> tuple[Summary, list[Heard], list[float], float]:
    """Listen for an hour: what came of it, the memory used each minute, and how far the robot went."""
    clock = VirtualClock()
    robot = SimulatedRobot(clock)
    events: list[Heard] = []
    memory: list[float] = []

    def watch(_: float) -> None:
        gc.collect()
        memory.append(used())

    with Executor(robot, clock=clock) as executor:
        runtime = Runtime(engine, executor, whisper, on_event=events.append, patience=600)
        summary = runtime.run(Frames(hour_of(sounds, watch)))
        executor.wait()
    return summary, events, memory, robot.pose().x


def test_an_hour_of_silence(engine, whisper):
    threads = threading.active_count()
    summary, events, memory, x = play(engine, whisper, [])
    assert summary.seconds == pytest.approx(3600, abs=0.1)
    assert (summary.utterances, summary.errors, events, x) == (0, 0, [], 0.0)
    assert max(memory[30:]) - memory[30] < MOST
    assert threading.active_count() <= threads + 1


def test_an_hour_of_commands_talk_and_noise(engine, whisper, go_forward, demo):
    talk = demo[int(13 * SAMPLE_RATE) : int(19 * SAMPLE_RATE)][::-1].copy()
    sounds = [
        go_forward,
        pink(20, 0.1).astype(np.float32),
        talk,
        chords(20, 0.5).astype(np.float32),
        np.full(5 * SAMPLE_RATE, 0.5, np.float32),
    ]
    play(engine, whisper, sounds)  # the models' own memory grows until everything was heard a few times
    summary, events, memory, x = play(engine, whisper, sounds)
    assert summary.errors == 0
    done = [event for event in events if event.kind is HeardKind.SUBMITTED]
    assert len(done) == 12, "a command every fifth minute, and nothing else"
    assert x == pytest.approx(24.0)
    assert max(memory) - memory[0] < MOST, memory
    threads = [thread.name for thread in threading.enumerate() if thread.name == "recogniser"]
    assert threads == []
