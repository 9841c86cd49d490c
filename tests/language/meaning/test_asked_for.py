"""What is asked for with the verb at the end, of a grammar that only has orders: "kannst du das Licht anmachen?"."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: de
slots:
  tisch: {type: number, min: 1, max: 30, whole: true}
  raum: [Küche, Bar]
  meter: distance
  tür: [Haustür, Hintertür]
  gerät: [Hammer, Zange]
  person: {type: text, max_words: 2}
  "on": boolean
intents:
  licht: {action: custom, sentences: ["mach das Licht {on}"]}
  tür: {action: custom, sentences: [{say: "mach die {tür} auf", slots: {zu: false}}]}
  fahr: {action: custom, sentences: ["fahr in die {raum}"]}
  räum: {action: custom, sentences: ["räum tisch {tisch} ab"]}
  dreh: {action: custom, sentences: ["dreh dich nach links"]}
  nimm: {action: custom, sentences: ["nimm (den|die) {gerät}"]}
  begleite: {action: custom, sentences: ["begleite {person} in die {raum}"]}
  füge: {action: custom, sentences: ["füge {meter} Draht hinzu"]}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Kannst du das Licht anmachen?", "mach das Licht an"),
        ("Könnten Sie bitte das Licht ausmachen", "mach das Licht aus"),
        ("Würdest du die Haustür aufmachen?", "mach die Haustür auf"),
        ("Könntest du Tisch zehn abräumen?", "räum Tisch zehn ab"),
        ("Kannst du in die Küche fahren?", "fahr in die Küche"),
        ("Kannst du dich nach links drehen?", "dreh dich nach links"),
        ("Kannst du mir die Zange nehmen?", "nimm die Zange"),
        ("Könnten Sie Anna in die Küche begleiten?", "begleite Anna in die Küche"),
        ("Kannst du zwei Meter Draht hinzufügen?", "füge zwei Meter Draht hinzu"),
        ("Du sollst das Licht anmachen.", "mach das Licht an"),
        ("Ich möchte, dass du das Licht anmachst.", "mach das Licht an"),
        ("Kannst du kurz in die Küche fahren?", "fahr in die Küche"),
        ("Kannst du Anna begleiten, in die Küche?", "begleite Anna in die Küche"),
        ("Ich möchte, dass du Anna begleitest, in die Bar", "begleite Anna in die Bar"),
        ("Ich will, dass du Tisch zehn abräumst", "räum Tisch zehn ab"),
        ("Ich möchte, dass du in die Küche fährst", "fahr in die Küche"),
        ("Ich hätte gern, dass du die Zange nimmst", "nimm die Zange"),
    ],
)
def test_it_is_the_order(engine_of, said: str, meant: str) -> None:
    engine = engine_of(GRAMMAR)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "Das Licht anmachen?",
        "Du sollst das Licht anmachen?",
        "Sie sollen das Licht anmachen",  # they, perhaps
        "Soll ich das Licht anmachen?",
        "Hast du das Licht angemacht?",
        "Kannst du das Licht nicht anmachen?",
        "Du sollst das Licht nicht anmachen",
        "Kannst du das Licht anmachen, wenn Tom kommt?",
        "Kannst du den Hammer haben?",
        "Tom sagt, du sollst das Licht anmachen",
        "Ich möchte nicht, dass du das Licht anmachst",
        "Kannst du zwei Meter Draht hinzufügen, drei?",
        "Kannst du in die Küche fahren, in die Bar?",
        "Kannst du Anna begleiten, nicht in die Küche?",
        "Ich möchte, dass du das Licht nicht anmachst",
        "Ich möchte, dass Tom das Licht anmacht",
        "Ich möchte, dass du das Licht anmachst, wenn Tom kommt",
        "Ich möchte, dass du das Licht anmachst?",
        "Ich weiß, dass du das Licht anmachst",
        "Ich dachte, dass du Tisch zehn abräumst",
        "Ich möchte, dass du das Licht angemacht hast",
        "dass du das Licht anmachst",
        "Tom kann das Licht anmachen",
    ],
)
def test_what_asks_whether_denies_or_tells_of_others_is_none(engine_of, said: str) -> None:
    assert engine_of(GRAMMAR).parse(said).actions == ()
