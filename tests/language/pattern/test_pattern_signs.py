"""Regular expressions that ask for signs: what is told of is never said, and what can be said is not told of."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lark import Lark

from intent_engine.language.normalize import tokenize
from intent_engine.language.pattern.pattern_signs import unsaid_blank, unsaid_in_lark, unsaid_sign


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("hop, now", ","),
        ("hop now!", "!"),
        ("what's up", "'"),
        ("x-ray", "-"),
        ("wave\\.", "."),
        ("bow[!;]", "!"),
        ("(hop!|bow!)", "!"),
        ("(hop!)+", "!"),
        ("(?P<how>hop!)", "!"),
        ("faster by 50%", "%"),
    ],
)
def test_a_sign_that_nobody_says(text, sign):
    assert unsaid_sign(text) == sign


@pytest.mark.parametrize(
    "text",
    [
        "hop,? now",
        "(hop!)?",
        "(hop!|bow)",
        "bow[!a]",
        "add -\\d+",
        "(?:hop|bow){1,2}",
        "(?i)hop",
        "2\\.5|1/2",
        "< 5",
    ],
)
def test_what_can_be_said(text):
    assert unsaid_sign(text) is None


@pytest.mark.parametrize("text", ["go  now", " go", "go now\n", "(?P<how>go)  now", "go ( now|\\.)\t"])
def test_a_blank_that_nobody_says(text):
    assert unsaid_blank(text)


@pytest.mark.parametrize("text", ["go now", "go +now", "go ( now)?", "( go)?now", "go {1,2}now", "^go now$"])
def test_a_blank_that_can_be_said(text):
    assert not unsaid_blank(text)


@pytest.mark.parametrize(
    ("grammar", "unsaid"),
    [
        ('start: "Go Now"', "Go Now"),
        ('start: "Go now"i', None),
        ('start: "go, now!"', ","),
        ('start: "go" (", now")?', None),
        ('start: "go " N\nN: /[A-Za-z]+/', None),
    ],
)
def test_what_nobody_says_of_a_lark_grammar(grammar, unsaid):
    assert unsaid_in_lark(Lark(grammar, parser="earley"), ()) == unsaid


PIECES = ["hop", "now", "2", "5", " ", ",", "!", "'", "-", "/", "\\.", "%", "é", "?", "(a|b!)", "(c,)?", "[;d]"]


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(PIECES), min_size=1, max_size=6), st.text("hopnw25 ,.!'-/%abcdé;", max_size=12))
def test_no_pattern_that_fits_what_is_said_is_told_of(pieces, text):
    pattern = "".join(pieces)
    said = " ".join(token.word for token in tokenize(text))
    try:
        fits = re.fullmatch(pattern, said) is not None
    except re.error:
        return
    assert not (fits and unsaid_sign(pattern))
    assert not (fits and said and unsaid_blank(pattern))


@settings(max_examples=200, deadline=None)
@given(st.from_regex(r"[a-z]{1,4}( [a-z0-9]{1,3}){0,3}", fullmatch=True))
def test_words_as_they_are_said_are_never_told_of(text):
    assert unsaid_sign(text) is None
