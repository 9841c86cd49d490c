"""Negations that only name what is not meant by a part of a command: "turn left, *not* right", "*nicht* den Bohrer,
nimm den Taster"."""

from __future__ import annotations

from collections.abc import Sequence

from intent_engine.language.utterance import Utterance
from intent_engine.language.wording import Wording

__all__ = ["Excluding"]


class Excluding:
    """Tells them by where they stand."""

    def __init__(self, wording: Wording) -> None:
        self._anywhere = wording.excludes
        self._apart = wording.excludes_apart
        # A "non" may be a "no" as it was heard, which corrects: there a joint has to part the one from the other.
        self._behind_a_pause = frozenset() if wording.may_forbid else wording.excludes_apart

    def before(self, negation: Sequence[str]) -> bool:
        """Whether one does that before a whole command."""
        return tuple(negation) in self._anywhere or tuple(negation) in self._apart

    def behind(self, core: Utterance, position: int, length: int) -> bool:
        """Whether one does that behind what is said: in one breath with what it names. "Y no, a la izquierda" corrects,
        and "mach das Licht an, nicht, äh" breaks off."""
        if True in core.breaks[position + 1 : position + length + 1]:
            return False
        negation = tuple(core.words[position : position + length])
        return negation in self._anywhere or (core.breaks[position] is True and negation in self._behind_a_pause)
