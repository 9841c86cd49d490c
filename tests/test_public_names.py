"""The names that a program imports from the package are typed, and not only found when they are used."""

from __future__ import annotations

import ast
from pathlib import Path

import intent_engine


def test_a_type_checker_knows_every_public_name() -> None:
    tree = ast.parse(Path(intent_engine.__file__).read_text(encoding="utf-8"))
    known = {alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert set(intent_engine.__all__) - {"__version__"} <= known
