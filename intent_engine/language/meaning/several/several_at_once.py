"""One sentence that is several commands without saying each: lists of numbers, one verb for several things, and lists
that were corrected."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.language.meaning.clause import Clause
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.corrected_lists import CorrectedLists
from intent_engine.language.meaning.corrections.correction import Corrections
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.several.listed_numbers import ListedNumbers
from intent_engine.language.meaning.several.shared_verb import SharedVerb
from intent_engine.language.meaning.several.verbs_of_one_thing import VerbsOfOneThing
from intent_engine.language.utterance import Utterance

__all__ = ["SeveralAtOnce"]

_BOTH = 2


class SeveralAtOnce:
    """The commands of such a sentence."""

    def __init__(self, phrases: Phrases, commands: Commands, corrections: Corrections) -> None:
        self._lists = ListedNumbers(phrases, commands)
        self._shared_verb = SharedVerb(phrases, commands, self._lists)
        self._verbs = VerbsOfOneThing(phrases, commands, self._lists)
        self._corrected = CorrectedLists(phrases, commands, corrections)
        wording = commands.matcher.grammar.wording
        self._for_each, self._both_of = wording.for_each, wording.both_of

    def verb_may_be_shared(self, core: Utterance) -> bool:
        """A quick look: whether one verb may be said of several things, or several of one."""
        return self._shared_verb.may_stand_in(core) or self._verbs.may_stand_in(core)

    def one_of(self, core: Utterance, state: Collection[str]) -> list[tuple[str, str]]:
        """What is said of each thing of which one is meant, and the whole command with it: "unlock drawer 13 or 30".
        Empty: there are none."""
        return self._shared_verb.one_of(core, state)

    def each(self, part: Utterance, state: Collection[str], after: str, *, shared: bool) -> list[Clause]:
        """The commands; or the one clause that is not accepted, since one of them cannot be done or it is not clear
        what is meant. Empty: there are none.

        Args:
            part: of an utterance, which is no command by itself.
            state: of the robot.
            after: the intent that it goes on from; empty: it is a command by itself.
            shared: whether one verb may be said of several things.
        """

        def listed(words: Utterance, of_each: bool = False) -> list[Clause]:
            found = self._lists.each(words, state, after, of_each=of_each)
            if found is None and shared:
                found = self._shared_verb.each(words, state, of_each=of_each) or self._verbs.each(words, state)
            return found or []

        if (each := self._for_each.find(part.words, 1)) is not None:
            start, length = each
            return listed(part.cut(start, start + length), of_each=True)
        if shared and (both := self._both_of.find(part.words, 1)) is not None:
            start, length = both
            found = listed(part.cut(start, start + length))
            return found if len(found) == _BOTH or not all(clause.accepted for clause in found) else []
        return self._corrected.each(part, state, listed) or listed(part)
