"""What a template begins with, and how long it may be."""

from __future__ import annotations

import pytest

from intent_engine.language.template import parse_template
from intent_engine.language.templates.template_tree import first_words, most_words

PHRASES = {"please": parse_template("[would you] kindly"), "well": parse_template("[well]")}


@pytest.mark.parametrize(
    ("template", "words", "empty"),
    [
        ("go back", {"go"}, False),
        ("(go|drive) back", {"go", "drive"}, False),
        ("[please] [do] go", {"please", "do", "go"}, False),
        ("[please] [now]", {"please", "now"}, True),
        ("{please} go", {"would", "kindly"}, False),
        ("{well} go", {"well", "go"}, False),
        ("{thing} falls", set(), False),
        ("(now; go [back])", {"now", "go"}, False),
        ("([now]; [go])", {"now", "go"}, True),
    ],
)
def test_the_words_it_may_begin_with(template, words, empty):
    assert first_words(parse_template(template), PHRASES) == (words, empty)


@pytest.mark.parametrize(
    ("template", "most"),
    [("go", 1), ("go [right] back", 3), ("(go|turn right)", 2), ("go to {place} now", 6), ("(now; go back)", 3)],
)
def test_the_words_of_its_longest_way(template, most):
    assert most_words(parse_template(template), lambda _: 3) == most
