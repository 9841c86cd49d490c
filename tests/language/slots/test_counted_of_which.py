"""Some of the things that there are: "sort five of the washers into the tray"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

ENGLISH = """
language: en
slots:
  object: [red block, bolt, washer, battery]
  bin: [tray, scrap bin]
  amount: {type: number, whole: true, min: 1, max: 20}
  share: {type: number, min: 0, max: 20}
  turns: {type: number, unit: turn, units: {1: [turn, turns]}}
  what: {type: text, max_words: 4}
intents:
  sort: {action: custom, sentences: ["sort {amount} {object} into [the] {bin}"]}
  cut: {action: custom, sentences: ["cut {share} {object}"]}
  name: {action: custom, sentences: ["name {what}", "call for {amount} {what}"]}
  wind: {action: custom, sentences: ["wind {turns} {object}"]}
  pick: {action: custom, sentences: ["take [the|a] {object}"]}
"""
FOREIGN = {
    "de": ("sortiere {n} {thing} in die Kiste", "[Schrauben, Muttern]", "sortiere fünf von den Schrauben in die Kiste"),
    "fr": ("range {n} {thing} dans le bac", "[vis, écrous]", "range cinq des écrous dans le bac"),
    "it": ("metti {n} {thing} nella scatola", "[viti, dadi]", "metti cinque delle viti nella scatola"),
}


@pytest.fixture(scope="module")
def engine(engine_of) -> IntentEngine:
    return engine_of(ENGLISH)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("sort five of the washers into the tray", [(5, "washer")]),
        ("sort five of those washers into the tray", [(5, "washer")]),
        ("please sort 12 of these red blocks into the scrap bin", [(12, "red block")]),
        ("sort one of the batteries into the tray", [(1, "battery")]),
        ("sort a dozen of the bolts into the tray", [(12, "bolt")]),
        ("sort a couple of the bolts into the tray", [(2, "bolt")]),
        ("can you sort twelve of the bolts into the tray?", [(12, "bolt")]),
        (
            "sort five of the washers into the tray and three of the bolts into the scrap bin",
            [(5, "washer"), (3, "bolt")],
        ),
    ],
)
def test_a_number_of_the_things_is_that_number_of_them(engine, said: str, meant: list[tuple[int, str]]) -> None:
    actions = engine.parse(said).actions
    assert [(action.slots["amount"], action.slots["object"]) for action in actions] == meant


@pytest.mark.parametrize(
    "said",
    [
        # All, a part, no number, or a number of a number.
        "sort all three of the washers into the tray",
        "sort half of the washers into the tray",
        "sort some of the washers into the tray",
        "sort most of the washers into the tray",
        "sort three of the five washers into the tray",
        "sort three of five washers into the tray",
        "sort two or three of the washers into the tray",
        "sort at least five of the washers into the tray",
        "sort none of the washers into the tray",
        "sort 2.5 of the washers into the tray",
        "cut two and a half of the washers",
        "cut zero of the washers",
        "sort twenty five of the washers into the tray",
        # Something else than a thing of the list.
        "sort five of the broken washers into the tray",
        "sort five of the kettles into the tray",
        "sort five of the washers that are dirty into the tray",
        "sort five of the washers and bolts into the tray",
        "sort five of them into the tray",
        "sort five, of the washers into the tray",
        "call for five of the men",
        "wind five of the washers",
        "take five of the washers",
        # No order.
        "don't sort five of the washers into the tray",
        "I sorted five of the washers into the tray",
        "did you sort five of the washers into the tray?",
        "sort five of the washers into the tray tomorrow",
    ],
)
def test_what_is_no_such_number_is_refused(engine, said: str) -> None:
    assert not [action for action in engine.parse(said).actions if action.name != "name"], said


def test_free_words_keep_it(engine) -> None:
    (action,) = engine.parse("name five of the men").actions
    assert action.slots["what"] == "five of the men"


@pytest.mark.parametrize("language", FOREIGN)
def test_in_other_languages(engine_of, language: str) -> None:
    sentence, things, said = FOREIGN[language]
    engine = engine_of(
        f"language: {language}\nslots: {{n: {{type: number, whole: true, min: 1}}, thing: {things}}}\n"
        f'intents: {{sort: {{action: custom, sentences: ["{sentence}"]}}}}\n'
    )
    assert [action.slots["n"] for action in engine.parse(said).actions] == [5]
