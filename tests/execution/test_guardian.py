"""The velocity process, really started, killed and frozen. Times are the drill's and the benchmark's to judge."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import textwrap
import threading
import time
from itertools import pairwise

import pytest
from execution_stage import until

from intent_engine.actions import Move, Turn
from intent_engine.errors import RobotError
from intent_engine.execution.clock import MonotonicClock, VirtualClock
from intent_engine.execution.executor import Executor
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.guardian import Guardian
from intent_engine.execution.limits import Limits
from intent_engine.execution.motion import Motion, Rates
from intent_engine.execution.robots.jsonl import JsonLinesRobot
from intent_engine.execution.robots.simulated import SimulatedRobot

SINK = "intent_engine.execution.robots.jsonl:JsonLinesRobot"
LIMITS = Limits(linear_acceleration=2.0, angular_acceleration=4.0)
LONG = Move(0.5, 50.0, 100.0)


class Wire:
    """What robots in any process wrote, in order; a thread of ours reads it when it comes to it."""

    def __init__(self) -> None:
        read, self.write = os.pipe()
        os.set_inheritable(self.write, True)
        self.lines: list[dict] = []
        self.thread = threading.Thread(target=self.read, args=(read,), daemon=True)
        self.thread.start()

    def read(self, read: int) -> None:
        with os.fdopen(read) as lines:
            self.lines += []
            for line in lines:
                self.lines.append(json.loads(line))

    def velocities(self) -> list[tuple[float, float]]:
        return [(m["velocity"]["linear"], m["velocity"]["angular"]) for m in list(self.lines) if "velocity" in m]

    def moving(self) -> bool:
        return bool(self.velocities()) and any(self.velocities()[-1])

    def stopped(self) -> bool:
        return bool(self.lines) and ("stop" in self.lines[-1] or not any(self.velocities()[-1]))


@pytest.fixture
def wire():
    made = Wire()
    yield made
    os.close(made.write)
    made.thread.join(10.0)


@pytest.fixture
def guarded(wire):
    guardian = Guardian(SINK, {"out": wire.write}, limits=LIMITS, pass_fds=(wire.write,))
    with Executor(JsonLinesRobot(wire.write), LIMITS, loop=guardian, handle_sigterm=False) as executor:
        yield executor


def distance(wire: Wire) -> float:
    points = [(m["time"], m["velocity"]["linear"]) for m in wire.lines if "velocity" in m]
    return sum(v * (later - at) for (at, v), (later, _) in pairwise(points))


def test_it_drives_the_distance_and_ends_in_zeros(guarded, wire):
    goals = guarded.submit([Move(0.5, 0.2, 0.4), Turn(0.3, 1.0, 0.3)])
    assert guarded.wait(goals, 30.0)
    assert [goal.state for goal in goals] == [GoalState.SUCCEEDED] * 2
    assert goals[0].feedback.travelled == pytest.approx(0.2, abs=0.02)
    until(lambda: wire.velocities()[-3:] == [(0.0, 0.0)] * 3)


class Elsewhere(MonotonicClock):
    """A clock that began at another time, as those of other programs did."""

    def now(self) -> float:
        return super().now() + 1e6

    def wait_until(self, condition: threading.Condition, deadline: float | None) -> bool:
        return super().wait_until(condition, None if deadline is None else deadline - 1e6)


def test_the_executors_clock_may_begin_at_another_time(wire):
    guardian = Guardian(SINK, {"out": wire.write}, limits=LIMITS, pass_fds=(wire.write,))
    robot = JsonLinesRobot(wire.write)
    with Executor(robot, LIMITS, Elsewhere(), loop=guardian, handle_sigterm=False) as executor:
        (goal,) = executor.submit(Move(0.5, 0.3, 0.6))
        assert goal.result(30.0).succeeded


def test_hold_pause_and_replacement_keep_the_distance(guarded, wire):
    (goal,) = guarded.submit(Move(0.5, 0.6, 1.2))
    until(wire.moving)
    guarded.hold()
    held = len(wire.velocities())
    until(wire.stopped)
    guarded.release()
    until(lambda: any(any(v) for v in wire.velocities()[held:]))
    guarded.pause()
    until(wire.stopped)
    paused = len(wire.velocities())
    guarded.resume()
    goal.result(30.0)
    until(lambda: any(any(v) for v in wire.velocities()[paused:]) and wire.stopped())
    assert goal.feedback.travelled == pytest.approx(0.6, abs=0.03)
    assert distance(wire) == pytest.approx(0.6, abs=0.06)


@pytest.mark.parametrize(("rest", "go_on"), [("hold", "release"), ("pause", "resume")])
def test_a_motion_that_has_just_ended_is_not_driven_again_after_a_rest(guarded, wire, rest, go_on):
    """The process has ended it, and nobody here has looked at that yet."""
    with guarded._books.lock:
        (goal,) = guarded.submit(Move(0.5, 0.02, 0.04))
        until(lambda: guarded.loop._ended is not None)
        getattr(guarded, rest)()
    until(lambda: goal.done or guarded.loop.written == (0.0, 0.0))
    getattr(guarded, go_on)()
    goal.result(30.0)
    until(lambda: any(any(v) for v in wire.velocities()) and wire.stopped())
    assert goal.feedback.travelled == pytest.approx(0.02, abs=0.005)
    assert distance(wire) == pytest.approx(0.02, abs=0.005)


@pytest.mark.parametrize("order", ["halt", "brake"])
def test_what_a_motion_covered_that_ended_before_an_order_is_the_answer_to_it(wire, order):
    guardian = Guardian(SINK, {"out": wire.write}, limits=LIMITS, pass_fds=(wire.write,))
    heard = threading.Semaphore(0)
    guardian.attach(heard.release, lambda: None)
    guardian.start(Motion(False, 0.5, 0.02, 0.04), time.monotonic())
    assert heard.acquire(timeout=30.0)
    travel = getattr(guardian, order)(time.monotonic())
    assert travel.amount == pytest.approx(0.02, abs=0.005)
    if order == "brake":
        assert heard.acquire(timeout=30.0)
        ended = guardian.step(time.monotonic())
        assert ended is not None
        assert ended.travel.amount == 0.0
    guardian.close()


def test_nothing_follows_a_stop(guarded, wire):
    for _ in range(20):
        (goal,) = guarded.submit(LONG)
        until(wire.moving)
        guarded.stop()
        at = time.monotonic()
        assert goal.reason is Reason.STOP
        time.sleep(0.06)
        late = [m for m in list(wire.lines) if m["time"] > at and any(m.get("velocity", {"linear": 0}).values())]
        assert [m for m in late if m["velocity"]["linear"]] == []


@pytest.mark.parametrize("verbs", [["stop"], ["stop", "stop"], ["hold"]], ids=" ".join)
def test_a_robot_that_hangs_keeps_no_stop_from_the_process(wire, verbs):
    """Who hangs in a call of the robot has the lock, and the gate is none for what another process writes."""
    rates = Rates(valid_for=60.0)  # the watchdog would stop it too, but not before
    guardian = Guardian(SINK, {"out": wire.write}, limits=LIMITS, rates=rates, pass_fds=(wire.write,))
    robot = JsonLinesRobot(wire.write)
    with Executor(robot, LIMITS, loop=guardian, rates=rates, handle_sigterm=False) as executor:
        executor._books.LATER = 0.01
        (goal,) = executor.submit(LONG)
        until(lambda: guardian.travel(0.0).amount > 0.02)
        threads = [threading.Thread(target=getattr(executor, verb)) for verb in verbs]
        with executor._books.lock:
            for thread in threads:
                thread.start()
            until(lambda: wire.velocities()[-3:] == [(0.0, 0.0)] * 3)
        for thread in threads:
            thread.join(30.0)
        covered = executor._conductor._run.feedback(0.0) if verbs == ["hold"] else goal.result(30.0).feedback
        assert covered.travelled == pytest.approx(distance(wire), abs=0.02)


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "frozen"])
def test_a_lost_loop_is_noticed_and_the_robot_stopped_by_its_own_stop(guarded, wire, number):
    (goal,) = guarded.submit(LONG)
    until(wire.moving)
    os.kill(guarded.loop.pid, number)
    goal.result(30.0)
    assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.VELOCITY_LOOP)
    until(lambda: "stop" in wire.lines[-1])
    (refused,) = guarded.submit(LONG)
    assert (refused.state, refused.reason) == (GoalState.REJECTED, Reason.VELOCITY_LOOP)
    guarded.reset()
    (again,) = guarded.submit(Move(0.5, 0.05, 0.1))
    assert again.result(30.0).succeeded


def test_a_process_that_could_not_be_started_again_is_started_by_the_next_reset(guarded, wire, monkeypatch):
    """The machine had no memory or no process left for it, say."""

    def none_left(*arguments, **options):
        raise OSError("no process is left")

    (goal,) = guarded.submit(LONG)
    until(wire.moving)
    os.kill(guarded.loop.pid, signal.SIGKILL)
    goal.result(30.0)
    with monkeypatch.context() as patch:
        patch.setattr(subprocess, "Popen", none_left)
        with pytest.raises(RobotError, match="could not be started: no process is left"):
            guarded.reset()
    (refused,) = guarded.submit(LONG)
    assert (refused.state, refused.reason) == (GoalState.REJECTED, Reason.VELOCITY_LOOP)
    guarded.reset()
    (again,) = guarded.submit(Move(0.5, 0.02, 0.04))
    assert again.result(30.0).succeeded


def test_the_end_of_an_old_process_heard_late_is_not_taken_for_the_end_of_the_new_one(request, wire, monkeypatch):
    launches = 0
    relaunched = threading.Event()

    class HearsTheEndLate(socket.socket):
        def recv(self, size: int) -> bytes:
            try:
                data = super().recv(size)
            except OSError:
                data = b""
            if not data:
                relaunched.wait(10.0)
            return data

    make_pair = socket.socketpair

    def pair() -> tuple[socket.socket, socket.socket]:
        nonlocal launches
        launches += 1
        if launches == 2:
            relaunched.set()
        ours, theirs = make_pair()
        return HearsTheEndLate(fileno=ours.detach()), theirs

    monkeypatch.setattr(socket, "socketpair", pair)
    executor = request.getfixturevalue("guarded")
    (goal,) = executor.submit(LONG)
    until(wire.moving)
    os.kill(executor.loop.pid, signal.SIGSTOP)
    goal.result(30.0)
    executor.reset()
    (again,) = executor.submit(Move(0.5, 0.05, 0.1))
    assert again.result(30.0).succeeded


def test_stopping_a_frozen_loop_kills_it(guarded, wire):
    (goal,) = guarded.submit(LONG)
    until(wire.moving)
    pid = guarded.loop.pid
    os.kill(pid, signal.SIGSTOP)
    guarded.stop()
    assert goal.done
    until(lambda: "stop" in wire.lines[-1])
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTSTP, signal.SIGHUP])
def test_what_a_terminal_sends_does_not_reach_the_loop(guarded, wire, number):
    (goal,) = guarded.submit(Move(0.5, 0.2, 0.4))
    until(wire.moving)
    assert os.getpgid(guarded.loop.pid) != os.getpgid(0)
    os.kill(guarded.loop.pid, number)
    assert goal.result(30.0).succeeded


def test_a_loop_that_is_asked_to_end_ends_in_zeros(guarded, wire):
    (goal,) = guarded.submit(LONG)
    until(wire.moving)
    os.kill(guarded.loop.pid, signal.SIGTERM)
    goal.result(30.0)
    assert (goal.state, goal.reason) == (GoalState.ABORTED, Reason.VELOCITY_LOOP)
    until(lambda: (0.0, 0.0) in wire.velocities())
    until(wire.stopped)


def test_a_loop_that_dies_is_answered_by_the_robots_own_stop_at_once(wire):
    """From the thread that notices, without the executor, which may be held up."""
    guardian = Guardian(SINK, {"out": wire.write}, pass_fds=(wire.write,))
    stopped = threading.Event()
    guardian.attach(lambda: None, stopped.set)
    os.kill(guardian.pid, signal.SIGKILL)
    assert stopped.wait(30.0)
    guardian.close()


def test_two_guardians_do_not_meet(guarded, wire):
    other = Wire()
    guardian = Guardian(SINK, {"out": other.write}, limits=LIMITS, pass_fds=(other.write,))
    with Executor(JsonLinesRobot(other.write), LIMITS, loop=guardian, handle_sigterm=False) as executor:
        guarded.submit(LONG)
        (goal,) = executor.submit(Move(-0.3, 0.1, 0.1 / 0.3))
        until(wire.moving)
        guarded.stop()
        assert goal.result(30.0).succeeded
    assert all(linear <= 0.0 for linear, _ in other.velocities())
    os.close(other.write)


def test_an_interrupted_start_leaves_no_process(wire, monkeypatch):
    started: list[subprocess.Popen] = []
    popen = subprocess.Popen

    def start(*arguments, **options):
        started.append(popen(*arguments, **options))
        return started[-1]

    def interrupted(event, timeout=None):
        raise KeyboardInterrupt

    monkeypatch.setattr(subprocess, "Popen", start)
    # Threads wait for their own start in the same way, so theirs has to go on.
    waits = threading.Event.wait
    monkeypatch.setattr(Guardian, "START_TIMEOUT", -1.0)
    monkeypatch.setattr(threading.Event, "wait", lambda event, t=None: (interrupted if t == -1.0 else waits)(event, t))
    with pytest.raises(KeyboardInterrupt):
        Guardian(SINK, {"out": wire.write}, pass_fds=(wire.write,))
    assert started[0].returncode is not None


def test_a_robot_that_goes_away_from_a_guarded_program_is_told_of_once(tmp_path):
    """Before, program and guardian told each other for ever, and the program could not even be interrupted."""
    program = textwrap.dedent(
        """
        import os
        from intent_engine.actions import Move
        from intent_engine.execution.executor import Executor
        from intent_engine.execution.guardian import Guardian
        from intent_engine.execution.robots.jsonl import JSONL_SINK, JsonLinesRobot

        read, write = os.pipe()
        guardian = Guardian(JSONL_SINK, {"out": write}, pass_fds=(write,))
        with Executor(JsonLinesRobot(write), loop=guardian, on_event=lambda e: print(e.kind, e.reason)) as robot:
            (goal,) = robot.submit(Move(0.5, 50.0, 100.0))
            os.read(read, 1)
            os.close(read)
            goal.result(30)
            robot.submit(Move(0.5, 50.0, 100.0))[0].result(30)
            robot.stop()
        """
    )
    (tmp_path / "program.py").write_text(program)
    with (tmp_path / "out").open("wb") as out, (tmp_path / "err").open("wb") as err:
        process = subprocess.Popen([sys.executable, tmp_path / "program.py"], stdout=out, stderr=err)
        try:
            code = process.wait(60)
        finally:
            process.kill()
            process.wait()
    told = (tmp_path / "out").read_text().splitlines()
    assert code == 0
    assert not [line for line in told if line.startswith("error")]
    assert told.count("goal robot_error") == 2  # each of the two goals
    assert (tmp_path / "err").read_text().count("no stop could be written") == 1


PARENT = textwrap.dedent(
    """
    import ctypes
    import sys
    import time
    from intent_engine.actions import Move
    from intent_engine.execution.executor import Executor
    from intent_engine.execution.guardian import Guardian
    from intent_engine.execution.robots.jsonl import JsonLinesRobot

    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(1, 9)  # PR_SET_PDEATHSIG: no test that is broken off leaves a program behind
    guardian = Guardian({sink!r}, {{"out": {write}}}, pass_fds=({write},))
    executor = Executor(JsonLinesRobot({write}), loop=guardian)
    (goal,) = executor.submit(Move(0.5, 50.0, 100.0))
    print(guardian.pid, flush=True)
    {end}
    """
)


def parent(wire: Wire, end: str = "time.sleep(600)") -> subprocess.Popen:
    code = PARENT.format(sink=SINK, write=wire.write, end=end)
    return subprocess.Popen([sys.executable, "-c", code], pass_fds=(wire.write,), stdout=subprocess.PIPE, text=True)


def ended(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    return False


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT], ids=["KILL", "TERM", "INT"])
def test_a_killed_program_leaves_zeros_and_no_process(wire, number):
    with parent(wire) as process:
        pid = int(process.stdout.readline())
        until(wire.moving)
        process.send_signal(number)
        assert process.wait(30) in (-number, 1, 130)
        until(lambda: ended(pid))
    until(lambda: wire.velocities()[-2:] == [(0.0, 0.0)] * 2)


def test_a_frozen_program_does_not_drive_on_and_hears_of_it_when_it_wakes(wire):
    with parent(wire, "print(goal.result(60).reason, goal.detail, flush=True)") as process:
        process.stdout.readline()
        until(wire.moving)
        process.send_signal(signal.SIGSTOP)
        until(wire.stopped)
        frozen = len(wire.lines)
        time.sleep(0.2)
        assert not [m for m in wire.lines[frozen:] if any(v for v in (m.get("velocity", {}).get("linear"),))]
        process.send_signal(signal.SIGCONT)
        assert process.stdout.readline().startswith("watchdog the program said nothing for")
        process.wait(30)
    assert wire.stopped()


def test_leaving_the_program_leaves_zeros(wire):
    with parent(wire, "time.sleep(0.3)") as process:
        pid = int(process.stdout.readline())
        assert process.wait(30) == 0
        until(lambda: ended(pid))
    until(wire.stopped)


def test_a_sink_that_cannot_be_made_is_told(capfd):
    with pytest.raises(RobotError, match="did not start"):
        Guardian("intent_engine.execution.robots.jsonl:NoSuchRobot")
    assert "NoSuchRobot" in capfd.readouterr().err


def test_a_slow_brake_is_waited_for(wire):
    limits = Limits(linear_acceleration=5.0, linear_deceleration=0.1)
    guardian = Guardian(SINK, {"out": wire.write}, limits=limits, pass_fds=(wire.write,))
    try:
        now = time.monotonic()
        assert guardian.start(Motion(False, 1.0, 1.0, 1.0), now) - now == pytest.approx(4.6, abs=0.1)
        guardian.halt(now)
    finally:
        guardian.close()


def test_a_guardian_has_the_accelerations_of_its_executor(wire):
    """Else it would drive without the ramps that the robot must have."""
    guardian = Guardian(SINK, {"out": wire.write}, pass_fds=(wire.write,))
    with pytest.raises(ValueError, match="other accelerations"):
        Executor(JsonLinesRobot(wire.write), LIMITS, loop=guardian, handle_sigterm=False)
    Executor(JsonLinesRobot(wire.write), Limits(distance=3.0), loop=guardian, handle_sigterm=False).close()


def test_a_guardian_cannot_follow_a_virtual_clock(wire):
    guardian = Guardian(SINK, {"out": wire.write}, pass_fds=(wire.write,))
    with pytest.raises(ValueError, match="virtual clock"):
        Executor(SimulatedRobot(), clock=VirtualClock(), loop=guardian)
    guardian.close()


def test_a_guardian_that_is_closed_is_not_started_again(guarded, wire):
    guardian = guarded.loop
    (goal,) = guarded.submit(LONG)
    until(wire.moving)
    os.kill(guardian.pid, signal.SIGKILL)
    assert goal.result(30.0).reason is Reason.VELOCITY_LOOP
    guarded.close()
    guarded.reset()
    assert guardian._process.poll() is not None
