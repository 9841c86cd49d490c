"""A verb that is said once of things with which different things are done."""

from __future__ import annotations

import pytest

GRAMMAR = """
language: de
slots:
  lampe: [Deckenlicht, Nachtlicht]
  an: boolean
  anteil: percent
  bild: [Bühne, Gast]
  ding: text
intents:
  jalousie: {action: custom, sentences: ["mach die Jalousie (auf|zu)"]}
  lampe: {action: custom, sentences: ["mach das {lampe} {an}"]}
  zoom: {action: custom, sentences: ["stell den Zoom auf {anteil}"]}
  fokus: {action: custom, sentences: ["stell (die|den) {bild} scharf"]}
  holen: {action: custom, sentences: ["hol {ding}"]}
  bringen: {action: custom, sentences: ["hol die Tasse aus (der Küche|dem Bad)"]}
"""


@pytest.mark.parametrize(
    ("said", "intents"),
    [
        ("mach die Jalousie auf und das Deckenlicht aus", ["jalousie", "lampe"]),
        ("mach das Nachtlicht an und die Jalousie zu", ["lampe", "jalousie"]),
        ("mach bitte die Jalousie zu und dann das Deckenlicht an", ["jalousie", "lampe"]),
        ("machen Sie die Jalousie auf und das Deckenlicht aus", ["jalousie", "lampe"]),
        ("stell den Zoom auf 40 Prozent und die Bühne scharf", ["zoom", "fokus"]),
        ("mach das Deckenlicht aus und das Nachtlicht an", ["lampe", "lampe"]),
    ],
)
def test_each_is_done(engine_of, said: str, intents: list[str]) -> None:
    assert [action.name for action in engine_of(GRAMMAR).parse(said).actions] == intents


@pytest.mark.parametrize(
    "said",
    [
        "mach die Jalousie auf und das Deckenlicht ist aus",
        "mach die Jalousie auf und das Deckenlicht",
        "mach die Jalousie auf und nicht das Deckenlicht aus",
        "mach die Jalousie auf und das Deckenlicht nicht aus",
        "mach die Jalousie auf oder das Deckenlicht aus",
        "mach die Jalousie auf und das Deckenlicht geht aus",
        "ich mach die Jalousie auf und das Deckenlicht aus",
        "hol die Tasse aus der Küche und den Teller",
    ],
)
def test_what_tells_or_denies_does_nothing(engine_of, said: str) -> None:
    assert not engine_of(GRAMMAR).parse(said).actions


PRINTER = """
language: en
slots:
  heat: {type: number, max: 300}
  bed: {type: number, max: 120}
  printer: {type: number, max: 9, whole: true}
  level: percent
intents:
  heat:
    action: custom
    sentences:
      - "heat the nozzle [of printer {printer}] to {heat} degrees"
      - "heat the bed [of printer {printer}] to {bed} degrees"
  lid: {action: custom, sentences: ["open the lid [to {level}]"]}
  door: {action: custom, sentences: ["open the door"]}
"""


@pytest.mark.parametrize(
    ("said", "slots"),
    [
        ("heat the nozzle to 210 degrees and the bed to 60 degrees", [{"heat": 210.0}, {"bed": 60.0}]),
        ("heat the nozzle to 210 degrees, and the bed to 60 degrees", [{"heat": 210.0}, {"bed": 60.0}]),
        ("open the lid and the door", [{}, {}]),
        ("open the lid to half and the door", [{"level": 0.5}, {}]),
    ],
)
def test_where_nouns_have_no_cases(engine_of, said: str, slots: list[dict[str, object]]) -> None:
    assert [dict(action.slots) for action in engine_of(PRINTER).parse(said).actions] == slots


@pytest.mark.parametrize(
    "said",
    [
        "heat the nozzle of printer 3 to 210 degrees and the bed to 60 degrees",  # of printer 3 as well?
        "open the lid and the door is open", "open the lid or the door", "don't open the lid and the door",
        "open the lid and the window", "he opens the lid and the door",
    ],
)  # fmt: skip
def test_where_nouns_have_no_cases_and_it_is_not_clear(engine_of, said: str) -> None:
    assert not engine_of(PRINTER).parse(said).actions


BOTH = {
    "de": """
language: de
slots: {ding: [Hefte, Plakate], zeit: duration, n: {type: number, whole: true}}
intents:
  falzen: {action: custom, sentences: ["falze die {ding} [{zeit} lang]"]}
  binden: {action: custom, sentences: ["binde (die|{n}) {ding} [{zeit} lang]"]}
  schneiden: {action: custom, sentences: ["schneide {n} {ding}"]}
  anmachen: {action: custom, sentences: ["leg die {ding} ein"]}
""",
    "fr": """
language: fr
slots: {tissu: [laine, soie]}
intents:
  laver: {action: custom, sentences: ["lave la {tissu}"]}
  repasser: {action: custom, sentences: ["repasse la {tissu}"]}
  ouvrir: {action: custom, sentences: ["ouvre la {tissu}"]}
  fermer: {action: custom, sentences: ["ferme la {tissu}"]}
""",
}


@pytest.mark.parametrize(
    ("language", "said", "meant"),
    [
        ("de", "falze und binde die Hefte", "falze die Hefte und binde die Hefte"),
        ("de", "leg die Hefte ein und die Plakate auch", "leg die Hefte ein und leg die Plakate ein"),
    ],
)
def test_verb_or_thing_is_said_once(engine_of, language: str, said: str, meant: str) -> None:
    engine = engine_of(BOTH[language])
    assert len(engine.parse(said).actions) == 2
    assert engine.parse(said).actions == engine.parse(meant).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("de", "falze oder binde die Hefte"),
        ("de", "falze und binde nicht die Hefte"),
        ("de", "leg die Hefte ein und die Plakate"),
        ("de", "leg die Hefte ein und die Plakate auch nicht"),
        ("fr", "lave et ne repasse pas la laine"),
    ],
)
def test_where_it_is_not_clear_of_which_nothing_is_done(engine_of, language: str, said: str) -> None:
    assert not engine_of(BOTH[language]).parse(said).actions
