"""What people say in German to a robot of the shipped grammar that drives, fetches and carries."""

from __future__ import annotations

from math import radians

import pytest

from intent_engine import IntentEngine


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return IntentEngine.from_files("de", locations="zuhause")


@pytest.mark.parametrize(
    ("said", "intent", "slots"),
    [
        ("Setz zwei Meter zurück", "move", {"direction": "backward", "distance": 2.0}),
        ("Und jetzt zwei Meter vor", "move", {"direction": "forward", "distance": 2.0}),
        ("Fahr a bissl zurück", "move", {"direction": "backward", "distance": 0.2}),
        ("Dreh dich auf drei Uhr", "turn", {"side": "right", "angle": radians(90)}),
        ("Rechtsum!", "turn", {"side": "right", "angle": radians(90)}),
        ("Darf ich dich bitten, dich umzudrehen?", "turn", {"side": "left", "angle": radians(180)}),
        ("Steuere die Ladestation an", "navigate", {"place": "ladestation"}),
        ("Führ mich in die Küche", "navigate", {"place": "küche"}),
        ("Bitte umdrehen", "turn", {"side": "left", "angle": radians(180)}),
        ("Komm ein Stück näher", "come", {}),
        ("Hol die Milch raus", "pick", {"thing": "milch"}),
        ("Nimm die Tasse vom Tisch in der Küche", "pick", {"thing": "tasse", "source": "tisch in der küche"}),
        ("Räum das Buch ins Regal ein", "place", {"thing": "buch", "target": "regal"}),
        ("Stell die Tasse auf den Tisch ab", "place", {"thing": "tasse", "target": "tisch"}),
        ("Bring die Tasse vom Tisch in die Küche", "bring", {"thing": "tasse", "source": "tisch", "target": "küche"}),
        ("Reich mir die Zange rüber", "bring", {"thing": "zange"}),
        ("Schau nach dem Herd", "look", {"target": "herd"}),
    ],
)
def test_it_is_done(engine: IntentEngine, said: str, intent: str, slots: dict[str, object]) -> None:
    frame = engine.parse(said)
    assert (frame.intent, frame.slots) == (intent, pytest.approx(slots))


@pytest.mark.parametrize(
    "said",
    [
        "Kannst du eigentlich rückwärts fahren?",
        "Könntest du eigentlich in die Küche fahren",
        "Hol dir einen Kaffee",
        "Nimm dir ruhig einen Keks",
        "Nimm die Tasse, Max",
        "Stell die Tasse auf den Tisch, Oma",
        "Hol den Kaffee her, Peter",
        "Heben Sie bitte den linken Arm hoch",
        "Nimm die Füße vom Tisch",
        "Nimm die Tasse vorsichtig",
        "Stell die Tasse leise auf den Tisch",
        "Bring den Stein ins Rollen",
        "Steck die Nase in deine Bücher",
        "Lad deinen Frust ab",
        "Räum endlich auf",
        "Zieh dich zurück",
        "Weiter geradeaus kommt eine Ampel",
        "Auf drei Uhr ist ein Hindernis",
        "Er wartet auf mich in der Küche",
        "Es geht langsam vorwärts",
        "Nochmals vielen Dank",
        "Nein, anders rum die",
        "Losfahren?",
        "Umdrehen?",
    ],
)
def test_it_is_nothing(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions


@pytest.mark.parametrize(
    "said", ["Kannst du eigentlich mal anhalten", "Ich bitte dich anzuhalten", "Mission abbrechen"]
)
def test_it_stops(engine: IntentEngine, said: str) -> None:
    assert [action.type for action in engine.parse(said, state=("moving",)).actions] == ["stop"]


@pytest.mark.parametrize("said", ["such der flur die", "such den flur die"])
def test_what_was_broken_off_at_an_article_is_not_put_in_another_order(engine: IntentEngine, said: str) -> None:
    assert not engine.parse(said).actions
