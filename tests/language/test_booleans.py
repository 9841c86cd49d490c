"""A slot that is on or off, in words of the grammar's language."""

from __future__ import annotations

import pytest

from intent_engine.errors import ConfigError

GRAMMAR = """
language: {language}
slots: {{lit: boolean}}
intents: {{lamp: {{action: custom, sentences: ["lamp {{lit}}"]}}}}
"""
DUTCH = "operators: {negation: [niet], stop: [stop]}\n"


@pytest.mark.parametrize(
    ("language", "on", "off"),
    [
        ("en", ["on", "yes", "true"], ["off", "false"]),
        ("de", ["an", "ein", "ja"], ["aus"]),
        ("fr", ["oui", "on", "en marche", "allumée"], ["off", "éteinte", "à l'arrêt"]),
        ("es", ["sí", "encendida"], ["off", "apagada"]),
        ("it", ["sì", "acceso"], ["off", "spento"]),
    ],
)
def test_each_language_has_words_for_both(engine_of, language: str, on: list[str], off: list[str]) -> None:
    engine = engine_of(GRAMMAR.format(language=language))
    assert all(engine.parse(f"lamp {said}").slots == {"lit": True} for said in on)
    assert all(engine.parse(f"lamp {said}").slots == {"lit": False} for said in off)


@pytest.mark.parametrize(
    ("language", "said"), [("en", "no"), ("fr", "non"), ("it", "no"), ("de", "nein"), ("de", "yes"), ("it", "yes")]
)
def test_what_corrects_says_nothing_by_itself(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMAR.format(language=language)).parse(f"lamp {said}").actions


def test_a_language_that_is_not_known_needs_values(engine_of) -> None:
    with pytest.raises(ConfigError) as error:
        engine_of(GRAMMAR.format(language="nl") + DUTCH)
    assert "what is said for true and for false is not known in 'nl'" in str(error.value)
    assert "write values: {true: [...], false: [...]}" in str(error.value)
    with_values = GRAMMAR.replace("lit: boolean", "lit: {{type: boolean, values: {{true: aan, false: uit}}}}")
    assert engine_of(with_values.format(language="nl") + DUTCH).parse("lamp aan").slots == {"lit": True}
