"""A correction that says several things again: nothing said before is lost, and what is unclear is not done."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine import IntentEngine, Status

GRAMMAR = """
language: en
slots:
  count: {type: number, min: 1, max: 50}
  vessel: [cups, jars, tins]
  content: [tea, honey, salt]
  shelf: {type: number, min: 1, max: 20}
  time: duration
  word: text
intents:
  fetch: {action: custom, sentences: ["fetch {count} {vessel} [of {content}]"]}
  dust: {action: custom, sentences: ["dust shelf {shelf} [for {time}]"]}
  spell: {action: custom, sentences: ["spell {word} {count} times"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("fetch two cups of tea, no, three jars of honey", {"count": 3, "vessel": "jars", "content": "honey"}),
        ("fetch two cups of tea, no, three jars", {"count": 3, "vessel": "jars", "content": "tea"}),
        ("fetch two cups of tea, I mean jars of salt", {"count": 2, "vessel": "jars", "content": "salt"}),
        ("fetch two cups, no, three jars of honey", {"count": 3, "vessel": "jars", "content": "honey"}),
        ("fetch two cups, no, three, no, four jars of salt", {"count": 4, "vessel": "jars", "content": "salt"}),
        ("dust shelf four, no, five for ten minutes", {"shelf": 5, "time": 600}),
        ("dust shelf four for ten minutes, no, shelf five", {"shelf": 5, "time": 600}),
        ("dust shelf four for ten minutes, no, shelf five for six minutes", {"shelf": 5, "time": 360}),
        ("dust shelf four, no, dust shelf five", {"shelf": 5}),
        ("spell tea two times, no, honey three times", {"word": "honey", "count": 3}),
        ("spell tea two times, no, honey", {"word": "honey", "count": 2}),
        ("spell tea two times, no, three times", {"word": "tea", "count": 3}),
    ],
)
def test_several_values_are_corrected_at_once(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    found = engine.parse(said)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.slots == slots


@pytest.mark.parametrize(
    "said",
    [
        "fetch two cups of tea, no, honey jars",  # in no order that the grammar has
        "dust shelf four, no, ten minutes",  # the shelf would be lost, or there would be none
        "dust shelf four for ten minutes, no, five",  # of what?
        "fetch two cups of tea, no, shelf five for ten minutes",
        "fetch two cups of tea, no, three jars of sand",
    ],
)
def test_what_is_not_clear_is_not_done(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).actions == ()


FREE = """
language: en
slots:
  thing: {type: text, max_words: 5, known: [cup, box, bottle]}
  whom: {type: text, max_words: 2}
intents:
  give: {action: custom, sentences: ["(give|bring) {thing} (to|from) {whom}", "(give|bring) the {thing:gift} at once"]}
"""
NAMES = st.sampled_from(["cup", "box", "bottle", "red cup"])
PEOPLE = st.sampled_from(["Anna", "Tom", "the nurse", "my boss"])


@given(NAMES, PEOPLE, NAMES, PEOPLE, st.sampled_from(["to", "from"]), st.sampled_from([", no, ", " no ", ", sorry, "]))
def test_what_is_said_again_as_it_was_takes_the_place_of_all(engine_of, one, who, other, whom, joint, no):
    engine = engine_of(FREE)
    found = engine.parse(f"bring the {one} {joint} {who}{no}the {other} {joint} {whom}")
    meant = engine.parse(f"bring the {other} {joint} {whom}").actions
    assert len(meant) == 1
    assert found.actions == meant


@given(NAMES, PEOPLE, NAMES, PEOPLE)
def test_where_other_words_are_between_nobody_knows(engine_of, one, who, other, whom):
    """It may be the box from Tom that is to be brought, to Anna."""
    engine = engine_of(FREE)
    assert not engine.parse(f"bring the {one} to {who}, no, the {other} from {whom}").actions


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("bring the cup to Anna, no, the box", "bring the box to Anna"),
        ("bring the cup to Anna, no, to Tom", "bring the cup to Tom"),
        ("bring the cup to Anna, no, the box on the table", "bring the box on the table to Anna"),
    ],
)
def test_what_is_left_out_stays(engine_of, said, meant):
    engine = engine_of(FREE)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()
