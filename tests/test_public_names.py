"""Packages that load their names when they are first used tell a type checker what each of them is."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path

import pytest


@pytest.mark.parametrize("name", ["intent_engine", "intent_engine.runtime", "intent_engine.testing"])
def test_a_type_checker_knows_every_public_name(name):
    package = import_module(name)
    assert package.__file__ is not None
    tree = ast.parse(Path(package.__file__).read_text("utf-8"))
    checked = [node for node in tree.body if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"]
    told = {
        one.name for block in checked for line in block.body if isinstance(line, ast.ImportFrom) for one in line.names
    }
    assert told == set(package.__all__) - {"__version__"}
