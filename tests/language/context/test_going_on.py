"""What goes on with a command in a text of its own: "and Ben", after "wave to Anna"."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status

GRAMMAR = """
language: en
slots:
  person: [Anna, Ben, Lucy, Tom]
  n: {type: number, min: 1, max: 600, whole: true}
  time: duration
intents:
  wave: {action: custom, sentences: ["wave to {person}"], then: ["[to] {person}"]}
  unlock: {action: custom, sentences: ["unlock drawer {n}"]}
  heat: {action: custom, sentences: ["heat plate {n} for {time}"]}
  go: {action: custom, sentences: ["go to bay {n}"], then: ["to bay {n}"]}
  shout: {action: custom, sentences: [shout]}
  undock: {action: custom, requires: [docked], sentences: ["leave dock {n}"]}
"""


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(GRAMMAR)


def said_one_by_one(engine: IntentEngine, *texts: str) -> Interpretation:
    """What the last of several texts means, each understood behind the one before."""
    return reduce(lambda last, text: engine.parse(text, last=last), texts[1:], engine.parse(texts[0]))


def values(found: Interpretation) -> list[object]:
    return [next(iter(action.slots.values())) for action in found.actions]


@pytest.mark.parametrize(
    ("texts", "added"),
    [
        (("wave to Anna", "and Ben"), ["Ben"]),
        (("wave to Anna", "and also to Ben"), ["Ben"]),
        (("wave to Anna", "and then Ben and Lucy"), ["Ben", "Lucy"]),
        (("wave to Anna", "and Ben", "and Lucy"), ["Lucy"]),
        (("wave to Anna and Ben", "and Lucy"), ["Lucy"]),
        (("unlock drawer 3", "and 4"), [4]),
        (("unlock drawer 3", "and drawer 4"), [4]),
        (("unlock drawer 3", "and 4", "and 5 and 7"), [5, 7]),
    ],
)
def test_only_what_is_added_is_done(engine: IntentEngine, texts: tuple[str, ...], added: list[object]) -> None:
    found = said_one_by_one(engine, *texts)
    assert (values(found), found.goes_on) == (added, True)
    assert found.text == " ".join(texts)
    assert len(found.needs) == len(found.actions)


@pytest.mark.parametrize("text", ["Ben too", "Ben, too!", "to Ben as well", "and Ben as well", "also Ben", "now Ben"])
def test_what_is_done_besides_goes_on_without_a_joint(engine: IntentEngine, text: str) -> None:
    found = said_one_by_one(engine, "wave to Anna", text)
    assert (values(found), found.goes_on) == (["Ben"], True)
    assert values(engine.parse("and Lucy", last=found)) == ["Lucy"]


@pytest.mark.parametrize(
    ("before", "text"),
    [
        ("wave to Anna", "and Ben?"),
        ("wave to Anna", "Ben too?"),
        ("wave to Anna", "now Ben?"),
        ("wave to Anna", "now Ben is late"),
        ("wave to Anna", "now not Ben"),
        ("wave to Anna", "me too"),
        ("wave to Anna", "too"),
        ("wave to Anna", "not Ben too"),
        ("wave to Anna", "no, Ben too"),
        ("wave to Anna", "Ben waved too"),
        ("wave to Anna", "Ben"),
        ("wave to Anna", "Ben and Lucy"),
        ("wave to Anna", "and"),
        ("wave to Anna", "and 4"),
        ("wave to Anna", "and not Ben"),
        ("wave to Anna", "or Ben"),
        ("wave to Anna", "and Ben or Lucy"),
        ("wave to Anna", "no, and Ben"),
        ("shout", "and Ben"),
        ("unlock drawer 3", "and Ben"),
        ("unlock drawer 3", "and a half"),
        ("unlock drawer 3", "and 3"),
        ("unlock drawer 20", "and 4"),
        ("unlock drawer 100", "and 4"),
        ("heat plate 3 for ten seconds", "and 4"),
        ("stop", "and Ben"),
        ("wave to Anna", "and Ben and shout"),
        ("go to bay 100", "and 4 and to bay 7"),
    ],
)
def test_nothing_goes_on_where_it_is_not_sure(engine: IntentEngine, before: str, text: str) -> None:
    found = engine.parse(text, last=engine.parse(before))
    assert (found.actions, found.goes_on) == ((), False)


def test_what_is_spoken_or_has_nothing_before_it_is_no_command(engine: IntentEngine) -> None:
    last = engine.parse("wave to Anna")
    assert not engine.parse("and Ben", last=last, heard=True).actions
    assert not engine.parse("and Ben", last=last, spoken=True).actions
    assert not engine.parse("and Ben", last=last.actions).actions
    assert not engine.parse("and Ben", last=()).actions
    assert not engine.parse("and Ben").actions


def test_a_command_by_itself_is_that_one(engine: IntentEngine) -> None:
    found = engine.parse("and shout", last=engine.parse("wave to Anna"))
    assert [action.name for action in found.actions] == ["shout"]
    assert not found.goes_on


def test_nothing_goes_on_from_a_question_or_from_another_text(engine: IntentEngine) -> None:
    last = engine.parse("wave to Anna")
    asked = engine.parse("unlock drawer", last=last)
    assert asked.question is not None
    assert not engine.parse("and Ben", last=asked).actions
    assert not engine.parse("and Ben", last=replace(last, actions=engine.parse("shout").actions)).actions


def test_what_the_states_forbid_does_not_go_on(engine: IntentEngine) -> None:
    last = engine.parse("leave dock 3", state=["docked"])
    assert engine.parse("and 4", last=last, state=["docked"]).actions
    assert not engine.parse("and 4", last=last).actions


names = st.lists(st.sampled_from(("Anna", "Ben", "Lucy", "Tom")), min_size=2, max_size=4, unique=True)
drawers = st.lists(st.integers(1, 600), min_size=2, max_size=4, unique=True).map(sorted)


@settings(max_examples=100, deadline=None, derandomize=True)
@given(names.map(lambda found: ("wave to", found)) | drawers.map(lambda found: ("unlock drawer", found)))
def test_one_by_one_is_the_same_as_in_one_sentence(engine: IntentEngine, listed) -> None:
    verb, found = listed
    texts = [f"{verb} {found[0]}", *(f"and {one}" for one in found[1:])]
    last, done = None, []
    for text in texts:
        last = engine.parse(text, last=last)
        assert last.status is Status.ACCEPTED, (text, last.reason)
        done += last.actions
    assert tuple(done) == engine.parse(" ".join(texts)).actions


PARTED = {
    "de": """
language: de
slots: {raum: [Küche, Flur, Bad], gerät: [Pumpe, Lampe], anteil: percent}
intents:
  licht: {action: custom, sentences: ["mach das Licht (in der|im) {raum} an"]}
  ein: {action: custom, sentences: ["schalte die {gerät} ein"]}
  dimmen: {action: custom, sentences: ["dimme das Licht (in der|im) {raum} auf {anteil}"]}
""",
    "en": """
language: en
slots: {device: [fan, pump, lamp]}
intents:
  "on": {action: custom, sentences: ["turn the {device} on"]}
  "off": {action: custom, sentences: ["turn the {device} off"]}
""",
}


@pytest.mark.parametrize(
    ("language", "texts", "added"),
    [
        ("de", ("mach das Licht in der Küche an.", "und im Flur"), ["Flur"]),
        ("de", ("Mach das Licht in der Küche an", "und im Flur", "und im Bad."), ["Bad"]),
        ("de", ("schalte die Pumpe ein", "und die Lampe"), ["Lampe"]),
        ("en", ("turn the fan on", "and the pump", "and the lamp"), ["lamp"]),
        ("de", ("mach das Licht in der Küche an", "und in der Küche"), []),
        ("de", ("mach das Licht in der Küche an", "und die Pumpe"), []),
        ("de", ("mach das Licht in der Küche an", "oder im Flur"), []),
        ("de", ("mach das Licht in der Küche an", "und nicht im Flur"), []),
        ("de", ("dimme das Licht im Flur auf 20 Prozent", "und im Bad"), []),
        ("en", ("turn the fan on", "the pump"), []),
    ],
)
def test_a_word_that_ends_the_sentence_ends_what_is_added(engine_of, language, texts, added) -> None:
    found = said_one_by_one(engine_of(PARTED[language]), *texts)
    assert (values(found), found.goes_on) == (added, bool(added))


def test_what_ends_otherwise_is_another_command(engine_of) -> None:
    engine = engine_of(PARTED["en"])
    found = said_one_by_one(engine, "turn the fan on", "and the pump off")
    assert found.actions == engine.parse("turn the pump off").actions != ()
