"""Words that say no more of a way than where it goes, or what is switched: "bring the tray over to the lab", "turn the
lamp back on"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots: {item: [tray, test tubes], place: [lab, hall], level: percent}
intents:
  bring: {action: custom, sentences: ["bring [the] {item} to [the] {place}"]}
  go: {action: custom, sentences: ["go to [the] {place}"]}
  turn: {action: custom, sentences: ["turn [the] volume to {level}"]}
""",
    "de": """
language: de
slots: {ding: [Zange, Kiste], ort: [Labor, Halle]}
intents:
  bring: {action: custom, sentences: ["bring die {ding} (ins|in die) {ort}"]}
  geh: {action: custom, sentences: ["geh (ins|in die) {ort}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "bring the tray over to the lab", "bring the tray to the lab"),
        ("en", "go back down to the hall", "go to the hall"),
        (
            "en",
            "go over to the lab and bring the tray back to the hall",
            "go to the lab and bring the tray to the hall",
        ),
        ("en", "bring these test tubes to the lab", "bring the test tubes to the lab"),
        ("de", "bring die Zange rüber ins Labor", "bring die Zange ins Labor"),
        ("de", "geh hoch in die Halle", "geh in die Halle"),
    ],
)
def test_it_is_the_way(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "bring the tray over, to the lab"),
        ("en", "bring the tray over the lab"),
        ("en", "don't bring the tray over to the lab"),
        ("de", "bring die Zange rüber"),
        ("de", "er bringt die Zange rüber ins Labor"),
    ],
)
def test_what_says_more_is_none(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions


@pytest.mark.parametrize(
    ("language", "sentence", "said", "count"),
    [
        ("fr", "enfourne {n} pains", "enfourne une douzaine de pains", 12),
        ("fr", "enfourne {n} pains", "enfourne deux douzaines de pains", 24),
        ("es", "lleva {n} cajas", "lleva una docena de cajas", 12),
        ("it", "porta {n} casse", "porta una dozzina di casse", 12),
    ],
)
def test_dozens_are_counted_with_of(engine_of, language: str, sentence: str, said: str, count: int) -> None:
    engine = engine_of(f"""
language: {language}
slots: {{n: {{type: number, whole: true}}}}
intents: {{load: {{action: custom, sentences: ["{sentence}"]}}}}
""")
    (action,) = engine.parse(said).actions
    assert action.slots == {"n": count}


HOME = """
language: en
slots:
  room: [kitchen, garden, balcony]
  lamp: [lamp, fan, desk light]
  level: {type: percent, unit: percent}
  st: boolean
  item: [tray, basket]
  way: {type: choice, values: {forward: [forward], backward: [backward, back]}}
intents:
  switch: {action: custom, sentences: ["turn the {lamp} {st}"]}
  go: {action: custom, sentences: ["(take me|go|drive) to [the] {room}"]}
  put: {action: custom, sentences: ["(put|lay|leave) the {item} (in|on) the {room}"]}
  deliver: {action: custom, sentences: ["(drop|deliver) the {item} at the {room}"]}
  base: {action: custom, sentences: ["fly back to base", "return to base"]}
  way: {action: custom, sentences: ["roll {way}"]}
  level: {action: custom, sentences: ["turn the {lamp} to {level}"]}
  on: {action: custom, sentences: [go on]}
"""
SHOP = """
language: en
slots:
  valve: [valve, boiler]
intents:
  "on": {action: custom, sentences: ["switch on the {valve}"]}
  "off": {action: custom, sentences: ["switch off the {valve}"]}
  zoom: {action: custom, sentences: ["zoom (in|out)", "turn the music up"]}
"""
HOTEL = """
language: en
slots:
  item: {type: text, max_words: 4}
  thing: object
  n: {type: number, whole: true, max: 999}
  place: [lobby, roof]
  device: [radio, screen]
  who: [Anna, Tom]
  st: boolean
intents:
  bring: {action: custom, sentences: ["bring {item} to room {n}"]}
  carry: {action: custom, sentences: ["carry [the] {thing} to [the] {place}", "put [the] {thing} on [the] {place}"]}
  play: {action: custom, sentences: ["play {item} on the {device}", "send {item} to {who}"]}
  switch: {action: custom, sentences: ["turn [the] {thing} {st}"]}
"""


@pytest.mark.parametrize(
    ("grammar", "said", "meant"),
    [
        (HOME, "turn the lamp back on", "turn the lamp on"),
        (HOME, "can you turn that desk light back off", "turn the desk light off"),
        (HOME, "lamp back on", "turn the lamp on"),
        (HOME, "turn the fan back on and take me out to the balcony", "turn the fan on and take me to the balcony"),
        (HOME, "take me back out to the garden", "take me to the garden"),
        (HOME, "put the tray down in the kitchen", "put the tray in the kitchen"),
        (HOME, "lay the basket back down on the balcony", "lay the basket on the balcony"),
        (HOME, "put the tray over on the balcony", "put the tray on the balcony"),
        (HOME, "drop the basket off at the garden", "drop the basket at the garden"),
        (HOME, "fly on back to base", "fly back to base"),
        (HOME, "return over to base", "return to base"),
        (SHOP, "switch the valve back on", "switch on the valve"),
        (SHOP, "switch back off the boiler", "switch off the boiler"),
        (SHOP, "zoom back out", "zoom out"),
        (SHOP, "turn the music back up", "turn the music up"),
    ],
)
def test_what_leads_there_or_is_switched_is_said(engine_of, grammar: str, said: str, meant: str) -> None:
    assert_same(engine_of(grammar), said, meant)


@pytest.mark.parametrize(
    ("grammar", "said"),
    [
        (HOME, "turn the lamp back"),
        (HOME, "turn the lamp back on or off"),
        (HOME, "the lamp is back on"),
        (HOME, "I'm back on"),
        (HOME, "he turned the lamp back on"),
        (HOME, "is the lamp back on"),
        (HOME, "don't turn the lamp back on"),
        (HOME, "go back on"),
        (HOME, "put the tray down"),
        (HOME, "put the tray in down the kitchen"),
        (HOME, "put the tray off on the balcony"),
        (HOME, "turn the lamp off to the kitchen"),
        (HOME, "turn the lamp on to ten percent"),
        (HOME, "take me up down to the balcony"),
        (HOME, "roll forward back to the garden"),
        (SHOP, "zoom back"),
        (SHOP, "zoom in back out"),
        (SHOP, "switch the valve back"),
    ],
)
def test_what_leads_nowhere_is_none(engine_of, grammar: str, said: str) -> None:
    assert not engine_of(grammar).parse(said).actions


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("bring an ice bucket up to room 412", {"item": "ice bucket", "n": 412}),
        ("bring towels over to room 12", {"item": "towels", "n": 12}),
        ("bring the menu back down to room 12", {"item": "menu", "n": 12}),
        ("carry the red box back up to the roof", {"thing": "red box", "place": "roof"}),
        ("carry the cart out to the lobby", {"thing": "cart", "place": "lobby"}),
        ("put the red box down on the roof", {"thing": "red box", "place": "roof"}),
        ("turn the big lamp back on", {"thing": "big lamp", "st": True}),
        ("carry the red box to the roof one more time", {"thing": "red box", "place": "roof"}),
        ("turn the big lamp on one more time", {"thing": "big lamp", "st": True}),
        ("play once more with feeling on the radio", {"item": "once more with feeling", "device": "radio"}),
        ("bring a 7 up to room 12", {"item": "a 7 up", "n": 12}),
        ("play come back on the radio", {"item": "come back", "device": "radio"}),
        ("send come back to Anna", {"item": "come back", "who": "Anna"}),
    ],
)
def test_a_thing_does_not_end_with_a_way(engine_of, said: str, slots: dict[str, object]) -> None:
    assert engine_of(HOTEL).parse(said).slots == slots


@pytest.mark.parametrize(
    "said", ["put the print out on the roof", "carry the pick up to the roof", "bring the load up to room 12"]
)
def test_what_may_be_a_thing_or_a_way_is_none(engine_of, said: str) -> None:
    found = engine_of(HOTEL).parse(said)
    assert not found.actions
    assert "may be a thing" in found.reason
