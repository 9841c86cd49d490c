"""Stops as they are said to one, to several and to a stranger, and with words that say nothing within them."""

from __future__ import annotations

import pytest
from meanings import done, german

GRAMMAR = """
language: {}
intents:
  go: {{action: {{type: move, direction: forward, distance: 1 m}}, sentences: ["{}"]}}
"""
GO = {"de": "fahr vor", "fr": "avance", "es": "avanza", "it": "vai avanti"}
STOPS = {
    "de": [
        "haltet an", "bleibt stehen", "hört auf", "bleib dort stehen", "halten Sie bitte an",
        "bleiben Sie bitte stehen", "halt doch jetzt mal an", "bleib bitte sofort stehen", "bleib wo du bist",
        "stoppt", "stoppe", "stoppen", "du sollst anhalten", "ich möchte, dass du anhältst", "stehen geblieben",
        "kannst du bitte stehen bleiben?",
    ],
    "fr": [
        "arrêtez-vous immédiatement", "arrête s'il te plaît tout de suite", "arrête-toi là", "ne bouge pas",
        "ne bougez plus", "n'avance plus", "plus un geste", "ça suffit", "reste là", "reste où tu es",
        "restez où vous êtes", "peux-tu t'arrêter ?", "tu peux arrêter ?", "arrêter", "freinez", "halte-là",
    ],
    "es": [
        "pare", "párese", "para ahí", "deténgase", "deténgase por favor", "quédate ahí", "no se mueva",
        "no te muevas más", "ya basta", "frene", "¿puedes parar?", "deja de moverte", "parar", "detener",
        "ni un paso más",
    ],
    "it": [
        "si fermi", "fermatevi", "fermati lì", "non ti muovere", "non si muova", "resta lì", "resta fermo",
        "basta così", "smettila", "smetti di muoverti", "freni", "puoi fermarti?", "fermarsi",
    ],
}  # fmt: skip
NONE = {
    "de": ["ohne anzuhalten", "ohne zu bremsen", "nicht stoppen", "haltet nicht an", "bleibt nicht stehen"],
    "fr": ["ne t'arrête pas", "sans s'arrêter", "il ne faut pas s'arrêter", "n'arrêtez pas", "le train s'arrête ici"],
    "es": ["no pares", "no te detengas", "sin parar", "sin detenerse", "no se pare"],
    "it": ["non fermarti", "non ti fermare", "senza fermarti", "non si fermi", "non fermatevi"],
}


@pytest.mark.parametrize(("language", "said"), [(language, said) for language, rows in STOPS.items() for said in rows])
@pytest.mark.parametrize("state", [(), ("moving",)])
def test_a_stop_stops(engine_of, language: str, said: str, state: tuple[str, ...]) -> None:
    engine = engine_of(GRAMMAR.format(language, GO[language]))
    assert done(engine.parse(said, state=state)) == "stop"
    assert done(engine.parse(f"{GO[language]}, {said}", state=state)) == "stop"


@pytest.mark.parametrize(("language", "said"), [(language, said) for language, rows in NONE.items() for said in rows])
def test_who_says_not_to_stop_stops_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMAR.format(language, GO[language])).parse(said).actions


@pytest.mark.parametrize(
    "said",
    [
        "warte dort", "wart mal", "wartet hier", "warte hier auf mich", "pausiere", "halt endlich an",
        "nun halt schon an", "bleib doch endlich stehen", "fahr nicht los", "stopp den Motor", "ey stopp",
        "hör bitte damit auf",
    ],
)  # fmt: skip
def test_the_german_grammar_stops(said: str) -> None:
    assert done(german().parse(said, state=("moving",))) == "stop"
    assert done(german().parse(said)) == "stop"


@pytest.mark.parametrize("said", ["das geht nicht", "warte nicht auf mich", "die Wartehalle"])
def test_the_german_grammar_does_not(said: str) -> None:
    assert not german().parse(said).actions
