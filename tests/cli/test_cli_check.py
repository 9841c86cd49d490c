"""``check`` and ``parse --explain`` as a person and a program meet them."""

from __future__ import annotations

import json

import pytest

FINE = """\
language: en
intents:
  wave:
    action: custom
    sentences: ['wave [at me]']
    examples:
      - wave: {}
"""
DOUBTFUL = FINE + "  bow: {action: {type: custom, name: bow}, sentences: ['(wave|bow) at me']}\n"
BROKEN = FINE.replace("[at me]", "[at {who]")
FAILING = FINE.replace("- wave: {}", "- greet: {}")


@pytest.fixture
def grammar(tmp_path):
    def write(text: str, name: str = "g.yaml"):
        (tmp_path / name).write_text(text)
        return tmp_path / name

    return write


@pytest.mark.parametrize(
    ("text", "options", "code", "says"),
    [
        (FINE, [], 0, "0 errors, 0 warnings"),
        (DOUBTFUL, [], 0, "warning: {}:8:56: 'wave at me' could be"),
        (DOUBTFUL, ["--strict"], 1, "0 errors, 1 warning"),
        (BROKEN, [], 1, "error: {}:5:31: ']' does not close the '{{'"),
        (FAILING, [], 1, "error: {}:7:9: the example 'greet' fails: status should be accepted, is rejected"),
    ],
    ids=["fine", "doubtful", "strict", "broken", "failing"],
)
def test_the_exit_code_is_the_answer(in_process, grammar, text, options, code, says):
    path = grammar(text)
    done = in_process("check", *options, path)
    assert says.format(path) in done.stdout
    assert (done.returncode, done.stderr) == (code, "")


PLACES = """\
language: en
slots: {place: {type: location}}
intents:
  go:
    action: {type: navigate, location: '{goal}'}
    sentences: ['go to [the] {place:goal}']
    examples:
      - go to the lab: {goal: lab}
      - go to the hall: {goal: hall}
      - go to the lab and go to the shed: {steps: [{goal: lab}, {goal: shed}]}
      - go to the workbench: {goal: lab}
      - go to the moon: rejected
"""


LISTED = """\
language: en
slots: {place: [pier, town hall]}
intents: {fly: {action: {type: navigate, location: '{place}'}, sentences: ['fly to [the] {place}']}}
"""


def test_who_gives_no_map_is_told_of_places_that_no_robot_reaches(in_process, grammar):
    path, places = grammar(LISTED), grammar("locations: {pier: {x: 1, y: 2}}\n", "map.yaml")
    done = in_process("check", path)
    assert done.returncode == 0
    assert "0 errors, 0 warnings, 2 places not on the map home (--locations FILE is yours); --notes" in done.stdout
    assert "0 errors, 1 warning\n" in in_process("check", "--locations", places, path).stdout
    told = in_process("parse", "--grammar", path, "fly to the pier")
    said = f"2 places that grammar {path} names are not on the map home.yaml: --locations FILE gives a map of your own"
    assert told.stderr.strip() == said
    told = in_process("parse", "--grammar", path, "--locations", places, "fly to the pier")
    assert told.returncode == 0
    assert "1 place that grammar" in told.stderr
    assert "names is not on the map map.yaml" in told.stderr


def test_examples_of_places_that_the_map_has_not_are_not_tried(in_process, grammar):
    path, places = grammar(PLACES), grammar("locations: {lab: {x: 1, y: 2}, yard: {x: 3, y: 2}}\n", "map.yaml")
    done = in_process("check", "--notes", "--locations", places, path)
    assert done.returncode == 0
    assert "0 errors, 0 warnings, 3 examples of other places not tried" in done.stdout
    assert f"note: {path}:9:9: the example 'go to the hall' was not tried: no place" in done.stdout
    tested = in_process("test", "--locations", places, path)
    assert (tested.returncode, tested.stdout.strip()) == (0, "5 examples: 2 passed, 0 failed, 3 not tried")
    assert "places that the map has not: hall, shed, workbench;" in tested.stderr


def test_a_name_that_its_own_map_has_not_fails(in_process, grammar):
    places = grammar("locations: {lab: {x: 1, y: 2}, hall: {x: 3, y: 2}, shed: {x: 4, y: 2}}\n", "map.yaml")
    tested = in_process("test", "--locations", places, grammar(PLACES))
    assert tested.returncode == 1
    assert "5 examples: 4 passed, 1 failed" in tested.stdout


def test_a_slip_in_the_name_of_a_place_is_no_other_place(in_process, grammar):
    path, places = (
        grammar(PLACES.replace("goal: hall", "goal: halll")),
        grammar("locations: {lab: {x: 1, y: 2}, hall: {x: 3, y: 2}, shed: {x: 3, y: 4}}\n", "map.yaml"),
    )
    done = in_process("check", "--locations", places, path)
    assert done.returncode == 1
    assert "slots.goal should be halll, is hall" in done.stdout


def test_a_place_that_is_nearly_called_like_another_is_of_another_map(in_process):
    """ "Küche" and "kitchen" have two letters of three in common."""
    done = in_process("check", "--notes", "-g", "en", "-g", "de", "--locations", "home")
    assert done.returncode == 0, done.stdout
    assert "note: grammars/de.yaml:" in done.stdout
    assert "'fahr in die Küche' was not tried: no place of the map is called 'küche'" in done.stdout
    tested = in_process("test", "--locations", "home", "de")
    assert tested.returncode == 0, tested.stdout
    assert "places that the map has not: küche, " in tested.stderr


def test_a_grammar_may_be_named_as_other_verbs_take_it(in_process, grammar):
    paths = [grammar(FINE), grammar(DOUBTFUL, "h.yaml")]
    by_option = in_process("check", paths[0], "--grammar", paths[1])
    assert "0 errors, 1 warning" in by_option.stdout
    assert by_option.stdout == in_process("check", *paths).stdout


def test_one_bad_file_does_not_disturb_another(in_process, grammar):
    done = in_process("check", grammar(BROKEN, "bad.yaml"), grammar(FINE, "good.yaml"))
    assert done.returncode == 1
    assert "bad.yaml:5" in done.stdout
    assert "good.yaml (en)" in done.stdout
    assert "1 error, 0 warnings" in done.stdout


def test_files_may_be_checked_together(in_process, grammar):
    one, other = (
        grammar(FINE, "a.yaml"),
        grammar(FINE.replace("wave", "bow").replace("bow [", "(wave|bow) ["), "b.yaml"),
    )
    assert "0 warnings" in in_process("check", one, other).stdout
    assert "1 warning" in in_process("check", "--together", one, other).stdout


def test_notes_are_told_when_asked_for(in_process, grammar):
    text = FINE + "  all: {action: {type: custom, name: all}, sentences: ['wave at {thing}']}\nslots: {thing: text}\n"
    done = in_process("check", grammar(text))
    assert "--notes tells 1 note" in done.stdout
    assert "note:" not in done.stdout
    assert "note: " in in_process("check", "--notes", grammar(text)).stdout


def test_json(in_process, grammar):
    done = in_process("check", "--json", grammar(DOUBTFUL), grammar(BROKEN, "bad.yaml"))
    first, second = map(json.loads, done.stdout.splitlines())
    assert done.returncode == 1
    assert (first["ok"], second["ok"]) == (True, False)
    (finding,) = first["findings"]
    assert (finding["level"], finding["topic"], finding["line"]) == ("warning", "ambiguous", 8)
    assert first["figures"][0]["sentences"] == 2
    assert second["findings"][0]["hint"]
    assert second["figures"] == []


def test_a_missing_grammar_is_an_error(in_process):
    done = in_process("check", "nowhere.yaml")
    assert done.returncode == 2, "there is nothing to be checked"
    assert done.stderr.startswith("error: nowhere.yaml: no such file\n")
    assert done.stdout == ""


def test_an_explanation_in_words(in_process):
    done = in_process("parse", "--explain", "uh go to the kitchn please")
    assert done.returncode == 0
    for line in (
        "words: uh go to the kitchn please",
        "  filler: uh",
        "misheard: 'go to the kitchn': understood as navigate (heard 'kitchn' as 'kitchen')",
        "  place=kitchen: said 'kitchn', fuzzy",
        "  -> navigate to kitchen",
    ):
        assert line in done.stdout


def test_an_explanation_as_json(intent_engine):
    lines = b"don't go forward\ngo forward\n"
    done = intent_engine("parse", "--explain", "-", stdin=lines)
    refused, taken = map(json.loads, done.stdout.splitlines())
    assert refused["status"] == "rejected"
    assert {"kind": "negation", "words": "not", "start": 1} in refused["explanation"]["noticed"]
    assert taken["explanation"]["slots"][0][0]["source"] == "said"
    plain = json.loads(intent_engine("parse", "--json", "go forward").stdout)
    assert plain == {key: value for key, value in taken.items() if key != "explanation"}


@pytest.mark.parametrize(
    ("files", "warnings"),
    [
        (["en"], 0),
        (["de", "--locations", "zuhause"], 0),
        (["examples/custom_command.yaml", "examples/my_grammar/lamp.yaml"], 0),
        (["examples/coffee/coffee.yaml"], 1),  # "a bit of milk" and "a bit of soy milk" are much alike
    ],
    ids=["English", "German", "examples", "coffee"],
)
def test_what_is_shipped_is_checked(in_process, files, warnings):
    done = in_process("check", *files)
    assert done.returncode == 0, done.stdout
    assert f"0 errors, {warnings} warning" in done.stdout
