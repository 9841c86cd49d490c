"""What means the same in other words, whatever it is about: each of a grammar that has it in one way only."""

from __future__ import annotations

import math

import pytest

CRANE = """
slots:
  part: [boom, hook, winch, lamp, pump]
  how_far: distance
  how_much: angle
  height: distance
  level: {type: percent, unit: percent}
  pace: speed
  liters: {type: number}
  heading: {type: angle, unit: deg, digits: true}
  what: object
  "on": boolean
  tongue: [english, german]
intents:
  check: {action: custom, sentences: ["check the {part}"]}
  slew: {action: custom, sentences: ["slew (left|right) [{how_much}]"]}
  tilt: {action: custom, sentences: ["tilt the {part} (to the left|to the right) [{how_much}]"]}
  hoist: {action: custom, sentences: ["hoist the {part} {how_far}"]}
  raise: {action: custom, sentences: ["raise the {part} to {height}"]}
  fill: {action: custom, sentences: ["fill the tank to {level}"]}
  drive: {action: custom, sentences: ["drive [at {pace}]"]}
  flow: {action: custom, sentences: ["set the flow to {liters} liters per minute"]}
  steer: {action: custom, sentences: ["steer to {heading}"]}
  take: {action: custom, sentences: ["take the {what}"]}
  switch: {action: custom, sentences: ["switch the {part} {on}"]}
  explain: {action: custom, sentences: ["explain the {part} [in {tongue}]"]}
  add: {action: custom, sentences: ["add {liters} milliliters of {drink}"]}
  put: {action: custom, sentences: ["put the {part} on the {part:where}", "put down the {what}"]}
  east: {action: custom, sentences: ["slew to the east"]}
  soak: {action: custom, sentences: ["soak it for {time}"]}
  polish: {action: custom, sentences: ["polish the lamp {count} times"]}
  pause: {action: custom, sentences: ["pause printer {count}"]}
  load: {action: custom, sentences: ["load {drink} in printer {count}"]}
  lower: {action: custom, sentences: ["lower the {part} by {how_far}"]}
  hooks: {action: custom, sentences: ["check the hooks"]}
  siren: {action: custom, sentences: ["turn on the siren"]}
  drinks: {action: custom, sentences: ["(make|mix) [me] [a|an|{count}] {drink}"]}
  fetch: {action: custom, sentences: ["get me the {what}"]}
  start: {action: custom, sentences: ["start the {part} [at {pace}] [for {time}]"]}
"""
GRAMMAR = CRANE.replace(
    "slots:\n", "slots:\n  time: duration\n  count: {type: number, max: 9}\n  drink: [tea, coffee]\n", 1
)


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        # Words that point to a thing.
        ("check that boom", "check the boom"),
        ("check your hook", "check the hook"),
        ("raise my boom to two meters", "raise the boom to two meters"),
        ("check all the hooks", "check the hooks"),
        ("check all of those hooks", "check the hooks"),
        ("pause the printer eight", "pause printer eight"),
        ("switch that lamp on", "switch the lamp on"),
        ("check a hook", "check the hook"),
        ("slew eastward", "slew to the east"),
        ("soak it ten minutes", "soak it for ten minutes"),
        ("polish the lamp twice", "polish the lamp two times"),
        ("turn that siren on", "turn on the siren"),
        # Which way.
        ("slew to the left", "slew left"),
        ("can you slew to the left?", "slew left"),
        ("slew towards the right by ten degrees", "slew right ten degrees"),
        ("slew ten degrees to your left", "slew left ten degrees"),
        ("slew a quarter turn to the right", "slew right a quarter turn"),
        ("tilt the boom left", "tilt the boom to the left"),
        # What leads an amount.
        ("hoist the hook by two meters", "hoist the hook two meters"),
        ("raise the hook to a height of two meters", "raise the hook to two meters"),
        ("drive at a speed of one meter per second", "drive at one meter per second"),
        ("fill the tank to a level of ten percent", "fill the tank to ten percent"),
        ("add ten milliliters tea", "add ten milliliters of tea"),
        ("add 10 ml of tea", "add ten milliliters of tea"),
        ("put the hook back on the boom", "put the hook on the boom"),
        ("set the flow to two liters a minute", "set the flow to two liters per minute"),
        ("lower the hook two meters", "lower the hook by two meters"),
        ("lower the hook by about two meters", "lower the hook by two meters"),
        ("hoist the hook about a meter", "hoist the hook a meter"),
        ("hoist that hook one and a half meters", "hoist the hook one and a half meters"),
        ("hoist the hook two meters high", "hoist the hook two meters"),
        ("raise the hook up to two meters", "raise the hook to two meters"),
        ("set the flow at two liters per minute", "set the flow to two liters per minute"),
        ("load tea into printer five", "load tea in printer five"),
        ("in printer five load tea", "load tea in printer five"),
        # What belongs to a verb and says no more.
        ("fill up the tank to ten percent", "fill the tank to ten percent"),
        ("fill the tank up to ten percent", "fill the tank to ten percent"),
        ("raise up that boom to two meters", "raise the boom to two meters"),
        ("start up the pump", "start the pump"),
        # No verb.
        ("lamp on", "switch the lamp on"),
        ("the pump off please", "switch the pump off"),
        # How, before the verb; how long, before how fast.
        ("in German, explain the boom", "explain the boom in German"),
        ("start the pump for half an hour at 1 m/s", "start the pump at 1 m/s for half an hour"),
        # A thing that somebody wants.
        ("could I get a tea?", "make me a tea"),
        ("I'll have two coffees", "make two coffees"),
        ("we would like a tea, please", "make me a tea"),
        ("can I have a tea and a coffee", "mix a tea and a coffee"),
        # What somebody wants to have done, or to be so.
        ("I want the lamp switched on", "switch the lamp on"),
        ("let's get that pump started for ten minutes", "start the pump for ten minutes"),
        ("could I get the pump started?", "start the pump"),
        ("we need those hooks checked", "check the hooks"),
        ("I want the boom to be checked", "check the boom"),
        ("please get the pump switched off", "switch the pump off"),
        ("let's have the lamp on", "switch the lamp on"),
        ("I need the flow at two liters per minute", "set the flow to two liters per minute"),
        # What may be done now.
        ("you can switch that lamp off now, thanks", "switch the lamp off"),
        ("Can we check the boom, please?", "check the boom"),
        # A thing that is named first.
        ("that lamp, switch it on", "switch the lamp on"),
        ("I need that lamp, switch it on", "switch the lamp on"),
        ("the lamp, switch it on and check the boom", "switch the lamp on, then check the boom"),
        ("the lamp, switch it on, then switch the pump off", "switch the lamp on, then switch the pump off"),
        # What is switched.
        ("lamp on and pump off", "switch the lamp on, then switch the pump off"),
        ("the lamp off, the pump on please", "switch the lamp off, then switch the pump on"),
        ("lamp on and check the boom", "switch the lamp on, then check the boom"),
        # One of it.
        ("add a milliliter of tea", "add one milliliters of tea"),
        # For how long, and how much.
        ("start the pump for the next ten minutes", "start the pump for ten minutes"),
        ("for the next two and a half hours, start the pump", "start the pump for two and a half hours"),
        ("start the pump for the next hour", "start the pump for one hour"),
        ("hoist the hook just two meters", "hoist the hook two meters"),
        ("fill the tank to, let's say, ten percent", "fill the tank to ten percent"),
        ("raise the hook to like two meters", "raise the hook to two meters"),
        ("hoist the hook two meters each", "hoist the hook two meters"),
        ("just slew half a degree left", "slew left half a degree"),
        ("slew a couple of degrees to the left", "slew left a couple of degrees"),
        ("slew a hundred and twenty degrees to the left", "slew left a hundred and twenty degrees"),
        # What was begun and left.
        ("the boom, uh, check the boom", "check the boom"),
        ("printer eight... pause printer eight", "pause printer eight"),
        ("quick, check the boom", "check the boom"),
        # Several.
        ("check that boom and slew to the left", "check the boom and slew left"),
        ("check your boom, then raise up your hook to two meters", "check the boom, then raise the hook to two meters"),
        ("check this boom, no, the hook", "check the boom, no, the hook"),
    ],
)  # fmt: skip
def test_it_is_the_same(engine_of, said: str, meant: str) -> None:
    engine = engine_of(GRAMMAR)
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "check that",
        "don't check that boom",
        "take your time",  # about no thing
        "take that chance",
        "put your foot down",  # of "put down the {what}": that is said of nothing either
        "a bit left",
        "the boom slews to the left",
        "slew to the left or right",
        "drive by two meters per second",  # that changes a speed
        "fill the tank by ten percent",
        "the lamp is on",
        "is the lamp on",
        "lamp on?",
        "lamp on the pump",
        "come on",
        "lamp on or pump off",
        "lamp on and pump",
        "lamp on and off",
        "lamp on and pump off?",
        "I left the lamp on and the pump off",
        "with the lamp on and the pump off",
        "the lamp on and the pump off are wrong",
        "is the lamp on and the pump off",
        "not lamp on and pump off",
        "pause printer a",
        "pause a printer",
        "add a few milliliters of tea",
        "add a milliliter",
        "add a milliliters of tea",  # eight?
        "have the lamp, switch it on",
        "could I get the lamp, switch it on",
        "I need help, switch it on",
        "I need the lamp and the pump, switch it on",
        "I don't need the lamp, switch it off",
        "raise the hook down to two meters",
        "drive two meters per second deep",
        "the hook, uh, check the boom",
        "the boom, check the boom or the hook",
        "check all",
        "set the flow to two liters a tea",
        "put the hook back on",
        "add ten milliliters word",
        "the ghost on",
        "not lamp on",
        "in ten minutes explain the boom",
        "steer two seven zero",  # the first may be a digit
        "your boom",
        "could I have a word",
        "could I get the boom",
        "I'd like a tea if there is one",
        "I would like tea more than coffee",
        "she'll have a tea",
        "I'll have had a tea",
        # Somebody tells what he does himself.
        "I'll take a tea to the office",
        "I will take the pump off",
        "we will take a tea along",
        "that's your boom up",
        "I have the lamp switched on",
        "I want the lamp switched on when it rains",
        "have the lamp switched on?",
        "I want the boom checking",
        "I wanted the lamp switched on",
        "do I need the lamp switched on",
        "I need the word taken",
        "you can check the boom",
        "you can check the boom now?",
        "now you can check the boom",
        "you can't check the boom now",
        "can we check the boom",
        "the word, take it",
        "the boom, check it and the hook",
        "Anna, check it",
        "hoist the hook just",
        "say two meters",
        "raise the hook to, like, two or three meters",
        "start the pump for the next",
    ],
)
def test_what_may_mean_something_else_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions


def test_digits_behind_the_word_that_leads_them_are_a_number(engine_of) -> None:
    assert engine_of(GRAMMAR).parse("steer to two seven zero").slots == {"heading": pytest.approx(math.radians(270))}


FOREIGN = {
    "de": ("""
language: de
slots: {teil: [Ventil, Pumpe, Licht], weite: distance, winkel: angle, tempo: speed}
intents:
  öffnen: {action: custom, sentences: ["öffne (das|die) {teil}"]}
  drehen: {action: custom, sentences: ["dreh dich nach links [{winkel}]"]}
  fahren: {action: custom, sentences: ["fahr [{weite}] vorwärts [mit {tempo}]"]}
  teil: {action: custom, sentences: ["dreh die {teil} {winkel} nach links"]}
  füllen: {action: custom, sentences: ["füll zwei Liter mit Newtonmeter"]}
  an: {action: custom, sentences: ["schalte (das|die) {teil} ein", "mach (das|die) {teil} an"]}
""", [
        ("öffne dieses Ventil", "öffne das Ventil"),
        ("öffne deine Pumpe", "öffne die Pumpe"),
        ("dreh dich links", "dreh dich nach links"),
        ("dreh dich um neunzig Grad nach links", "dreh dich nach links neunzig Grad"),
        ("fahr nach vorn", "fahr vorwärts"),
        ("fahr vorwärts mit einer Geschwindigkeit von 1 m/s", "fahr vorwärts mit 1 m/s"),
        ("die Pumpe um neunzig Grad nach links drehen", "dreh die Pumpe neunzig Grad nach links"),
        ("füll zwei Liter mit Newtonmetern", "füll zwei Liter mit Newtonmeter"),
        ("Licht an", "mach das Licht an"),
        ("die Pumpe ein", "schalte die Pumpe ein"),
    ]),
    "fr": ("""
language: fr
slots: {quoi: [vanne, pompe], combien: angle, loin: distance, allure: speed}
intents:
  ouvrir: {action: custom, sentences: ["ouvre la {quoi}"]}
  tourner: {action: custom, sentences: ["tourne à gauche [{combien}]"]}
  avancer: {action: custom, sentences: ["avance [{loin}] [à {allure}]"]}
""", [
        ("ouvre cette vanne", "ouvre la vanne"),
        ("tourne vers la gauche", "tourne à gauche"),
        ("tourne à gauche de trente degrés", "tourne à gauche trente degrés"),
        ("avance de deux mètres", "avance deux mètres"),
        ("ouvre donc la vanne", "ouvre la vanne"),
        ("avance à une vitesse de deux mètres par seconde", "avance à deux mètres par seconde"),
    ]),
    "es": ("""
language: es
slots: {cosa: [válvula, bomba], cuánto: angle, marcha: speed, rato: duration}
intents:
  abrir: {action: custom, sentences: ["abre la {cosa}"]}
  girar: {action: custom, sentences: ["gira a la izquierda [{cuánto}]"]}
  bomba: {action: custom, sentences: ["abre la bomba durante {rato}"]}
  avanzar: {action: custom, sentences: ["avanza [a {marcha}]"]}
""", [
        ("abre esta válvula", "abre la válvula"),
        ("abre la bomba diez minutos", "abre la bomba durante diez minutos"),
        ("gira hacia la izquierda", "gira a la izquierda"),
        ("avanza a una velocidad de un metro por segundo", "avanza a un metro por segundo"),
    ]),
    "it": ("""
language: it
slots: {cosa: [valvola, pompa], quanto: angle, passo: speed}
intents:
  aprire: {action: custom, sentences: ["apri la {cosa}"]}
  girare: {action: custom, sentences: ["gira a sinistra [{quanto}]"]}
  andare: {action: custom, sentences: ["vai avanti [a {passo}]"]}
""", [
        ("apri questa valvola", "apri la valvola"),
        ("gira verso sinistra", "gira a sinistra"),
        ("gira a sinistra di trenta gradi", "gira a sinistra trenta gradi"),
        ("vai avanti a una velocità di un metro al secondo", "vai avanti a un metro al secondo"),
    ]),
}  # fmt: skip


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [(language, said, meant) for language, (_, rows) in FOREIGN.items() for said, meant in rows],
)
def test_other_languages_have_such_words(engine_of, language: str, said: str, meant: str) -> None:
    engine = engine_of(FOREIGN[language][0])
    assert engine.parse(said).actions == engine.parse(meant).actions != ()


@pytest.mark.parametrize("said", ["don't turn to the left", "do not turn leftwards", "please don't turn to your left"])
def test_a_motion_that_is_forbidden_in_other_words_stops(engine_of, said: str) -> None:
    engine = engine_of("""
intents:
  turn: {action: {type: turn, direction: left}, sentences: ["turn left"]}
""")
    assert engine.parse(said, state=("moving",)).stops
    assert engine.parse(said).denied


OPPOSITES = {
    "en": """
slots: {d: distance, way: {type: choice, values: {up: [up], down: [down]}}}
intents: {lift: {action: custom, sentences: ["lift the tray [{way}] [by] {d}", "lift the tray by {d} {way}"]}}
""",
    "de": """
language: de
slots: {d: distance, way: {type: choice, values: {up: [hoch, "nach oben"], down: [runter, herunter, "nach unten"]}}}
intents: {lift: {action: custom, sentences: ["heb den Korb {d} {way}"]}}
""",
}


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "lift the tray up down two meters"),
        ("en", "lift the tray down up by two meters"),
        ("en", "lift the tray up by two meters down"),
        ("en", "lift up the tray two meters down"),
        ("de", "heb den Korb zwei Meter hoch runter"),
        ("de", "heb den Korb zwei Meter runter hoch"),
        ("de", "heb den Korb zwei Meter hoch nach unten"),
        ("de", "heb den Korb zwei Meter tief nach oben"),
        ("de", "heb den Korb hoch zwei Meter herunter"),
    ],
)
def test_one_of_two_opposite_ways_is_not_left_out(engine_of, language: str, said: str) -> None:
    assert not engine_of(OPPOSITES[language]).parse(said).actions
