"""What is said to a stranger, "fahren Sie vor", is what is said to a friend, "fahr vor"; "fahren Sie vor?" asks."""

from __future__ import annotations

import pytest
from meanings import german

from intent_engine.actions import Stop
from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status

PAIRS = [
    ("Fahren Sie vor", "fahr vor"),
    ("Fahren Sie bitte zwei Meter zurück", "fahr bitte zwei Meter zurück"),
    ("Gehen Sie langsam vorwärts", "geh langsam vorwärts"),
    ("Machen Sie zwei Schritte zurück", "mach zwei Schritte zurück"),
    ("Setzen Sie zurück", "setz zurück"),
    ("Drehen Sie sich nach links", "dreh dich nach links"),
    ("Drehen Sie um", "dreh um"),
    ("Kehren Sie um", "kehr um"),
    ("Biegen Sie rechts ab", "bieg rechts ab"),
    ("Gehen Sie in die Küche", "geh in die Küche"),
    ("Kommen Sie zur Ladestation", "komm zur Ladestation"),
    ("Kommen Sie her", "komm her"),
    ("Folgen Sie mir", "folg mir"),
    ("Nehmen Sie den Becher", "nimm den Becher"),
    ("Nehmen Sie ihn vom Tisch", "nimm ihn vom Tisch"),
    ("Heben Sie den Schlüssel auf", "heb den Schlüssel auf"),
    ("Stellen Sie die Tasse auf den Tisch", "stell die Tasse auf den Tisch"),
    ("Lassen Sie die Tasse los", "lass die Tasse los"),
    ("Bringen Sie mir das Buch", "bring mir das Buch"),
    ("Holen Sie mir die Tasse aus dem Schrank", "hol mir die Tasse aus dem Schrank"),
    ("Geben Sie mir die Tasse", "gib mir die Tasse"),
    ("Machen Sie das nochmal", "mach das nochmal"),
    ("Schauen Sie sich die Tür an", "schau dir die Tür an"),
    ("Prüfen Sie den Herd", "prüfe den Herd"),
    ("Fahren Sie vor und drehen Sie sich nach links", "fahr vor und dreh dich nach links"),
    ("Fahren Sie vor, nein, zurück", "fahr vor, nein, zurück"),
    ("Seien Sie so nett und fahren Sie vor", "sei so nett und fahr vor"),
    ("Warten Sie", "warte"),
    ("Bleiben Sie hier", "bleib hier"),
    ("Hören Sie auf, mir zu folgen", "hör auf mir zu folgen"),
    ("Fahren Sie nicht", "fahr nicht"),
    ("Bewegen Sie sich nicht", "beweg dich nicht"),
]


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return german()


@pytest.mark.parametrize(("polite", "plain"), PAIRS)
def test_it_is_what_is_said_to_a_friend(engine, polite, plain):
    found = engine.parse(polite)
    assert found.status is Status.ACCEPTED, found.reason
    assert found.actions == engine.parse(plain).actions


@pytest.mark.parametrize("polite", [polite for polite, _ in PAIRS])
@pytest.mark.parametrize("spoken", [False, True])
def test_with_a_question_mark_nothing_moves(engine, polite, spoken):
    found = engine._interpreter(None).interpret(f"{polite}?", spoken=spoken)
    assert all(isinstance(action, Stop) for action in found.actions), found


def test_a_request_is_none_and_a_thing_is_no_person(engine):
    assert engine.parse("Können Sie in die Küche fahren?").actions
    assert engine.parse("Nimm sie?").actions


@pytest.mark.parametrize(
    "text",
    [
        "Sie fahren vor",
        "wir fahren in die Küche",
        "fahren wir in die Küche",
        "Fahren Sie nicht vor",
        "Fahren Sie morgen in die Küche",
        "Nehmen Sie Platz",
        "Nehmen Sie mich",
        "Nehmen Sie",
        "Setzen Sie sich",
        "Finden Sie das gut",
        "Finden Sie die Küche schön",
        "wenn Sie fahren, gehen Sie nach links",
        "Fahren Sie nach links oder nach rechts",
    ],
)
def test_what_tells_of_others_or_says_no_moves_nothing(engine, text):
    assert engine.parse(text).actions == ()
