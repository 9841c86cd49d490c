"""Behind a way "back" may be backward, or the way back: it is asked about, unless more is said."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import done, german, shipped

from intent_engine import IntentEngine, Status

WAYS = st.sampled_from(
    ["go to the kitchen", "drive to the dock", "go forward two meters", "move forward for two seconds"]
)
JOINTS = st.sampled_from([" and ", ", ", " and then ", ", then "])


@given(WAYS, JOINTS, st.sampled_from(["back", "go back", "drive back", "please go back"]))
def test_back_behind_a_way_is_asked_about(way: str, joint: str, back: str) -> None:
    found = shipped().parse(f"{way}{joint}{back}")
    assert found.status is Status.AMBIGUOUS, found
    assert not found.actions


ERRANDS = st.sampled_from(
    [
        "take the cup to the kitchen",
        "deliver the mail",
        "ferry the cup to the garage",
        "bring the cup to the office",
        "put the cup on the table",
        "pick up the cup from the table",
        "follow me",
    ]
)
OWN = """
language: en
include: [en]
slots:
  item: {type: text, max_words: 3}
  location: {type: location}
  spot: [kitchen, garage]
intents:
  carry: {action: {type: custom, item: "{item}", to: "{location}"}, sentences: ["take the {item} to the {location}"]}
  ferry: {action: custom, sentences: ["ferry the {item} to the {spot}"]}
  deliver: {action: custom, sentences: ["deliver the mail"]}
"""


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    path = tmp_path_factory.mktemp("own") / "own.yaml"
    path.write_text(OWN)
    return IntentEngine.from_files(path, locations="home")


@given(
    ERRANDS,
    JOINTS,
    st.sampled_from(["", "turn around and ", "turn left, turn right, "]),
    st.sampled_from(["back", "go back", "back again"]),
)
def test_so_it_is_behind_what_may_have_gone_somewhere(
    own: IntentEngine, errand: str, joint: str, turns: str, back: str
) -> None:
    found = own.parse(f"{errand}{joint}{turns}{back}")
    assert found.status in (Status.AMBIGUOUS, Status.REJECTED), found
    assert not found.actions


@given(ERRANDS, st.sampled_from([" and ", " and then "]))
def test_what_says_more_behind_an_errand_is_done(own: IntentEngine, errand: str, joint: str) -> None:
    assert done(own.parse(f"{errand}{joint}go back one meter")).endswith("back 1")
    assert done(own.parse(f"{errand}{joint}go back to the bedroom")).endswith("to bedroom")
    assert done(own.parse(f"{errand}{joint}come back")).endswith("come")


@given(WAYS, JOINTS, st.sampled_from(["back up", "go backward", "go back one meter", "go back to the bedroom"]))
def test_what_says_more_is_done(way: str, joint: str, back: str) -> None:
    assert len(shipped().parse(f"{way}{joint}{back}").actions) == 2


@pytest.mark.parametrize("said", ["go forward and back", "turn left and go back", "left, back", "forward then back"])
def test_behind_what_goes_nowhere_in_particular_it_is_backward(said: str) -> None:
    assert done(shipped().parse(said)).endswith("back 0.6")


@pytest.mark.parametrize("said", ["fahr in die Küche und zurück", "fahr zwei Meter vor und dann wieder zurück"])
def test_in_german(said: str) -> None:
    assert not german().parse(said).actions
