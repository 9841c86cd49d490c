"""German, heard by the model that knows it, from a synthetic voice."""

from __future__ import annotations

import numpy as np
import pytest

from intent_engine.engine import IntentEngine
from intent_engine.speech.audio import Samples
from intent_engine.speech.models import recognizer_for

voices = pytest.importorskip("py_nanotts", reason="the voice's package has no wheel for this system")


def said(text: str) -> Samples:
    """By SVOX Pico's German voice, at 16 kHz, with quiet around it."""
    sound = np.frombuffer(voices.NanoTTS().speak(text, "de-DE"), np.int16).astype(np.float32)
    return np.concatenate([np.zeros(4800, np.float32), 0.3 * sound / np.abs(sound).max(), np.zeros(4800, np.float32)])


@pytest.fixture(scope="module")
def engine(root) -> IntentEngine:
    return IntentEngine.from_files(root / "grammars/de.yaml", locations=root / "locations/zuhause.yaml")


@pytest.fixture(scope="module")
def hears(engine):
    recognizer = recognizer_for(engine)
    yield lambda text: recognizer.transcribe(said(text))
    recognizer.close()


@pytest.mark.parametrize(
    "text",
    [
        "komm bitte zur Ladestation",
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


@pytest.mark.parametrize("text", ["fahr nicht in die Küche", "dreh dich nicht um", "er geht zwei Meter vor"])
def test_what_is_no_command_is_none(engine, hears, text):
    heard = hears(text)
    acted_on = engine.parse(heard.text).actions and heard.sureness >= 0.7 and not (heard.unclear or heard.left_out)
    assert not acted_on
