"""Every program in examples/ runs, and prints what its docstring says it prints."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = sorted((ROOT / "examples").glob("*.py"))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_program(program):
    expected = _shown(program)
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, str(program)]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == expected
    assert "Traceback" not in done.stderr


def _shown(program: Path) -> str:
    docstring = ast.get_docstring(ast.parse(program.read_text("utf-8"))) or ""
    found = re.search(r"^It prints::\n\n((?: {4}.*\n?)+)", docstring, re.MULTILINE)
    assert found, f"{program.name}: its docstring ends with 'It prints::' and what it prints"
    return textwrap.dedent(found[1]).rstrip() + "\n"
