"""What people get wrong: one clear error on standard error, an exit code that says which kind, and no robot moves."""

from __future__ import annotations

import os
import random
import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import soundfile

RATE = 16_000
ROOT = Path(__file__).resolve().parent.parent.parent
SMALL = "examples/custom_command.yaml"
"""A grammar that is checked in a moment."""


def _speech(seconds: float) -> np.ndarray:
    samples, _ = soundfile.read(ROOT / "examples" / "demo.flac", stop=int(seconds * RATE), dtype="float32")
    return samples


def _half(path: Path) -> Path:
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    return path


def _write(name: str, samples: np.ndarray, **how: str) -> Callable[[Path], Path]:
    def make(folder: Path) -> Path:
        soundfile.write(folder / name, samples, RATE, **how)
        return folder / name

    return make


def _bytes(name: str, data: bytes) -> Callable[[Path], Path]:
    def make(folder: Path) -> Path:
        (folder / name).write_bytes(data)
        return folder / name

    return make


def _eight_hours(folder: Path) -> Path:
    size = 8 * 3600 * RATE * 2
    head = b"RIFF" + struct.pack("<I", 36 + size) + b"WAVE"
    head += b"fmt " + struct.pack("<IHHIIHH", 16, 1, 1, RATE, 2 * RATE, 2, 16) + b"data" + struct.pack("<I", size)
    path = folder / "long.wav"
    with path.open("wb") as file:
        file.write(head)
        file.truncate(len(head) + size)  # sparse: it takes no room
    return path


RECORDINGS = {
    "missing": (lambda folder: folder / "missing.wav", "no such file"),
    "folder": (lambda folder: folder, "is a folder"),
    "empty": (_bytes("empty.wav", b""), "is empty (0 bytes)"),
    "header only": (_write("none.wav", np.zeros(0)), "holds no sound"),
    "half a header": (_bytes("head.wav", b"RIFF\x24\x00\x00\x00WAVEfmt "), "no sound file"),
    "truncated wav": (lambda folder: _half(_write("cut.wav", _speech(8))(folder)), "is cut off: 50%"),
    "truncated flac": (
        lambda folder: _half(_write("cut.flac", _speech(8))(folder)),
        "be read beyond about 2 s\n    copy",
    ),
    "truncated vorbis": (
        lambda folder: _half(_write("cut.ogg", _speech(8))(folder)),
        "is cut off: the end of its sound",
    ),
    "truncated opus": (
        lambda folder: _half(_write("cut.ogg", _speech(8), subtype="OPUS")(folder)),
        "is cut off: the end of its sound is not there\n    copy",
    ),
    "truncated mp3": (
        lambda folder: _half(_write("cut.mp3", _speech(8))(folder)),
        "is cut off: 50% of it is there\n    copy or record it again",
    ),
    "beginning of a flac": (
        _bytes("head.flac", b"fLaC" + bytes(30)),
        "begins as FLAC does, but cannot be read: it is cut",
    ),
    "silent": (_write("silent.wav", np.zeros(3 * RATE)), "nobody speaks in it (3.0 s)"),
    "not a number": (_write("nan.wav", np.full(2 * RATE, np.nan), subtype="FLOAT"), "nobody speaks in it (2.0 s)"),
    "text": (_bytes("notes.wav", b"go forward two meters\n" * 50), "no sound file"),
    "picture": (_bytes("noise.flac", b"\x89PNG" + random.Random(1).randbytes(5000)), "no sound file"),
    "eight hours": (_eight_hours, "lasts 8.0 hours"),
}


@pytest.mark.parametrize("case", RECORDINGS)
def test_recordings(in_process, tmp_path, case):
    make, says = RECORDINGS[case]
    done = in_process("run", make(tmp_path), cwd=ROOT)
    _one_error(done, 3, says)


GRAMMARS = {
    "missing": (None, "nowhere.yaml"),
    "empty": ("", "empty"),
    "not YAML": ("intents: [unclosed", "broken.yaml:"),
    "tabs": ("intents:\n\tmove: {}\n", "broken.yaml:2"),
    "binary": (b"\x00\xff\xfe\x80" * 100, "broken.yaml"),
    "not a mapping": ("- just\n- a list\n", "broken.yaml"),
    "unknown key": ("language: en\nintent:\n  go: {sentences: [go]}\n", "did you mean"),
    "unknown slot": ("language: en\nintents:\n  go: {action: stop, sentences: ['go {plcae}']}\n", "plcae"),
}


@pytest.mark.parametrize("verb", [["parse", "stop"], ["run", "examples/demo.flac"]], ids=["parse", "run"])
@pytest.mark.parametrize("case", GRAMMARS)
def test_grammars(in_process, tmp_path, verb, case):
    text, says = GRAMMARS[case]
    path = _config(tmp_path, text)
    done = in_process(*verb, "--grammar", path)
    _one_error(done, 2, says)


MAPS = {
    "missing": (None, "nowhere.yaml"),
    "not YAML": ("locations: {kitchen: ", "broken.yaml:"),
    "no number": ("frame: map\nlocations:\n  kitchen: {x: five, y: 2.0, yaw: 0.0}\n", "broken.yaml:3"),
    "not finite": ("frame: map\nlocations:\n  kitchen: {x: .nan, y: 2.0, yaw: 0.0}\n", "broken.yaml:3"),
    "coordinate missing": ("frame: map\nlocations:\n  kitchen: {x: 5.0, yaw: 0.0}\n", "broken.yaml:3"),
    "twice the same name": (
        "frame: map\nlocations:\n  kitchen: {x: 1, y: 2, yaw: 0}\n  hall: {x: 1, y: 3, yaw: 0, aliases: [kitchen]}\n",
        "kitchen",
    ),
}


@pytest.mark.parametrize("case", MAPS)
def test_maps(in_process, tmp_path, case):
    text, says = MAPS[case]
    done = in_process("parse", "--locations", _config(tmp_path, text), "go to the kitchen")
    _one_error(done, 2, says)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read every file")
def test_a_grammar_without_permission(in_process, tmp_path):
    path = _config(tmp_path, "language: en\n")
    path.chmod(0)
    _one_error(in_process("parse", "--grammar", path, "stop"), 2, "permission")


def test_a_model_that_is_not_there(in_process, tmp_path):
    _one_error(in_process("run", "--model", tmp_path / "none", "examples/demo.flac"), 5, "no model folder")


@pytest.mark.parametrize(
    ("args", "says"),
    [
        (["fly"], "there is no verb 'fly'\n    there is run, listen, parse, "),
        (["pars", "stop"], "there is no verb 'pars'\n    did you mean 'parse'?\n"),
        (
            ["parse"],
            "TEXT is missing\n    what was said; - reads one sentence a line from standard input\n"
            '    as in: intent-engine parse "go to the kitchen"\n    intent-engine parse --help tells all of it\n',
        ),
        (
            ["parse", "--gramar", "x", "stop"],
            "there is no option --gramar\n    did you mean '--grammar'?\n    intent-engine parse --help tells all",
        ),
        (["--vresion"], "there is no option --vresion\n    did you mean '--version'?\n    intent-engine --help tells"),
        (
            ["parse", "-g", "tests", "stop"],
            "tests: is a folder, not a file\n    there is de, en; or give the path of a file\n",
        ),
        (["drill", "-r", ""], "a name of one of the robots is empty\n    there is arm_mobile, simulated, "),
        (["check", "nowhere.yaml"], "nowhere.yaml: no such file\n"),
        (["check", "--json", "-l", "nowhere.yaml"], "nowhere.yaml: no such file\n"),
        (["drill", "-r", os.devnull], f"{os.devnull}: is empty\n    the shortest robot file: {{name: rover}}\n"),
        (["sample", "-q"], "there is no option -q\n    intent-engine sample --help tells all of it\n"),
        (
            ["parse", "--debug", "stop"],
            "there is no option --debug\n    it stands before the verb: intent-engine --debug parse",
        ),
        (["parse", "stop", "-g"], "-g needs a value\n    intent-engine parse --help tells all of it\n"),
        (["parse", "stop", "--json=yes"], "--json takes no value\n    intent-engine parse --help tells all of it\n"),
        (
            ["parse", "go", "to", "bed"],
            "'to bed' is too much\n    put words that belong together in quotes: intent-engine parse \"go to the ",
        ),
        (
            ["sample", "my.yaml"],
            "'my.yaml' is too much\n    a grammar is an option here: intent-engine sample --grammar my",
        ),
        (["run", "a.wav", "b.wav"], "'b.wav' is too much\n    give one path; in quotes, if it has spaces\n"),
        (
            ["--json", "parse", "stop"],
            "there is no option --json\n    it stands after the verb: intent-engine run --json\n",
        ),
        (
            ["run", "--audio", "a.wav"],
            "there is no option --audio\n    the path stands without an option: intent-engine run FILE\n",
        ),
        (["run", "a.wav", "--pcm", "-"], "there is no option --pcm\n    it is an option of listen\n"),
        (["run", "a.wav", "--model", ""], "--model is empty\n    give a name, or leave the option out\n"),
        (["run", "a.wav", "--second-model="], "--second-model is empty\n"),
        (["evaluate", ".", "-m", "base", "-m", ""], "--model is empty\n"),
        (["evaluate", ".", "--snr", ""], "--snr is empty\n"),
        (["listen", "--device", ""], "--device is empty\n"),
        (["doctor", "--model", ""], "--model is empty\n"),
        (
            ["run", "examples/demo.flac", "--denoise", "--no-noise-filter"],
            "--denoise and --no-noise-filter at once\n    give one: ",
        ),
        (["--debug"], "the verb is missing\n    there is run, listen, parse, "),
        (["help"], "there is no verb 'help'\n    intent-engine --help tells of all verbs"),
        (["sample", "stop"], "'stop' is too much\n    sample takes options alone\n"),
        (["sample", "-n", "0"], "--count: 0 is out of range\n    give a whole number, 1 or more\n"),
        (["sample", "--seed", "x"], "--seed: 'x' is no whole number\n    give a whole number\n"),
        (
            ["evaluate", ".", "--at-least", "101"],
            "--at-least: 101.0 is out of range\n    give a number from 0 to 100\n",
        ),
        (
            ["parse", "--language", "fr", "stop"],
            "--language: there is no grammar for 'fr'\n    there is one for de, en; for another language give your "
            "own, with language: fr in it: --grammar my_grammar.yaml --language fr\n",
        ),
        (
            ["parse", "--language", "english", "stop"],
            "--language: there is no grammar for 'english'\n    write --language en\n",
        ),
        (
            ["parse", "--language", "Italiano", "stop"],
            "--language: there is no grammar for 'Italiano'\n    there is one for de, en; for another language give "
            "your own, with language: it in it",
        ),
        (["parse", "--language", "fr-CA", "stop"], "--language: there is no grammar for 'fr'\n"),
        (["parse", "--language", "", "stop"], "--language: there is no grammar for ''\n    there is one for de, en;"),
        (
            ["complete", "--language", "grammars/de.yaml", "stop"],
            "--language: there is no grammar for 'grammars/de.yaml'",
        ),
        (
            ["parse", "--grammar", "en", "--language", "fr", "stop"],
            "no grammar of language 'fr' is loaded; there is en\n    ask for one of these, or load a grammar with",
        ),
        (
            ["parse", "--state", "movng", "stop"],
            "--state: no intent of the grammar asks for a state 'movng'\n    did you mean 'moving'?\n",
        ),
        (
            ["sample", "--state", "moving", "--state", "docked"],
            "--state: no intent of the grammar asks for a state 'docked'\n    there is moving\n",
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_options(in_process, args, says):
    done = in_process(*args, COLUMNS="200")
    _one_error(done, 2, says)
    assert done.stderr.startswith(f"error: {says}")


def _config(folder: Path, text: str | bytes | None) -> Path:
    if text is None:
        return folder / "nowhere.yaml"
    path = folder / "broken.yaml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def _one_error(done, code: int, says: str) -> None:
    assert done.returncode == code, done.stdout + done.stderr
    assert done.stderr.startswith("error: ")
    assert done.stderr.count("error: ") == 1
    assert says in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == "", "nothing was understood, so nothing was done"


FULL = pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")


@FULL
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize(
    "command",
    [
        "parse stop",
        "parse --json stop",
        f"check {SMALL}",
        "doctor",
        "--help",
        "--version",
        "run --json examples/demo.flac",
    ],
)
def test_standard_output_on_a_full_disk(command, unbuffered):
    done = subprocess.run(
        ["sh", "-c", f"{sys.executable} -m intent_engine.cli {command} >/dev/full"],
        cwd=ROOT,
        env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == "error: standard output cannot be written: No space left on device\n"
    assert done.returncode == 2


@pytest.mark.parametrize("command", ["parse stop", "parse --json stop", f"check {SMALL}", "--help"])
def test_standard_output_that_is_closed(command):
    line = f"{sys.executable} -m intent_engine.cli {command} >&-"
    done = subprocess.run(["sh", "-c", line], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stderr == "error: standard output cannot be written: it is closed\n"
    assert done.returncode == 2


def test_standard_error_that_is_closed():
    line = f"{sys.executable} -m intent_engine.cli parse stop 2>&-; {sys.executable} -m intent_engine.cli parse 2>&-"
    done = subprocess.run(["sh", "-c", line], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.splitlines()[0]) == (2, "accepted: stop (confidence 1.00)")


@FULL
@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize(
    ("command", "code"), [("parse -g nowhere stop", 2), ("run nowhere.wav", 3), ("--bogus", 2), ("test /dev/stdin", 0)]
)
def test_what_cannot_be_told_on_standard_error_changes_no_exit_code(command, code, unbuffered):
    """The last one has a note to tell: there are no examples."""
    grammar = "language: en\nintents: {a: {action: custom, sentences: [wave]}}\n"
    for where in ("2>/dev/full", "2</dev/null"):
        done = subprocess.run(
            ["sh", "-c", f"{sys.executable} -m intent_engine.cli {command} {where}"],
            cwd=ROOT,
            input=grammar,
            env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == code, (where, done.stdout)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such pipes; CI is Linux, and runs it")
@pytest.mark.parametrize("colours", ["", "1"])
@pytest.mark.parametrize("command", ["sample -n 300", "--help", f"check --notes {SMALL}"])
def test_a_reader_that_goes_away(command, colours):
    """Also where Rich writes, and Typer: they would end the program in ways of their own."""
    with subprocess.Popen(
        [sys.executable, "-m", "intent_engine.cli", *command.split()],
        cwd=ROOT,
        env={**os.environ, "FORCE_COLOR": colours},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 141


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such shell; CI is Linux, and runs it")
@pytest.mark.parametrize(
    ("command", "code", "said"),
    [
        ("parse -", 2, "error: standard input is closed\n    give it sentences: "),
        ("run -", 3, "error: standard input is closed, and no sound comes from it\n"),
        ("parse stop", 0, ""),
    ],
)
def test_standard_input_that_is_closed(command, code, said):
    line = f"{sys.executable} -m intent_engine.cli {command} <&-"
    done = subprocess.run(["sh", "-c", line], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr[: len(said)]) == (code, said)
    assert bool(done.stderr) == bool(said)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "way.xyz",
            "--plot: way.xyz cannot be drawn: '.xyz' is no kind of picture\n    end its name in .png, .svg or .pdf",
        ),
        ("/proc/way.png", "--plot: /proc/way.png cannot be written: No such file or directory"),
        (".", "--plot: . is a folder"),
    ],
)
def test_a_picture_that_cannot_be_drawn_is_told_before_anything_moves(in_process, name, said):
    done = in_process("run", "examples/demo.flac", "--plot", name)
    assert (done.returncode, done.stdout) == (2, "")
    assert said in done.stderr


def test_raw_samples_in_a_file(in_process, tmp_path):
    (tmp_path / "x.raw").write_bytes((32_767 * _speech(4.0)).astype("<i2").tobytes())
    untold = in_process("run", tmp_path / "x.raw")
    assert (untold.returncode, untold.stdout) == (3, "")
    assert "give --rate and --format" in untold.stderr
    assert in_process("run", tmp_path / "x.raw", "--rate", RATE, "--format", "s16le").returncode == 0


def test_how_long_nobody_speaks_in_a_pipe(intent_engine):
    done = intent_engine("run", "-", stdin=bytes(2 * 3 * RATE))
    assert done.returncode == 3
    assert "standard input: nobody speaks in it (3.0 s)" in done.stderr


@pytest.mark.parametrize("words", [["test"], ["run"], ["evaluate"], ["parse", "stop", "--grammar"]])
def test_a_sentence_where_a_file_belongs_is_no_fault_of_the_program(in_process, words):
    done = in_process(*words, "turn left and " * 25)
    assert done.returncode in (2, 3)
    assert done.stderr.startswith("error: ")
    assert "turn left" in done.stderr
    assert "fault of the program" not in done.stderr
