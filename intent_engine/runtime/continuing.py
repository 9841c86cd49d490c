"""What is said right after a command may belong to it: "turn left", and a moment later "ninety degrees", "no, right",
"slowly", or "and then go to the kitchen".

A motion that could go on is begun after a short silence, so that the robot answers at once. What follows, and is no
command by itself, is heard once more together with it. If both are one command that begins with the words of the first,
then that is what was meant, and the robot does what is left of it. What begins with "and then" waits its turn. Of what
begins with "no", and is not understood, so much is clear that the motion was not meant: the robot stops. And a stop is
done before its sentence is over: "going forward" after "stop" is the end of it. So is any command that makes one
sentence of the grammar with the one before and means the same: "too loud", and "turn it down". "And go to the kitchen"
goes on from what was said before; if that was not understood, neither is done.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from intent_engine.execution.goal import Goal
from intent_engine.execution.policy import Policy
from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.context.references import Before
from intent_engine.needs import MOVING
from intent_engine.runtime.amending import CarriedOut, Step, begun_alike, in_a_row
from intent_engine.runtime.follow_up import FollowUp
from intent_engine.runtime.judgement import Judge
from intent_engine.speech.audio import SAMPLE_RATE
from intent_engine.speech.recognizer import Transcript
from intent_engine.speech.thresholds import HARDLY_A_SENTENCE, SURE_ENOUGH_OF_SEVERAL

if TYPE_CHECKING:
    from intent_engine.speech.audio import Samples
    from intent_engine.speech.spoken_utterance import SpokenUtterance

__all__ = ["Continuing", "Understood"]

LONGEST = 10.0
"""s of sound that is heard once more."""
ONE_SENTENCE = 1.5
"""s from the last words of a command that was done to the onset of others that may be the end of its sentence."""
ONE_BREATH = 0.45
"""s from the last frame of one command to the onset of the next, within which both are said in one breath: what other
commands wait for those that could go on, and two frames for the onset."""
_AFTER_NOTHING = "what was said before it was not understood, and may come first; say both again"
_BESIDES_OR_INSTEAD = "{!r} may be said besides what was said before, or in its place; say 'and' or 'no' before it"
_TOO_LATE = "it belongs to {!r}, which is being done and cannot be changed; say the whole command again"
_WITHDRAWN = "the command before it is taken back, and what is meant instead was not understood; say it again"


@dataclass(frozen=True, slots=True)
class Understood:
    """What came of an utterance."""

    transcript: Transcript
    meaning: Interpretation
    step: Step
    withdrawn: bool = False
    """Whether the command before is taken back, and nothing is done in its place."""
    corrects: bool = False
    """Whether it is not understood, and begins with a "no" or the like, however long ago the command before was."""


@dataclass(frozen=True, slots=True)
class _Said:
    """The last command that was carried out, and how it was said."""

    sound: Samples
    ended: float
    command: CarriedOut
    heard: str = ""
    """The words as they were heard freely: "it's too loud" of "that's too loud"."""
    withdrawn: bool = False
    """Whether it was taken back, and not said yet what is meant instead."""
    last: Before = ()
    """What was last understood before it, which its words and those that belong to it point back to."""


class Continuing:
    """Keeps the last command, for what may go on from it. For one thread.

    Args:
        judge: what a transcript means.
        within: s after the last words of a command, within which those begin that go on from it.
    """

    def __init__(self, judge: Judge, within: float) -> None:
        self._judge = judge
        self._follow_up = FollowUp(judge.engine)
        self.on = True
        """Whether anything goes on from a command. It may be changed at any time."""
        self._within = within
        self._said: _Said | None = None
        self._stopped: tuple[str, float] | None = None
        """The last stop in words, and when they ended; None: something else was done since."""
        self._last: Before = ()
        """What was last understood before the utterance that is being understood."""
        self._missed: float | None = None
        """When the last utterance ended, if it was not understood."""

    def carried_out(self, utterance: SpokenUtterance, understood: Understood, goals: Sequence[Goal]) -> None:
        """A command was begun, by these goals."""
        whole, given = understood.meaning, tuple(goals)
        before = self._said.command if self._said is not None else None
        command = before.grown_to(whole, given) if before is not None else CarriedOut(whole, given)
        goes_on = self._said is not None and understood.step.goes_on
        last = self._said.last if self._said is not None and goes_on else self._last
        heard = understood.transcript.free_text
        self._said = _Said(utterance.said(), utterance.last_voice, command, heard, last=last)
        self._stopped = self._missed = None

    def stopped(self, utterance: SpokenUtterance, meaning: Interpretation) -> None:
        """The robot was stopped, before it was known whether the sentence was over. With a "no, wait!" the command
        before is only taken back: what was meant may follow."""
        said, heard = self._before(utterance), utterance.result
        self.forget()
        self._stopped = meaning.text, utterance.last_voice
        if said is not None and heard is not None and self._follow_up.only_corrects(heard):
            self._said = replace(said, sound=utterance.said(), ended=utterance.last_voice, heard="", withdrawn=True)

    def forget(self) -> None:
        """Nothing goes on from what was said."""
        self._said = self._stopped = self._missed = None

    def heard_with(
        self, utterance: SpokenUtterance, state: Collection[str], last: Before, *, held: bool = False
    ) -> Samples | None:
        """The sound together with which an utterance is to be heard anew, since it is no command by itself, or was
        hardly heard as one; None: there is none, or it has been already.

        Args:
            utterance: decoded by itself.
            state: of the robot.
            last: what was last understood.
            held: whether the robot is held, since a stop may have been said.
        """
        said, heard = self._before(utterance), utterance.result
        if said is None or utterance.short or utterance.before is not None:
            return None
        if said.sound.size > LONGEST * SAMPLE_RATE or heard is None or not heard.free_text.strip():
            return None
        alone = self._judge.meaning(heard, state, last)
        if held:
            alone = self._judge.held(heard, alone)
        clearly = heard.word_by_word or heard.sureness >= SURE_ENOUGH_OF_SEVERAL
        goes_on = alone.stops_at_first or alone.objects  # "no", and a moment later "the dock"
        sure = alone.status is Status.ACCEPTED and (alone.stops or clearly) and not goes_on
        return None if sure else said.sound

    def understood(self, utterance: SpokenUtterance, state: Collection[str], last: Before) -> Understood:
        """What an utterance means that was decoded, by itself or together with the command before. Nothing, if it goes
        on ("and go to the kitchen") from what was not understood just before: that may have had to be done first."""
        self._last = last
        found = self._meant(utterance, state, last)
        soon = self._missed is not None and utterance.began - self._missed <= self._within
        accepted = found.meaning.status is Status.ACCEPTED
        if soon and accepted and not found.meaning.stops and self._follow_up.comes_after(found.transcript):
            refused = Interpretation(found.transcript.text, Status.REJECTED, reason=_AFTER_NOTHING)
            found = Understood(found.transcript, refused, Step(()))
        said = accepted or not found.transcript.text.strip()
        self._missed = None if said else utterance.last_voice
        return found if accepted else replace(found, corrects=self._follow_up.corrects(found.transcript))

    def _meant(self, utterance: SpokenUtterance, state: Collection[str], last: Before) -> Understood:
        """The first of these that fits:

        1. the end of a sentence whose stop was done already: "stop" ... "going forward";
        2. the second half of a sentence that was done already: "too loud" ... "turn it down";
        3. by itself, if nothing was said right before it;
        4. the rest of the last command, heard with it in one, or joined to its text: "turn left" ... "ninety degrees";
        5. by itself, after a command; if that is nothing to do, it may still take the command back.
        """
        heard, alone = utterance.result, utterance.alone
        assert heard is not None
        said = self._before(utterance)
        meaning = self._judge.meaning(heard, state, last if said is None or alone is None else said.last)
        if (stop := self._still_stopping(utterance, heard, meaning, state)) is not None:
            return Understood(heard, stop, Step(stop.actions))
        own, by_itself = (heard, meaning) if alone is None else (alone, self._judge.meaning(alone, state, last))
        if (whole := self._done_already(utterance, own, by_itself, state)) is not None:
            return Understood(own, whole, Step((), goes_on=True))
        if alone is None:
            return Understood(heard, meaning, self._by_itself(said, utterance, heard, meaning, state))
        too_late = False
        if said is not None:
            exact = self._follow_up.together(said.command.meaning.text, alone, state, said.last)
            done = said.command.meaning
            another = by_itself.status is Status.ACCEPTED or self._lacks_wake_word(said, utterance, alone, state)
            together = begun_alike(lambda text: self._follow_up.text(text, heard, state, said.last), done, meaning)
            for transcript, whole in ((heard, together), (alone, exact)):
                step = said.command.step_to(whole) if whole is not None else None
                if whole is not None and step is not None and self._belongs(said, step, whole, alone, another=another):
                    return Understood(transcript, whole, step)
                too_late = too_late or (whole is not None and step is None and said.command.says_more(whole))
        meaning = by_itself
        withdrawn = False
        if said is not None and (meaning.status is not Status.ACCEPTED or meaning.objects):
            withdrawn = self._follow_up.corrects(alone) or self._follow_up.ends_in_correction(heard)
            if withdrawn or len(alone.free_text.split()) <= HARDLY_A_SENTENCE:
                # "No", and a moment later "the dock".
                taken_back = withdrawn or said.withdrawn
                sound, ended = utterance.said(), utterance.last_voice
                self._said = replace(said, sound=sound, ended=ended, heard="", withdrawn=taken_back)
            if withdrawn:
                refused = Interpretation(meaning.text, Status.REJECTED) if meaning.objects else meaning
                meaning = replace(refused, reason=_WITHDRAWN)
            elif too_late:
                meaning = replace(meaning, reason=_TOO_LATE.format(said.command.meaning.text))
            elif self._follow_up.besides_or_instead(said.command.meaning, alone, state, said.last):
                meaning = replace(meaning, reason=_BESIDES_OR_INSTEAD.format(alone.free_text))
        return Understood(alone, meaning, self._by_itself(said, utterance, alone, meaning, state), withdrawn)

    def _still_stopping(
        self, utterance: SpokenUtterance, heard: Transcript, meaning: Interpretation, state: Collection[str]
    ) -> Interpretation | None:
        """The stop of which an utterance is the end of the sentence; None: it is none."""
        if self._stopped is None or meaning.status is not Status.ACCEPTED or meaning.stops:
            return None
        stop, ended = self._stopped
        if utterance.began - ended > ONE_SENTENCE:
            return None
        return self._follow_up.stop_going_on(stop, heard, state)

    def _done_already(
        self, utterance: SpokenUtterance, heard: Transcript, by_itself: Interpretation, state: Collection[str]
    ) -> Interpretation | None:
        """The sentence of the grammar that a command makes with the one before, if that was all of it: the volume is
        turned down once for "too loud ... turn it down". None: it makes none, or there is more to do."""
        said = self._said
        if said is None or said.withdrawn or utterance.began - said.ended > ONE_SENTENCE:
            return None
        if by_itself.status is not Status.ACCEPTED or by_itself.stops:
            return None
        done = said.command.meaning
        ways = (
            self._follow_up.one_sentence(begun, heard, state)
            for begun in dict.fromkeys((done.text, said.heard))
            if begun
        )
        return next((whole for whole in ways if whole is not None and whole.actions == done.actions), None)

    def _belongs(self, said: _Said, step: Step, whole: Interpretation, alone: Transcript, *, another: bool) -> bool:
        """Whether what was heard together with the command before is what was meant: not if what is more of it is
        another command by itself, nor if the words began with a "no", or came after one, and take nothing back."""
        if another and step.amends is None:
            return False
        return whole.corrected or not (said.withdrawn or self._follow_up.corrects(alone))

    def _lacks_wake_word(
        self, said: _Said, utterance: SpokenUtterance, alone: Transcript, state: Collection[str]
    ) -> bool:
        """Whether an utterance is a command without its wake word, and that of the command before is not meant for it
        too, as in one breath or with an "and then" it is."""
        if utterance.began - said.ended <= ONE_BREATH or self._follow_up.comes_after(alone):
            return False
        return self._follow_up.lacks_wake_word(alone, state)

    def _by_itself(
        self,
        said: _Said | None,
        utterance: SpokenUtterance,
        heard: Transcript,
        meaning: Interpretation,
        state: Collection[str],
    ) -> Step:
        """What is to be done of a command by itself. After the one before, if it begins with "and then", or both were
        said in one breath and are two commands in a row ("turn left, go forward"). After whatever is being done,
        however long ago that was said, if it says so: "when you get there, turn left"."""
        if meaning.status is not Status.ACCEPTED or meaning.stops:
            return Step(meaning.actions)
        in_turn = MOVING in state and self._follow_up.comes_later(heard)
        if said is not None and not in_turn:
            before = said.command.meaning
            both = in_a_row(lambda text: self._follow_up.text(text, heard, state, said.last), before, meaning)
            soon = utterance.began - said.ended <= ONE_BREATH
            in_turn = self._follow_up.comes_after(heard) or (soon and both is not None)
        return Step(meaning.actions, Policy.FOLLOW if in_turn else None)

    def _before(self, utterance: SpokenUtterance) -> _Said | None:
        """The command that an utterance may belong to."""
        said = self._said
        if said is None or not self.on or utterance.began - said.ended > self._within:
            return None
        return said if said.withdrawn or said.command.under_way else None
