"""Who asks for another wants one more: "another coffee" is "a coffee", where a sentence has the article; and "two more
coffees" are two."""

from __future__ import annotations

import pytest
from meanings import done

from intent_engine.engine import IntentEngine

GRAMMAR = """
slots:
  drink: [coffee, tea]
  size: [small, large]
  count: {type: number, whole: true, max: 6}
  title: {type: text, max_words: 2}
intents:
  order: {action: custom, sentences: ["[get me] [a|an|{count}] [{size}] {drink}"]}
  add: {action: custom, sentences: ["add a pinch", "add {count} pinches"]}
  play: {action: custom, sentences: ["play {title}"]}
"""
PLACES = """
slots: {place: location}
intents:
  go: {action: {type: navigate, location: "{place}"}, sentences: ["go to {place}"]}
  walk: {action: custom, sentences: ["go for a walk"]}
"""
ROWS = """
slots: {row: [A, B]}
intents: {pick: {action: custom, sentences: ["take row {row}", "take a row"]}}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("another coffee", {"drink": "coffee"}),
        ("please get me another large tea", {"drink": "tea", "size": "large"}),
        ("another two tea", {"count": 2, "drink": "tea"}),
        ("add another pinch", {}),
        ("add another", None),
        ("another", None),
    ],
)
def test_another_is_one_more(engine_of, said: str, slots: dict[str, object] | None) -> None:
    found = engine_of(GRAMMAR).parse(said)
    assert (dict(found.slots) if found.actions else None) == slots


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("one more coffee", {"count": 1, "drink": "coffee"}),
        ("get me 2 more large coffees please", {"count": 2, "size": "large", "drink": "coffee"}),
        ("add three more pinches", {"count": 3}),
        ("play more love", {"title": "more love"}),
        ("one more", None),
        ("one more please", None),
        ("two, more coffees", None),
        ("more coffee", None),
        ("no more coffee", None),
        ("not one more coffee", None),
        ("add one more pinches than before", None),
    ],
)
def test_so_many_more(engine_of, said: str, slots: dict[str, object] | None) -> None:
    found = engine_of(GRAMMAR).parse(said)
    assert (dict(found.slots) if found.actions else None) == slots


def test_more_is_a_word_of_a_grammar_that_has_it(engine_of) -> None:
    engine = engine_of(GRAMMAR + '  heat: {action: custom, sentences: ["a little more"]}\n')
    assert not engine.parse("two more coffees").actions


def test_so_many_more_in_german(engine_of) -> None:
    engine = engine_of(
        "language: de\nslots: {zahl: {type: number, whole: true}, was: [kaffee, tee]}\n"
        "intents: {order: {action: custom, sentences: ['bring mir {zahl} {was}']}}\n"
    )
    assert engine.parse("bring mir zwei weitere Kaffee").slots == {"zahl": 2, "was": "kaffee"}


DRINKS = {
    "fr": ("sers [un|une|{n}] (café|cafés)", "va à {place}", "joue {title}"),
    "es": ("sirve [un|una|{n}] (café|cafés)", "ve a {place}", "toca {title}"),
    "it": ("porta [un|una|{n}] caffè", "vai in {place}", "suona {title}"),
    "de": ("bring [ein|eine|einen|{n}] (kaffee|kaffees)", "geh in {place}", "spiel {title}"),
}


@pytest.mark.parametrize(
    ("language", "said", "slots"),
    [
        ("fr", "sers deux autres cafés", {"n": 2}),
        ("fr", "sers un autre café", {}),
        ("fr", "sers deux cafés de plus", {"n": 2}),
        ("fr", "sers d'autres cafés", None),
        ("fr", "sers les deux autres cafés", None),
        ("fr", "ne sers pas un autre café", None),
        ("fr", "joue deux autres chansons", {"title": "deux autres chansons"}),
        ("es", "sirve otros dos cafés", {"n": 2}),
        ("es", "sirve otro café", {}),
        ("es", "sirve dos cafés más", {"n": 2}),
        ("es", "sirve un café más", {}),
        ("es", "sirve dos cafés más, gracias", {"n": 2}),
        ("es", "sirve dos más", None),
        ("es", "sirve más cafés", None),
        ("es", "sirve dos cafés, más", None),
        ("es", "sirve dos cafés más rápido", None),
        ("es", "toca dos canciones más", {"title": "dos canciones más"}),
        ("it", "porta altri due caffè", {"n": 2}),
        ("it", "porta due altri caffè", {"n": 2}),
        ("it", "porta un altro caffè", {}),
        ("it", "porta due caffè in più", {"n": 2}),
        ("it", "porta l'altro caffè", None),
        ("de", "bring zwei weitere Kaffees", {"n": 2}),
        ("de", "bring einen weiteren Kaffee", {}),
        ("de", "bring den weiteren Kaffee", None),
    ],
)
def test_one_more_and_so_many_more_in_other_languages(engine_of, language: str, said: str, slots) -> None:
    drink, _, play = DRINKS[language]
    found = engine_of(
        f"language: {language}\nslots: {{n: {{type: number, whole: true}}, title: {{type: text, max_words: 3}}}}\n"
        f"intents:\n  order: {{action: custom, sentences: ['{drink}']}}\n"
        f"  play: {{action: custom, sentences: ['{play}']}}\n"
    ).parse(said)
    assert ({key: value for key, value in found.slots.items() if value != 1} if found.actions else None) == slots


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "va à une autre cuisine"),
        ("es", "ve a otra cocina"),
        ("es", "ve a una cocina más"),
        ("it", "vai in un'altra cucina"),
        ("it", "vai in una cucina in più"),
        ("de", "geh in eine weitere Küche"),
    ],
)
def test_another_place_is_none_that_is_known(tmp_path, language: str, said: str) -> None:
    file = tmp_path / "grammar.yaml"
    go = f"action: {{type: navigate, location: '{{place}}'}}, sentences: ['{DRINKS[language][1]}']"
    file.write_text(f"language: {language}\nslots: {{place: location}}\nintents: {{go: {{{go}}}}}\n", "utf-8")
    places = dict.fromkeys(("cuisine", "cocina", "cucina", "küche"), (0.0, 0.0, 0.0))
    assert not IntentEngine.from_files(file, locations=places).parse(said).actions


@pytest.mark.parametrize("said", ["take row another", "take row another please"])
def test_another_is_no_letter(engine_of, said: str) -> None:
    assert done(engine_of(ROWS).parse(said)) == "rejected"


def test_another_is_no_place(tmp_path) -> None:
    file = tmp_path / "grammar.yaml"
    file.write_text(PLACES, encoding="utf-8")
    engine = IntentEngine.from_files(file, locations={"a": (0.0, 0.0, 0.0), "dock a": (1.0, 0.0, 0.0)})
    assert not engine.parse("go to another").actions
    assert not engine.parse("go to dock another").actions
    assert not engine.parse("go to another dock").actions


KIOSK = """
slots:
  snack: [sandwich, slice of cake]
  place: location
  thing: {type: text, max_words: 3}
  title: {type: text, max_words: 3}
  n: {type: number, whole: true, max: 9}
intents:
  sell: {action: custom, sentences: ["bring [a|{n}] {snack} [to the {place}]", "bring a napkin to the {place}"]}
  carry: {action: custom, sentences: ["bring [the] {thing} to the {place}", "take a {thing}"]}
  go: {action: {type: navigate, location: "{place}"}, sentences: ["go to [(a|the)] {place}"]}
  play: {action: custom, sentences: ["play [a] {title}"]}
"""


@pytest.mark.parametrize(
    ("said", "intent", "slots"),
    [
        ("bring another sandwich", "sell", {"snack": "sandwich"}),
        ("bring another sandwich to the desk", "sell", {"snack": "sandwich", "place": "desk"}),
        ("could you bring another slice of cake to the desk", "sell", {"snack": "slice of cake", "place": "desk"}),
        ("bring another napkin to the desk", "sell", {"place": "desk"}),
        ("bring another sandwich and go to the dock", "sell", None),
        ("bring another spoon to the desk", "carry", {"thing": "another spoon", "place": "desk"}),
        ("take another spoon", "carry", {"thing": "spoon"}),
        ("play another love", "play", {"title": "another love"}),
        ("bring 2 more sandwiches", "sell", {"n": 2, "snack": "sandwich"}),
        ("bring two more slices of cake", "sell", {"n": 2, "snack": "slice of cake"}),
        ("bring a sandwich to another desk", None, None),
        ("go to another desk", None, None),
        ("go to the another desk", None, None),
        ("don't bring another sandwich", None, None),
        ("who wants another sandwich", None, None),
        ("another sandwich was brought to the desk", None, None),
    ],
)
def test_another_thing_where_there_are_places(tmp_path, said: str, intent: str | None, slots) -> None:
    """A thing of a list is one more, and no free words; of a place there is but one."""
    file = tmp_path / "grammar.yaml"
    file.write_text(KIOSK, encoding="utf-8")
    found = IntentEngine.from_files(file, locations={"desk": (0.0, 0.0, 0.0), "dock": (1.0, 0.0, 0.0)}).parse(said)
    assert (found.intent if found.actions else None) == intent or slots is None
    if intent is None:
        assert not found.actions
    elif slots is not None:
        assert found.slots == slots
