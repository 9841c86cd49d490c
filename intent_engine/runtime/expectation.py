"""Whether more can be expected after what was heard so far, and how long to wait for it."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from intent_engine.actions import Custom
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.references import Before
from intent_engine.language.utterance import plain
from intent_engine.language.words.thing_words import thing_words
from intent_engine.prefix import PrefixStatus
from intent_engine.runtime.amending import can_be_amended
from intent_engine.runtime.judgement import Judge
from intent_engine.runtime.transcript_grammar import grammar_of, intents_of, language_of
from intent_engine.speech.endpoint import Outlook
from intent_engine.speech.hypotheses.evidence import letters_apart
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY

__all__ = ["Expectation"]

LAST_WORDS = 3
"""Words at the end of a command, "the swimming pool", of which others may have been said that it goes on from."""


class Expectation:
    """What may follow the words heard, by the grammar of an engine.

    Args:
        judge: what they mean.
    """

    def __init__(self, judge: Judge) -> None:
        self._judge = judge
        self._engine = judge.engine
        self._spoken = SpokenGrammar(judge.engine)

    def outlook(
        self, transcript: Transcript, state: Collection[str], last: Before, *, amendable: bool
    ) -> tuple[Interpretation | None, Outlook]:
        """What the words so far mean, and whether more can be expected.

        Args:
            transcript: what was heard so far.
            state: of the robot.
            last: what was last understood.
            amendable: whether a motion can be put right while it is done: then there is less to wait for.
        """
        if not transcript.text:
            return None, Outlook.OTHER
        if self._only_called(transcript):
            return self._judge.meaning(transcript, state, last), Outlook.CALLED
        meaning, language = self._judge.meaning(transcript, state, last), language_of(self._engine, transcript)
        if meaning.status is Status.REJECTED and self._judge.unsure(transcript):
            begun = self._engine.prefix(transcript.free_text, language=language)
            return meaning, Outlook.INCOMPLETE if begun.status is PrefixStatus.INCOMPLETE else Outlook.OTHER
        prefix = self._engine.prefix(transcript.text, language=language, spoken=True)
        if meaning.status is Status.ACCEPTED and not meaning.stops_at_first:
            if meaning.stops:
                return meaning, Outlook.COMPLETE
            amended = amendable and can_be_amended(meaning)
            rests = prefix.resting or self._as_like_unfinished(transcript, language)
            # The speed of what a user's program does is a value like any other.
            told = prefix.settled and not (prefix.manner and any(isinstance(one, Custom) for one in meaning.actions))
            closed = prefix.status is PrefixStatus.COMPLETE and transcript.word_by_word
            asked = self.wait(transcript, meaning) is not None  # where it could go on, whatever that changes
            told = told and not (prefix.idle_end and asked)
            if not told and closed and not amended and not asked:
                # Behind "please" comes no more of a command, though it could have gone on before.
                return meaning, Outlook.SETTLED
            if not told or (rests and not amended):
                # What cannot be put right is waited for one step longer, and so is what was hardly heard.
                longer = (not amended) + _hardly_heard(transcript)
                return meaning, (Outlook.AMENDABLE, Outlook.EXTENDABLE, Outlook.DOUBTFUL)[longer]
            # "Take up", before a "picture", is like "take off", which nothing can follow.
            return meaning, Outlook.COMPLETE if closed or amended else Outlook.SETTLED
        return meaning, Outlook.INCOMPLETE if prefix.status is PrefixStatus.INCOMPLETE else Outlook.OTHER

    def _as_like_unfinished(self, transcript: Transcript, language: str | None) -> bool:
        """Whether what was heard is as near to the beginning of another sentence as to the command that it was taken
        for: "to the rule" may be "to the pool", and "to room" of which the number is to come."""
        if transcript.word_by_word:
            return False
        said, heard = (self._spoken.words(text, language) for text in (transcript.text, transcript.free_text))
        apart = letters_apart(said, heard) if heard else -1.0
        # Nobody rests behind an article.
        articles = thing_words(grammar_of(self._engine, transcript).language).articles
        return any(
            letters_apart([*begun, word], heard) <= apart and self._begins_only([*begun, word], language)
            for begun in (said[:count] for count in range(max(1, len(said) - LAST_WORDS), len(said)))
            for word in self._engine.prefix(" ".join(begun), language=language, spoken=True).next_words
            if word[0] != "<" and word not in articles
        )

    def _begins_only(self, words: Sequence[str], language: str | None) -> bool:
        prefix = self._engine.prefix(" ".join(words), language=language, spoken=True)
        return prefix.status is PrefixStatus.INCOMPLETE

    def _only_called(self, transcript: Transcript) -> bool:
        """Whether nothing was heard but the wake word: "robot", "hey robot"."""
        if not grammar_of(self._engine, transcript).wake:
            return False
        words, language = plain(transcript.free_text), language_of(self._engine, transcript)
        return len(words) == self._spoken.wake(language).after(words)

    def begins_nothing(self, transcript: Transcript) -> bool:
        """Whether no command begins with what was heard so far of words under way, of which the last may be half a
        word."""
        *words, _ = transcript.free_text.split() or [""]
        if not words:
            return False
        begun = self._engine.prefix(" ".join(words), language=language_of(self._engine, transcript))
        return begun.status is PrefixStatus.IMPOSSIBLE

    def wait(self, transcript: Transcript, meaning: Interpretation | None) -> float | None:
        """s of silence that end it where it could go on: the longest that its intents ask for; None: they do not."""
        if meaning is None or meaning.status is not Status.ACCEPTED:
            return None
        intents = intents_of(self._engine, transcript, meaning)
        return max((one.wait for one in intents if one.wait is not None), default=None)


def _hardly_heard(transcript: Transcript) -> bool:
    """Whether the words of a command were hardly heard."""
    return not transcript.word_by_word and transcript.score < CLEARLY
