"""Ordinals of other languages: "dritte", "vingt et unième"."""

from __future__ import annotations

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Status
from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers import foreign_ordinals
from intent_engine.language.quantities import evaluate

SAID = {
    "de": {"erste": 1, "dritten": 3, "zwölfte": 12, "einundzwanzigste": 21, "hundertste": 100, "letzte": -1, "3.": 3},
    "fr": {"première": 1, "seconde": 2, "troisième": 3, "vingt et unième": 21, "dernier": -1, "3ème": 3, "1er": 1},
    "es": {"primer": 1, "segundo": 2, "tercera": 3, "décimo": 10, "vigésima primera": 21, "última": -1},
    "it": {"primo": 1, "seconda": 2, "terza": 3, "undicesimo": 11, "ventunesimo": 21, "ultima": -1},
}
SENTENCES = {"de": "nimm die {} reihe", "fr": "prends la {} porte", "es": "abre la {} puerta", "it": "apri la {} porta"}


@pytest.fixture(scope="module")
def engines(tmp_path_factory) -> dict[str, IntentEngine]:
    folder = tmp_path_factory.mktemp("ordinals")
    found = {}
    for language, sentence in SENTENCES.items():
        path = folder / f"{language}.yaml"
        path.write_text(
            f"language: {language}\nslots: {{nth: {{type: ordinal, max: 30}}, far: distance}}\n"
            f"intents: {{a: {{action: custom, sentences: ['{sentence.format('{nth}')}', 'x {{far}}']}}}}\n",
            "utf-8",
        )
        found[language] = IntentEngine.from_files(path)
    return found


@pytest.mark.parametrize(("language", "said"), [(language, said) for language, rows in SAID.items() for said in rows])
def test_what_is_said_and_what_a_grammar_hears(engines, language, said):
    value = SAID[language][said]
    assert evaluate([token.word for token in tokenize(said, language)], "ordinal", language) == value
    found = engines[language].parse(SENTENCES[language].format(said))
    if value <= 30:
        assert (found.status, dict(found.slots)) == (Status.ACCEPTED, {"nth": float(value)})
    else:
        assert found.beyond_limits


@pytest.mark.parametrize("language", list(SAID))
def test_what_is_no_ordinal(language):
    for said in ("", "tasse", "la", "prima vera", "ieme"):
        assert evaluate(said.split(), "ordinal", language) is None


def test_a_grammar_without_ordinals_knows_none(tmp_path):
    path = tmp_path / "es.yaml"
    path.write_text(
        "language: es\nslots: {n: number}\nintents: {a: {action: custom, sentences: ['sala {n}', 'sala segunda']}}\n"
    )
    engine = IntentEngine.from_files(path)
    assert engine.parse("sala segunda").slots == {}
    assert engine.parse("sala tercera").actions == ()


@pytest.mark.parametrize(
    ("said", "language", "value"),
    [
        ("der dritte", "de", 3),
        ("numéro trois", "fr", 3),
        ("3 ème", "fr", 3),
        ("drei", "de", 3),
        ("zwei komma fünf", "de", None),
        ("minus drei", "de", None),
        ("halle", "de", None),
        ("", "de", None),
        ("third", "en", None),
    ],
)
def test_an_ordinal_may_have_an_article_a_number_word_or_figures(said, language, value):
    assert foreign_ordinals.ordinal(tuple(said.split()), language) == value


@pytest.mark.parametrize(("word", "is_one"), [("dritte", True), ("letzte", True), ("drei", True), ("halle", False)])
def test_words_of_ordinals_are_known_and_numbers_are_some(word, is_one):
    assert foreign_ordinals.is_ordinal_word(word, "de") is is_one
