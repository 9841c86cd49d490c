"""Reasons told beside a command in German, French, Spanish and Italian."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "de": """
language: de
slots: {teil: [Lampe, Heizung], raum: [Küche, Bad]}
intents:
  an: {action: custom, sentences: ["schalte die {teil} ein"]}
  fahren: {action: custom, sentences: ["fahr in (die|das) {raum}"]}
""",
    "fr": """
language: fr
slots: {lieu: [cuisine, chambre]}
intents:
  fermer: {action: custom, sentences: ["ferme la porte"]}
  allumer: {action: custom, sentences: ["allume la lampe"]}
  aller: {action: custom, sentences: ["va à la {lieu}"]}
""",
    "es": """
language: es
slots: {lugar: [cocina, sala]}
intents:
  cerrar: {action: custom, sentences: ["cierra la puerta"]}
  encender: {action: custom, sentences: ["enciende la luz"]}
  ir: {action: custom, sentences: ["ve a la {lugar}"]}
""",
    "it": """
language: it
slots: {luogo: [cucina, camera]}
intents:
  chiudere: {action: custom, sentences: ["chiudi la porta"]}
  accendere: {action: custom, sentences: ["accendi la luce"]}
  andare: {action: custom, sentences: ["vai in {luogo}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("de", "es ist dunkel, schalte die Lampe ein", "schalte die Lampe ein"),
        ("de", "schalte die Heizung ein, mir ist kalt", "schalte die Heizung ein"),
        ("de", "schalte bitte die Lampe ein, damit ich etwas sehe", "schalte die Lampe ein"),
        ("de", "fahr in die Küche, weil das Bad voll ist", "fahr in die Küche"),
        ("de", "meine Füße sind kalt, schalte mal die Heizung ein", "schalte die Heizung ein"),
        ("de", "schalte die Lampe ein, denn es wird dunkel", "schalte die Lampe ein"),
        ("fr", "c'est trop sombre, allume la lampe", "allume la lampe"),
        ("fr", "allume la lampe parce qu'il fait nuit", "allume la lampe"),
        ("fr", "j'ai froid, va à la chambre", "va à la chambre"),
        ("fr", "mes pieds sont froids, va à la chambre", "va à la chambre"),
        ("es", "está muy oscuro, enciende la luz", "enciende la luz"),
        ("es", "enciende la luz, porque tengo frío", "enciende la luz"),
        ("es", "la puerta está abierta, ve a la sala", "ve a la sala"),
        ("it", "è troppo buio, accendi la luce", "accendi la luce"),
        ("it", "accendi la luce perché ho freddo", "accendi la luce"),
        ("it", "c'è gente alla porta, vai in cucina", "vai in cucina"),
        ("fr", "il fait froid, ferme la porte", "ferme la porte"),
        ("fr", "ferme la porte, j'ai froid", "ferme la porte"),
        ("fr", "ferme la porte parce qu'il fait froid", "ferme la porte"),
        ("fr", "ferme la porte à cause du bruit", "ferme la porte"),
        ("fr", "allume la lampe pour que je voie mieux", "allume la lampe"),
        ("fr", "ferme la porte, la soupe est froide", "ferme la porte"),
        ("es", "cierra la puerta, hace frío", "cierra la puerta"),
        ("es", "cierra la puerta porque hace frío", "cierra la puerta"),
        ("es", "tengo miedo, enciende la luz", "enciende la luz"),
        ("es", "ve a la cocina, la sopa está fría", "ve a la cocina"),
        ("es", "enciende la luz, así puedo ver", "enciende la luz"),
        ("it", "chiudi la porta, fa freddo", "chiudi la porta"),
        ("it", "chiudi la porta perché fa freddo", "chiudi la porta"),
        ("it", "ho paura, accendi la luce", "accendi la luce"),
        ("it", "vai in cucina, la zuppa è pronta", "vai in cucina"),
        ("it", "accendi la luce così posso leggere", "accendi la luce"),
        ("de", "die Gäste warten schon, also fahr bitte ins Bad", "fahr in das Bad"),
        ("de", "fahr in die Küche, die reisen ab", "fahr in die Küche"),
        ("de", "hier staubt es, schalte die Lampe ein", "schalte die Lampe ein"),
        ("de", "es regnet, fahr in die Küche", "fahr in die Küche"),
        ("de", "das Bad braucht eine Lampe, fahr in das Bad", "fahr in das Bad"),
        ("de", "schalte die Lampe ein, man sieht ja nichts", "schalte die Lampe ein"),
        ("de", "schalte die Lampe ein, ich sehe nichts mehr", "schalte die Lampe ein"),
        ("fr", "il pleut, ferme la porte", "ferme la porte"),
        ("fr", "ferme la porte, les enfants dorment", "ferme la porte"),
        ("fr", "va à la cuisine, ça brûle", "va à la cuisine"),
        ("fr", "allume la lampe, on n'y voit rien ici", "allume la lampe"),
        ("fr", "ferme la porte, on n'entend plus rien", "ferme la porte"),
        ("fr", "on ne voit rien, allume la lampe", "allume la lampe"),
        ("es", "llueve, cierra la puerta", "cierra la puerta"),
        ("es", "cierra la puerta, que hace frío", "cierra la puerta"),
        ("es", "cierra la puerta, que va a llover", "cierra la puerta"),
        ("es", "ve a la cocina, que se quema la sopa", "ve a la cocina"),
        ("es", "enciende la luz, que no se ve nada", "enciende la luz"),
        ("es", "los niños duermen, cierra la puerta", "cierra la puerta"),
        ("it", "piove, chiudi la porta", "chiudi la porta"),
        ("it", "sta per piovere, chiudi la porta", "chiudi la porta"),
        ("it", "chiudi la porta, che fa freddo", "chiudi la porta"),
        ("it", "i clienti aspettano, vai in cucina", "vai in cucina"),
        ("it", "accendi la luce, non si vede niente", "accendi la luce"),
    ],
)
def test_the_command_is_the_same(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "fahr in die Küche, es ist das Bad"),
        ("de", "fahr in die Küche, sagt er"),
        ("de", "es ist ein Witz, fahr in die Küche"),
        ("de", "schalte die Lampe ein, wenn es dunkel ist"),
        ("de", "es ist nicht dunkel, schalte die Lampe ein"),
        ("de", "weil es dunkel ist"),
        # What is written somewhere is no reason.
        ("de", "in der Anleitung steht: schalte die Lampe ein"),
        ("de", "da steht geschrieben: schalte die Lampe ein"),
        ("fr", "c'est écrit : ferme la porte"),
        ("es", "está escrito: cierra la puerta"),
        ("it", "sul foglio c'è scritto: chiudi la porta"),
        ("fr", "il dit va à la chambre"),
        ("fr", "allume la lampe quand il fait nuit"),
        ("fr", "ce n'est pas sombre, allume la lampe"),
        ("es", "ve a la cocina, es la sala"),
        ("es", "dice que enciende la luz"),
        ("es", "enciende la luz cuando esté oscuro"),
        ("it", "vai in cucina, è la camera"),
        ("it", "vai in cucina, è camera"),
        ("it", "mio padre dice vai in cucina"),
        ("fr", "ferme la porte quand il fait froid"),
        ("fr", "ferme la porte, il dit"),
        ("fr", "ferme la porte, c'est une blague"),
        ("fr", "va à la cuisine, c'est la chambre"),
        ("fr", "ferme la porte, il ne fait pas froid"),
        ("fr", "il fait froid"),
        ("fr", "j'ai froid et ferme la porte"),
        ("es", "cierra la puerta cuando hace frío"),
        ("es", "cierra la puerta, hace dos minutos"),
        ("es", "cierra la puerta, dice el jefe"),
        ("es", "cierra la puerta que hay en la cocina"),
        ("es", "enciende la luz para que pueda ver"),  # "para" stops
        ("es", "hace frío"),
        ("it", "chiudi la porta quando fa freddo"),
        ("it", "chiudi la porta, ha detto"),
        ("it", "perché chiudi la porta"),
        ("it", "chiudi la porta se fa freddo"),
        ("it", "fa freddo"),
        ("de", "die Gäste warten nicht, fahr ins Bad"),
        ("de", "die Gäste warten schon"),
        ("de", "regnet es, fahr in die Küche"),  # if it does
        ("de", "schalte die Lampe ein, ich sehe nichts und nicht die Heizung"),
        ("de", "schalte die Lampe ein, ich sehe nichts, aber nicht jetzt"),
        ("de", "man sieht nichts"),
        ("de", "schalte die Lampe ein, das kann warten"),
        ("de", "schalte die Lampe ein, die Gäste können noch warten"),
        ("de", "wer wartet, fahr in die Küche"),
        ("fr", "allume la lampe, on ne veut rien"),
        ("fr", "n'allume pas la lampe, on n'y voit rien"),
        ("fr", "allume la lampe, ça peut attendre"),
        ("fr", "allume la lampe, ça n'allume rien"),
        ("fr", "allume la lampe, on va dire"),
        ("es", "cierra la puerta que está en la cocina"),  # which one
        ("es", "no cierres la puerta, que hace frío"),
        ("es", "enciende la luz, que no quiero nada"),
        ("es", "cierra la puerta, que no"),
        ("it", "chiudi la porta che dà sul giardino"),
        ("it", "non chiudere la porta, che fa freddo"),
        ("it", "accendi la luce, non voglio niente"),
        ("it", "se piove, chiudi la porta"),
        ("de", "schalte die Lampe ein, das ist verboten"),
        ("de", "schalte die Lampe ein, die Feier ist abgesagt"),
        ("fr", "ferme la porte, j'ai changé d'avis"),
        ("fr", "ferme la porte, c'est inutile"),
        ("es", "cierra la puerta, está prohibido"),
        ("es", "cierra la puerta, la fiesta está cancelada"),
        ("it", "chiudi la porta, ho cambiato idea"),
        ("it", "chiudi la porta, è vietato"),
    ],
)
def test_what_is_no_reason_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
