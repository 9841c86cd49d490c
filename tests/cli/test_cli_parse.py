"""``intent-engine parse``, as a person at a shell and as a program at a pipe meet it."""

from __future__ import annotations

import json
import random
import sys

import pytest

KEYS = ["text", "status", "intent", "slots", "actions", "confidence", "alternatives", "reason"]


def test_a_sentence_and_its_action(in_process):
    done = in_process("parse", "go forward two meters")
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "accepted: move direction=forward distance=2" in done.stdout
    assert "move forward 2.00 m at +0.50 m/s for 4.00 s" in done.stdout
    assert "\x1b" not in done.stdout, "no colours in a pipe"


@pytest.mark.parametrize(
    ("text", "code", "status"),
    [
        ("go to the kitchen", 0, "accepted"),
        ("don't move forward", 1, "rejected"),
        ("go to the", 1, "incomplete"),
        ("", 1, "rejected"),
    ],
)
def test_json_has_exactly_the_eight_keys_and_the_code_says_whether_it_was_accepted(in_process, text, code, status):
    done = in_process("parse", "--json", text)
    assert done.returncode == code
    (line,) = done.stdout.splitlines()
    found = json.loads(line)
    assert list(found) == KEYS
    assert (found["text"], found["status"]) == (text, status)
    assert bool(found["actions"]) == (code == 0)


def test_a_sentence_a_line_from_standard_input(intent_engine):
    done = intent_engine("parse", "-", stdin=b"go to the kitchen\nstop\r\n\nwhat a day")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [item["status"] for item in found] == ["accepted", "accepted", "rejected", "rejected"]
    assert [item["text"] for item in found] == ["go to the kitchen", "stop", "", "what a day"]
    assert all(list(item) == KEYS for item in found)
    assert done.returncode == 1, "not every sentence was accepted"


def test_all_accepted_is_success(intent_engine):
    assert intent_engine("parse", "-", stdin=b"stop\nturn left\n").returncode == 0


def test_bytes_that_are_no_text(intent_engine):
    noise = random.Random(7).randbytes(20_000)
    done = intent_engine("parse", "-", stdin=noise)
    assert done.returncode == 1
    assert len(done.stdout.splitlines()) == noise.rstrip(b"\n").count(b"\n") + 1
    assert not any(json.loads(line)["actions"] for line in done.stdout.splitlines())
    assert "Traceback" not in done.stderr


def test_a_megabyte_without_a_line_end(intent_engine):
    done = intent_engine("parse", "-", stdin=b"go forward " * 100_000 + b"\nstop\n")
    assert done.returncode == 7
    assert done.stderr.startswith("error: line 1 of standard input is longer than")
    long, short = [json.loads(line) for line in done.stdout.splitlines()]
    assert (long["status"], long["actions"]) == ("rejected", [])
    assert short["status"] == "accepted", "the lines after it are read as ever"


@pytest.mark.parametrize("verb", ["parse", "complete"])
def test_a_long_argument(in_process, verb):
    done = in_process(verb, "go forward " * 9_000)
    assert done.returncode == 7
    assert done.stdout == ""
    assert done.stderr.startswith("error: the text (99000 characters) is longer than")


HEAVY = {
    *("faster_whisper", "ctranslate2", "sounddevice", "soundfile", "onnxruntime", "av", "soxr", "numpy", "rclpy"),
    *("matplotlib", "huggingface_hub", "pydantic", "hypothesis", "pytest"),
}
"""What has no business in a verb that reads text."""
SLOW = {"jsonschema", "lark", "rich.console", "importlib.metadata"}
"""What is only needed for a mistake in a file, or for a terminal."""


@pytest.mark.parametrize(
    ("arguments", "absent"),
    [
        (
            ["parse", "go to the kitchen"],
            HEAVY | SLOW | {"rapidfuzz", "intent_engine.execution", "intent_engine.speech"},
        ),
        (["parse", "--json", "turn left"], HEAVY | SLOW | {"rapidfuzz"}),
        (["parse", "--explain", "turn left"], HEAVY | SLOW),
        (["complete", "go to the"], HEAVY | SLOW | {"rapidfuzz"}),
        (["sample", "-n", "3"], HEAVY | SLOW),
        (["--help"], HEAVY | {"jsonschema", "lark", "rapidfuzz", "yaml"}),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_verbs_that_read_text_load_no_more_than_that_takes(arguments, absent):
    import subprocess

    code = (
        "import contextlib, sys\n"
        f"sys.argv = ['intent-engine', *{arguments!r}]\n"
        "from intent_engine.cli import main\n"
        "with contextlib.suppress(SystemExit):\n"
        "    main()\n"
        f"print(sorted({absent!r} & set(sys.modules)))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"
    assert len(done.stdout.splitlines()) > 1


@pytest.mark.parametrize(
    ("text", "words", "others"),
    [
        ("go to the", {"kitchen", "bedroom", "dock"}, {"forward"}),
        ("go to the ki", {"kitchen"}, {"bedroom"}),
        ("turn", {"left", "right", "around"}, {"kitchen"}),
    ],
)
def test_complete_lists_the_words_that_may_follow(in_process, text, words, others):
    done = in_process("complete", text)
    listed = set(done.stdout.split())
    assert done.returncode == 0
    assert words <= listed
    assert not others & listed
    as_json = json.loads(in_process("complete", "--json", text).stdout)
    assert set(as_json["next_words"]) == listed


def test_complete_knows_when_nothing_can_follow(in_process):
    done = in_process("complete", "fly to the moon")
    assert (done.returncode, done.stdout) == (1, "")
    assert "no sentence begins so" in done.stderr


DOUBTFUL = """\
language: en
slots: {colour: {values: [red, blue]}}
intents:
  wave: {action: custom, sentences: [wave]}
"""


@pytest.mark.parametrize("options", [["wave"], ["--json", "wave"], ["--explain", "wave"], ["-"]])
def test_what_is_doubtful_in_a_grammar_is_told_in_one_line_that_says_where(intent_engine, tmp_path, options):
    (tmp_path / "my wave.yaml").write_text(DOUBTFUL)
    done = intent_engine("parse", "-g", "my wave.yaml", *options, stdin=b"wave\nwave\n", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stderr == "1 warning in grammar my wave.yaml: intent-engine check 'my wave.yaml' shows it\n"
    checked = intent_engine("check", "my wave.yaml", cwd=tmp_path)
    assert checked.stdout.startswith("warning: my wave.yaml:2:9: slot 'colour' is used by no sentence")
    assert "0 errors, 1 warning" in checked.stdout


def test_of_several_files_that_are_one_grammar_it_is_told_once(in_process, tmp_path):
    (tmp_path / "one.yaml").write_text(DOUBTFUL)
    (tmp_path / "two.yaml").write_text(DOUBTFUL.replace("wave", "bow").replace("colour", "shade"))
    done = in_process("parse", "-g", "one.yaml", "-g", "two.yaml", "wave", cwd=tmp_path)
    assert done.stderr == (
        "2 warnings in grammars one.yaml and two.yaml: intent-engine check --together one.yaml two.yaml shows them\n"
    )


def test_the_mark_before_utf_8_is_not_said(intent_engine):
    done = intent_engine("parse", "-", stdin="\N{BOM}stop\n\N{BOM}stop\n".encode())
    assert [json.loads(line)["text"] for line in done.stdout.splitlines()] == ["stop", "\N{BOM}stop"]


def test_sentences_in_another_encoding_are_told_of(intent_engine):
    done = intent_engine("parse", "-", stdin="stop\ngeh zur Küche\nzur Tür\n".encode("latin-1"))
    assert len(done.stdout.splitlines()) == 3
    assert done.stderr == "line 2 of standard input is not UTF-8 text: save the sentences as UTF-8\n"


def test_a_long_line_is_cut_within_no_character(intent_engine):
    done = intent_engine("parse", "-", stdin=b"a" + "ü".encode() * 50_000 + b"\n")
    assert done.returncode == 7
    assert "UTF-8" not in done.stderr


def test_no_sentence_at_all_is_no_success(intent_engine):
    done = intent_engine("parse", "-", stdin=b"")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "standard input is empty: no sentence was given\n"


def test_the_name_of_a_file_is_no_sentence(in_process, tmp_path):
    path = tmp_path / "my sentences.txt"
    path.write_text("stop\n", "utf-8")
    done = in_process("parse", path)
    assert done.returncode == 1
    assert done.stdout.startswith("rejected: ")
    assert f"{path} is a file; for the sentences in it, one a line: intent-engine parse - < '{path}'" in done.stderr


def test_an_argument_is_utf_8_whatever_the_locale_says(intent_engine):
    locale = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    done = intent_engine("parse", "--json", "--language", "de", "fahr zurück", **locale)
    found = json.loads(done.stdout)
    assert (found["text"], found["confidence"]) == ("fahr zurück", 1.0)
    done = intent_engine("complete", "--json", "--language", "de", "fahr zurü", **locale)
    assert json.loads(done.stdout)["next_words"] == ["zurück"]


def test_a_line_in_another_encoding_does_nothing(intent_engine):
    done = intent_engine("parse", "--language", "de", "-", stdin="fahr 1½ Meter vor\n".encode("latin-1"))
    assert (done.returncode, json.loads(done.stdout)["actions"]) == (1, [])
