"""German, heard by the model that knows it, from a synthetic voice."""

from __future__ import annotations

import numpy as np
import pytest
from meanings import german

from intent_engine.engine import IntentEngine
from intent_engine.speech.audio import Samples
from intent_engine.speech.models import recognizer_for

voices = pytest.importorskip("py_nanotts", reason="the voice's package has no wheel for this system")


def said(text: str) -> Samples:
    """By SVOX Pico's German voice, at 16 kHz, with quiet around it."""
    sound = np.frombuffer(voices.NanoTTS().speak(text, "de-DE"), np.int16).astype(np.float32)
    return np.concatenate([np.zeros(4800, np.float32), 0.3 * sound / np.abs(sound).max(), np.zeros(4800, np.float32)])


@pytest.fixture(scope="module")
def engine() -> IntentEngine:
    return german()


@pytest.fixture(scope="module")
def hears(engine):
    recognizer = recognizer_for(engine)
    yield lambda text: recognizer.transcribe(said(text))
    recognizer.close()


@pytest.mark.parametrize(
    "text",
    [
        "geh einen halben Meter zurück",
        "fahr fünf Meter geradeaus",
        "dreh dich um fünfundvierzig Grad nach rechts",
        "dreh dich zwei Sekunden lang nach rechts",
        "fahr mit einem halben Meter pro Sekunde vorwärts",
        "nicht weiter",
        "folge mir",
    ],
)
def test_a_command_is_heard(engine, hears, text):
    heard = hears(text)
    assert engine.parse(heard.text).actions == engine.parse(text).actions != ()
    assert not heard.unclear
    assert heard.sureness >= 0.7


@pytest.mark.parametrize("text", ["fahr nicht in die Küche", "dreh dich nicht um", "er hat den Ball genommen"])
def test_what_is_no_command_is_none(engine, hears, text):
    heard = hears(text)
    acted_on = engine.parse(heard.text).actions and heard.sureness >= 0.7 and not (heard.unclear or heard.left_out)
    assert not acted_on


# -- German or English ------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def either(root):
    """A recogniser of both grammars."""
    grammars, maps = ("en", "de"), ("home", "zuhause")
    engine = IntentEngine.from_files(
        [root / f"grammars/{one}.yaml" for one in grammars], locations=[root / f"locations/{one}.yaml" for one in maps]
    )
    recognizer = recognizer_for(engine)
    yield engine, recognizer
    recognizer.close()


@pytest.mark.parametrize("text", ["fahr fünf Meter geradeaus", "dreh dich nach rechts", "folge mir", "komm her"])
def test_german_is_told_from_english(either, text):
    engine, recognizer = either
    heard = recognizer.transcribe(said(text))
    assert engine.parse(heard.text, language=heard.language).actions == engine.parse(text, language="de").actions


def test_english_is_told_from_german(either, spoken):
    engine, recognizer = either
    heard = recognizer.transcribe(spoken)
    assert heard.language == "en"
    assert engine.parse(heard.text, language="en").actions == engine.parse("go forward two meters").actions


def test_a_language_without_a_grammar_is_not_heard(either, spoken):
    """Of a short command a model thinks of Norwegian, too."""
    _, recognizer = either
    encoded = recognizer.encode(said("komm her"))
    assert len(recognizer.detect(encoded)) > 50
    assert set(recognizer.detect(encoded, ("de", "en"))) == {"de", "en"}
    assert set(recognizer.detect(encoded, ("de",))) == {"de"}
    assert len(recognizer.detect(encoded, ("tlh",))) > 50  # no language that it knows


@pytest.mark.parametrize(
    ("behind", "written", "language"),
    [
        (5.0, {"en": ("Come hear", -0.1), "de": ("Komm her", -0.1)}, "en"),
        (1.0, {"en": ("Calm hair", -0.1), "de": ("Komm her", -0.9)}, "de"),
        (1.0, {"en": ("Calm hair", -0.9), "de": ("Kommher ja", -0.1)}, "de"),
        (1.0, {"en": ("Come here", -0.5), "de": ("Komm her", -0.5)}, "en"),
        (1.0, {"en": ("Come here", -0.9), "de": ("Komm nicht her", -0.1)}, "de"),
    ],
    ids=["not near", "a command in one", "clearer in one", "the likelier", "what shall not be done"],
)
def test_where_it_may_be_either(either, monkeypatch, behind, written, language):
    _, recognizer = either
    monkeypatch.setattr(recognizer, "detect", lambda *_: {"en": -0.1, "de": -0.1 - behind})
    monkeypatch.setattr(recognizer, "greedy", lambda _, language=None: (*written[language], False))
    assert recognizer.listen(said("komm her")).transcript.language == language
