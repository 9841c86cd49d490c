"""What may have been said as well, and does something else, so that a robot asks back: "go forward" or "go back"?"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.utterance import plain
from intent_engine.language.words.likeness import sound
from intent_engine.runtime.transcript_grammar import grammar_of, language_of
from intent_engine.speech.recognizer import Transcript
from intent_engine.ways import opposite_ways, ways

__all__ = ["other_way", "run_together"]

OTHER_WAY = 3.0
"""nats by which the same motion the other way must be less likely than what is done: one in twenty. Of 344 commands,
clean, and 172 at 10 dB, "going forward" for "going rearward" was ahead by 2.6, and what was right by 3.1 and more."""


def other_way(
    engine: IntentEngine, transcript: Transcript, meaning: Interpretation, state: Collection[str]
) -> str | None:
    """What may have been said as well and drives or turns the other way; None: nothing."""
    if meaning.status is not Status.ACCEPTED or transcript.word_by_word or not any(ways(meaning.actions)):
        return None
    language = language_of(engine, transcript)
    near = (one for one, nats in zip(transcript.alternatives, transcript.behind, strict=False) if nats < OTHER_WAY)
    for other in near:
        if opposite_ways(meaning.actions, engine.parse(other, state=state, language=language, heard=True).actions):
            return other
    return None


def run_together(
    engine: IntentEngine, transcript: Transcript, meaning: Interpretation, state: Collection[str]
) -> str | None:
    """What may have been said as well, if a joint is the beginning of the word after it: "unload it", of which "and
    load it" is heard, or "turn anticlockwise", of which "turn and clockwise" is; None: nothing that does anything
    else. However sure the models are of an "and", little speaks for one that joins nothing, and less for two
    commands where the same sound is one."""
    words = plain(transcript.text)
    if meaning.status is not Status.ACCEPTED:
        return None
    language = language_of(engine, transcript)
    joints = grammar_of(engine, transcript).operators.sequence
    for place, (joint, begun) in enumerate(pairwise(words)):
        if (joint,) not in joints:
            continue
        for word in _words_after(engine, words[:place], language):
            if word.endswith(begun) and _sounds_like_begun(joint, word.removesuffix(begun)):
                other = " ".join((*words[:place], word, *words[place + 2 :]))
                found = engine.parse(other, state=state, language=language)
                fewer = len(found.actions) < len(meaning.actions)
                if found.actions and (fewer if place else found.actions != meaning.actions):
                    return other
    return None


def _words_after(engine: IntentEngine, words: Sequence[str], language: str | None) -> list[str]:
    """The words of the grammar with which a sentence may go on that begins so."""
    strict = engine.matcher(language).strict
    known, reached = strict.walk(words)
    return sorted(strict.next_words(reached)) if reached is not None and known == len(words) else []


def _sounds_like_begun(joint: str, beginning: str) -> bool:
    """Whether a joint sounds like the beginning of a word, up to a last sound that is easily lost: "and", and "un"."""
    shorter, longer = sorted((sound(joint), sound(beginning) if beginning else ""), key=len)
    return len(shorter) > 1 and longer.startswith(shorter)
