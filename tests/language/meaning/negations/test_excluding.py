"""What is not meant by a part of a command is named beside it, in every language."""

from __future__ import annotations

from pathlib import Path

import pytest

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: {language}
slots: {{tool: [{tools}]}}
intents:
  take: {{action: custom, sentences: ["{take}"]}}
  light: {{action: custom, sentences: ["{light}"]}}
"""
GRAMMARS = {
    "en": ("hammer, saw", "take the {tool}", "turn on the light"),
    "de": ("Hammer, Bohrer", "nimm den {tool}", "mach das Licht an"),
    "de, feminine": ("Zange, Säge", "nimm die {tool}", "mach das Licht an"),
    "fr": ("pelle, scie", "prends la {tool}", "allume la lampe"),
    "es": ("pala, sierra", "coge la {tool}", "enciende la luz"),
    "it": ("pala, sega", "prendi la {tool}", "accendi la luce"),
}
WANTED = [
    ("de", "nimm den Hammer, nicht den Bohrer", "Hammer"),
    ("de", "nimm den Hammer und nicht den Bohrer", "Hammer"),
    ("de", "nicht den Bohrer, nimm den Hammer", "Hammer"),
    ("de, feminine", "nimm die Zange statt der Säge", "Zange"),
    ("de, feminine", "nimm die Zange anstelle der Säge", "Zange"),
    ("fr", "prends la pelle au lieu de la scie", "pelle"),
    ("es", "coge la pala en vez de la sierra", "pala"),
    ("it", "prendi la pala invece della sega", "pala"),
    ("fr", "prends la pelle, pas la scie", "pelle"),
    ("fr", "prends la pelle et pas la scie", "pelle"),
    ("fr", "prends la pelle, et non la scie", "pelle"),
    ("fr", "prends non pas la scie, mais la pelle", "pelle"),
    ("fr", "pas la scie, prends la pelle", "pelle"),
    ("es", "coge la pala y no la sierra", "pala"),
    ("es", "no la sierra, coge la pala", "pala"),
    ("it", "prendi la pala e non la sega", "pala"),
    ("it", "prendi la pala, ma non la sega", "pala"),
    ("it", "non la sega, prendi la pala", "pala"),
]
NOTHING = [
    ("en", "take the hammer, not, the saw"),
    ("de", "nimm den Hammer nicht den Bohrer"),  # as it is heard: "nimm den Hammer nicht, den Bohrer"?
    ("de", "nimm den Hammer, nicht, den Bohrer"),
    ("de", "nimm den Hammer und nicht"),
    ("de", "nimm den Hammer, nicht jetzt"),
    ("de", "nimm den Hammer, nicht das Licht"),
    ("de", "nicht den Bohrer"),
    ("de, feminine", "nimm die Zange statt der Feile"),
    ("de, feminine", "nimm die Zange statt der"),
    ("de", "noch nicht, den Hammer"),
    ("fr", "prends la pelle pas la scie"),
    ("fr", "prends la pelle et pas maintenant"),
    ("fr", "prends la pelle, et non"),
    ("fr", "pas la scie, la pelle non plus"),
    ("es", "coge la pala, no la sierra"),  # heard, it may be "no, la sierra"
    ("es", "coge la pala y no, la sierra"),
    ("es", "coge la pala y no enciendas la luz"),
    ("it", "prendi la pala, non la sega"),  # heard, it may be "no, la sega"
    ("it", "prendi la pala e non, la sega"),
    ("it", "prendi la pala e non accendere la luce"),
]


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> dict[str, IntentEngine]:
    folder = tmp_path_factory.mktemp("excluding")
    for language, (tools, take, light) in GRAMMARS.items():
        text = GRAMMAR.format(language=language[:2], tools=tools, take=take, light=light)
        Path(folder, f"{language}.yaml").write_text(text, encoding="utf-8")
    return {language: IntentEngine.from_files(folder / f"{language}.yaml") for language in GRAMMARS}


@pytest.mark.parametrize(("language", "said", "tool"), WANTED)
def test_the_other_is_not_meant(engines: dict[str, IntentEngine], language: str, said: str, tool: str) -> None:
    meaning = engines[language].parse(said)
    assert meaning.actions, meaning.reason
    assert (meaning.intent, dict(meaning.slots)) == ("take", {"tool": tool})


@pytest.mark.parametrize(("language", "said"), NOTHING)
def test_what_may_forbid_or_correct_does_nothing(engines: dict[str, IntentEngine], language: str, said: str) -> None:
    assert not engines[language].parse(said).actions
