"""A dictated text: "write down that the left wheel needs oil". Nothing in a grammar tells what may be in it.

So only the words before it are steered: "right down" is "write down" if that is how it sounded. What comes after them
is left to each model as it heard it, and taken from the one whose text both together find likelier. Among the sentences
of a grammar such a command is its beginning with one word for whatever was dictated.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from intent_engine.language.meaning.dictation import ANYTHING
from intent_engine.language.networks.approximate import FreeWord
from intent_engine.speech.hypotheses.evidence import letters_apart
from intent_engine.speech.recognizer import Transcript

if TYPE_CHECKING:
    from intent_engine.speech.hypotheses.opinion import Opinion

__all__ = ["DICTATED", "as_heard", "as_written", "begin_of", "dictated_to_both", "hardly_begun", "text_of"]

DICTATED = FreeWord(ANYTHING)
"""Whatever was dictated, as the last word of a sentence."""
BEHIND = 3.0
"""nats for each model by which the words before a text may be less likely than what was heard in their place. "Right
down" is so by 0 to 9 of "write down", half of the time by less than 2; "not the" of "note the" by 5 to 13
(docs/decisions/speech-dictation.md)."""
MORE_HEARD = 2
"""Words by which more or fewer may have been heard for the words before it: "Tillanna" for "tell Anna"."""


def begin_of(words: Sequence[str]) -> tuple[str, ...]:
    """The words before a dictated text; none where nothing is dictated."""
    return tuple(words[:-1]) if words and words[-1] == DICTATED else ()


def as_heard(words: Sequence[str], heard: Sequence[str]) -> tuple[str, ...]:
    """A sentence, with the text that was heard in the place of whatever was dictated.

    Args:
        words: of the sentence.
        heard: all words that were heard.
    """
    begin = begin_of(words)
    return (*begin, *heard[_length(begin, heard) :]) if begin else tuple(words)


def _length(begin: Sequence[str], heard: Sequence[str]) -> int:
    """How many of the words heard stand for those before a text, which is not empty."""
    most = min(len(begin) + MORE_HEARD, len(heard) - 1)
    lengths = range(max(0, min(len(begin) - MORE_HEARD, most)), most + 1)
    return min(lengths, key=lambda length: letters_apart(begin, heard[:length]), default=0)


def hardly_begun(words: Sequence[str], opinions: Sequence[Opinion]) -> tuple[str, ...]:
    """The words before a dictated text, if no model heard them and they are not as likely as what was heard: "not the
    left one" is no "note the left one". Nothing else in the sentence could tell.

    Args:
        words: of the sentence.
        opinions: of the same sound.
    """
    begin = begin_of(words)
    if not begin or any(list(as_heard(words, one.heard)) == one.heard for one in opinions):
        return ()
    views = [one.views([tuple(words)])[0] for one in opinions]
    behind = sum(max(0.0, view.free_score - view.score) for view in views)
    return (" ".join(begin),) if behind > BEHIND * len(opinions) else ()


def as_written(begin: Sequence[str], text: str, words: Callable[[str], Sequence[str]]) -> str:
    """The words before a text, and the text as a model wrote it.

    Args:
        begin: those words.
        text: all that it wrote.
        words: of which words something written is.
    """
    count = _length(begin, words(text))
    written = text.split()
    enough = (place for place in range(len(written) - 1) if len(words(" ".join(written[:place]))) >= count)
    return " ".join((*begin, *written[next(enough, len(written) - 1) :]))


def text_of(words: Sequence[str], opinions: Sequence[Opinion]) -> str:
    """A sentence as it is written: with the dictated text in it, if there is one, that all models together find
    likeliest."""
    if not (begin := begin_of(words)):
        return " ".join(words)
    texts = list(dict.fromkeys(one.written(begin) for one in opinions))
    together = [sum(likely) for likely in zip(*(one.likelihoods(texts) for one in opinions), strict=True)]
    return texts[together.index(max(together))]


def dictated_to_both(first: Opinion, second: Opinion, confidence: float) -> Transcript | None:
    """What two models heard, where both heard the same words before a dictated text; else None.

    Args:
        first, second: what each made of the sound.
        confidence: in the words that both heard.
    """
    if not first.dictated or first.dictated != second.dictated:
        return None
    text = text_of((*first.dictated, DICTATED), (first, second))
    return replace(first.transcript, text=text, gap=0.0, alternatives=(), behind=(), confidence=confidence)
