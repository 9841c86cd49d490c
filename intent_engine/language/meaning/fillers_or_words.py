"""Fillers that may be words of a command, as "right" and "hey" are: with them, without them, or nobody knows."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from intent_engine.interpretation import Interpretation, Status
from intent_engine.language.meaning.clause import Clause, described
from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.meaning.told import Understood, as_told_together
from intent_engine.language.utterance import Utterance

__all__ = ["FillersOrWords"]

_TWO_THINGS = "it could mean two things"


class FillersOrWords:
    """What an utterance means that has fillers in it.

    Args:
        phrases: of the grammar.
        commands: of the grammar.
        meant: what an utterance means in a state of the robot, with the text that it was said in.
    """

    def __init__(
        self,
        phrases: Phrases,
        commands: Commands,
        meant: Callable[[str, Utterance, Collection[str]], Understood],
    ) -> None:
        self._phrases = phrases
        self._commands = commands
        self._meant = meant
        self._stop_intent = commands.matcher.grammar.stop_intent

    def besides(self, said: Utterance, core: Utterance, state: Collection[str]) -> Clause | None:
        """What an utterance says besides its fillers, exactly; None: nothing, or it is no single command.

        Args:
            said: all words, with the fillers.
            core: those without.
            state: of the robot.
        """
        phrases = self._phrases
        kept, clause = core, self._exact(core, state)
        if clause is None:  # "uh, again": some fillers are sentences as well, or parts of one
            kept = phrases.without_idle_fillers(said)
            clause = self._exact(kept, state)
        if clause is None:  # "robot, wait for me here", of which both are
            kept = phrases.without_opening(said)
            clause = self._exact(kept, state)
        if clause is None:  # "light hey on", of a grammar that has free names besides
            kept = phrases.without_greetings(said)
            clause = self._exact(kept, state)
            if clause is not None and clause.reading is not None and clause.reading.free_words:
                clause = None  # "say thank you to everybody here", of a slot that has not so many words
        less = phrases.without_whole_fillers(said)
        if not core.words or len(less) == len(core):
            return clause
        other = self._exact(less, state)
        if other is None or not other.accepted or (other.reading and phrases.cuts_a_filler(said, other.reading)):
            return clause
        if clause is None or not clause.accepted or clause.reading is None or other.reading is None:
            return other
        if clause.action == other.action or clause.reading.free_words < other.reading.free_words:
            return clause
        if not set(kept.words) <= set(less.words):
            return clause  # "slightly more right now" has a "more" that no "slightly right" has
        meanings = (described(clause.reading), described(other.reading))
        return Clause(clause.reading, reason=_TWO_THINGS, alternatives=meanings, ambiguous=True)

    def listed(self, text: str, said: Utterance, state: Collection[str]) -> Understood | None:
        """ "right then left": two commands. "right then turn left", "right, turn left": two, or one after a word that
        says nothing. Nobody knows, so nothing is done. None: no command follows, or a stop."""
        if (parted := self._phrases.or_commands.as_a_list(said)) is None:
            return None
        first, rest = parted
        before = self._commands.exact(first, state)
        found, parts = self._meant(text, rest, state)
        if not found.actions:  # behind a joint some sentences are none: "turn left go forward", "drop it"
            without = rest.part(self._phrases.goes_on(rest.words), len(rest))
            if self._phrases.or_commands.as_a_list(without) is not None:
                return found, parts  # "right then right then ...": a list, whatever opens it
            found, parts = self._meant(text, without, state)
        if before is None or before.reading is None or not before.accepted or not parts or not found.actions:
            return None
        begins = parts[0].reading
        if begins is not None and not self._commands.opens_with_a_verb(begins):
            return as_told_together(text, [before, *parts], self._stop_intent)
        after = _in_order(parts)
        clearer = "in a whole sentence" if rest.breaks[0] else "with a pause"
        reason = f"{' '.join(first)!r} may be a command, or say nothing here; say it {clearer}"
        either = (f"{described(before.reading)}, then {after}", after)
        return Interpretation(text, Status.AMBIGUOUS, alternatives=either, reason=reason), ()

    def or_either(self, text: str, meant: Understood, other: Utterance, state: Collection[str]) -> Understood:
        """What was meant, unless the same command in other words is another: a filler may have taken the "right" of
        "turn right away ninety degrees". Nobody knows, so nothing is done."""
        found = self._meant(text, other, state)
        alike = len(found[0].actions) == len(meant[0].actions) and not (found[0].stops or meant[0].stops)
        if not alike or found[0].actions == meant[0].actions:
            return meant
        meanings = (_in_order(meant[1]), _in_order(found[1]))
        return Interpretation(text, Status.AMBIGUOUS, alternatives=meanings, reason=_TWO_THINGS), ()

    def _exact(self, said: Utterance, state: Collection[str]) -> Clause | None:
        return self._commands.exact(said.words, state, breaks=said.breaks)


def _in_order(parts: Sequence[Clause]) -> str:
    """Commands in a row as they are asked about."""
    return ", then ".join(described(part.reading) for part in parts if part.reading is not None)
