"""Small words beside an amount, whatever else is in other words: "turn about 45 degrees to the left"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

DOLLY = """
language: en
slots:
  way: {type: choice, values: {forward: [forward], backward: [backward, back]}}
  side: [left, right]
  inout: [in, out]
  far: {type: distance, units: {50 cm: [step, steps]}}
  angle: {type: angle, unit: deg}
  time: duration
  bread: [rolls, buns]
  oven: [top oven, stone oven]
  degrees: number
  pace: speed
  title: {type: text, max_words: 5}
intents:
  walk: {action: custom, sentences: ["(walk|move) {way} [{far}]"]}
  turn: {action: custom, sentences: ["turn [to the] {side} [by {angle}]"]}
  dolly: {action: custom, sentences: ["dolly {inout} [by] {far}"]}
  bake: {action: custom, sentences: ["bake [the] {bread} [in the {oven}] [for {time}]"]}
  hover: {action: custom, sentences: ["hover [for {time}]"]}
  heat: {action: custom, sentences: ["heat the {oven} to {degrees} degrees"]}
  pace: {action: custom, sentences: ["set the speed to {pace}"]}
  play: {action: custom, sentences: ["play {title}"]}
"""


@pytest.fixture(scope="module")
def dolly(engine_of) -> IntentEngine:
    return engine_of(DOLLY)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("turn about 45 degrees to the left", "turn to the left by 45 degrees"),
        ("turn about another 45 degrees to your left", "turn left by 45 degrees"),
        ("turn 45 degrees or so to the left", "turn left by 45 degrees"),
        ("bake your rolls for about ten minutes in the top oven", "bake the rolls in the top oven for ten minutes"),
        ("bake the rolls for, say, ten minutes or so", "bake the rolls for ten minutes"),
        ("walk ten more steps forwards", "walk forward ten steps"),
        ("dolly another 40 cm out", "dolly out 40 cm"),
        ("move back by, say, half a meter", "move back half a meter"),
        ("move back by about 20 cm", "move back 20 cm"),
        ("dolly out by, I guess, 40 cm", "dolly out 40 cm"),
        ("turn left, I think, 45 degrees", "turn left 45 degrees"),
        ("hover for maybe ten seconds", "hover for ten seconds"),
        ("could you maybe hover for ten seconds", "hover for ten seconds"),
        ("would you perhaps walk forward two steps?", "walk forward two steps"),
        ("bake the rolls one more time in the top oven", "bake the rolls in the top oven"),
        ("bake the rolls one more time for ten minutes, then hover", "bake the rolls for ten minutes, then hover"),
        ("for two minutes, just hover", "hover for two minutes"),
        ("hover for say 15 seconds", "hover for 15 seconds"),
        ("hover for half a minute or so, please", "hover for half a minute"),
        ("for half a minute or so, hover", "hover for half a minute"),
        ("heat the top oven to ninety degrees or so", "heat the top oven to ninety degrees"),
        ("set the speed to just 5 m/s", "set the speed to 5 m/s"),
        ("in the top oven, bake the buns for ten minutes", "bake the buns in the top oven for ten minutes"),
    ],
)
def test_they_say_no_more(dolly: IntentEngine, said: str, meant: str) -> None:
    assert_same(dolly, said, meant)


@pytest.mark.parametrize(
    "said",
    [
        "hover or so",
        "turn left or so",
        "turn left or right",
        "turn left 45 degrees or right",
        "turn left 45 or 50 degrees",
        "hover for two or so minutes",
        "hover for two minutes or three",
        "hover for two minutes or so they say",
        "in half a minute or so, hover",
        "in ten minutes bake the buns in the top oven",
        "turn 45, uh, 30 degrees to the left",
        "walk five steps, uh, five forward",
        "say half a meter",
        "maybe hover for ten seconds",
        "perhaps turn left",
        "hover maybe",
        "turn left I guess",
        "I guess turn left",
        "hover for ten maybe twenty seconds",
        "walk two, maybe three steps forward",
        "walk forward two, I guess three",
        "hover for ten seconds, maybe twenty",
        "could you maybe not hover",
        "I think 45 degrees",
        "bake the rolls one time in the top oven",
        "bake the rolls one more time zone",
        "bake one more time zone rolls",
    ],
)
def test_what_leaves_it_open_is_none(dolly: IntentEngine, said: str) -> None:
    assert not dolly.parse(said).actions


def test_in_free_words_they_are_words(dolly: IntentEngine) -> None:
    assert dolly.parse("play two minutes or so").slots == {"title": "two minutes or so"}


FOREIGN = {
    language: f"language: {language}\nslots: {{far: distance}}\nintents: {{go: {{action: custom, sentences: {said}}}}}"
    for language, said in (
        ("de", '["fahr [um] {far} vor"]'),
        ("fr", '["avance de {far}"]'),
        ("es", '["avanza {far}"]'),
        ("it", '["avanza di {far}"]'),
    )
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("de", "fahr um, sagen wir, zwei Meter vor", "fahr zwei Meter vor"),
        ("de", "fahr zwei Meter oder so vor", "fahr zwei Meter vor"),
        ("fr", "avance, disons de deux mètres", "avance de deux mètres"),
        ("fr", "avance de disons deux mètres", "avance de deux mètres"),
        ("fr", "avance de deux mètres ou à peu près", "avance de deux mètres"),
        ("es", "avanza, digamos, dos metros", "avanza dos metros"),
        ("es", "avanza más o menos dos metros", "avanza dos metros"),
        ("es", "avanza dos metros o así", "avanza dos metros"),
        ("it", "avanza di, diciamo, due metri", "avanza di due metri"),
        ("it", "avanza di due metri più o meno", "avanza di due metri"),
    ],
)
def test_of_other_languages_they_say_no_more(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(FOREIGN[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "fahr um hundert, sagen wir, zwanzig Meter vor"),
        ("de", "fahr zwei Meter oder drei vor"),
        ("fr", "avance de deux mètres, disons trois"),
        ("fr", "avance de vingt, disons cinq mètres"),
        ("fr", "avance de vingt à peu près cinq mètres"),
        ("fr", "disons de deux mètres"),
        ("es", "avanza veinte más o menos cinco metros"),
        ("es", "avanza dos metros o tres"),
        ("es", "no avances más o menos dos metros"),
        ("it", "avanza di venti più o meno cinque metri"),
        ("it", "avanza di due, diciamo tre metri"),
    ],
)
def test_of_other_languages_no_number_is_made(engine_of, language: str, said: str) -> None:
    assert not engine_of(FOREIGN[language]).parse(said).actions
