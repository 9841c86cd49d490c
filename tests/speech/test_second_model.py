"""Which model is the first, and which the second."""

from __future__ import annotations

import platform
import sys

import pytest

from intent_engine.engine import IntentEngine
from intent_engine.errors import WeightsError
from intent_engine.speech.acoustic.moonshine_weights import MOONSHINE
from intent_engine.speech.models import NONE, recognizer_for, second_model, usual_model
from intent_engine.speech.steered import SteeredWhisper

MOONSHINE_CAN_BE_HAD = (sys.platform, platform.machine()) == ("linux", "x86_64")


@pytest.mark.parametrize(
    ("languages", "language", "found"),
    [
        (("en",), None, "tiny.en"),
        (("en", "de"), "en", "tiny.en"),
        (("de",), None, "base"),
        (("en", "de"), None, "base"),
        (("en",), "fr", "base"),
    ],
)
def test_the_first_model_knows_the_language(languages, language, found):
    assert usual_model(languages, language) == found


def test_a_german_grammar_is_heard_in_german(root):
    engine = IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")
    recognizer = recognizer_for(engine)
    assert (recognizer.weights.name, recognizer.language) == ("base", "de")
    recognizer.close()


@pytest.mark.parametrize(
    ("model", "second", "language", "found"),
    [
        ("tiny.en", None, None, MOONSHINE),
        ("tiny", None, "en", MOONSHINE),
        ("tiny", None, "de", "base"),
        ("tiny.en", NONE, None, None),
        ("base", None, None, None),
        ("base", "tiny.en", None, "tiny.en"),
        ("base", MOONSHINE, None, MOONSHINE),
    ],
)
def test_the_second_model(engine, model, second, language, found):
    if found == MOONSHINE and not MOONSHINE_CAN_BE_HAD:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    assert second_model(engine, model, second, language=language) == found


def test_where_moonshine_is_not_installed_the_second_is_base(engine, monkeypatch):
    monkeypatch.setattr("intent_engine.speech.models.moonshine_package", lambda: None)
    assert second_model(engine, "tiny.en") == "base"


def test_a_second_model_that_was_named_must_be_there(engine):
    with pytest.raises(WeightsError):
        second_model(engine, "tiny.en", "/nowhere/at/all")


def test_without_a_second_the_first_is_all_there_is(engine):
    recognizer = recognizer_for(engine, second=NONE)
    assert isinstance(recognizer, SteeredWhisper)
    recognizer.close()


@pytest.mark.parametrize(("name", "near"), [("None", "'none'"), ("off", None), ("nope", "'none'"), ("bsae", "'base'")])
def test_a_second_model_that_is_none(engine, name, near):
    with pytest.raises(WeightsError) as caught:
        second_model(engine, "tiny.en", name)
    first, *rest = str(caught.value).splitlines()
    assert first == f"no model is called {name!r}"
    assert rest[-1].startswith("    --second-model knows tiny, ")
    assert ", none, or the path" in rest[-1]
    assert near is None or rest[0] == f"    did you mean {near}?"


def test_a_second_model_that_nobody_named_is_left_out_where_it_cannot_be_made_ready(engine, tmp_path, monkeypatch):
    if not MOONSHINE_CAN_BE_HAD:
        pytest.skip("Moonshine's package is for Linux on x86-64")
    (tmp_path / "cache").write_text("a file")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    told: list[str] = []
    recognizer = recognizer_for(engine, tell=told.append)
    assert isinstance(recognizer, SteeredWhisper)
    recognizer.close()
    assert told[-1].startswith("no second model: ")
    with pytest.raises(WeightsError):
        recognizer_for(engine, second=MOONSHINE)
