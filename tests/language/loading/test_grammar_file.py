"""Grammar files that are right: what each key means, several files, includes, languages, values with units."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest
import yaml
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from intent_engine.engine import IntentEngine
from intent_engine.errors import ConfigError
from intent_engine.language.grammar import Grammar
from intent_engine.language.loading.grammar_file import load_grammars, schema
from intent_engine.language.loading.language_words import default_operators
from intent_engine.language.loading.yaml_source import YamlSource, parse_yaml

STOP = "  halt: {action: stop, sentences: [halt]}\n"


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def load(text: str, **others: str) -> Grammar:
    for name, content in others.items():
        Path(f"{name}.yaml").write_text(content)
    Path("grammar.yaml").write_text(text)
    (grammar,) = load_grammars("grammar.yaml")
    return grammar


def test_the_shortest_file():
    grammar = load("intents:\n" + STOP)
    assert (grammar.language, list(grammar.intents), grammar.files) == ("en", ["halt"], ("grammar.yaml",))
    assert ("not",) in grammar.operators.negation, "every grammar knows how to say no"


@pytest.mark.parametrize(
    "file", sorted((Path(__file__).parents[3] / "grammars").glob("*.yaml")), ids=lambda path: path.name
)
def test_the_schema_takes_what_is_shipped(file):
    Draft202012Validator.check_schema(schema())
    source = parse_yaml(file.read_text("utf-8"), YamlSource(str(file)))
    assert list(Draft202012Validator(schema()).iter_errors(source.data)) == []


SLOTS = [
    ("{type: distance, min: 10 cm, max: 3 ft}", "minimum maximum", (0.1, 0.9144)),
    ("{type: angle, unit: deg, min: -90, max: 90}", "minimum maximum unit", (-math.pi / 2, math.pi / 2, "deg")),
    ("{type: angle, min: -1, max: 1}", "minimum maximum", (-1.0, 1.0)),
    ("{type: speed, max: 3.6 km/h}", "maximum", 1.0),
    ("{type: duration, max: a minute and a half}", "maximum", 90.0),
    ("{type: number, min: 1, max: 10}", "minimum maximum", (1.0, 10.0)),
    ("{type: text, max_words: 2, allow: [and], without: [away]}", "max_words allow without", (2, {"and"}, {"away"})),
    ("text", "type max_words", ("text", 4)),
    ("{type: location, tags: [charger], fuzzy: false}", "type tags fuzzy", ("location", {"charger"}, False)),
]  # fmt: skip


@pytest.mark.parametrize(("spec", "names", "values"), SLOTS, ids=[spec for spec, _, _ in SLOTS])
def test_slots(spec, names, values):
    slot = load(f"slots: {{it: {spec}}}\nintents:\n  x: {{action: custom, sentences: ['do {{it}}']}}\n").slots["it"]
    found = [getattr(slot, name) for name in names.split()]
    wanted = list(values) if isinstance(values, tuple) else [values]
    assert found == [pytest.approx(value) if isinstance(value, float) else value for value in wanted]


@pytest.mark.parametrize("name", ["größe", "año", "числo", "côté_2", "距離"])
def test_names_may_have_letters_of_any_language(name):
    load(f"slots: {{{name}: number}}\nintents:\n  {name}: {{action: custom, sentences: ['set {{{name}:ü}}']}}\n")
    found = IntentEngine.from_files("grammar.yaml").parse("set seven")
    assert (found.intent, dict(found.slots)) == (name, {"ü": 7.0})


@pytest.mark.parametrize(
    ("spec", "values"),
    [
        ("[red, dark blue]", ["red", "dark blue"]),
        ("{values: [red, blue]}", ["red", "blue"]),
        ("{type: choice, values: {red: [red, crimson], blue: '(blue|navy)'}}", ["red", "blue"]),
        ("boolean", [True, False]),
        ("{type: boolean, values: {yes: [open], no: [shut]}}", [True, False]),
        ("{values: {1: [one], 2: [two]}}", ["1", "2"]),
    ],
)
def test_choices(spec, values):
    slot = load(f"slots: {{it: {spec}}}\nintents:\n  x: {{action: custom, sentences: ['do {{it}}']}}\n").slots["it"]
    assert [value for value, _ in slot.values] == values


MOVE = (
    "slots:\n  direction: [forward, backward]\n  angle: {type: angle, unit: deg, min: -720 deg, max: 720 deg}\n"
    "  side: [left, right]\n  turn_speed: {type: angular_speed}\n  speed: {type: speed, max: 2 m/s}\n"
    "intents:\n  turn:\n    action: {type: turn, direction: '{side}', speed: '{turn_speed}'}\n"
    "    defaults: {speed: 30 deg/s, duration: 90 s}\n"
    "    sentences:\n      - 'turn {side} [{angle}] [at {turn_speed}]'\n"
    "      - {say: turn around, slots: {side: left, angle: 180 deg}}\n"
    "      - {say: turn a bit, slots: {side: right, angle: 0.5}}\n"
    "  move:\n    action: move\n    defaults: {speed: 50 cm/s}\n"
    "    when: [{slots: {direction: backward}, defaults: {speed: 0.72 km/h}}]\n"
    "    sentences: ['go {direction} [at {speed}]']\n"
)


def test_values_with_units_are_si():
    grammar = load(MOVE)
    turn, move = grammar.intents["turn"], grammar.intents["move"]
    assert turn.defaults == {"speed": pytest.approx(math.pi / 6), "duration": 90.0}
    assert turn.sentences[1].fixed == {"side": "left", "angle": pytest.approx(math.pi)}
    assert turn.sentences[2].fixed == {"side": "right", "angle": 0.5}, "a plain number is in SI"
    assert move.defaults == {"speed": 0.5}
    assert move.when[0].defaults == {"speed": pytest.approx(0.2)}


def test_values_reach_the_actions():
    load(MOVE)
    engine = IntentEngine.from_files("grammar.yaml")
    (turn,) = engine.parse("turn around").actions
    assert (turn.angle, turn.angular_velocity) == (pytest.approx(math.pi), pytest.approx(math.pi / 6))
    (turn,) = engine.parse("turn left 90").actions
    assert turn.angle == pytest.approx(math.pi / 2), "said without a unit: the slot's"
    (move,) = engine.parse("go backward").actions
    assert move.linear_velocity == pytest.approx(-0.2)


@given(
    st.floats(0.01, 100), st.sampled_from([("m", 1.0), ("cm", 0.01), ("km", 1000.0), ("ft", 0.3048), ("in", 0.0254)])
)
def test_a_limit_is_the_same_in_every_unit(value, unit):
    name, factor = unit
    text = f"slots: {{it: {{type: distance, max: {value:.4f} {name}}}}}\nintents:\n"
    text += "  x: {action: custom, sentences: ['do {it}']}\n"
    assert load(text).slots["it"].maximum == pytest.approx(round(value, 4) * factor)


@pytest.mark.parametrize("unit", ["\N{MICRO SIGN}m", "\N{GREEK SMALL LETTER MU}m", "um"])
def test_a_unit_with_either_sign_of_micro(unit):
    text = f"slots: {{it: {{type: distance, unit: {unit}, max: 500}}}}\n"
    text += "intents:\n  x: {action: custom, sentences: ['do {it}']}\n"
    assert load(text).slots["it"].maximum == pytest.approx(500e-6)


# -- several files --------------------------------------------------------------------------------------------


def test_an_included_file_is_read_first_and_the_one_that_includes_it_wins():
    base = "intents:\n  wave:\n    action: custom\n    defaults: {times: 1, who: all}\n    sentences: [wave]\n"
    grammar = load(
        "include: [base.yaml]\nfillers: [please]\nintents:\n  wave: {action: custom, defaults: {times: 3}, "
        "sentences: [wave a lot], priority: 2, min_confidence: 0.5, wait: 450 ms, requires: [awake]}\n",
        base=base + "fillers: [uh]\n",
    )
    wave = grammar.intents["wave"]
    assert [sentence.text for sentence in wave.sentences] == ["wave", "wave a lot"]
    assert wave.defaults == {"times": 3, "who": "all"}
    assert (wave.priority, wave.min_confidence, wave.wait, wave.requires) == (2, 0.5, 0.45, {"awake"})
    assert grammar.fillers[:2] == (("uh",), ("please",))
    assert grammar.files == ("base.yaml", "grammar.yaml")


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("en", "take off", ["please take off", "uh, take off", "could you take off, please", "hey, take off, thanks"]),
        ("de", "heb ab", ["bitte heb ab", "äh, heb ab", "kannst du bitte heb ab"]),
        ("fr", "décolle", ["décolle s'il te plaît", "euh, décolle", "peux-tu décolle", "décolle, merci"]),
        ("es", "despega", ["por favor despega", "eh, despega", "despega, gracias"]),
        ("it", "decolla", ["decolla per favore", "ehm, decolla", "decolla, grazie"]),
    ],
)
def test_politeness_needs_no_line(language, sentence, said):
    text = f"language: {language}\nintents: {{a: {{action: custom, sentences: ['{sentence}']}}}}\n"
    load(text)
    engine = IntentEngine.from_files("grammar.yaml")
    assert [engine.parse(one).intent for one in said] == ["a"] * len(said)
    load(text + "fillers: []\n")
    engine = IntentEngine.from_files("grammar.yaml")
    assert [engine.parse(one).intent for one in said] == [None] * len(said)


@pytest.mark.parametrize(
    ("language", "sentence", "said"),
    [
        ("en", "order {n} coffees", ["order about two coffees", "order two more coffees"]),
        ("de", "bestelle {n} kaffees", ["bestelle etwa zwei kaffees", "bestelle zwei weitere kaffees"]),
        ("fr", "commande {n} cafés", ["commande environ deux cafés", "commande deux cafés de plus"]),
    ],
)
def test_what_says_nothing_beside_a_number_needs_no_line_either(language, sentence, said):
    """Whoever lists fillers thinks of "please"."""
    text = (
        f"language: {language}\nslots: {{n: number}}\nintents: {{a: {{action: custom, sentences: ['{sentence}']}}}}\n"
    )
    for fillers, known in (("", True), ("fillers: [hey]\n", True), ("fillers: []\n", False)):
        load(text + fillers)
        engine = IntentEngine.from_files("grammar.yaml")
        assert [bool(engine.parse(one).actions) for one in said] == [known] * len(said)


def test_a_file_that_is_included_twice_is_read_once():
    grammar = load(
        "include: [a.yaml, b.yaml]\nintents:\n" + STOP,
        a="include: [words.yaml]\n",
        b="include: [words.yaml]\n",
        words="phrases: {hi: (hi|hello)}\n",
    )
    assert grammar.files == ("words.yaml", "a.yaml", "b.yaml", "grammar.yaml")


def test_includes_are_found_beside_the_file_that_names_them(tmp_path):
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep" / "a.yaml").write_text("include: [b.yaml]\n")
    (tmp_path / "deep" / "b.yaml").write_text("intents:\n" + STOP)
    assert list(load("include: [deep/a.yaml]\n").intents) == ["halt"]


def test_a_shipped_grammar_is_included_by_its_name():
    grammar = load("include: [en]\nintents:\n  wave: {action: custom, sentences: [wave]}\n")
    assert {"wave", "move", "navigate"} <= set(grammar.intents)
    with pytest.raises(ConfigError, match=r"there is no grammar 'klingon' to include\n.*\n.*\n    there is .*en"):
        load("include: [klingon]\nintents:\n" + STOP)


NO_FILES = (
    "..",
    "folder",
    "folder/",
    "",
    "a\\0b",
    "loop.yaml",
    "no/such/folder/a.yaml",
    "a" * 300 + ".yaml",
    "a/" * 3000,
)


@pytest.mark.parametrize("name", NO_FILES, ids=[name[:20] for name in NO_FILES])
def test_includes_that_are_no_files(tmp_path, name):
    (tmp_path / "folder").mkdir()
    (tmp_path / "loop.yaml").symlink_to("loop.yaml")
    with pytest.raises(ConfigError, match=r"grammar\.yaml:1:1[0-9]: "):
        load(f'include: ["{name}"]\nintents:\n' + STOP)


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("wav.yaml", "there is no file .*did you mean 'wave.yaml'"),
        ("wave", "there is no grammar .*did you mean 'wave.yaml'"),
        ("drum.yaml", "the path is taken from this file's folder"),
        ("en.yaml", "the one that comes with the engine is 'en'"),
        ("old.yaml", "old.yaml is a link to gone.yaml, which is not there"),
    ],
)
def test_what_was_probably_included(tmp_path, monkeypatch, name, told):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "wave.yaml").write_text("intents:\n" + STOP)
    (folder / "old.yaml").symlink_to("gone.yaml")
    (folder / "grammar.yaml").write_text(f"include: {name}\nintents:\n" + STOP)
    with pytest.raises(ConfigError, match=f"(?s)mine/grammar.yaml:1:10: .*{told}"):
        load_grammars("mine/grammar.yaml")


def test_a_file_that_is_a_link_to_itself(tmp_path):
    (tmp_path / "loop.yaml").symlink_to("loop.yaml")
    with pytest.raises(ConfigError, match=r"loop\.yaml: "):
        load_grammars("loop.yaml")


def test_a_circle_of_includes_is_told():
    with pytest.raises(
        ConfigError, match=r"b.yaml:1:11: .* in a circle: grammar.yaml -> a.yaml -> b.yaml -> grammar.yaml"
    ):
        load("include: [a.yaml]\n", a="include: [b.yaml]\n", b="include: [grammar.yaml]\n")


def test_another_action_for_the_same_intent_is_told():
    with pytest.raises(ConfigError, match=r"grammar.yaml:3:3: intent 'halt' already .* another action \(a.yaml:2\)"):
        load("include: [a.yaml]\nintents:\n  halt: {action: custom, sentences: [hold]}\n", a="intents:\n" + STOP)


def test_where_the_slot_stands_that_is_defined_again():
    again = "include: [a.yaml]\nslots:\n  far: {type: distance, max: 1 m}\nintents:\n" + STOP
    where = r"grammar.yaml:3:3: 'far' is already the name of a slot \(a.yaml:2\)\n(.*\n)*.*a copy of its file"
    with pytest.raises(ConfigError, match=where):
        load(again, a="slots:\n  far: distance\n")
    with pytest.raises(ConfigError, match=r"grammar.yaml:2:9: 'far' is already the name of a phrase \(line 1\)\n"):
        load("phrases: {far: away}\nslots: {far: distance}\nintents:\n" + STOP)


TEXTS = st.from_regex(r"[a-z]{3,6}( [a-z]{3,6})?", fullmatch=True).filter(lambda text: yaml.safe_load(text) == text)
LISTS = """language: en
include: <a.yaml>
fillers: <WORD>
wake: <robot>
operators: {negation: <nay>}
sound_alikes: {hopp: <hop>}
slots:
  what: {type: text, allow: <WORD>, without: <mail>, known: <cup>}
  where: {type: location, tags: <STATE>}
intents:
  x: {action: custom, sentences: <SAID>, then: <again>, requires: <STATE>, excludes: <un STATE>}
  y: {action: custom, sentences: ['hop {what} {where}']}
"""


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(said=TEXTS, state=TEXTS, word=TEXTS)
def test_a_text_is_a_list_of_one(said, state, word):
    assume({"not", "without", "stop", "never", "nay"}.isdisjoint(f"{said} {word}".split()))
    text = LISTS.replace("WORD", word).replace("STATE", state).replace("SAID", said)
    found = []
    for begin, end in (("[", "]"), ("", "")):
        grammar = load(text.replace("<", begin).replace(">", end), a="phrases: {}\n")
        said_so = [(one.text, one.template) for intent in grammar.intents.values() for one in intent.all_sentences]
        states = [(intent.requires, intent.excludes) for intent in grammar.intents.values()]
        slots = [replace(slot, place=None) for slot in grammar.slots.values()]
        words = (grammar.fillers, grammar.wake, grammar.operators, grammar.sound_alikes, grammar.files)
        found.append((said_so, states, slots, words))
    assert found[0] == found[1]
    assert found[0][1][0] == ({state}, {f"un {state}"})


def test_languages_are_grammars_of_their_own():
    for name, language in (("a", "en"), ("b", "de"), ("c", "en-GB")):
        Path(f"{name}.yaml").write_text(
            f"language: {language}\nintents:\n  {name}: {{action: custom, sentences: [{name}]}}\n"
        )
    english, german = load_grammars(["a.yaml", "b.yaml", "c.yaml"])
    assert (english.language, list(english.intents)) == ("en", ["a", "c"])
    assert (german.language, list(german.intents)) == ("de", ["b"])
    assert ("nicht",) in german.operators.negation


def test_a_language_of_ones_own_needs_its_operators():
    text = "language: nl\noperators: {negation: [niet], stop: [stop, halt]}\n"
    text += "intents:\n  w: {action: custom, sentences: [zwaai]}\n"
    grammar = load(text)
    assert grammar.operators.negation == (("niet",),)
    assert default_operators("nl") == {}
    engine = IntentEngine.from_files("grammar.yaml")
    assert engine.parse("zwaai").actions
    assert engine.parse("zwaai niet").actions == ()
    assert engine.parse("halt").intent == "stop"


def test_a_word_that_the_grammar_has_is_not_written_for_another():
    turning = "intents:\n  t: {action: {type: custom}, sentences: ['turn left']}\n"
    lifting = "  l: {action: {type: custom}, sentences: ['lift it']}\n"
    assert load(turning).sound_alikes["lift"] == ("left",)
    assert "lift" not in load(turning + lifting).sound_alikes
    assert load(turning + lifting + "sound_alikes: {lift: [left]}\n").sound_alikes["lift"] == ("left",)
    assert load(turning + "  g: {action: {type: custom}, sentences: ['go to it']}\n").sound_alikes["to"] == ("two",)


def test_what_takes_back_is_heard_in_every_english_grammar_as_recognisers_write_it():
    turning = "intents:\n  t: {action: {type: custom}, sentences: ['turn left']}\n"
    assert load(turning).sound_alikes["know"] == ("no",)
    assert "know" not in load(turning + "  k: {action: {type: custom}, sentences: ['let me know']}\n").sound_alikes


def test_operators_and_sound_alikes_are_added_to_those_of_the_language():
    grammar = load(
        "operators: {stop: [red light], closed: [perhaps]}\nsound_alikes: {whale: [wave]}\nwake: [hey bot]\n"
        "intents:\n  wave: {action: custom, sentences: [wave]}\n"
    )
    assert {("red", "light"), ("stop",)} <= set(grammar.operators.stop)
    assert "perhaps" in grammar.operators.closed
    assert grammar.sound_alikes["whale"] == ("wave",)
    assert grammar.wake == (("hey", "bot"),)


def test_no_file_at_all():
    with pytest.raises(ConfigError, match="no grammar file was given"):
        load_grammars([])
