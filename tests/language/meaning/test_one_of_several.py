"""What names two things of which one is meant asks which, in the order in which they were said."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

ENGLISH = """
language: en
slots:
  room: [kitchen, hall, lab]
  n: {type: number, min: 1, max: 60, whole: true}
  row: {type: ordinal, max: 9}
  share: percent
  side: [left, right]
  title: {type: text, max_words: 4}
intents:
  go: {action: custom, sentences: ["go to the {room}"]}
  unlock: {action: custom, sentences: ["unlock drawer {n}"]}
  open: {action: custom, sentences: ["open the {row} window"]}
  dim: {action: custom, sentences: ["dim the lights to {share}"]}
  turn: {action: custom, sentences: ["turn {side}"]}
  play: {action: custom, sentences: ["play {title}"]}
  stop: {action: stop, sentences: [stop]}
"""
GERMAN = """
language: de
slots: {n: {type: number, min: 1, max: 60, whole: true}, raum: [Flur, Bad, Küche]}
intents:
  fach: {action: custom, sentences: ["öffne Fach {n}"]}
  licht: {action: custom, sentences: ["mach das Licht (in der|im) {raum} an"]}
"""
FRENCH = "language: fr\nslots: {n: {type: number, whole: true}}\nintents: {o: {action: custom, sentences: ['ouvre le tiroir {n}']}}\n"  # noqa: E501
SPANISH = "language: es\nslots: {n: {type: number, whole: true}}\nintents: {o: {action: custom, sentences: ['abre el cajón {n}']}}\n"  # noqa: E501
ITALIAN = "language: it\nslots: {n: {type: number, whole: true}}\nintents: {o: {action: custom, sentences: ['apri il cassetto {n}']}}\n"  # noqa: E501
GRAMMARS = {"en": ENGLISH, "de": GERMAN, "fr": FRENCH, "es": SPANISH, "it": ITALIAN}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


@pytest.mark.parametrize(
    ("language", "said", "names", "answer", "meant"),
    [
        ("en", "go to the lab or the hall", ("the lab", "the hall"), "the first", "go to the lab"),
        ("en", "go to the lab or the hall", ("the lab", "the hall"), "the second one", "go to the hall"),
        ("en", "go to the lab, the kitchen or the hall", ("the lab", "the kitchen", "the hall"), "the last",
         "go to the hall"),
        ("en", "unlock drawer 13 or 30", ("13", "30"), "thirty", "unlock drawer 30"),
        ("en", "open the first or the third window", ("the first", "the third"), "the third", "open the third window"),
        ("en", "turn left or right", ("left", "right"), "left", "turn left"),
        ("de", "öffne Fach 13 oder 30", ("13", "30"), "dreizehn", "öffne Fach 13"),
        ("de", "öffne Fach 13 oder 30", ("13", "30"), "das zweite", "öffne Fach 30"),
        ("de", "mach das Licht im Bad oder im Flur an", ("im bad", "im flur"), "im Flur", "mach das Licht im Flur an"),
        ("fr", "ouvre le tiroir 13 ou 30", ("13", "30"), "treize", "ouvre le tiroir 13"),
        ("es", "abre el cajón 13 o 30", ("13", "30"), "trece", "abre el cajón 13"),
        ("it", "apri il cassetto 13 o 30", ("13", "30"), "tredici", "apri il cassetto 13"),
    ],
)  # fmt: skip
def test_it_asks_which_and_an_answer_tells(engines, language, said, names, answer, meant) -> None:
    engine = engines[language]
    asked = engine.parse(said)
    assert (asked.status, asked.actions, asked.alternatives) == (Status.REJECTED, (), names)
    assert asked.reason == f"one of them is meant; say which: {' or '.join(names)}"
    found = engine.parse(answer, last=asked)
    assert found.actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "go to the lab or the moon",
        "go to the lab or the hall?",
        "do not go to the lab or the hall",
        "go to the lab or not",
        "go to the lab or the lab",
        "go to the lab or go to the hall",
        "go to the lab or the hall and stop",
        "turn left or the hall",
        "he said go to the lab or the hall",
        "go to the lab, or the hall, no",
        "play this or that",
    ],
)
def test_nothing_is_asked_where_it_is_no_such_pair(engines, said: str) -> None:
    found = engines["en"].parse(said)
    assert "one of them is meant" not in found.reason
    assert found.stops or not found.actions


@pytest.mark.parametrize("answer", ["neither", "no", "both", "yes", "the third", "maybe"])
def test_what_tells_none_of_them_does_nothing(engines, answer: str) -> None:
    engine = engines["en"]
    assert not engine.parse(answer, last=engine.parse("go to the lab or the hall")).actions
