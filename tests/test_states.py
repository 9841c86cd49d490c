"""States that somebody named, beside those of the grammar."""

from __future__ import annotations

from intent_engine.states import unknown_states


def test_every_unknown_name_is_told_once_with_what_was_meant():
    problems = unknown_states(["dockd", "docked", "asleep", "dockd"], {"docked", "moving"}, "--state")
    assert [str(problem) for problem in problems] == [
        "--state: no intent of the grammar asks for a state 'dockd'\n    did you mean 'docked'?",
        "--state: no intent of the grammar asks for a state 'asleep'\n    there is docked, moving",
    ]


def test_known_names_are_no_problem():
    assert unknown_states(["docked", "moving"], {"docked", "moving"}, "--state") == []
