"""Sound in its own time, as a microphone brings it, by the machine's clock: what a virtual clock leaves out.

There decodes are left when somebody speaks on, threads wait for each other, and what comes too late is late.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass

from intent_engine.evaluation.hearing import Listener
from intent_engine.execution.clock import MonotonicClock
from intent_engine.runtime.heard import Heard
from intent_engine.speech.audio import FRAME_SAMPLES, SAMPLE_RATE, Samples
from intent_engine.speech.sources.stream import StreamSource

__all__ = ["Played", "play"]


@dataclass(frozen=True)
class Played:
    """What came of a sound."""

    events: tuple[tuple[float, Heard], ...]
    """s since the sound began, by the machine's clock, and what was told then."""
    core_seconds: float
    """Processor time of all threads."""


def play(way: Listener, sound: Samples) -> Played:
    """Push a sound as it would be heard, a frame when it is over."""
    source = StreamSource(SAMPLE_RATE)
    began = time.monotonic()

    def speak() -> None:
        for start in range(0, sound.size, FRAME_SAMPLES):
            block = sound[start : start + FRAME_SAMPLES]
            time.sleep(max(0.0, began + (start + block.size) / SAMPLE_RATE - time.monotonic()))
            source.push(block)
        source.end()

    events: list[tuple[float, Heard]] = []
    used = time.process_time()
    speaker = threading.Thread(target=speak, name="speaker")
    speaker.start()
    way.play(source, MonotonicClock(), lambda event: events.append((time.monotonic() - began, event)))
    speaker.join()
    return Played(tuple(events), time.process_time() - used)
