"""The beginning of a command is known as one, in whichever way it is put: "turn the lamp in the hall ..." of a grammar
that has "turn on the lamp", and "open the door and the ..." of one that has "open the door"."""

from __future__ import annotations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status

WHOLE = (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)
HOUSE = """
language: en
phrases: {what: "[the] {lamp}"}
slots:
  lamp: [lamp, fan, ceiling light]
  opening: [door, window, gate]
  room: [hall, kitchen]
  share: percent
  row: {type: ordinal, max: 30}
  thing: {type: text, max_words: 3}
  time: duration
  pump: boolean
intents:
  on: {action: custom, sentences: ["turn on {what} [in the {room}]"]}
  off: {action: custom, sentences: ["(turn|switch) [the] {lamp} off [for {time}]"]}
  open: {action: custom, sentences: ["open the {opening}"]}
  shut: {action: custom, sentences: ["[firmly] shut the {row} {opening}"]}
  take: {action: custom, sentences: ["pick up [the] {thing}"]}
  lay: {action: custom, sentences: ["put [the] {thing} down"]}
  fade: {action: custom, sentences: ["fade {lamp} to {share}"]}
  pump: {action: custom, sentences: ["switch {pump} the pump"]}
  wave: {action: custom, sentences: [wave]}
"""
GERMAN = """
language: de
slots: {gerät: [Lampe, Pumpe], raum: [Küche, Halle]}
intents:
  ein: {action: custom, sentences: ["schalte die {gerät} [in der {raum}] ein"]}
  öffnen: {action: custom, sentences: ["fahr in die {raum}"]}
"""


@pytest.fixture(scope="module")
def house(engine_of) -> IntentEngine:
    return engine_of(HOUSE)


@pytest.fixture(scope="module")
def german(engine_of) -> IntentEngine:
    return engine_of(GERMAN)


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("turn the lamp", PrefixStatus.INCOMPLETE),
        ("turn the lamp in the", PrefixStatus.INCOMPLETE),
        ("turn the lamp in the hall", PrefixStatus.INCOMPLETE),
        ("turn the lamp in the hall on", PrefixStatus.COMPLETE),
        ("turn the lamp on", PrefixStatus.EXTENDABLE),
        ("turn the lamp on in the", PrefixStatus.INCOMPLETE),
        ("turn the lamp on in the hall", PrefixStatus.COMPLETE),
        ("turn off the fan", PrefixStatus.EXTENDABLE),
        ("turn off the fan for ten minutes", PrefixStatus.EXTENDABLE),
        ("switch off", PrefixStatus.INCOMPLETE),
        ("switch the pump on", PrefixStatus.COMPLETE),
        ("pick the red cup", PrefixStatus.INCOMPLETE),
        ("wave and turn the lamp in the hall", PrefixStatus.INCOMPLETE),
        ("open the door", PrefixStatus.COMPLETE),
        ("open the door and", PrefixStatus.INCOMPLETE),
        ("open the door and the", PrefixStatus.INCOMPLETE),
        ("open the door and the window", PrefixStatus.COMPLETE),
        ("open the door and the window and the gate", PrefixStatus.COMPLETE),
        ("open the door and the window and wave", PrefixStatus.COMPLETE),
        ("fade the lamp to 20 percent and the", PrefixStatus.INCOMPLETE),
        ("turn the lamp on and the fan", PrefixStatus.EXTENDABLE),
        ("shut the first gate firmly", PrefixStatus.COMPLETE),
    ],
)
def test_how_far_words_have_come(house: IntentEngine, text: str, status: PrefixStatus) -> None:
    assert house.prefix(text).status is status


@pytest.mark.parametrize("text", ["turn the on", "turn the lamp on the", "open and the", "wave up"])
def test_what_begins_no_command_is_none(house: IntentEngine, text: str) -> None:
    assert house.prefix(text).status is PrefixStatus.IMPOSSIBLE


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("turn the ceiling", "light"),
        ("turn the lamp", "on"),
        ("turn the lamp in the hall", "on"),
        ("open the door", "and"),
        ("open the door and", "the"),
        ("open the door and the", "window"),
        ("shut the first", "and"),
        ("shut the first and the third", "gate"),
        ("shut the first gate", "firmly"),
    ],
)
def test_words_that_may_follow(house: IntentEngine, text: str, word: str) -> None:
    assert word in house.prefix(text).next_words


def test_a_list_is_not_waited_for(house: IntentEngine) -> None:
    """Whoever says "open the door" is done: "and the window" would be another command."""
    for text in ("open the door", "open the door and the window", "turn the lamp on in the hall"):
        found = house.prefix(text)
        assert found.status is PrefixStatus.COMPLETE
        assert found.settled


LAMPS, OPENINGS = st.sampled_from(["lamp", "fan", "ceiling light"]), st.sampled_from(["door", "window", "gate"])
ROOMS, ROWS = st.sampled_from(["", " in the hall", " in the kitchen"]), st.sampled_from(["first", "third", "twelfth"])
JOINTS = st.sampled_from(["and", "and then", "then"])


@st.composite
def put_otherwise(draw: st.DrawFn) -> str:
    """A command as the grammar has it not."""
    lamp, other, room, joint = draw(LAMPS), draw(LAMPS), draw(ROOMS), draw(JOINTS)
    opening, further, last = draw(OPENINGS), draw(OPENINGS), draw(OPENINGS)
    return draw(
        st.sampled_from(
            [
                f"turn the {lamp}{room} on",
                f"turn {lamp} on{room}",
                f"turn off the {lamp}",
                f"switch off {lamp} for ten minutes",
                "switch the pump off",
                f"turn on the {lamp} {joint} the {other}",
                f"turn the {lamp} on {joint} the {other}",
                f"turn on the {lamp} in the hall {joint} the {other} in the kitchen",
                f"turn the {lamp} {joint} the {other} off",
                f"open the {opening} {joint} the {further}",
                f"open the {opening} {joint} {further} and the {last}",
                f"shut the {draw(ROWS)} {joint} the {draw(ROWS)} {opening}",
                f"shut the {draw(ROWS)} {opening} firmly",
                f"fade the {lamp} to 20 percent {joint} the {other} to 30 percent",
                f"wave {joint} turn the {lamp} on {joint} open the {opening} and the {further}",
                "pick the red cup up",
            ]
        )
    )


@given(put_otherwise())
def test_every_beginning_of_a_command_leads_to_its_next_word(house: IntentEngine, command: str) -> None:
    assume(house.parse(command).actions)
    words = command.split()
    for count, word in enumerate(words):
        found = house.prefix(" ".join(words[:count]))
        assert found.status is not PrefixStatus.IMPOSSIBLE
        assert found.known_words == count
        numeral = word.isdigit() and "<number>" in found.next_words
        assert numeral or word in found.next_words or "<any>" in found.next_words, word
    assert house.prefix(command).status in WHOLE


@pytest.mark.parametrize(
    "command",
    ["schalte die Lampe und die Pumpe in der Küche ein", "fahr in die Küche und in die Halle"],
)
def test_lists_of_german(german: IntentEngine, command: str) -> None:
    words = command.split()
    assert all(german.prefix(" ".join(words[:count])).known_words == count for count in range(len(words) + 1))
    assert german.prefix(command).status in WHOLE


def test_a_particle_may_stand_in_a_phrase_that_has_phrases(engine_of) -> None:
    engine = engine_of(
        """
        language: en
        slots: {lamp: [lamp, fan]}
        phrases: {what: "the {lamp}", which: "on {what}"}
        intents: {"on": {action: custom, sentences: ["turn {which}"]}}
        """
    )
    assert engine.parse("turn the fan on").actions
    assert engine.prefix("turn the fan").status is PrefixStatus.INCOMPLETE
    assert not engine.parse("turn the green fan").actions


ARM = """
language: en
slots:
  far: {type: number, min: 1, max: 300}
  rate: {type: number, min: 1, max: 50}
intents:
  lift: {action: custom, sentences: ["lift the arm {far} millimeters [at {rate} degrees per second]"]}
  drill: {action: custom, sentences: ["drill a hole of {far} centimeters"]}
  press: {action: custom, sentences: ["press with {far} newton meters downwards"]}
"""


@pytest.mark.parametrize(
    ("text", "status", "settled"),
    [
        ("Drill a hole of 15 cm", PrefixStatus.COMPLETE, True),
        ("drill a whole of 15 cm", PrefixStatus.COMPLETE, True),  # heard with a word that sounds like another, too
        ("drill a hole of 15cm", PrefixStatus.COMPLETE, True),
        ("drill a hole of 15", PrefixStatus.INCOMPLETE, False),
        ("lift the arm 15 mm", PrefixStatus.EXTENDABLE, False),
        ("lift the arm 15 mm at 5", PrefixStatus.INCOMPLETE, False),
        ("lift the arm 15 mm at 5 deg/s", PrefixStatus.COMPLETE, True),
        ("press with 3 Nm", PrefixStatus.INCOMPLETE, False),
        ("press with 3 Nm downwards", PrefixStatus.COMPLETE, True),
        ("drill a hole of 15 mm", PrefixStatus.IMPOSSIBLE, False),
        ("drill mm", PrefixStatus.IMPOSSIBLE, False),
    ],
)
def test_units_for_short_are_those_of_the_grammar(engine_of, text, status, settled) -> None:
    found = engine_of(ARM).prefix(text, spoken=True)
    assert (found.status, found.settled) == (status, settled)


def test_units_for_short_in_german(engine_of) -> None:
    grammar = (
        'language: de\nslots: {w: number}\nintents: {h: {action: custom, sentences: ["heb den Arm um {w} Meter"]}}\n'
    )
    engine = engine_of(grammar)
    assert [engine.prefix(text).status for text in ("heb den Arm um 2 m", "heb den Arm um 2")] == [
        PrefixStatus.COMPLETE,
        PrefixStatus.INCOMPLETE,
    ]


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("open a door", PrefixStatus.COMPLETE),
        ("turn on a lamp", PrefixStatus.EXTENDABLE),
        ("turn on my lamp in the hall", PrefixStatus.COMPLETE),
        ("open an", PrefixStatus.IMPOSSIBLE),  # only whole commands are read so
        ("open a kitchen", PrefixStatus.IMPOSSIBLE),
    ],
)
def test_a_command_with_another_article_ends_as_with_that_of_the_grammar(house, text, status):
    assert house.prefix(text, spoken=True).status is status
    assert (status in WHOLE) is (house.parse(text).status is Status.ACCEPTED)
