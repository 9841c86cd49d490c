"""Mistakes in grammar files: each is told at its place. The messages are in ``golden/grammar_mistakes.txt``.

After a change of wording: ``UPDATE_GOLDEN=1 pytest tests/language/test_grammar_mistakes.py``, and read the diff.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from grammar_mistakes import MISTAKES, move, says

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError, Problem

GOLDEN = Path(__file__).parents[2] / "golden" / "grammar_mistakes.txt"


def problems(text: str | bytes) -> tuple[Problem, ...]:
    Path("grammar.yaml").write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ConfigError) as caught:
        IntentEngine.from_files("grammar.yaml")
    return caught.value.problems


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_messages_are_as_they_were_read():
    told = []
    for name, text in MISTAKES.items():
        found = "\n".join(str(problem) for problem in problems(text))
        told.append(f"== {name} ==\n{found}\n")
    if os.environ.get("UPDATE_GOLDEN"):
        GOLDEN.write_text("\n".join(told), "utf-8")
    assert "\n".join(told) == GOLDEN.read_text("utf-8")


@pytest.mark.parametrize("name", MISTAKES)
def test_every_problem_has_its_place(name):
    for problem in problems(MISTAKES[name]):
        assert problem.file == "grammar.yaml"
        assert problem.message
        if problem.line is not None:
            text = MISTAKES[name]
            assert isinstance(text, str) or name == "Latin-1"
            if isinstance(text, str):
                assert problem.source == text.splitlines()[problem.line - 1].replace("\x07", "\ufffd")
            assert problem.column is None or 1 <= problem.column <= len(problem.source or "") + 1


def test_nearly_every_message_says_what_to_do():
    without = [name for name, text in MISTAKES.items() if any(one.hint is None for one in problems(text))]
    assert len(without) <= 0.1 * len(MISTAKES), without


def test_problems_stand_in_the_order_of_the_file():
    lines = [problem.line or 0 for problem in problems(MISTAKES["everything at once"])]
    assert lines == sorted(lines)
    assert len(lines) >= 6


def test_one_bad_file_does_not_disturb_another():
    Path("bad.yaml").write_text(says("wave (at {who"))
    Path("odd.yaml").write_text(move(sentence="'go {driection}'"))
    Path("good.yaml").write_text(says("bow").replace("wave", "bow"))
    with pytest.raises(ConfigError) as caught:
        IntentEngine.from_files(["bad.yaml", "good.yaml", "odd.yaml"])
    told = [(problem.file, problem.message) for problem in caught.value.problems]
    assert told == [("bad.yaml", "'{' is never closed"), ("odd.yaml", "there is no slot or phrase 'driection'")]


def test_what_a_broken_file_defines_is_not_called_missing():
    Path("words.yaml").write_text("language: en\nslots:\n  who: {type: txt}\nphrases:\n  hi: (hi|hello\n")
    Path("main.yaml").write_text(says("{hi} {who}", "include: [words.yaml]\n"))
    with pytest.raises(ConfigError) as caught:
        IntentEngine.from_files("main.yaml")
    assert [problem.file for problem in caught.value.problems] == ["words.yaml", "words.yaml"]
    Path("words.yaml").write_text("language: en\nslots: [\n")
    with pytest.raises(ConfigError) as caught:
        IntentEngine.from_files("main.yaml")
    (problem,) = caught.value.problems
    assert (problem.file, problem.line) == ("words.yaml", 2)


@pytest.mark.parametrize("size", [65 * 1024 * 1024])
def test_a_huge_file_is_not_read(size):
    with Path("grammar.yaml").open("wb") as file:
        file.truncate(size)
    with pytest.raises(ConfigError, match=r"grammar.yaml: is larger than 64 MiB\n    is this the right file\?"):
        IntentEngine.from_files("grammar.yaml")


def test_phrases_that_double_are_refused():
    rows = "".join(f"  p{number}: '{{p{number - 1}}} {{p{number - 1}}}'\n" for number in range(1, 41))
    (problem,) = problems(says("wave [{p40}]", f"phrases:\n  p0: '[x]'\n{rows}"))  # 2 to the power of 40 ways
    assert problem.message == "there are more than 10,000 ways to go on after the same words of this sentence"
    assert problem.line == 48
    # The same with words that must be said is long, and no way of going on is another.
    Path("grammar.yaml").write_text(says("wave [{p40}]", f"phrases:\n  p0: 'x'\n{rows}"))
    assert IntentEngine.from_files("grammar.yaml").parse("wave x").actions == ()


def test_phrases_nested_without_end_are_refused():
    rows = "".join(f"  p{number}: 'x [{{p{number - 1}}}]'\n" for number in range(1, 2000))
    found = problems(says("wave {p1999}", f"phrases:\n  p0: x\n{rows}"))
    assert found[0].message == "phrase 'p50' holds phrases in phrases, more than 50 deep"
