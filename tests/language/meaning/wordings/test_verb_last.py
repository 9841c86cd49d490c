"""German orders whose verb stands last, "Ventil drei schließen", of a grammar that has "schließ Ventil {n}"."""

from __future__ import annotations

import pytest

WORKSHOP = """
language: de
slots:
  was: [Ventil, Ventile, Tür, Türen, Pumpe, Licht, Zange]
  n: {type: number, whole: true}
  teil: object
  ort: [Küche, Labor]
  weite: distance
  winkel: angle
intents:
  öffnen: {action: custom, sentences: ["öffne [die|das] {was} [{n}]"]}
  schließen: {action: custom, sentences: ["schließ [die|das] {was} [{n}]"]}
  einschalten: {action: custom, sentences: ["schalte [die|das] {was} ein"]}
  lösen: {action: custom, sentences: ["löse (das|die) {was}"]}
  hin: {action: custom, sentences: ["fahr (zum|in die) {ort}"]}
  fahren: {action: custom, sentences: ["fahr [{weite}] vorwärts"]}
  drehen: {action: custom, sentences: ["dreh dich [{winkel}] nach links"]}
  greifen: {action: custom, sentences: ["greif {teil}"]}
"""


@pytest.mark.parametrize(
    ("said", "intent", "slots"),
    [
        ("Ventil drei schließen", "schließen", {"was": "Ventil", "n": 3}),
        ("das Ventil drei sofort schließen", "schließen", {"was": "Ventil", "n": 3}),
        ("Tür öffnen", "öffnen", {"was": "Tür"}),
        ("die Tür öffnen", "öffnen", {"was": "Tür"}),
        ("die Pumpe öffnen", "öffnen", {"was": "Pumpe"}),
        ("Licht einschalten", "einschalten", {"was": "Licht"}),
        ("die Ventile einschalten", "einschalten", {"was": "Ventile"}),
        ("Pumpe lösen", "lösen", {"was": "Pumpe"}),
        ("in die Küche fahren", "hin", {"ort": "Küche"}),
        ("zwei Meter vorwärts fahren", "fahren", {"weite": 2.0}),
        ("nach links drehen", "drehen", {}),
        ("Roboter, Ventil drei schließen!", "schließen", {"was": "Ventil", "n": 3}),
        ("nein, das Licht einschalten", "einschalten", {"was": "Licht"}),
        ("die Tür öffnen, nein, das Ventil", "öffnen", {"was": "Ventil"}),
        ("die Tür, nein, das Ventil öffnen", "öffnen", {"was": "Ventil"}),
        ("Ventil zwei, ach nein, drei schließen", "schließen", {"was": "Ventil", "n": 3}),
        ("zwei, nein, drei Meter vorwärts fahren", "fahren", {"weite": 3.0}),
        ("das Licht, nein, die Pumpe einschalten", "einschalten", {"was": "Pumpe"}),
        ("kannst du in die Küche, nein, zum Labor fahren", "hin", {"ort": "Labor"}),
        ("die Tür eben öffnen", "öffnen", {"was": "Tür"}),
        ("die Pumpe ruhig einschalten", "einschalten", {"was": "Pumpe"}),
        ("den Hebel greifen", "greifen", {"teil": "hebel"}),
        ("eine Zange greifen", "greifen", {"teil": "zange"}),
    ],
)
def test_it_is_an_order(engine_of, said: str, intent: str, slots: dict[str, object]) -> None:
    frame = engine_of(WORKSHOP).parse(said)
    assert (frame.intent, frame.slots) == (intent, slots)


@pytest.mark.parametrize(
    ("said", "intents"),
    [
        ("Tür öffnen und in die Küche fahren", ["öffnen", "hin"]),
        ("nach links drehen, dann zwei Meter vorwärts fahren", ["drehen", "fahren"]),
        ("öffne die Tür und das Licht einschalten", ["öffnen", "einschalten"]),
        ("bitte nach links drehen und die Tür öffnen", ["drehen", "öffnen"]),
    ],
)
def test_several_are_done_one_after_the_other(engine_of, said: str, intents: list[str]) -> None:
    assert [step["intent"] for step in engine_of(WORKSHOP).parse(said).slots["steps"]] == intents


@pytest.mark.parametrize(
    "said",
    [
        "die Türen öffnen",  # they open
        "die Ventile, nein, die Türen öffnen",
        "die Tür, nein, das Ventil öffnen wir",
        "die Tür, nein, nicht das Ventil öffnen",
        "die Tür, nein, das Ventil öffnen?",
        "die Tür eben nicht öffnen",
        "die Ventile schließen",
        "Leute greifen",
        "die Leute greifen",
        "sie drehen",
        "einschalten",
        "nicht einschalten",
        "wir Ventil drei schließen",
        "wir müssen die Tür öffnen",
        "dass wir in die Küche fahren",
        "um die Tür zu öffnen",
        "das Licht einschalten wollte er",
        "das Licht einschalten?",
        "das Ventil nicht öffnen",
        "kein Licht einschalten",
        "morgen in die Küche fahren",
        "zum Labor fahren oder in die Küche fahren",
        "nicht die Tür öffnen, das Licht einschalten?",
    ],
)
def test_what_tells_of_somebody_asks_or_denies_is_none(engine_of, said: str) -> None:
    assert not engine_of(WORKSHOP).parse(said).actions
