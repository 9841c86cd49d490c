"""How often, and how far apart: "every hour" is every one hour."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

SAMPLER = """
language: {language}
slots:
  often: {{type: duration}}
  apart: {{type: distance}}
  thing: {{type: object}}
intents:
  sample: {{action: custom, sentences: ["sample {each} {{often}} [now]", "photo {each} {{apart}}"]}}
  find: {{action: custom, sentences: ["find {{thing}}"]}}
"""


@pytest.fixture(scope="module")
def sampler(engine_of) -> IntentEngine:
    return engine_of(SAMPLER.format(language="en", each="every"))


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("sample every minute", {"often": 60.0}),
        ("please sample every hour now", {"often": 3600.0}),
        ("sample every two minutes", {"often": 120.0}),
        ("photo every meter", {"apart": 1.0}),
        ("sample every other hour", {"often": 7200.0}),
        ("please sample every other minute now", {"often": 120.0}),
        ("photo every other meter", {"apart": 2.0}),
        ("find every other meter", {"thing": "every other meter"}),
        ("find every meter", {"thing": "every meter"}),
    ],
)
def test_a_unit_behind_every_is_one_of_it(sampler, said, slots) -> None:
    assert sampler.parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    ["sample every second minute", "sample every other, hour", "sample other hour", "sample every, hour",
     "sample hour",
     "do not sample every hour", "sample every hour or two", "he samples every hour",
     "don't sample every other hour", "sample every other other hour"],
)  # fmt: skip
def test_what_is_no_every_one(sampler, said) -> None:
    assert not sampler.parse(said).actions


@pytest.mark.parametrize(
    ("language", "each", "said"),
    [("es", "cada", "cada hora"), ("it", "ogni", "ogni ora"), ("fr", "toutes les", "toutes les heures")],
)
def test_other_languages(engine_of, language, each, said) -> None:
    assert engine_of(SAMPLER.format(language=language, each=each)).parse(f"sample {said}").slots == {"often": 3600.0}
