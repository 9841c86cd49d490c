"""Labels files: what rows mean, and every way to write them wrong."""

from __future__ import annotations

import json

import pytest

from intent_engine.actions import Move, Stop
from intent_engine.errors import ConfigError
from intent_engine.evaluation.hearing import Act, Hearing
from intent_engine.evaluation.label_files import find_labels, read_labels
from intent_engine.evaluation.labels import Step
from intent_engine.evaluation.scoring import Condition, Verdict, judge
from intent_engine.language.sampler import sample


@pytest.fixture
def write(tmp_path):
    """Writes a labels file beside a sound file named a.wav."""
    (tmp_path / "a.wav").write_bytes(b"RIFF")

    def labels(*lines):
        texts = [line if isinstance(line, str) else json.dumps(line) for line in lines]
        path = tmp_path / "labels.jsonl"
        path.write_text("\n".join(texts), "utf-8")
        return path

    return labels


def test_a_text_means_what_the_grammar_makes_of_it(engine, write):
    path = write({"audio": "a.wav", "text": "go forward two meters"}, "", {"audio": "a.wav", "text": "what a day"})
    command, talk = read_labels(path, engine)
    assert command.expected.command
    assert command.expected.actions == (Move(0.5, 2.0, 4.0),)
    assert command.expected.steps[0].intent == "move"
    assert not talk.expected.command
    assert (command.line, talk.line) == (1, 3)


def test_who_does_what_a_text_says_is_right_in_other_words(engine, write):
    said, labelled = read_labels(
        write(
            {"audio": "a.wav", "text": "go forward two meters"},
            {"audio": "a.wav", "text": "go forward two meters", "intent": "move", "slots": {"direction": "forward"}},
        ),
        engine,
    )
    assert said.expected.by_text
    assert not labelled.expected.by_text
    meaning = engine.parse("go two meters")
    assert meaning.slots != engine.parse("go forward two meters").slots
    hearing = Hearing(meanings=[meaning], acts=[Act(meaning, 1.0, 0.5)])
    assert judge(said, Condition("tiny.en"), hearing).verdict is Verdict.RIGHT
    assert judge(labelled, Condition("tiny.en"), hearing).verdict is Verdict.WRONG


def test_a_label_is_believed_before_the_grammar(engine, write):
    path = write(
        {"audio": "a.wav", "text": "go forward two meters", "intent": None},
        {"audio": "a.wav", "text": "go forward two meters", "intent": "stop"},
        {"audio": "a.wav", "text": "go forward two meters", "actions": []},
        {"audio": "a.wav", "actions": [{"type": "stop"}]},
        {"audio": "a.wav", "actions": ["move", "turn"]},
    )
    none, stop, nothing, action, types = (row.expected for row in read_labels(path, engine))
    assert not none.command
    assert [step.intent for step in stop.steps] == ["stop"]
    assert not nothing.command
    assert action.actions == (Stop(),)
    assert types.types == ("move", "turn")


def test_actions_of_ones_own_are_labelled_by_name(engine_of, write):
    engine = engine_of("""
language: en
intents:
  wave: {action: custom, sentences: [wave]}
  greet: {action: {type: custom, name: bow}, sentences: [greet them]}
""")
    path = write({"audio": "a.wav", "actions": ["wave", "bow"]}, {"audio": "a.wav", "actions": ["bow", "custom"]})
    meaning = engine.parse("wave and greet them")
    hearing = Hearing(meanings=[meaning], acts=[Act(meaning, 1.0, 0.5)])
    verdicts = [judge(row, Condition("tiny.en"), hearing).verdict for row in read_labels(path, engine)]
    assert verdicts == [Verdict.RIGHT, Verdict.WRONG]
    with pytest.raises(ConfigError, match=r"there is no action 'greet'\n    there is move, .*, bow, wave"):
        read_labels(write({"audio": "a.wav", "actions": ["greet"]}), engine)


def test_every_grammar_has_a_stop_to_label(engine_of, write):
    """A stop is told under a name also where the file has no intent for it."""
    engine = engine_of("language: en\nintents: {wave: {action: custom, sentences: [wave]}}\n")
    (row,) = read_labels(write({"audio": "a.wav", "text": "stop", "intent": engine.parse("stop").intent}), engine)
    assert row.expected.stops
    hearing = Hearing(meanings=[engine.parse("stop")], acts=[Act(engine.parse("stop"), 1.0, 0.5)])
    assert judge(row, Condition("tiny.en"), hearing).verdict is Verdict.RIGHT
    with pytest.raises(ConfigError, match="intent 'halt' is not in the grammar"):
        read_labels(write({"audio": "a.wav", "text": "halt", "intent": "halt"}), engine)


def test_what_goes_on_from_a_command_has_its_slots(engine_of, write):
    engine = engine_of("""
language: en
slots: {side: [left, right]}
intents:
  look: {action: custom, sentences: [look], then: ["to the {side}"]}
""")
    label = {"audio": "a.wav", "text": "look to the left", "intent": "look", "slots": {"side": "left"}}
    (row,) = read_labels(write(label), engine)
    assert row.expected.steps == (Step("look", {"side": "left"}),)


def test_compound_commands_have_steps(engine, write):
    steps = [{"intent": "move", "slots": {"distance": 2}}, {"intent": "turn", "slots": {"side": "left"}}]
    path = write({"audio": "a.wav", "intent": "compound", "slots": {"steps": steps}})
    (row,) = read_labels(path, engine)
    assert [(step.intent, dict(step.slots)) for step in row.expected.steps] == [
        ("move", {"distance": 2}),
        ("turn", {"side": "left"}),
    ]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('{"audio": "a.wav" "text": "stop"}', "labels.jsonl:1:19: is no JSON: Expecting ',' delimiter"),
        ("[1, 2]", "labels.jsonl:1: is no JSON object"),
        ("[" * 100_000, "labels.jsonl:1: is "),
        ({"text": "stop"}, "labels.jsonl:1: 'audio' is missing"),
        ({"audio_filepath": "a.wav", "text": "stop"}, "is missing\n    here 'audio_filepath' is called 'audio'"),
        ({"audio": "a.wav", "sentence": "stop"}, "what is said\n    here 'sentence' is called 'text'"),
        ({"audio": 5, "text": "stop"}, "labels.jsonl:1:2: 'audio' must be the path of a sound file, not 5"),
        ({"audio": "b.wav", "text": "stop"}, "labels.jsonl:1:2: there is no sound file"),
        ({"audio": "a.wav"}, "labels.jsonl:1: says nothing of what is said"),
        ({"audio": "a.wav", "text": ["stop"]}, "labels.jsonl:1:20: 'text' must be a text, not ['stop']"),
        ({"audio": "a.wav", "intent": "fly"}, "labels.jsonl:1:20: intent 'fly' is not in the grammar"),
        ({"audio": "a.wav", "intent": "trun"}, "is not in the grammar\n    did you mean 'turn'? it has again, "),
        ({"audio": "a.wav", "intent": "none"}, "is not in the grammar\n    no command is null, without quotes"),
        ({"audio": "a.wav", "intent": "move", "slots": {"hight": 1}}, "intent 'move' has no slot 'hight'"),
        ({"audio": "a.wav", "text": "stop", "slots": {"distance": 1}}, "has 'slots' but no 'intent'"),
        ({"audio": "a.wav", "intent": None, "slots": {"distance": 1}}, "has 'slots' but no intent"),
        ({"audio": "a.wav", "intent": "compound", "slots": {}}, "'compound' needs its steps"),
        ({"audio": "a.wav", "actions": ["fly"]}, "there is no action 'fly'\n    there is move, "),
        ({"audio": "a.wav", "actions": ["mvoe"]}, "there is no action 'mvoe'\n    did you mean 'move'?"),
        (
            {"audio": "a.wav", "actions": [{"type": "turn"}]},
            "'actions': turn needs angle, angular_velocity and",
        ),
        (
            {"audio": "a.wav", "actions": [{"type": "move"}]},
            "labels.jsonl:1:20: 'actions': move needs linear_velocity, distance and duration",
        ),
        (
            {"audio": "a.wav", "text": "go", "intnet": "move"},
            "labels.jsonl:1:34: unknown key 'intnet'\n    did you mean 'intent'?",
        ),
        (
            {"audio": "a.wav", "intent": "move", "slot": {"distance": 2}},
            "unknown key 'slot'\n    did you mean 'slots'?",
        ),
        ({"audo": "a.wav", "text": "stop"}, "labels.jsonl:1:2: unknown key 'audo'\n    did you mean 'audio'?"),
        ({"audio": "a.wav", "Text": "stop"}, "unknown key 'Text'\n    did you mean 'text'?"),
        ({"audio": "a.wav", "text": "stop", "speech-end": 1}, "did you mean 'speech_end'?"),
        ({"audio": "a.wav", "text": "stop", "action": ["stop"]}, "did you mean 'actions'?"),
        ({"audio": "a.wav", "actions": [3]}, "'actions': an action is a JSON object, not int"),
        ({"audio": "a.wav", "text": "stop", "start": -1}, "'start' must be a number of seconds, not -1"),
        ({"audio": "a.wav", "text": "stop", "end": "now"}, "'end' must be a number of seconds, not 'now'"),
        ({"audio": "a.wav", "text": "stop", "start": 2, "end": 1}, "'end' is 1 s, not after 'start', 2 s"),
        ('{"audio": "a.wav", "text": "stop", "start": NaN}', "'start' must be a number of seconds"),
        ('{"audio": "a.wav", "text": "stop", "start": 1' + "0" * 400 + "}", "holds a number of 401 digits"),
        ('{"audio": "a.wav", "text": "stop", "n": 1' + "0" * 5000 + "}", "holds a number of 5001 digits"),
        *(
            ({"audio": "a.wav", "intent": "compound", "slots": {"steps": steps}}, "'compound' needs its steps")
            for steps in ([], "move", ["move"], [{}], [{"intent": ["move"]}], [{"intent": "move", "slots": 3}])
        ),
        ({"audio": "a.wav", "actions": ["move", {"type": "stop"}]}, "'actions' are whole actions, or their types and"),
        ('{"audio": "a.wav", "intent": "move", "slots": {"distance": NaN}}', "'slots' holds NaN or an infinite number"),
        ('{"audio": "a.wav", "intent": "move", "slots": {"distance": 1e999}}', "labels.jsonl:1:38: 'slots' holds NaN"),
        ('{"audio": "a.wav", "actions": [{"type": "custom", "slots": {"n": [NaN]}}]}', "'actions' holds NaN"),
        (r'{"audio": "a.wav", "text": "st\ud800op"}', r"holds half a character, '\ud800'"),
        ({"audio": "a" * 5000, "text": "stop"}, "labels.jsonl:1:2: there is no sound file"),
        ({"audio": ".", "text": "stop"}, " is a folder\n    give each sound file in it a line"),
        ({"audio": "A.WAV", "text": "stop"}, "A.WAV\n    did you mean 'a.wav'?"),
        ({"audio": "a.flac", "text": "stop"}, "a.flac\n    did you mean 'a.wav'?"),
        ({"audio": "b\\a.wav", "text": "stop"}, "a.wav\n    write paths with /"),
        (r'{"audio": "C:\Users\a.wav", "text": "stop"}', "write paths with /, or each \\ twice"),
        ('{"audio": "a.wav", "text": "stop"},', "each line is an object of its own, with no comma behind it"),
        ('{"audio": "a.wav", "text": "stop",}', "no comma before the closing bracket"),
        ("{“audio”: “a.wav”, “text”: “stop”}", "write straight double quotes"),
        ("# mine", "JSON has no comments"),
        ('{"audio": "a.wav", "audio": "a.wav", "text": "stop"}', "has 'audio' twice"),
        ({"audio": "a.wav", "text": None}, "says nothing of what is said"),
        ({"audio": "a.wav", "actions": None}, "says nothing of what is said"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(engine, write, line, said):
    with pytest.raises(ConfigError) as caught:
        read_labels(write(line), engine)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ({"audio": "a.wav", "intent": None, "actions": ["move"]}, "has 'actions' and yet no 'intent' (null)"),
        ({"audio": "a.wav", "intent": "move", "actions": []}, "has an 'intent' and yet no 'actions'"),
        (
            {"audio": "a.wav", "intent": "turn", "slots": {"side": "lefft"}},
            "'lefft' is no value of slot 'side'\n    did you mean 'left'?",
        ),
        (
            {"audio": "a.wav", "intent": "navigate", "slots": {"place": "kitchn"}},
            "'kitchn' is no value of slot 'place'\n    did you mean 'kitchen'?",
        ),
        (
            {"audio": "a.wav", "intent": "move", "slots": {"distance": "two bananas"}},
            "'two bananas' is no distance (slot 'distance')\n    give a number (m), or a text with its unit:",
        ),
        (
            {"audio": "a.wav", "intent": "turn", "slots": {"angle": 90}},
            "90, which is 5156.62°, is more than the largest, 720°",
        ),
        (
            {"audio": "a.wav", "intent": "move", "slots": {"distance": True}},
            "True is no distance",
        ),
    ],
)
def test_what_can_hardly_be_meant_is_doubted_and_counts(engine, write, line, said):
    (row,) = read_labels(write(line), engine)
    (doubt,) = row.doubts
    assert said in str(doubt)
    assert row.expected.command


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            '[\n  {"audio": "a.wav", "text": "stop"},\n  {"audio": "a.wav", "text": "stop"}\n]\n',
            "labels.jsonl:1: is no JSON object, but begins an array\n    take out the brackets around all",
        ),
        ("audio,text\na.wav,stop\na.wav,stop\n", "labels.jsonl:1: is the head of a table, not JSON"),
        ("\n\tText;Audio\nstop;a.wav\n", "labels.jsonl:2: is the head of a table, not JSON"),
        ("path\tsentence\na.wav\tstop\n", "labels.jsonl:1: is no JSON, nor is any line of the file\n    write"),
        ("84-0 STOP\n84-1 GO\n", "labels.jsonl:1: is no JSON, nor is any line of the file"),
        ("a.wav|stop|stop\nb.wav|go|go\n", "labels.jsonl:1: is no JSON, nor is any line of the file"),
        ('{\n  "audio": "a.wav",\n  "text": "stop"\n}\n', "labels.jsonl:1: is an object over several lines"),
    ],
)
def test_a_file_in_another_form_is_one_mistake_and_not_one_of_every_line(engine, write, text, said):
    with pytest.raises(ConfigError) as caught:
        read_labels(write(text), engine)
    assert len(caught.value.problems) == 1
    assert said in str(caught.value)


def test_what_is_null_is_not_labelled(engine, write):
    (row,) = read_labels(write({"audio": "a.wav", "text": "go forward two meters", "actions": None}), engine)
    assert row.expected.actions == (Move(0.5, 2.0, 4.0),)


@pytest.mark.parametrize(
    ("intent", "slot", "written", "value"),
    [
        ("move", "distance", "2 m", 2.0),
        ("move", "distance", "two feet", 0.6096),
        ("turn", "angle", "90 deg", 1.5708),
        ("turn", "angle", 1.5708, 1.5708),
        ("turn", "side", "Left", "Left"),
        ("move", "direction", "backward", "backward"),
        ("bring", "thing", "anything at all", "anything at all"),
    ],
)
def test_values_are_written_as_the_engine_gives_them_or_with_their_unit(engine, write, intent, slot, written, value):
    (row,) = read_labels(write({"audio": "a.wav", "intent": intent, "slots": {slot: written}}), engine)
    read = row.expected.steps[0].slots[slot]
    assert read == (value if isinstance(value, str) else pytest.approx(value, rel=1e-4))


def test_every_meaning_of_the_shipped_grammar_is_a_label(engine, write):
    lines = []
    for found in sample(engine.grammars[0], engine.locations, 300):
        meaning = engine.parse(found.text)
        if meaning.actions and meaning.intent != "compound":
            lines.append({"audio": "a.wav", "intent": meaning.intent, "slots": dict(meaning.slots)})
    assert len(read_labels(write(*lines), engine)) == len(lines) > 100


def test_a_slip_is_told_once_and_not_what_comes_of_it(engine, write):
    with pytest.raises(ConfigError) as caught:
        read_labels(write({"audo": "a.wav", "intnet": "stop"}), engine)
    assert [problem.message for problem in caught.value.problems] == ["unknown key 'audo'", "unknown key 'intnet'"]


def test_keys_of_ones_own_are_left_alone(engine, write):
    own = ("speaker", "room", "side", "idx", "name", "note", "test", "duration", "language", "section", "audio_file")
    path = write({"audio": "a.wav", "text": "stop", **dict.fromkeys(own, 1)})
    assert len(read_labels(path, engine)) == 1


def test_all_mistakes_are_told_at_once_and_a_wrong_grammar_once(engine, write):
    orders = [{"audio": "a.wav", "intent": "orderDrink"}] * 50
    path = write({"text": "stop"}, *orders, *([{"audio": "a.wav"}] * 50))
    with pytest.raises(ConfigError) as caught:
        read_labels(path, engine)
    text = str(caught.value)
    assert text.count("orderDrink") == 1
    assert "labels.jsonl:1:" in text
    assert "more like these" in text
    assert len(caught.value.problems) <= 11


@pytest.mark.parametrize("content", [b"", b"\n\n", b"RIFF\xff\x00\x00\x00"])
def test_files_without_labels(engine, tmp_path, content):
    path = tmp_path / "labels.jsonl"
    path.write_bytes(content)
    with pytest.raises(
        ConfigError, match=r"holds no labels|no text at all\n    give the folder with it and labels.jsonl"
    ):
        read_labels(path, engine)


def test_labels_in_another_encoding_are_told_with_their_line(engine, tmp_path):
    path = tmp_path / "labels.jsonl"
    path.write_bytes('{"audio": "a.wav"}\n{"audio": "é.wav"}\n'.encode("latin-1"))
    with pytest.raises(
        ConfigError, match=r"labels\.jsonl:2:12: is not UTF-8 text: byte 0xe9\n(.*\n)+    save it as UTF-8"
    ):
        read_labels(path, engine)


def test_labels_in_another_form_are_told(tmp_path):
    (tmp_path / "labels.csv").write_text("audio,text\na.wav,stop\n")
    with pytest.raises(ConfigError, match=r"has no labels.jsonl\n    labels.csv is not read; write one JSON object"):
        find_labels(tmp_path)


def test_which_file_holds_the_labels(tmp_path):
    with pytest.raises(ConfigError, match="no such folder"):
        find_labels(tmp_path / "nowhere")
    with pytest.raises(ConfigError, match=r"cannot be read: File name too long|no such folder"):
        find_labels(tmp_path / (300 * "x"))
    with pytest.raises(ConfigError, match=r"has no labels.jsonl\n    write one"):
        find_labels(tmp_path)
    (tmp_path / "mine.jsonl").touch()
    with pytest.raises(ConfigError, match=r"give the file itself: .*mine\.jsonl"):
        find_labels(tmp_path)
    assert find_labels(tmp_path / "mine.jsonl") == tmp_path / "mine.jsonl"
    (tmp_path / "labels.jsonl").touch()
    assert find_labels(tmp_path) == tmp_path / "labels.jsonl"


def test_a_recording_that_is_labelled_twice_is_doubted(engine, write):
    stop, left = {"audio": "a.wav", "text": "stop"}, {"audio": "./a.wav", "text": "turn left"}
    part = {"audio": "a.wav", "text": "stop", "start": 1.0}
    rows = read_labels(write(stop, part, stop, left), engine)
    assert [bool(row.doubts) for row in rows] == [False, False, True, True]
    same, other = (str(row.doubts[0]) for row in rows[2:])
    assert "labels.jsonl:3: a.wav is labelled in line 1 already: it counts twice\n    leave one of them out" in same
    assert "labels.jsonl:4: a.wav is labelled in line 1 already: as something else, and cannot be both" in other


def test_a_step_of_several_commands_needs_no_slots(engine, write):
    steps = [{"intent": "move", "slots": None}, {"intent": "turn"}]
    (row,) = read_labels(write({"audio": "a.wav", "intent": "compound", "slots": {"steps": steps}}), engine)
    assert row.expected.steps == (Step("move"), Step("turn"))
