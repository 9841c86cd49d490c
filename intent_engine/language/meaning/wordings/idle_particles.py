"""What belongs to a verb and says no more than it: "heat *up* the flask", "fill the glass *up* to ten percent"."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from intent_engine.language.grammar import Grammar
from intent_engine.language.meaning.wordings.rewording import Rewording
from intent_engine.language.utterance import Utterance

__all__ = ["IdleParticles"]


class IdleParticles:
    """Reads an utterance without it, of a grammar that has the verb alone."""

    def __init__(self, grammar: Grammar) -> None:
        self._idle = grammar.wording.idle_particles

    def ways(self, core: Utterance) -> Iterator[Rewording]:
        """Without each one that stands behind its verb, up to a pause or the next such verb."""
        words, breaks = core.words, core.breaks
        verbs = [at for at, word in enumerate(words) if word in self._idle]
        for verb, next_verb in pairwise([*verbs, len(words)]):
            end = next((at for at in range(verb + 1, next_verb) if breaks[at]), next_verb)
            for at in range(verb + 1, end):
                if words[at] in self._idle[words[verb]]:
                    yield Rewording(core.cut(at, at + 1))
