"""Places and values that the group of a regex never takes: `check` tells of them."""

from __future__ import annotations

import pytest

from intent_engine.language.pattern.values_missed import values_missed

GRAMMAR = r"""
language: en
slots:
  place: location
  thing: [red ball, cup, blue ball, green ball, old ball]
  note: {{type: text, max_words: 3}}
  n: {{type: number, max: 9}}
intents:
  go:
    action: custom
    {sentences}
    regex: {regex}
"""
MAP = {"kitchen": (0.0, 0.0, 0.0), "living room": (1.0, 0.0, 0.0), "bay 3": (2.0, 0.0, 0.0)}


def told(engine_of, regex: str, sentences: str = "") -> list[str]:
    engine = engine_of(GRAMMAR.format(regex=regex, sentences=sentences), locations=MAP)
    return [
        problem.message for problem in values_missed(engine.grammar.intents["go"], engine.grammar, engine.locations)
    ]


@pytest.mark.parametrize(
    ("regex", "message"),
    [
        (
            r"'go to (the )?(?P<place>\w+)'",
            r"a pattern of 'go' never takes 'living room', 'bay 3' for 'place': (?P<place>\w+) does not fit",
        ),
        (
            r"'go (?P<place>[a-z ]+?) now'",
            None,
        ),
        (
            r"'take (?P<thing>[a-z]+)( now)?'",
            "a pattern of 'go' never takes 'red ball', 'blue ball', 'green ball' and 1 more for 'thing': "
            "(?P<thing>[a-z]+) does not fit",
        ),
        (r"['go to (?P<place>\w+)', 'drive to (?P<place>\w+ \w+)']", None),
        # It takes them all, or its author lists what it takes.
        (r"'go to (?P<place>.+)'", None),
        (r"'go to (?P<place>\w+( \w+)*)'", None),
        (r"'go to (?P<place>kitchen|bay 3)'", None),
        (r"'write (?P<note>\w+)'", None),
        (r"'wait (?P<n>\d+) times'", None),
    ],
)
def test_an_open_group_that_is_too_narrow_is_told(engine_of, regex: str, message: str | None) -> None:
    assert told(engine_of, regex) == ([] if message is None else [message])


def test_what_a_sentence_takes_can_be_said(engine_of) -> None:
    assert not told(engine_of, r"'go to (?P<place>\w+)'", 'sentences: ["drive to {place}"]')


def test_it_is_as_it_tells(engine_of) -> None:
    engine = engine_of(GRAMMAR.format(regex=r"'go to (the )?(?P<place>\w+)'", sentences=""), locations=MAP)
    assert engine.parse("go to the kitchen").actions
    assert not engine.parse("go to the living room").actions
