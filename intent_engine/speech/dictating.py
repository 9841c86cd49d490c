"""A dictated text: "write down that the left wheel needs oil". Nothing in a grammar tells what may be in it.

So only the words before it are asked about. Where two models heard these alike, the text is the one that both together
find likelier, word for word as one of them wrote it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from intent_engine.speech.opinion import Opinion
from intent_engine.speech.recognizer import Transcript

__all__ = ["dictated_to_both", "read_as_dictated"]


def dictated_to_both(first: Opinion, second: Opinion, confidence: float) -> Transcript | None:
    """What two models heard, where both heard the same before a dictated text; else None.

    Args:
        first, second: what each made of the sound.
        confidence: in the words that both heard.
    """
    if not first.dictated or first.dictated != second.dictated:
        return None
    texts = [one.transcript.free_text for one in (first, second)]
    both = [sum(found) for found in zip(*(one.likelihoods(texts) for one in (first, second)), strict=True)]
    text = texts[both.index(max(both))]
    return replace(first.transcript, text=text, free_text=text, gap=0.0, confidence=confidence)


def read_as_dictated(transcript: Transcript, words: Sequence[str], opinions: Sequence[Opinion]) -> Transcript:
    """A transcript in the writing of the model that heard just these words, where one heard them and a text in them."""
    heard = (one for one in opinions if one.dictated and one.heard == list(words))
    one = next(heard, None)
    return transcript if one is None else replace(transcript, text=one.transcript.free_text)
