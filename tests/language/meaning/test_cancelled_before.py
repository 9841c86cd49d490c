"""What is said after "never mind" and a pause is wanted; and words that join sentences may stand together."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import does, german, shipped

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


@pytest.mark.parametrize("cancelled", ["never mind", "Nevermind", "forget it", "oh forget that"])
@pytest.mark.parametrize("state", [(), ("moving",)])
@pytest.mark.parametrize("wanted", ["turn right", "go back", "go to the kitchen and pick up the cup"])
def test_what_is_wanted_instead_is_done_instead(cancelled, state, wanted) -> None:
    assert shipped().parse(f"{cancelled}, {wanted}", state=state).actions == shipped().parse(wanted).actions
    assert shipped().parse(f"{cancelled}, stop", state=state).stops


@pytest.mark.parametrize("behind", [", it rains", ", don't go there", " turn right", " the kitchen", ", "])
def test_and_a_robot_that_moves_stops_whatever_is_behind_it(behind) -> None:
    assert shipped().parse(f"never mind{behind}", state=["moving"]).stops
    if behind != ", ":
        assert not shipped().parse(f"never mind{behind}").actions


# -- what was said before it, in the same breath -----------------------------------------------------------------

TAKEN_BACK = [
    "turn left",
    "go to the kitchen",
    "pick up the cup",
    "go forward two meters, then turn left",
    "turn",
    "go to",
]
WANTED = ["turn right", "go back two meters", "go to the bedroom, then pick up the ball", "bring me the cup"]
GERMAN = {
    "taken back": ["fahr vorwärts", "dreh dich nach links", "nimm den Becher", "fahr in"],
    "wanted": ["fahr zurück", "dreh dich nach rechts und nimm den Ball"],
}


@given(
    st.sampled_from(TAKEN_BACK),
    st.sampled_from([", ", ". ", " - ", ", no, ", ", uh, ", ", and then "]),
    st.sampled_from(["never mind", "forget it", "cancel that", "never mind, forget that", "just kidding"]),
    st.sampled_from(WANTED),
    st.sampled_from([(), ("moving",)]),
)
def test_only_what_follows_is_done(before: str, pause: str, cancel: str, wanted: str, state: tuple[str, ...]) -> None:
    assert does(f"{before}{pause}{cancel}, {wanted}", *state) == does(wanted)
    assert does(f"{before}{pause}{cancel}, {before}, {cancel}, {wanted}", *state) == does(wanted)


@given(st.sampled_from(GERMAN["taken back"]), st.sampled_from(GERMAN["wanted"]))
def test_only_what_follows_is_done_in_german(before: str, wanted: str) -> None:
    assert german().parse(f"{before}, vergiss es, {wanted}").actions == german().parse(wanted).actions != ()


@pytest.mark.parametrize(
    ("said", "done"),
    [
        ("go to the lab never mind, open the drawer", ["open"]),
        ("go to the lab, drop it, open the drawer", ["go", "drop", "open"]),
        # Nothing tells what is wanted, or who said it.
        ("go to the lab, never mind open the drawer", []),
        ("go to the lab, never mind, the ward", []),
        ("go to the lab, never mind, don't open the drawer", []),
        ("go to the lab, never mind, did you open the drawer", []),
        ("she went to the lab, never mind, open the drawer", []),
        ("if you go to the lab, never mind, open the drawer", []),
        ("go never mind, open the drawer", []),
    ],
)
def test_what_is_taken_back_are_commands(engine: IntentEngine, said: str, done: list[str]) -> None:
    assert names(engine, said) == done
