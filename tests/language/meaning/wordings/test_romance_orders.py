"""Orders as people put them in Spanish, French and Italian, and in German to a friend, of a grammar that has "riega la
huerta": to a stranger, in the infinitive behind what asks, as a wish, and as a question with "please"."""

from __future__ import annotations

import pytest
from meanings import assert_same

from intent_engine.engine import IntentEngine

GRAMMARS = {
    "es": """
language: es
slots: {zona: [huerta, terraza], n: {type: number, whole: true}, m: distance}
intents:
  regar: {action: custom, sentences: ["riega la {zona}"]}
  encender: {action: custom, sentences: ["enciende la luz"]}
  llevar: {action: custom, sentences: ["lleva {n} cajas"]}
  hacer: {action: custom, sentences: ["haz una foto"]}
  subir: {action: custom, sentences: ["sube {m}"]}
  ir: {action: custom, sentences: ["ve a la {zona}"]}
  medir: {action: custom, sentences: ["mide la humedad"]}
  traer: {action: custom, sentences: ["trae la caja"]}
  dar: {action: custom, sentences: ["da la llave"]}
""",
    "fr": """
language: fr
slots: {lieu: [cave, cuisine], n: {type: number, whole: true}}
intents:
  peser: {action: custom, sentences: ["pèse {n} oeufs"]}
  sortir: {action: custom, sentences: ["sors le pain"]}
  aller: {action: custom, sentences: ["va à la {lieu}"]}
  eteindre: {action: custom, sentences: ["éteins la lampe"]}
  regler: {action: custom, sentences: ["règle le four"]}
""",
    "it": """
language: it
slots: {luogo: [cantina, cucina]}
intents:
  andare: {action: custom, sentences: ["vai in {luogo}"]}
  accendere: {action: custom, sentences: ["accendi la luce"]}
  portare: {action: custom, sentences: ["porta la cassa"]}
  pulire: {action: custom, sentences: ["pulisci la {luogo}"]}
  iniziare: {action: custom, sentences: ["inizia il giro"]}
  fare: {action: custom, sentences: ["fai una foto"]}
  dare: {action: custom, sentences: ["dai la chiave"]}
""",
    "de": """
language: de
slots: {n: {type: number, whole: true}, zeit: duration}
intents:
  schalten: {action: custom, sentences: ["schalte die Pumpe ein"]}
  holen: {action: custom, sentences: ["hol {n} Kisten"]}
  nehmen: {action: custom, sentences: ["nimm die Kiste"]}
  prüfen: {action: custom, sentences: ["prüfe Tank {n}"]}
  rühren: {action: custom, sentences: ["rühr den Brei [für {zeit}]"]}
""",
}
STRANGERS_VERBS = """
language: es
slots: {zona: [huerta, terraza]}
intents: {regar: {action: custom, sentences: ["riegue la {zona}", "abra la {zona}"]}}
"""


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    return {language: engine_of(text) for language, text in GRAMMARS.items()}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("es", "riegue la huerta, por favor", "riega la huerta"),
        ("es", "encienda la luz y vaya a la terraza", "enciende la luz y ve a la terraza"),
        ("es", "rieguen la huerta", "riega la huerta"),
        ("es", "¿puedes regar la huerta?", "riega la huerta"),
        ("es", "podría encender la luz", "enciende la luz"),
        ("es", "puedes ir a la terraza y medir la humedad", "ve a la terraza y mide la humedad"),
        ("es", "¿te importaría hacer una foto?", "haz una foto"),
        ("es", "quiero que riegues la terraza", "riega la terraza"),
        ("es", "me gustaría que midieras la humedad", "mide la humedad"),
        ("es", "hazme una foto", "haz una foto"),
        ("es", "enciéndeme la luz", "enciende la luz"),
        ("es", "lléveme dos cajas", "lleva dos cajas"),
        ("es", "¿me riegas la huerta?", "riega la huerta"),
        ("es", "¿enciendes la luz, por favor?", "enciende la luz"),
        ("es", "enciende la luz otra vez", "enciende la luz"),
        ("es", "encienda usted la luz", "enciende la luz"),
        ("es", "tráigame usted la caja, porfa", "trae la caja"),
        ("es", "¿podría usted traerme la caja?", "trae la caja"),
        ("es", "necesito que me traigas la caja", "trae la caja"),
        ("es", "¿me regarías la huerta?", "riega la huerta"),
        ("fr", "tu peux me sortir le pain, s'il te plaît ?", "sors le pain"),
        ("fr", "vous pourriez m'éteindre la lampe et nous régler le four", "éteins la lampe et règle le four"),
        ("fr", "veuillez régler le four", "règle le four"),
        ("fr", "il faudrait éteindre la lampe", "éteins la lampe"),
        ("fr", "j'aimerais que vous me sortiez le pain", "sors le pain"),
        ("fr", "vous m'éteignez la lampe, s'il vous plaît ?", "éteins la lampe"),
        ("fr", "sors-nous le pain", "sors le pain"),
        ("it", "puoi portarmi la cassa", "porta la cassa"),
        ("it", "mi accendi la luce per favore?", "accendi la luce"),
        ("it", "mi pulisci quella cucina?", "pulisci la cucina"),
        ("it", "inizi il giro", "inizia il giro"),
        ("it", "mi piacerebbe che accendessi la luce", "accendi la luce"),
        ("it", "ci porteresti la cassa?", "porta la cassa"),
        ("de", "könnten Sie wohl die Pumpe einschalten", "schalte die Pumpe ein"),
        ("de", "ich möchte, dass Sie Tank 3 prüfen", "prüfe Tank 3"),
        ("de", "kannst du für zehn Minuten den Brei rühren", "rühr den Brei für zehn Minuten"),
        ("fr", "pesez trois oeufs", "pèse trois oeufs"),
        ("fr", "peux-tu sortir le pain ?", "sors le pain"),
        ("fr", "vous pourriez peser trois oeufs", "pèse trois oeufs"),
        ("fr", "tu pourrais éteindre la lampe et régler le four", "éteins la lampe et règle le four"),
        ("fr", "je voudrais que tu ailles à la cave", "va à la cave"),
        ("fr", "il faut que vous éteigniez la lampe", "éteins la lampe"),
        ("fr", "tu sors le pain, s'il te plaît ?", "sors le pain"),
        ("fr", "sors le pain tout de suite", "sors le pain"),
        ("it", "accenda la luce", "accendi la luce"),
        ("it", "vada in cantina e porti la cassa", "vai in cantina e porta la cassa"),
        ("it", "può accendere la luce?", "accendi la luce"),
        ("it", "potresti pulire la cucina per favore", "pulisci la cucina"),
        ("it", "vorrei che tu pulissi la cucina", "pulisci la cucina"),
        ("it", "portami la cassa", "porta la cassa"),
        ("it", "fammi una foto", "fai una foto"),
        ("it", "dacci la chiave", "dai la chiave"),
        ("es", "¿me das la llave?", "da la llave"),
        ("es", "déme usted la llave", "da la llave"),
        ("es", "¿puedes darme la llave?", "da la llave"),
        ("de", "schaltest du bitte die Pumpe ein?", "schalte die Pumpe ein"),
        ("de", "nimmst du bitte die Kiste", "nimm die Kiste"),
        ("de", "hole zwei Kisten", "hol zwei Kisten"),
        ("de", "prüf Tank 3", "prüfe Tank 3"),
        ("de", "die Pumpe bitte einschalten", "schalte die Pumpe ein"),
        ("de", "bitte Tank 3 prüfen", "prüfe Tank 3"),
    ],
)
def test_it_is_the_order(engines, language: str, said: str, meant: str) -> None:
    assert_same(engines[language], said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("es", "no riegue la huerta"),
        ("es", "no encienda usted la luz"),
        ("es", "usted enciende la luz"),
        ("es", "me trae la caja"),
        ("es", "puedes traerme suerte"),
        ("fr", "tu m'éteins la lampe"),
        ("fr", "il m'éteint la lampe"),
        ("fr", "je peux t'éteindre la lampe"),
        ("fr", "veuillez ne pas sortir le pain"),
        ("fr", "il faudrait éteindre la lampe ?"),
        ("fr", "il faudrait que Paul me sorte le pain"),
        ("it", "mi porta la cassa"),
        ("it", "mi hai acceso la luce"),
        ("it", "vorrei che non accendessi la luce"),
        ("it", "Paolo mi accende la luce"),
        ("de", "ich möchte, dass sie die Pumpe einschaltet"),
        ("de", "ich möchte, dass Sie Tank 3 nicht prüfen"),
        ("es", "quiero regar la huerta"),
        ("es", "quiero que no riegues la huerta"),
        ("es", "quiero que Pedro riegue la huerta"),
        ("es", "riegas la huerta"),
        ("es", "¿quieres regar la huerta?"),
        ("fr", "veux-tu sortir le pain ?"),
        ("de", "willst du die Pumpe einschalten?"),
        ("es", "¿riegas la huerta?"),
        ("es", "ya riega la huerta"),
        ("es", "regar la huerta"),
        ("es", "súbeme dos metros"),
        ("es", "regué la huerta"),
        ("es", "¿puedo encender la luz?"),
        ("es", "antes de encender la luz"),
        ("es", "si puedes regar la huerta"),
        ("fr", "tu sors le pain"),
        ("fr", "tu sors le pain ?"),
        ("fr", "je peux sortir le pain"),
        ("fr", "je voudrais sortir le pain"),
        ("fr", "il faut que Paul sorte le pain"),
        ("fr", "il faut que tu ne sortes pas le pain"),
        ("fr", "quand tu sors le pain"),
        ("it", "non accenda la luce"),
        ("it", "vorrei accendere la luce"),
        ("it", "vorrei che Paolo accendesse la luce"),
        ("it", "se accende la luce"),
        ("de", "schaltest du die Pumpe ein?"),
        ("de", "schaltest du bitte die Pumpe nicht ein"),
        ("de", "die Pumpe einschalten?"),
        ("de", "die Pumpe bitte nicht einschalten"),
        ("de", "wir wollen bitte die Pumpe einschalten"),
        ("de", "ich hole zwei Kisten"),
    ],
)
def test_what_tells_asks_or_forbids_does_nothing(engines, language: str, said: str) -> None:
    assert not engines[language].parse(said).actions


@pytest.mark.parametrize(
    "said", ["riega la huerta", "abre la terraza", "puedes regar la huerta", "¿me abres la terraza?"]
)
def test_a_grammar_for_strangers_is_understood_of_friends(engine_of, said: str) -> None:
    assert engine_of(STRANGERS_VERBS).parse(said).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("es", "quiero que pares"), ("es", "me gustaría que te detuvieras"), ("es", "párate ya"),
        ("fr", "je voudrais que tu t'arrêtes"), ("it", "vorrei che ti fermassi"), ("de", "hältst du bitte an?"),
    ],
)  # fmt: skip
def test_a_stop_that_is_wished_stops(engines, language: str, said: str) -> None:
    assert engines[language].parse(said, state=["moving"]).stops


@pytest.mark.parametrize("said", ["no rieguen la huerta", "no riegue la huerta", "no riegues la huerta"])
def test_what_is_forbidden_a_stranger_ends_nothing_else(engines, said: str) -> None:
    found = engines["es"].parse(said, state=["moving"])
    assert not found.actions
    assert found.denied
