"""The automaton says what a slow and obvious matcher says, whatever the grammar."""

from __future__ import annotations

import threading
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from reference_matcher import ReferenceMatcher, Slots, TooManyWaysError

from intent_engine.language import automaton as automaton_module
from intent_engine.language.automaton import Automaton
from intent_engine.language.grammar import ActionSpec, Grammar, Intent, Operators, Sentence, Slot
from intent_engine.language.matcher import Matcher
from intent_engine.language.networks.network import Call, Edge, Networks, State
from intent_engine.language.reading import Reading
from intent_engine.language.template import parse_template
from intent_engine.language.templates.template_tree import (
    AnyOrder,
    Choice,
    Node,
    Optional,
    Reference,
    Sequence,
    Word,
    WordClass,
)

NAMED = ["ant", "bee", "cat", "the"]
CLOSED = frozenset(("not", "if"))
SAID = [*NAMED, "not", "if", "yak", "zoo", "7", "2.5", "-3"]
"""Words of the grammars, closed words, words that no grammar has, numerals."""


def trees(leaves: st.SearchStrategy[Node], size: int) -> st.SearchStrategy[Node]:
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.lists(inner, min_size=2, max_size=3).map(lambda items: Sequence(tuple(items))),
            st.lists(inner, min_size=2, max_size=3).map(lambda items: Choice(tuple(items))),
            inner.map(Optional),
            st.lists(inner, min_size=2, max_size=3).map(lambda items: AnyOrder(tuple(items))),
        ),
        max_leaves=size,
    )


words = st.sampled_from([*NAMED, "not"]).map(Word)
plain = trees(words, 3)


def reference(*names: str) -> st.SearchStrategy[Node]:
    return st.sampled_from([Reference(name, label, 0) for name in names for label in (name, f"{name}2")])


@st.composite
def grammars(draw: st.DrawFn) -> Grammar:
    phrases = {"p": draw(plain), "q": draw(trees(st.one_of(words, st.just(Reference("p", "p", 0))), 3))}
    in_slot = trees(st.one_of(words, st.just(Reference("p", "p", 0))), 3)
    slots = {
        "kind": Slot(
            "kind",
            "choice",
            values=tuple((f"v{n}", draw(in_slot)) for n in range(draw(st.integers(1, 3)))),
            fuzzy=False,
        ),
        "free": Slot("free", "text", max_words=draw(st.integers(1, 2))),
        "wide": Slot("wide", "text", max_words=draw(st.integers(1, 2)), allow=frozenset(("not",))),
    }
    leaves = st.one_of(words, words, st.just(WordClass("#")), reference("p", "q", "kind", "free", "wide"))
    templates = draw(st.lists(trees(leaves, 6), min_size=1, max_size=3))
    return grammar_of(templates, phrases, slots)


def grammar_of(
    templates: list[Node],
    phrases: dict[str, Node] | None = None,
    slots: dict[str, Slot] | None = None,
    alikes: dict[str, tuple[str, ...]] | None = None,
) -> Grammar:
    intents = {
        f"intent{n}": Intent(f"intent{n}", ActionSpec("custom"), (Sentence("", template),))
        for n, template in enumerate(templates)
    }
    return Grammar("en", (), phrases or {}, slots or {}, intents, Operators(closed=CLOSED), alikes or {})


def slots_of(reading: Reading) -> Slots:
    return tuple((slot.label, slot.start, slot.end, slot.value) for slot in reading.slots)


def number_of(reading: Reading) -> int:
    return int(reading.intent.name.removeprefix("intent"))


def matcher_of(grammar: Grammar) -> Matcher:
    """A matcher in which a number is a numeral: the reference says all sentences, but not all numbers in words."""
    matcher = Matcher(grammar)
    matcher.networks.add_template("quantity:number", WordClass("#"), {})
    return matcher


def both(grammar: Grammar) -> tuple[Matcher, ReferenceMatcher]:
    try:
        return matcher_of(grammar), ReferenceMatcher(grammar)
    except TooManyWaysError:
        assume(False)
        raise


@st.composite
def grammar_and_words(draw: st.DrawFn) -> tuple[Matcher, ReferenceMatcher, list[list[str]]]:
    """A grammar; random words; and sentences of the grammar, whole or with one word changed."""
    matcher, slow = both(draw(grammars()))
    tried = draw(st.lists(st.lists(st.sampled_from(SAID), max_size=6), min_size=1, max_size=4))
    ways = [way for sentence in slow.sentences for way in sentence]
    for way in draw(st.lists(st.sampled_from(ways), max_size=6)) if ways else ():
        said = [piece.word or ("7" if piece.numeral else draw(st.sampled_from(SAID))) for piece in way.pieces]
        changed = draw(st.booleans())
        if said and changed:
            said[draw(st.integers(0, len(said) - 1))] = draw(st.sampled_from(SAID))
        tried.append(said)
    return matcher, slow, tried


many = settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much]
)


@many
@given(grammar_and_words())
def test_the_same_sentences_with_the_same_slots(case: tuple[Matcher, ReferenceMatcher, list[list[str]]]) -> None:
    matcher, slow, tried = case
    for said in tried:
        expected = slow.readings(said)
        found = {number_of(reading): reading for reading in matcher.read(said)}
        # A number that is not whole is refused, also where a free slot would take it; and a thing "7" that stands
        # behind another number is told to be none.
        assert expected.keys() - slow.refused_for_a_number(said) <= found.keys() <= expected.keys(), said
        for number, reading in found.items():
            if reading.problem:
                assert beside_each_other(said), said
            else:
                assert slots_of(reading) in expected[number], said


def beside_each_other(said: list[str]) -> bool:
    """Whether two numbers are."""
    numbers = [word[0].isdigit() for word in said]
    return any(first and second for first, second in pairwise(numbers))


@many
@given(grammar_and_words())
def test_the_same_beginnings_and_the_same_next_words(
    case: tuple[Matcher, ReferenceMatcher, list[list[str]]],
) -> None:
    matcher, slow, tried = case
    automaton = matcher.strict
    for said in tried:
        count, state = automaton.walk(said)
        assert slow.begins(said[:count])
        if state is None:
            assert not slow.begins(said[: count + 1])
            continue
        assert count == len(said)
        following, numeral, free = slow.next_words(said)
        assert automaton.next_words(state) == following
        assert automaton.allows_digits(state) == numeral
        assert automaton.free(state) == free
        assert automaton.accepting(state) == slow.ends(said)
        assert automaton.inside(state) == slow.goes_on(said)


@many
@given(grammar_and_words())
def test_one_that_is_only_walked_goes_the_same_ways(case: tuple[Matcher, ReferenceMatcher, list[list[str]]]) -> None:
    matcher, _, tried = case
    traced = matcher.strict
    walked = matcher._automaton(matcher._root(matcher._whole), loose=False, traced=False)
    for said in tried:
        (count, state), (walked_count, walked_state) = traced.walk(said), walked.walk(said)
        assert count == walked_count
        assert (state is None) is (walked_state is None)
        if state is not None and walked_state is not None:
            for asked in ("next_words", "known_words", "allows_digits", "free", "accepting", "inside"):
                assert getattr(traced, asked)(state) == getattr(walked, asked)(walked_state), asked


@many
@given(grammar_and_words(), st.randoms(use_true_random=False))
def test_what_was_read_before_changes_nothing(
    case: tuple[Matcher, ReferenceMatcher, list[list[str]]], random: object
) -> None:
    """Steps are kept; a kept step must mean what a new one would."""
    matcher, _, tried = case
    for said in tried:
        fresh = matcher_of(matcher.grammar)
        for loose in (False, True):
            kept = [(number_of(reading), slots_of(reading)) for reading in matcher.read(said, loose=loose)]
            new = [(number_of(reading), slots_of(reading)) for reading in fresh.read(said, loose=loose)]
            assert kept == new


@given(case=grammar_and_words())
@settings(many, max_examples=50)
def test_a_store_that_is_emptied_all_the_time_changes_nothing(
    case: tuple[Matcher, ReferenceMatcher, list[list[str]]],
) -> None:
    matcher, _, tried = case
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(automaton_module, "MAX_KEPT", 2)
        forgetful = matcher_of(matcher.grammar)
        for said in (*tried, *tried):
            expected = [(number_of(reading), slots_of(reading)) for reading in matcher.read(said)]
            assert [(number_of(reading), slots_of(reading)) for reading in forgetful.read(said)] == expected


# -- sound-alikes ---------------------------------------------------------------------------------------------

ALIKES = {"yak": ("ant",), "zoo": ("bee", "cat")}


@many
@given(trees(words, 6), st.lists(st.sampled_from(SAID), max_size=5))
def test_a_word_that_sounds_alike_is_read_as_one_that_is_known(template: Node, said: list[str]) -> None:
    matcher = Matcher(grammar_of([template], alikes=ALIKES))
    _, slow = both(grammar_of([template]))
    meant = [[]]  # type: list[list[str]]
    for word in said:
        meant = [[*before, one] for before in meant for one in (word, *ALIKES.get(word, ()))]
    expected = {tuple(one) for one in meant if slow.readings(one)}
    found = matcher.read(said, loose=True)
    assert bool(found) == bool(expected)
    for reading in found:
        assert reading.words in expected
        assert reading.alikes == sum(heard != read for heard, read in zip(said, reading.words, strict=True))


def test_sound_alikes_are_read_only_when_asked_for() -> None:
    matcher = Matcher(grammar_of([parse_template("ant bee")], alikes=ALIKES))
    assert not matcher.read(["yak", "bee"])
    assert [reading.words for reading in matcher.read(["yak", "zoo"], loose=True)] == [("ant", "bee")]


# -- cost -----------------------------------------------------------------------------------------------------


def counting(automaton: Automaton, monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Counts new steps: those that were not kept."""
    count = 0
    advance = automaton._advance

    def counted(*asked: Any) -> object:
        nonlocal count
        count += 1
        return advance(*asked)

    monkeypatch.setattr(automaton, "_advance", counted)
    return lambda: count


ADVERSARIAL = ["{free} {free} {free} {free}", "[ant] [ant] [ant] [ant] [ant] ant", "({free}|ant) ({free}|ant) [{wide}]"]


@pytest.mark.parametrize("template", ADVERSARIAL)
def test_one_step_a_word_however_often_the_sentence_could_be_divided(
    template: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    slots = {name: Slot(name, "text", max_words=12) for name in ("free", "wide")}
    matcher = Matcher(grammar_of([parse_template(template)], slots=slots))
    steps = counting(matcher.strict, monkeypatch)
    for length in range(1, 40):
        matcher.read(["ant"] * length)
    assert steps() <= 60, "each length adds one step to those kept"


def test_a_word_that_no_sentence_names_is_walked_once_for_all_such_words(monkeypatch: pytest.MonkeyPatch) -> None:
    matcher = Matcher(grammar_of([parse_template("ant {free}")], slots={"free": Slot("free", "text", max_words=2)}))
    steps = counting(matcher.strict, monkeypatch)
    for number in range(500):
        assert len(matcher.read(["ant", f"word{number}", f"other{number}"])) == 1
    assert steps() == 3


NOTHING_FOR_IT = st.lists(st.sampled_from(["ant", "bee", "cat", "yak", "zoo", "7"]), max_size=5)


@given(said=NOTHING_FOR_IT, without=NOTHING_FOR_IT.map(frozenset))
def test_what_was_probably_said_has_nothing_in_a_slot_that_is_nothing_for_it(said: list[str], without: frozenset[str]):
    """A search that finds "fetch the big right apple" only to hear that "right" is nothing to fetch finds no other."""
    slots = {"free": Slot("free", "text", max_words=3, without=without)}
    templates = [parse_template("ant {free} [bee]"), parse_template("[{free}] cat")]
    matcher = Matcher(grammar_of(templates, slots=slots))

    def thing(words: list[str]) -> bool:
        return 1 <= len(words) <= 3 and without.isdisjoint(words)

    ant = said[:1] == ["ant"] and (thing(said[1:]) or (said[-1] == "bee" and thing(said[1:-1])))
    cat = said[-1:] == ["cat"] and (len(said) == 1 or thing(said[:-1]))
    _, state = matcher.likely.walk(said)
    assert (state is not None and matcher.likely.accepting(state)) is (ant or cat)
    for word in set(said) | without:
        assert not state or not matcher.likely.free(state) or word in without or matcher.likely.step(state, word)


def test_what_is_said_all_the_same_is_read_and_told() -> None:
    slots = {"free": Slot("free", "text", max_words=3, without=frozenset({"yak"}))}
    matcher = Matcher(grammar_of([parse_template("ant {free}")], slots=slots))
    assert [one.problem for one in matcher.read(["ant", "zoo"])] == [""]
    assert [one.problem for one in matcher.read(["ant", "yak"])] == ["'yak' is nothing for slot 'free'"]
    assert matcher.spoken.walk(["ant", "yak"])[1] is not None
    assert matcher.likely.walk(["ant", "yak"])[1] is None


def test_threads_that_walk_at_once_read_the_same() -> None:
    slots = {"free": Slot("free", "text", max_words=3)}
    matcher = Matcher(grammar_of([parse_template("ant [bee] {free} [cat]"), parse_template("{free} bee")], slots=slots))
    said = [["ant", *["bee"] * n, "yak", *["cat"] * m] for n in range(3) for m in range(3)]
    expected = [[slots_of(reading) for reading in Matcher(matcher.grammar).read(one)] for one in said]
    wrong: list[object] = []

    def walk() -> None:
        for _ in range(20):
            found = [[slots_of(reading) for reading in matcher.read(one)] for one in said]
            if found != expected:
                wrong.append(found)

    threads = [threading.Thread(target=walk) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_who_comes_to_a_list_that_another_is_unfolding_finds_its_names() -> None:
    """A program parses, while another of its threads looks ahead."""
    networks, root = Networks(), State()
    end = State()
    end.final = True
    root.edges.append(Edge(end, call=Call("names")))
    first, second = (Automaton(networks, root, is_numeral=str.isdigit, is_number_word=str.isdigit) for _ in range(2))
    walked: list[int] = []
    other = threading.Thread(target=lambda: walked.append(second.walk(["ant"])[0]))

    class Names:
        def __iter__(self):
            other.start()
            other.join(0.1)  # without a lock it has come through by now
            yield (("ant",), "ant")

    networks.add_names("names", Names())
    assert first.walk(["ant"])[0] == 1
    other.join(30.0)
    assert walked == [1]
    assert second.walk(["ant"])[0] == 1
