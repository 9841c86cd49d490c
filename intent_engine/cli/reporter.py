"""Tells what happens while a robot listens, as it happens: lines for a person, or JSON lines for a program."""

from __future__ import annotations

import contextlib
import functools
import threading
from collections.abc import Callable
from typing import Any

from intent_engine.actions import to_json
from intent_engine.cli.describe import STYLES, action_text, meaning_text, pose_text
from intent_engine.cli.outbox import Outbox
from intent_engine.cli.streams import OutputError
from intent_engine.cli.terminal import json_line, say
from intent_engine.execution.events import Event, EventKind
from intent_engine.execution.goal import Goal, GoalState
from intent_engine.execution.robots.robot import Pose, Robot
from intent_engine.interpretation import Interpretation, Status
from intent_engine.runtime.heard import Heard, HeardKind, Summary
from intent_engine.speech.audio import Report
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import WORTH_ASKING

__all__ = ["Reporter"]

WORTH_TELLING = 3.0
"""nats by which another reading may be less likely and still be told to a person: one in twenty."""

_ENDS = {
    GoalState.SUCCEEDED: ("done", "green"),
    GoalState.CANCELED: ("canceled", "yellow"),
    GoalState.ABORTED: ("aborted", "red"),
    GoalState.REJECTED: ("refused", "red"),
}
_TOLD = {
    HeardKind.HOLD: "hold",
    HeardKind.RELEASE: "release",
    HeardKind.LOST: "lost",
    HeardKind.ERROR: "error",
}


class Reporter:
    """Prints the events of a runtime and of its executor, in the order in which they come. Thread-safe.

    Args:
        robot: is asked for its pose when an action ends.
        as_json: one JSON object a line instead of text.
        outbox: writes it; None: it is written at once, and whoever tells waits until it is read.
    """

    def __init__(self, robot: Robot, *, as_json: bool, outbox: Outbox | None = None) -> None:
        self._robot = robot
        self._json = as_json
        self._outbox = outbox
        self._lock = threading.Lock()
        self.start = 0.0
        """The executor's time at which the sound began, in s."""
        self.failed = 0
        """Goals that the robot could not do."""
        self.error = ""
        """What failed last while listening."""
        self._ended = False

    def mute_stops(self) -> None:
        """From now on a stop of the executor is no news: it is how every session ends."""
        self._ended = True

    # -- what was heard -----------------------------------------------------------------------------------------

    def heard(self, event: Heard) -> None:
        """An event of the runtime."""
        with self._lock:
            if event.kind is HeardKind.ERROR:
                self.error = event.detail
            if self._json:
                self._heard_json(event)
            else:
                self._heard_text(event)

    def _heard_json(self, event: Heard) -> None:
        data: dict[str, Any] = {"event": event.kind.value, "time": round(event.time, 3)}
        if event.kind is HeardKind.SUBMITTED:
            return  # the goals tell of themselves
        if event.transcript is not None and event.kind in (HeardKind.PARTIAL, HeardKind.TRANSCRIPT):
            data["text"] = event.transcript.text
            if event.transcript.free_text not in ("", event.transcript.text):
                data["free_text"] = event.transcript.free_text
            data["decode_seconds"] = round(event.transcript.decode_seconds, 4)
            if event.kind is HeardKind.TRANSCRIPT:
                data["alternatives"] = event.transcript.alternatives_to_json()
        if event.interpretation is not None:
            data["interpretation"] = event.interpretation.to_json()
        if event.speech_ended is not None:
            data["speech_ended"] = round(event.speech_ended, 3)
        if event.goes_on:
            data["goes_on"] = True
        if event.in_turn:
            data["in_turn"] = True
        if event.detail:
            data["detail"] = event.detail
        self._json_line(data)

    def _heard_text(self, event: Heard) -> None:
        if event.kind is HeardKind.INTERPRETATION and event.interpretation is not None:
            # Its text is what was heard after all: other words than the transcript's, where the grammar had steered
            # the recogniser too far from the sound.
            found = event.interpretation
            self._line(event.time, "heard", found.text, "bold")
            done = "goes on" if event.goes_on else "next" if event.in_turn else "understood"
            word = done if found.status is Status.ACCEPTED else found.status.value
            self._line(None, word, _meaning(found), STYLES[found.status])
            if others := _perhaps(found, event.transcript):
                self._line(None, "perhaps", " or ".join(map(repr, others)), "dim")
        elif event.kind in _TOLD:
            self._line(event.time, _TOLD[event.kind], event.detail or "a stop word, perhaps", "yellow")

    def source(self, report: Report) -> None:
        """What a live source of sound tells."""
        with self._lock:
            if self._json:
                data = {"event": "source", "time": round(report.time, 3), "kind": report.kind.value}
                self._json_line(data | {"detail": report.detail})
            else:
                self._line(report.time, "sound", report.detail, "yellow")

    # -- what is done -------------------------------------------------------------------------------------------

    def executed(self, event: Event) -> None:
        """An event of the executor."""
        # The executor logs what a listener raises. A reader that went away, or a full disk, is met by the session's own
        # next line.
        with self._lock, contextlib.suppress(BrokenPipeError, OutputError):
            time = event.time - self.start
            if event.kind is EventKind.GOAL and event.goal is not None and event.state is not None:
                self._goal(time, event, event.goal, event.state)
            elif event.kind in (EventKind.ESTOP, EventKind.ERROR) or (event.kind is EventKind.STOP and not self._ended):
                pose = self._robot.pose()
                if self._json:
                    data: dict[str, Any] = {"event": event.kind.value, "time": round(time, 3)}
                    self._json_line(data | _detail(event) | _pose(pose))
                else:
                    self._line(time, "stopped", event.detail or _where(pose), "red")

    def _goal(self, time: float, event: Event, goal: Goal, state: GoalState) -> None:
        if state in (GoalState.ABORTED, GoalState.REJECTED):
            self.failed += 1
        pose = self._robot.pose() if state.ended else None
        if self._json:
            data = {
                "event": "goal",
                "time": round(time, 3),
                "goal": goal.id,
                "state": state.value,
                "action": to_json(goal.action),
            }
            self._json_line(data | _detail(event) | _pose(pose))
        elif state is GoalState.EXECUTING:
            self._line(time, "doing", action_text(goal.action), "cyan")
        elif state in _ENDS:
            word, style = _ENDS[state]
            why = ": ".join(part for part in (event.reason.value.replace("_", " "), event.detail) if part)
            told = f"{action_text(goal.action)}; " if state is GoalState.REJECTED else ""
            self._line(time, word, f"{told}{why + ', ' if why else ''}{_where(pose)}", style)

    def end(self, summary: Summary, time: float) -> None:
        """The sound has ended and the robot stands still; ``time`` in s on the executor's clock."""
        pose = self._robot.pose()
        with self._lock:
            self._ended = True
            if self._json:
                data = {
                    "event": "end",
                    "time": round(time - self.start, 3),
                    "utterances": summary.utterances,
                    "accepted": summary.accepted,
                    "errors": summary.errors,
                }
                self._json_line(data | _pose(pose))
            else:
                said = f"{summary.utterances} sentence{'s' * (summary.utterances != 1)}, {summary.accepted} understood"
                self._line(None, "end", f"{said}; the robot is {_where(pose)}", "bold")

    def _line(self, time: float | None, word: str, text: str, style: str) -> None:
        when = f"{time:7.2f} s" if time is not None else " " * 9
        self._write(functools.partial(say, f"{when}  {word:<11} {text}".rstrip(), style))

    def _json_line(self, data: dict[str, Any]) -> None:
        self._write(functools.partial(json_line, data))

    def _write(self, write: Callable[[], object]) -> None:
        if self._outbox is None:
            write()
        else:
            self._outbox.put(write)


def _meaning(found: Interpretation) -> str:
    if found.status is Status.ACCEPTED:
        return meaning_text(found.intent, found.slots)
    nearest = f" (nearest: {', '.join(found.alternatives)})" if found.alternatives else ""
    return f"{found.reason or 'not a command'}{nearest}"


def _perhaps(found: Interpretation, heard: Transcript | None) -> list[str]:
    """What was said perhaps, where it is asked back. Of what is no command at all, nothing."""
    if found.status is Status.ACCEPTED or heard is None or heard.sureness < WORTH_ASKING:
        return []
    told = {*found.alternatives, found.text}
    return [
        text
        for text, nats in zip(heard.alternatives, heard.behind, strict=False)
        if nats < WORTH_TELLING and text not in told
    ]


def _where(pose: Pose | None) -> str:
    return f"at {pose_text(pose)}" if pose is not None else "somewhere: this robot cannot tell where it is"


def _pose(pose: Pose | None) -> dict[str, Any]:
    if pose is None:
        return {}
    return {"pose": {"x": round(pose.x, 6), "y": round(pose.y, 6), "yaw": round(pose.yaw, 6), "frame": pose.frame}}


def _detail(event: Event) -> dict[str, Any]:
    data: dict[str, Any] = {}
    if event.reason:
        data["reason"] = event.reason.value
    if event.detail:
        data["detail"] = event.detail
    return data
