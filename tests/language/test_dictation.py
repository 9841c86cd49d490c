"""A dictated text: everything after the words before it, as it was said, and never a stop, a "don't" or a command."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from meanings import shipped

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.errors import ConfigError
from intent_engine.interpretation import Status

NOTES = """
language: en
include: [{home}]
slots:
  note: {{type: text, dictation: true}}
  name: {{type: text, max_words: 2}}
phrases:
  down: (write|note) down
intents:
  note:
    action: {{type: custom, name: note}}
    sentences: ["(take|make) a note [that] {{note}}", "{{down}} [that] {{note}}", "note {{note}}"]
  message:
    action: {{type: custom, name: message, text: "{{words}}"}}
    sentences: ["tell {{name}} that {{note:words}}"]
    requires: [online]
"""


@pytest.fixture(scope="module")
def notes(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    path = tmp_path_factory.mktemp("notes") / "notes.yaml"
    home = next(file for file in shipped().grammar.files if file.endswith("en.yaml"))
    path.write_text(NOTES.format(home=home))
    return IntentEngine.from_files(path)


@pytest.mark.parametrize(
    ("said", "text"),
    [
        ("Write down that Dr. Miller comes at 5:30 on Monday.", "Dr. Miller comes at 5:30 on Monday"),
        ("note buy milk and then go to the kitchen", "buy milk and then go to the kitchen"),
        ("note down don't drive into the garage", "don't drive into the garage"),
        ("note: the robot is now okay, no, it isn't", "the robot is now okay, no, it isn't"),
        ("could you please take a note that the bus stop is closed", "the bus stop is closed"),
        ("uh make a note, um, check the brakes!", "check the brakes!"),
        ("note please check the brakes", "please check the brakes"),
        ("could you make a note okay robot is what he said", "okay robot is what he said"),
        ("make a note, please check the brakes", "please check the brakes"),
        ("make a note please, check the brakes", "check the brakes"),
        ("note down please that it turns", "it turns"),
        ("note that", "that"),
        ("note 1.500 euros", "1.500 euros"),
        ("take a note " + "very " * 40 + "long", "very " * 40 + "long"),
    ],
)
def test_a_text_is_kept_as_it_was_said(notes, said, text):
    found = notes.parse(said)
    assert (found.status, found.intent, found.slots) == (Status.ACCEPTED, "note", {"note": text})
    assert found.actions[0].slots == {"note": text}
    assert notes.prefix(said).status is PrefixStatus.EXTENDABLE


@pytest.mark.parametrize(
    "said", ["stop", "note stop", "write down stop stop", "note the door is open. Stop!", "take a note no wait"]
)
def test_a_stop_is_none(notes, said):
    """It may be meant, and to stop for nothing is the lesser harm."""
    assert notes.parse(said).stops


@pytest.mark.parametrize(
    "said",
    ["don't write down buy milk", "never note that", "take a note", "take a note, please", "he said note this", "note"],
)
def test_nothing_is_written_that_nobody_asked_for(notes, said):
    assert not notes.parse(said).actions


def test_a_text_goes_with_the_slots_before_it_and_needs_what_its_intent_needs(notes):
    said = "tell my mother that I don't come home, and go to bed"
    assert notes.parse(said).status is Status.REJECTED
    found = notes.parse(said, state=["online"])
    assert found.slots == {"name": "mother", "words": "I don't come home, and go to bed"}


def test_a_sentence_may_begin_with_a_slot_or_a_phrase_in_a_phrase(tmp_path):
    (tmp_path / "say.yaml").write_text(
        "language: en\nslots: {tone: [loudly, softly], note: {type: text, dictation: true}}\n"
        "phrases: {say: say, shout: '({say}|cry)'}\n"
        "intents: {say: {action: {type: custom, name: say}, sentences: ['{tone} {note}', '{shout} {note}']}}\n"
    )
    engine = IntentEngine.from_files(tmp_path / "say.yaml")
    assert engine.parse("softly don't go").slots == {"tone": "softly", "note": "don't go"}
    assert engine.parse("cry and then go").slots == {"note": "and then go"}


def test_after_another_command_a_note_is_a_few_words(notes):
    found = notes.parse("go back two meters and then take a note the door is closed")
    assert [step["intent"] for step in found.slots["steps"]] == ["move", "note"]
    assert found.slots["steps"][1]["slots"] == {"note": "the door is closed"}


def test_it_is_told_what_was_dictated(notes):
    steps = notes.explain("please note down that it doesn't turn").steps
    assert [(step.name, step.outcome) for step in steps] == [("dictation", 'dictated: "it doesn\'t turn"')]


ANY = ("turn", "left", "go", "don't", "not", "and", "then", "robot", "please", "that", "2", "A.", "kitchen,", "no", "I")
WORDS = st.lists(st.sampled_from(ANY), min_size=1, max_size=12).map(" ".join)


@given(WORDS)
def test_whatever_is_dictated_moves_nothing(notes, text):
    """A text with a command in it is a text."""
    found = notes.parse(f"write down x {text} x")
    assert found.slots == {"note": f"x {text} x"}
    assert [action.type for action in found.actions] == ["custom"]


@given(WORDS)
def test_a_grammar_without_dictation_finds_none(text):
    assert shipped().dictated(f"write down {text}") is None


WRONG = """
language: en
slots: {{note: {{type: text, dictation: true}}}}
phrases: {{that: "that {{note}}"}}
intents: {{note: {{action: {{type: custom, name: note}}, sentences: ["{sentence}"]}}}}
"""


@pytest.mark.parametrize("sentence", ["note {note} now", "note [{note}]", "note ({note}|it)", "{note} is noted"])
def test_a_text_ends_its_sentence(tmp_path, sentence):
    (tmp_path / "notes.yaml").write_text(
        WRONG.replace('phrases: {{that: "that {{note}}"}}\n', "").format(sentence=sentence)
    )
    with pytest.raises(ConfigError) as caught:
        IntentEngine.from_files(tmp_path / "notes.yaml")
    assert "{note} must end a sentence" in str(caught.value)
    assert "notes.yaml:4:" in str(caught.value)


def test_a_text_stands_in_no_phrase(tmp_path):
    (tmp_path / "notes.yaml").write_text(WRONG.format(sentence="note {that}"))
    with pytest.raises(ConfigError, match="must end a sentence"):
        IntentEngine.from_files(tmp_path / "notes.yaml")
