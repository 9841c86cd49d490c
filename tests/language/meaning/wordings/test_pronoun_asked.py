"""What was named, in an order that asks for it: "puoi spegnerlo?" after "accendi il motore"."""

from __future__ import annotations

import pytest

GRAMMARS = {
    "es": """
language: es
slots: {cosa: [radio, compresor]}
intents:
  enciende: {action: custom, sentences: ["enciende (el|la) {cosa}"]}
  apaga: {action: custom, sentences: ["apaga (el|la) {cosa}"]}
""",
    "fr": """
language: fr
slots: {chose: [fer, lampe]}
intents:
  allume: {action: custom, sentences: ["allume (le|la) {chose}"]}
  eteins: {action: custom, sentences: ["éteins (le|la) {chose}"]}
""",
    "it": """
language: it
slots: {cosa: [motore, pompa]}
intents:
  accendi: {action: custom, sentences: ["accendi (il|la) {cosa}"]}
  spegni: {action: custom, sentences: ["spegni (il|la) {cosa}"]}
""",
}
BEFORE = {"es": "enciende el compresor", "fr": "allume le fer", "it": "accendi il motore"}
MEANT = {"es": "apaga el compresor", "fr": "éteins le fer", "it": "spegni il motore"}
SAID = [
    ("es", "¿puedes apagarlo?"),
    ("es", "ya puedes apagarlo"),
    ("es", "¿lo puedes apagar?"),
    ("es", "¿me lo apagas?"),
    ("es", "¿lo apagas, por favor?"),
    ("es", "¿podrías apagármelo?"),
    ("es", "quiero que lo apagues"),
    ("fr", "tu peux l'éteindre ?"),
    ("fr", "pourrais-tu me l'éteindre ?"),
    ("fr", "tu l'éteins, s'il te plaît ?"),
    ("fr", "vous l'éteignez, s'il vous plaît ?"),
    ("fr", "je voudrais que tu l'éteignes"),
    ("fr", "éteins-le quand même"),
    ("it", "puoi spegnerlo?"),
    ("it", "lo puoi spegnere?"),
    ("it", "me lo spegni?"),
    ("it", "potresti spegnermelo?"),
    ("it", "lo spegni, per favore?"),
    ("it", "ok, spegnilo pure"),
]
NOT_SAID = [
    ("es", "no lo puedes apagar"),
    ("es", "¿no lo apagas, por favor?"),
    ("es", "no quiero que lo apagues"),
    ("es", "¿lo apagas?"),
    ("es", "él puede apagarlo"),
    ("es", "¿quién puede apagarlo?"),
    ("es", "Paco me lo apaga"),
    ("es", "puedes apagarlo mañana"),
    ("fr", "tu ne peux pas l'éteindre"),
    ("fr", "tu l'éteins ?"),
    ("fr", "tu l'as éteint, s'il te plaît ?"),
    ("fr", "Marie peut l'éteindre"),
    ("fr", "je ne veux pas que tu l'éteignes"),
    ("fr", "pourquoi tu l'éteins, s'il te plaît"),
    ("it", "non puoi spegnerlo"),
    ("it", "lo spegni"),
    ("it", "lo spegne, per favore?"),
    ("it", "chi può spegnerlo?"),
    ("it", "puoi spegnerlo tra dieci minuti"),
]


@pytest.mark.parametrize(("language", "said"), SAID)
def test_it_is_what_was_named_before(engine_of, language: str, said: str) -> None:
    engine = engine_of(GRAMMARS[language])
    assert engine.parse(said, last=engine.parse(BEFORE[language])).actions == engine.parse(MEANT[language]).actions


@pytest.mark.parametrize(("language", "said"), NOT_SAID)
def test_what_asks_for_nothing_does_nothing(engine_of, language: str, said: str) -> None:
    engine = engine_of(GRAMMARS[language])
    assert not engine.parse(said, last=engine.parse(BEFORE[language])).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("es", "el compresor, ¿me lo apagas?"),
        ("es", "el compresor lo puedes apagar"),
        ("fr", "le fer, tu l'éteins, s'il te plaît"),
        ("fr", "le fer, tu peux l'éteindre ?"),
        ("it", "il motore, me lo spegni?"),
        ("it", "il motore puoi spegnerlo"),
    ],
)
def test_the_thing_may_be_said_first(engine_of, language: str, said: str) -> None:
    engine = engine_of(GRAMMARS[language])
    assert engine.parse(said).actions == engine.parse(MEANT[language]).actions


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("es", "el compresor, ¿lo apagas tú o yo, por favor?"),
        ("es", "el compresor no lo apagues, por favor"),
        ("fr", "le fer, si tu l'éteins, s'il te plaît"),
        ("it", "il motore lo ho spento, per favore"),
        ("it", "il motore lo spengo io"),
    ],
)
def test_what_is_told_of_it_does_nothing(engine_of, language: str, said: str) -> None:
    assert not engine_of(GRAMMARS[language]).parse(said).actions
