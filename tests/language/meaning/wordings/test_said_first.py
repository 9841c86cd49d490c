"""How something is done, said before its verb: "for ten minutes water the beds"; and behind what has it first."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from intent_engine.engine import IntentEngine
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.wordings.said_first import SaidFirst
from intent_engine.language.utterance import Utterance

FARM = """
language: en
slots:
  bed: [north bed, south bed]
  time: duration
  pace: {type: choice, values: {slow: [slowly], fast: [quickly]}}
  litres: {type: number, max: 9}
  thing: {type: text, max_words: 3}
  load: {type: object, max_words: 3}
intents:
  water: {action: custom, sentences: ["water the {bed} [with {litres} liters] [(for|in) {time}]"]}
  drive: {action: custom, sentences: ["drive to the {bed} [{pace}]"]}
  turn: {action: custom, sentences: ["[{pace}] turn the (crank|{bed} tap)"]}
  push: {action: custom, sentences: ["[{pace}] push {load}"]}
  read: {action: custom, sentences: ["carefully read the gauge"]}
  carry: {action: custom, sentences: ["carry {thing} to the {bed}", "carry {thing} with {thing:tool}"]}
"""


@pytest.fixture(scope="module")
def farm(engine_of) -> IntentEngine:
    return engine_of(FARM)


@pytest.mark.parametrize(
    ("said", "usual"),
    [
        ("for ten minutes water the north bed", "water the north bed for ten minutes"),
        ("With two liters, please water the north bed.", "water the north bed with two liters"),
        ("slowly drive to the south bed", "drive to the south bed slowly"),
        ("quickly, drive to the south bed", "drive to the south bed quickly"),
        ("to the south bed carry the rake", "carry the rake to the south bed"),
        ("turn the crank slowly", "slowly turn the crank"),
        ("turn the north bed tap, quickly please", "quickly turn the north bed tap"),
        ("push the red box slowly", "slowly push the red box"),
        ("push it quickly", "quickly push it"),
        ("read the gauge carefully", "carefully read the gauge"),
    ],
)
def test_it_is_the_same_command(farm: IntentEngine, said: str, usual: str) -> None:
    assert farm.parse(said).actions == farm.parse(usual).actions != ()


@pytest.mark.parametrize(
    "said",
    [
        "in ten minutes water the north bed",  # when, and not how fast
        "for ten minutes water the north bed and drive to the south bed",
        "for ten minutes the north bed got water",
        "for ten minutes don't water the north bed",
        "for ten minutes she watered the north bed",
        "to water the north bed drive to the south bed",
        "with a rake carry the hay",
        "for Anna water the north bed",
        "at noon water the north bed",
        "for ten minutes, or twenty, water the north bed",
        "quickly water the north bed",
        "read the gauge quickly",
        "turn the crank hardly",
        "turn the crank. Slowly drive",
        "turn the crank slowly?",
        "she turns the crank slowly",
        "don't turn the crank slowly",
        "turn slowly the crank",
        "push the box gently",  # no pace of this grammar, and no box
    ],
)
def test_what_may_be_when_or_of_something_else_is_none(farm: IntentEngine, said: str) -> None:
    assert not farm.parse(said).actions


GREENHOUSE = {
    "fr": """
language: fr
slots: {n: {type: number, whole: true}, où: [serre, cour], rayon: [fruits, fleurs], temps: duration}
intents:
  semer: {action: custom, sentences: ["sème {n} graines [dans la {où}]"]}
  imprimer: {action: custom, sentences: ["imprime {n} étiquettes [pour les {rayon}]"]}
  arroser: {action: custom, sentences: ["arrose [les] fleurs [pendant {temps}]"]}
""",
    "es": """
language: es
slots: {giro: angle, lado: [izquierda, derecha], tiempo: duration}
intents:
  girar: {action: custom, sentences: ["gira {giro} a la {lado}"]}
  regar: {action: custom, sentences: ["riega la huerta durante {tiempo}", "riega la huerta en {tiempo}"]}
""",
    "it": """
language: it
slots: {n: {type: number, whole: true}, dove: [serra, stalla]}
intents:
  seminare: {action: custom, sentences: ["semina {n} semi [nella {dove}]"]}
""",
    "de": """
language: de
slots: {n: {type: number, whole: true}, wo: [Halle, Scheune], zeit: duration, grad: number}
intents:
  säen: {action: custom, sentences: ["säe {n} Samen [in der {wo}]"]}
  rasten: {action: custom, sentences: ["mach eine Rast von {zeit} bei {grad} Grad"]}
  gießen: {action: custom, sentences: ["gieß die Beete in {zeit}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "usual"),
    [
        ("fr", "dans la serre, sème dix graines", "sème dix graines dans la serre"),
        ("fr", "pour les fruits, imprime vingt étiquettes", "imprime vingt étiquettes pour les fruits"),
        ("es", "a la izquierda gira treinta grados", "gira treinta grados a la izquierda"),
        ("es", "durante hora y media riega la huerta", "riega la huerta durante hora y media"),
        ("it", "nella serra semina dieci semi", "semina dieci semi nella serra"),
        ("de", "in der Halle säe bitte zehn Samen", "säe zehn Samen in der Halle"),
        ("de", "mach bei 72 Grad eine Rast von zehn Minuten", "mach eine Rast von zehn Minuten bei 72 Grad"),
        ("de", "bei 72 Grad bitte eine Rast von zehn Minuten machen", "mach eine Rast von zehn Minuten bei 72 Grad"),
    ],
)
def test_it_is_the_same_in_other_languages(engine_of, language: str, said: str, usual: str) -> None:
    engine = engine_of(GREENHOUSE[language])
    assert engine.parse(said).actions == engine.parse(usual).actions != ()


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "dans la serre Paul sème dix graines"),
        ("fr", "dans dix minutes arrose les fleurs"),
        ("fr", "pour Paul, imprime vingt étiquettes"),
        ("es", "en diez minutos riega la huerta"),
        ("es", "a la izquierda no gires treinta grados"),
        ("it", "nella serra si semina dieci semi"),
        ("de", "in der Halle säe ich zehn Samen"),
        ("de", "in zehn Minuten gieß die Beete"),
        ("de", "bei 72 Grad machen wir eine Rast von zehn Minuten"),
    ],
)
def test_what_is_told_or_of_another_time_is_none_in_other_languages(engine_of, language: str, said: str) -> None:
    assert not engine_of(GREENHOUSE[language]).parse(said).actions


WORDS = st.sampled_from(
    [
        "slowly",
        "quickly",
        "for",
        "in",
        "with",
        "from",
        "two",
        "ten",
        "minutes",
        "liters",
        "water",
        "drive",
        "push",
        "turn",
        "the",
        "north",
        "bed",
        "tap",
        "to",
        "just",
    ]
)


@given(st.lists(WORDS, min_size=1, max_size=9))
def test_another_order_has_all_the_words(farm: IntentEngine, words: list[str]) -> None:
    """But for what says no more before a verb: "for two minutes *just* hover"."""
    (grammar,) = farm.grammars
    rule, said = SaidFirst(grammar, Phrases(grammar)), Utterance.in_one_breath(words)
    verbs = {"water", "drive", "push", "turn"}
    for way, moved in (*rule.verb_first(said, verbs), *rule.behind_the_verb(said, verbs), *rule.manner_first(said)):
        less = len(words) - len(way)
        assert sorted([*way.words, *["just"] * less]) == sorted(words)
        assert less in (0, 1)
        assert range(len(way))[moved.start : moved.stop] == moved


def test_nothing_that_was_said_is_left_out(farm: IntentEngine) -> None:
    assert not farm.parse("slowly drive to the south bed in ten minutes").actions
    assert not farm.parse("slowly push the cart to the barn, uh, for you").actions
