"""A number beyond its limits that is corrected, or corrects: it was said for its slot all the same."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine

GRAMMAR = """
language: en
slots:
  drawer: {type: number, min: 1, max: 8, whole: true}
  shelf: {type: number, min: 1, max: 40, whole: true}
  rpm: {type: number, min: 100, max: 3000}
  time: {type: duration, max: 1 h}
  thing: {type: text, max_words: 3}
intents:
  open: {action: custom, sentences: ["open drawer {drawer} [of shelf {shelf}]"]}
  shelf: {action: custom, sentences: ["clear shelf {shelf} drawer {drawer}"]}
  any: {action: custom, sentences: ["open {thing}"]}
  spin: {action: custom, sentences: ["spin at {rpm} rpm [for {time}]"]}
  load: {action: custom, regex: "load drawer (?P<drawer>\\\\d+)"}
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> IntentEngine:
    file = tmp_path_factory.mktemp("limits") / "lab.yaml"
    file.write_text(GRAMMAR, "utf-8")
    return IntentEngine.from_files(file)


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("open drawer 12, no, 3", {"drawer": 3}),
        ("open drawer 12, no, drawer 3", {"drawer": 3}),
        ("open drawer 12, no, 14, no, 3", {"drawer": 3}),
        ("open drawer 3, no, 12, no, 4", {"drawer": 4}),
        ("open drawer 12 of shelf 3, no, drawer 4", {"drawer": 4, "shelf": 3}),
        ("spin at 500 rpm for two hours, no, for a minute", {"rpm": 500, "time": 60}),
        ("load drawer 9, no, 3", {"drawer": 3}),
        ("open drawer 3 of shelf 4, no, 12", {"drawer": 3, "shelf": 12}),
    ],
)
def test_a_number_beyond_its_limits_is_corrected(engine: IntentEngine, said: str, slots: dict[str, object]) -> None:
    assert engine.parse(said).slots == slots


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        ("open drawer 3, no, 12", "drawer of 12 is more than the largest, 8"),
        ("open drawer 3, no, 2.5", "drawer of 2.5 is no whole number"),
        ("spin at five hundred, no, five thousand rpm", "rpm of 5000 is more than the largest, 3000"),
        ("spin at 5000 rpm for two hours, no, for a minute", "rpm of 5000 is more than the largest, 3000"),
        ("load drawer 3, no, 9", "drawer of 9 is more than the largest, 8"),
        # The drawer may be meant as well as the shelf, though no drawer has that number.
        (
            "clear shelf 4 drawer 3, no, 12",
            "it is not clear what '12' takes the place of; say the whole command again",
        ),
    ],
)
def test_a_correction_beyond_the_limits_is_told(engine: IntentEngine, said: str, reason: str) -> None:
    found = engine.parse(said)
    assert not found.actions
    assert found.reason == reason
