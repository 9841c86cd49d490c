"""What is added to a value is not the value: "set the fan to ten percent more"."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  share: percent
  height: distance
  length: duration
  heat: number
  rate: {type: number, units: {1: [dot, dots]}}
  count: {type: number, whole: true}
  note: {type: text, max_words: 8}
intents:
  level: {action: custom, sentences: ["set the fan to {share}", "raise the lift to {height}", "run at {rate}"]}
  warm: {action: custom, sentences: ["heat to {heat} degrees"]}
  last: {action: custom, sentences: ["(wait|run) for {length}", "raise the lift by {height}"]}
  bring: {action: custom, sentences: ["bring it to {count} (room|rooms)"]}
  press: {action: custom, sentences: ["raise the pressure to {heat} bar"]}
  write: {action: custom, sentences: ["write {note}"]}
"""
OTHERS = {
    "de": "setz den Lüfter auf {share}",
    "es": "pon el ventilador al {share}",
    "fr": "mets le ventilateur à {share}",
    "it": "metti la ventola al {share}",
}


@cache
def engine_of(language: str) -> IntentEngine:
    grammar = GRAMMAR
    if language != "en":
        sentence = OTHERS[language]
        grammar = f"""
language: {language}
slots: {{share: percent}}
intents: {{level: {{action: custom, sentences: ["{sentence}"]}}}}
"""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "level.yaml"
        file.write_text(grammar, "utf-8")
        return IntentEngine.from_files(file)


@pytest.mark.parametrize("spoken", [False, True])
@pytest.mark.parametrize(
    "text",
    [
        "set the fan to ten percent more",
        "set the fan to 10% more please",
        "set the fan to ten more percent",
        "set the fan to another ten percent",
        "raise the lift to two meters more",
        "raise the lift to two more meters",
        "run at two more dots",
        "heat to 5 more degrees",
        "raise the pressure to 3 more bar",
        "raise the pressure to another three bar",
        "heat to 50 degrees, then set the fan to 20 percent more",
        "write hello and then set the fan to 20 percent more",
    ],
)
def test_nobody_knows_what_it_comes_to(text: str, spoken: bool) -> None:
    assert not engine_of("en").parse(text, spoken=spoken).actions


@pytest.mark.parametrize(
    ("language", "more", "level"),
    [
        ("de", "setz den Lüfter auf 10 Prozent mehr", "setz den Lüfter auf 10 Prozent"),
        ("es", "pon el ventilador al 10 por ciento más", "pon el ventilador al 10 por ciento"),
        ("fr", "mets le ventilateur à 10 pour cent de plus", "mets le ventilateur à 10 pour cent"),
        ("it", "metti la ventola al 10 per cento in più", "metti la ventola al 10 per cento"),
    ],
)
def test_in_other_languages(language: str, more: str, level: str) -> None:
    assert not engine_of(language).parse(more).actions
    assert engine_of(language).parse(level).slots == {"share": 0.1}


@pytest.mark.parametrize(
    ("text", "slots"),
    [
        ("set the fan to ten percent", {"share": 0.1}),
        ("wait for two more minutes", {"length": 120}),
        ("run for two minutes more", {"length": 120}),
        ("raise the lift by two more meters", {"height": 2}),
        ("bring it to two more rooms", {"count": 2}),
        ("raise the pressure to 3 bar", {"heat": 3}),
        ("write turn it to ten percent more", {"note": "turn it to ten percent more"}),
    ],
)
def test_what_is_added_where_it_may_be(text: str, slots: dict[str, object]) -> None:
    found = engine_of("en").parse(text)
    assert found.actions, found.reason
    assert found.slots == slots
