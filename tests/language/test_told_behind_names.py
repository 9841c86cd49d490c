"""What is told behind the name of a thing is no part of it, shortened or in full: "drop the cup, it's hot"."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine import IntentEngine

SHIPPED = shipped()
GRAMMAR = """
language: en
slots:
  song: {type: text, max_words: 5}
  thing: {type: object, max_words: 5}
  note: {type: text, max_words: 8, dictation: true}
  mine: {type: object, max_words: 3, allow: ["you're"]}
intents:
  play: {action: custom, sentences: ["play {song}"]}
  fetch: {action: custom, sentences: ["fetch {thing}"]}
  note: {action: custom, sentences: ["note {note}"]}
  name: {action: custom, sentences: ["name {mine}"]}
"""
TOLD = st.sampled_from(
    ["it's hot", "I'm thirsty", "he's here", "she's gone", "they've left", "they'd like that", "I've one"]
)
TOLD_AFTER_A_PAUSE = st.sampled_from(["you're nice", "that's mine", "there's one", "you've had one", "I'll help"])


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


THINGS = st.sampled_from(["cup", "the red cup", "that box"])


@given(THINGS, TOLD)
def test_no_thing_goes_on_with_what_is_told(engine: IntentEngine, thing: str, told: str) -> None:
    assert not engine.parse(f"fetch {thing} {told}").actions
    assert not SHIPPED.parse(f"drop {thing} {told}").actions


@given(THINGS, st.sampled_from([", ", ". "]), TOLD | TOLD_AFTER_A_PAUSE)
def test_behind_a_pause_it_is_why_or_nothing_is_done(engine: IntentEngine, thing: str, pause: str, told: str) -> None:
    for one, verb in ((engine, "fetch"), (SHIPPED, "drop")):
        found = one.parse(f"{verb} {thing}{pause}{told}").actions
        assert found in ((), one.parse(f"{verb} {thing}").actions)


@pytest.mark.parametrize("said", ["look at the door it's open", "put it on the sofa it's late"])
def test_in_the_shipped_grammar(said: str) -> None:
    assert not SHIPPED.parse(said).actions


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("fetch the cup you're holding", "cup youre holding"),
        ("fetch the cup that's red", "cup thats red"),
        ("fetch the box with its lid", "box with its lid"),
        ("fetch the box that he's holding", "box that hes holding"),
        ("fetch the id card", "id card"),
        ("fetch the old id, please", "old id"),
        ("fetch the big, red cup", "big red cup"),
        ("play I'm yours", "im yours"),
        ("play baby, it's cold outside", "baby its cold outside"),
        ("note the cup is hot, it's on the table", "the cup is hot, it's on the table"),
        ("name cup, you're", "cup youre"),
    ],
)
def test_what_may_be_its_name_is(engine: IntentEngine, said: str, value: str) -> None:
    assert list(engine.parse(said).slots.values()) == [value]


FOREIGN = """
language: {language}
slots: {{thing: {{type: object, max_words: 4}}, song: {{type: text, max_words: 4}}}}
intents:
  fetch: {{action: custom, sentences: ["{fetch} {{thing}}"]}}
  play: {{action: custom, sentences: ["{play} {{song}}"]}}
"""
VERBS = {"de": ("such", "spiel"), "fr": ("prends", "joue"), "es": ("coge", "toca"), "it": ("prendi", "suona")}


@pytest.mark.parametrize(
    ("language", "said", "thing"),
    [
        ("de", "such die Zange, die Gäste warten", "zange"),
        ("de", "such auch die Zange", "zange"),
        ("de", "such auch Zange", "zange"),
        ("fr", "prends la tasse, ça brûle", "tasse"),
        ("fr", "prends aussi la tasse", "tasse"),
        ("fr", "prends la tasse bleue, verte", "tasse bleue verte"),
        ("es", "coge la taza, que quema", "taza"),
        ("es", "coge también la taza", "taza"),
        ("it", "prendi la tazza, scotta", "tazza"),
        ("it", "prendi la tazza, che scotta", "tazza"),
        ("it", "prendi anche tazza", "tazza"),
    ],
)
def test_of_other_languages_it_is_no_part_either(engine_of, language: str, said: str, thing: str) -> None:
    fetch, play = VERBS[language]
    found = engine_of(FOREIGN.format(language=language, fetch=fetch, play=play)).parse(said)
    assert found.slots == {"thing": thing}, found.reason


@pytest.mark.parametrize(("language", "said"), [("de", "such auch"), ("fr", "prends aussi"), ("es", "coge también")])
def test_what_softens_is_no_thing(engine_of, language: str, said: str) -> None:
    fetch, play = VERBS[language]
    assert not engine_of(FOREIGN.format(language=language, fetch=fetch, play=play)).parse(said).actions


@pytest.mark.parametrize(
    ("language", "said", "song"),
    [("de", "spiel auch morgen", "auch morgen"), ("fr", "joue aussi loin", "aussi loin")],
)
def test_in_titles_they_are_words(engine_of, language: str, said: str, song: str) -> None:
    fetch, play = VERBS[language]
    found = engine_of(FOREIGN.format(language=language, fetch=fetch, play=play)).parse(said)
    assert found.slots == {"song": song}, found.reason
