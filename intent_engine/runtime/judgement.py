"""What a transcript means for a robot: nothing, where the sound was not clearly a command.

Text is understood by the engine alone. A transcript also says how well the sentence explains the sound, and a robot
that acts on a guess does what was not said.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable
from dataclasses import replace

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Question, Status
from intent_engine.language.context.references import Before
from intent_engine.language.numbers.alike import alike
from intent_engine.needs import MOVING
from intent_engine.runtime.asking_back import other_way, run_together
from intent_engine.runtime.transcript_grammar import grammar_of, intents_of, language_of
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import (
    CLEARLY,
    HARDLY_A_SENTENCE,
    HARDLY_A_WORD,
    SURE_ENOUGH,
    SURE_ENOUGH_OF_SEVERAL,
    SURE_ENOUGH_TO_STOP,
    WORTH_ASKING,
    enough_to_stop,
)

__all__ = ["Judge"]

SURE_BESIDE_A_STOP = 0.9
"""Confidence from which a word or two are done that may have been a stop: of 42 "go" at 10 dB two were less sure."""
FAR_BEHIND = 6.5
"""nats by which a stop may be less likely and still be what was said. Of 58 "stop" in two kitchen noises at 10 and 6 dB
ten were "go" from 0.6 to 0.9; the stop was behind by 5.2 at most. Any single word of a grammar is compared with any
short sound: of "louder" or "start recording" a stop is among the next likeliest, but behind by 8 and more."""

SURE_THOUGH_HELD = 0.95
"""Confidence in another short command, from which it is done though a stop was heard in its sound: at 10 dB and less
"stop" is "go", "let's go" and "just go", of which the models were sure by 0.78 to 0.90; of a true "go" by 0.98."""

_HELD = "a stop was heard before the word had ended, and nothing else was heard clearly"


class Judge:
    """Judges what was heard by the grammar of an engine, which may be reloaded at any time.

    Args:
        engine: understands.
    """

    def __init__(self, engine: IntentEngine) -> None:
        self.engine = engine

    def meaning(self, transcript: Transcript, state: Collection[str], last: Before) -> Interpretation:
        """What a transcript means; nothing, where it is too unlike what was heard. A stop that was heard of it, or a
        "no", stops a robot that moves, though the nearest sentence of the grammar may be another."""
        meaning = self._meaning(transcript, state, last)
        if MOVING in state and meaning.status is not Status.ACCEPTED and transcript.score > HARDLY_A_WORD:
            language = language_of(self.engine, transcript)
            heard = self.engine.parse(transcript.free_text, state=state, language=language, spoken=True, last=last)
            return heard if heard.stops else meaning
        return meaning

    def _meaning(self, transcript: Transcript, state: Collection[str], last: Before) -> Interpretation:
        language = language_of(self.engine, transcript)
        meaning = self.engine.parse(transcript.text, state=state, language=language, spoken=True, last=last)
        if meaning.status is Status.ACCEPTED and not meaning.stops and (why := self._unheard(transcript)):
            return Interpretation(transcript.text, Status.REJECTED, reason=why, alternatives=(transcript.text,))
        if meaning.status is Status.ACCEPTED and self.unsure(transcript, meaning):
            near = Interpretation(
                transcript.free_text,
                Status.REJECTED,
                reason=_why_unsure(transcript),
                alternatives=(transcript.text,),
            )
            if transcript.sureness >= WORTH_ASKING:
                return replace(near, question=Question((transcript.text,)))
            return self._with_reason(near, transcript, state, last)
        turned = other_way(self.engine, transcript, meaning, state)
        if (other := turned or run_together(self.engine, transcript, meaning, state)) is not None:
            why = f"{transcript.text!r} or {other!r}{', the other way' if turned else ''}? say it again"
            either = (transcript.text, other)
            asked = Question(either)
            return Interpretation(
                transcript.free_text, Status.REJECTED, reason=why, alternatives=either, question=asked
            )
        if meaning.status is Status.REJECTED and not meaning.refuses and self.unsure(transcript):
            return self._with_reason(meaning, transcript, state, last)
        return meaning if self._may_ask(transcript) else replace(meaning, question=None)

    def _unheard(self, transcript: Transcript) -> str:
        return _unheard(transcript, grammar_of(self.engine, transcript).language)

    def _may_ask(self, transcript: Transcript) -> bool:
        """Whether an answer to what is asked back may be acted on: not where its own words were hardly heard."""
        return not (self._unheard(transcript) or self.unsure(transcript))

    def _with_reason(
        self, refused: Interpretation, transcript: Transcript, state: Collection[str], last: Before
    ) -> Interpretation:
        """What is refused, for the reason that the words heard have when they are typed, if they clearly name a place
        that is not on the map: of "go to the moon" the nearest command tells nothing. It stays refused."""
        if transcript.score < CLEARLY:
            return refused
        language = language_of(self.engine, transcript)
        typed = self.engine.parse(transcript.free_text, state=state, language=language, spoken=True, last=last)
        if not typed.unknown_place:
            return refused
        return Interpretation(
            transcript.free_text,
            Status.REJECTED,
            reason=typed.reason,
            causes=typed.causes,
            alternatives=typed.alternatives,
            question=typed.question,
        )

    def held(self, transcript: Transcript, meaning: Interpretation) -> Interpretation:
        """What a transcript means while a robot is held, since a stop was heard in its sound before that had ended.

        That is a stop, unless something else was heard clearly, or more words than a stop has. To go on would pass over
        a stop; to stand costs a word.

        Args:
            transcript: what was heard.
            meaning: what it means by itself.
        """
        # "Moving of moving" are more words than "moving on" has: of "stop moving" no more was heard.
        found = transcript.text if meaning.status is Status.ACCEPTED else transcript.free_text
        fewest = min(len(text.split()) for text in (transcript.free_text, found))
        if meaning.stops or fewest > HARDLY_A_SENTENCE:
            return meaning
        if meaning.status is Status.ACCEPTED and transcript.confidence is not None:
            clearly = transcript.sureness >= SURE_THOUGH_HELD
        else:
            clearly = transcript.score > HARDLY_A_WORD
        if clearly:
            return meaning
        phrase = next(iter(grammar_of(self.engine, transcript).operators.stop))
        stop = self.engine.parse(" ".join(phrase), language=language_of(self.engine, transcript))
        return replace(stop, confidence=SURE_ENOUGH_TO_STOP, reason=_HELD)

    def unsure(self, transcript: Transcript, meaning: Interpretation | None = None) -> bool:
        """Whether the sentence of the grammar that was found is too unlikely to have been said.

        Args:
            transcript: what was heard.
            meaning: what it would mean; None: nothing that is done.
        """
        if transcript.confidence is None:
            return False
        return transcript.confidence < self._enough(meaning, transcript)

    def _enough(self, meaning: Interpretation | None, transcript: Transcript) -> float:
        """Confidence from which a meaning of a transcript is acted on."""
        if meaning is None:
            return SURE_ENOUGH
        several = len(meaning.actions) > 1
        asked = (intent.min_confidence for intent in intents_of(self.engine, transcript, meaning))
        enough = max((SURE_ENOUGH if one is None else one for one in asked), default=SURE_ENOUGH)
        if meaning.stops:
            return min(enough, enough_to_stop(transcript))
        if several:
            return max(enough, SURE_ENOUGH_OF_SEVERAL)
        return max(enough, SURE_BESIDE_A_STOP) if self._beside_a_stop(transcript) else enough

    def _beside_a_stop(self, transcript: Transcript) -> bool:
        """Whether a word or two may as well have been a stop: of "go", "move" and "stop", the last is the one that must
        never be missed."""
        if len(transcript.free_text.split()) > HARDLY_A_SENTENCE:
            return False
        language = language_of(self.engine, transcript)
        behind = transcript.behind or itertools.repeat(0.0)
        near = (other for other, nats in zip(transcript.alternatives, behind, strict=False) if nats < FAR_BEHIND)
        return any(self.engine.parse(other, language=language).stops for other in near)


def _unheard(transcript: Transcript, language: str) -> str:
    """Why words that are a command may not have been said; empty: they may be taken."""
    unclear = dict.fromkeys(transcript.unclear)  # one word may be so for several reasons
    others = {word: " or ".join(map(repr, alike(word, language))) for word in unclear}
    numbers = [f"{word!r} may have been {other}" for word, other in others.items() if other]
    words = [word for word, other in others.items() if not other]
    more = _listed(transcript.left_out)
    told = [
        *numbers,
        *([f"{_listed(words)} {'was' if len(words) == 1 else 'were'} not heard clearly"] if words else []),
        *([f"{more} was said too, and is no part of {transcript.text!r}"] if more else []),
    ]
    return f"{', '.join(told)}; say it again" if told else ""


def _listed(words: Iterable[str]) -> str:
    return " and ".join(map(repr, words))


def _why_unsure(transcript: Transcript) -> str:
    if transcript.sureness >= WORTH_ASKING:
        return f"perhaps {transcript.text!r}, but that was not heard clearly; say it again"
    return "it sounded too different from the nearest command"
