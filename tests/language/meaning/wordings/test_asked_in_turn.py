"""German orders of several things whose verb stands last, and several orders that are asked for once."""

from __future__ import annotations

import pytest
from meanings import assert_same

GREENHOUSE = """
language: de
slots:
  pflanze: [Tomaten, Gurken, Paprika]
  ding: [Pumpe, Heizung]
  beet: {type: number, min: 1, max: 12, whole: true}
  winkel: angle
intents:
  gießen: {action: custom, sentences: ["gieß die {pflanze}", "gieß Beet {beet}"]}
  düngen: {action: custom, sentences: ["dünge die {pflanze}"]}
  an: {action: custom, sentences: ["schalte die {ding} ein"]}
  aus: {action: custom, sentences: ["schalte die {ding} aus"]}
  lüften: {action: custom, sentences: ["öffne das Dachfenster"]}
  drehen: {action: custom, sentences: ["stell den Kopf auf {winkel}"]}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("kannst du die Heizung ausschalten und das Dachfenster öffnen?",
         "schalte die Heizung aus und öffne das Dachfenster"),
        ("kannst du die Tomaten gießen und die Gurken düngen?", "gieß die Tomaten und dünge die Gurken"),
        ("kannst du die Tomaten gießen, die Gurken düngen und dann das Dachfenster öffnen?",
         "gieß die Tomaten, dünge die Gurken und öffne dann das Dachfenster"),
        ("ich möchte, dass du die Heizung ausschaltest und das Dachfenster öffnest",
         "schalte die Heizung aus und öffne das Dachfenster"),
        ("ich bitte dich, die Heizung auszuschalten und das Dachfenster zu öffnen",
         "schalte die Heizung aus und öffne das Dachfenster"),
        ("kannst du die Tomaten gießen und sie düngen?", "gieß die Tomaten und dünge die Tomaten"),
        ("die Pumpe und die Heizung ausschalten", "schalte die Pumpe und die Heizung aus"),
        ("kannst du die Pumpe und die Heizung ausschalten?", "schalte die Pumpe und die Heizung aus"),
        ("die Pumpe aus und die Heizung einschalten", "schalte die Pumpe aus und die Heizung ein"),
        ("bitte die Tomaten und die Gurken gießen", "gieß die Tomaten und die Gurken"),
        ("Beete 3 und 4 gießen", "gieß Beete 3 und 4"),
        ("könnten Sie Beet 3, Beet 4 und Beet 7 gießen?", "gieß Beet 3, Beet 4 und Beet 7"),
        ("den Kopf auf 20, nein, auf 30 Grad stellen", "stell den Kopf auf 30 Grad"),
    ],
)  # fmt: skip
def test_each_is_done(engine_of, said: str, meant: str) -> None:
    assert_same(engine_of(GREENHOUSE), said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "die Pumpe und die Heizung ausschalten?",
        "die Pumpe oder die Heizung ausschalten",
        "die Pumpe und nicht die Heizung ausschalten",
        "die Tomaten und die Gurken gießen",  # they do?
        "ich will die Pumpe und die Heizung ausschalten",
        "wer kann die Pumpe und die Heizung ausschalten?",
        "kannst du die Pumpe oder die Heizung ausschalten?",
        "kannst du die Tomaten gießen und der Nachbar die Gurken düngen?",
        "kannst du die Tomaten nicht gießen und die Gurken düngen?",
        "kannst du die Tomaten gießen und die Gurken?",
        "kannst du eigentlich die Tomaten gießen und die Gurken düngen?",
        "die Tomaten gießen und die Gurken düngen?",
    ],
)
def test_else_nothing_is_done(engine_of, said: str) -> None:
    assert not engine_of(GREENHOUSE).parse(said).actions
