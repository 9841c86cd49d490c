"""What a transcript means for a robot: nothing, where the sound was not clearly a command.

Text is understood by the engine alone. A transcript also says how well the sentence explains the sound, and a robot
that acts on a guess does what was not said.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from intent_engine.actions import Action, Stop
from intent_engine.engine import IntentEngine, PrefixStatus
from intent_engine.interpretation import Interpretation, Status
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.recognizer import Transcript

__all__ = ["Judge", "stops", "too_far"]

MAX_GAP = 1.5
"""Gap of a transcript beyond which something else was said. Measured on commands and other speech: docs/speech.md."""

NOISE_SCORE = -2.0
"""Score of a transcript below which only what was heard as it is counts: a fan may be like a sentence too."""
MUMBLED_SCORE = -1.2
"""Score of a transcript below which the sound is hardly speech: then every sentence explains it as badly as the free
words do, and the gap must be next to nothing. A stop is taken from any sound that is like one."""
MUMBLED_GAP = 0.1
SEVERAL_GAP = 0.3
"""Gap beyond which several commands at once are not taken: "hunting and reese" is no "hundred and freeze"."""


class Judge:
    """Judges what was heard by the grammar of an engine, which may be reloaded at any time."""

    def __init__(self, engine: IntentEngine) -> None:
        self.engine = engine

    def outlook(
        self, transcript: Transcript, state: Collection[str], last: Sequence[Action]
    ) -> tuple[Interpretation | None, Outlook]:
        """What the words so far mean, and whether more can be expected."""
        if not transcript.text:
            return None, Outlook.OTHER
        meaning = self.meaning(transcript, state, last)
        if meaning.status is Status.REJECTED and too_far(transcript):
            return meaning, Outlook.OTHER
        prefix = self.engine.prefix(transcript.text, language=self._language(transcript))
        if meaning.status is Status.ACCEPTED:
            if stops(meaning):
                return meaning, Outlook.COMPLETE
            if not prefix.settled:
                return meaning, Outlook.EXTENDABLE
            return meaning, Outlook.COMPLETE if prefix.status is PrefixStatus.COMPLETE else Outlook.SETTLED
        return meaning, Outlook.INCOMPLETE if prefix.status is PrefixStatus.INCOMPLETE else Outlook.OTHER

    def _language(self, transcript: Transcript) -> str | None:
        """The grammar for a transcript: that of the language spoken, where there is one."""
        return transcript.language if transcript.language in self.engine.languages else None

    def meaning(self, transcript: Transcript, state: Collection[str], last: Sequence[Action]) -> Interpretation:
        """What a transcript means; nothing, where it is too unlike what was heard."""
        language = self._language(transcript)
        meaning = self.engine.parse(transcript.text, state=state, language=language, spoken=True, last=last)
        if meaning.status is Status.ACCEPTED and not stops(meaning) and (why := _unheard(transcript)):
            return Interpretation(transcript.text, Status.REJECTED, reason=why, alternatives=(transcript.text,))
        if meaning.status is Status.ACCEPTED and too_far(transcript, meaning):
            free = self.engine.parse(transcript.free_text, state=state, language=language, spoken=True, last=last)
            if free.actions != meaning.actions:
                return Interpretation(
                    transcript.free_text,
                    Status.REJECTED,
                    reason="it sounded too different from the nearest command",
                    alternatives=(transcript.text,),
                )
        return meaning


def _unheard(transcript: Transcript) -> str:
    """Why words that are a command may not have been said; empty: they may be taken."""
    words = " and ".join(repr(word) for word in transcript.unclear)
    return f"{words} was not heard clearly; say it again" if words else ""


def too_far(transcript: Transcript, meaning: Interpretation | None = None) -> bool:
    """Whether the nearest sentence of the grammar is too unlike the sound to have been said."""
    most = MAX_GAP
    if meaning is None or not stops(meaning):
        if meaning is not None and len(meaning.actions) > 1:
            most = SEVERAL_GAP
        if transcript.score < MUMBLED_SCORE:
            most = MUMBLED_GAP if transcript.score > NOISE_SCORE else 0.0
    return transcript.gap is not None and transcript.gap > most


def stops(meaning: Interpretation) -> bool:
    return any(isinstance(action, Stop) for action in meaning.actions)
