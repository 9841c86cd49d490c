"""How likely a stop phrase is being said, by what a model thinks of the first pieces of a text."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.moonshine import MoonshineModel, MoonshineRecognizer
from intent_engine.speech.acoustic.prefix_tree import Beginning
from intent_engine.speech.audio import Samples

__all__ = ["MoonshineStops", "StopPhrases"]

_Floats: TypeAlias = npt.NDArray[np.float32]

MAX_PIECES = 5
"""Of a phrase; longer ones are left to the recogniser."""
OPEN = 0.1
"""Probability of a beginning that is followed up; each costs as much again as the first piece."""
SURE = 0.5
"""Probability above which it need not be known better."""


class StopPhrases:
    """Stop phrases in the pieces of a model, in the ways that it writes them.

    Args:
        phrases: what stops the robot; none begins with another.
        leads: what may stand before a phrase of one word ("please", "robot").
        encode: the pieces of a text; one that begins with a blank begins with a word.
    """

    def __init__(
        self, phrases: Iterable[Sequence[str]], leads: Sequence[str], encode: Callable[[str], Sequence[int]]
    ) -> None:
        complete: set[Beginning] = set()
        for phrase, lead in product(phrases, ("", *leads)):
            if lead and len(phrase) > 1:
                continue
            said = " ".join([lead, *phrase] if lead else phrase)
            # Before a comma a sentence does not begin again: "Robot, stop".
            texts = {said, said.capitalize()}
            if lead:
                texts.add(f"{lead.capitalize()}, {' '.join(phrase)}")
            for text in texts:
                for spaced in (" " + text, text):
                    pieces = tuple(encode(spaced))
                    if len(pieces) <= MAX_PIECES:
                        complete.add(pieces)
        self._complete = frozenset(
            pieces for pieces in complete if not any(pieces[:length] in complete for length in range(1, len(pieces)))
        )
        onward: dict[Beginning, set[int]] = {}
        for pieces in self._complete:
            for length, piece in enumerate(pieces):
                onward.setdefault(pieces[:length], set()).add(piece)
        self._onward = {begun: sorted(following) for begun, following in onward.items()}

    def chance(self, after: Callable[[Beginning], _Floats], enough: float = SURE) -> float:
        """How likely a text begins with one of them.

        Args:
            after: the probability of every piece, ``(pieces,)``, after some.
            enough: probability from which it need not be known better.
        """
        total = 0.0
        begun: Beginning | None = ()
        chance = 1.0
        while begun is not None and total < enough:
            row = after(begun)
            ways = [((*begun, piece), chance * float(row[piece])) for piece in self._onward[begun]]
            total += sum(likely for way, likely in ways if way in self._complete)
            begun, chance = max(
                ((way, likely) for way, likely in ways if way not in self._complete and likely >= OPEN),
                key=lambda way: way[1],
                default=(None, 0.0),
            )
        return total


class MoonshineStops:
    """A Moonshine model that only listens for stop phrases. For one thread at a time.

    Args:
        model: is shared with whoever else uses it.
        phrases, leads: as for :class:`StopPhrases`.
    """

    def __init__(self, model: MoonshineModel, phrases: Iterable[Sequence[str]], leads: Sequence[str]) -> None:
        self._moonshine = MoonshineRecognizer(model)
        self._pieces = StopPhrases(phrases, leads, model.tokenizer.encode)

    def probability(self, samples: Samples) -> float:
        """How likely a stop phrase is being said, or has just been said, at the beginning of this sound."""
        encoded = self._moonshine.encode(samples)
        return self._pieces.chance(lambda begun: np.exp(self._moonshine.chances(encoded, begun)))
