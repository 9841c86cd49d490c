"""A session on the real clock, with a recogniser that hears nothing: what is told, and in which order."""

from __future__ import annotations

import contextlib
import json
import threading
from collections.abc import Iterator

import numpy as np
import pytest

from intent_engine import IntentEngine
from intent_engine.actions import Custom, Move
from intent_engine.cli.listening_options import Hearing, Telling, session
from intent_engine.cli.reporter import Reporter
from intent_engine.cli.session import Session
from intent_engine.errors import ConfigError
from intent_engine.evaluation.sound import SamplesSource
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.execution.events import Event
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.journal import Journal
from intent_engine.execution.robots.robot_file import load_robot
from intent_engine.resources import default_grammar, default_robot
from intent_engine.runtime.runtime import Runtime


class Deaf:
    """A recogniser to which nobody speaks."""

    def close(self) -> None:
        pass


@pytest.mark.parametrize("stopped", [False, True])
def test_the_end_is_told_after_what_was_done(monkeypatch, capsys, stopped):
    """However late the listener's thread comes to its turn."""
    waited, tell = threading.Event(), Reporter.executed

    def late(reporter: Reporter, event: Event) -> None:
        if event.state is GoalState.SUCCEEDED or event.kind == "stop":
            waited.wait(30.0)
        tell(reporter, event)

    settle = Executor.settle

    def settled(executor: Executor, timeout: float = 1.0) -> bool:
        waited.set()
        return settle(executor, 30.0)

    @contextlib.contextmanager
    def controls(_: object, executor: Executor) -> Iterator[None]:
        executor.submit(Move(0.5, 0.01, 0.02))
        executor.wait()
        if stopped:
            executor.stop()
        yield

    monkeypatch.setattr(Reporter, "executed", late)
    monkeypatch.setattr(Executor, "settle", settled)
    monkeypatch.setattr(Session, "_recognizer", lambda self: Deaf())
    engine = IntentEngine.from_files(default_grammar())
    robot = load_robot(default_robot())
    session = Session(engine, robot, MonotonicClock(), reflex=False, as_json=True, controls=controls)
    session.play(SamplesSource(np.zeros(1_600, np.float32)))
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert told[-1]["event"] == "end"
    assert "succeeded" in [one.get("state") for one in told]
    assert [one["event"] for one in told].count("stop") == stopped


def _with_a_wave(monkeypatch, **options):
    """A session in which the robot is told to wave and then to drive."""

    @contextlib.contextmanager
    def controls(_: object, executor: Executor) -> Iterator[None]:
        executor.submit([Custom("wave", {"person": "camera"}), Move(0.5, 1.0, 2.0)])
        executor.wait()
        yield

    monkeypatch.setattr(Session, "_recognizer", lambda self: Deaf())
    engine, robot = IntentEngine.from_files(default_grammar()), load_robot(default_robot())
    session = Session(engine, robot, reflex=False, controls=controls, **options)
    return session.play(SamplesSource(np.zeros(1_600, np.float32)))


def test_an_action_of_ones_own_is_shown_and_what_follows_is_done(monkeypatch, capsys):
    ended = _with_a_wave(monkeypatch, clock=VirtualClock())
    assert ended.failed == 0
    assert [line.split("s  ", 1)[-1].strip() for line in capsys.readouterr().out.splitlines()[:4]] == [
        "doing       wave person=camera",
        "done        no handler in this program: shown only, at x 0.00 m, y 0.00 m, facing 0°",
        "doing       move forward 1.00 m at +0.50 m/s for 2.00 s",
        "done        at x 1.00 m, y 0.00 m, facing 0°",
    ]


def test_that_an_action_was_shown_only_is_in_the_json(monkeypatch, capsys):
    _with_a_wave(monkeypatch, clock=VirtualClock(), as_json=True)
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    waved, moved = (one for one in told if one.get("state") == "succeeded")
    assert waved["action"] == {"type": "custom", "name": "wave", "slots": {"person": "camera"}}
    assert waved["detail"] == "no handler in this program: shown only"
    assert "detail" not in moved


def test_a_robot_that_is_driven_does_not_go_on_from_what_it_did_not_do(monkeypatch, capsys, tmp_path):
    ended = _with_a_wave(monkeypatch, clock=MonotonicClock(), drive=tmp_path / "out", in_process=True, as_json=True)
    assert ended.failed
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert "executing" not in [one.get("state") for one in told]
    assert "no_handler" in [one.get("reason") for one in told]


@pytest.mark.parametrize("as_json", [False, True])
def test_a_doubtful_grammar_that_is_listened_to_is_told_of_once(capsys, tmp_path, as_json):
    path = tmp_path / "g.yaml"
    path.write_text("slots: {a: {values: [red, blue]}}\nintents: {wave: {action: custom, sentences: [wave]}}\n")
    session(Hearing(grammar=[str(path)]), Telling(as_json=as_json), VirtualClock())
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err == f"1 warning in grammar {path}: intent-engine check {path} shows it\n"
    session(Hearing(), Telling(as_json=as_json), VirtualClock())
    assert capsys.readouterr().err == ""


def test_the_journal_is_closed_with_the_session(monkeypatch, tmp_path):
    closed: list[Journal] = []
    monkeypatch.setattr(Journal, "close", lambda self: closed.append(self))
    _with_a_wave(monkeypatch, clock=VirtualClock(), journal=tmp_path / "journal.jsonl", as_json=True)
    assert [one.path.name for one in closed] == ["journal.jsonl"]


def test_a_session_that_cannot_begin_leaves_no_process_behind(monkeypatch, tmp_path):
    """The process that writes velocities has been started when the journal is found to be no file."""
    (tmp_path / "file").write_text("")
    made: list[Guardian] = []
    launch = Guardian._launch
    monkeypatch.setattr(Guardian, "_launch", lambda self: (made.append(self), launch(self))[1])
    with pytest.raises(ConfigError, match="the journal cannot be written"):
        _with_a_wave(monkeypatch, clock=MonotonicClock(), drive=tmp_path / "out", journal=tmp_path / "file" / "journal")
    (guardian,) = made
    assert guardian._process.poll() is not None


def test_nothing_is_said_of_what_was_heard_after_the_reader_had_gone(monkeypatch):
    """A session that ends since nobody reads has not heard all of it: "nobody speaks in it" would be false."""
    ended, asked = threading.Event(), []
    close = Runtime.close

    def closed(runtime: Runtime) -> None:
        close(runtime)
        ended.set()

    def gone(*_: object) -> None:
        raise BrokenPipeError

    @contextlib.contextmanager
    def controls(_: object, executor: Executor) -> Iterator[None]:
        executor.submit(Move(0.5, 0.01, 0.02))
        ended.wait(30.0)
        yield

    monkeypatch.setattr(Runtime, "close", closed)
    monkeypatch.setattr(Reporter, "_line", lambda reporter, *_: reporter._write(gone))
    monkeypatch.setattr(Session, "_recognizer", lambda self: Deaf())
    engine, robot = IntentEngine.from_files(default_grammar()), load_robot(default_robot())
    session = Session(engine, robot, MonotonicClock(), reflex=False, controls=controls)
    with pytest.raises(BrokenPipeError):
        session.play(SamplesSource(np.zeros(1_600, np.float32)), check=asked.append)
    assert asked == []
