"""Words that soften an order and say nothing of it, and those that say nothing beside an amount."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "fr": """
language: fr
slots: {loin: distance}
intents:
  ouvrir: {action: custom, sentences: ["ouvre la porte"]}
  monter: {action: custom, sentences: ["monte la caisse [de {loin}]"]}
""",
    "es": """
language: es
slots: {rato: duration}
intents:
  abrir: {action: custom, sentences: ["abre la puerta"]}
  regar: {action: custom, sentences: ["riega la huerta [durante {rato}]"]}
""",
    "it": """
language: it
slots: {quanto: angle}
intents:
  aprire: {action: custom, sentences: ["apri la porta"]}
  girare: {action: custom, sentences: ["gira la gru [di {quanto}]"]}
""",
    "de": """
language: de
slots: {zeit: duration, distance: distance}
intents:
  öffnen: {action: custom, sentences: ["öffne die Tür"]}
  rühren: {action: custom, sentences: ["rühr den Brei [für {zeit}]"]}
  fahren: {action: move, sentences: [{say: "fahr {distance} vor", slots: {direction: forward}}]}
""",
}
PACED = """
language: de
slots: {tempo: [langsam, schnell], ort: [Tor, Lager]}
intents:
  schwenken: {action: custom, sentences: ["schwenk [{tempo}] zum {ort}"]}
  öffnen: {action: custom, sentences: ["öffne das {ort}"]}
"""


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("fr", "ouvre voir la porte", "ouvre la porte"),
        ("fr", "ouvrez bien la porte", "ouvre la porte"),
        ("fr", "monte un peu la caisse, de deux mètres", "monte la caisse de deux mètres"),
        ("es", "cierra, no, abre la puerta, anda", "abre la puerta"),
        ("es", "riega un poco la huerta durante dos minutos", "riega la huerta durante dos minutos"),
        ("it", "apri pure la porta", "apri la porta"),
        ("it", "gira un attimo la gru di dieci gradi", "gira la gru di dieci gradi"),
        ("de", "öffne ruhig die Tür", "öffne die Tür"),
        ("de", "öffne bitte schnell die Tür", "öffne die Tür"),
        ("de", "kannst du mal eben schnell die Tür öffnen", "öffne die Tür"),
        ("de", "schnell, öffne die Tür", "öffne die Tür"),
        ("fr", "ouvre vite la porte", "ouvre la porte"),
        ("fr", "vite, ouvrez la porte", "ouvre la porte"),
        ("fr", "allez, ouvre la porte", "ouvre la porte"),
        ("fr", "ouvre la porte quand même", "ouvre la porte"),
        ("fr", "dis, ouvre la porte", "ouvre la porte"),
        ("es", "abre la puerta de una vez", "abre la puerta"),
        ("es", "abre la puerta, anda, que llueve", "abre la puerta"),
        ("it", "apri la porta pure", "apri la porta"),
        ("it", "apri la porta, mi raccomando", "apri la porta"),
        ("de", "öffne die Tür noch", "öffne die Tür"),
        ("de", "du, öffne die Tür", "öffne die Tür"),
        ("es", "abre rápido la puerta", "abre la puerta"),
        ("es", "abre de una vez la puerta", "abre la puerta"),
        ("fr", "ouvre aussi la porte", "ouvre la porte"),
        ("fr", "ouvre plutôt la porte", "ouvre la porte"),
        ("es", "abre también la puerta", "abre la puerta"),
        ("es", "abre mejor la puerta", "abre la puerta"),
        ("it", "apri anche la porta", "apri la porta"),
        ("it", "apri invece la porta", "apri la porta"),
        ("de", "öffne auch die Tür", "öffne die Tür"),
        ("de", "öffne doch lieber die Tür", "öffne die Tür"),
        ("de", "kannst du kurz die Tür öffnen?", "öffne die Tür"),
        ("de", "fahr nur einen halben Meter vor", "fahr einen halben Meter vor"),
        ("de", "rühr den Brei, und zwar für zehn Minuten", "rühr den Brei für zehn Minuten"),
    ],
)
def test_it_is_the_order(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("fr", "monte un peu la caisse"),  # how much that is nobody knows
        ("fr", "ouvre la porte pour voir"),
        ("fr", "il ouvre bien la porte"),
        ("es", "riega un poco la huerta"),
        ("es", "anda a la puerta"),
        ("it", "gira un po' la gru"),
        ("it", "apri pure domani la porta"),
        ("de", "rühr ein bisschen den Brei"),
        ("de", "rühr den Brei, und zwar morgen"),
        ("de", "fahr schnell zwei Meter vor"),  # which says how fast
        ("de", "öffne schneller die Tür"),
        ("fr", "n'ouvre pas aussi la porte"),
        ("fr", "ouvre plutôt pas la porte"),
        ("es", "no abras también la puerta"),
        ("es", "abre mejor no la puerta"),
        ("it", "apri anche no la porta"),
        ("it", "apri invece di chiudere la porta"),
        ("de", "öffne lieber nicht die Tür"),
        ("de", "öffne auch nicht die Tür"),
        ("de", "öffne kurz die Tür"),  # and close it then?
        ("de", "rühr den Brei für hundert lieber fünfzig Minuten"),  # no 150
        ("de", "öffne die Tür, auch wenn es kalt ist"),
        ("de", "öffne die Tür noch nicht"),
        ("de", "du öffnest die Tür"),
        ("es", "abre la puerta mejor"),
        ("es", "abre la puerta, anda, que no"),
        ("de", "öffne zu schnell die Tür"),
        ("de", "öffne nicht so schnell die Tür"),
        ("de", "er öffnet schnell die Tür"),
        ("fr", "ouvre plus vite la porte"),
        ("fr", "il ouvre vite la porte"),
        ("es", "abre más rápido la puerta"),
        ("de", "öffne nur die Tür"),  # and what not?
        ("de", "öffne ruhig nicht die Tür"),
    ],
)
def test_what_may_say_more_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions


def test_a_grammar_that_says_how_fast_means_it(engine_of) -> None:
    engine = engine_of(PACED)
    assert engine.parse("schwenk mal schnell zum Tor").slots == {"tempo": "schnell", "ort": "Tor"}
    assert not engine.parse("öffne schnell das Tor").actions
