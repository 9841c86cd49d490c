"""Where an utterance denies something."""

from __future__ import annotations

from intent_engine.language.meaning.phrases import Phrases
from intent_engine.language.utterance import Utterance
from intent_engine.language.wording import Wording

__all__ = ["WhereDenied"]


class WhereDenied:
    """Finds the first negation that denies."""

    def __init__(self, phrases: Phrases, wording: Wording) -> None:
        self._phrases = phrases
        self._negation = phrases.negation
        self._perceives_none = wording.perceives_none
        self._why = wording.why_apart

    def first(self, core: Utterance) -> tuple[int, int] | None:
        """(position, length) of the first negation that is no correction, nor a part of one: "no espera" corrects,
        where "no" negates; "no no" may be either, and so negates. Spanish "no" corrects between two pauses, and at the
        beginning before one: "a la izquierda, no, a la derecha", "no, ve al bar". Nor is it a part of what tells why:
        "on n'entend rien"."""
        words = core.words
        position = 0
        while position < len(words):
            if told := self._tells_of_nothing(core, position):
                position += told
                continue
            length = self._negation.at(words, position)
            corrects = self._phrases.correction.at(words, position)
            if corrects > length and not all(
                self._negation.at([word], 0) for word in words[position : position + corrects]
            ):
                position += corrects
            elif parted := self._correction_apart(core, position):
                position += parted
            elif length:
                return position, length
            else:
                position += 1
        return None

    def _tells_of_nothing(self, core: Utterance, position: int) -> int:
        """Length of what tells behind a pause, or at the beginning, that nothing is seen or heard; 0: nothing does."""
        if position and not core.breaks[position]:
            return 0
        why = self._why.at(core.words, position)
        told = self._perceives_none.at(core.words, position + why)
        return why + told if told else 0

    def _correction_apart(self, core: Utterance, position: int) -> int:
        """Length of the words of correction at a place, said in one breath between two pauses; 0: there are none.
        Before the first word of all needs to be no pause, and behind them something must follow."""
        if position and not core.breaks[position]:
            return 0
        for length in self._phrases.correction.lengths_at(core.words, position):
            end = position + length
            if end < len(core) and core.breaks[end] and True not in core.breaks[position + 1 : end]:
                return length
        return 0
