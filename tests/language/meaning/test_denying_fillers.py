"""What says no and denies nothing: "if you don't mind". All the rest that says no still denies."""

from __future__ import annotations

import pytest

GRAMMARS = {
    "en": ("turn the lamp on", "dim the lamp by {by}"),
    "de": ("schalte die Lampe ein", "dimme die Lampe um {by}"),
    "fr": ("allume la lampe", "baisse la lampe de {by}"),
    "es": ("enciende la lámpara", "baja la lámpara {by}"),
    "it": ("accendi la lampada", "abbassa la lampada di {by}"),
}


def grammar(language: str, fillers: str = "") -> str:
    light, dim = GRAMMARS[language]
    return f"""
language: {language}
{fillers}
slots: {{by: percent}}
intents:
  light: {{action: custom, sentences: ["{light}"]}}
  dim: {{action: custom, sentences: ["{dim}"]}}
"""


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en", "if you don't mind, {}"),
        ("en", "{} if it's not too much trouble"),
        ("en", "if you wouldn't mind {}"),
        ("de", "{}, wenn es dir nichts ausmacht"),
        ("de", "wenn Sie nichts dagegen haben, {}"),
        ("fr", "si ça ne te dérange pas, {}"),
        ("es", "{}, si no te importa"),
        ("it", "se non ti dispiace, {}"),
    ],
)
@pytest.mark.parametrize("own", ["", "fillers: [hoho]"])
def test_a_polite_no_denies_nothing(engine_of, language: str, text: str, own: str) -> None:
    engine = engine_of(grammar(language, own))
    said = GRAMMARS[language][0]
    assert engine.parse(text.format(said)).actions == engine.parse(said).actions != ()


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("en", "if you don't mind, don't turn the lamp on"),
        ("en", "don't turn the lamp on if you don't mind"),
        ("en", "I don't mind turn the lamp on"),
        ("en", "if you don't mind the dark turn the lamp on"),
        ("en", "if you don't turn the lamp on"),
        ("de", "schalte die Lampe nicht ein, wenn es dir nichts ausmacht"),
        ("fr", "si ça ne te dérange pas, n'allume pas la lampe"),
        ("es", "no enciendas la lámpara, si no te importa"),
        ("it", "se non ti dispiace, non accendere la lampada"),
    ],
)
def test_and_any_other_no_does(engine_of, language: str, text: str) -> None:
    assert not engine_of(grammar(language)).parse(text).actions


def test_a_grammar_without_fillers_has_none(engine_of) -> None:
    engine = engine_of(grammar("en", "fillers: []"))
    assert not engine.parse("if you don't mind, turn the lamp on").actions
