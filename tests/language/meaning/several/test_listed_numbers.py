"""Numbers that name several things in one command: "unlock drawer 3 and 4"."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Status

ENGLISH = """
language: en
slots:
  n: {type: number, min: 1, max: 600, whole: true}
  any: number
  count: {type: number, min: 1, max: 20, whole: true}
  drink: [coffee, tea]
  colour: [red, blue]
  how: [slowly, gently]
  digits: {type: number, digits: true}
  litres: {type: number, unit: liter, units: {1: [liter, liters]}}
  what: {type: text, max_words: 2}
  time: duration
  share: percent
  far: {type: distance, max: 20 m}
intents:
  unlock: {action: custom, sentences: ["unlock [the] drawer {n}"]}
  water: {action: custom, sentences: ["water row {any} [for {time}]"]}
  clear: {action: custom, sentences: ["clear [the] table {n}"]}
  go: {action: custom, sentences: ["go to bay {n}"], then: ["to bay {n}"]}
  put: {action: custom, sentences: ["put drawer {n} back"]}
  light: {action: custom, sentences: ["set lamp {n} to {colour}", "turn lamp {n} on"]}
  dim: {action: custom, defaults: {share: 50 %}, sentences: ["dim lamp {n} [to {share}]"]}
  lift: {action: custom, sentences: ["lift pallet {n} to shelf {n:shelf}"]}
  fan: {action: custom, sentences: ["set the fan to level {n}"]}
  cups: {action: custom, sentences: ["bring {count} cups", "bring {count} cups to table {n}"]}
  serve: {action: custom, sentences: ["bring {drink} to table {n}"]}
  ring: {action: custom, sentences: ["ring {n}", "ring bell {n} [{count} times]"]}
  wait: {action: custom, sentences: ["wait {time}", "wait at table {n}"]}
  valve: {action: custom, sentences: ["close valve {n} [{how}]"]}
  factor: {action: {type: change_speed, factor: "{any}"}, sentences: ["set factor {any}"]}
  gate: {action: custom, sentences: ["open gate {digits}"]}
  fill: {action: custom, sentences: ["fill tank {litres}"]}
  show: {action: custom, sentences: ["show {what} in the {colour} room"], then: ["{what} in the {colour} room"]}
  sugar: {action: custom, sentences: ["add sugar {n} spoons"]}
  spare: {action: custom, sentences: ["unlock all but drawer {n}"]}
  forward: {action: {type: move, direction: forward}, sentences: ["go forward {far:distance}"]}
  pair: {action: custom, sentences: ["join pipe {n} [and {n:other}]"]}
  lamp: {action: custom, sentences: ["switch on the lamp in the {colour} room"], then: ["the {colour} room"]}
"""
GERMAN = """
language: de
slots:
  n: {type: number, min: 1, max: 600, whole: true}
  count: {type: number, whole: true}
  far: {type: distance, max: 20 m}
intents:
  unlock: {action: custom, sentences: ["öffne [die] Schublade {n}", "öffne [das] Fach {n}"]}
  clear: {action: custom, sentences: ["räum [den] Tisch {n} ab"]}
  water: {action: custom, sentences: ["gieße [die] Reihe {n}"]}
  fan: {action: custom, sentences: ["stell den Lüfter auf Stufe {n}"]}
  cups: {action: custom, sentences: ["bring {count} Tassen"]}
  forward: {action: {type: move, direction: forward}, sentences: ["fahr {far:distance} vor"]}
"""
FRENCH = """
language: fr
slots: {n: {type: number, min: 1, max: 600, whole: true}, count: {type: number, whole: true}}
intents:
  unlock: {action: custom, sentences: ["ouvre [le] tiroir {n}"]}
  clear: {action: custom, sentences: ["nettoie [la] table {n}"]}
  cups: {action: custom, sentences: ["apporte {count} tasses"]}
"""
SPANISH = """
language: es
slots: {n: {type: number, min: 1, max: 600, whole: true}, count: {type: number, whole: true}}
intents:
  unlock: {action: custom, sentences: ["abre [el] cajón {n}"]}
  clear: {action: custom, sentences: ["limpia [la] mesa {n}"]}
  cups: {action: custom, sentences: ["trae {count} tazas"]}
"""
ITALIAN = """
language: it
slots: {n: {type: number, min: 1, max: 600, whole: true}, count: {type: number, whole: true}}
intents:
  unlock: {action: custom, sentences: ["apri [il] cassetto {n}"]}
  clear: {action: custom, sentences: ["pulisci [la] sala {n}"]}
  cups: {action: custom, sentences: ["porta {count} tazze"]}
"""
GRAMMARS = {"en": ENGLISH, "de": GERMAN, "fr": FRENCH, "es": SPANISH, "it": ITALIAN}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


def numbers(engine: IntentEngine, said: str, **options: object) -> list[int]:
    return [action.slots.get("n", action.slots.get("any")) for action in engine.parse(said, **options).actions]


LISTS = {
    "en": {
        "unlock drawer 3 and 4": [3, 4],
        "unlock drawer three and four": [3, 4],
        "unlock drawer 3, 4 and 5": [3, 4, 5],
        "unlock drawer 3, 4, and 5": [3, 4, 5],
        "unlock drawer 3, 4 - and 5": [3, 4, 5],
        "unlock drawer 3 - and clear table 4": [3, 4],
        "unlock drawer 3 and 4 and 7": [3, 4, 7],
        "unlock drawer 3 and also 4": [3, 4],
        "unlock drawer 3 and then 4": [3, 4],
        "please unlock drawer 3 and, uh, 4": [3, 4],
        "unlock drawer 3 and drawer 4": [3, 4],
        "unlock the drawer 3 and the drawer 4": [3, 4],
        "unlock drawer number 3 and 4": [3, 4],
        "unlock drawers 3 and 4": [3, 4],
        "unlock the drawers 3, 4 and 5": [3, 4, 5],
        "water rows 2, 3 and 5": [2, 3, 5],
        "unlock drawer 30 and 40": [30, 40],
        "unlock drawer twenty, twenty one and twenty two": [20, 21, 22],
        "go to bay 3 and 4": [3, 4],
        "go to bay 3 and then to bay 4 and 5": [3, 4, 5],
        "put drawer 3 and 4 back": [3, 4],
        "close valves 3 and 4 slowly": [3, 4],
        "wait at table 3 and 4": [3, 4],
        "unlock drawer, uh, 3 and 4": [3, 4],
        "unlock drawer 1, 2, 3, 4, 5, 6, 7 and 8": [1, 2, 3, 4, 5, 6, 7, 8],
        "unlock drawer 1, 2, 3, 4, 5, 6 and 7 and clear table 8": [1, 2, 3, 4, 5, 6, 7, 8],
        "set lamp 3 and 4 to red": [3, 4],
        "turn lamp 3 and 4 on": [3, 4],
        "dim lamps 3 and 4 to ten percent": [3, 4],
        "lift pallet 3 and 4 to shelf 5": [3, 4],
        "unlock drawer 3 and 4 and clear table 5 and 6": [3, 4, 5, 6],
        "don't unlock drawer 3, unlock drawer 4 and 5": [4, 5],
        "unlock drawer 3 and 4 and stop": [3, 4],
        "first clear table 1 and 2, then unlock drawer 3": [1, 2, 3],
    },
    "de": {
        "öffne Schublade 3 und 4": [3, 4],
        "öffne die Schubladen 3, 4 und 5": [3, 4, 5],
        "öffne die Fächer drei und vier": [3, 4],
        "räum Tisch 3 und 4 ab": [3, 4],
        "räum die Tische 3 und 4 ab": [3, 4],
        "gieße die Reihen 2, 3 und dann 5": [2, 3, 5],
    },
    "fr": {"ouvre les tiroirs 3 et 4": [3, 4], "nettoie la table trois, quatre et cinq": [3, 4, 5]},
    "es": {"abre los cajones 3 y 4": [3, 4], "limpia la mesa tres, cuatro y cinco": [3, 4, 5]},
    "it": {"apri i cassetti 3 e 4": [3, 4], "pulisci le sale tre e quattro": [3, 4]},
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [(language, said, meant) for language, rows in LISTS.items() for said, meant in rows.items()],
)
def test_the_command_is_done_for_each(engines, language: str, said: str, meant: list[int]) -> None:
    assert numbers(engines[language], said) == meant
    assert numbers(engines[language], said, spoken=True) == meant


NONE = {
    "en": [
        "unlock drawer 100 and 4, then drawer 200 and 5",
        "unlock drawer twenty and four",
        "unlock drawer 20 and 4",
        "unlock drawer 200 and 31",
        "unlock drawer 3 and a half",
        "unlock drawer 3 and 4 and a half",
        "unlock drawer 2 to 5",
        "unlock drawers 2 to 5 and 6",
        "unlock drawer 2-5",
        "unlock drawers 2-5 and 7",
        "unlock drawers 2 - 5 and 7",
        "unlock drawers 2 – 5 and 7",
        "unlock drawers 1, 3 - 5 and 7",
        "unlock drawers two - five and seven",
        "unlock drawer 3 or 4",
        "unlock drawer 3, 4 or 5",
        "unlock drawer 3 and 4 or 5",
        "unlock drawer 3, 4",
        "unlock drawer 3 4",
        "unlock drawer 3, uh, 4 and 5",
        "unlock drawer 3, wait, 4 and 5",
        "unlock drawer 3 and 3",
        "unlock drawer 3, 4 and 3",
        "unlock drawer 3 and -4",
        "unlock drawer 3.5 and 4",
        "water row 3.5 and 4",
        "water row 3 and minus 4",
        "water row 3 and -4",
        "unlock drawer 3 and not 4 and 5",
        "don't unlock drawer 3 and 4",
        "unlock drawer 3 and 4 never mind",
        "unlock drawer 3 and 4 unless it is late",
        "did you unlock drawer 3 and 4",
        "unlock drawer 1, 2, 3, 4, 5, 6, 7, 8 and 9",
        "unlock drawer 1, 2, 3, 4, 5, 6, 7 and 8 and clear table 9",
        "clear table 9 and unlock drawer 1, 2, 3, 4, 5, 6, 7 and 8",
        "unlock all but drawer 3 and 4",
        # One thing, and how much of it; or a number that counts.
        "set the fan to level 3 and 4",
        "bring 2 and 3 cups",
        "bring 3 and 4 cups to table 5 and 6",
        "bring 3 cups to table 5 and 6",
        "bring coffee to table 5 and 6",
        "lift pallet 3 to shelf 4 and 5",
        "ring 3 and 4",
        "ring bell 3 and 4 times",
        "set factor 2 and 3",
        "add sugar 2 and 3 spoons",
        "open gate three, four and five",
        "open gates fourteen, fifteen and sixteen",
        "open gates one two and three four",
        "open gates 1 2 and 3",
        "open gates twenty and three",
        "fill tank 3 and 4",
        "wait 5 and 10 seconds",
        "go forward 3 and 4 meters",
        "dim lamp 3 to 20 and 30 percent",
        # The grammar has its own list.
        "join pipe 3 and 4 and 5",
    ],
    "de": [
        "öffne Schublade fünf und zwanzig und öffne Fach 3 oder 4",
        "öffne Schublade 5 und 20",
        "öffne Schublade 2 bis 5",
        "stell den Lüfter auf Stufe 3 und 4",
        "bring 2 und 3 Tassen",
        "öffne nicht Schublade 3 und 4",
        "fahr 3 und 4 Meter vor",
    ],
    "fr": ["ouvre le tiroir 3 ou 4", "apporte 2 et 3 tasses", "ouvre le tiroir dix, sept et vingt"],
    "es": ["abre el cajón 3 o 4", "trae 2 y 3 tazas"],
    "it": ["apri il cassetto 3 o 4", "porta 2 e 3 tazze"],
}


@pytest.mark.parametrize(("language", "said"), [(language, said) for language, rows in NONE.items() for said in rows])
def test_what_may_be_meant_otherwise_is_no_list(engines, language: str, said: str) -> None:
    assert len(engines[language].parse(said).actions) <= 1
    assert len(engines[language].parse(said, heard=True).actions) <= 1


def test_a_number_in_words_stays_one(engines) -> None:
    assert numbers(engines["en"], "unlock drawer a hundred and four") == [104]
    assert numbers(engines["de"], "öffne Schublade fünf und zwanzig") == [25]
    assert numbers(engines["fr"], "ouvre le tiroir vingt et un") == [21]
    assert numbers(engines["es"], "abre el cajón treinta y cuatro") == [34]


def test_a_sentence_with_two_numbers_of_its_own_has_both(engines) -> None:
    (action,) = engines["en"].parse("join pipe three and four").actions
    assert dict(action.slots) == {"n": 3, "other": 4}


ROWS = {
    "open gates 14 and 15": [14, 15],
    "open gate 3 and 5": [3, 5],
    "open gates three and five": [3, 5],
    "open gates 14, 15 and 16": [14, 15, 16],
    "open gates 140 and 150": [140, 150],
    "open gates one two zero seven and one two zero eight": [1207, 1208],
    "open gate 14 15": [1415],
    "open gate one two zero seven": [1207],
    # Of more than one gate the digits are no row.
    "open gates 14, 15": [],
    "open gates 14-16": [],
    "open gates 1-4": [],
    "open gates three four": [],
    "open gates 14 through 16": [],
    "open gates 14 to 16": [],
}


@pytest.mark.parametrize(("said", "meant"), ROWS.items())
def test_numbers_that_may_be_said_digit_by_digit(engines, said: str, meant: list[int]) -> None:
    assert [action.slots["digits"] for action in engines["en"].parse(said).actions] == meant


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("water rows 2 and 3 for ten minutes", "or for all together"),
        ("dim lamp 3 and 4 to ten percent", "or for the last"),
        ("clear table 5 and water row 2 and 3 for ten minutes", "or for all together"),
    ],
)
def test_what_may_be_for_all_or_the_last_is_asked(engines, said: str, told: str) -> None:
    found = engines["en"].parse(said)
    assert (found.status, found.actions) == (Status.AMBIGUOUS, ())
    assert told in found.reason


@pytest.mark.parametrize("said", ["unlock drawer 3 and 900", "clear table 1 and unlock drawers 3, 5 and 900"])
def test_one_beyond_its_limits_refuses_all(engines, said: str) -> None:
    found = engines["en"].parse(said)
    assert not found.actions
    assert "900 is more than the largest" in found.reason


def test_each_of_several_things_that_are_no_numbers(engines) -> None:
    engine = engines["en"]
    colours = [
        action.slots["colour"]
        for action in engine.parse("switch on the lamps in the red room and the blue room").actions
    ]
    assert colours == ["red", "blue"]
    assert not engine.parse("switch on the lamps in the red room").actions
    assert not engine.parse("show lamps in the red room and cups in the blue rooms").actions  # one lamp was not said
    assert engine.parse("show lights in the red room and cups in the blue rooms").actions
    assert not engine.parse("switch on the lamps in the red room and clear table 5").actions


def test_the_beginning_of_a_list_goes_on(engines) -> None:
    engine = engines["en"]
    said = ["unlock", "drawer", "three", "and", "four", "and", "then", "seven"]
    for count in range(1, len(said) + 1):
        assert engine.prefix(" ".join(said[:count])).status is not PrefixStatus.IMPOSSIBLE, said[:count]
        assert engine.matcher().likely.walk(said[:count])[1] is not None  # a recogniser is led along it
    assert engine.prefix("unlock drawer three and").status is PrefixStatus.INCOMPLETE
    assert engine.prefix(" ".join(said)).status in (PrefixStatus.COMPLETE, PrefixStatus.EXTENDABLE)


# -- laws -----------------------------------------------------------------------------------------------------

laws = settings(max_examples=150, deadline=None, derandomize=True)
SAID = {
    "en": [("unlock drawer", "unlock drawer", ""), ("unlock the drawers", "unlock the drawer", ""),
           ("put drawer", "put drawer", " back"), ("go to bays", "go to bay", "")],
    "de": [("öffne Schublade", "öffne Schublade", ""), ("öffne die Fächer", "öffne das Fach", ""),
           ("räum Tisch", "räum Tisch", " ab"), ("räum die Tische", "räum den Tisch", " ab")],
    "fr": [("ouvre le tiroir", "ouvre le tiroir", ""), ("nettoie les tables", "nettoie la table", "")],
    "es": [("abre el cajón", "abre el cajón", ""), ("abre los cajones", "abre el cajón", "")],
    "it": [("apri il cassetto", "apri il cassetto", ""), ("pulisci le sale", "pulisci la sala", "")],
}  # fmt: skip
"""What is said before a list, before one of it, and behind both."""
JOINTS = {"en": "and", "de": "und", "fr": "et", "es": "y", "it": "e"}


@st.composite
def several(draw) -> tuple[str, str, str, str, list[int]]:
    """A language, what is said before a list, before one of it and behind both, and numbers as people list them."""
    language = draw(st.sampled_from(sorted(SAID)))
    listed = sorted(draw(st.sets(st.integers(1, 600), min_size=2, max_size=8)))
    assume(not any(one < 10 and 20 <= other < 100 and other % 10 == 0 for one, other in pairwise(listed)))
    return language, *draw(st.sampled_from(SAID[language])), listed


def as_list(language: str, listed: list[int]) -> str:
    *first, last = map(str, listed)
    return f"{', '.join(first)} {JOINTS[language]} {last}"


@laws
@given(several())
def test_a_list_is_the_commands_said_singly(engines, said) -> None:
    language, before, one, behind, listed = said
    engine = engines[language]
    singly = [engine.parse(f"{one} {number}{behind}") for number in listed]
    whole = engine.parse(f"{before} {as_list(language, listed)}{behind}")
    assert whole.actions == tuple(action for found in singly for action in found.actions)
    assert [step["slots"] for step in whole.slots["steps"]] == [dict(found.slots) for found in singly]


@laws
@given(several(), st.data())
def test_in_any_order_it_is_that_order_or_nothing(engines, said, data) -> None:
    language, before, _, behind, listed = said
    mixed = data.draw(st.permutations(listed))
    assert numbers(engines[language], f"{before} {as_list(language, mixed)}{behind}") in ([], mixed)


@laws
@given(several(), st.sampled_from(["or", "to", "-", ",", "oder", "bis", "ou", "à", "o", "a"]))
def test_no_other_joint_makes_a_list(engines, said, joint) -> None:
    language, before, _, behind, listed = said
    text = f"{before} {f' {joint} '.join(map(str, listed))}{behind}"
    assert len(engines[language].parse(text).actions) <= 1


@laws
@given(several(), st.sampled_from(["don't", "do not", "never"]))
def test_a_list_is_denied_as_a_whole(engines, said, word) -> None:
    assert not engines["en"].parse(f"{word} unlock drawer {as_list('en', said[-1])}").actions
