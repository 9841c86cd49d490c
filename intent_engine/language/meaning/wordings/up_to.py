"""Which way something goes until it is so much: "heat the flask *up* to eighty degrees", "set the speed *down* to ten
percent", "zoom *in* to a half"."""

from __future__ import annotations

from collections.abc import Iterator

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.amounts_read import AMOUNTS, Begins
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.utterance import Utterance

__all__ = ["UpTo"]

_LEVELS = frozenset({"percent", "speed", "angular_speed", "number"})
"""What goes up and down, whatever it is of."""
_MOST = 4
"""Words behind "to" of which one begins the amount: "to a level of ten percent"."""


class UpTo:
    """Reads an utterance without the way, which the amount tells."""

    def __init__(self, grammar: Grammar) -> None:
        wording = grammar.wording
        self._to = wording.ways_to
        self._up = wording.up_to
        self._ways = wording.up_to | wording.in_to
        self._back = {words[0] for words in wording.ways_back if len(words) == 1}
        self._idle = wording.idle_particles
        self._own = wording.particles

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without each of them."""
        words = core.words
        for at in range(1, len(words) - 2):
            if words[at + 1] not in self._to or any(core.breaks[at : at + 2]):
                continue
            if kinds := self._goes(words[0], words[at]):
                start = at - (at > 1 and words[at - 1] in self._back)  # "back down to"
                yield Rewording(core.cut(start, at + 1), Begins(words[at + 2 : at + 2 + _MOST], kinds))

    def _goes(self, verb: str, way: str) -> frozenset[str]:
        """Of which amounts a way says no more behind a verb than "to" does. "Raise the boom *down* to a meter" says two
        things, and "turn the camera *down* to thirty degrees" may be about another angle."""
        idle = self._ways & self._idle.get(verb, frozenset())
        own = self._ways & self._own.get(verb, frozenset())
        if way in idle or way in self._back:
            return AMOUNTS
        if idle:
            return frozenset()
        if own:
            return _LEVELS if way in own else frozenset()
        return AMOUNTS if way in self._up else frozenset()
