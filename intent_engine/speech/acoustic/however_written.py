"""How clearly a model heard what it wrote, however it might have written it: "Turn 10 degrees", "turn ten degrees".

The probability of a piece is divided among the ways to write one word. Of a clear "go back two meters" a model may give
0.4 to "Go" and as much to "go", 0.4 to "2" and a quarter to "two", and a third each to a full stop, an exclamation mark
and none: as it is written it seems to be in doubt.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from intent_engine.language.numbers.spelled import in_digits, in_words
from intent_engine.speech.acoustic.rows import Rows, total

__all__ = ["HoweverWritten"]


class HoweverWritten:
    """The pieces of one tokenizer that write the same.

    Args:
        tokenizer: with ``encode`` and ``decode``, as faster-whisper's.
        language: of the words.
    """

    def __init__(self, tokenizer: Any, language: str | None = None) -> None:
        self._tokenizer = tokenizer
        self._language = language
        self._same: dict[int, list[int]] = {}

    def clearness(self, rows: Rows) -> float:
        """Mean log probability of the words' pieces that were heard freely, whichever way they are written; signs are
        left out. Minus infinity, if that is not known, or there are none."""
        heard = max(rows, key=len, default=())
        found: list[float] = []
        for place, piece in enumerate(heard):
            if not (same := self.same(piece)):
                continue
            row = rows.get(heard[:place])
            if row is None:
                return -math.inf
            found.append(float(np.logaddexp.reduce(row[same])) - total(row))
        return sum(found) / len(found) if found else -math.inf

    def same(self, piece: int) -> list[int]:
        """A piece, with those that write the same word or part of one; nothing for a sign."""
        if piece not in self._same:
            self._same[piece] = self._alike(piece)
        return self._same[piece]

    def _alike(self, piece: int) -> list[int]:
        text: str = self._tokenizer.decode([piece])
        word = text.strip()
        if not any(map(str.isalnum, word)):
            return []
        blank = text[: len(text) - len(text.lstrip())]
        plain = word.lower()
        numbers = in_words([plain], self._language), in_digits([plain], self._language)
        in_one = (one for one in numbers if len(one) == 1)  # "21" is two words
        ways = {way for one in (plain, *(only for (only,) in in_one)) for way in (one, one.capitalize(), one.upper())}
        written = (self._tokenizer.encode(blank + way) for way in sorted(ways))
        return sorted({piece, *(pieces[0] for pieces in written if len(pieces) == 1)})
