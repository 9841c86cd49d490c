"""What the README and the docs show is run: Python blocks, shell commands and what they print.

A ``console`` block holds ``$ command`` lines, each followed by what it prints, if that is shown; a line ``...`` stands
for any lines. A ``yaml`` block whose first line is ``# name.yaml`` is a file that the commands after it can use.
``<!-- skip: next -->`` before a block says that it cannot be run here (a microphone, a robot).
"""

from __future__ import annotations

import dataclasses
import json
import os
import re
import runpy
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import markdown
import pytest
import yaml
from sybil import Document, Example
from sybil.parsers.markdown import CodeBlockParser, PythonCodeBlockParser, SkipParser

from intent_engine import Status
from intent_engine.evaluation.scoring import Score, Verdict
from intent_engine.execution.goal import GoalState, Reason
from intent_engine.execution.policy import Policy
from intent_engine.execution.robots.robot_file import robot_schema
from intent_engine.runtime.heard import HeardKind

ROOT = Path(__file__).resolve().parent.parent
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")])
BY_HAND = ("make ", "git ", "cd ", "pip ", "sudo ", "python -m pip")
"""Commands that set things up; that their make targets exist is tested, the rest is for a person."""
SLOW = ("docs/evaluate.md", "docs/json.md")
"""Pages that are run with the slow tests: half a minute of recordings, model after model."""


def _timed(page: Path) -> Any:
    """A page, marked as slow if it is."""
    name = page.relative_to(ROOT).as_posix()
    return pytest.param(page, id=name, marks=[pytest.mark.slow] if name in SLOW else [])


class Shell:
    """Runs console blocks in a copy of the repository's data, and writes the files that pages show."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        bin_folder = Path(sys.executable).parent
        path = f"{bin_folder}{os.pathsep}{os.environ['PATH']}"
        self.environment = {**os.environ, "PATH": path, "NO_COLOR": "1", "COLUMNS": "100", "OPENBLAS_NUM_THREADS": "1"}

    def console(self, example: Example) -> None:
        for command, expected in _commands(str(example.parsed)):
            if command.startswith(BY_HAND):
                continue
            done = subprocess.run(
                ["bash", "-c", command],
                cwd=self.folder,
                env=self.environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                timeout=300,
                check=False,
            )
            where = f"{example.path}:{example.line}: $ {command}"
            if expected:
                assert _matches(expected, done.stdout), f"{where}\nshown:\n{expected}\nprinted:\n{done.stdout}"
            else:
                assert done.returncode == 0, f"{where}\n{done.stdout}"

    def yaml(self, example: Example) -> None:
        if name := re.match(r"# ([\w./-]+\.ya?ml)\n", str(example.parsed)):
            path = self.folder / name[1]
            path.parent.mkdir(exist_ok=True)
            path.write_text(str(example.parsed), "utf-8")


def _commands(block: str) -> list[tuple[str, str]]:
    found: list[tuple[str, str]] = []
    for line in block.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], ""))
        elif found and found[-1][0].endswith("\\"):
            found[-1] = (found[-1][0][:-1] + line.strip(), "")
        elif found:
            found[-1] = (found[-1][0], found[-1][1] + line + "\n")
    return found


def _matches(shown: str, printed: str) -> bool:
    lines = [r"(?:.*\n)*?" if line.strip() == "..." else _line(line) for line in shown.strip("\n").splitlines()]
    return re.fullmatch("".join(lines) + r"\s*", printed.strip("\n") + "\n") is not None


def _line(line: str) -> str:
    """One line, in which ``...`` stands for anything and spaces may differ in number."""
    words = [".*".join(map(re.escape, word.split("..."))) for word in line.split()]
    return r"[^\S\n]*" + r"[^\S\n]+".join(words) + r"[^\S\n]*\n"


@pytest.mark.parametrize("page", [_timed(page) for page in PAGES])
def test_page(page, tmp_path, monkeypatch):
    for name in ("grammars", "locations", "robots", "examples"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.chdir(tmp_path)
    shell = Shell(tmp_path)
    parsers = [
        SkipParser(),
        PythonCodeBlockParser(),
        CodeBlockParser("console", shell.console),
        CodeBlockParser("yaml", shell.yaml),
    ]
    document = Document.parse(str(page), *parsers)
    for example in document.examples():
        example.evaluate()


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_make_targets_that_a_page_names_exist(page):
    targets = set(re.findall(r"^([a-z0-9-]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))
    named = set(re.findall(r"(?:`|\$ )make ([a-z][a-z0-9-]*)", page.read_text("utf-8")))
    assert named <= targets


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_between_pages_lead_somewhere(page):
    text = re.sub(r"```.*?```", "", page.read_text("utf-8"), flags=re.DOTALL)
    for target in re.findall(r"\]\(([^)#\s]+)", text):
        if not target.startswith(("http://", "https://", "mailto:")):
            assert (page.parent / target).exists(), f"{page.name} links to {target}"


def test_a_bar_in_the_code_of_a_table_is_shown_as_it_is_said():
    build = runpy.run_path(str(ROOT / "docs" / "build.py"))
    page = build["bars_as_written"]("| a | b |\n|---|---|\n| `(left\\|right)` | c |")
    assert "<code>(left|right)</code></td>\n<td>c</td>" in markdown.markdown(page, extensions=["tables"])


def test_the_reference_names_every_key_of_a_grammar():
    schema = json.loads((ROOT / "intent_engine" / "language" / "grammar.schema.json").read_text("utf-8"))
    parts = [schema, schema["properties"]["operators"], schema["$defs"]["slot"], schema["$defs"]["intent"]]
    named = set(re.findall(r"`([a-z_]+)`", (ROOT / "docs" / "grammar.md").read_text("utf-8")))
    assert {key for part in parts for key in part["properties"]} - {"type"} <= named


def _in_code(page: str) -> set[str]:
    """All words that a page of the docs shows as code."""
    text = (ROOT / "docs" / page).read_text("utf-8")
    return {word for code in re.findall(r"`([^`\n]+)`", text) for word in re.findall(r"[\w-]+", code)}


def test_the_page_on_execution_names_every_key_of_a_robot_file():
    schema = robot_schema()["properties"]
    inside = [part["properties"] for part in schema.values() if isinstance(part.get("properties"), dict)]
    assert {key for part in (schema, *inside) for key in part} <= _in_code("execution.md")


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        ("execution.md", GoalState),
        ("execution.md", Reason),
        ("execution.md", Policy),
        ("json.md", HeardKind),
        ("json.md", Status),
        ("json.md", Verdict),
    ],
)
def test_a_page_names_every_value_that_is_told(page, kind):
    quiet = {HeardKind.SUBMITTED}  # the goals tell of themselves
    assert {word for value in set(kind) - quiet for word in value.split()} <= _in_code(page)


def test_the_page_on_json_names_every_figure_of_an_evaluation():
    assert {field.name for field in dataclasses.fields(Score)} <= _in_code("json.md")


def test_the_page_on_ros2_names_every_parameter():
    file = ROOT / "ros2" / "intent_engine_ros" / "config" / "voice_commands.yaml"
    nodes = yaml.safe_load(file.read_text("utf-8"))
    assert {name for node in nodes.values() for name in node["ros__parameters"]} <= _in_code("ros2.md")


def test_the_page_for_contributors_names_every_room():
    package = ROOT / "intent_engine"
    rooms = [path.parent.relative_to(package) for path in package.rglob("__init__.py") if path.parent != package]
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    for room in rooms:
        name = room.as_posix() if len(room.parts) < 3 else room.name
        assert f"`{name}/`" in text, room


def test_the_files_and_folders_that_the_page_for_contributors_names_exist():
    for named in re.findall(
        r"`((?:tests|grammars|docs|scripts)/[\w/]+(?:\.\w+)?)`", (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    ):
        assert (ROOT / named).exists() or named == "grammars/pt.yaml", named


OF_TODAY = [page for page in PAGES if "decisions" not in page.parts]  # those tell of their day as well


@pytest.mark.parametrize("page", OF_TODAY, ids=lambda path: str(path.relative_to(ROOT)))
def test_modules_that_a_page_names_exist(page):
    """``language/matcher.py`` is one of the package."""
    rooms = [path.name for path in (ROOT / "intent_engine").iterdir() if path.is_dir()]
    for named in re.findall(rf"`((?:{'|'.join(rooms)})/[\w/]*(?:\.py)?)`", page.read_text("utf-8")):
        assert (ROOT / "intent_engine" / named).exists(), f"{page.name} names {named}"
