"""The microphone, through PortAudio: survives being unplugged, and never lets sound pile up.

PortAudio lists devices when it starts and never again, so a microphone that was plugged in later is seen only after it
was started anew. That ends every other stream of the process, and is done only while no sound comes.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from intent_engine.errors import DeviceError
from intent_engine.execution.clock import Clock
from intent_engine.speech.audio import FRAME_SECONDS, SAMPLE_RATE, Frame
from intent_engine.speech.sources.devices import InputDevice, choose, hint_for_permission, portaudio
from intent_engine.speech.sources.live import CAPACITY, Inbox, Reporter

__all__ = ["Microphone"]

BLOCK_SECONDS = 0.032
PATIENCE = 1.0
"""s without sound after which a microphone counts as unplugged. Some take most of a second to begin."""
REOPEN_EVERY = 1.0
"""s between two attempts to open it again."""


class Microphone:
    """Frames of a microphone, as they are heard.

    Life cycle: made (the device is looked up) -> ``frames()`` opens it -> away and back, as often as it is unplugged
    and plugged in again -> ``close()`` (idempotent, from any thread). While it is away its frames are marked as deaf.

    Args:
        device: number, name or part of the name; None: the system's default, also after a replug.
        capacity: s of sound that may wait to be taken; beyond it the oldest is dropped, and this is told.
        on_report: is told of lost sound, and of the microphone's going and coming back.
        clock: None: the machine's.

    Raises:
        DeviceError: there is no PortAudio or no such microphone; says what to do.
    """

    def __init__(
        self,
        device: int | str | None = None,
        *,
        capacity: float = CAPACITY,
        on_report: Reporter | None = None,
        clock: Clock | None = None,
    ) -> None:
        self._sd = portaudio()
        self._wanted = device
        self.device: InputDevice = choose(device)
        """The microphone in use; another after a replug, if the default has changed."""
        self._inbox = Inbox(
            f"microphone {self.device.name!r}", patience=PATIENCE, capacity=capacity, on_report=on_report, clock=clock
        )
        self._stream: Any = None
        self._tried = 0.0

    def frames(self) -> Iterator[Frame]:
        """Open the microphone and listen. Before the first frame sound is missing, as after a gap: what begins with it
        may be the rest of a sentence.

        Raises:
            DeviceError: it cannot be opened; says what to do.
        """
        try:
            self._open()
            first = True
            for frame in self._inbox.frames(self._reopen):
                # Somebody may be speaking already, and "don't" may be what nobody heard.
                missing = FRAME_SECONDS if first and frame.samples.size else 0.0
                yield replace(frame, lost=missing) if missing > frame.lost else frame
                first = first and not frame.samples.size
        finally:
            self._shut()

    def close(self) -> None:
        self._inbox.close()

    def wake(self) -> None:
        self._inbox.wake()

    # -- the stream ---------------------------------------------------------------------------------

    def _open(self) -> None:
        sd = self._sd
        rate, channels = self._settings()

        def heard(data: Any, frames: int, time: Any, status: Any) -> None:
            if self._stream is not stream and self._stream is not None:
                return  # of a stream that was given up
            overflow = bool(status and status.input_overflow)
            # How much PortAudio lost it does not say: at least about a block.
            self._inbox.put(data.copy(), rate, lost=BLOCK_SECONDS if overflow else 0.0)

        def finished() -> None:
            if self._stream is stream:
                self._inbox.fail()

        stream: Any = None
        try:
            stream = sd.InputStream(
                device=self.device.index,
                samplerate=rate,
                channels=channels,
                dtype="float32",
                blocksize=int(rate * BLOCK_SECONDS),
                callback=heard,
                finished_callback=finished,
            )
            stream.start()
        except sd.PortAudioError as error:
            if stream is not None:
                with contextlib.suppress(sd.PortAudioError):
                    stream.close(ignore_errors=True)
            raise DeviceError(
                f"microphone {self.device.name!r} cannot be opened: {error}\n    {hint_for_permission()}"
            ) from None
        self._stream = stream

    def _settings(self) -> tuple[int, int]:
        """A rate and a number of channels that the device takes; 16 kHz mono if it can, which saves the resampling."""
        sd = self._sd
        tried: list[str] = []
        for rate in dict.fromkeys((SAMPLE_RATE, self.device.rate, 48_000, 44_100)):
            for channels in dict.fromkeys((1, min(2, self.device.channels), self.device.channels)):
                try:
                    sd.check_input_settings(
                        device=self.device.index, channels=channels, dtype="float32", samplerate=rate
                    )
                    return rate, channels
                except (sd.PortAudioError, ValueError) as error:
                    tried.append(str(error))
        raise DeviceError(f"microphone {self.device.name!r} cannot be opened: {tried[0]}\n    {hint_for_permission()}")

    def _shut(self) -> None:
        stream, self._stream = self._stream, None
        if stream is not None:
            with contextlib.suppress(Exception):  # a device that is gone may raise anything, and is gone
                stream.abort(ignore_errors=True)
                stream.close(ignore_errors=True)

    def _reopen(self) -> None:
        """Try to hear something again, not too often."""
        now = self._inbox.clock.now()
        if now - self._tried < REOPEN_EVERY:
            return
        self._tried = now
        self._shut()
        with contextlib.suppress(self._sd.PortAudioError):
            self._sd._terminate()
        with contextlib.suppress(self._sd.PortAudioError, DeviceError):
            self._sd._initialize()
            # A number may be another microphone's by now; the name is the same.
            wanted = self.device.name if self._wanted is not None else None
            self.device = choose(wanted)
            self._open()
