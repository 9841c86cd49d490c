"""German orders in the infinitive, "den Ball aufheben", where a grammar has "kannst du den Ball aufheben"."""

from __future__ import annotations

import pytest
from meanings import german


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("den Ball aufheben", {"thing": "ball"}),
        ("Bitte den Ball aufheben!", {"thing": "ball"}),
        ("den Ball vom Boden aufheben", {"thing": "ball", "source": "boden"}),
        ("die Tasse abstellen", {"thing": "tasse"}),
        ("das Buch hinlegen", {"thing": "buch"}),
    ],
)
def test_it_is_an_order(said: str, slots: dict[str, str]) -> None:
    assert german().parse(said).slots == slots


@pytest.mark.parametrize(
    "said",
    [
        "den Ball aufheben?",
        "nicht den Ball aufheben",
        "den Ball nicht aufheben",
        "der Ball aufheben",
        "die Kinder den Ball aufheben",
        "ich werde den Ball aufheben",
        "wir wollen den Ball aufheben",
        "den Ball sollte man aufheben",
        "die Leute sollen den Ball aufheben",
        "wenn die Kinder den Ball aufheben",
        "den Ball morgen aufheben",
        "den Ball aufheben oder die Tasse abstellen",
        "das Licht abstellen",
        "die Leute nehmen",
        "die Kinder heben den Ball auf",
    ],
)
def test_what_asks_denies_or_tells_of_others_is_none(said: str) -> None:
    assert not german().parse(said).actions


DOORS = """
language: de
slots: {door: [Hintertür, Haustür]}
intents:
  open: {action: custom, sentences: ["die {door} öffnen", "öffne die {door}"]}
  halt: {action: stop, sentences: ["zum Stehen kommen"]}
"""


@pytest.mark.parametrize("said", ["Die Hintertür öffnen?", "die Haustür öffnen ?"])
def test_one_of_the_grammar_asks_whether_where_a_question_mark_ends_it(engine_of, said: str) -> None:
    assert not engine_of(DOORS).parse(said).actions


@pytest.mark.parametrize(
    "said",
    ["die Hintertür öffnen", "Die Hintertür öffnen!", "öffne die Hintertür?", "kannst du die Hintertür öffnen?",
     "bitte die Hintertür öffnen?", "zum Stehen kommen?"],
)  # fmt: skip
def test_what_tells_asks_for_it_or_stops_is_done(engine_of, said: str) -> None:
    assert engine_of(DOORS).parse(said).actions
