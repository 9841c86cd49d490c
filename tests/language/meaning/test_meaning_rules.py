"""Every rule of meaning is needed: without it, some sentence of the table is done wrongly."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import pytest
from meanings import ROOT, does, done, shipped
from safety_table import MOTION_FORBIDDEN, NEGATED, STOP, TABLE, WHILE_MOVING, matches

from intent_engine.engine import IntentEngine
from intent_engine.language.grammar import Grammar, Operators
from intent_engine.language.locations import load
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.corrections.hesitation import Hesitations
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.meaning.joined_doubts import JoinedDoubts
from intent_engine.language.meaning.negations.negation import Negations
from intent_engine.language.meaning.not_commands.sayings import Sayings
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.run_on import RunOns
from intent_engine.language.meaning.stops import Stops
from intent_engine.language.meaning.wordings.numbers_in_pieces import NumbersInPieces
from intent_engine.language.meaning.wordings.whose_place import WhosePlace


def engine_with(grammar: Grammar) -> IntentEngine:
    return IntentEngine([grammar], load(ROOT / "locations" / "home.yaml"))


def failure(engine: IntentEngine, rows: dict[str, str]) -> str | None:
    """The first text that is done wrongly."""
    return next((text for text, meant in rows.items() if not matches(meant, done(engine.parse(text)))), None)


def goes_on(engine: IntentEngine, texts: Iterable[str]) -> str | None:
    """The first text that does not stop a robot that moves."""
    return next((text for text in texts if done(engine.parse(text, state=["moving"])) != "stop"), None)


ELSEWHERE = {("rather", "than"), ("in", "place", "of")}
"""Needed where free text is not a thing: test_words_that_exclude.py."""


@pytest.mark.slow
@pytest.mark.parametrize("words", sorted({*shipped().grammar.operators.negation} - ELSEWHERE), ids=" ".join)
def test_the_table_fails_without_a_word_of_negation(words: tuple[str, ...]) -> None:
    grammar = shipped().grammar
    operators = grammar.operators
    broken = replace(
        operators,
        negation=tuple(other for other in operators.negation if other != words),
        closed=operators.closed - set(words) if len(words) == 1 else operators.closed,
    )
    engine = engine_with(replace(grammar, operators=broken))
    said = " ".join(words)
    forbidden = sorted(MOTION_FORBIDDEN, key=lambda text: said not in text)  # those with the words are at fault first
    rows = dict(sorted({**NEGATED, **STOP}.items(), key=lambda row: said not in row[0]))
    assert goes_on(engine, forbidden) or failure(engine, rows), f"nothing needs {words}"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["negation", "correction", "cancel", "sequence", "contrast", "stop"])
def test_the_table_fails_without_a_list_of_operators(name: str) -> None:
    grammar = shipped().grammar
    broken = replace(grammar.operators, **{name: ()})
    assert failure(engine_with(replace(grammar, operators=broken)), TABLE)


def test_an_english_grammar_has_its_operators_whatever_its_author_writes() -> None:
    assert shipped().grammar.operators != Operators()


ALL_WAYS = RunOns._ways
RULES = {
    # Rule -> what it says when it is broken.
    (Negations, "wanted"): lambda self, core, state: (core, ""),
    (Phrases, "negated_before"): lambda self, words, position: False,
    (Stops, "in_a_sentence"): lambda self, core: False,
    (Stops, "_corrected_after"): lambda self, words, position: False,
    (Stops, "between"): lambda self, said, state: False,
    (Stops, "_only_commands"): lambda self, part, state: True,
    (Phrases, "joined_before"): lambda self, words, position: False,
    (Stops, "_clause_begins"): lambda self, words, start, position: True,
    (Phrases, "after_opening"): lambda self, words: 0,
    (Phrases, "only_stops"): lambda self, words, position: bool(words[position:]),
    (NumbersInPieces, "restarted"): lambda self, core, said: False,
    (Corrections, "_pause_after"): lambda self, part, position: True,
    (Corrections, "corrected"): lambda self, part, state, before="": None,
    (Corrections, "_corrected_before"): lambda self, part, state: None,
    (Replacements, "_grafted"): lambda self, slot, words, at, meant, whole, last: False,
    (Corrections, "taken_back"): lambda self, words: 0,
    (Compounds, "split"): lambda self, core, state, exactly=False: None,
    (JoinedDoubts, "unless_the_way_back"): lambda self, clause, onward: onward,
    (Sayings, "within"): lambda self, said, parts: "",
    (Hesitations, "or_either"): lambda self, parts, said, state: parts,
    (WhosePlace, "settled"): lambda self, reading: (reading, (), ""),
    (RunOns, "split"): lambda self, core, state: None,
    (RunOns, "_is_certain"): lambda self, clause, start: clause.accepted,
    (RunOns, "_is_thing"): lambda self, slot, reading: True,
    (RunOns, "_said_twice"): lambda self, parts: False,
    (RunOns, "_ways"): lambda self, core: ALL_WAYS(self, core)[-1:],
    (Commands, "holds_command"): lambda self, reading, words=(): False,
    (Phrases, "operate_in"): lambda self, words: False,
    (Stops, "heard"): lambda self, said, state: False,
}


@pytest.mark.slow
@pytest.mark.parametrize(("rule", "name"), RULES, ids=[f"{rule.__name__}.{name}" for rule, name in RULES])
def test_the_table_fails_without_a_rule(rule: type, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert hasattr(rule, name)
    monkeypatch.setattr(rule, name, RULES[rule, name])
    assert goes_on(shipped(), WHILE_MOVING) or failure(shipped(), TABLE), (
        f"no sentence of the table needs {rule.__name__}.{name}"
    )


FILLER_WORDS = {words[0] for words in shipped().grammar.fillers if len(words) == 1}


@pytest.mark.parametrize("word", sorted(shipped().grammar.operators.closed - FILLER_WORDS))
def test_a_closed_word_is_part_of_no_thing(word: str) -> None:
    text = f"pick up the cup {word} bottle"
    grammar = shipped().grammar
    broken = replace(grammar.operators, closed=grammar.operators.closed - {word})
    bare = replace(broken, negation=(), correction=(), cancel=(), sequence=(), contrast=(), stop=())
    assert "cup" not in does(text) or "bottle" not in does(text)
    assert done(engine_with(replace(grammar, operators=bare)).parse(text)) == f"pick cup {word} bottle"


TIE = """
language: en
slots: {time: {type: duration}}
intents:
  back: {action: {type: move, direction: backward}, sentences: ["back up {time:duration}"]}
  pause: {action: stop, sentences: ["back up a second"]}
"""


def test_of_two_meanings_as_good_as_each_other_a_stop_is_none_to_ask_about(engine_of):
    engine = engine_of(TIE)
    assert engine.parse("back up a second").stops
    assert not engine.parse("back up two seconds").stops
