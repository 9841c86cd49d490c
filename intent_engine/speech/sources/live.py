"""What live sources share: a bounded box between the thread that brings sound and the one that takes it.

Life cycle of an :class:`Inbox`: made -> ``put`` from one thread, ``frames`` in another -> ``end`` (what is inside is
still given) or ``close`` (at once; idempotent, from any thread).

Times are those at which sound arrived, not a count of samples: a microphone's clock drifts, sound gets lost, and a
command must not count as stale, or as fresh, because of it.
"""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from intent_engine.execution.clock import Clock, MonotonicClock
from intent_engine.speech.audio import FRAME_SAMPLES, FRAME_SECONDS, Frame, Report, ReportKind, Resampler, clean
from intent_engine.speech.scale import faint

__all__ = ["Inbox", "Reporter"]

_log = logging.getLogger(__name__)

Reporter = Callable[[Report], object]
"""Is told what happened to a source, in the thread that takes its frames."""

CAPACITY = 4.0
"""s of sound that may wait. Longer than any pause of the machine; beyond it what was said is too old to act on."""
STALE = 0.25
"""s by which the count of samples may differ from the clock. Arrivals of a busy machine differ by some 10 ms."""
MUTE_SECONDS = 3.0
"""s of nothing that could be heard, which are no silence: a real microphone always hears its own noise."""
REPORT_EVERY = 5.0
"""s between two reports of lost sound."""
AWAY_STEP = 0.128
"""s between two frames of a source from which no sound comes."""
STAND_IN = 0.25
"""s without sound, beyond the longest block so far, after which silence stands in for it."""
FIRST = 4.0
"""s that a source is given for its first sound: PulseAudio and Bluetooth take more than one."""
TAIL_SECONDS = 0.8
"""s of silence after the last sound, so that the last command is heard to end."""


@dataclass(frozen=True, slots=True)
class _Block:
    samples: npt.NDArray[Any]
    rate: int
    arrived: float
    lost: float
    early: float = 0.0

    @property
    def seconds(self) -> float:
        return len(self.samples) / self.rate


@dataclass(slots=True)
class _Flow:
    """How far frames have been given."""

    last: float = 0.0
    """s since the source began: end of the last of them."""
    lost: float = 0.0
    """s of sound that are missing before the next."""
    away: bool = False
    """Whether no sound came last, and that was told."""
    resampler: Resampler | None = None
    """None: there was no sound yet, or a gap since."""
    rate: int = 0
    """Hz, of what it resamples."""

    def passed(self, frame: Frame) -> Frame:
        """The next frame: never earlier than the one before it, and with what is missing."""
        self.last = max(frame.time, self.last)
        lost, self.lost = self.lost, 0.0
        return replace(frame, time=self.last, lost=lost)

    def silence(self, end: float) -> Iterator[Frame]:
        """Silent frames up to a time."""
        start = self.last
        for count in range(1, round((end - start) / FRAME_SECONDS) + 1):
            self.last = start + count * FRAME_SECONDS
            yield Frame(np.zeros(FRAME_SAMPLES, np.float32), self.last)


class Inbox:
    """Sound from another thread, bounded: where it is not taken, the oldest is dropped and this is told.

    Args:
        name: of the source, for reports.
        patience: s without sound after which the source counts as deaf; None: never, silence stands in.
        capacity: s of sound that may wait.
        on_report: is told what was lost, went away and came back; None: the log is.
        clock: None: the machine's.
    """

    def __init__(
        self,
        name: str,
        *,
        patience: float | None,
        capacity: float = CAPACITY,
        on_report: Reporter | None = None,
        clock: Clock | None = None,
    ) -> None:
        self.name = name
        self.clock: Clock = clock or MonotonicClock()
        self._patience = patience
        self._capacity = capacity
        self._on_report = on_report
        self._changed = threading.Condition()
        self._blocks: deque[_Block] = deque()
        self._waiting = 0.0
        self._ended = False
        self._cut = False
        self._missing = 0.0
        self._closed = False
        self._failed = False
        self._woken = False
        self._listened = False
        self._longest = 0.0
        self._began = self.clock.now()
        self._reported = -REPORT_EVERY
        self._lost = 0.0
        self._inaudible = 0.0
        """s of sound so far of which nothing can be heard; infinite: something could be, or this was told,"""
        self._zeros = True
        """and whether all of it was zeros;"""
        self._opposite = False
        """and whether its channels were each other's opposite."""

    # -- the thread that brings sound ----------------------------------------------------------------

    def put(
        self, samples: npt.NDArray[Any], rate: int, *, lost: float = 0.0, early: float = 0.0, wait: bool = False
    ) -> bool:
        """Bring sound; quick, unless told to wait.

        Args:
            samples: ``(n,)`` or ``(n, channels)``; copied by the caller if it is to change. Where there is none of
                them, no sound has come.
            rate: Hz.
            lost: s of sound known to be missing before it.
            early: s of sound before it that came before anybody listened, and is not heard: missing too.
            wait: wait for room instead of dropping the oldest.

        Returns:
            False when nobody wants it any more.
        """
        block = _Block(samples, rate, self.clock.now(), lost, early)
        with self._changed:
            while wait and self._waiting >= self._capacity and not (self._closed or self._ended):
                self._changed.wait()
            if self._closed or self._ended:
                return False
            if not len(samples):
                return True
            self._blocks.append(block)
            self._waiting += block.seconds
            while self._waiting > self._capacity and len(self._blocks) > 1 and not wait:
                dropped = self._blocks.popleft()
                self._waiting -= dropped.seconds
                next_one = self._blocks[0]
                missing = next_one.lost + dropped.lost + dropped.seconds
                self._blocks[0] = replace(next_one, lost=missing, early=next_one.early + dropped.early)
            self._changed.notify_all()
        return True

    def fail(self) -> None:
        """No more sound comes for now: do not wait for patience to run out."""
        with self._changed:
            self._failed = True
            self._changed.notify_all()

    def wake(self) -> None:
        """Let ``frames`` give one without sound, once what waits is taken. From any thread."""
        with self._changed:
            self._woken = True
            self._changed.notify_all()

    def end(self, *, cut: bool = False, missing: float = 0.0) -> None:
        """No more sound will come; what waits is still given.

        Args:
            cut: it ended in the midst of a sound.
            missing: s of sound that should have come.
        """
        with self._changed:
            if not self._ended:
                self._cut, self._missing = cut, missing
            self._ended = True
            self._changed.notify_all()

    def close(self) -> None:
        """Nobody wants sound any more."""
        with self._changed:
            self._closed = True
            self._blocks.clear()
            self._waiting = 0.0
            self._changed.notify_all()

    @property
    def closed(self) -> bool:
        return self._closed

    # -- the thread that takes frames -----------------------------------------------------------------

    def time(self) -> float:
        """s since the source began."""
        return self.clock.now() - self._began

    def frames(self, reopen: Callable[[], object] | None = None, *, counted: bool = False) -> Iterator[Frame]:
        """Frames as they come, until the end. Asked for again, as by a program that listens once more after an error,
        it gives nothing that has come since: that is too old to act on, and what comes next may be the rest of it.

        Args:
            reopen: called again and again while no sound comes, to bring it back.
            counted: times are counts of samples, as of a recording, and it is waited for sound for ever.
        """
        flow = _Flow()
        self._began = self.clock.now()
        if self._listened and not counted:
            flow.lost = self._pass_over()
        self._listened = True
        while True:
            block = self._take(None if counted else self._limit(flow.away))
            if block is not None:
                yield from self._of_block(block, flow, counted)
            elif self._closed:
                return
            elif self._rouse():
                yield Frame(np.zeros(0, np.float32), flow.last)
            elif self._ended:
                yield from self._of_end(flow)
                return
            elif self._patience is None:
                flow.resampler = None
                yield from flow.silence(max(self.time(), flow.last + FRAME_SECONDS))
            else:
                flow.resampler = None
                yield self._deaf(flow)
                if reopen is not None and not self._closed:
                    reopen()

    def _of_block(self, block: _Block, flow: _Flow, counted: bool) -> Iterator[Frame]:
        """The frames that are whole with a block; what happened to the source is told."""
        if flow.resampler is None or flow.rate != block.rate:
            start = flow.last if counted else self._start(block, flow.last)
            if self._patience is None:
                yield from flow.silence(start)
            flow.resampler, flow.rate = Resampler(block.rate, start), block.rate
        elif not counted:
            self._keep_time(flow.resampler, block)
        flow.lost += block.lost + block.early
        if flow.away:
            flow.away = False
            self._tell(ReportKind.BACK, f"{self.name} is back")
        self._tell_early(block.early)
        self._tell_lost(block.lost)
        self._look_for_mute(block, told_at=np.inf if counted else MUTE_SECONDS)
        for frame in flow.resampler.push(block.samples):
            yield flow.passed(frame)

    def _of_end(self, flow: _Flow) -> Iterator[Frame]:
        """The frames after the last block: what is left of the sound, and silence."""
        if 0.0 < self._inaudible < np.inf and (not self._zeros or self._inaudible >= MUTE_SECONDS):
            self._tell_mute()
        if flow.resampler is None:
            return
        silence = np.zeros(int(TAIL_SECONDS * flow.rate), np.float32)
        cut = self._cut
        flow.lost += self._missing
        for frame in flow.resampler.push(silence, last=True):
            yield replace(flow.passed(frame), cut=cut)
            cut = False

    def _pass_over(self) -> float:
        """Leave what waits. Returns s of sound that are missing before what comes next: at least one frame."""
        with self._changed:
            seconds = sum(block.seconds + block.lost for block in self._blocks)
            self._blocks.clear()
            self._waiting = 0.0
        self._tell_early(seconds)
        return max(seconds, FRAME_SECONDS)

    def _deaf(self, flow: _Flow) -> Frame:
        """A frame in place of the sound that does not come; that it does not is told once."""
        if not flow.away:
            flow.away = True
            self._tell(ReportKind.AWAY, f"no sound comes from {self.name}")
        flow.last = max(flow.last, self.time())
        return Frame(np.zeros(FRAME_SAMPLES, np.float32), flow.last, deaf=True)

    def _limit(self, away: bool) -> float:
        """s to wait for the next block. Who brings a second at a time is not late after half a one."""
        if away:
            return AWAY_STEP
        patience = STAND_IN if self._patience is None else self._patience
        if not self._longest:
            patience = max(patience, FIRST)
        return patience + 1.5 * self._longest

    def _take(self, patience: float | None) -> _Block | None:
        """The next block; None when there is none in time, or no more."""
        with self._changed:
            deadline = None if patience is None else self.clock.now() + patience
            while not (self._blocks or self._closed or self._ended or self._failed or self._woken):
                if self.clock.wait_until(self._changed, deadline):
                    break
            if not self._blocks:
                self._failed = self._failed and self._woken
                return None
            block = self._blocks.popleft()
            self._waiting -= block.seconds
            self._longest = max(self._longest, block.seconds)
            self._changed.notify_all()
            return block

    def _rouse(self) -> bool:
        """Whether somebody woke the source; once."""
        with self._changed:
            woken, self._woken = self._woken, False
        return woken

    def _start(self, block: _Block, last: float) -> float:
        return max(block.arrived - self._began - block.seconds, last)

    def _keep_time(self, resampler: Resampler, block: _Block) -> None:
        late = (block.arrived - self._began) - (resampler.time + block.seconds)
        if abs(late) > STALE:
            resampler.shift(late)

    # -- reports ------------------------------------------------------------------------------------

    def _tell(self, kind: ReportKind, detail: str) -> None:
        if self._on_report is not None:
            self._on_report(Report(kind, self.time(), detail))
        else:
            _log.log(logging.INFO if kind is ReportKind.BACK else logging.WARNING, "%s", detail)

    def _tell_early(self, seconds: float) -> None:
        if seconds:
            self._tell(
                ReportKind.EARLY,
                f"{seconds:.1f} s of sound from {self.name} came before it was listened to and are not "
                "heard; what was being said when listening began is not acted on",
            )

    def _tell_lost(self, seconds: float) -> None:
        """Add to what was lost, and tell it, but not with every block."""
        self._lost += seconds
        if not self._lost or self.time() - self._reported < REPORT_EVERY:
            return
        self._reported = self.time()
        self._tell(
            ReportKind.LOST,
            f"{self._lost:.2f} s of sound from {self.name} were lost: the machine was too busy to take them",
        )
        self._lost = 0.0

    def _look_for_mute(self, block: _Block, told_at: float) -> None:
        """Look whether any sound so far could be heard; tell it after so many s. A recording may begin with silence."""
        if self._inaudible == np.inf or not faint(heard := clean(block.samples)):
            self._inaudible = np.inf
            return
        self._inaudible += block.seconds
        self._zeros = self._zeros and not heard.any()
        self._opposite = self._opposite or (block.samples.ndim > 1 and not faint(np.nan_to_num(block.samples)))
        if self._inaudible >= told_at:
            self._tell_mute()

    def _tell_mute(self) -> None:
        """Tell, once, that nothing can be heard of it."""
        self._inaudible = np.inf
        if self._opposite:
            what = "has channels that cancel each other out, of which the mean is heard: bring one of them alone"
        elif self._zeros:
            what = (
                "gives nothing but zeros: it is muted, or this program may not use it; "
                "intent-engine doctor says what to do"
            )
        else:
            what = (
                "gives next to nothing, less than -96 dB: it is turned down, or its samples are 16-bit integers that "
                "are called 32-bit ones (int32, s32le): say int16, s16le"
            )
        self._tell(ReportKind.MUTE, f"{self.name} {what}")
