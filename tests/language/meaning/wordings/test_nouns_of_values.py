"""Things that are told apart by a value before their noun: "the green cube", "it", "the red one"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

GRAMMARS = {
    "en": """
language: en
slots:
  colour: [red, green, dark blue]
  shape: [cube, ball]
  size: [big, small]
  target: [left bin, tray]
  n: {type: number, min: 1, max: 9, whole: true}
  degrees: {type: number, min: -90, max: 90}
intents:
  grab: {action: custom, sentences: ["(grab|pick up) the [{size}] [{colour}] {shape}"]}
  place: {action: custom, sentences: ["(put|place) the [{size}] [{colour}] {shape} (in|on) the {target}"]}
  weigh: {action: custom, sentences: ["weigh the {shape}"]}
  paint: {action: custom, sentences: ["open the {colour} lid", "close the {colour} lid"]}
  turn: {action: custom, sentences: ["turn the wrist to {degrees} degrees"]}
""",
    "valves": """
language: en
slots: {n: {type: ordinal, max: 8}, door: {type: ordinal, max: 3}}
intents:
  open: {action: custom, sentences: ["open the {n} valve", "open the {door} door"]}
  close: {action: custom, sentences: ["close the {n} valve", "turn the {n} valve off"]}
  wait: {action: custom, sentences: [rest]}
""",
    "es": """
language: es
slots: {n: {type: ordinal, max: 8}}
intents:
  abrir: {action: custom, sentences: ["abre la {n} válvula"]}
  cerrar: {action: custom, sentences: ["cierra la {n} válvula"]}
""",
    "de": """
language: de
slots:
  nummer: {type: number, min: 1, max: 9, whole: true}
  form: [Würfel, Becher]
  ziel: [Tablett, Regal]
intents:
  nehmen: {action: custom, sentences: ["nimm den {form} [{nummer}]"]}
  stellen: {action: custom, sentences: ["stell den {form} [{nummer}] auf das {ziel}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "grab the green cube and put it on the tray", "grab the green cube and put the green cube on the tray"),
        ("en", "grab the cube and put that in the left bin", "grab the cube and put the cube in the left bin"),
        (
            "en",
            "grab the big dark blue ball, then place that one on the tray",
            "grab the big dark blue ball, then place the big dark blue ball on the tray",
        ),
        ("en", "grab the green cube and weigh it", "grab the green cube and weigh the cube"),
        ("en", "grab the green cube and weigh this", "grab the green cube and weigh the cube"),
        ("en", "grab the green cube and then the red one", "grab the green cube and then grab the red cube"),
        ("en", "grab the red ball, then grab the dark blue one", "grab the red ball, then grab the dark blue ball"),
        (
            "en",
            "put the red ball on the tray and the green one in the left bin",
            "put the red ball on the tray and put the green ball in the left bin",
        ),
        ("en", "open the red lid and close the green one", "open the red lid and close the green lid"),
        ("valves", "close the first valve and open the second", "close the first valve and open the second valve"),
        ("valves", "close the first valve, then open the last one", "close the first valve, then open the last valve"),
        ("valves", "open the second door, rest and open the third", "open the second door, rest, open the third door"),
        ("valves", "open the first valve and turn the third one off", "open the first valve, turn the third valve off"),
        ("es", "cierra la primera válvula y abre la segunda", "cierra la primera válvula y abre la segunda válvula"),
        ("de", "nimm den Würfel und stell den auf das Regal", "nimm den Würfel und stell den Würfel auf das Regal"),
    ],
)
def test_it_and_one_are_what_was_named(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


def test_a_value_is_told_as_it_is_said(engine_of) -> None:
    grammar = """
language: en
slots:
  colour: {type: choice, values: {"": [plain], "#f00": [red, scarlet]}}
  shape: [cube, ball]
intents: {grab: {action: custom, sentences: ["grab the [{colour}] {shape}"]}}
"""
    found = engine_of(grammar).parse("grab the plain cube and then the scarlet one")
    assert [action.slots for action in found.actions] == [
        {"colour": "", "shape": "cube"},
        {"colour": "#f00", "shape": "cube"},
    ]


def test_so_it_is_in_the_next_utterance(engine_of) -> None:
    engine: IntentEngine = engine_of(GRAMMARS["en"])
    before = engine.parse("grab the green cube", last=())
    for text in ("put it on the tray", "put that on the tray"):
        assert engine.parse(text, last=before).actions == engine.parse("put the green cube on the tray").actions
        assert engine.parse(text, last=before).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "put it on the tray"),
        ("en", "grab the red one"),
        ("en", "grab the cube, then grab the red one"),
        ("en", "grab the green cube, open the red lid and grab the red one"),
        ("en", "grab the green cube and put the one on the tray"),
        ("en", "grab the green cube and not the green one"),
        ("en", "grab the green cube and put that ring on the tray"),
        ("en", "grab the green cube, then the red ball and put that on the tray"),
        ("en", "turn the wrist to green one"),
        ("valves", "open the second"),
        ("valves", "rest and open the second"),
        ("valves", "open the second and close the first valve"),
        ("valves", "close the first valve, open the second door and open the third"),
        ("valves", "close the first valve and don't open the second"),
        ("valves", "open the second door and close the third"),
    ],
)
def test_where_nothing_or_more_was_named_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions


def test_a_noun_behind_that_is_what_is_meant(engine_of) -> None:
    engine = engine_of(GRAMMARS["en"])
    found = engine.parse("grab the green cube and put that ball on the tray")
    assert found.actions[1].slots == {"shape": "ball", "target": "tray"}
