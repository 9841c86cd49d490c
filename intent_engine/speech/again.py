"""What is made of a sound that is heard again, a moment later.

A model cuts a sound into the steps of its own clock: the same a hundredth of a second later is other numbers to it, and
in noise often other words. What was said is heard both times; what the noise made of it, seldom.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from intent_engine.speech.audio import Samples
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Transcript

__all__ = ["heard_again", "later"]

LATER = 170
"""Samples by which the sound is later, 10.6 ms: a model's window is 10 ms, and Whisper's encoder takes two at once."""
CONFIRMED = 0.95
"""Confidence from which what is done need not be heard again. In a grammar that would rather be wrong than ask
(``min_confidence``) nothing that is done is."""
SURE_AGAIN = 0.75
"""Confidence of the second time from which it is done, where nothing was done by the first;"""
HOPELESS = 0.03
"""that of the first, below which it is no command;"""
MAY_BE = 0.2
"""and that of either from which it may have been said: where that is not the same both times, it is asked back. Less
is noise."""


def heard_again(
    once: Transcript,
    samples: Samples,
    grammar: SpokenGrammar,
    hear: Callable[[Samples, bool], Transcript],
    *,
    late: bool = False,
) -> Transcript:
    """What was heard, after it was heard again if it is not sure: done if it was sure either time, and asked back if it
    may have been something else. A stop waits for nothing, what shall not be done is not tried until it is heard
    otherwise, and a thing that may have any name must be heard the first time.

    Args:
        once: what was heard, with all care.
        samples: in which sound.
        grammar: that knows what it means.
        hear: how it was heard: a sound, and whether with as much care. What is done already is only looked at, which
            takes half the time.
        late: whether it took so long that nothing more is to be found. What would be done is looked at all the same:
            a slow machine is no reason to be less careful.
    """
    meaning = grammar.parse(once.text, once.language)
    done = grammar.acted_on(once.sureness, once.language)
    confirmed = once.sureness >= CONFIRMED or grammar.forgiving(once.language)
    asked_back = once.unclear or once.left_out
    enough = meaning.refuses or (done and (confirmed or meaning.stops or asked_back))
    if enough or once.sureness < HOPELESS or (late and not done):
        return once
    again = hear(later(samples), not done)
    said = grammar.parse(again.text, again.language)
    if said.actions != meaning.actions and not said.stops and min(once.sureness, again.sureness) >= MAY_BE:
        return replace(once, confidence=once.sureness / 2) if done else once
    if done and again.left_out and again.sureness >= MAY_BE:
        return replace(once, left_out=again.left_out)
    if done or not said.actions or again.sureness < SURE_AGAIN or again.unclear or again.left_out:
        return once
    return once if grammar.holds_any_words(grammar.words(again.text, again.language), again.language) else again


def later(samples: Samples) -> Samples:
    """The same sound, a moment later."""
    return np.concatenate((np.zeros(LATER, samples.dtype), samples))
