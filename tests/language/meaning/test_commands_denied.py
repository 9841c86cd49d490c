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
        ("de", "reinige das Labor nicht", CLEAN_LAB),
        ("fr", "ne nettoie pas le labo", CLEAN_LAB),
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


def test_what_is_wanted_instead_is_done(engines):
    found = engines["en"].parse("don't clean the lab, clean the hall")
    assert found.actions == (Custom("clean", {"room": "hall"}),)


def test_it_is_no_part_of_the_json_form(engines):
    found = engines["en"].parse("don't clean the lab")
    assert Interpretation.from_json(found.to_json()) == found
    assert Interpretation.from_json(found.to_json()).denied == ()
