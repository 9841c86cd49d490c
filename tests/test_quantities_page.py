"""The tables of docs/quantities.md: each text is the value that its row says, or refused, where a slot takes it."""

from __future__ import annotations

import functools
import json
import re

import pytest
from page_tables import quoted, rows

from intent_engine import IntentEngine
from intent_engine.language.normalize import tokenize
from intent_engine.language.quantities import evaluate

PAGE = "quantities.md"
LANGUAGES = {"English": "en", "German": "de", "French": "fr", "Spanish": "es", "Italian": "it"}
USUAL = {"speed": "1 m/s", "angular_speed": "1 rad/s"}
ROWS = [pytest.param(row, id=f"{PAGE}:{row.line}") for row in rows(PAGE)]


def test_no_table_of_what_is_said_is_left_out():
    tried = {row.values[0].section for row in (*QUANTITIES, *SENTENCES, *FIGURES)}
    assert {row.values[0].section for row in ROWS} - tried == {"Quantities", "Types"}


@pytest.fixture(scope="module")
def engine_of(tmp_path_factory):
    """Gives the engine of one sentence with one slot, x."""

    @functools.cache
    def made(sentence: str, slot: str, language: str) -> IntentEngine:
        path = tmp_path_factory.mktemp("row") / "row.yaml"
        kind = str(re.sub(r".*type: (\w+).*", r"\1", slot))
        usual = f"    defaults: {{x: {USUAL[kind]}}}\n" if kind in USUAL else ""
        path.write_text(
            f"language: {language}\nslots:\n  x: {slot}\n"
            f"intents:\n  row:\n    action: custom\n{usual}    sentences: [{json.dumps(sentence)}]\n",
            "utf-8",
        )
        return IntentEngine.from_files(path)

    return made


def _value(cell: str, kind: str) -> float:
    """``0.5 of the usual speed`` is half of what the intent has for a usual speed, 1."""
    if kind in ("percent", "number", "ordinal") or "usual" in cell:
        return float(cell.split()[0])
    value = evaluate([token.word for token in tokenize(cell)], kind)
    assert isinstance(value, float)
    return value


def _is(engine: IntentEngine, text: str, cell: str, kind: str) -> None:
    found = engine.parse(text)
    if cell in ("refused", "asked"):
        assert not found.actions, (text, found.slots)
        assert bool(found.alternatives) or cell == "refused"
    else:
        assert found.actions, (text, found.reason)
        assert found.slots["x"] == pytest.approx(_value(cell, kind)), text


QUANTITIES = [row for row in ROWS if "said or written" in row.values[0].head]


@pytest.mark.parametrize("row", QUANTITIES)
def test_what_a_quantity_is(row, engine_of):
    cells = dict(zip(row.head, row.cells, strict=True))
    kind = cells.get("type", row.section.lower().replace(" ", "_")).strip("`")
    language = LANGUAGES[cells.get("language", "English")]
    texts = quoted(cells["said or written"])
    assert texts
    for text in texts:
        engine = engine_of("take {x}", f"{{type: {kind}}}", language)
        _is(engine, f"take {text}", cells.get("is", "refused"), kind)


SENTENCES = [row for row in ROWS if row.values[0].head[0] == "a sentence"]


@pytest.mark.parametrize("row", SENTENCES)
def test_what_a_sentence_gives(row, engine_of):
    sentence, slot, said, value = row.cells
    assert quoted(said)
    for text in quoted(said):
        kind = re.sub(r".*type: (\w+).*", r"\1", slot.strip("`"))
        _is(engine_of(sentence.strip("`"), slot.strip("`"), "en"), text, value, kind)


FIGURES = [row for row in ROWS if row.values[0].head[0] == "written"]


@pytest.mark.parametrize("row", FIGURES)
def test_what_a_figure_is(row, engine_of):
    for head, cell in zip(row.head[1:], row.cells[1:], strict=True):
        for language in re.findall(r"\w+", head):
            value = cell.partition(":")[0]
            _is(
                engine_of("take {x}", "{type: number}", LANGUAGES[language]),
                f"take {row.cells[0][1:-1]}",
                value,
                "number",
            )
