"""German orders as people ask for them: verbs in "-ern" and "-eln", what may be done now, and why."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMAR = """
language: de
slots: {box: {type: number, whole: true}, grad: {type: number}, zoom: percent, ort: [Rampe, Tor]}
intents:
  füttern: {action: custom, sentences: ["füttere die Kuh in Box {box}"]}
  speichern: {action: custom, sentences: ["speicher die Position [als] {box}"]}
  wickeln: {action: custom, sentences: ["wickel das Seil auf"]}
  melken: {action: custom, sentences: ["melk die Kuh in Box {box}"]}
  licht: {action: custom, sentences: ["mach das Licht an"]}
  pumpe: {action: custom, sentences: ["mach die Pumpe aus"]}
  drehen: {action: custom, sentences: ["dreh dich nach links"]}
  zoomen: {action: custom, sentences: ["zoome auf {zoom} heran"]}
  hin: {action: custom, sentences: ["fahr (zum|zur) {ort}"]}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("kannst du die Kuh in Box 3 füttern", "füttere die Kuh in Box 3"),
        ("die Kuh in Box 3 bitte füttern", "füttere die Kuh in Box 3"),
        ("fütter die Kuh in Box 3", "füttere die Kuh in Box 3"),
        ("füttre die Kuh in Box 3", "füttere die Kuh in Box 3"),
        ("füttern Sie die Kuh in Box 3", "füttere die Kuh in Box 3"),
        ("fütterst du bitte die Kuh in Box 3", "füttere die Kuh in Box 3"),
        ("würdest du die Position als 5 speichern", "speicher die Position als 5"),
        ("das Seil aufwickeln", "wickel das Seil auf"),
        ("kannst du auf 60 Prozent heranzoomen", "zoome auf 60 Prozent heran"),
        ("wärst du so lieb und melkst die Kuh in Box 9", "melk die Kuh in Box 9"),
        ("wärst du so nett und machst das Licht an", "mach das Licht an"),
        ("du kannst jetzt zur Rampe fahren", "fahr zur Rampe"),
        ("du darfst bitte das Seil aufwickeln", "wickel das Seil auf"),
        ("mach schon das Licht an", "mach das Licht an"),
        ("komm, mach das Licht an", "mach das Licht an"),
        ("mach das Licht an, ja?", "mach das Licht an"),
        ("machst du mal das Licht an?", "mach das Licht an"),
        ("könntest du so nett sein und das Licht anmachen", "mach das Licht an"),
        ("tu mir den Gefallen und mach das Licht an", "mach das Licht an"),
        ("es wäre schön, wenn du das Licht anmachst", "mach das Licht an"),
        ("fahr zur Rampe hin", "fahr zur Rampe"),
        ("dreh nach links", "dreh dich nach links"),
        ("Licht an und Pumpe aus", "mach das Licht an und mach die Pumpe aus"),
        ("kannst du das Licht wieder anmachen", "mach das Licht an"),
        ("das Seil nochmal aufwickeln", "wickel das Seil auf"),
        ("mach das Licht an, es wird dunkel", "mach das Licht an"),
        ("mach das Licht an, mir ist unheimlich", "mach das Licht an"),
        ("mach das Licht an, damit ich etwas sehen kann", "mach das Licht an"),
    ],
)
def test_it_is_the_order(engine_of, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMAR), said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "du kannst zur Rampe fahren",
        "du kannst jetzt nicht zur Rampe fahren",
        "du kannst jetzt zur Rampe fahren?",
        "melkst die Kuh in Box 9",
        "das Licht schon an",
        "schon das Licht an",
        "machst du das Licht an?",
        "du machst mal das Licht an",
        "es wäre schön, wenn das Licht an wäre",
        "dreh den Kopf nach links",
        "das Licht an und die Pumpe ist aus",
        "das Licht wieder anmachen?",
        "das Licht nicht wieder anmachen",
        "wieder das Seil aufwickeln",
        "wärst du so lieb und melkst die Kuh in Box 9 nicht",
        "die Kuh in Box 3 fütterst",
        "wir füttern die Kuh in Box 3",
        "mach das Licht an, es wird nicht dunkel",
        "mach das Licht an, es wird dunkel wenn du gehst",
        "mir ist kalt",
    ],
)
def test_what_tells_denies_or_asks_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions
