"""The robot behind a pipe."""

from __future__ import annotations

import contextlib
import json
import os
import threading

import pytest

from intent_engine.actions import Move, Navigate
from intent_engine.errors import RobotError
from intent_engine.execution.clock import VirtualClock
from intent_engine.execution.events import EventKind
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.robots import jsonl
from intent_engine.execution.robots.jsonl import JsonLinesRobot
from intent_engine.execution.robots.robot import Pose, TaskState


@pytest.fixture
def pipe():
    read, write = os.pipe()
    yield read, write
    for end in (read, write):
        try:
            os.close(end)
        except OSError:
            continue


def lines(read: int) -> list[dict]:
    return [json.loads(line) for line in os.read(read, 1 << 20).splitlines()]


def test_velocities_and_the_zeros_that_end_them(pipe):
    read, write = pipe
    with Executor(JsonLinesRobot(write), clock=VirtualClock(), handle_sigterm=False) as executor:
        executor.submit(Move(0.5, 0.1, 0.2))
        executor.run_until_idle()
        written = [line["velocity"] for line in lines(read)]
    assert written[0] == {"linear": 0.5, "angular": 0.0, "valid_for": 0.3}
    assert [line["linear"] for line in written[-3:]] == [0.0] * 3


def test_without_replies_a_task_is_handed_over(pipe):
    read, write = pipe
    with Executor(JsonLinesRobot(write), clock=VirtualClock(), handle_sigterm=False) as executor:
        (goal,) = executor.submit(Navigate("kitchen", 5.0, 2.0, 0.5))
        executor.wait(goal)
    assert goal.state is GoalState.SUCCEEDED
    assert "handed over" in goal.detail
    sent = lines(read)[0]
    assert (sent["task"], sent["navigate"]) == (1, {"x": 5.0, "y": 2.0, "yaw": 0.5, "frame": "map"})


def test_replies_end_tasks_and_tell_the_pose(pipe):
    _, write = pipe
    back_read, back_write = os.pipe()
    with os.fdopen(back_read) as replies, os.fdopen(back_write, "w", buffering=1) as answer:
        robot = JsonLinesRobot(write, replies)
        with Executor(robot, handle_sigterm=False) as executor:
            goals = [executor.submit(Navigate("kitchen", 5.0, 2.0, 0.5))[0]]
            answer.write("nonsense\n" + json.dumps({"pose": {"x": 1, "y": 2, "yaw": 3}}) + "\n")
            answer.write(json.dumps({"task": 1, "state": "failed", "reason": "a closed door"}) + "\n")
            goals[0].result(30)
            assert (goals[0].reason, goals[0].detail) == (Reason.ROBOT_ERROR, "a closed door")
            assert robot.pose().y == 2.0
            task = robot.pick("cup")
            robot.stop()
            assert task.state is TaskState.CANCELED
        answer.close()


def test_a_broken_pipe_aborts_the_goal_and_stop_stays_quiet(pipe):
    read, write = pipe
    os.close(read)
    robot = JsonLinesRobot(write)
    with pytest.raises(RobotError, match="gone"):
        robot.velocity(0.0, 0.0, 0.3)
    with Executor(robot, clock=VirtualClock(), handle_sigterm=False) as executor:
        (goal,) = executor.submit(Move(0.5, 1.0, 2.0))
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        executor.stop()


class Counting(JsonLinesRobot):
    """Remembers what was to be written."""

    def __init__(self, out: int) -> None:
        super().__init__(out)
        self.tried: list[str] = []

    def _write(self, message: dict) -> None:
        self.tried.append(next(iter(message)))
        super()._write(message)


def test_a_reader_that_goes_away_is_told_of_once_and_nothing_more_is_written(pipe, caplog):
    read, write = pipe
    robot, clock, events = Counting(write), VirtualClock(), []
    with Executor(robot, clock=clock, on_event=events.append, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Move(0.5, 50.0, 100.0))
        clock.advance(1.0)
        os.close(read)
        robot.tried.clear()
        clock.advance(10.0)
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        assert robot.tried == ["velocity", "stop", "velocity", "stop"]
        assert executor.run_until_idle()
        executor.stop()
        assert executor.run_until_idle()
    assert not [event for event in events if event.kind is EventKind.ERROR]
    assert "is gone" in robot.lost
    assert not caplog.records  # the goal says it


def test_a_stop_that_finds_nobody_says_so_once(pipe, caplog):
    read, write = pipe
    robot = JsonLinesRobot(write)
    robot.stop()
    assert (robot.lost, caplog.text) == ("", "")
    os.close(read)
    for _ in range(3):
        robot.stop()
    assert caplog.text.count("no stop could be written") == 1


def test_a_robot_that_is_there_again_is_driven_again(tmp_path):
    """A named pipe whose reader was started again."""
    path = tmp_path / "commands"
    os.mkfifo(path)
    first = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    write = os.open(path, os.O_WRONLY)
    robot, clock = JsonLinesRobot(write), VirtualClock()
    with Executor(robot, clock=clock, handle_sigterm=False) as executor:
        os.close(first)
        assert executor.submit(Move(0.5, 0.1, 0.2))[0].result().state is GoalState.ABORTED
        assert robot.lost
        second = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        assert executor.submit(Move(0.5, 0.1, 0.2))[0].result().succeeded
        executor.run_until_idle()
        assert robot.lost == ""
        assert [line["velocity"]["linear"] for line in lines(second)[-3:]] == [0.0] * 3
    os.close(write)
    os.close(second)


def fill(write: int) -> None:
    os.set_blocking(write, False)
    with contextlib.suppress(BlockingIOError):
        while True:
            os.write(write, b" " * 4096)
    os.set_blocking(write, True)


def test_a_reader_that_does_not_read_holds_up_no_stop(pipe, monkeypatch):
    _, write = pipe
    fill(write)
    waited = []

    def select(reading: list, writing: list, other: list, timeout: float) -> tuple:
        waited.append(timeout)
        return select_really(reading, writing, other, timeout)

    select_really = jsonl.select.select
    monkeypatch.setattr(jsonl.select, "select", select)
    robot = JsonLinesRobot(write)
    with pytest.raises(RobotError, match="does not read"):
        robot.velocity(0.5, 0.0, 0.3)
    robot.stop()
    robot.close()
    first, *more = waited
    assert 0 < first <= JsonLinesRobot.PATIENCE
    assert set(more) == {0.0}, "it is known by then"


def test_no_stop_stands_in_the_midst_of_a_line_that_went_out_in_pieces(pipe):
    """It is 4 KiB of which a pipe promises that they are written whole."""
    read, write = pipe
    robot = JsonLinesRobot(write)
    with pytest.raises(RobotError, match="too long"):
        robot.pick("x" * (1 << 20))
    robot.stop()
    assert [next(iter(line)) for line in lines(read)] == ["stop"]


def test_nor_does_one_between_whose_look_and_write_another_filled_the_pipe(pipe, monkeypatch):
    """As a guardian's process may, which writes into the same pipe."""
    _, write = pipe
    fill(write)
    os.set_blocking(write, False)
    monkeypatch.setattr(jsonl.select, "select", lambda reading, writing, other, timeout: ([], writing, []))
    robot = JsonLinesRobot(write)
    robot.stop()
    assert "does not read" in robot.lost


def test_a_reader_that_stands_still_is_lost_and_told_of_once(pipe, caplog):
    read, write = pipe
    robot, clock, events = Counting(write), VirtualClock(), []
    with Executor(robot, clock=clock, on_event=events.append, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Move(0.5, 50.0, 100.0))
        clock.advance(1.0)
        fill(write)
        robot.tried.clear()
        clock.advance(10.0)
        assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.ROBOT_ERROR)
        assert "does not read" in goal.detail
        assert robot.lost == goal.detail
        assert robot.tried == ["velocity", "stop", "velocity", "stop"]
        executor.stop()
        assert not caplog.records
        os.read(read, 1 << 20)
        assert executor.submit(Move(0.5, 0.1, 0.2))[0].result().succeeded, "and it is there again when it reads"
        assert robot.lost == ""
    assert not [event for event in events if event.kind is EventKind.ERROR]


@pytest.fixture
def answering(pipe):
    """A robot, and the end of the pipe into which the other process writes its replies."""
    back_read, back_write = os.pipe()
    with os.fdopen(back_read, encoding="utf-8") as replies, os.fdopen(back_write, "wb", buffering=0) as answer:
        yield JsonLinesRobot(pipe[1], replies), answer
        answer.close()


def ended(task) -> TaskState:
    """How a task ended, when it has."""
    done = threading.Event()
    task.add_done_callback(lambda task: done.set())
    assert done.wait(30.0)
    return task.state


def test_whoever_does_not_answer_any_more_does_no_task(answering):
    robot, answer = answering
    before = robot.navigate(Pose(1.0, 2.0, 0.0))
    answer.close()
    assert ended(before) is TaskState.FAILED
    after = robot.pick("cup")
    assert (ended(after), after.reason) == (TaskState.FAILED, "the other process ended")


def test_replies_that_are_no_text_end_the_tasks_and_are_told_of(answering, caplog):
    robot, answer = answering
    task = robot.navigate(Pose(1.0, 2.0, 0.0))
    answer.write(b"\xff\xfe\n")
    assert ended(task) is TaskState.FAILED
    assert "replies cannot be read" in caplog.text


def test_tasks_that_were_stopped_are_not_kept_and_may_be_answered_late(answering, caplog):
    robot, answer = answering
    for _ in range(3):
        robot.navigate(Pose(1.0, 2.0, 0.0))
        robot.stop()
    assert not robot._tasks
    last = robot.pick("cup")
    answer.write(b'{"task": 1, "state": "canceled"}\n{"task": 4, "state": "succeeded"}\n')
    assert ended(last) is TaskState.SUCCEEDED
    assert not caplog.records
    answer.write(b'{"task": 99, "state": "succeeded"}\n')
    answer.close()
    assert ended(robot.pick("cup")) is TaskState.FAILED
    assert caplog.text.count("cannot be understood") == 1


def test_a_task_that_could_not_be_written_is_not_kept(pipe, answering):
    robot, _ = answering
    os.close(pipe[0])
    with pytest.raises(RobotError):
        robot.navigate(Pose(1.0, 2.0, 0.0))
    assert not robot._tasks
