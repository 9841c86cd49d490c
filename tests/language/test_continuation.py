"""What may still be said after a command decides how long to wait for it."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from meanings import commands, shipped

from intent_engine import Status
from intent_engine.engine import PrefixStatus
from intent_engine.testing import sentences

SETTLED = [
    "turn left ninety degrees",
    "turn left 90 degrees",
    "rotate sixty degrees to the right",
    "go forward two meters",
    "go forward two meters slowly",
    "drive backward for ten seconds",
    "go to the kitchen",
    "please go to the kitchen",
    "go to the kitchen please",
    "turn left ninety degrees for me",
    "take me to the kitchen",  # and not "take {thing} ... from the table": "me" is nothing to take
]
OPEN = [
    "go forward for me",
    "turn left please",
    "turn left",
    "go forward",
    "stop turning and go forward",
    "turn left 90",  # "90 degrees", or "90, no, 19"
    "turn left one hundred",
    "pick up the cup",
    "bring me the red cup",
    "take the cup",
    "go forward two",
    "love",
]


@pytest.mark.parametrize("text", SETTLED)
def test_what_is_to_be_done_is_said(text: str) -> None:
    assert shipped().prefix(text).settled


@pytest.mark.parametrize("text", OPEN)
def test_more_may_be_said_of_what_is_to_be_done(text: str) -> None:
    assert not shipped().prefix(text).settled


@settings(max_examples=150, deadline=None)
@given(commands(), st.data())
def test_a_beginning_that_is_settled_says_the_same_as_the_whole_but_for_the_manner(
    command: str, data: st.DataObject
) -> None:
    engine = shipped()
    words = command.split()
    count = data.draw(st.integers(1, len(words)))
    beginning = " ".join(words[:count])
    if not engine.prefix(beginning).settled:
        return
    begun, whole = engine.parse(beginning), engine.parse(command)
    if begun.status is not Status.ACCEPTED or whole.status is not Status.ACCEPTED:
        return
    manner = {"speed", "turn_speed", "angular_speed"}
    said = {name: value for name, value in begun.slots.items() if name not in manner}
    later = {name: value for name, value in whole.slots.items() if name not in manner}
    assert begun.intent == whole.intent
    assert said.keys() == later.keys()


TIMER = """
language: en
slots: {length: duration, pace: {type: speed}}
intents:
  timer: {action: custom, sentences: ["(sleep|stay) [for] {length} [at {pace}]"]}
"""


@pytest.mark.parametrize(
    ("text", "resting"),
    [
        ("sleep for an hour", True),
        ("please sleep 1 hour", True),
        ("sleep for two hours", True),
        ("stay a minute", True),
        ("sleep for an hour and a half", False),
        ("sleep for ten minutes", False),
        ("sleep for half a minute", False),
        ("sleep for a quarter of an hour", False),
        ("sleep for two and a half hours", False),
        ("sleep for 2.5 hours", False),
        ("sleep for twenty one hours", True),
        ("sleep for twenty one minutes", False),
        ("sleep for an hour and twenty minutes", False),
        ("sleep for an hour at half speed", False),
        ("sleep for", False),
        ("sleep for an", False),
    ],
)
def test_people_rest_after_an_hour_and_go_on_with_a_half(engine_of, text: str, resting: bool) -> None:
    assert engine_of(TIMER).prefix(text).resting is resting


SLEEP = """
language: de
slots: {dauer: duration}
intents: {schlaf: {action: custom, sentences: ["schlaf {dauer}"]}}
"""


@pytest.mark.parametrize(
    ("text", "resting"),
    [
        ("schlaf eine Stunde", True),
        ("schlaf eine halbe Stunde", False),
        ("schlaf anderthalb Stunden", False),
        ("schlaf 2,5 Stunden", False),
    ],
)
def test_people_rest_after_an_hour_in_german(engine_of, text: str, resting: bool) -> None:
    assert engine_of(SLEEP).prefix(text).resting is resting


GRAMMAR = """
language: en
slots:
  pace: {type: speed}
intents:
  act:
    action: {type: custom, name: act}
    sentences:
      - "paint it [black]"
      - "polish it [at {pace}]"
"""


def test_what_may_follow_a_command_is_words_or_a_speed(engine_of) -> None:
    engine = engine_of(GRAMMAR)
    assert engine.prefix("paint it").status is PrefixStatus.EXTENDABLE
    assert engine.prefix("paint it").settled  # what is done is the same, black or not: it fills no slot
    assert engine.prefix("paint it black").settled
    assert engine.prefix("polish it").settled


ENDINGS = """
language: en
slots:
  topic: [history, travel]
  degrees: {type: number, min: 10, max: 30, whole: true}
  time: duration
  count: {type: number, min: 1, max: 9, whole: true}
  door: [front door, back door]
intents:
  guide: {action: custom, sentences: ["show me [the] {topic} [section [of the library]]"]}
  heat: {action: custom, sentences: ["set it to {degrees} [degrees]"]}
  expose: {action: custom, sentences: ["take {count} frames of {time} [each]"]}
  lift: {action: custom, sentences: ["(lift|pick up) the box"]}
  open: {action: {type: custom, name: open}, sentences: ["open the {door}"]}
  unlock: {action: {type: custom, name: unlock}, sentences: ["open the {door} with the key"]}
  spin: {action: custom, sentences: [turn]}
  look: {action: custom, sentences: ["turn around"]}
  call: {action: custom, sentences: ["call [(a|the)] (nurse|doctor) [to the {door}]"]}
  many: {action: custom, sentences: ["go now [(one|two|three) (four|five|six) (seven|eight|nine)]"]}
"""


@pytest.mark.parametrize(
    ("text", "settled"),
    [
        ("show me the history", True),
        ("show me the history section", True),
        ("set it to fourteen", True),
        ("set it to twenty", False),  # "five"
        ("take two frames of ten seconds", True),
        ("take two frames of ten", False),
        ("open the front door", False),  # "with the key" is another intent
        ("turn", False),  # and so is "around"
        ("call the nurse", False),
        ("pick up the box", True),
        ("go now", False),  # too many ways to say
    ],
)
def test_words_that_change_nothing_leave_a_command_settled(engine_of, text: str, settled: bool) -> None:
    engine = engine_of(ENDINGS)
    assert engine.parse(text).status is (Status.INCOMPLETE if text.endswith("of ten") else Status.ACCEPTED)
    assert engine.prefix(text).settled is settled


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_no_end_of_a_sentence_that_is_not_waited_for_would_change_what_is_done(engine_of, data) -> None:
    engine = engine_of(ENDINGS)
    # Not "expose": "two minutes" goes on to "ten", for which nobody is waited for either.
    intent = data.draw(st.sampled_from(["guide", "heat", "lift", "open", "unlock", "spin", "look", "call", "many"]))
    words = data.draw(sentences(engine, intent)).text.split()
    beginning = " ".join(words[: data.draw(st.integers(1, len(words)))])
    if engine.prefix(beginning).idle_end:
        assert engine.parse(beginning).actions == engine.parse(" ".join(words)).actions
