"""Whether what was said answers what was asked back, and was heard clearly: "bay 3 or bay 13?", and "the second one".

What an answer means is known by the engine (:mod:`~intent_engine.language.context.answers`), and how long a question
lasts by :mod:`~intent_engine.runtime.last_asked`. An answer is a word or two, and the grammar has no sentence with
which its sound could be compared, so its words are only taken where they were heard clearly.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace

from rapidfuzz.distance import Levenshtein

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.answers import either
from intent_engine.language.numbers.alike import alike
from intent_engine.language.utterance import plain
from intent_engine.language.words.likeness import sound
from intent_engine.runtime.transcript_grammar import grammar_of, language_of
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY, ENOUGH_FOR_AN_ANSWER

__all__ = ["Answering"]

_NOT_CLEAR = "perhaps {!r}, but the answer was not heard clearly; say it again"
_SOUNDS_ALIKE = "{!r} sounds like another answer; say it otherwise"


class Answering:
    """Reads the answers to what was asked back, by the grammar of an engine, which may be reloaded at any time.

    Args:
        engine: understands.
    """

    def __init__(self, engine: IntentEngine) -> None:
        self._engine = engine

    def answer(
        self, asked: Interpretation, heard: Transcript, found: Interpretation, state: Collection[str]
    ) -> Interpretation | None:
        """What an utterance means as an answer; None: it is none, and means what it means by itself.

        Args:
            asked: what asked something back.
            heard: what was said next, by itself.
            found: what that means by itself.
            state: of the robot.
        """
        if found.stops:
            return None
        answer = self._read(asked, heard, heard.free_text, state)
        if answer is None or answer.stops:
            return answer
        if found.status is Status.ACCEPTED:
            if answer.status is not Status.ACCEPTED:
                return answer  # the words that were heard may be a command, or the answer
            return either(asked, found, answer) if answer.actions != found.actions else None
        if answer.status is not Status.ACCEPTED:
            return answer
        again = replace(asked, text=heard.free_text)
        # The rest of a sentence may be any of the grammar's words, an answer only what was asked about.
        one_of_few = asked.question is not None and not asked.question.beginning
        if heard.score < (ENOUGH_FOR_AN_ANSWER if one_of_few else CLEARLY) or heard.unclear:
            return replace(again, reason=_NOT_CLEAR.format(answer.text))
        if self._sounds_like_another(asked, heard, answer, state):
            return replace(again, reason=_SOUNDS_ALIKE.format(heard.free_text))
        return answer

    def _read(
        self, asked: Interpretation, heard: Transcript, text: str, state: Collection[str]
    ) -> Interpretation | None:
        """What words mean as the answer; None: they are none."""
        language = language_of(self._engine, heard)
        return self._engine.answer(asked, text, state=state, language=language, spoken=True)

    def _sounds_like_another(
        self, asked: Interpretation, heard: Transcript, answer: Interpretation, state: Collection[str]
    ) -> bool:
        """Whether another answer is said with a word that sounds like one that was heard: "thirty" and "thirteen",
        "the left one" and "the last one"."""
        words = plain(heard.free_text)
        language = grammar_of(self._engine, heard).language
        names = set[str]().union(*map(plain, asked.alternatives))
        for place, word in enumerate(words):
            for other in (*alike(word, language), *_like(word, names)):
                meant = self._read(asked, heard, " ".join((*words[:place], other, *words[place + 1 :])), state)
                if meant is not None and meant.actions and meant.actions != answer.actions:
                    return True
        return False


def _like(word: str, names: Collection[str]) -> Iterator[str]:
    """Words of names all but one sound of which is the same as that of a word."""
    for other in names:
        one, another = sound(word), sound(other)
        if other != word and min(len(one), len(another)) > 1 and Levenshtein.distance(one, another) <= 1:
            yield other
