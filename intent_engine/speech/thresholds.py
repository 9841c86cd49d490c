"""How sure a transcript must be, and how clear its words, for what: what recognisers and a robot that listens share.

Confidences are probabilities, gaps are in nats, and how clear words were is their mean log probability.
"""

from __future__ import annotations

from intent_engine.speech.recognizer import Transcript

__all__ = [
    "CLEARLY",
    "ENOUGH_FOR_AN_ANSWER",
    "HARDLY_A_SENTENCE",
    "HARDLY_A_WORD",
    "SURE_ENOUGH",
    "SURE_ENOUGH_OF_SEVERAL",
    "SURE_ENOUGH_TO_STOP",
    "WORTH_ASKING",
    "enough_to_stop",
]

SURE_ENOUGH = 0.7
"""Confidence of a transcript from which it is acted on, where its intent does not say another (``min_confidence``).
Measured on commands and other speech: docs/decisions/speech-confidence.md."""
SURE_ENOUGH_OF_SEVERAL = 0.9
"""The same for several commands at once: "hunting and reese" is no "hundred and freeze"."""
WORTH_ASKING = 0.4
"""Confidence from which it is told what it may have been."""
SURE_ENOUGH_TO_STOP = 0.4
"""Confidence from which a stop is acted on: to stop for nothing is the lesser harm,"""
ANOTHER_WORD = 1.75
"""unless another word was heard that is likelier by this gap: "wow" is not "whoa". Of 58 "stop" by as many people,
clean and at 10 dB, none had a gap above 1.5 where tiny.en was sure of it at 0.4 to 0.7; 13 "wow" had 1.8 to 2.7."""

HARDLY_A_WORD = -1.5
"""Mean log probability of the words heard, below which they tell nothing of what was said: "Oh" and "That" were heard
for "stop" at 10 dB. Most other words that hold the robot are heard better (docs/decisions/speech-held-robot.md)."""
HARDLY_A_SENTENCE = 2
"""Words heard, above which more was said than a stop: hardly any stop phrase is longer. At 10 dB a sentence is often
heard as hardly a word, and some of them hold the robot: "Please now take one" was "move backward one meter"."""
CLEARLY = -0.35
"""Mean log probability of the words heard, below which quiet ones beside a pause may be lost: of what is heard in doubt
of orders of coffee four of ten are below it in quiet, and six of ten at 6 dB."""

ENOUGH_FOR_AN_ANSWER = -1.0
"""The same from which an answer to what was asked back is taken, which says hardly more than the word that was asked
for, and so is never heard as well as a sentence (docs/decisions/language-answers.md)."""


def enough_to_stop(transcript: Transcript) -> float:
    """Confidence from which a stop is acted on."""
    another = transcript.gap is not None and transcript.gap > ANOTHER_WORD
    return SURE_ENOUGH if another else SURE_ENOUGH_TO_STOP
