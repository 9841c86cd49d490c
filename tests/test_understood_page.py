"""The tables of docs/understood.md: each sentence in quotes is understood, or refused, as its row says.

A table that begins with "a grammar has" makes a grammar of the templates in that column; every other one is about the
shipped grammar, or about the file that its section shows.
"""

from __future__ import annotations

import functools
import re

import pytest
from page_tables import quoted, rows

from intent_engine import IntentEngine

PAGE = "understood.md"
LANGUAGES = {"German": "de", "French": "fr", "Spanish": "es", "Italian": "it"}
SLOTS = """
  place: location
  thing: {type: text, max_words: 3}
  listed: {type: text, known: [cup, glass]}
  device: [lamp, fan, pump, lampe, lámpara, lampada]
  drink: [coffee, beer, tea, Kaffee, café, caffè]
  colour: [red, blue]
  room: [Flur, cocina]
  state: [an, aus]
  tool: [Hammer, Zange]
  way: [vor, zurück]
  side: [left, right]
  row: {type: number, min: 1, max: 40, whole: true}
  count: {type: number, min: 1, max: 40}
  weight: {type: number, min: 1, max: 1000}
  level: {type: percent, max: 100 %}
  distance: distance
  angle: angle
  time: duration
"""
PLACES = [
    "kitchen",
    "lab",
    "bar",
    "C1",
    "Küche",
    "Tor",
    "Müller",
    "entrée",
    "bar",
    "cuisine",
    "salón",
    "bar",
    "ingresso",
]


ROWS = [pytest.param(row, id=f"{PAGE}:{row.line}") for row in rows(PAGE)]


@pytest.mark.parametrize("row", [row for row in ROWS if "grammar has" in row.values[0].head[0]])
def test_what_a_sentence_is_understood_for(row, tmp_path):
    language = next((LANGUAGES[word] for word in row.head[0].split() if word in LANGUAGES), "en")
    said = [one.replace("'", "''") for one in re.findall(r"`([^`]+)`", row.cells[0])]
    sentences = "".join(f"\n      - '{one}'" for one in said)
    path = tmp_path / "row.yaml"
    path.write_text(
        f"language: {language}\nslots:{SLOTS}intents:\n  row:\n    action: custom\n    sentences:{sentences}\n", "utf-8"
    )
    engine = IntentEngine.from_files(path, locations=dict.fromkeys(PLACES, (0.0, 0.0, 0.0)))
    assert quoted(row.cells[1])
    for text in quoted(row.cells[1]):
        assert engine.parse(text).status == "accepted", (text, engine.parse(text).reason)
    for text in quoted(row.cells[2]):
        assert not engine.parse(text).actions, text


@pytest.fixture(scope="module")
def engine_of(tmp_path_factory):
    """Gives the engine of a file that the page shows, or the shipped one."""

    @functools.cache
    def made(file: str | None) -> IntentEngine:
        grammar = "en"
        if file:
            path = tmp_path_factory.mktemp("shown") / "shown.yaml"
            path.write_text(file, "utf-8")
            grammar = str(path)
        return IntentEngine.from_files(grammar, locations="home")

    return made


@pytest.mark.parametrize("row", [row for row in ROWS if row.values[0].head[-1] == "means"])
def test_what_a_text_means(row, engine_of):
    engine = engine_of(row.file)
    *before, said, means = row.cells
    last = engine.parse(quoted(before[0])[0]) if before else None
    assert quoted(said)
    for text in quoted(said):
        found = engine.parse(text, last=last)
        if means.startswith('"'):
            assert found.actions, (text, found.reason)
            assert found.actions == engine.parse(quoted(means)[0]).actions
        else:
            assert means.startswith(("nothing", "asked"))
            assert not found.actions, text
            assert not means.startswith("asked") or found.status == "ambiguous", (text, found.reason)
