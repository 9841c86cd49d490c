"""What a command that was negated says not to do: a robot that does it has to stop."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine
from intent_engine.actions import Custom, Pick
from intent_engine.interpretation import Interpretation, Status

GRAMMARS = {
    "en": ("clean the {room}", "take the {thing}", {"lab": "lab", "hall": "hall"}),
    "de": ("reinige {room}", "nimm {thing}", {"lab": "das Labor", "hall": "die Halle"}),
    "fr": ("nettoie {room}", "prends {thing}", {"lab": "le labo", "hall": "le hall"}),
    "es": ("limpia {room}", "coge {thing}", {"lab": "el laboratorio", "hall": "el pasillo"}),
    "it": ("pulisci {room}", "prendi {thing}", {"lab": "il laboratorio", "hall": "la sala"}),
}
CLEAN_LAB = Custom("clean", {"room": "lab"})


def grammar(language: str) -> str:
    clean, take, rooms = GRAMMARS[language]
    values = ", ".join(f"{name}: [{said}]" for name, said in rooms.items())
    return f"""
language: {language}
slots:
  room: {{type: choice, values: {{{values}}}}}
  thing: object
intents:
  clean: {{action: {{type: custom, name: clean}}, sentences: ["{clean}"]}}
  take: {{action: {{type: pick, object: "{{thing}}"}}, sentences: ["{take}"]}}
"""


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(grammar(language)) for language in GRAMMARS}


@pytest.mark.parametrize(
    ("language", "said", "denied"),
    [
        ("en", "don't clean the lab", CLEAN_LAB),
        ("en", "please do not clean the lab", CLEAN_LAB),
        ("en", "no, don't clean the lab please", CLEAN_LAB),
        ("en", "never clean the lab", CLEAN_LAB),
        ("en", "don't take the cup", Pick("cup")),
        ("en", "don't clean that lab", CLEAN_LAB),
        ("en", "don't clean up the lab", CLEAN_LAB),
        ("de", "reinige das Labor nicht", CLEAN_LAB),
        ("fr", "ne nettoie pas le labo", CLEAN_LAB),
        ("en", "you must not clean the lab", CLEAN_LAB),
        ("en", "I don't want you to clean the lab", CLEAN_LAB),
        ("en", "don't start cleaning the lab", CLEAN_LAB),
        ("de", "nicht das Labor reinigen", CLEAN_LAB),
        ("de", "das Labor bitte nicht reinigen", CLEAN_LAB),
        ("de", "reinigen Sie das Labor nicht", CLEAN_LAB),
        ("fr", "ne nettoyez pas le labo", CLEAN_LAB),
        ("fr", "ne pas nettoyer le labo", CLEAN_LAB),
        ("fr", "il ne faut pas nettoyer le labo", CLEAN_LAB),
        ("es", "no limpies el laboratorio", CLEAN_LAB),
        ("es", "no limpiar el laboratorio", CLEAN_LAB),
        ("es", "no limpien el laboratorio", CLEAN_LAB),
        ("es", "no debes limpiar el laboratorio", CLEAN_LAB),
        ("es", "no, no limpies el laboratorio", CLEAN_LAB),
        ("it", "non pulire il laboratorio", CLEAN_LAB),
        ("it", "non pulisca il laboratorio", CLEAN_LAB),
        ("it", "non devi pulire il laboratorio", CLEAN_LAB),
    ],
)
@pytest.mark.parametrize("state", [(), ("moving",)])
def test_a_whole_command_that_is_negated(engines, language, said, denied, state):
    found = engines[language].parse(said, state=state)
    assert (found.status, found.actions, found.denied) == (Status.REJECTED, (), (denied,))
    assert found.refuses


@pytest.mark.parametrize("said", ["clean the lab", "don't worry", "don't clean the moon", "don't", "clean the lab, no"])
def test_nothing_is_denied_by_anything_else(engines, said):
    assert engines["en"].parse(said).denied == ()


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "don't clean the lab, clean the hall"),
        ("en", "don't clean the lab but the hall"),
        ("en", "clean the hall, not the lab"),
        ("en", "clean the hall instead of the lab"),
        ("de", "reinige nicht das Labor, reinige die Halle"),
        ("es", "no limpies el laboratorio, limpia el pasillo"),
        ("it", "non pulire il laboratorio, pulisci la sala"),
    ],
)
def test_what_is_wanted_instead_is_done(engines, language, said):
    found = engines[language].parse(said)
    assert found.actions == (Custom("clean", {"room": "hall"}),)
    assert found.denied == (CLEAN_LAB,)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "no, clean the hall"),
        ("de", "nein, reinige die Halle"),
        ("fr", "non, nettoie le hall"),
        ("es", "no, limpia el pasillo"),
        ("es", "no no, limpia el pasillo"),
        ("it", "no, pulisci la sala"),
    ],
)
def test_a_no_before_a_pause_corrects(engines, language, said):
    found = engines[language].parse(said)
    assert (found.actions, found.denied) == ((Custom("clean", {"room": "hall"}),), ())


@pytest.mark.parametrize("said", ["no limpia el pasillo", "no no limpia el pasillo", "no, no limpia el pasillo"])
def test_in_one_breath_with_it_a_spanish_no_forbids(engines, said):
    assert not engines["es"].parse(said).actions


def test_it_is_no_part_of_the_json_form(engines):
    found = engines["en"].parse("don't clean the lab")
    assert Interpretation.from_json(found.to_json()) == found
    assert Interpretation.from_json(found.to_json()).denied == ()
