"""The reflex stop: a small keyword recogniser that is always listening for nothing but the stop words.

It hears "stop" before the word has ended, and is wrong one time in twenty; so it only *holds* the robot, and the
recogniser then confirms the stop or releases it. Two partial results in a row are asked for.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, Protocol

import numpy as np

from intent_engine.speech.audio import SAMPLE_RATE, Samples

__all__ = ["PocketsphinxReflex", "Reflex"]

AGREEING = 2
"""Partial results in a row that must hold a stop word."""


class Reflex(Protocol):
    """Listens for stop words in the stream."""

    def heard(self, samples: Samples) -> bool:
        """Whether a stop word is being said, as of this frame."""
        ...

    def reset(self) -> None:
        """A new utterance begins."""
        ...


class PocketsphinxReflex:
    """Pocketsphinx on a grammar of the stop words against everything else that is short, with its own model.

    Args:
        stop_phrases: what stops the robot; phrases with a word that the dictionary lacks are left out.
        others: words of the language that sound like none of them, to take what is not a stop.
    """

    def __init__(self, stop_phrases: Iterable[str], others: Iterable[str] = ()) -> None:
        from pocketsphinx import Decoder

        self._decoder: Any = Decoder(lm=None, loglevel="FATAL", samprate=SAMPLE_RATE)
        known = [phrase for phrase in stop_phrases if self._knows(phrase)]
        rest = [word for word in others if self._knows(word) and word not in known]
        if not known:
            raise ValueError("none of the stop words is in the dictionary")
        self.words = frozenset(known)
        stops = " | ".join(known)
        fillers = " | ".join(rest) if rest else ""
        rule = f"( {stops} | {fillers} )" if fillers else f"( {stops} )"
        self._decoder.add_jsgf_string("stop", f"#JSGF V1.0;\ngrammar stop;\npublic <words> = {rule}+ ;\n")
        self._decoder.activate_search("stop")
        self._pattern = re.compile(r"\b(?:" + "|".join(map(re.escape, known)) + r")\b")
        self._open = False
        self._agreeing = 0

    def _knows(self, phrase: str) -> bool:
        return all(self._decoder.lookup_word(word) is not None for word in phrase.split())

    def reset(self) -> None:
        if self._open:
            self._decoder.end_utt()
        self._decoder.start_utt()
        self._open = True
        self._agreeing = 0

    def heard(self, samples: Samples) -> bool:
        if not self._open:
            self.reset()
        sound = (np.clip(samples, -1.0, 1.0) * 32767).astype(np.int16).tobytes()
        self._decoder.process_raw(sound, False, False)
        partial = self._decoder.hyp()
        if partial is not None and self._pattern.search(partial.hypstr):
            self._agreeing += 1
        else:
            self._agreeing = 0
        return self._agreeing >= AGREEING
