"""Which grammar of an engine a transcript belongs to, and which of its intents."""

from __future__ import annotations

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation
from intent_engine.language.grammar import Grammar, Intent
from intent_engine.speech.recognizer import Transcript

__all__ = ["grammar_of", "intents_of", "language_of"]


def language_of(engine: IntentEngine, transcript: Transcript) -> str | None:
    """The language of the grammar for a transcript: the one spoken; None, where no grammar has that: the first."""
    return transcript.language if transcript.language in engine.languages else None


def grammar_of(engine: IntentEngine, transcript: Transcript) -> Grammar:
    """The grammar for a transcript."""
    return engine.matcher(language_of(engine, transcript)).grammar


def intents_of(engine: IntentEngine, transcript: Transcript, meaning: Interpretation) -> list[Intent]:
    """What was said, one intent for each kind of command."""
    said = {step["intent"] for step in meaning.slots["steps"]} if meaning.intent == "compound" else {meaning.intent}
    intents = grammar_of(engine, transcript).intents
    return [intent for name, intent in intents.items() if name in said]
