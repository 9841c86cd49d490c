"""Commands with no word and no pause between, of which the second may be a part of what the first is about."""

from __future__ import annotations

import pytest
from meanings import shipped

from intent_engine.actions import Pick, Place


@pytest.mark.parametrize(
    ("text", "thing", "place"),
    [
        ("pick up the cup put that bottle on the table", "bottle", "table"),
        ("pick up the cup put the gizmo down", "gizmo", None),
        ("pick up the cup and put that gizmo down", "gizmo", None),
        ("pick up the cup, put that gizmo on the table", "gizmo", "table"),
    ],
)
def test_a_thing_that_is_known_or_named_plainly_is_of_another_command(text: str, thing: str, place: str | None) -> None:
    assert shipped().parse(text).actions == (Pick("cup"), Place(thing, place))


@pytest.mark.parametrize(
    "text",
    [
        "find me a pizza place that delivers",
        "bring me a hair drop that shines",
        "get me a paper drop that opens",
        "pick up the cup put that gizmo down",
    ],
)
def test_what_may_tell_more_of_the_thing_before_it_is_none(text: str) -> None:
    assert not shipped().parse(text).actions
