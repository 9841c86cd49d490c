"""German orders behind what wishes or begs, in which the verb stands last, with or without a "zu"."""

from __future__ import annotations

import pytest

KITCHEN = """
language: de
slots:
  teil: object
  ort: [Küche, Labor]
  weite: distance
intents:
  öffnen: {action: custom, sentences: ["öffne {teil}"]}
  heben: {action: custom, sentences: ["heb {teil} auf"]}
  hin: {action: custom, sentences: ["fahr (zum|in die) {ort}"]}
  vor: {action: custom, sentences: ["fahr {weite} vor"]}
  drehen: {action: custom, sentences: ["dreh dich um"]}
  halt: {action: stop, sentences: [stopp]}
"""


@pytest.mark.parametrize(
    ("said", "intent", "slots"),
    [
        ("ich bitte dich, die Zange zu öffnen", "öffnen", {"teil": "zange"}),
        ("darf ich Sie bitten, in die Küche zu fahren?", "hin", {"ort": "Küche"}),
        ("versuch mal, die Zange aufzuheben", "heben", {"teil": "zange"}),
        ("wärst du so nett, zwei Meter vorzufahren", "vor", {"weite": 2.0}),
        ("würden Sie so freundlich sein, die Zange zu öffnen", "öffnen", {"teil": "zange"}),
        ("sei so gut, dich umzudrehen", "drehen", {}),
        ("sei so gut und öffne die Zange", "öffnen", {"teil": "zange"}),
        ("schau, dass du in die Küche fährst", "hin", {"ort": "Küche"}),
        ("sieh zu, dass du die Zange öffnest", "öffnen", {"teil": "zange"}),
        ("ich bitte dich anzuhalten", "stop", {}),
    ],
)
def test_it_is_an_order(engine_of, said: str, intent: str, slots: dict[str, object]) -> None:
    frame = engine_of(KITCHEN).parse(said, state=("moving",))
    assert (frame.intent, frame.slots) == (intent, slots) if intent != "stop" else frame.actions[0].type == "stop"


@pytest.mark.parametrize(
    "said",
    [
        "ich bitte dich",
        "ich bitte dich, die Zange nicht zu öffnen",
        "ich bat dich, die Zange zu öffnen",
        "darf ich dich bitten zu öffnen",
        "ich bitte dich, mich die Zange öffnen zu lassen",
        "wärst du so nett gewesen, zwei Meter vorzufahren",
        "ich sehe, dass du in die Küche fährst",
        "er vergaß, die Zange zu öffnen",
        "sieh zu, dass du wegkommst",
    ],
)
def test_it_is_none(engine_of, said: str) -> None:
    assert not engine_of(KITCHEN).parse(said).actions
