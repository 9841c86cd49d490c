"""What is wanted after "never mind" and a pause, with or without commands before: "turn left, never mind, go back"."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.compound import Compounds
from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance

__all__ = ["Cancelled"]


class Cancelled:
    """Where an utterance goes on behind words that cancel what stands before them."""

    def __init__(self, phrases: Phrases, commands: Commands, compounds: Compounds) -> None:
        self._phrases = phrases
        self._commands = commands
        self._compounds = compounds

    def after(self, core: Utterance, state: Collection[str]) -> int:
        """The word with which begins what is wanted, behind words that cancel, and a pause. 0: there are none."""
        if not self._phrases.cancel.may_stand_in(core.words):
            return 0
        begins = self._phrases.after_cancelled(core)
        if begins and not self._does_something(core.words[:begins], state):
            return begins
        return self._after_commands(core, state)

    def _after_commands(self, core: Utterance, state: Collection[str]) -> int:
        """The same where something was said before that is taken back. 0 also if not all of that is a command or the
        beginning of one: "he says, never mind, go back".

        Without a pause before them it must be whole: "tell Anna never mind, go back" may be told to Anna. Words that
        are a command themselves cancel nothing ("drop it"), and those that correct as well are corrections.
        """
        cancel, correction = self._phrases.cancel, self._phrases.correction
        for at in range(len(core) - 2, 0, -1):
            for length in cancel.lengths_at(core.words, at):
                end, words = at + length, core.words[at : at + length]
                if end >= len(core) or not core.breaks[end] or self._phrases.negation.at(core.words, end - 1):
                    continue
                if correction.at(words, 0) == length or self._does_something(words, state):
                    continue
                return end if self._is_taken_back(core.part(0, at), state, begun=bool(core.breaks[at])) else 0
        return 0

    def _does_something(self, words: list[str], state: Collection[str]) -> bool:
        """Whether words that cancel are a command of the grammar, but for one that stops."""
        clause = self._commands.exact(words, state)
        if clause is None or not clause.accepted or clause.reading is None:
            return False
        return clause.reading.intent.action.type != "stop"

    def _is_taken_back(self, part: Utterance, state: Collection[str], *, begun: bool) -> bool:
        """Whether a part is commands; or, if it is enough that they were begun, how commands begin."""
        last = (self._phrases.correction, self._phrases.sequence, self._phrases.cancel)
        while length := max(phrases.ends(part.words) for phrases in last):  # "turn left, no, never mind, go back"
            end = len(part) - length
            part, begun = part.part(0, end), begun or bool(part.breaks[end])
        if not part.words:
            return True
        if begun and self._commands.matcher.prefix(part.words)[1] is not None:
            return True
        if after := self.after(part, state):  # "turn left, never mind, turn right, never mind, go back"
            return self._is_taken_back(part.part(after, len(part)), state, begun=begun)
        clause = self._compounds.part(part, state)
        return (clause is not None and clause.accepted) or self._compounds.split(part, state) is not None
