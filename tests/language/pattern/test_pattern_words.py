"""The words of patterns: what a pattern fits is a way through its network, and every way fits it."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Collection
from functools import reduce

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lark import Lark

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.language.networks.network import Call, Network, State
from intent_engine.language.pattern.pattern_lark import lark_tree
from intent_engine.language.pattern.pattern_regex import regex_tree
from intent_engine.language.pattern.pattern_tree import Named, Number, UnsayableError, Words, leaves_open, walk
from intent_engine.language.pattern.pattern_words import pattern_network

WORDS = st.sampled_from(["go", "lights?", "turn(?:ing)?", "[ab]c", r"x\.?", "(?P<side>left|right)", "r{1,2}ed"])
PATTERNS = st.recursive(
    WORDS,
    lambda inner: st.one_of(
        st.builds("{} {}".format, inner, inner),
        st.builds("(?:{}|{})".format, inner, inner),
        st.builds("(?:{} )?{}".format, inner, inner),
        st.builds(r"{}(?:\s+{})*".format, inner, inner),
        st.builds("(?:{}(?: {}){{0,2}}|the)".format, inner, inner),
    ),
    max_leaves=6,
)


def once(pattern: str) -> str:
    """A pattern whose groups have one name each, as Python and RE2 want."""
    names = iter(range(100))
    return re.sub("<side>", lambda _: f"<side{next(names)}>", pattern)


def network(pattern: str) -> Network:
    return pattern_network(regex_tree(pattern), lambda _: None, numbers=False)


def closed(states: Collection[State]) -> set[State]:
    found, waiting = set(states), list(states)
    while waiting:
        for edge in waiting.pop().edges:
            if edge.target not in found:
                found.add(edge.target)
                waiting.append(edge.target)
    return found


def accepts(ways: Network, words: Collection[str]) -> bool:
    def step(states: set[State], word: str) -> set[State]:
        return closed({after for state in states for after in state.arcs.get(word, ())})

    return any(state.final for state in reduce(step, words, closed({ways.start})))


@settings(max_examples=150)
@given(PATTERNS, st.data())
def test_what_a_pattern_fits_is_a_way_through_its_network(pattern, data):
    pattern = once(pattern)
    text = " ".join(data.draw(st.from_regex(pattern, fullmatch=True, alphabet="abcdefghilnoqrstuvwx. ")).split())
    if re.fullmatch(pattern, text):
        assert accepts(network(pattern), text.split())


@settings(max_examples=150)
@given(PATTERNS, st.data())
def test_every_way_through_its_network_fits_the_pattern(pattern, data):
    pattern = once(pattern)
    here, words = network(pattern).start, []
    while not here.final:
        word = data.draw(st.sampled_from(sorted(here.arcs)))
        (here,) = here.arcs[word][:1]
        words.append(word)
        if len(words) > 40:
            return
    assert re.fullmatch(pattern, " ".join(words))


@pytest.mark.parametrize(
    ("pattern", "opened"),
    [
        (r"go \d+", [Number]),
        (r"go \d{1,3} (?:m|cm)", [Number]),
        (r"go [0-9]+(?:\.[0-9]+)? meters", [Number, Number]),
        (r"say .+", [Words]),
        (r"say (?P<note>[a-z ]+)", [Named, Words]),
        (r"\w+ left", [Words]),
        (r"[^ab]+", [Words]),
        (r"gate [a-c]", []),
        (r"gate .", []),
        (r"^go\b( now)?$", []),
        (r"(?i)GO", []),
        (r"(?i)GO \S+ [A-C]", [Words]),
        (r"go (?:[0-9]|[ ])+", [Words]),
        (r"go (?:[0-9])+", [Number]),
        (r"go(?:[ \t\f\r\n])+now", []),
    ],
)
def test_what_a_pattern_leaves_open(pattern, opened):
    found = [type(part) for part in walk(regex_tree(pattern)) if isinstance(part, Number | Words | Named)]
    assert found == opened


@pytest.mark.parametrize(
    ("pattern", "opened"), [("gate .", True), ("gate [a-c]", False), (r"go \d+", False), ("x .*", True)]
)
def test_whether_a_pattern_leaves_any_words_open(pattern, opened):
    assert leaves_open(regex_tree(pattern)) is opened


@pytest.mark.parametrize(
    "pattern",
    [
        r"(go",
        r"a\1",
        r"\pL",
        r"(?=go)go",
        r"(?:go|a{9})",
        "",
        r"[a-z]{3} now",
        "go  now",
        " go",
        "(" * 99 + "a" + ")" * 99,
    ],
)
def test_a_pattern_of_which_nobody_knows_how_it_is_said(pattern):
    with pytest.raises(UnsayableError):
        network(pattern)


@settings(deadline=None)
@given(st.text("ab(|)[]?*+{2,}\\\\dws.^-<P> ", max_size=30))
def test_whatever_is_written_it_is_known_or_it_is_not(pattern):
    with contextlib.suppress(UnsayableError):
        network(pattern)


def test_rules_within_each_other_are_not_followed_for_ever():
    rules = "\n".join(
        f"r{n}: " + " | ".join(f'"{n}" r{other} r{(other + 1) % 9}' for other in range(9)) for n in range(9)
    )
    with pytest.raises(UnsayableError):
        lark_tree(Lark(f'start: r0 | "x"\n{rules}\n', parser="earley"), ())


def test_a_number_is_said_in_words_too():
    ways = pattern_network(regex_tree("gate 204"), lambda _: None, numbers=True)
    for said in ("gate 204", "gate two hundred four", "gate two oh four"):
        assert accepts(ways, said.split()), said


def test_what_is_said_has_small_letters():
    assert accepts(network("(?i)Go (?:Left|[R]ight)"), ["go", "right"])


def test_letters_that_go_on_as_a_number_are_no_word():
    ways = pattern_network(regex_tree(r"(?:bay\d+|bay \d+)"), lambda _: Call("quantity:number"), numbers=True)
    assert ways.words() == {"bay"}
    (state,) = ways.start.arcs["bay"]
    assert [edge.call for edge in state.edges] == [Call("quantity:number")]


GRAMMAR = r"""
language: en
slots:
  lamp: {type: text}
  state: {type: choice, values: [up, down]}
  place: {type: location}
  metres: {type: number}
  note: {type: text, max_words: 6}
  colour: {type: choice, values: [red, blue]}
  count: {type: number}
intents:
  lights: {action: custom, regex: "(?P<lamp>lights?|ceiling lamp) (?P<state>up|down)"}
  drive: {action: custom, regex: "(?:go|move) (?:the )?(?:forward|ahead) (?P<metres>\\d+(?:\\.\\d+)?) (?:meters?|m)"}
  visit: {action: custom, regex: "(?:visit|see) (?P<place>.+)"}
  dance: {action: custom, regex: "(?:.* )?dance"}
  stack:
    action: custom
    lark: |
      start: "stack" count colour ("on" colour)*
      count: /\d+/
      colour: "red" | "blue"
      %ignore " "
  climb:
    action: custom
    lark: |
      %import common.NUMBER
      %import common.WORD
      %import common.WS
      %ignore WS
      start: ("climb" | "go") way+ metres "meters" | "tell" note
      way: "up" | "down"
      metres: NUMBER
      note: WORD+
  sing:
    action: custom
    lark: |
      start: "sing" " " (song | "(" start ")")
      song: "la" (" la")+
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR, locations={"kitchen": (1.0, 2.0), "Bay B12": (0.0, 0.0)})


@pytest.mark.parametrize(
    "text",
    [
        "lights up",
        "ceiling lamp down",
        "go forward two meters",
        "move the ahead 2.5 meters",
        "visit the kitchen",
        "see bay b twelve",
        "dance",
        "stack two red",
        "stack 4 red on blue on red",
        "sing la la la",
        "climb up down two meters",
        "go up 2.5 meters",
        "tell my friend hello",
        "lights up and then visit the kitchen",
        "do not dance",
    ],
)
def test_what_patterns_have_may_be_heard(engine, text):
    likely = engine.matcher().likely
    state = reduce(lambda here, word: here and likely.step(here, word), text.split(), likely.start())
    assert state is not None
    assert likely.accepting(state)


@pytest.mark.parametrize("text", ["lights blue", "visit the moon", "stack two", "play dance", "go forward meters"])
def test_and_nothing_else(engine, text):
    likely = engine.matcher().likely
    state = reduce(lambda here, word: here and likely.step(here, word), text.split(), likely.start())
    assert state is None or not likely.accepting(state)


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("lights", PrefixStatus.INCOMPLETE),
        ("lights up", PrefixStatus.COMPLETE),
        ("go forward two", PrefixStatus.INCOMPLETE),
        ("go forward two meters", PrefixStatus.COMPLETE),
        ("lights blue", PrefixStatus.IMPOSSIBLE),
    ],
)
def test_they_are_looked_ahead_in(engine, text, status):
    assert engine.prefix(text).status is status


@pytest.mark.parametrize(
    ("text", "slots"),
    [
        ("go forward 2 meters", {"metres": 2.0}),
        ("go forward two meters", {"metres": 2.0}),
        ("go forward two point five meters", {"metres": 2.5}),
        ("go forward twenty one meters", {"metres": 21.0}),
        ("stack two red on blue", {"count": 2.0, "colour": "blue"}),
    ],
)
def test_a_pattern_with_digits_is_said_in_words(engine, text, slots):
    assert engine.parse(text).slots == slots
