"""A letter by itself: a name, as of a row, or a sound said twice: "t turn left"."""

from __future__ import annotations

from pathlib import Path

import pytest

from intent_engine.engine import IntentEngine, PrefixStatus

GRAMMAR = """
language: en
slots:
  tote: {type: number, min: 1, max: 40, whole: true}
  rack: [A, B, C, D, E, F]
  bay: {type: number, min: 1, max: 20, whole: true}
  thing: {type: text, max_words: 4}
intents:
  fetch: {action: custom, sentences: ["fetch tote {tote} from rack {rack} [bay] {bay}"]}
  take: {action: custom, sentences: ["(fetch|take) {thing} [from {thing:source}]"]}
"""


def made(folder: Path, grammar: str) -> IntentEngine:
    file = folder / "rows.yaml"
    file.write_text(grammar, "utf-8")
    return IntentEngine.from_files(file)


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    return made(tmp_path_factory.mktemp("letters"), GRAMMAR)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        # Free words would take "rack bay 3".
        ("fetch tote 12 from rack B bay 3", {"tote": 12, "rack": "B", "bay": 3}),
        ("fetch tote 12 from rack a bay 3, no, rack b bay 4", {"tote": 12, "rack": "B", "bay": 4}),
        ("fetch tote 12 from rack f five", {"tote": 12, "rack": "F", "bay": 5}),
        ("fetch tote twelve from rack e eight", {"tote": 12, "rack": "E", "bay": 8}),
        ("take the c clamp", {"thing": "c clamp"}),
        # Sounds.
        ("f fetch tote f five from rack b t two", {"tote": 5, "rack": "B", "bay": 2}),
        ("take t the clamp", {"thing": "clamp"}),
    ],
)
def test_a_letter_is_a_word_where_a_sentence_has_it(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert engine.parse(said).slots == slots


def test_a_number_beyond_its_limits_behind_a_letter_is_told(engine: IntentEngine) -> None:
    found = engine.parse("fetch tote 12 from rack b bay 99")
    assert found.beyond_limits
    assert not found.actions


@pytest.mark.parametrize("said", ["s stop", "take the cup s stop", "take the cup s stop now"])
def test_a_stop_behind_its_first_sound_is_one(engine: IntentEngine, said: str) -> None:
    assert engine.parse(said).stops


def test_what_follows_a_letter_is_looked_ahead_to(tmp_path: Path) -> None:
    rows = made(tmp_path, GRAMMAR.partition("  take:")[0])
    assert rows.prefix("fetch tote 12 from rack b bay 3").status is not PrefixStatus.IMPOSSIBLE
    assert rows.prefix("f fetch tote 12 from rack b").status is PrefixStatus.INCOMPLETE
