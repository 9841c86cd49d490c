"""Of two lists that stand as alternatives a name is looked for in both, also where it is not said as it is written."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  reagent: [ethanol, the blue dye, sodium chloride]
  tool: [beaker, flask, the long tongs]
  place: location
phrases:
  thing: ({tool:thing}|{reagent:thing})
intents:
  one: {action: custom, sentences: ["weigh the {reagent:thing}", "lift {tool:thing}"]}
  shake: {action: custom, sentences: ["shake the ({tool:thing}|{reagent:thing})"]}
  take: {action: custom, sentences: ["take ({tool:thing}|{reagent:thing})"]}
  within: {action: custom, sentences: ["clean the {thing} (twice|well)", "use {thing}"]}
  go: {action: custom, sentences: ["go to the ({place}|{tool})"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR, locations={"sink": (1.0, 2.0), "fume hood": (3.0, 4.0)})


@given(
    st.sampled_from(["shake the {}", "take {}", "take the {}", "clean the {} twice", "use {}", "use the {}"]),
    st.sampled_from(["ethanol", "blue dye", "beaker", "flask", "sodium chloride", "long tongs"]),
)
def test_a_name_without_its_article_is_that_of_either(engine: IntentEngine, say: str, name: str) -> None:
    found = engine.parse(say.format(name))
    assert found.status is Status.ACCEPTED, found.reason
    assert str(found.slots["thing"]).removeprefix("the ") == name


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("shake the ethanoll", {"thing": "ethanol"}),
        ("shake the beeker", {"thing": "beaker"}),
        ("go to the fume hod", {"place": "fume hood"}),
        ("go to the flasks", {"tool": "flask"}),
    ],
)
def test_a_misspelled_name_is_the_nearest_of_both(engine: IntentEngine, said: str, slots: dict[str, str]) -> None:
    assert engine.parse(said).slots == slots


@pytest.mark.parametrize("said", ["shake the table", "use blue", "go to the moon", "take sodium and chloride"])
def test_what_neither_has_is_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
