"""Whatever is put together of the sentences of a grammar and of the words that change them means something, or nothing;
it never is a fault of the program."""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.sampler import sample
from intent_engine.language.words.thing_words import thing_words

ROOT = Path(__file__).resolve().parents[3]
GRAMMARS = ("grammars/en.yaml", "grammars/de.yaml", "examples/coffee/coffee.yaml")


@cache
def engine(grammar: str) -> IntentEngine:
    return IntentEngine.from_files(ROOT / grammar, locations=ROOT / "locations" / "home.yaml")


@cache
def changing(grammar: str) -> list[str]:
    """The words that change what a sentence does, and small ones that stand between others."""
    known = engine(grammar).grammar
    operators = (getattr(known.operators, field.name) for field in fields(known.operators))
    phrases = {" ".join(one) if isinstance(one, tuple) else one for some in operators for one in some}
    things = thing_words(known.language)
    return sorted(phrases | {"two", "red"} | things.articles | things.having)


@cache
def parts(grammar: str) -> st.SearchStrategy[str]:
    """Sentences, what stands anywhere in them, and words that change them."""
    known = engine(grammar)
    sentences = [one.text.split() for one in sample(known.grammar, known.locations, 300, seed=3)]
    some = st.sampled_from(sentences)
    cut = st.tuples(some, st.integers(0, 6), st.integers(1, 4)).map(lambda cut: cut[0][cut[1] :][: cut[2]])
    return st.one_of(some.map(" ".join), cut.map(" ".join).filter(bool), st.sampled_from(changing(grammar)))


@cache
def corrections(grammar: str) -> st.SearchStrategy[str]:
    return st.sampled_from([" ".join(one) for one in engine(grammar).grammar.operators.correction])


@st.composite
def said(draw: st.DrawFn, grammar: str) -> str:
    """Such parts, and perhaps some of the same words once more after a "no"."""
    some = draw(st.lists(parts(grammar), min_size=1, max_size=4))
    if draw(st.booleans()):
        words = " ".join(some).split()
        start = draw(st.integers(0, len(words) - 1))
        end = draw(st.integers(start + 1, min(start + 4, len(words))))
        some += [draw(corrections(grammar)), *words[start:end]]
    return draw(st.sampled_from([" ", " ", ", "])).join(some)


@pytest.mark.parametrize("examples", [200, pytest.param(500, marks=pytest.mark.slow)])
@pytest.mark.parametrize("grammar", GRAMMARS)
def test_sentences_in_pieces_are_understood_or_not(grammar, examples):
    @settings(max_examples=examples)
    @given(text=said(grammar))
    def check(text):
        for state in ((), ("moving",)):
            found = engine(grammar).parse(text, state=state)
            assert bool(found.actions) == (found.status is Status.ACCEPTED)
        engine(grammar).prefix(text)

    check()


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("fr", "verse {menge}", "bof deux kilos et demi"),
        ("es", "vierte {menge}", "bah dos kilos y medio"),
        ("it", "versa {menge}", "boh due chili e mezzo"),
        ("de", "gieß {menge}", "tja zwei Kilos und ein halbes"),
    ],
)
def test_units_that_may_be_written_as_each_other_end(engine_of, language: str, sentence: str, said: str) -> None:
    engine = engine_of(f"""
language: {language}
slots: {{menge: {{type: number, units: {{1: [gramm], 1000: [kilo, kilos, chilo, chili]}}}}}}
intents: {{weigh: {{action: custom, sentences: ["{sentence}"]}}}}
""")
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    "text",
    [
        "deliver cup from cup out of cup back back to cup back",
        "deliver cup back out of cup back back back to cup cup cup",
    ],
)
def test_a_way_that_is_left_out_of_what_was_moved_ends_no_word_of_it(text: str) -> None:
    """What is moved ends at its last word, of which none may be there where "back" says no more."""
    assert engine("grammars/en.yaml").parse(text).status is not Status.INCOMPLETE


HOUSES = {
    "en": ("turn on the {thing}", "lamp, pump", "turn on the lamp"),
    "de": ("schalte die {thing} ein", "Lampe, Pumpe", "schalte die Lampe ein"),
    "fr": ("allume la {thing}", "lampe, pompe", "allume la lampe"),
    "es": ("enciende la {thing}", "lámpara, bomba", "enciende la lámpara"),
    "it": ("accendi la {thing}", "lampada, pompa", "accendi la lampada"),
}


@pytest.mark.parametrize("language", HOUSES)
def test_what_is_said_behind_a_command_is_understood_or_not(engine_of, language: str) -> None:
    """By itself each word that may point back or change what was said, and a few of them together."""
    sentence, things, command = HOUSES[language]
    house = engine_of(f"""
language: {language}
slots: {{thing: [{things}], n: {{type: number, max: 9}}}}
intents: {{on: {{action: custom, sentences: ["{sentence}", "{sentence.split()[0]} {{n}}"]}}}}
""")
    last = house.parse(command)
    assert last.actions
    known = house.grammar
    operators = (getattr(known.operators, field.name) for field in fields(known.operators))
    phrases = {" ".join(one) if isinstance(one, tuple) else one for some in operators for one in some}
    small = (getattr(thing_words(language), field.name) for field in fields(thing_words(language)))
    phrases |= {word for some in small if isinstance(some, frozenset) for word in some if isinstance(word, str)}
    phrases |= {*command.split(), "2"}
    for phrase in phrases:
        for heard in (False, True):
            found = house.parse(phrase, last=last, heard=heard)
            assert bool(found.actions) == (found.status is Status.ACCEPTED)

    @settings(max_examples=150)
    @given(st.lists(st.sampled_from(sorted(phrases)), min_size=2, max_size=4))
    def check(some):
        found = house.parse(" ".join(some), last=last)
        assert bool(found.actions) == (found.status is Status.ACCEPTED)

    check()
