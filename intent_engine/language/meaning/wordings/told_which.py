"""A thing of which it is told behind a pause which one is meant: "grab the flask, the blue one" is "grab the blue
flask"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.meaning.command import Commands
from intent_engine.language.meaning.corrections.replacement import Replacements
from intent_engine.language.meaning.corrections.stand_ins import StandIns
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance

__all__ = ["ToldWhich"]


class ToldWhich:
    """Reads it with its noun. Where which one was said already, "the red flask, the blue one" may be another, or both.

    Args:
        commands: of the grammar.
    """

    def __init__(self, commands: Commands) -> None:
        self._commands = commands
        self._one_words = commands.matcher.grammar.wording.standing_for
        self._stand_ins = StandIns(commands, Replacements(commands))
        self.rules = ((self.told, self.is_meant),)
        """It as one of those that put what was said otherwise."""

    def told(self, said: Utterance, language: str) -> Utterance | None:
        """The command with its thing told in full; None: it is none, or not clear."""
        del language
        parts = self._parts(said)
        if parts is None or not self._stand_ins.stands_last(*parts):
            return None
        return self._stand_ins.replaced(*parts, ())

    def is_meant(self, said: Utterance, readings: Sequence[Reading], language: str) -> bool:
        """Whether nothing is said of the command but which one, of which it said nothing before."""
        del language
        parts = self._parts(said)
        before = self._commands.likeliest(parts[0].words) if parts is not None else None
        if before is None or before.problem or len(readings) != 1 or readings[0].free_words:
            return False
        old, new = before.values(), readings[0].values()
        same = all(label in new and new[label] == value for label, value in old.items())
        return before.intent is readings[0].intent and same and len(new) == len(old) + 1

    def _parts(self, said: Utterance) -> tuple[Utterance, Utterance] | None:
        if not said.words or said.words[-1] not in self._one_words:
            return None
        pause = next((at for at in range(len(said) - 1, 0, -1) if said.breaks[at]), 0)
        return (said.part(0, pause), said.part(pause, len(said))) if pause else None
