"""Which of many regular expressions fit a text: asked at once, it is what each would say for itself."""

from __future__ import annotations

import re2
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.checker import check_grammar
from intent_engine.language.pattern.regex_set import RegexSet

WORDS = ["go", "stop", "the", "lamp", "5", "é", "no"]
TEXTS = st.lists(st.sampled_from(WORDS), max_size=6).map(" ".join)
PATTERNS = st.recursive(
    st.sampled_from([*WORDS, r"\w+", ".", ".*", r"\b", " ", "[a-m]", "(?i:GO)", "^", "$"]),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map("".join),
        st.tuples(inner, inner).map(lambda two: f"(?:{two[0]}|{two[1]})"),
        st.tuples(inner, inner).map(" ".join),
        inner.map(lambda one: f"(?:{one})?"),
        inner.map(lambda one: f"(?:{one})*?"),
        inner.map(lambda one: f"(?P<slot>{one})"),
    ),
    max_leaves=6,
)
TOO_MUCH = [re2.compile(rf"w{place} (?:\w+ ){{1,100}}x [a-z ]{{0,100}}") for place in range(400)]


def alone(patterns: list, text: str) -> list[int]:
    return [place for place, pattern in enumerate(patterns) if pattern.fullmatch(text) is not None]


@given(st.lists(PATTERNS.filter(lambda text: text.count("P<slot>") < 2), max_size=8), st.lists(TEXTS, max_size=4))
def test_it_is_what_each_says_for_itself(written, texts):
    patterns = [re2.compile(text) for text in written]
    together = RegexSet(patterns)
    for text in texts:
        found = [place for place in together.fitting(text) if patterns[place].fullmatch(text) is not None]
        assert found == alone(patterns, text)
        if len(patterns) > 1:
            assert list(together.fitting(text)) == found, "no more are asked than fit"


def test_what_is_too_much_for_it_is_asked_one_by_one():
    together = RegexSet(TOO_MUCH)
    assert list(together.fitting("w1 a x b")) == [*range(400)]
    assert alone(TOO_MUCH, "w1 a x b") == [1]


def test_so_is_what_it_gives_up_while_it_matches(monkeypatch):
    patterns = [re2.compile("go"), re2.compile("stop")]
    together = RegexSet(patterns)
    monkeypatch.setattr(re2.Set, "Match", lambda *_: None)
    assert list(together.fitting("stop")) == [0, 1]


GRAMMAR = r"""
language: en
slots: {thing: {type: text}, n: {type: number}}
intents:
  a: {action: {type: custom, name: a}, regex: ["dance(?: .*)?", "hop (?P<n>.+)"]}
  b: {action: {type: custom, name: b}, regex: "(?:.* )?wave"}
  c: {action: {type: custom, name: c}, regex: ["dance now", "take (?P<thing>.+)"]}
  d: {action: {type: custom, name: d}, sentences: [take it easy], regex: "hop [0-9]"}
"""


def test_a_check_finds_the_same(engine_of, monkeypatch):
    engine: IntentEngine = engine_of(GRAMMAR)
    quick = check_grammar(engine.grammars[0], None)
    assert {"pattern", "shadowed"} <= {one.topic for one in quick.findings}
    monkeypatch.setattr(RegexSet, "fitting", lambda each, text: range(len(each._patterns)))
    assert check_grammar(engine.grammars[0], None) == quick
