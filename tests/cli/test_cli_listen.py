"""``intent-engine listen``, and ``run -``: sound from pipes and from a microphone, keys, wake word, what goes wrong."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile
import soxr
from typer.testing import CliRunner

from intent_engine.cli import app
from intent_engine.cli.session import Session

ROOT = Path(__file__).resolve().parent.parent.parent
RATE = 16_000
PLAYED = ROOT / "tests" / "speech" / "played_microphone"
NEAR = 0.2
"""m by which a hurried robot goes too far that stands a tenth of a second late, as on a busy machine."""


@pytest.fixture(scope="module")
def go_forward() -> np.ndarray:
    """ "go forward two meters", with next to no quiet around it: some tests wait as long as it takes to say."""
    samples, _ = soundfile.read(
        ROOT / "examples" / "demo.flac", start=int(1.2 * RATE), stop=int(3.4 * RATE), dtype="float32"
    )
    return samples


def raw(samples: np.ndarray) -> bytes:
    return (samples * 32_767).astype("<i2").tobytes()


def events(done: subprocess.CompletedProcess[str]) -> list[dict]:
    return [json.loads(line) for line in done.stdout.splitlines()]


def end_of(done: subprocess.CompletedProcess[str]) -> dict:
    return events(done)[-1]


def wav(samples: np.ndarray, rate: int, folder: Path) -> bytes:
    soundfile.write(folder / "piped.wav", samples, rate, subtype="PCM_24")
    return (folder / "piped.wav").read_bytes()


def test_raw_samples_from_a_pipe(intent_engine, go_forward):
    done = intent_engine("run", "-", "--json", "--no-reflex", stdin=raw(go_forward))
    assert done.returncode == 0, done.stderr
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0)


def test_a_wav_file_from_a_pipe_says_its_own_format(intent_engine, tmp_path, go_forward):
    stereo = np.stack([soxr.resample(go_forward, RATE, 44_100)] * 2, axis=1)
    done = intent_engine("run", "-", "--json", "--no-reflex", stdin=wav(stereo, 44_100, tmp_path))
    assert done.returncode == 0, done.stderr
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0)


def test_listen_to_a_pipe_in_real_time(spoken_to, go_forward, hurried):
    done = spoken_to(go_forward, "--json", "--grammar", hurried)
    assert done.returncode == 0, done.stderr
    assert "listening to standard input" in done.stderr
    states = [event["state"] for event in events(done) if event["event"] == "goal"]
    assert states[-1] == "succeeded"
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0, abs=NEAR)


def test_what_was_said_before_it_listened_is_not_done_and_told(spoken_to, go_forward):
    """While models are loaded; and whoever writes the pipe need not wait until they are."""
    before = go_forward
    assert len(raw(before)) > 1 << 16, "more than a pipe holds"
    done = spoken_to(np.zeros(RATE // 10), "--json", "--no-reflex", before=before)
    assert done.returncode == 0, done.stderr
    told = events(done)
    (early,) = [event for event in told if event["event"] == "source"]
    assert early["kind"] == "early"
    assert early["detail"].startswith(f"{before.size / RATE:.1f} s of sound from standard input came before")
    assert [event["event"] for event in told if event is not early] == ["end"]


@pytest.mark.parametrize("seconds", [pytest.param(0, id="short"), pytest.param(20, id="long", marks=pytest.mark.slow)])
def test_a_recording_that_is_piped_into_it_is_heard(intent_engine, go_forward, hurried, seconds):
    """It ends before anybody listens, or brings more than time has gone by: no microphone does."""
    sound = np.concatenate([np.zeros(seconds * RATE, np.float32), go_forward])
    done = intent_engine("listen", "--pcm", "-", "--json", "--no-reflex", "--grammar", hurried, stdin=raw(sound))
    assert done.returncode == 0, done.stderr
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0, abs=NEAR)
    (ended,) = [event["speech_ended"] for event in events(done) if event["event"] == "transcript"]
    assert seconds + 1.0 < ended < seconds + 3.0, "where it ends in the recording"


def test_a_recording_from_a_pipe_at_its_own_speed(intent_engine, go_forward, hurried):
    options = ("--realtime", "--json", "--no-reflex", "--grammar", hurried)
    done = intent_engine("run", "-", *options, stdin=raw(go_forward))
    assert done.returncode == 0, done.stderr
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0, abs=NEAR)
    (ended,) = [event["speech_ended"] for event in events(done) if event["event"] == "transcript"]
    assert 1.0 < ended < 3.0, "where it ends in the recording"


def driven(lines: Path) -> tuple[float, list[dict]]:
    """How far the written velocities drive, in m, and all that was written."""
    written = [json.loads(line) for line in lines.read_text().splitlines()]
    times = [one["time"] for one in written]
    speeds = [one.get("velocity", {"linear": 0.0})["linear"] for one in written]
    return sum(v * (b - a) for v, a, b in zip(speeds, times, times[1:], strict=False)), written


DRIVING = [
    pytest.param([], id="in a process of its own"),
    pytest.param(["--in-process"], id="in process", marks=pytest.mark.slow),
]


@pytest.mark.parametrize("options", [[], ["--in-process"]], ids=["in a process of its own", "in process"])
def test_listen_drives_another_process(spoken_to, tmp_path, go_forward, hurried, options):
    lines = tmp_path / "commands.jsonl"
    done = spoken_to(go_forward, "--json", "--no-reflex", "--grammar", hurried, "--drive", lines, *options)
    assert done.returncode == 0, done.stderr
    assert [event["state"] for event in events(done) if event["event"] == "goal"][-1] == "succeeded"
    far, written = driven(lines)
    assert far == pytest.approx(2.0, abs=2 * NEAR)
    last = written[-1].get("velocity", {"linear": 0.0, "angular": 0.0})
    assert (last["linear"], last["angular"]) == (0.0, 0.0)


def driving(write: int, options: list[str]) -> subprocess.Popen[bytes]:
    """It listens, and drives by a descriptor, which is closed here."""
    command = [sys.executable, "-m", "intent_engine.cli", "listen", "--pcm", "-", "--json", "--no-reflex", *options]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    process = subprocess.Popen([*command, "--drive", f"/dev/fd/{write}"], cwd=ROOT, pass_fds=(write,), **pipes)
    os.close(write)
    process.stdin.write(bytes(3_200))
    process.stdin.flush()
    assert b"listening to" in process.stderr.readline()
    return process


@pytest.mark.skipif(sys.platform == "win32", reason="descriptors of Unix")
@pytest.mark.parametrize("options", DRIVING)
def test_listening_ends_when_the_robot_goes_away(speak, go_forward, options):
    """While it goes on being spoken to: the standard input stays open."""
    read, write = os.pipe()
    with driving(write, options) as process:
        try:
            speak(process.stdin, go_forward)
            assert os.read(read, 1)
            os.close(read)
            assert process.wait(60) == 6
        finally:
            process.kill()
        told = [json.loads(line) for line in process.stdout.read().splitlines()]
        error = process.stderr.read().decode()
    assert [event["state"] for event in told if event["event"] == "goal"][-1] == "aborted"
    assert [event["event"] for event in told if event["event"] in ("error", "stop", "end")] == []
    assert error.count("error: ") == 1
    assert "the process behind the pipe is gone" in error.split("error: ")[1]
    assert error.count("no stop could be written") <= 1


@pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux lets a program set how much a pipe holds; CI is Linux, and runs it"
)
@pytest.mark.parametrize("options", DRIVING)
def test_listening_ends_when_the_robot_stands_still(speak, go_forward, options):
    """Its pipe stays open, and takes a second of velocities."""
    fcntl = pytest.importorskip("fcntl")
    read, write = os.pipe()
    fcntl.fcntl(write, fcntl.F_SETPIPE_SZ, 4096)
    with driving(write, options) as process:
        try:
            speak(process.stdin, go_forward)
            assert process.wait(60) == 6
        finally:
            process.kill()
        told = [json.loads(line) for line in process.stdout.read().splitlines()]
        error = process.stderr.read().decode()
    os.close(read)
    assert [event["state"] for event in told if event["event"] == "goal"][-1] == "aborted"
    assert [event["event"] for event in told if event["event"] in ("error", "stop", "end")] == []
    assert error.count("error: ") == 1
    assert "the process behind the pipe is there, but does not read" in error.split("error: ")[1]
    assert error.count("no stop could be written") <= 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
@pytest.mark.parametrize("options", DRIVING)
def test_a_robot_that_cannot_be_written_to(spoken_to, go_forward, options):
    done = spoken_to(go_forward, "--json", "--no-reflex", "--drive", "/dev/full", *options)
    assert done.returncode == 6
    assert "error: /dev/full: nothing can be written to the robot" in done.stderr
    assert [event["event"] for event in events(done) if event["event"] in ("error", "stop", "end")] == []


def test_only_a_simulated_robot_is_drawn(intent_engine, tmp_path):
    done = intent_engine("listen", "--drive", str(tmp_path / "out"), "--map")
    assert done.returncode == 2
    assert "--map" in done.stderr


def test_nowhere_to_drive(intent_engine, tmp_path, go_forward):
    done = intent_engine("listen", "--pcm", "-", "--drive", str(tmp_path / "no" / "pipe"), stdin=raw(go_forward))
    assert done.returncode == 2
    assert f"error: --drive: {tmp_path / 'no' / 'pipe'} cannot be written: no such file" in done.stderr
    assert "Traceback" not in done.stderr


def test_with_a_wake_word_other_commands_are_not_meant(intent_engine, go_forward):
    done = intent_engine("run", "-", "--wake-word", "computer", "--no-reflex", stdin=raw(go_forward))
    assert done.returncode == 1
    assert "did not begin with 'computer'" in done.stdout
    assert "doing" not in done.stdout


def test_noise_reduction_as_an_option(intent_engine, go_forward):
    pytest.importorskip("noisereduce", reason="needs the extra intent-engine[noise]")
    done = intent_engine("run", "-", "--denoise", "--json", "--no-reflex", stdin=raw(go_forward))
    assert end_of(done)["pose"]["x"] == pytest.approx(2.0), done.stdout + done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process; CI is Linux, and runs it")
def test_a_microphone_until_ctrl_c(tmp_path, go_forward):
    """A process of its own, in real time: the robot is on its way when Ctrl-C comes."""
    soundfile.write(tmp_path / "said.wav", np.concatenate([np.zeros(RATE * 3 // 5), go_forward]), RATE)
    environment = {**os.environ, "PYTHONPATH": str(PLAYED), "PLAYED": str(tmp_path / "said.wav")}
    command = [sys.executable, "-u", "-m", "intent_engine.cli", "listen", "--json"]
    with subprocess.Popen(
        command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        for line in process.stdout:
            if json.loads(line).get("state") == "executing":
                process.send_signal(signal.SIGINT)
                break
        rest = [json.loads(line) for line in process.stdout]
        error = process.stderr.read()
    assert process.returncode == 130, error
    assert "listening to microphone 'played'; Ctrl-C ends it" in error
    assert "interrupted; the robot is stopped" in error
    assert "Traceback" not in error
    assert [event["state"] for event in rest if event["event"] == "goal"][-1] == "canceled"


def fake(played: str) -> dict[str, str]:
    return {"PYTHONPATH": str(PLAYED), "PLAYED": played}


def test_where_raw_samples_come_from_is_called_as_it_was_given(intent_engine, tmp_path):
    (tmp_path / "to-robot").write_bytes(bytes(3_200))
    done = intent_engine("listen", "--pcm", "to-robot", "--no-reflex", cwd=tmp_path)
    assert "listening to to-robot;" in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process; CI is Linux, and runs it")
def test_a_pipe_that_goes_on_until_ctrl_c(speak, go_forward):
    """The reader of the pipe is still at it when the program ends; that must not abort it."""
    command = [sys.executable, "-m", "intent_engine.cli", "listen", "--pcm", "-", "--no-reflex", "--json"]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    with subprocess.Popen(command, cwd=ROOT, **pipes) as process:
        process.stdin.write(bytes(3_200))
        process.stdin.flush()
        assert b"listening to" in process.stderr.readline()
        speak(process.stdin, go_forward)
        assert process.stdout.readline()
        process.send_signal(signal.SIGINT)
        error = process.stderr.read().decode()
        assert process.wait(60) == 130, error
    assert "the robot is stopped" in error
    assert "Fatal" not in error


def test_microphones_are_listed(intent_engine):
    done = intent_engine("listen", "--list-devices", **fake("zeros"))
    assert done.returncode == 0, done.stderr
    assert "played" in done.stdout
    (one,) = events(intent_engine("listen", "--list-devices", "--json", **fake("zeros")))
    assert one == {
        "index": 0, "name": "played", "channels": 1, "rate": 16_000, "interface": "a file", "default": True,
    }  # fmt: skip


NO_PORTAUDIO = "raise OSError('PortAudio library not found')\n"


@pytest.mark.parametrize("args", [["listen"], ["listen", "--list-devices"]], ids=" ".join)
def test_without_portaudio(intent_engine, tmp_path, args):
    (tmp_path / "sounddevice.py").write_text(NO_PORTAUDIO, "utf-8")
    done = intent_engine(*args, PYTHONPATH=str(tmp_path))
    assert done.returncode == 4
    assert done.stdout == ""
    assert done.stderr.startswith("error: PortAudio is not there, so no microphone can be heard")
    assert "install" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("args", "code", "says"),
    [
        (["listen"], 4, "there is no microphone"),
        (["listen", "--list-devices"], 4, "there is no microphone"),
        (["listen", "--device", "0", "--pcm", "-"], 2, "a microphone and raw samples at once"),
        (["listen", "--pcm", "nowhere.raw"], 3, "nowhere.raw: no such file"),
        (["listen", "--pcm", "-"], 3, "standard input is empty"),
        (["listen", "--pcm", "-", "--format", "mp3"], 2, "--format: mp3 is no format of raw samples\n    there is u8"),
        (["listen", "--pcm", "-", "--rate", "0"], 2, "--rate: 0 Hz is no sample rate of sound\n    give one from"),
        (["listen", "--rate", "0"], 2, "--rate: 0 Hz is no sample rate of sound"),
        (["run", "examples/demo.flac", "--rate", "0"], 2, "--rate: 0 Hz is no sample rate of sound"),
        (
            ["run", "-", "--rate", "8", "--format", "s17", "--channels", "0"],
            2,
            "--rate: 8 Hz is no sample rate of sound\n    give one from 1000 to 768000, such as 16000\n"
            "--format: s17 is no format of raw samples\n    there is u8, s8, s16le, s16be, s24le, s32le, s32be, f32le, "
            "f32be, f64le, f64be\n--channels: 0 channels cannot be\n    give 1 for mono",
        ),
        (["listen", "--rate", "16000"], 2, "--rate, --format and --channels are of raw samples\n    say where"),
        (["listen", "--in-process"], 2, "--in-process without --drive"),
        (["run", "examples/demo.flac", "--live"], 2, "--live needs --realtime\n    give both"),
        (["run", "examples/demo.flac", "--watch"], 2, "--watch needs --realtime\n    give both"),
        (["parse", "stop", "--watch"], 2, "--watch is for sentences from standard input\n    leave it out"),
        (["listen", "--pcm", "-", "--push-to-talk"], 2, "push-to-talk needs a terminal"),
        (["run", "-"], 3, "standard input is empty"),
        (["run", "examples/demo.flac", "--wake-word", "!"], 2, "the wake word has no letters"),
        (
            ["run", "examples/demo.flac", "--wait", "extendible=1"],
            2,
            "--wait: there is no wait 'extendible'\n    did you mean 'extendable'?",
        ),
        (["listen", "--wait", "unknown=never"], 2, "--wait: 'never' is no time to wait"),
        (["evaluate", "shared", "--wait", "other"], 2, "--wait: '' is no time to wait"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_goes_wrong(in_process, args, code, says):
    outside = args[0] == "listen" or "-" in args  # what hears, reads or looks for a terminal
    done = _without_a_terminal(args, fake("none")) if outside else in_process(*args)
    assert done.returncode == code, done.stdout + done.stderr
    assert f"error: {says}" in done.stderr
    assert done.stderr.count("error: ") == 1
    assert "Traceback" not in done.stderr
    assert done.stdout == ""


def _without_a_terminal(args: list[str], environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """A session of its own has no terminal, not even behind /dev/tty."""
    return subprocess.run(
        [sys.executable, "-m", "intent_engine.cli", *args],
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
        start_new_session=True,
        timeout=120,
        check=False,
    )


class Failing:
    """A recogniser that fails, at first or for ever."""

    def __init__(self, real: object, failures: int) -> None:
        self.real, self.failures = real, failures

    def transcribe(self, samples: np.ndarray, *, final: bool = True) -> object:
        if self.failures:
            self.failures -= 1
            raise RuntimeError("out of memory")
        return self.real.transcribe(samples, final=final)

    def close(self) -> None:
        pass


@pytest.mark.parametrize(
    "arguments", [["run", "examples/demo.flac"], ["listen", "--pcm", "{raw}"]], ids=lambda arguments: arguments[0]
)
def test_a_recogniser_that_fails_at_everything(monkeypatch, tmp_path, go_forward, arguments):
    (tmp_path / "x.raw").write_bytes(raw(go_forward))
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr("intent_engine.cli.session.Session._recognizer", lambda _: Failing(None, 1000))
    given = [part.format(raw=tmp_path / "x.raw") for part in arguments]
    done = CliRunner().invoke(app, [*given, "--no-reflex"])
    assert done.exit_code == 5, done.output
    assert "the recogniser failed: RuntimeError: out of memory" in done.stdout
    assert "0 sentences, 0 understood" in done.stdout
    block = done.stderr[done.stderr.index("error: ") :]
    assert block.startswith("error: nothing of what was said could be recognised (")
    assert "the last: the recogniser failed: RuntimeError: out of memory" in block
    assert "intent-engine doctor" in block


def test_a_recogniser_that_fails_now_and_then(monkeypatch):
    whole = Session._recognizer
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr(Session, "_recognizer", lambda session: Failing(whole(session), 1))
    done = CliRunner().invoke(app, ["run", "examples/demo.flac", "--no-reflex", "--second-model", "none"])
    assert done.exit_code == 0, done.output
    assert "the recogniser failed: RuntimeError: out of memory" in done.stdout


def test_what_is_no_raw_sound(intent_engine):
    done = intent_engine("run", "-", stdin=(ROOT / "examples" / "demo.flac").read_bytes())
    assert done.returncode == 3
    assert "standard input is a FLAC file, not raw samples" in done.stderr
