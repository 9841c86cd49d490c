"""German sentences for synthetic voices: commands as people say them, what shall not be done, and talk."""

from __future__ import annotations

from typing import Any

from speech_sentences import label

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

COMMANDS = """
stopp
halt
halt an
sofort anhalten
bitte anhalten
bleib stehen
hör auf
das reicht
nicht weiter
Roboter, halt an
fahr vorwärts
fahr zurück
fahr einen Meter vor
fahr zwei Meter vorwärts
fahr fünf Meter geradeaus
fahr zwanzig Zentimeter rückwärts
fahr drei Meter zurück
fahre bitte anderthalb Meter vorwärts
fahr siebzig Zentimeter vor
geh einen halben Meter zurück
geh zehn Meter nach vorne
fahr drei Sekunden lang geradeaus
fahr ein bisschen zurück
fahr etwas vor
fahr langsam vorwärts
fahr mit einem halben Meter pro Sekunde vorwärts
kannst du zwei Meter zurück fahren
vorwärts
rückwärts
dreh dich nach links
dreh dich nach rechts
dreh dich um
bitte dreh dich um
dreh dich dreißig Grad nach links
dreh dich um neunzig Grad nach rechts
dreh dich um fünfundvierzig Grad nach links
dreh dich um hundertachtzig Grad
dreh dich zwei Sekunden lang nach rechts
dreh dich ein bisschen nach links
bieg rechts ab
bieg links ab
links
fahr in die Küche
fahr zur Küche
fahr ins Wohnzimmer
fahr bitte zum Eingang
fahr zurück zur Ladestation
geh in das Schlafzimmer
komm in die Stube
könntest du ins Schlafzimmer fahren
bring mich in die Küche
nimm die rote Tasse
nimm den Ball
nimm bitte das Buch
nimm die Flasche vom Tisch
heb den Schlüssel auf
greif die blaue Kiste
stell die Tasse auf den Tisch
leg das Buch hin
leg die Schlüssel auf den Stuhl
stell die Kiste ab
lass den Ball fallen
bring mir den Hammer
bring mir bitte eine Flasche
hol mir die Tasse aus dem Schrank
gib mir das Buch
folge mir
komm her
komm zu mir
dreh dich um und fahr zwei Meter vor
fahr in die Küche und nimm die Tasse
"""
FORBIDDEN = """
fahr nicht in die Küche
fahr nicht vorwärts
fahr nicht zwei Meter zurück
fahr bitte nicht zur Ladestation
dreh dich nicht um
dreh dich nicht nach links
bieg nicht rechts ab
geh nie ins Schlafzimmer
nimm nicht die Tasse
nimm die Flasche nicht
stell die Tasse nicht auf den Tisch
leg das Buch nicht hin
bring mir nicht den Hammer
folge mir nicht
komm nicht her
du sollst nicht in die Küche fahren
"""
TALK = """
wie wird das Wetter morgen
wie spät ist es
ich war gestern in der Küche
ich gehe in die Küche
er geht zwei Meter vor
wir fahren morgen nach Berlin
die Katze liegt auf dem Sofa
der Bus hält an der Haltestelle
was gibt es heute zu essen
stell den Wecker auf sieben Uhr
stell einen Timer auf zehn Minuten
mach das Licht an
mach die Musik leiser
spiel etwas Musik
nimm Platz
nimm dir Zeit
dreh die Heizung auf
ruf meine Mutter an
schreib eine Nachricht an Anna
wann fährst du in die Küche
hast du die Tasse genommen
das Buch liegt auf dem Tisch
er hat den Ball genommen
sie stellt die Blumen auf den Tisch
die linke Tür ist kaputt
das ist nicht richtig
da hast du recht
vor zwei Minuten war er noch da
das sind etwa zwei Meter
wenn du dich umdrehst siehst du die Tür
meine Schwester kommt mit dem Zug
guten Morgen zusammen
vielen Dank für alles
bis morgen dann
kannst du mir sagen wie spät es ist
wir treffen uns um zehn in der Küche
"""


def german(engine: IntentEngine, voices: int) -> list[dict[str, Any]]:
    """Every command as often as there are voices, and twice what is none.

    Raises:
        ValueError: the engine does not understand a command, or takes other speech for one.
    """
    found = []
    for text in COMMANDS.strip().splitlines():
        meaning = engine.parse(text)
        if meaning.status is not Status.ACCEPTED or meaning.intent is None:
            raise ValueError(f"{text!r}: {meaning.reason}")
        found += [label(text, meaning.intent, meaning.actions, "plain")] * voices
    for text in (FORBIDDEN + TALK).split("\n"):
        if engine.parse(text).actions:
            raise ValueError(f"the grammar takes this for a command: {text!r}")
        found += [{"text": text, "intent": None, "kind": "other"}] * (2 if text else 0)
    return found
