"""Why something is to be done, told behind it: "turn the lamp on, it's getting dark"."""

from __future__ import annotations

from collections.abc import Collection

from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.wording import Wording
from intent_engine.language.words.phrase_set import PhraseSet

__all__ = ["Reasons"]

_MOST = 4
"""Words of such a reason, behind those that it begins with."""


class Reasons:
    """Reads the command without its reason. It stands behind a pause and the command, and has nothing of another one,
    or of a condition ("it is dark *when* you leave")."""

    def __init__(self, wording: Wording, phrases: Phrases, closed: Collection[str]) -> None:
        self._begins = PhraseSet(wording.reasons)
        self._phrases = phrases
        self._closed = frozenset(closed)

    def without(self, core: Utterance, verbs: Collection[str]) -> Utterance | None:
        """The command; None: no reason is behind it."""
        pause = next((at for at in range(len(core) - 1, 0, -1) if core.breaks[at]), 0)
        told = core.words[pause:]
        begins = self._begins.at(told, 0)
        if not (pause and begins and begins < len(told) <= begins + _MOST):
            return None
        rest = told[begins:]
        if any(word in verbs or word in self._closed for word in rest):
            return None
        phrases = self._phrases
        others = (phrases.negation, phrases.sequence, phrases.correction, phrases.cancel, phrases.stop)
        return None if any(one.find(rest) for one in others) else core.part(0, pause)
