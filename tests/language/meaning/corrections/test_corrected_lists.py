"""Lists that were corrected while they were said: "unlock drawer 3 and 4, no, 5"."""

from __future__ import annotations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine

ENGLISH = """
language: en
slots:
  n: {type: number, min: 1, max: 600, whole: true}
  row: {type: ordinal, max: 9}
  fader: {type: choice, values: {A: a, B: b, C: c}}
  share: percent
  room: [kitchen, hall, lab]
intents:
  unlock: {action: custom, sentences: ["unlock [the] drawer {n}"]}
  lock: {action: custom, sentences: ["lock drawer {n}"]}
  open: {action: custom, sentences: ["open the {row} window"]}
  fade: {action: custom, sentences: ["fade {fader} to {share}"]}
  dim: {action: custom, sentences: ["dim the lights in the {room} to {share}"]}
  lift: {action: custom, sentences: ["lift pallet {n} to shelf {n:shelf}"]}
  stop: {action: stop, sentences: [stop]}
"""
GERMAN = """
language: de
slots: {n: {type: number, min: 1, max: 600, whole: true}, ventil: {type: ordinal, max: 9}}
intents:
  fach: {action: custom, sentences: ["öffne [das] Fach {n}", "räum [den] Tisch {n} ab"]}
  ventil: {action: custom, sentences: ["öffne das {ventil} Ventil"]}
"""
FRENCH = "language: fr\nslots: {n: {type: number, min: 1, whole: true}}\nintents: {o: {action: custom, sentences: ['ouvre [le] tiroir {n}']}}\n"  # noqa: E501
SPANISH = "language: es\nslots: {n: {type: number, min: 1, whole: true}}\nintents: {o: {action: custom, sentences: ['abre [el] cajón {n}']}}\n"  # noqa: E501
ITALIAN = "language: it\nslots: {n: {type: number, min: 1, whole: true}}\nintents: {o: {action: custom, sentences: ['apri [il] cassetto {n}']}}\n"  # noqa: E501
GRAMMARS = {"en": ENGLISH, "de": GERMAN, "fr": FRENCH, "es": SPANISH, "it": ITALIAN}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


def values(engine: IntentEngine, said: str) -> list[object]:
    return [next(iter(action.slots.values())) for action in engine.parse(said).actions]


MEANT = {
    "en": {
        "unlock drawer 3 and 4, no, 5": [3, 5],
        "unlock drawer 3 and 4, no wait, 5": [3, 5],
        "unlock drawers 3, 4 and 5, sorry, 6": [3, 4, 6],
        "unlock drawers 3 and 4, no, drawer 5": [3, 5],
        "unlock drawers 3 and 4, no wait, 4 and 5": [4, 5],
        "unlock drawer 3 and 4, I mean 3 and 5": [3, 5],
        "unlock drawer 3, no, 4 and 5": [4, 5],
        "unlock drawer 3 and 4, no, 5, then open the first window": [3, 5, 1.0],
        "no, unlock drawer 3 and 4": [3, 4],
        "actually, unlock the drawers 3 and 4": [3, 4],
        "no, open the first and the third window": [1.0, 3.0],
        "open the first and the third window, no, the fourth": [1.0, 4.0],
        "open the first and the third window, no, the fourth window": [1.0, 4.0],
        "open the first and the third window, no, the second and the fourth": [2.0, 4.0],
        "fade A to 20 percent and B to 30 percent, no, C": ["A", "C"],
    },
    "de": {
        "öffne Fach 3 und 4, nein, 5": [3, 5],
        "öffne Fach 3 und 4, nein, 4 und 5": [4, 5],
        "räum Tisch 3 und 4 ab, ich meine 5": [3, 5],
        "nein, öffne Fach 3 und 4": [3, 4],
        "öffne das erste und das dritte Ventil, nein, das vierte": [1.0, 4.0],
    },
    "fr": {"ouvre le tiroir 3 et 4, non, 5": [3, 5], "non, ouvre le tiroir 3 et 4": [3, 4]},
    "es": {"abre el cajón 3 y 4, no, 5": [3, 5], "no, abre el cajón 3 y 4": [3, 4]},
    "it": {"apri il cassetto 3 e 4, no, 5": [3, 5], "no, apri il cassetto 3 e 4": [3, 4]},
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [(language, said, meant) for language, rows in MEANT.items() for said, meant in rows.items()],
)
def test_what_is_meant_at_last(engines, language: str, said: str, meant: list[object]) -> None:
    assert values(engines[language], said) == meant
    assert values(engines[language], said.capitalize() + ".") == meant


def test_an_amount_of_the_last_is_corrected_in_the_last(engines) -> None:
    found = engines["en"].parse("fade A to 20 percent and B to 30 percent, no, 40 percent")
    assert [action.slots["share"] for action in found.actions] == [0.2, 0.4]
    assert found.corrected


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "unlock drawers 3, 4 and 5, no, 6 and 7"),
        ("en", "unlock drawer 3 and 4, no, 3"),
        ("en", "unlock drawer 3 and 4, no, 900"),
        ("en", "unlock drawer 3 and 4 no 5"),
        ("en", "unlock drawer 3 and 4, no, 5, no, 6 and 7"),
        ("en", "unlock drawer 3 and 4, not 5"),
        ("en", "unlock drawer 3 and 4, no"),
        ("en", "unlock drawer 3 and 4, no, the kitchen"),
        ("en", "unlock drawer 3 or 4, no, 5"),
        ("en", "unlock drawer 3 and 4, no, 5 or 6"),
        ("en", "don't unlock drawer 3 and 4, no, 5"),
        ("en", "no unlock drawer 3 and 4"),
        ("en", "he said no, unlock drawer 3 and 4"),
        ("en", "lift pallet 3 to shelf 4, no, 5 and 6"),
        ("en", "lift pallet 3 and 4 to shelf 5, no, 6"),
        ("en", "dim the lights in the kitchen and the hall to 20 percent, no, 30 percent"),
        ("en", "unlock drawer 3 and 4, no, never mind"),
        ("de", "öffne Fach 3 und 4, nein, 5 oder 6"),
        ("de", "öffne Fach 3 und 4, nein, nicht 5"),
        ("fr", "ouvre le tiroir 3 ou 4, non, 5"),
        ("es", "abre el cajón 3 y 4, no"),
        ("it", "apri il cassetto 3 o 4, no, 5"),
    ],
)
def test_what_is_not_sure_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize("meant", ["6 and 7", "the kitchen", "3"])
def test_what_it_takes_the_place_of_is_asked(engines, meant: str) -> None:
    found = engines["en"].parse(f"unlock drawers 3, 4 and 5, no, {meant}")
    assert found.reason == f"it is not clear what '{meant}' takes the place of; say the whole command again"


def test_a_whole_command_and_a_stop_are_themselves(engines) -> None:
    assert engines["en"].parse("unlock drawer 3 and 4, no, stop").stops
    assert [action.name for action in engines["en"].parse("unlock drawer 3 and 4, no, lock drawer 5").actions] == [
        "lock"
    ]


laws = settings(max_examples=100, deadline=None, derandomize=True)
SAID = {
    "en": ("unlock drawer", "and", "no"),
    "de": ("öffne Fach", "und", "nein"),
    "fr": ("ouvre le tiroir", "et", "non"),
    "es": ("abre el cajón", "y", "no"),
    "it": ("apri il cassetto", "e", "no"),
}


@laws
@given(st.sampled_from(sorted(SAID)), st.lists(st.integers(1, 19), min_size=2, max_size=4, unique=True), st.data())
def test_the_last_is_replaced_and_all_others_stay(engines, language: str, listed: list[int], data) -> None:
    before, joint, no = SAID[language]
    other = data.draw(st.integers(1, 19))
    assume(other not in listed)
    *first, last = map(str, listed)
    found = values(engines[language], f"{before} {', '.join(first)} {joint} {last}, {no}, {other}")
    assert found == [*listed[:-1], other]
