"""Whatever the grammar: "five of the washers" and "totes 4 and 5" do what was said, in its order, or nothing."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.quantities import evaluate

laws = settings(max_examples=80, deadline=None, derandomize=True)

VERBS = ("sort", "close")
NOUNS = ("tote", "battery", "box")
THINGS = {"washer": "washers", "red bolt": "red bolts", "battery": "batteries", "gear": "gears"}
"""Each with what more of it are called."""
TAILS = ("", " into the tray", " [into the tray]", " from aisle {m}", " [from aisle {m}]")
SAID_BEHIND = ("", " into the tray", " from aisle 3", " please", " now")


@pytest.fixture(scope="module")
def made(engine_of):
    """Engines by what their grammar is made of."""
    engines: dict[tuple[object, ...], IntentEngine] = {}

    def engine(verb: str, noun: str, tail: str, *, digits: bool, plural: bool) -> IntentEngine:
        key = (verb, noun, tail, digits, plural)
        if key not in engines:
            things = [more if plural else one for one, more in THINGS.items()]
            engines[key] = engine_of(f"""
language: en
slots:
  n: {{type: number, whole: true, min: 1, max: 5000, digits: {str(digits).lower()}}}
  m: {{type: number, whole: true, min: 1, max: 9}}
  thing: [{", ".join(things)}]
intents:
  count: {{action: custom, sentences: ["{verb} {{n}} {{thing}}{tail}"]}}
  name: {{action: custom, sentences: ["{verb} [the] {noun} {{n}}{tail}"]}}
  one: {{action: custom, sentences: ["take [the|a] {{thing}}"]}}
""")
        return engines[key]

    return engine


@st.composite
def grammars(draw) -> dict[str, object]:
    return {
        "verb": draw(st.sampled_from(VERBS)),
        "noun": draw(st.sampled_from(NOUNS)),
        "tail": draw(st.sampled_from(TAILS)),
        "digits": draw(st.booleans()),
        "plural": draw(st.booleans()),
    }


def number_as_said(number: int, *, words: bool) -> str:
    return " ".join(in_words([str(number)])) if words else str(number)


def plural_of(noun: str) -> str:
    return {"battery": "batteries", "box": "boxes"}.get(noun, f"{noun}s")


@laws
@given(
    grammars(),
    st.integers(1, 300),
    st.booleans(),
    st.sampled_from(sorted(THINGS)),
    st.sampled_from(("of the", "of those", "of these")),
    st.sampled_from(SAID_BEHIND),
)
def test_a_number_of_the_things_is_the_number_of_them(made, grammar, number, words, thing, of, behind) -> None:
    engine, said = made(**grammar), number_as_said(number, words=words)
    plain = engine.parse(f"{grammar['verb']} {said} {THINGS[thing]}{behind}").actions
    found = engine.parse(f"{grammar['verb']} {said} {of} {THINGS[thing]}{behind}").actions
    assert found in ((), plain)
    if plain and not any(number_as_said(number, words=True).endswith(part) for part in ("half", "quarter")):
        assert found == plain
        assert (plain[0].slots["n"], len(plain)) == (number, 1)


@laws
@given(
    grammars(),
    st.integers(2, 40),
    st.booleans(),
    st.sampled_from(sorted(THINGS)),
    st.sampled_from(SAID_BEHIND),
    st.sampled_from((
        "all {n} of the {things}", "{n} of the {m} {things}", "{n} of {m} {things}", "half of the {things}",
        "{n} of the other {things}", "{n} or {m} of the {things}", "at least {n} of the {things}",
        "not {n} of the {things}", "{n}, of the {things}", "{n} and a half of the {things}", "{n} of the {things} only",
        "most of the {n} {things}", "{n} of what the {things} are", "none of the {n} {things}",
    )),
)  # fmt: skip
def test_more_than_that_is_nothing(made, grammar, number, words, thing, behind, form) -> None:
    engine = made(**grammar)
    said = form.format(
        n=number_as_said(number, words=words), m=number_as_said(number + 3, words=words), things=THINGS[thing]
    )
    assert not engine.parse(f"{grammar['verb']} {said}{behind}").actions, said


@laws
@given(
    grammars(),
    st.lists(st.integers(1, 300), min_size=2, max_size=4),
    st.booleans(),
    st.one_of(st.just(", "), st.sampled_from((" and ", " and then ", " to ", " through ", "-", " - ", " or ", " "))),
    st.one_of(st.just(" and "), st.sampled_from((", and ", " and also ", ", ", " or ", " to ", " through ", "-", " "))),
    st.booleans(),
    st.sampled_from(SAID_BEHIND),
)
def test_of_several_numbers_none_is_left_out_nor_made(
    made, grammar, numbers, words, joint, last, article, behind
) -> None:
    """Whatever stands between them, more than one was named."""
    engine = made(**grammar)
    *first, end = (number_as_said(number, words=words) for number in numbers)
    listed = f"{joint.join(first)}{last}{end}"
    assume(evaluate(words_of(listed), "number") is None)  # "totes one hundred and four" may be tote 104
    noun = plural_of(str(grammar["noun"]))
    actions = engine.parse(f"{grammar['verb']} {'the ' * article}{noun} {listed}{behind}").actions
    done = [action.slots["n"] for action in actions]
    joints = [joint] * (len(numbers) - 2) + [last]
    parted = all("and" in one or one == ", " for one in joints) and "and" in last
    if done == [one for one, _ in pairwise([*numbers, 0])] and len(set(numbers)) == len(numbers):
        assert parted or words, (listed, done)
    else:
        assert not done, (listed, done)
    assert all(action.name == "name" for action in actions)
