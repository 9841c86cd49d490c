"""Words that no rule understood: what is told to who said them, so that it can be said otherwise."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import partial
from typing import TYPE_CHECKING

from intent_engine.interpretation import Cause, Interpretation, Question, Status
from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.not_commands.one_of_a_range import one_of_a_range
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.steps import Kind, step
from intent_engine.language.meaning.told import Understood, as_told, asked_back
from intent_engine.language.slots.called_by_number import in_order
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

if TYPE_CHECKING:
    from intent_engine.language.networks.nearest import Nearest

__all__ = ["NoCommand"]

MOST_FOLLOWING = 8
"""Words that are told of those with which an unfinished sentence may go on."""
_NOTHING = frozenset((Cause.NO_COMMAND,))
_NO_COMMAND = "not a command of this grammar"


class NoCommand:
    """Why words are no command: the sentence is not finished, one part of it is wrong, or nothing is known of it but
    which sentences are near."""

    def __init__(
        self, phrases: Phrases, commands: Commands, compounds: Compounds, corrections: Corrections, nearest: Nearest
    ) -> None:
        self._phrases = phrases
        self._commands = commands
        self._matcher = commands.matcher
        self._things = thing_words(commands.matcher.grammar.language)
        self._compounds = compounds
        self._corrections = corrections
        self._nearest = nearest

    @step(Kind.OTHERWISE)
    def told(self, text: str, core: Utterance, state: Collection[str], clause: Clause | None) -> Understood:
        """An interpretation without an action, with the reason that helps most.

        Args:
            text: what was said or typed.
            core: its words, without fillers.
            state: of the robot.
            clause: what came nearest to a command, if anything did.
        """
        words = core.words
        if "?" not in text and (choices := self._compounds.at_once.one_of(core, state)):
            names, sentences = zip(*choices, strict=True)
            reason = f"one of them is meant; say which: {' or '.join(names)}"
            asked = Question(sentences)
            return Interpretation(text, Status.REJECTED, reason=reason, alternatives=names, question=asked), ()
        if "?" not in text and (asked_of_one := self._by_number(text, core, state)) is not None:
            return asked_of_one, ()
        manner = self._manner(words, state)
        told = clause is not None and (clause.ambiguous or manner in clause.at_fault)
        if manner and not told:
            reason = f"{manner!r} says how it is done, and this command has no word for that; say it without"
            return Interpretation(text, Status.REJECTED, reason=reason), ()
        if (clause is None or not clause.ambiguous) and (reason := self._range(words, state)):
            return Interpretation(text, Status.REJECTED, reason=reason), ()
        if not self._phrases.change_meaning(words) and not (clause is not None and clause.ambiguous):
            # Before what a name is not: "go to the" is unfinished, not a place called "the".
            automaton = self._matcher.spoken
            _, reached = self._matcher.prefix(words)
            # A place that is not on the map is not the beginning of a thing: "bring me to the library".
            a_place = clause is not None and clause.unknown_place and reached is not None and automaton.free(reached)
            if reached is not None and not automaton.accepting(reached) and not a_place:
                from intent_engine.language.networks.likely_words import likely_words

                following = likely_words(self._matcher, words, most=MOST_FOLLOWING)
                reason = "the sentence is not finished"
                asked = Question(beginning=text)
                return Interpretation(
                    text, Status.INCOMPLETE, reason=reason, alternatives=following, question=asked
                ), ()
        if clause is not None:
            return as_told(text, clause)
        are_several = partial(self._are_several, state=state)
        if self._corrections.may_stand_in(words) and (meant := self._corrections.unclear(core, state, are_several)):
            reason = f"it is not clear what {' '.join(meant)!r} takes the place of; say the whole command again"
            return Interpretation(text, Status.REJECTED, reason=reason), ()
        failing = self._compounds.failing(core, state)
        if failing is not None:
            return self._not_all(text, *failing)
        near = self._nearest.sentences(words)
        which = None if self._phrases.change_meaning(words) else _which_sentence(near)
        found = Interpretation(text, Status.REJECTED, None, {}, (), 0.0, near, _NO_COMMAND, _NOTHING, question=which)
        return found, ()

    def _are_several(self, said: Utterance, state: Collection[str]) -> bool:
        parts = self._compounds.split(said, state)
        return parts is not None and parts[0].accepted

    def _by_number(self, text: str, core: Utterance, state: Collection[str]) -> Interpretation | None:
        """What asks about "the third drawer", where drawers are told apart by their numbers: the third in a row need
        not be drawer 3. None: there is nothing to ask."""
        language = self._matcher.grammar.language
        one = in_order(core, language)
        if one is None:
            return None
        for meant in one.meant:
            clause = self._commands.exact(meant.words, state, breaks=meant.breaks)
            parts = [clause] if clause is not None and clause.accepted else self._compounds.split(meant, state) or []
            readings = [part.reading for part in parts if part.accepted and part.reading is not None]
            if len(readings) == len(parts) and one.is_named(readings, language):
                text_meant = " ".join(meant.words)
                reason = f"{one.said!r} may be '{one.noun} {one.number}', or not; say the number"
                asked = Question((text_meant,))
                return Interpretation(text, Status.REJECTED, reason=reason, alternatives=(text_meant,), question=asked)
        return None

    def _manner(self, words: Sequence[str], state: Collection[str]) -> str:
        """The word that says how something is to be done that would be a command without it: "slowly drive to the
        kitchen". Done as it always is it would not be what was said. Empty: there is none."""
        return next(
            (
                word
                for place, word in enumerate(words)
                if self._things.is_manner(word) and self._commands.accepts([*words[:place], *words[place + 1 :]], state)
            ),
            "",
        )

    def _range(self, words: Sequence[str], state: Collection[str]) -> str:
        language = self._matcher.grammar.language
        return one_of_a_range(words, self._things.ranging, language, lambda said: self._commands.accepts(said, state))

    def _not_all(self, text: str, part: Utterance, clause: Clause | None) -> Understood:
        """One part of what was said is no command, so nothing of it is done."""
        said = " ".join(part.words)
        asked = None if clause is None else asked_back(text, clause)
        if clause is not None and clause.reason:
            near, reason, causes = clause.alternatives, f"in {said!r}: {clause.reason}", clause.causes
        else:
            near, reason, causes = self._nearest.sentences(part.words), f"{said!r} is {_NO_COMMAND}", _NOTHING
        return Interpretation(text, Status.REJECTED, None, {}, (), 0.0, near, reason, causes, question=asked), ()


def _which_sentence(near: Collection[str]) -> Question | None:
    """What is asked about sentences that are near; one with a slot, that has no value yet, is none to choose."""
    choices = tuple("" if "{" in one or "<" in one else one for one in near)
    return Question(choices) if any(choices) else None
