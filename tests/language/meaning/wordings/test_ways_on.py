"""Words that say no more of a way than where it goes: "bring the tray over to the lab"."""

from __future__ import annotations

import pytest
from meanings import assert_same

GRAMMARS = {
    "en": """
language: en
slots: {item: [tray, test tubes], place: [lab, hall], level: percent}
intents:
  bring: {action: custom, sentences: ["bring [the] {item} to [the] {place}"]}
  go: {action: custom, sentences: ["go to [the] {place}"]}
  turn: {action: custom, sentences: ["turn [the] volume to {level}"]}
""",
    "de": """
language: de
slots: {ding: [Zange, Kiste], ort: [Labor, Halle]}
intents:
  bring: {action: custom, sentences: ["bring die {ding} (ins|in die) {ort}"]}
  geh: {action: custom, sentences: ["geh (ins|in die) {ort}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("en", "bring the tray over to the lab", "bring the tray to the lab"),
        ("en", "go back down to the hall", "go to the hall"),
        (
            "en",
            "go over to the lab and bring the tray back to the hall",
            "go to the lab and bring the tray to the hall",
        ),
        ("en", "bring these test tubes to the lab", "bring the test tubes to the lab"),
        ("de", "bring die Zange rüber ins Labor", "bring die Zange ins Labor"),
        ("de", "geh hoch in die Halle", "geh in die Halle"),
    ],
)
def test_it_is_the_way(engine_of, language: str, said: str, meant: str) -> None:
    assert_same(engine_of(GRAMMARS[language]), said, meant)


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "bring the tray over, to the lab"),
        ("en", "bring the tray over the lab"),
        ("en", "don't bring the tray over to the lab"),
        ("de", "bring die Zange rüber"),
        ("de", "er bringt die Zange rüber ins Labor"),
    ],
)
def test_what_says_more_is_none(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions


@pytest.mark.parametrize(
    ("language", "sentence", "said", "count"),
    [
        ("fr", "enfourne {n} pains", "enfourne une douzaine de pains", 12),
        ("fr", "enfourne {n} pains", "enfourne deux douzaines de pains", 24),
        ("es", "lleva {n} cajas", "lleva una docena de cajas", 12),
        ("it", "porta {n} casse", "porta una dozzina di casse", 12),
    ],
)
def test_dozens_are_counted_with_of(engine_of, language: str, sentence: str, said: str, count: int) -> None:
    engine = engine_of(f"""
language: {language}
slots: {{n: {{type: number, whole: true}}}}
intents: {{load: {{action: custom, sentences: ["{sentence}"]}}}}
""")
    (action,) = engine.parse(said).actions
    assert action.slots == {"n": count}
