""" "Fahr zum Tor" is understood by "fahr zu {place}": one word for a preposition and an article."""

from __future__ import annotations

import pytest
from meanings import done

from intent_engine import IntentEngine
from intent_engine.prefix import PrefixStatus

GRAMMAR = """
language: {language}
slots: {{place: location, thing: object, who: [{who}]}}
intents:
  go: {{action: {{type: navigate, location: "{{place}}"}}, sentences: ["{go} {{place}}"]}}
  put: {{action: custom, sentences: ["{put} {{thing}}", "{put} {{thing}} {to} {{place}}"]}}
  tell: {{action: custom, sentences: ["{tell} {{who}}"]}}
"""
WORDS = {
    "de": {"go": "fahr zu", "put": "stell", "to": "zu", "tell": "melde dich bei", "who": "Chef"},
    "fr": {"go": "va à", "put": "pose", "to": "à", "tell": "parle à", "who": "chef"},
    "es": {"go": "ve a", "put": "lleva", "to": "a", "tell": "habla a", "who": "jefe"},
    "it": {"go": "vai a", "put": "porta", "to": "a", "tell": "parla con", "who": "capo"},
}
PLACES = {
    "de": ["Tor", "Rampe", "Haus zum Löwen"], "fr": ["bar", "toilettes", "café du port"],
    "es": ["bar", "almacén", "puerta del sol"], "it": ["bar", "ingresso", "porta del sole"],
}  # fmt: skip
PLACE = [
    ("de", "fahr zum Tor", "Tor"),
    ("de", "fahr zur Rampe", "Rampe"),
    ("de", "fahr bitte zum Tor", "Tor"),
    ("de", "fahr zum Tor, nein, zur Rampe", "Rampe"),
    ("de", "fahr nicht zum Tor, sondern zur Rampe", "Rampe"),
    ("de", "fahr zu Haus zum Löwen", "Haus zum Löwen"),
    ("fr", "va au bar", "bar"),
    ("fr", "va aux toilettes", "toilettes"),
    ("fr", "ne va pas au bar mais aux toilettes", "toilettes"),
    ("fr", "va au café du port", "café du port"),
    ("es", "ve al bar", "bar"),
    ("es", "ve al bar, no, al almacén", "almacén"),
    ("es", "no vayas al bar sino al almacén", "almacén"),
    ("es", "ve a la puerta del sol", "puerta del sol"),
    ("it", "vai al bar", "bar"),
    ("it", "vai all'ingresso", "ingresso"),
    ("it", "non andare al bar ma all'ingresso", "ingresso"),
    ("it", "vai alla porta del sole", "porta del sole"),
]
OTHERS = [
    ("de", "melde dich beim Chef", {"who": "Chef"}),
    ("fr", "parle au chef", {"who": "chef"}),
    ("es", "habla al jefe", {"who": "jefe"}),
    ("it", "parla col capo", {"who": "capo"}),
    ("de", "stell die Kiste zur Rampe", {"thing": "kiste", "place": "Rampe"}),
    ("fr", "pose le verre au bar", {"thing": "verre", "place": "bar"}),
    ("fr", "pose du pain", {"thing": "pain"}),
    ("fr", "pose le jus du frigo", {"thing": "jus du frigo"}),
    ("es", "lleva la caja al almacén", {"thing": "caja", "place": "almacén"}),
    ("it", "porta la tazza all'ingresso", {"thing": "tazza", "place": "ingresso"}),
]
NOTHING = [
    ("de", "fahr zum Keller"), ("de", "fahr im Tor"), ("de", "zum Tor"), ("de", "fahr nicht zum Tor"),
    ("de", "ich fahr zum Tor"), ("fr", "va du bar"), ("fr", "ne va pas au bar"), ("es", "ve del bar"),
    ("es", "no vayas al bar"), ("it", "vai dal bar"), ("it", "non andare al bar"),
]  # fmt: skip


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    def engine(language: str) -> IntentEngine:
        places = {name: (float(number), 0.0) for number, name in enumerate(PLACES[language])}
        return engine_of(GRAMMAR.format(language=language, **WORDS[language]), locations=places)

    return {language: engine(language) for language in WORDS}


@pytest.mark.parametrize(("language", "said", "place"), PLACE)
def test_a_place_is_named_behind_it(engines, language: str, said: str, place: str) -> None:
    found = engines[language].parse(said)
    assert dict(found.slots) == {"place": place}, found.reason


@pytest.mark.parametrize(("language", "said", "slots"), OTHERS)
def test_so_are_values_and_what_stands_behind_a_thing(engines, language: str, said: str, slots: dict[str, str]) -> None:
    assert dict(engines[language].parse(said).slots) == slots


@pytest.mark.parametrize(("language", "said"), NOTHING)
def test_nothing_else_is_understood_by_it(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


def test_a_forbidden_way_stops_what_moves(engines) -> None:
    assert done(engines["de"].parse("fahr nicht zur Rampe", state=("moving",))) == "stop"


def test_it_begins_a_sentence(engines) -> None:
    assert engines["it"].prefix("vai all'").status is PrefixStatus.INCOMPLETE
    assert engines["es"].prefix("ve al").status is PrefixStatus.INCOMPLETE


def test_a_value_may_hold_the_word_itself(engine_of) -> None:
    text = (
        "language: es\nslots: {place: location, side: {type: choice, values: {north: al norte}}}\n"
        "intents:\n  turn: {action: custom, sentences: ['gira {side}']}\n"
        "  face: {action: custom, sentences: ['gira a {place}']}\n"
    )
    engine = engine_of(text, locations={"bar": (1.0, 2.0)})
    assert engine.parse("gira al norte").slots == {"side": "north"}
    assert engine.parse("gira al bar").slots == {"place": "bar"}


@pytest.mark.parametrize(
    ("language", "take", "said", "thing"),
    [
        ("fr", "prends (le|la|un)", "prends le au bar", None),
        ("fr", "prends (le|la|un)", "prends-le au bar", None),
        ("fr", "prends (le|la|un)", "prends le jus du bar", "jus du bar"),
        ("de", "nimm", "nimm zum Tor", None),
        ("es", "coge", "coge al bar", None),
        ("it", "prendi", "prendi al bar", None),
        ("it", "prendi", "prendi del pane", "del pane"),
    ],
)
def test_no_thing_begins_with_it(engine_of, language: str, take: str, said: str, thing: str | None) -> None:
    engine = engine_of(
        f"language: {language}\nslots: {{thing: object}}\n"
        f'intents: {{take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{take} {{thing}}"]}}}}\n'
    )
    assert [action.object for action in engine.parse(said).actions] == ([thing] if thing else [])
