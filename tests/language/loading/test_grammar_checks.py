"""What the checks let pass: no grammar that works is called wrong. What they refuse is in ``grammar_mistakes.py``."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from templates import trees

from intent_engine.errors import ConfigError
from intent_engine.language.grammar import Grammar
from intent_engine.language.loading.grammar_file import load_grammars
from intent_engine.language.templates.template_tree import template_text


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def load(text: str) -> Grammar:
    Path("grammar.yaml").write_text(text)
    (grammar,) = load_grammars("grammar.yaml")
    return grammar


def warnings(text: str) -> list[tuple[int | None, str]]:
    return [(problem.line, problem.message) for problem in load(text).warnings]


FINE = {
    "a list for values that are not said": (
        "slots: {domain: [light, fan]}\n"
        "intents:\n  x: {action: custom, sentences: [{say: lights on, slots: {domain: light}}]}\n"
    ),
    "a slot straight behind a bracket": (
        "slots: {room: [hall, lab]}\n"
        "intents:\n  x: {action: custom, sentences: ['go (to|into){room} [the ]{room:by}']}\n"
    ),
    "the same slot in two alternatives": (
        "slots: {place: text}\nintents:\n  x: {action: custom, sentences: ['go (to {place}|into {place})']}\n"
    ),
    "the same slot under two names": (
        "slots: {place: text}\nintents:\n  x: {action: custom, sentences: ['from {place:start} to {place:end}']}\n"
    ),
    "a slot inside a phrase": (
        "slots: {place: text}\nphrases: {there: 'to {place}'}\n"
        "intents:\n  x: {action: custom, sentences: ['go {there}']}\n"
    ),
    "an optional phrase that may be empty": (
        "phrases: {politely: '[very] [kindly]'}\nintents:\n  x: {action: custom, sentences: ['{politely} go']}\n"
    ),
    "a phrase inside a value": (
        "phrases: {very: '(very|really)'}\nslots: {size: {values: {big: '[{very}] big', small: small}}}\n"
        "intents:\n  x: {action: custom, sentences: ['a {size} one']}\n"
    ),
    "a constant for a custom action": (
        "intents:\n  x: {action: {type: custom, name: wave, times: 3}, sentences: [wave]}\n"
    ),
    "a direction from the sign of a distance": (
        "slots: {distance: distance}\nintents:\n  x: {action: move, sentences: ['by {distance}']}\n"
    ),
    "a direction from a default": "intents:\n  x: {action: move, defaults: {direction: forward}, sentences: [go]}\n",
    "a direction from a fixed slot": (
        "intents:\n  x: {action: turn, sentences: [{say: left turn, slots: {direction: left}}]}\n"
    ),
    "a number for a distance": (
        "slots: {steps: {type: number, max: 10}}\nintents:\n  x: {action: {type: move, distance: '{steps}'},\n"
        "    defaults: {direction: forward}, sentences: ['go {steps}']}\n"
    ),
    "a choice of places": (
        "slots: {where: [kitchen, hall]}\nintents:\n"
        "  x: {action: {type: navigate, location: '{where}'}, sentences: ['to {where}']}\n"
    ),
    "the same sentence for two states of the robot": (
        "intents:\n  x: {action: custom, sentences: [go], requires: [docked]}\n"
        "  y: {action: stop, sentences: [go], excludes: [docked]}\n"
    ),
    "slots from a regex": (
        "slots: {who: text}\nintents:\n"
        "  x: {action: custom, regex: 'wave (at|to) (?P<who>[a-z ]+)', defaults: {who: me}}\n"
    ),
    "a regex that could run for hours elsewhere": "intents:\n  x: {action: custom, regex: 'wave (a+)+b'}\n",
    "a regex that looks at capitals": "intents:\n  x: {action: custom, regex: '(?i)WAVE'}\n",
    "several regexes": "intents:\n  x: {action: custom, regex: ['wave \\S+ bow', 'bow']}\n",
    "a lark grammar": (
        'slots: {who: text}\nintents:\n  x:\n    action: custom\n    lark: |\n      start: "wave" " " who\n'
        "      who: /[a-z]+/\n"
    ),
    "a stop among the words of another sentence": (
        "slots: {what: [music, game]}\nintents:\n"
        "  x: {action: custom, sentences: ['stop [the] {what}', 'play freeze']}\n"
    ),
    "a question": "intents:\n  x: {action: custom, sentences: ['what time is it?', 'would you [please] wave?']}\n",
    "bars that part all of a sentence": (
        "slots: {who: text}\nintents:\n  x: {action: custom, sentences: ['bow|take a bow', 'hug {who}|kiss {who}']}\n"
    ),
    "constants of an action, and defaults of slots": (
        "slots: {rate: number}\nintents:\n  x: {action: custom, sentences: ['spin [at {rate}]'],\n"
        "    defaults: {rate: 4, mode: wet}}\n"
        "  y: {action: {type: custom, turns: '{rate}'}, sentences: ['turn [at {rate}]'], defaults: {rate: 4}}\n"
    ),
    "units of numbers, and words that are signs of units": (
        "slots: {n: number, t: {type: angle, unit: deg}, far: distance, time: duration}\nintents:\n"
        "  x: {action: custom, sentences: ['tip {t} degrees', 'heat to {n} degrees', 'go {far} in {time}']}\n"
    ),
    "a stroke between units": "intents:\n  x: {action: custom, sentences: ['spin at {#} rpm/s', 'mix 1/2 cup']}\n",
    "signs that a regex can do without": "intents:\n  x: {action: custom, regex: 'hop,? now[!.]?'}\n",
    "signs of numbers": "intents:\n  x: {action: custom, regex: 'add (-?\\d+|\\d+/\\d+|\\d+\\.5|2\\.5) cups'}\n",
    "brackets that choose, order and hold others": (
        "slots: {a: distance}\nintents:\n  x:\n    action: custom\n"
        "    sentences: [\"go ([very] far|home) [{a:b}] (on;off) l'[autre] fin, at 3:30\", 'lift (a|b) [c|d] {a}m']\n"
    ),
    "a value of a sentence that may say another": (
        "slots: {a: [up, down]}\nintents:\n  x:\n    action: custom\n    sentences:\n"
        "      - {say: 'go ({a}|on)', slots: {a: up}}\n"
    ),
    "stop in one's own words": "intents:\n  x: {action: stop, sentences: ['do not move']}\n",
}


@pytest.mark.parametrize("name", FINE)
def test_what_works_is_not_refused(name):
    assert warnings(FINE[name]) == []


DOUBTFUL = {
    "slots: {a: text}\nintents:\n  x: {action: custom, sentences: [go]}\n": (1, "slot 'a' is used by no sentence"),
    "intents:\n  x: {action: custom, sentences: [go]}\nphrases:\n  p: a\n": (4, "phrase 'p' is used by no sentence"),
    "slots: {a: text,\n b: text}\nintents:\n  x: {action: custom, regex: 'go (?P<a>up)'}\n": (
        2, "slot 'b' is used by no sentence",
    ),
    "slots: {a: text,\n b: text}\nintents:\n  x:\n    action: custom\n    lark: |\n      start: a B\n      a: \"up\"\n"
    "      B: \" x\"\n": (2, "slot 'b' is used by no sentence"),
    "slots: {rate: number}\nintents:\n  x: {action: custom, sentences: ['spin [at {rate}]'],\n"
    "    defaults: {ratee: 4}}\n": (4, "a default for 'ratee', which no sentence has"),
    "slots: {rate: number}\nintents:\n  x: {action: custom, sentences: ['spin [at {rate}]'],\n"
    "    when: [{slots: {rate: 4}, defaults: {rates: 5}}]}\n": (4, "a default for 'rates', which no sentence has"),
    "slots: {rate: number}\nintents:\n  x: {action: {type: custom, turns: '{rate}'}, sentences: ['spin [at {rate}]'],\n"
    "    defaults: {mode: wet}}\n": (4, "a default for 'mode', which the action does not take"),
    "slots: {t: duration}\nintents:\n  x: {action: custom, sentences: ['wait for {t} seconds']}\n": (
        3, "'seconds' would have to be said twice: 't' is said with its unit",
    ),
    "slots: {t: percent}\nintents:\n  x: {action: custom, sentences: ['dim [to {t:level} %]']}\n": (
        3, "'percent' would have to be said twice: 'level' is said with its unit",
    ),
    "slots: {t: angle}\nphrases: {p: '{t} (degrees|degree) up'}\n"
    "intents:\n  x: {action: custom, sentences: ['tip {p}']}\n": (
        2, "'degrees' would have to be said twice: 't' is said with its unit",
    ),
    "slots: {t: speed}\nintents:\n  x: {action: custom, sentences: ['roll at {t} m/s']}\n": (
        3, "'m per s' would have to be said twice: 't' is said with its unit",
    ),
    "intents:\n  x: {action: custom, sentences: [go,\n    go]}\n": (3, "the same sentence stands already at line 2"),
    "intents:\n  x: {action: custom, sentences: ['never go']}\n": (
        2, "this sentence says 'never', and yet the robot will act on it",
    ),
    "intents:\n  x: {action: custom, sentences: ['(stop|bow) now']}\n": (
        2, "'stop now' stops the robot in every grammar, and is never one of 'x'",
    ),
    "slots: {a: [hop, halt]}\nintents:\n  x: {action: custom, sentences: ['please {a}']}\n": (
        3, "'please halt' stops the robot in every grammar, and is never one of 'x'",
    ),
    "intents:\n  x: {action: custom, sentences: ['wave/greet']}\n": (
        2, "'wave/greet' would have to be said as 'wave per greet'",
    ),
    "intents:\n  x: {action: custom, sentences: ['{a}']}\nphrases:\n  a: [bow, wave/greet]\n": (
        4, "'wave/greet' would have to be said as 'wave per greet'",
    ),
    "intents:\n  x: {action: custom, sentences: ['wave at the? cat']}\n": (
        2, "the '?' of 'the?' says nothing: the word must be said",
    ),
    "slots: {a: text}\nintents:\n  x: {action: custom, sentences: ['hug|kiss the {a}']}\n": (
        3, "this '|' stands in no brackets, and so parts all of the sentence: one part has a slot, one none",
    ),
    "intents:\n  x: {action: custom, regex: [bow, 'hop, now!']}\n": (
        2, "the regex asks for ',', and what is said is words and numbers, without signs",
    ),
    "slots: {a: text, b: text}\nintents:\n  x: {action: custom, sentences: ['mix {a} [{b}]', 'mix {a} and {b}']}\n": (
        3, "nobody can tell where 'a' ends and 'b' begins: both are free text",
    ),
    "slots: {a: [up, down]}\nintents:\n  x:\n    action: custom\n    sentences:\n"
    "      - {say: 'go {a} now', slots: {a: up}}\n": (
        6, "slot 'a' is always said in this sentence, and never has the value 'up'",
    ),
    "intents:\n  x: {action: custom, sentences: ['light the lamp[s]']}\n": (
        2, "'lamp[s]' is said in two words: a bracket ends one",
    ),
    "intents:\n  x: {action: custom, sentences: ['light the (lamp|cand le)s']}\n": (
        2, "'(lamp|cand le)s' is said in two words: a bracket ends one",
    ),
    "intents:\n  x: {action: custom, sentences: ['[make, brew] coffee']}\n": (
        2, "a ',' parts nothing: all of '[make, brew]' is said, one after the other",
    ),
    "intents:\n  x: {action: custom, sentences: ['brew [a] (small) coffee']}\n": (
        2, "the brackets of '(small)' change nothing: it must be said",
    ),
    "intents:\n  x: {action: custom, sentences: ['brew coffee 1..3']}\n": (
        2, "'1..3' is no range, but two numbers that are said",
    ),
    "intents:\n  x: {action: custom, sentences: ['brew (coffee:espresso|tea)']}\n": (
        2, "'coffee:espresso' puts nothing in the place of a word: both are said",
    ),
    "slots: {a: [red, blue]}\nintents:\n  x: {action: custom, sentences: ['go (red|blue){a}']}\n": (
        3, "'(red|blue){a}' is two things that are said: '(red|blue)', then 'a'",
    ),
    "slots: {a: [red, blue]}\nintents:\n  x: {action: custom, sentences: ['go red{a:way}']}\n": (
        3, "'red{a:way}' is two things that are said: 'red', then 'a'",
    ),
    "slots:\n  a: ['(red|ruby)', blue]\nintents:\n  x: {action: custom, sentences: ['go {a}']}\n": (
        2, "the value of slot 'a' is called '(red|ruby)', as it is written",
    ),
}  # fmt: skip


@pytest.mark.parametrize("text", DOUBTFUL)
def test_what_is_doubtful_is_told_and_loads(text):
    assert warnings(text) == [DOUBTFUL[text]]


@pytest.mark.parametrize(
    ("regex", "hint"),
    [
        ('''r"hop (left|right)"''', "YAML has no r before a quote: write it in single quotes"),
        ('''"\\bhop\\b"''', "write it in single quotes: between double ones YAML reads \\b as the sign backspace"),
        ("'/hop now/i'", "write it without the / at both ends"),
    ],
)
def test_a_regex_copied_from_a_program_is_told_what_to_leave_out(regex, hint):
    (problem,) = load(f"intents:\n  x: {{action: custom, regex: [bow, {regex}]}}\n").warnings
    assert problem.hint == hint


@settings(max_examples=100, deadline=None)
@given(st.lists(trees(("a", "b", "c"), names=("s", "p")), min_size=1, max_size=4))
def test_any_sentences_load_or_are_told_what_is_wrong(templates):
    rows = "".join(f'      - "{template_text(tree)}"\n' for tree in templates)
    head = "slots: {s: text}\nphrases: {p: '(x|y [z])'}\nintents:\n  i:\n    action: custom\n    sentences:\n"
    try:
        found: Grammar | ConfigError = load(head + rows)
    except ConfigError as error:
        found = error
    if isinstance(found, ConfigError):
        assert all(6 < (problem.line or 0) <= 6 + len(templates) for problem in found.problems)
    else:
        assert len(found.intents["i"].sentences) == len(templates)


LINES = [
    "language: en", "intents:", "  wave:", "    action: custom", "    action: {type: move}", "    sentences:",
    "      - wave", "      - 'go {it}'", "slots:", "  it: text", "  it: {values: [a, b]}", "phrases:", "  p: '{p}'",
    "    defaults: {it: 3 m}", "    regex: '('", "    examples:", "include: [grammar.yaml]", "fillers: [not]", "  - x",
    "    when: [{slots: {it: a}, defaults: {speed: 1}}]", "    requires: [x]", "\t", "  : {", "  'a': &a [*a]", "---",
]  # fmt: skip


@settings(max_examples=150, deadline=None)
@given(st.lists(st.sampled_from(LINES), max_size=12) | st.permutations(LINES[:12]))
def test_lines_of_files_in_any_order_load_or_are_told_what_is_wrong(lines):
    try:
        load("\n".join(lines))
    except ConfigError as error:
        problems = error.problems
    else:
        problems = ()
    assert all(problem.file == "grammar.yaml" and problem.message for problem in problems)


def test_a_regex_is_linear_whatever_its_form():
    """Backtracking engines take 2 to the power of the text for this one; a test that ends is the proof."""
    from intent_engine.engine import IntentEngine

    load("intents:\n  x: {action: custom, regex: 'wave (a+)+b'}\n")
    engine = IntentEngine.from_files("grammar.yaml")
    assert engine.parse("wave " + "a" * 1900).actions == ()
    assert engine.parse("wave aaab").actions


@pytest.mark.parametrize("fillers", ["\n  - you are\n  - would you\n  - do not\n", " do not\n"])
def test_a_filler_that_denies_is_named_as_it_is_written_and_where(fillers: str) -> None:
    """Fillers are known shortened as well ("you're"), which moves none of them."""
    text = f"fillers:{fillers}intents:\n  wave: {{action: custom, sentences: [wave]}}\n"
    with pytest.raises(ConfigError) as caught:
        load(text)
    (problem,) = caught.value.problems
    assert problem.message.startswith("the filler 'do not' says no")
    assert text.splitlines()[(problem.line or 0) - 1].strip(" -").endswith("do not")
