"""Files that were given in the place of another kind."""

from __future__ import annotations

import pytest

from intent_engine.language.loading.file_kind import given_for


@pytest.mark.parametrize(
    ("kind", "keys", "says"),
    [
        ("grammar", {"locations"}, "is a map, not a grammar"),
        ("map", {"language", "intents"}, "is a grammar, not a map"),
        ("grammar", {"name", "limits"}, "is a robot file, not a grammar"),
        ("grammar", {"tests", "grammar", "locations"}, "is a test file, not a grammar"),
        ("robot file", {"tests"}, "is a test file, not a robot file"),
    ],
)
def test_a_file_of_another_kind_is_named_as_what_it_is(kind, keys, says):
    problem = given_for(kind, dict.fromkeys(keys), "a.yaml")
    assert problem is not None
    assert problem.message == says


def test_a_key_of_its_own_makes_it_what_it_was_given_as():
    assert given_for("grammar", {"intents": {}, "tests": []}, "a.yaml") is None
    assert given_for("map", {}, "a.yaml") is None
