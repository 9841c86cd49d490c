"""Another speed that is said twice in one breath, be it as a reason: "you're going too fast, slow down"."""

from __future__ import annotations

import pytest

SPEEDS = """
language: {language}
slots: {{factor: {{type: number}}}}
intents:
  slower:
    action: change_speed
    defaults: {{factor: 0.5}}
    sentences: ["{slower}", {{say: "{slower} {bit}", slots: {{factor: 0.75}}}}, "{reason}"]
  faster: {{action: change_speed, defaults: {{factor: 1.5}}, sentences: ["{faster}"]}}
"""
WORDS = {
    "en": ("slow down", "a bit", "you are too fast", "speed up"),
    "de": ("fahr langsamer", "als jetzt", "du bist zu schnell", "fahr schneller"),
    "fr": ("ralentis", "un peu", "tu vas trop vite", "accélère"),
    "es": ("reduce", "un poco", "vas muy deprisa", "acelera"),
    "it": ("rallenta", "un poco", "vai troppo forte", "accelera"),
}


@pytest.mark.parametrize("language", WORDS)
def test_it_is_one(engine_of, language: str) -> None:
    slower, bit, reason, faster = WORDS[language]
    engine = engine_of(SPEEDS.format(language=language, slower=slower, bit=bit, reason=reason, faster=faster))

    def factors(text: str) -> list[float]:
        return [action.factor for action in engine.parse(text).actions]

    assert factors(f"{reason}, {slower}") == factors(f"{slower}, {reason}") == [0.5]
    assert factors(f"{reason}, {slower} {bit}") == factors(f"{slower} {bit}, {reason}") == [0.75]
    assert factors(f"{slower}, {slower}, {slower}") == [0.5]
    assert factors(f"{slower}, {faster}") == [0.5, 1.5]
    no = {"en": "no", "de": "nein", "fr": "non", "es": "no", "it": "no"}[language]
    assert factors(f"{slower}, {slower}, {no}, {faster}") == [1.5], "both are taken back"
    assert factors(f"{slower}, {faster}, {no}, {slower}") == [0.5]
    joint = {"en": "and then", "de": "und dann", "fr": "et puis", "es": "y luego", "it": "e poi"}[language]
    assert factors(f"{slower} {joint} {slower}") == [0.5, 0.5]
