"""Mistakes in files that are called JSON, told in words of JSON at their own line and column."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.errors import ConfigError
from intent_engine.language.loading.json_mistakes import json_problem
from intent_engine.language.locations import load


@pytest.mark.parametrize(
    ("text", "place", "says"),
    [
        ('{\n "a": {"x": 1 "y": 2}\n}', (2, 15), "a comma or a closing bracket is missing here"),
        ('{\n "a": 1,\n}', (3, 1), "nothing follows the comma before this"),
        ('{"a" 1}', (1, 6), "a colon is missing here"),
        ('// places\n{"a": 1}', (1, 1), "JSON has no comments"),
        ('{"a": 1\n\n', (1, 8), "a comma or a closing bracket is missing here"),
        ('{"a": "b}\n', (1, 10), "a text goes on over the end"),
        ("{'a': 1}", (1, 2), "a name in double quotes is missing here"),
    ],
)
def test_what_is_wrong_and_where(text, place, says):
    problem = json_problem(text, "map.json")
    assert problem is not None
    assert says in problem.message
    assert (problem.line, problem.column) == place
    assert problem.hint


def test_a_map_that_is_broken_json(tmp_path):
    path = tmp_path / "map.json"
    path.write_text('{"locations": {\n  "hall": {"x": 1.0 "y": 2.0}\n}}\n')
    with pytest.raises(ConfigError, match=r"map.json:2:21: is not valid JSON: a comma or a closing bracket is missing"):
        load(path)


def test_what_yaml_takes_is_taken_as_ever(tmp_path):
    path = tmp_path / "map.json"
    path.write_text('{"locations": {"hall": {"x": 1.0, "y": 2.0},}}\n')
    assert list(load(path)) == ["hall"]


@given(st.recursive(st.integers() | st.text(), lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner)))
def test_json_has_no_mistake(value):
    assert json_problem(json.dumps(value, indent=1), "map.json") is None


@given(st.text('{}[]",: ab1\n', max_size=20))
def test_a_mistake_has_a_place_in_the_text(text):
    problem = json_problem(text, "map.json")
    if problem is not None and text.strip():
        lines = text.splitlines()
        assert 1 <= (problem.line or 0) <= len(lines)
        assert problem.source == lines[(problem.line or 0) - 1]
        assert 1 <= (problem.column or 0) <= len(problem.source or "") + 1
