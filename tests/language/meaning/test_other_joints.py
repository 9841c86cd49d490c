"""Words of several languages that join commands and correct them: each grammar of the language has them."""

from __future__ import annotations

import pytest

from intent_engine import IntentEngine, Status
from intent_engine.actions import Custom

SENTENCES = {
    "de": ("geh zum {place}", "öffne die Schublade"),
    "fr": ("va au {place}", "ouvre le tiroir"),
    "es": ("ve al {place}", "abre el cajón"),
    "it": ("vai al {place}", "apri il cassetto"),
}
PLACES = {"de": ("Labor", "Lager"), "fr": ("labo", "garage"), "es": ("taller", "garaje"), "it": ("banco", "garage")}
JOINTS = {
    "de": ("wenn du da bist", "sobald du fertig bist", "und als nächstes", "zum Schluss"),
    "fr": ("quand tu y seras", "une fois arrivé", "et quand tu as fini", "enfin"),
    "es": ("cuando llegues", "una vez allí", "y cuando termines", "por último"),
    "it": ("quando arrivi", "una volta lì", "e quando hai finito", "infine"),
}
CORRECTIONS = {
    "de": ("nee", "ach nein", "Korrektur", "oder besser"),
    "fr": ("non plutôt", "enfin non", "excuse-moi"),
    "es": ("no digo", "quise decir", "perdona"),
    "it": ("no anzi", "volevo dire", "mi correggo"),
}
HESITATIONS = {"de": "ähm", "fr": "euh", "es": "eh", "it": "ehm"}


@pytest.fixture(scope="module")
def engines(engine_of) -> dict[str, IntentEngine]:
    made = {}
    for language, (go, other) in SENTENCES.items():
        places = ", ".join(PLACES[language])
        made[language] = engine_of(
            f"language: {language}\nslots: {{place: [{places}]}}\nintents:\n"
            f'  go: {{action: custom, sentences: ["{go}"]}}\n  open: {{action: custom, sentences: ["{other}"]}}\n'
        )
    return made


def rows(words: dict[str, tuple[str, ...]]) -> list[tuple[str, str]]:
    return [(language, one) for language, several in words.items() for one in several]


def names(engine: IntentEngine, said: str) -> list[str]:
    actions = engine.parse(said).actions
    assert all(isinstance(action, Custom) for action in actions)
    return [action.name for action in actions if isinstance(action, Custom)]


@pytest.mark.parametrize(("language", "joint"), rows(JOINTS))
def test_what_joins_two_commands(engines, language: str, joint: str) -> None:
    go, other = SENTENCES[language]
    first = go.format(place=PLACES[language][0])
    assert names(engines[language], f"{first}, {joint} {other}") == ["go", "open"]
    assert names(engines[language], f"{joint}, {other}") == ["open"]
    assert names(engines[language], f"{first}, {joint}") == []


@pytest.mark.parametrize(("language", "words"), rows(CORRECTIONS))
def test_what_corrects(engines, language: str, words: str) -> None:
    first, second = (SENTENCES[language][0].format(place=place) for place in PLACES[language])
    for said in (f"{first}, {words}, {second}", f"{first}, {words} {PLACES[language][1]}"):
        found = engines[language].parse(said)
        assert found.slots == {"place": PLACES[language][1]}, said


@pytest.mark.parametrize(("language", "hesitation"), HESITATIONS.items())
def test_what_follows_a_hesitation_may_be_said_anew(engines, language: str, hesitation: str) -> None:
    first, second = (SENTENCES[language][0].format(place=place) for place in PLACES[language])
    assert engines[language].parse(f"{first}, {hesitation}, {second}").status is Status.AMBIGUOUS
    assert len(engines[language].parse(f"{first}, {second}").actions) == 2
