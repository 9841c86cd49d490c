"""Verbs that tell what somebody did or does, where a command sounds like them: "turned left", "led us to the cafe".

A recogniser may write "turned left" for "turn left". Who types it tells of something.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.words.verb_forms import told_forms_of

__all__ = ["told_as_done"]


def told_as_done(
    words: Sequence[str], parts: Sequence[Clause], alikes: Mapping[str, Sequence[str]], language: str
) -> tuple[str, str] | None:
    """A word that tells of what a command was read for, and the verb that it was read as. None: there is none.

    Args:
        words: those that were typed.
        parts: the commands that they were understood as.
        alikes: what words may be read as.
        language: of the words.
    """
    for part in parts:
        if part.reading is None or not part.reading.alikes:
            continue
        read = part.reading.words
        for word in words:
            verbs = [verb for verb in alikes.get(word, ()) if verb in read]
            if verbs and word not in read:
                told = next((verb for verb in told_forms_of(word, language) if verb in verbs), "")
                if told:
                    return word, told
    return None
