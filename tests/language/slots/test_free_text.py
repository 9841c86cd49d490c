"""Free words name a thing, or they are nothing."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, done, german

from intent_engine.engine import IntentEngine, PrefixStatus

GRAMMAR = """
language: {language}
slots:
  thing: {{type: text, max_words: 3}}
  one: {{type: text, max_words: 1}}
  any: {{type: text, max_words: 2, allow: [the, 'on']}}
intents:
  take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["take {{thing}} [home]"]}}
  get: {{action: {{type: pick, object: "{{one}}"}}, sentences: ["get {{one}}"]}}
  have: {{action: {{type: pick, object: "{{any}}"}}, sentences: ["have {{any}}"]}}
  see: {{action: {{type: pick, object: "{{thing}}"}}, regex: "see (?P<thing>[a-z ]+)"}}
"""
ENGLISH = {
    "take cup": "pick cup",
    "take the cup": "pick cup",
    "take the my cup": "pick cup",
    "take box a": "pick box a",
    "take a 42": "pick a 42",
    "take the b 42": "pick b 42",
    "take the 42": "pick 42",
    "take the": "incomplete",
    "take cup of": "incomplete",
    "take cup the": "incomplete",
    "take a": "incomplete",
    "take on": "incomplete",
    "take the on": "pick on",
    "take on home": "pick on home",
    "take that": "pick that",
    # What the sentence ends with is none of the thing.
    "take cup of home": "pick cup of home",
    "take the cup home": "pick cup",
    # Of one word, all are the last.
    "get cup": "pick cup",
    "get the": "incomplete",
    "get on": "rejected",
    # An author may say that such words are things.
    "have the": "pick the",
    "have on": "pick on",
    # A pattern finds the words by itself.
    "see cup": "pick cup",
    "see the": "incomplete",
    "see a": "pick a",
}


TAKES = st.sampled_from(["take", "pick up", "grab", "bring me", "drop", "put down"])
COUNTS = st.integers(0, 999).map(str) | st.sampled_from(["one", "two", "five", "a dozen", "twenty two", "a couple"])
UNITS = st.sampled_from(["feet", "meters", "inches", "degrees", "seconds", "meters per second", "percent", "steps"])


NAME = st.lists(st.sampled_from(["cup", "red", "box", "small"]), min_size=1, max_size=6)
BEFORE = st.sampled_from(["the", "my", "a", "another", "that my", "that", "some"])


@given(st.sampled_from([("take", 3), ("get", 1)]), st.lists(BEFORE, max_size=1), NAME)
def test_an_article_is_none_of_the_words_of_a_name(engines, verb, before, name):
    said, most = verb
    meant = f"pick {' '.join(name)}" if len(name) <= most else "rejected"
    assert done(engines["en"].parse(" ".join([said, *before, *name]))) == meant


def test_but_a_letter_before_a_number_is(engines):
    assert done(engines["en"].parse("get a 42")) == "rejected"
    assert done(engines["en"].parse("get the 42")) == "pick 42"


@given(TAKES, COUNTS, st.just("") | UNITS)
def test_how_much_is_no_thing(take, count, unit):
    for said in (f"{take} {count} {unit}", f"{take} the {count} {unit}" if unit else take):
        assert does(said.strip()) in ("rejected", "incomplete")


@given(st.integers(2, 99), st.sampled_from(["cups", "meter cable", "inch screws", "red boxes"]))
def test_but_may_be_said_of_one(count, thing):
    assert does(f"take the {count} {thing}") == f"pick {count} {thing}"


DOES_BESIDES = st.sampled_from(["wash", "open", "close", "fold", "fill", "rinse", "turn over", "let me see"])


@given(TAKES, st.sampled_from(["cup", "red box", "cup on the table"]), DOES_BESIDES, st.sampled_from(["it", "them"]))
def test_what_is_done_with_it_besides_is_no_part_of_its_name(take, thing, other, it):
    assert does(f"{take} the {thing}, {other} {it}") in ("rejected", "incomplete")


@pytest.mark.parametrize("name", ["book about him", "box for them", "one of them", "cup like it", "cup with it"])
def test_but_a_word_may_bind_it_to_the_name(engine_of, name):
    engine = engine_of(
        "slots: {thing: {type: text, max_words: 4, known: [cup]}}\n"
        "intents: {take: {action: {type: pick, object: '{thing}'}, sentences: ['take {thing} [home]']}}\n"
    )
    assert done(engine.parse(f"take the {name}")) in (f"pick {name}", f"pick the {name}")


@given(st.sampled_from(["pick up", "grab", "drop", "place"]), st.data())
def test_between_two_things_is_neither_of_them(take, data):
    """ "The cup between the plate and the bowl" are not two things to pick up."""
    thing, one, other = data.draw(st.permutations(["cup", "plate", "bowl", "red box", "lamp"]))[:3]
    assert does(f"{take} the {thing} between the {one} and the {other}") in ("rejected", "incomplete")


@given(st.sampled_from(["inside", "in", "on", "under"]))
def test_no_place_is_called_of_something(where):
    assert not does(f"put the cup {where} of the pot").startswith("place cup of")


@pytest.mark.parametrize("text", ["nimm fünf", "nimm zwei Meter", "hol mir drei Fuß", "nimm zwanzig"])
def test_how_much_is_no_thing_in_german(text):
    engine = german()
    assert done(engine.parse(text)) in ("rejected", "incomplete")
    assert done(engine.parse("nimm die zwei Tassen")) == "pick zwei tassen"


@pytest.fixture(scope="module")
def engines(tmp_path_factory) -> dict[str, IntentEngine]:
    found = {}
    for language in ("en", "de", "fr"):
        path = tmp_path_factory.mktemp(language) / "g.yaml"
        path.write_text(GRAMMAR.format(language=language))
        found[language] = IntentEngine.from_files(path)
    return found


@pytest.mark.parametrize(("text", "meant"), ENGLISH.items())
def test_what_a_thing_may_be_called(engines, text, meant) -> None:
    assert done(engines["en"].parse(text)) == meant
    whole = engines["en"].prefix(text).status in (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)
    if not text.startswith("see"):
        assert whole is meant.startswith("pick")


def test_each_language_has_its_own_articles(engines) -> None:
    assert done(engines["de"].parse("take den")) == "incomplete"
    assert done(engines["de"].parse("take an")) == "pick an"
    assert done(engines["fr"].parse("take the")) == "pick the"


def test_a_german_thing() -> None:
    engine = german()
    assert done(engine.parse("nimm den")) == "incomplete"
    assert done(engine.parse("nimm das")) == "pick das"


@pytest.mark.parametrize(
    ("said", "name"),
    [("jose", "josé"), ("José", "josé"), ("zoe", "zoe"), ("zoë", "zoë"), ("ana jose", "ana josé"), ("rose", "rose")],
)
def test_a_name_has_the_accents_with_which_it_is_listed(tmp_path, said, name):
    """Zoë and Zoe are two."""
    (tmp_path / "g.yaml").write_text(
        "language: en\nslots: {who: {type: text, known: [José, Zoë, Zoe, Ana]}}\n"
        "intents: {call: {action: custom, sentences: ['call {who}']}}\n",
        "utf-8",
    )
    assert IntentEngine.from_files(tmp_path / "g.yaml").parse(f"call {said}").slots == {"who": name}
