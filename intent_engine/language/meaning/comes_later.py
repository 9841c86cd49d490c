"""Whether a command is to be done after what the robot does: "then turn left", "turn left next"."""

from __future__ import annotations

from intent_engine.language.matcher import Matcher
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["comes_later"]


def comes_later(words: list[str], phrases: Phrases, matcher: Matcher) -> bool:
    """Whether words say that something else is done first, before a command or behind the first one. What a sentence of
    the grammar ends with says nothing of that: "play next".

    Args:
        words: of an utterance.
        phrases: of the grammar.
        matcher: of the grammar.
    """
    if phrases.comes_later(words):
        return True
    at_last = phrases.later_at_last.find(words, 1)
    while at_last is not None:
        end = sum(at_last)
        if phrases.fillers.cover(words[end:]) or phrases.sequence.at(words, end):
            own = phrases.without_fillers(Utterance.in_one_breath(words[phrases.after_wake(words) : end]))
            return not any(not reading.free_words for reading in matcher.read(own.words))
        at_last = phrases.later_at_last.find(words, end)
    return False
