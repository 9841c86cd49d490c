"""The same safety in a language whose negation stands after the verb, and whose verb may stand last."""

from __future__ import annotations

import pytest
from meanings import done, german

from intent_engine.engine import IntentEngine

NOTHING = "rejected"
UNFINISHED = "incomplete"
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
    "dreh dich um neunzig Grad": "left 90",
    "dreh dich ein bisschen nach rechts": "right 15",
    "ein bisschen zurück": "back 0.2",
    "komm einen Meter vor": "forward 1",
    "setz einen Meter zurück": "back 1",
    "nimm die Tasse da": "pick tasse",
    "folge mir": "follow",
    "komm her": "come",
    "bring mir die Tasse": "bring",
    "könntest du mir die Tasse bringen": "bring",
    "nimm die Tasse und stell sie auf den Tisch": "pick tasse, place tasse tisch",
    "nimm die Tasse und bring sie mir": "pick tasse, bring",
    "geh und hol die Tasse": "pick tasse",
    "kannst du dich nach links drehen": "left 43",
    "kannst du dich umdrehen": "left 180",
    "dreh dich langsam nach links": "left 21",
    "such den roten Ball": "look",
    "fahr zur Ladestation zurück": "to ladestation",
    "beweg dich nicht": "stop",
    "nicht bewegen": "stop",
    "fahr nicht": "stop",
    "fahr nicht mehr weiter": "stop",
    "Notbremse!": "stop",
    # One thing or another, when and how often, and what no hand can hold.
    "nimm die Tasse oder den Teller": NOTHING,
    "bring mir eine Tasse oder ein Glas": NOTHING,
    "stell die Tasse auf den Tisch oder ins Regal": NOTHING,
    "nimm die Tasse später": NOTHING,
    "nimm die Tasse um drei": NOTHING,
    "nimm die Tasse nach dem Essen": NOTHING,
    "nimm die Tasse zweimal": NOTHING,
    "nimm die Tasse, den Teller und die Gabel": NOTHING,
    "nimm Kontakt auf": NOTHING,
    "nimm Anlauf": NOTHING,
    "bring die Kinder ins Bett": NOTHING,
    "hol die Polizei": NOTHING,
    "heb die Hand hoch": NOTHING,
    # Half a command is none, nor are words that only hold one.
    "die links": NOTHING,
    "der zurück": NOTHING,
    "vor zwei Minuten": UNFINISHED,
    "links oder rechts": NOTHING,
    "nimm die Tasse von": UNFINISHED,
    "nimm die Tasse bevor du gehst": NOTHING,
    "nimm jede": UNFINISHED,
    "gib mir": UNFINISHED,
    "fahr mit": UNFINISHED,
    # Said to a telephone, or to a person.
    "nimm Platz": NOTHING,
    "nimm dir Zeit": NOTHING,
    "nimm das zurück": NOTHING,
    "nimm eine Nachricht auf": NOTHING,
    "hol mir die Nachrichten": NOTHING,
    "hole das Wetter für morgen": NOTHING,
    "stell den Wecker auf sieben Uhr": NOTHING,
    "stell einen Timer auf zehn Minuten": NOTHING,
    "setz dich auf das Sofa": UNFINISHED,
    "leg dich hin": UNFINISHED,
    "bring mich zum Lachen": NOTHING,
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
    "brems": "stop",
    "Not-Aus!": "stop",
    "keine Bewegung": "stop",
    "hör sofort auf": "stop",
    "fahr vorwärts hör auf": "stop",
    "stehen bleiben": "stop",
    "halt kurz an": "stop",
    "warte einen Moment": "stop",
    "das reicht": "stop",
    "halt nicht an": NOTHING,
    "hör nicht auf": NOTHING,
    "nicht anhalten": NOTHING,
    "er hat stopp gesagt": NOTHING,
    "die Bushaltestelle": NOTHING,
}


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return german()


@pytest.mark.parametrize(("text", "meant"), TABLE.items())
def test_a_german_sentence(engine: IntentEngine, text: str, meant: str) -> None:
    assert done(engine.parse(text)) == meant
