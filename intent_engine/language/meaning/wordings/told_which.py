"""A thing of which it is told behind a pause which one is meant: "grab the flask, the blue one" is "grab the blue
flask"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.meaning.command import Commands
from intent_engine.language.reading import Reading
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.thing_words import thing_words

__all__ = ["ToldWhich"]


class ToldWhich:
    """Reads it with its noun. Where which one was said already, "the red flask, the blue one" may be another, or both.

    Args:
        commands: of the grammar.
    """

    def __init__(self, commands: Commands) -> None:
        self._commands = commands
        self._one_words = commands.matcher.grammar.wording.standing_for
        self._articles = thing_words(commands.matcher.grammar.language).articles
        self.rules = ((self.told, self.is_meant),)
        """It as one of those that put what was said otherwise."""

    def told(self, said: Utterance, language: str) -> Utterance | None:
        """The command with its thing told in full; None: it is none, or not clear."""
        del language
        parts = self._parts(said)
        if parts is None:
            return None
        before, which = parts
        found: dict[object, Utterance] = {}
        for at in (place for place, word in enumerate(before.words) if word in self._articles):
            way = before.with_other(at + 1, at + 1, which)
            clause = self._commands.exact(way.words, (), breaks=way.breaks)
            if clause is not None and clause.accepted:
                found.setdefault(clause.action, way)
        return next(iter(found.values())) if len(found) == 1 else None

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
        """The command, and which one is meant of its thing; None: that is not told, or was told before."""
        if not said.words or said.words[-1] not in self._one_words:
            return None
        pause = next((at for at in range(len(said) - 1, 0, -1) if said.breaks[at]), 0)
        which = said.words[pause + 1 : -1]
        if not (pause and which) or said.words[pause] not in self._articles or set(said.words[:pause]) & set(which):
            return None
        return said.part(0, pause), Utterance.in_one_breath(which)
