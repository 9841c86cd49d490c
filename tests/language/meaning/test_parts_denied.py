""" "Not the kitchen", said to a robot that was told to go there."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine
from intent_engine.actions import Navigate, Turn

SENTENCES = {
    "en": ("go to the {location}", "turn {direction}", "left", "right"),
    "de": ("fahr zum {location}", "dreh dich nach {direction}", "links", "rechts"),
    "es": ("ve al {location}", "gira a la {direction}", "izquierda", "derecha"),
    "fr": ("va au {location}", "tourne à {direction}", "gauche", "droite"),
    "it": ("vai al {location}", "gira a {direction}", "sinistra", "destra"),
}
BAR, GARAGE = Navigate("bar", 1.0, 2.0, 0.0, "map"), Navigate("garage", 3.0, 4.0, 0.0, "map")


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    text = """
language: {}
slots:
  location: location
  direction: {{type: choice, values: {{left: [{}], right: [{}]}}}}
intents:
  go: {{action: navigate, sentences: ["{}"]}}
  turn: {{action: turn, sentences: ["{}"]}}
"""
    places = {"bar": (1.0, 2.0), "garage": (3.0, 4.0)}
    return {
        language: engine_of(text.format(language, left, right, go, turn), locations=places)
        for language, (go, turn, left, right) in SENTENCES.items()
    }


@pytest.mark.parametrize(
    ("language", "done", "said", "denied"),
    [
        ("en", "go to the bar", "not the bar", (BAR,)),
        ("en", "go to the bar", "no, not to the bar!", (BAR,)),
        ("en", "go to the bar", "not the garage", (GARAGE,)),
        ("en", "turn left, then go to the bar", "not the bar", (BAR,)),
        ("en", "go to the bar", "not the bar, the weather is bad", (BAR,)),
        ("en", "go to the bar", "not the moon", ()),
        ("en", "go to the bar", "the bar", ()),
        ("en", "go to the bar", "it is not the bar", ()),
        ("de", "fahr zum bar", "nicht zum bar", (BAR,)),
        ("es", "ve al bar", "no al bar", (BAR,)),
        ("fr", "va au bar", "pas au bar", (BAR,)),
        ("it", "vai al bar", "non al bar", (BAR,)),
    ],
)
def test_what_is_named_is_denied(engines, language, done, said, denied):
    engine = engines[language]
    assert engine.parse(said, last=engine.parse(done)).denied == denied


@pytest.mark.parametrize(
    ("language", "done", "said"),
    [
        ("en", "turn left", "not left"),
        ("de", "dreh dich nach links", "nicht nach links"),
        ("es", "gira a la izquierda", "no a la izquierda"),
        ("fr", "tourne à gauche", "pas à gauche"),
        ("it", "gira a sinistra", "non a sinistra"),
    ],
)
def test_a_side_is_denied(engines, language, done, said):
    engine = engines[language]
    turn = engine.parse(done)
    (denied,) = engine.parse(said, last=turn).denied
    assert isinstance(denied, Turn)
    assert (denied,) == turn.actions


def test_nothing_is_known_of_before(engines):
    assert engines["en"].parse("not the bar").denied == ()


@pytest.fixture(scope="module")
def kiosk(engine_of) -> IntentEngine:
    return engine_of("""
language: en
slots:
  drink: [tea, latte]
  item: {type: object, max_words: 2}
  part: [grinder, counter]
intents:
  order: {action: custom, sentences: ["order a {drink}"], then: ["a {drink}"]}
  fetch: {action: {type: pick, object: "{item}"}, sentences: ["fetch {item}"], then: ["(the|a) {item}"]}
  clean: {action: custom, sentences: ["clean the {part}"]}
""")


@pytest.mark.parametrize(
    ("texts", "said", "denied"),
    [
        (["order a tea"], "not the tea", "order a tea"),
        (["order a tea"], "not a tea", "order a tea"),
        (["order a tea and a latte"], "not the latte", "order a latte"),
        (["order a tea", "and a latte"], "no, not the latte", "order a latte"),
        (["fetch the cup and the plate"], "not the plate", "fetch plate"),
        (["fetch the cup and the plate"], "not the cup", "fetch cup"),
        (["fetch the cup", "and the plate"], "not the plate", "fetch plate"),
        (["fetch the cup and the plate"], "not the smile", ""),
        (["fetch the cup"], "not the smile", ""),
        (["clean the grinder and the counter"], "not the counter", "clean the counter"),
    ],
)
def test_what_was_added_is_denied_and_what_was_told_of_with_another_article(kiosk, texts, said, denied):
    last = ()
    for text in texts:
        last = kiosk.parse(text, last=last)
        assert last.actions
    found = kiosk.parse(said, last=last)
    assert found.denied == (kiosk.parse(denied).actions if denied else ())
    assert not found.actions


@pytest.mark.parametrize(
    ("done", "said", "denied"),
    [
        ("order a tea", "don't order it", "order a tea"),
        ("order a tea", "no, never order that", "order a tea"),
        ("order a tea and a latte", "don't order them", "order a tea and a latte"),
        ("clean the grinder", "don't clean it", "clean the grinder"),
        ("clean the grinder", "don't order it", ""),
        ("clean the grinder", "don't clean it up so often", ""),
        ("clean the grinder", "don't worry", ""),
    ],
)
def test_what_was_told_is_denied_by_its_verb(kiosk, done, said, denied):
    found = kiosk.parse(said, last=kiosk.parse(done))
    assert found.denied == (kiosk.parse(denied).actions if denied else ())
    assert not found.actions


@pytest.mark.parametrize(
    ("language", "done", "said"),
    [("de", "nimm {}", "nimm sie nicht"), ("fr", "prends {}", "ne la prends pas"), ("es", "toma {}", "no la tomes")],
)
def test_it_is_in_other_languages(engine_of, language, done, said):
    engine = engine_of(f"""
language: {language}
slots: {{thing: {{type: object, max_words: 2}}}}
intents: {{take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{done.format("{thing}")}"]}}}}
""")
    last = engine.parse(done.format({"de": "die Tasse", "fr": "la tasse", "es": "la taza"}[language]))
    assert engine.parse(said, last=last).denied == last.actions != ()
