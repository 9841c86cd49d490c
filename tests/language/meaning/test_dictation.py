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
    assert found.slots == {"name": "my mother", "words": "I don't come home, and go to bed"}


def test_a_sentence_may_begin_with_a_slot_or_a_phrase_in_a_phrase(tmp_path):
    (tmp_path / "say.yaml").write_text(
        "language: en\nslots: {tone: [loudly, softly], note: {type: text, dictation: true}}\n"
        "phrases: {say: say, shout: '({say}|cry)'}\n"
        "intents: {say: {action: {type: custom, name: say}, sentences: ['{tone} {note}', '{shout} {note}']}}\n"
    )
    engine = IntentEngine.from_files(tmp_path / "say.yaml")
    assert engine.parse("softly don't go").slots == {"tone": "softly", "note": "don't go"}
    assert engine.parse("cry and then go").slots == {"note": "and then go"}


@pytest.mark.parametrize(
    ("said", "text"),
    [
        ("go back two meters and then take a note the door is closed", "the door is closed"),
        ("Go back two meters, and write down that I don't know Dr. Miller.", "I don't know Dr. Miller"),
        ("please go back two meters and could you write down uh 1.500 euros", "uh 1.500 euros"),
        ("go back two meters. Note: turn left and then go to the kitchen", "turn left and then go to the kitchen"),
        ("go back two meters, note it turns and write down that it stopped", "it turns and write down that it stopped"),
        ("go back two meters and note thanks", "thanks"),
    ],
)
def test_after_another_command_a_text_is_kept_as_it_was_said(notes, said, text):
    found = notes.parse(said)
    assert [step["intent"] for step in found.slots["steps"]] == ["move", "note"]
    assert found.slots["steps"][1]["slots"] == {"note": text}
    assert notes.prefix(said).status is PrefixStatus.EXTENDABLE


@pytest.mark.parametrize(
    "said",
    [
        "don't go back two meters and write down that it is late",
        "if you go back two meters, write down that it is late",
        "he went back two meters and wrote down that it is late",
        "go back two meters and don't write down that it is late",
        "go back two meters, never mind, and write down that it is late",
    ],
)
def test_of_what_is_no_command_before_a_text_nothing_is_done(notes, said):
    assert not any(action.type == "move" for action in notes.parse(said).actions)


@pytest.mark.parametrize("said", ["tell Anna and Tom that I am late", "tell Anna or Tom that it is late"])
def test_who_else_is_to_be_told_is_no_part_of_a_text(engine_of, said):
    told = engine_of(
        "language: en\nslots: {who: [Anna, Tom], note: {type: text, dictation: true}}\n"
        "intents: {tell: {action: custom, sentences: ['tell {who} [that] {note}']}}\n"
    )
    assert not told.parse(said).actions
    assert told.parse("tell Anna that Tom and I are late").slots == {"who": "Anna", "note": "Tom and I are late"}
    assert told.parse("tell Anna, and then it rained").slots == {"who": "Anna", "note": "and then it rained"}


@pytest.mark.parametrize(
    ("language", "tell", "others"),
    [
        ("de", "sag {who} [dass] {note}", "sag Anna oder Tom dass es spät ist"),
        ("fr", "dis à {who} [que] {note}", "dis à Anna ou Tom que je suis là"),
        ("es", "dile a {who} [que] {note}", "dile a Anna u Oscar que llego tarde"),
        ("it", "di a {who} [che] {note}", "di a Anna oppure Tom che sono qui"),
    ],
)
def test_who_else_is_to_be_told_in_other_languages(engine_of, language, tell, others):
    told = engine_of(
        f"language: {language}\nslots: {{who: [Anna, Tom, Oscar], note: {{type: text, dictation: true}}}}\n"
        f"intents: {{tell: {{action: custom, sentences: ['{tell}']}}}}\n"
    )
    assert not told.parse(others).actions
    begin, text = others.partition(" Anna")[0], others.split()[-1]
    assert told.parse(f"{begin} Anna {text}").slots == {"who": "Anna", "note": text}


def test_a_stop_behind_a_text_stops_all(notes):
    assert notes.parse("go back two meters and write down that it is late. Stop!").stops


@given(st.integers(2, 90), st.lists(st.sampled_from(("A.", "don't", "I", "Mr. Brown", "2", "fell,", "x")), min_size=1))
def test_a_text_is_the_same_alone_and_behind_a_command(notes, count, words):
    text = f"x {' '.join(words)} x"
    before, alone = notes.parse(f"go back {count} cm"), notes.parse(f"write down that {text}")
    assert notes.parse(f"go back {count} cm and write down that {text}").actions == before.actions + alone.actions


@pytest.mark.parametrize(
    ("said", "text"),
    [("note hello", "hello"), ("please note thank you", "thank you"), ("write down: hi", "hi")],
)
def test_a_greeting_may_be_dictated(notes, said, text):
    assert notes.parse(said).slots == {"note": text}


@pytest.mark.parametrize(
    ("said", "text"),
    [
        ("note hello, goodbye", "hello, goodbye"),
        ("note thank you for the music", "thank you for the music"),
        ("note thank you, next", "thank you, next"),
        ("note: hello, world", "hello, world"),
        ("note: okay, computer", "okay, computer"),
        ("please note down that thank you for the cake", "thank you for the cake"),
        ("tell my mother that hello, it is late", "hello, it is late"),
        ("take a note, thank you, the door is closed", "the door is closed"),
        ("take a note, thank you so much, Anna", "thank you so much, Anna"),
    ],
)
def test_a_text_that_begins_with_a_greeting_is_kept_whole(notes, said, text):
    """After a pause it thanks whoever is to write, unless it goes on."""
    assert text in notes.parse(said, state=["online"]).slots.values()


GREETING = st.sampled_from(("hello", "hi", "hey", "thanks", "thank you"))


@given(GREETING, st.sampled_from(("", ",", ".")), st.lists(st.sampled_from(("it", "fell,", "I", "x")), min_size=1))
def test_a_greeting_in_one_breath_with_the_command_is_never_lost(notes, greeting, pause, words):
    text = f"{greeting}{pause} {' '.join(words)} x"
    assert notes.parse(f"write down that {text}").slots == {"note": text}
    assert notes.parse(f"go back 20 cm and write down that {text}").slots["steps"][1]["slots"] == {"note": text}


@pytest.mark.parametrize(
    "said", ["note, thanks", "take a note please", "take a note, thank you", "note now", "note uh"]
)
def test_what_goes_with_a_command_is_nothing_to_dictate(notes, said):
    assert not notes.parse(said).actions


def test_it_is_told_what_was_dictated(notes):
    steps = notes.explain("please note down that it doesn't turn").steps
    assert [(step.name, step.outcome) for step in steps] == [("dictation", 'dictated: "it doesn\'t turn"')]


@pytest.mark.parametrize(
    ("said", "name"),
    [
        ("tell uh Anna that I am late", "anna"),
        ("tell Anna, um, that I am late", "anna"),
        ("please tell Anna Lee that I am late", "anna lee"),
    ],
)
def test_a_name_before_a_text_holds_no_fillers(notes, said, name):
    assert dict(notes.parse(said, state=["online"]).slots) == {"name": name, "words": "I am late"}


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
