"""What words right after a command have to do with it: they go on from it, take it back, or end its sentence.

It is asked of the words alone. Which command was before, and how long ago, is known by
:mod:`~intent_engine.runtime.continuing`.
"""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.engine import IntentEngine
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.going_on import is_a_list
from intent_engine.language.context.references import Before
from intent_engine.language.numbers.alike import alike
from intent_engine.language.utterance import plain
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.runtime.transcript_grammar import grammar_of, language_of
from intent_engine.speech.hypotheses.corrections import as_meant
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import CLEARLY, HARDLY_A_WORD

__all__ = ["FollowUp"]

CORRECTED_CLEARLY = -0.9
"""The same of a correction, which at least stops what is being done: a "no, right" of two words is seldom heard as
clearly as a sentence."""


class FollowUp:
    """Reads what follows a command by the grammar of an engine, which may be reloaded at any time.

    Args:
        engine: understands.
    """

    def __init__(self, engine: IntentEngine) -> None:
        self._engine = engine
        self._spoken = SpokenGrammar(engine)

    def together(
        self, before: str, transcript: Transcript, state: Collection[str], last: Before | None = None
    ) -> Interpretation | None:
        """What words that were heard clearly mean after those before, if both are a command word by word. Numbers that
        sound like another are left to the models. ``last`` was understood before all of them."""
        clearly = CORRECTED_CLEARLY if self.corrects(transcript) else CLEARLY
        words, language = plain(transcript.free_text), grammar_of(self._engine, transcript).language
        if transcript.score < clearly or any(alike(word, language) for word in words):
            return None
        called = len(words) - len(self._words(transcript))
        text = " ".join(transcript.free_text.split()[called:])  # "robot, turn left", and "robot, no, right"
        meaning = self.text(f"{before}, {text}", transcript, state, last)
        return meaning if meaning.status is Status.ACCEPTED and meaning.confidence == 1.0 else None

    def text(
        self, text: str, transcript: Transcript, state: Collection[str], last: Before | None = None
    ) -> Interpretation:
        """What a text means in the language of a transcript, after ``last`` was understood."""
        language = language_of(self._engine, transcript)
        return self._engine.parse(text, state=state, language=language, spoken=True, last=last)

    def stop_going_on(self, stop: str, transcript: Transcript, state: Collection[str]) -> Interpretation | None:
        """A stop with the words after it, if both are one sentence that stops: "stop" and "going forward", but not
        "stop" and "go back"; None: they are not."""
        matcher = self._engine.matcher(language_of(self._engine, transcript))
        words = [*plain(stop), *plain(transcript.text)]
        for begin in range(len(plain(stop))):
            readings = matcher.read(words[begin:])
            if any(one.intent.action.type == "stop" and not one.problem for one in readings):
                return self.text(f"{stop}, {transcript.text}", transcript, state)
        return None

    def one_sentence(self, before: str, transcript: Transcript, state: Collection[str]) -> Interpretation | None:
        """What the words of a command and those after it mean, if the grammar has both as one sentence: "too loud" and
        "turn it down"; None: it has not."""
        matcher = self._engine.matcher(language_of(self._engine, transcript))
        readings = matcher.read([*plain(before), *plain(transcript.text)])
        if all(one.problem for one in readings):
            return None
        meaning = self.text(f"{before} {transcript.text}", transcript, state)
        return meaning if meaning.status is Status.ACCEPTED else None

    def besides_or_instead(
        self, done: Interpretation, transcript: Transcript, state: Collection[str], last: Before | None = None
    ) -> bool:
        """Whether its words are no more than what a command before could name, too: "the bedroom", after "go to the
        kitchen". Nothing tells whether both are meant."""
        sequence = grammar_of(self._engine, transcript).operators.sequence
        words = self._words(transcript)
        if transcript.score < CLEARLY or not sequence or not words:
            return False
        whole = self.text(" ".join((done.text, *sequence[0], *words)), transcript, state, last)
        return is_a_list(whole, len(done.actions) - 1)

    def comes_after(self, transcript: Transcript) -> bool:
        """Whether it begins with "and then", or the like."""
        sequence = PhraseSet(grammar_of(self._engine, transcript).operators.sequence)
        return sequence.at(self._words(transcript), 0) > 0

    def lacks_wake_word(self, transcript: Transcript, state: Collection[str]) -> bool:
        """Whether its words are a command that lacks only the wake word, and may be said to somebody else."""
        if not grammar_of(self._engine, transcript).wake:
            return False
        language = language_of(self._engine, transcript)
        typed = self._engine.parse(transcript.free_text, state=state, language=language, heard=True)
        return typed.status is Status.ACCEPTED

    def comes_later(self, transcript: Transcript) -> bool:
        """Whether it says by itself that something else is done first: "then", "when you get there", not "and"."""
        return self._engine.comes_later(transcript.free_text, language=language_of(self._engine, transcript))

    def corrects(self, transcript: Transcript) -> bool:
        """Whether it begins with "no", "I mean", or the like, and was heard well enough to be a word."""
        corrections, words = self._corrections(transcript)
        return corrections.at(words, 0) > 0

    def only_corrects(self, transcript: Transcript) -> bool:
        """Whether it is nothing but "no, wait", or the like, and was heard well enough."""
        corrections, words = self._corrections(transcript)
        return bool(words) and corrections.cover(words)

    def ends_in_correction(self, transcript: Transcript) -> bool:
        """Whether it ends with "no", or the like, and was heard well enough."""
        corrections, words = self._corrections(transcript)
        return corrections.ends(words) > 0

    def _words(self, transcript: Transcript) -> list[str]:
        """The words that were heard, behind a wake word."""
        words = plain(transcript.free_text)
        return words[self._spoken.wake(language_of(self._engine, transcript)).after(words) :]

    def _corrections(self, transcript: Transcript) -> tuple[PhraseSet, list[str]]:
        """What takes back what was said, and the words that were heard; none, if they were hardly words."""
        grammar = grammar_of(self._engine, transcript)
        corrections = PhraseSet(grammar.operators.correction)
        heard = self._words(transcript) if transcript.score > HARDLY_A_WORD else []
        return corrections, as_meant(heard, corrections, grammar.sound_alikes)
