"""The same safety in a language whose negation stands after the verb, and whose verb may stand last."""

from __future__ import annotations

import pytest
from meanings import ROOT, done

from intent_engine.engine import IntentEngine

NOTHING = "rejected"
TABLE = {
    "fahr vorwärts": "forward 1",
    "Fahre bitte zweieinhalb Meter vorwärts!": "forward 2.5",
    "dreh dich um 90° nach links": "left 90",
    "fahr in die Küche": "to küche",
    "nimm die Tasse": "pick tasse",
    "fahr zwei Meter vorwärts und dreh dich nach links": "forward 2, left 43",
    "fahr zwei Meter vorwärts dreh dich nach links": "forward 2, left 43",
    "nimm die Tasse fahr in die Küche": "pick tasse, to küche",
    "fahr vorwärts fahr zurück": NOTHING,
    "dreh dich nach links fahr nicht vorwärts": NOTHING,
    "fahr weiter in die Küche": "to küche",
    # Negated.
    "fahr nicht vorwärts": NOTHING,
    "bitte nicht vorwärts fahren": NOTHING,
    "fahr vorwärts nicht": NOTHING,
    "fahr niemals vorwärts": NOTHING,
    "fahr nie in die Küche": NOTHING,
    "dreh dich nicht nach links": NOTHING,
    "nimm keine Tasse": NOTHING,
    "nimm die Tasse nicht": NOTHING,
    "ohne zu fahren": NOTHING,
    "auf keinen Fall vorwärts fahren": NOTHING,
    # Corrected, taken back, cancelled.
    "dreh dich nach links, nein, nach rechts": "right 43",
    "fahr in die Küche, ich meine ins Schlafzimmer": "to schlafzimmer",
    "fahr vorwärts nein": NOTHING,
    "fahr vorwärts, vergiss es": NOTHING,
    "fahr vorwärts doch nicht": NOTHING,
    "fahr vorwärts, moment": "stop",
    # Talk.
    "er hat gesagt fahr vorwärts": NOTHING,
    "wenn du mich siehst fahr vorwärts": NOTHING,
    "fahr vorwärts wenn die Tür offen ist": NOTHING,
    "ich bin in die Küche gefahren": NOTHING,
    "wo ist die Küche": NOTHING,
    "fahr vorwärts und tanz": NOTHING,
    # Stop.
    "stopp": "stop",
    "Halt!": "stop",
    "bleib sofort stehen": "stop",
    "nein, stopp": "stop",
    "fahr vorwärts stopp": "stop",
    "stopp, nein, fahr vorwärts": "stop",
    "dreh dich nach links stopp dreh dich nach rechts": "stop",
    "halt nicht an": NOTHING,
    "nicht anhalten": NOTHING,
    "er hat stopp gesagt": NOTHING,
    "die Bushaltestelle": NOTHING,
}


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return IntentEngine.from_files(ROOT / "grammars" / "de.yaml", locations=ROOT / "locations" / "zuhause.yaml")


@pytest.mark.parametrize(("text", "meant"), TABLE.items())
def test_a_german_sentence(engine: IntentEngine, text: str, meant: str) -> None:
    assert done(engine.parse(text)) == meant
