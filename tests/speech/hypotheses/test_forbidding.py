"""A command as it would be said if it should not be done."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.speech.hypotheses.forbidding import forbidden, said_otherwise
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar


def test_how_a_german_command_would_be_forbidden(root):
    engine = IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")
    german = SpokenGrammar(engine)
    found = forbidden(german, ("bitte", "dreh", "dich", "um"), "de")
    assert ("bitte", "dreh", "dich", "nicht", "um") in found
    assert all("nicht" in words and not german.parse(" ".join(words), "de").actions for words in found)
    assert forbidden(german, ("stopp",), "de") == forbidden(german, ("hallo",), "de") == []


@pytest.mark.parametrize(
    ("text", "begins"),
    [
        ("turn left", [""]),
        ("please turn left", ["", "please "]),
        ("then well turn left", ["", "then well "]),
        ("stop", []),
        ("do not turn left", []),
        ("the orchestra played", []),
    ],
)
def test_a_command_as_it_would_be_forbidden(engine, grammar, text, begins):
    found = [" ".join(words) for words in forbidden(grammar, text.split())]
    assert found == [f"{begin}{no} turn left" for begin in begins for no in ("don't", "do not", "never")]
    assert not [one for one in found if engine.parse(one).actions]


def test_a_command_in_other_words_that_may_be_forbidden(grammar):
    """ "Don't forward two meters" is what nobody says, and "go back" is another command."""
    ways = ["move forward two meters", "go back", "forward two meters", "please go forward two meters", "drive ahead"]
    found = said_otherwise(grammar, [tuple(way.split()) for way in ways])
    assert [" ".join(one) for one in found] == ["please go forward two meters"]
    assert said_otherwise(grammar, [("go", "back")]) == []
