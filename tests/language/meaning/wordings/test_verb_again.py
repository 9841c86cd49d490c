"""A verb that is said once of things with which different things are done."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: de
slots:
  lampe: [Deckenlicht, Nachtlicht]
  an: boolean
  anteil: percent
  bild: [Bühne, Gast]
  ding: text
intents:
  jalousie: {action: custom, sentences: ["mach die Jalousie (auf|zu)"]}
  lampe: {action: custom, sentences: ["mach das {lampe} {an}"]}
  zoom: {action: custom, sentences: ["stell den Zoom auf {anteil}"]}
  fokus: {action: custom, sentences: ["stell (die|den) {bild} scharf"]}
  holen: {action: custom, sentences: ["hol {ding}"]}
  bringen: {action: custom, sentences: ["hol die Tasse aus (der Küche|dem Bad)"]}
"""


@pytest.mark.parametrize(
    ("said", "intents"),
    [
        ("mach die Jalousie auf und das Deckenlicht aus", ["jalousie", "lampe"]),
        ("mach das Nachtlicht an und die Jalousie zu", ["lampe", "jalousie"]),
        ("mach bitte die Jalousie zu und dann das Deckenlicht an", ["jalousie", "lampe"]),
        ("machen Sie die Jalousie auf und das Deckenlicht aus", ["jalousie", "lampe"]),
        ("stell den Zoom auf 40 Prozent und die Bühne scharf", ["zoom", "fokus"]),
        ("mach das Deckenlicht aus und das Nachtlicht an", ["lampe", "lampe"]),
    ],
)
def test_each_is_done(engine_of, said: str, intents: list[str]) -> None:
    assert [action.name for action in engine_of(GRAMMAR).parse(said).actions] == intents


@pytest.mark.parametrize(
    "said",
    [
        "mach die Jalousie auf und das Deckenlicht ist aus",
        "mach die Jalousie auf und das Deckenlicht",
        "mach die Jalousie auf und nicht das Deckenlicht aus",
        "mach die Jalousie auf und das Deckenlicht nicht aus",
        "mach die Jalousie auf oder das Deckenlicht aus",
        "mach die Jalousie auf und das Deckenlicht geht aus",
        "ich mach die Jalousie auf und das Deckenlicht aus",
        "hol die Tasse aus der Küche und den Teller",
    ],
)
def test_what_tells_or_denies_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions
