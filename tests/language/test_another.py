"""Who asks for another wants one more: "another coffee" is "a coffee", where a sentence has the article."""

from __future__ import annotations

import pytest
from meanings import done

from intent_engine.engine import IntentEngine

GRAMMAR = """
slots:
  drink: [coffee, tea]
  size: [small, large]
  count: {type: number, whole: true, max: 6}
  title: {type: text, max_words: 2}
intents:
  order: {action: custom, sentences: ["[get me] [a|an|{count}] [{size}] {drink}"]}
  add: {action: custom, sentences: ["add a pinch", "add {count} pinches"]}
  play: {action: custom, sentences: ["play {title}"]}
"""
PLACES = """
slots: {place: location}
intents:
  go: {action: {type: navigate, location: "{place}"}, sentences: ["go to {place}"]}
  walk: {action: custom, sentences: ["go for a walk"]}
"""
ROWS = """
slots: {row: [A, B]}
intents: {pick: {action: custom, sentences: ["take row {row}", "take a row"]}}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("another coffee", {"drink": "coffee"}),
        ("please get me another large tea", {"drink": "tea", "size": "large"}),
        ("another two tea", {"count": 2, "drink": "tea"}),
        ("add another pinch", {}),
        ("add another", None),
        ("another", None),
    ],
)
def test_another_is_one_more(engine_of, said: str, slots: dict[str, object] | None) -> None:
    found = engine_of(GRAMMAR).parse(said)
    assert (dict(found.slots) if found.actions else None) == slots


@pytest.mark.parametrize("said", ["take row another", "take row another please"])
def test_another_is_no_letter(engine_of, said: str) -> None:
    assert done(engine_of(ROWS).parse(said)) == "rejected"


def test_another_is_no_place(tmp_path) -> None:
    file = tmp_path / "grammar.yaml"
    file.write_text(PLACES, encoding="utf-8")
    engine = IntentEngine.from_files(file, locations={"a": (0.0, 0.0, 0.0), "dock a": (1.0, 0.0, 0.0)})
    assert not engine.parse("go to another").actions
    assert not engine.parse("go to dock another").actions
    assert not engine.parse("go to another dock").actions
