"""What is said after "never mind" and a pause is wanted; and words that join sentences may stand together."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine

GRAMMAR = """
language: en
slots:
  place: [lab, ward]
intents:
  go: {action: custom, sentences: ["go to the {place}"]}
  open: {action: custom, sentences: ["open the drawer"]}
  drop: {action: custom, sentences: ["drop it"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def names(engine: IntentEngine, said: str) -> list[str]:
    return [action.name for action in engine.parse(said).actions]


@pytest.mark.parametrize(
    "said",
    [
        "never mind, go to the lab",
        "forget it, go to the lab please",
        "cancel that. Go to the lab.",
        "never mind, forget it, go to the lab",
        "uh never mind, go to the lab",
    ],
)
def test_a_command_after_never_mind_is_done(engine: IntentEngine, said: str) -> None:
    assert names(engine, said) == ["go"]


@pytest.mark.parametrize(
    "said",
    [
        "never mind the lab",
        "never mind go to the lab",
        "don't, go to the lab",
        "no don't, go to the lab",
        "never mind, don't go to the lab",
        "never mind, did you go to the lab",
        "never, go to the lab",
        "go to the lab, never mind",
        "never mind, ",
    ],
)
def test_what_may_be_forbidden_is_not_done(engine: IntentEngine, said: str) -> None:
    assert names(engine, said) == []


def test_what_is_a_command_itself_cancels_nothing(engine: IntentEngine) -> None:
    assert names(engine, "drop it, go to the lab") == ["drop", "go"]


@pytest.mark.parametrize(
    "joint",
    ["and once you are there", "and then after that", "then when you get there", "and when you are done", "and then"],
)
def test_words_that_join_may_stand_together(engine: IntentEngine, joint: str) -> None:
    assert names(engine, f"go to the lab {joint} open the drawer") == ["go", "open"]


# -- where "never mind" is a sentence of the stop intent ---------------------------------------------------------


@pytest.fixture(scope="module")
def shipped(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars" / "en.yaml", locations=root / "locations" / "home.yaml")


@pytest.mark.parametrize("cancelled", ["never mind", "Nevermind", "forget it", "oh forget that"])
@pytest.mark.parametrize("state", [(), ("moving",)])
@pytest.mark.parametrize("wanted", ["turn right", "go back", "go to the kitchen and pick up the cup"])
def test_what_is_wanted_instead_is_done_instead(shipped, cancelled, state, wanted) -> None:
    assert shipped.parse(f"{cancelled}, {wanted}", state=state).actions == shipped.parse(wanted).actions
    assert shipped.parse(f"{cancelled}, stop", state=state).stops


@pytest.mark.parametrize("behind", [", it rains", ", don't go there", " turn right", " the kitchen", ", "])
def test_and_a_robot_that_moves_stops_whatever_is_behind_it(shipped, behind) -> None:
    assert shipped.parse(f"never mind{behind}", state=["moving"]).stops
    if behind != ", ":
        assert not shipped.parse(f"never mind{behind}").actions
