"""What ``check`` finds: sentences that meet, that nobody can say, names that sound alike; and how it counts."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from templates import trees

from intent_engine.engine import IntentEngine
from intent_engine.language.checker import Report, alike, check_grammar
from intent_engine.language.checking.grammar_figures import grammar_size
from intent_engine.language.grammar import ActionSpec, Grammar, Intent, Operators, Sentence
from intent_engine.language.networks.exploration import explore
from intent_engine.language.networks.network import MOST_ARTICLES
from intent_engine.language.templates.spellings import spellings
from intent_engine.language.templates.template_tree import template_text


def check(tmp_path: Path, text: str, places: dict[str, Any] | None = None) -> Report:
    path = tmp_path / "g.yaml"
    path.write_text(text)
    engine = IntentEngine.from_files(path, locations=places or {"kitchen": (1.0, 2.0)})
    return check_grammar(engine.grammar, engine.locations)


def found(report: Report, *levels: str) -> list[tuple[str, str, int | None]]:
    return [(one.level, one.topic, one.problem.line) for one in report.findings if not levels or one.level in levels]


HEAD = "language: en\nslots: {thing: text, place: {type: location}, colour: {values: [green, blue]}}\nintents:\n"


def intents(**sentences: str) -> str:
    rows = (
        f"  {name}: {{action: {{type: custom, name: {name}}}, sentences: [{said}]}}\n"
        for name, said in sentences.items()
    )
    return HEAD + "".join(rows)


USE = "'see {thing}', 'visit {place}', 'paint it {colour}'"
"""Sentences that use every slot, so that none is called useless."""


def test_a_slot_of_every_kind_of_quantity_can_be_said(tmp_path):
    kinds = ["number", "ordinal", "distance", "angle", "duration", "speed", "angular_speed", "percent"]
    slots = ", ".join(f"{kind}: {{type: {kind}, max: 9}}" for kind in kinds)
    rows = "".join(
        f"  {kind}: {{action: custom, sentences: ['see {kind.replace('_', ' ')} {{{kind}}} now']}}\n" for kind in kinds
    )
    report = check(tmp_path, f"language: en\nslots: {{{slots}}}\nintents:\n{rows}")
    assert found(report, "error", "warning") == []


def test_two_meanings_of_the_same_words(tmp_path):
    report = check(tmp_path, intents(use=USE, a="'wave [at me]'", b="'(wave|bow) at me'"))
    assert found(report) == [("warning", "ambiguous", 6)]
    message = report.findings[0].problem.message
    assert message == "'wave at me' could be this sentence of 'b' or that of 'a' (line 5): the robot would ask"
    assert (report.figures.shared, report.figures.ambiguous) == (1, 1)


@pytest.mark.parametrize("language", ["de", "fr", "es", "it"])
def test_more_may_stand_behind_a_percentage(tmp_path, language):
    text = f"language: {language}\nslots: {{much: percent}}\nintents:\n"
    text += "  a: {action: custom, sentences: ['blip {much} blop']}\n"
    assert not found(check(tmp_path, text), "warning", "error")


def test_words_that_one_sentence_wins(tmp_path):
    report = check(tmp_path, intents(use=USE, a="'fetch {thing}'", b="'fetch the paper'"))
    assert found(report) == [("note", "overlap", 5)]
    assert "which wins: fewer of its words fall into free text" in report.findings[0].problem.message
    assert report.figures.ambiguous == 0


def test_a_sentence_that_always_loses(tmp_path):
    text = intents(use=USE, a="'fetch the (paper|mail)'", b="'fetch [the] paper'")
    lowered = text.replace("name: a}", "name: a}, priority: -1")
    assert found(check(tmp_path, lowered), "warning") == []
    dead = text.replace("'fetch [the] paper'", "'fetch the paper'").replace("name: b}", "name: b}, priority: -1")
    assert found(check(tmp_path, dead), "warning") == [("warning", "shadowed", 6)]


def test_a_sentence_that_says_nothing_new(tmp_path):
    report = check(tmp_path, intents(use=USE, a="'wave [at me]', 'wave at me'"))
    assert found(report) == [("note", "shadowed", 5)]
    assert report.findings[0].problem.hint == "it can be removed"


def test_a_sentence_that_nobody_can_say(tmp_path):
    text = intents(use=USE).replace("{type: location}", "{type: location, tags: [charger]}")
    report = check(tmp_path, text)
    assert found(report) == [("warning", "unreachable", 4)]
    assert "tags" in (report.findings[0].problem.hint or "")


def test_numbers_side_by_side_are_said_and_may_be_one(tmp_path):
    slots = "hive: {type: number, whole: true, max: 24}, syrup: {type: number, max: 5}, time: duration"
    text = (
        f"language: en\nslots: {{{slots}}}\nintents:\n"
        "  feed: {action: custom, sentences: ['feed hive {hive} {syrup} liters']}\n"
        "  smoke: {action: custom, sentences: ['smoke hive {hive} [{time}]']}\n"
        "  open: {action: custom, sentences: ['open hive {hive} for {time}']}\n"
    )
    report = check(tmp_path, text)
    assert found(report) == [("note", "slot", 4), ("note", "slot", 5)]
    told = report.findings[0].problem
    assert told.column
    assert told.message == ("{hive} and {syrup} are numbers side by side: what could be one number is refused")
    assert told.hint == "put a word between them: {hive} with {syrup}"
    engine = IntentEngine.from_files(tmp_path / "g.yaml")
    assert engine.parse("feed hive eight two liters").actions
    assert not engine.parse("feed hive twenty four liters").actions


def test_a_priority_decides_an_ambiguity(tmp_path):
    text = intents(use=USE, a="'wave [at me]'", b="'(wave|bow) at me'").replace("name: b}", "name: b}, priority: 1")
    assert found(check(tmp_path, text)) == [("note", "overlap", 5)]


def test_numbers_meet_words(tmp_path):
    text = intents(use=USE, a="'go {d}'", b="'go 7 meters'").replace("slots: {", "slots: {d: distance, ")
    assert ("warning", "ambiguous", 6) in found(check(tmp_path, text))
    assert ("warning", "ambiguous", 6) in found(check(tmp_path, text.replace("7", "two")))
    counted = intents(use=USE, a="'lift {n} cups'", b="'lift the two cups', 'lift two cups'")
    assert ("warning", "ambiguous", 6) in found(check(tmp_path, counted.replace("slots: {", "slots: {n: number, ")))


def test_names_that_sound_alike(tmp_path):
    places = {
        "kitchen": (1.0, 0.0),
        "kitchin": (2.0, 0.0),
        "hall": (3.0, 0.0),
        "bay 3": (4.0, 0.0),
        "bay 13": (5.0, 0.0),
    }
    report = check(tmp_path, intents(use=USE), places)
    (finding,) = report.findings
    assert (finding.level, finding.topic) == ("warning", "alike")
    assert finding.problem.message.startswith("'kitchen' and 'kitchin' sound alike")
    text = intents(use=USE).replace("[green, blue]", "{red: [crimson], blue: [crimsen]}")
    assert found(check(tmp_path, text)) == [("warning", "alike", 2)]
    assert found(check(tmp_path, text.replace("crimsen]}", "crimsen]}, fuzzy: false"))) == []


def test_what_is_told_of_a_map_has_its_line(tmp_path):
    (tmp_path / "m.yaml").write_text(
        "locations:\n  kitchen: {x: 1, y: 2}\n\n  kitchin:\n    {x: 1, y: 2}\n  bar/foyer: {x: 1, y: 2}\n"
        "  bath/sauna: {x: 1, y: 2, aliases: [bath]}\n  '5': {x: 1, y: 2}\n"
    )
    (tmp_path / "g.yaml").write_text(intents(use=USE))
    engine = IntentEngine.from_files(tmp_path / "g.yaml", locations=tmp_path / "m.yaml")
    told = [one.problem for one in check_grammar(engine.grammar, engine.locations).findings]
    assert sorted((one.line, one.column) for one in told) == [(4, 3), (6, 3), (8, 3)]
    assert any("'bar/foyer'" in one.message and "'bar per foyer'" in one.message for one in told)
    (tmp_path / "m.csv").write_text("name,x,y\n5,1,2\n")
    engine = IntentEngine.from_files(tmp_path / "g.yaml", locations=tmp_path / "m.csv")
    (only,) = check_grammar(engine.grammar, engine.locations).findings
    assert (only.problem.file, only.problem.line) == (str(tmp_path / "m.csv"), 2)


def test_a_place_that_is_not_on_the_map(tmp_path):
    text = HEAD + (
        "  use: {action: custom, sentences: ['see {thing}', 'visit {place}', 'paint it {colour}']}\n"
        "  a: {action: {type: navigate, location: kichen}, sentences: [dine]}\n"
        "  b: {action: navigate, defaults: {location: attic}, sentences: [climb]}\n"
        "  c: {action: {type: navigate, location: '{place}'}, sentences: [{say: sleep, slots: {place: bed}}]}\n"
        "  d: {action: custom, defaults: {place: cellar}, sentences: ['drink [at {place}]']}\n"
        "  e: {action: {type: navigate, location: '{colour}'}, sentences: ['run {colour}']}\n"
        "  f: {action: {type: navigate, location: kitchen}, sentences: [cook]}\n"
        "  g: {action: {type: custom, location: nowhere}, sentences: [dream]}\n"
    )
    report = check(tmp_path, text)
    rows = [(one.problem.line, one.problem.message.split("'")[3]) for one in report.findings if one.topic == "place"]
    assert rows == [(2, "green"), (2, "blue"), (5, "kichen"), (6, "attic"), (7, "bed"), (8, "cellar")]
    assert next(one for one in report.findings if one.problem.line == 5).problem.hint == "did you mean 'kitchen'?"


def test_names_of_places_that_are_commands(tmp_path, root):
    places = {name: (float(at), 0.0) for at, name in enumerate(("left", "back", "it", "stop", "turn left", "kitchen"))}
    engine = IntentEngine.from_files(root / "grammars/en.yaml", locations=places)
    report = check_grammar(engine.grammar, engine.locations)
    rows = [one.problem.message for one in report.findings if one.level == "warning" and one.problem.file is None]
    assert sorted(row.split(" (")[0] for row in rows) == [
        "'go back' could be the place 'back' or a command of 'move'",
        "'go left' could be the place 'left' or a command of 'turn'",
        "'it', a name of 'it', points to what was named before when it is said",
        "'stop', a name of 'stop', stops the robot when it is said",
        "'turn left', a name of 'turn left', is a command of 'turn' when it is said",
    ]


def test_aliases_of_one_place_are_no_rivals():
    assert list(alike([(("kitchen",), "kitchen"), (("kitchin",), "kitchen")])) == []


def test_the_shipped_grammar_has_no_errors_or_warnings(engine):
    report = check_grammar(engine.grammar, engine.locations)
    assert found(report, "error", "warning") == []
    assert report.figures.complete
    assert report.figures.word_states < 20_000


def test_what_the_walk_comes_upon_is_understood(engine):
    """The reduced grammar is a part of the whole one."""
    walk = explore(engine.grammar, engine.locations)
    matcher = engine.matcher()
    for meeting in walk.meetings[::25]:
        whole = {id(reading.sentence) for reading in matcher.read(list(meeting.words))}
        assert {id(reading.sentence) for reading in meeting.readings} <= whole, meeting.words
    lengths = [len(meeting.words) for meeting in walk.meetings]
    assert all(one <= other for one, other in pairwise(lengths)), "the shortest words come first"


def test_a_walk_that_is_cut_short_says_so(engine):
    walk = explore(engine.grammar, engine.locations, most=100)
    assert not walk.complete
    assert walk.states < 300


def _grammar(templates) -> Grammar:
    action = ActionSpec("custom", "x")
    sentences = [Sentence(template_text(node), node) for node in templates]
    made = {f"i{index}": Intent(f"i{index}", action, (sentence,)) for index, sentence in enumerate(sentences)}
    return Grammar("en", (), {}, {}, made, Operators(negation=(("not",),), stop=(("stop",),)))


@settings(max_examples=60, deadline=None)
@given(st.lists(trees(("a", "b", "c"), leaves=5), min_size=2, max_size=4))
def test_the_walk_finds_exactly_the_sentences_that_share_words(templates):
    """Against every way to say every sentence, written out."""
    grammar = _grammar(templates)
    said: dict[tuple[str, ...], set[str]] = {}
    for intent in grammar.intents.values():
        for words in spellings(intent.sentences[0].template, {}, 100_000):
            if words:
                said.setdefault(words, set()).add(intent.name)
    walk = explore(grammar, None)
    assert walk.complete
    met = {frozenset(reading.intent.name for reading in meeting.readings) for meeting in walk.meetings}
    assert met == {frozenset(names) for names in said.values()}


@settings(max_examples=60, deadline=None)
@given(trees(("a", "b", "c"), leaves=6))
def test_sizes_are_counted_as_if_written_out(template):
    ways = spellings(template, {}, 1_000_000)
    size = grammar_size(_grammar([template]), None)
    assert size.ways == size.spoken == len(ways)
    assert size.longest == max(map(len, ways))


def test_sizes_count_values_and_names(tmp_path):
    text = intents(use="'paint [it] {colour}', 'visit {place}', 'see {thing}'")
    figures = check(tmp_path, text, {"hall": (0.0, 0.0), "far end": (1.0, 0.0)}).figures.size
    assert (figures.sentences, figures.ways, figures.spoken, figures.names) == (3, 4, 7, 2)
    assert figures.longest == 5 + MOST_ARTICLES


def test_sizes_count_no_names_of_which_no_slot_takes_any(tmp_path):
    text = intents(use="'paint [it] {colour}'").replace("type: location", "type: text")
    assert check(tmp_path, text, {"hall": (0.0, 0.0)}).figures.size.names == 0


def test_sizes_count_the_names_of_the_places_that_a_slot_takes(tmp_path):
    text = intents(use="'visit {place}', 'open {door}'").replace("thing: text", "door: {type: location, tags: [door]}")
    places = {"hall": (0, 0), "gate": {"x": 1, "y": 1, "tags": ["door"], "aliases": ["barrier"]}}
    figures = check(tmp_path, text, places).figures.size
    assert (figures.ways, figures.spoken, figures.names) == (2, 3 + 2, 3)


def test_a_large_map_is_cut_to_what_may_clash(tmp_path):
    places = {f"bay {number}": (float(number), 0.0) for number in range(5_000)} | {"paper": (0.0, 1.0)}
    report = check(tmp_path, intents(use=USE, a="'visit paper'"), places)
    (finding,) = (one for one in report.findings if one.topic == "ambiguous")
    assert "could be the place 'paper' or a command of 'a'" in finding.problem.message
    assert report.figures.size.names == 5_001
    assert report.figures.word_states < 1_000


def test_json_holds_it_all(tmp_path):
    report = check(tmp_path, intents(use=USE, a="wave", b="'[please] wave'"))
    data = report.to_json()
    assert Counter(one["topic"] for one in data["findings"]) == {"ambiguous": 1}
    assert data["figures"]["intents"] == 3
    assert data["figures"]["complete"] is True
