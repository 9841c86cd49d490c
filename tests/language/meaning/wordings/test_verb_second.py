"""Orders with a thing or a place before the verb with which somebody is asked."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMAR = """
language: de
slots:
  ware: [Kiste, Fass, Palette]
  fach: {type: number, whole: true, max: 40}
  raum: [Flur, Bad]
intents:
  abstellen: {action: custom, sentences: ["stell (die|das) {ware} in Fach {fach} ab"]}
  aufnehmen: {action: custom, sentences: ["nimm (die|das) {ware} auf"]}
  licht: {action: custom, sentences: ["mach das Licht im {raum} an"]}
  füttern: {action: custom, sentences: ["füttere die Kuh in Box {fach}"]}
"""


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("die Kiste stellst du bitte in Fach 9 ab", "stell die Kiste in Fach 9 ab"),
        ("die Kiste stellen Sie bitte in Fach 9 ab", "stell die Kiste in Fach 9 ab"),
        ("In Fach 9 stellst du bitte die Kiste ab", "stell die Kiste in Fach 9 ab"),
        ("das Fass nimmst du bitte mal auf", "nimm das Fass auf"),
        ("im Flur machst du bitte das Licht an", "mach das Licht im Flur an"),
        ("im Bad machen Sie bitte das Licht an", "mach das Licht im Bad an"),
        ("in Box 3 fütterst du bitte die Kuh", "füttere die Kuh in Box 3"),
    ],
)
def test_it_is_the_order(engine_of, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMAR), said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "die Kiste stellst du in Fach 9 ab",  # always?
        "in Fach 9 stellst du die Kiste ab",
        "das Fass nimmst du bitte nicht auf",
        "der Chef stellt bitte die Kiste in Fach 9 ab",
        "wenn die Kiste stellst du bitte in Fach 9 ab",
        "die Kiste und das Fass stellst du bitte",
        "im Flur machst du bitte immer das Licht an",
        "ich stelle bitte die Kiste in Fach 9 ab",
    ],
)
def test_what_may_tell_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions
