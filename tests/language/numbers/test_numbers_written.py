"""Numbers as they are written: each language's custom is understood or refused, and never wrong by a thousand."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from meanings import done, german

from intent_engine.actions import Move
from intent_engine.engine import IntentEngine
from intent_engine.language.normalize import UNCLEAR, tokenize
from intent_engine.language.quantities import evaluate
from intent_engine.language.utterance import Utterance

LANGUAGES = ("en", "de", "fr", "es", "it")
GO = {"en": "go {} meters", "de": "geh {} Meter", "fr": "va {} mètres", "es": "ve {} metros", "it": "vai {} metri"}
CUSTOMS = {"en": (",", "."), "de": (".", ","), "fr": ("\u202f", ","), "es": (".", ","), "it": (".", ",")}
"""Language -> what divides thousands and decimals there."""

NONE = None
WRITTEN = {
    # As written -> the value in English, German, French, Spanish, Italian; None: it is refused.
    "1,500": (1500, 1.5, 1.5, NONE, 1.5),
    "1.500": (1.5, NONE, NONE, NONE, NONE),
    "90.000": (90, NONE, NONE, NONE, NONE),
    "12,345": (12345, 12.345, 12.345, NONE, 12.345),
    "-1.500": (-1.5, NONE, NONE, NONE, NONE),
    # These can only be one number.
    "1500": (1500,) * 5,
    "1.5": (1.5,) * 5,
    "1,5": (1.5,) * 5,
    "1,50": (1.5,) * 5,
    "1.50": (1.5,) * 5,
    "1,5000": (1.5,) * 5,
    "1.5000": (1.5,) * 5,
    "0,500": (0.5,) * 5,
    "0.500": (0.5,) * 5,
    "1500.250": (1500.25,) * 5,
    "1.500,25": (1500.25,) * 5,
    "1,500.25": (1500.25,) * 5,
    "1.500.000": (1_500_000,) * 5,
    "1,500,000": (1_500_000,) * 5,
    "1.500.000,5": (1_500_000.5,) * 5,
    "1,500,000.5": (1_500_000.5,) * 5,
    "1\u202f500": (1500,) * 5,
    "1\u00a0500,5": (1500.5,) * 5,
    # And these are none.
    "1.2.3": (NONE,) * 5,
    "1.500.2": (NONE,) * 5,
    "1 500": (NONE,) * 5,
    "1'500": (NONE,) * 5,
}
ROWS = [
    (written, language, value)
    for written, values in WRITTEN.items()
    for language, value in zip(LANGUAGES, values, strict=True)
]


def value_of(written: str, language: str) -> object:
    return evaluate([token.word for token in tokenize(written, language)], "number", language)


@pytest.mark.parametrize(("written", "language", "value"), ROWS)
def test_a_number_as_it_is_written(written: str, language: str, value: float | None) -> None:
    assert value_of(written, language) == (value if value is None else pytest.approx(value))


@pytest.fixture(scope="module")
def engines(tmp_path_factory) -> dict[str, IntentEngine]:
    found = {}
    for language, go in GO.items():
        path = tmp_path_factory.mktemp(language) / "g.yaml"
        verb, _, _ = go.split()
        path.write_text(
            f"language: {language}\nslots: {{distance: distance, thing: text}}\nintents:\n"
            f"  move: {{action: {{type: move, direction: forward}}, sentences: ['{verb} {{distance}}']}}\n"
            f"  take: {{action: {{type: pick, object: '{{thing}}'}}, sentences: ['take {{thing}}']}}\n"
        )
        found[language] = IntentEngine.from_files(path)
    return found


def grouped(value: float, places: int, language: str) -> str:
    thousands, decimal = CUSTOMS[language]
    return f"{value:,.{places}f}".replace(",", "\0").replace(".", decimal).replace("\0", thousands)


@settings(max_examples=150, deadline=None)
@given(st.sampled_from(LANGUAGES), st.floats(0.1, 1e6), st.integers(0, 6))
def test_a_number_written_by_the_custom_of_the_language_is_right_or_refused(engines, language, number, places) -> None:
    value = round(number, places)
    written = grouped(value, places, language)
    found = engines[language].parse(GO[language].format(written))
    if found.actions:
        (action,) = found.actions
        assert isinstance(action, Move)
        assert math.isclose(action.distance, value, rel_tol=1e-9, abs_tol=1e-9), written
    else:
        assert value_of(written, language) is None or value == 0


@settings(max_examples=150, deadline=None)
@given(st.sampled_from(LANGUAGES), st.sampled_from(LANGUAGES), st.floats(0.1, 1e6), st.integers(0, 6))
def test_the_custom_of_another_language_is_never_wrong_without_a_word_about_it(writer, reader, number, places) -> None:
    """English and a comma: "1,500" of a German is the one form that nobody can tell, and English has but one custom."""
    value = round(number, places)
    written = grouped(value, places, writer)
    found = value_of(written, reader)
    single = sum(not character.isdigit() for character in written) == 1
    if found is not None and not (single and "en" in (writer, reader) and ("," in written or "." in written)):
        assert math.isclose(found, value, rel_tol=1e-9, abs_tol=1e-9), written


def test_the_reason_says_what_to_write(engines) -> None:
    found = engines["de"].parse("geh 1.500 Meter")
    assert found.reason == "'1.500' could be 1500 or 1,5; write one of these, or say it in words"
    assert "'90,000' could be 90000 or 90;" in engines["es"].parse("ve 90,000 metros").reason
    assert not engines["de"].parse("take 1.500 Schrauben").actions


def test_a_stop_is_heard_beside_any_number() -> None:
    engine = german()
    for text in ("stopp 1.500", "1.500, stopp", "fahr 1.500 Meter stopp", "fahr 2.000 mm vorwärts stopp geh weiter"):
        assert done(engine.parse(text, state=("moving",))) == "stop", text
    assert done(engine.parse("fahr nicht 1.500 Meter vorwärts")) == "rejected"


def test_the_words_of_an_utterance_hold_no_sign_of_doubt() -> None:
    said = Utterance.of("geh 1.500 oder 2.500 Meter", "de")
    assert said.unclear == "1.500"
    assert said.words == ["geh", "1500", "oder", "2500", "meter"]
    assert [token.word for token in tokenize("1.500", "de")] == ["1.500" + UNCLEAR]
    assert Utterance.of("go 1.500 meters").unclear == ""
