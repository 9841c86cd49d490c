"""What a model thinks of every piece after every beginning of a text, each computed once for a sound.

Sentences of a grammar begin alike, and are asked about again and again: as likely ones, beside others, after a "don't".
So the beginnings of one sound are a tree, in which a piece knows those before it; only what is new is computed, all of
it in one call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from intent_engine.speech.acoustic.graph_writer import as_bytes
from intent_engine.speech.recognizer import Encoded

__all__ = ["Beginning", "Decoder", "PrefixTree", "RecentTrees"]

HIDDEN = -1e9
"""Added to how much a piece looks at another that does not come before it."""
AT_ONCE = 48
"""Pieces computed in one call: enough to fill the processor, and 10 MB of chances."""
ROOM = 256
"""Pieces for which there is room at first; it doubles."""
TREES = 2
"""Sounds of which it is kept what was asked: a sound, and the same with a longer input."""

Beginning: TypeAlias = tuple[int, ...]
_Floats: TypeAlias = npt.NDArray[np.float32]


class Decoder(Protocol):
    """A decoder in three graphs (:mod:`~intent_engine.speech.acoustic.decoder_graphs`), loaded into ONNX Runtime."""

    small: npt.NDArray[np.int8]
    """What pieces are, as bytes: ``(pieces, width)``,"""
    scales: npt.NDArray[np.float32]
    """by these: ``(pieces, 1)``."""
    listening: Any
    stepping: Any
    telling: Any

    def rows(self, pieces: Sequence[int], places: Sequence[int]) -> Mapping[str, _Floats]:
        """What a step is told of pieces at some places of their texts, from 0."""
        ...


class PrefixTree:
    """What a model thinks of one sound. For one thread at a time.

    Args:
        decoder: of the model.
        features: ``(sounds, width)``, from the encoder.
        prompt: pieces before every text.
        check: called before each call of the model; what it raises leaves the tree as it was.
    """

    def __init__(
        self,
        decoder: Decoder,
        features: _Floats,
        prompt: Sequence[int],
        check: Callable[[], object] = lambda: None,
    ) -> None:
        self._decoder = decoder
        self._check = check
        self.prompt = tuple(prompt)
        names = [output.name for output in decoder.listening.get_outputs()]
        self._heard = dict(zip(names, decoder.listening.run(None, {"features": features}), strict=True))
        width = decoder.small.shape[1]
        self._known = {
            f"{kind}_{layer}": np.empty((ROOM, width), np.float32)
            for layer in range(len(names) // 2)
            for kind in ("keys", "values")
        }
        """What every layer knows, a row for each piece."""
        self._thoughts = np.empty((ROOM, width), np.float32)
        self._totals = np.empty(ROOM, np.float32)
        self._number: dict[Beginning, int] = {}
        self._lines: list[list[int]] = []
        """For each piece those before it and itself."""

    def chances(self, beginnings: Iterable[Beginning]) -> dict[Beginning, _Floats]:
        """The log probability of every next piece, ``(pieces,)``, after some beginnings."""
        wanted = dict.fromkeys(beginnings)
        found = {whole[len(self.prompt) :]: row for whole, row in self._grow(wanted)}
        again = [one for one in wanted if one not in found]
        if again:
            numbers = [self._number[self.prompt + one] for one in again]
            rows, _ = self._decoder.telling.run(None, {"thoughts": self._thoughts[numbers]})
            found.update(zip(again, rows, strict=True))
        return {one: found[one] for one in wanted}

    def along(self, written: Beginning, ahead: Beginning) -> dict[Beginning, _Floats]:
        """The chances after a beginning, and after each of its pieces ahead, in one call."""
        return self.chances((*written, *ahead[:place]) for place in range(len(ahead) + 1))

    def onward(
        self, beginnings: Sequence[Beginning], length: int, end: int, further: int = 0
    ) -> Iterator[tuple[Beginning, _Floats]]:
        """The same after some beginnings, all that they begin with, and what the model would go on with.

        Args:
            beginnings: pieces that the text begins with; they may differ in length.
            length: pieces up to which the model may go on.
            end: the piece after which it does not.
            further: pieces that it goes on with at the most.

        Yields:
            (beginning, ``(pieces,)`` log probabilities).
        """
        ends = list(dict.fromkeys(beginnings))
        parts = list(dict.fromkeys(one[:place] for one in ends for place in range(len(one) + 1)))
        for times in range(further + 1):
            found = self.chances(parts)
            yield from found.items()
            onward = ((*one, int(found[one].argmax())) for one in ends if len(one) < length)
            parts = ends = [one for one in onward if one[-1] != end]
            if times == further or not ends:
                return

    def likelihood(self, pieces: Sequence[int]) -> _Floats:
        """Log probability of each piece of a text, ``(n,)``. What it begins with must be known."""
        return self._chance([self._number[self.prompt + tuple(pieces[:place])] for place in range(len(pieces))], pieces)

    def after(self, beginning: Sequence[int], pieces: Sequence[int]) -> _Floats:
        """Log probability of some pieces, ``(n,)``, each next after a beginning that is known."""
        return self._chance([self._number[self.prompt + tuple(beginning)]] * len(pieces), pieces)

    def _chance(self, numbers: Sequence[int], pieces: Sequence[int]) -> _Floats:
        """Log probability of each piece after one row. As the graph has it, by bytes: a product that is more exact than
        the total that is taken from it would make what is nearly sure likelier than sure."""
        rows, next_ = np.array(numbers, np.int64), np.array(pieces, np.int64)
        thoughts, scales = as_bytes(self._thoughts[rows])
        products = np.einsum("ij,ij->i", thoughts, self._decoder.small[next_], dtype=np.int32)
        likely: _Floats = products * (scales * self._decoder.scales[next_])[:, 0] - self._totals[rows]
        return likely

    def learn(self, texts: Iterable[Sequence[int]]) -> None:
        """Get to know what some texts begin with: all but the last piece of each."""
        for _ in self._grow(tuple(text[:-1]) for text in texts):
            pass

    def _grow(self, beginnings: Iterable[Beginning]) -> Iterator[tuple[Beginning, _Floats]]:
        """Compute what is new in some beginnings and in those that they begin with: (with the prompt, chances)."""
        fresh: dict[Beginning, None] = {}
        for whole in (self.prompt + beginning for beginning in beginnings):
            if whole not in self._number:
                parts = (whole[:length] for length in range(1, len(whole) + 1))
                fresh.update((part, None) for part in parts if part not in self._number)
        new = list(fresh)
        for start in range(0, len(new), AT_ONCE):
            some = new[start : start + AT_ONCE]
            yield from zip(some, self._step(some), strict=True)

    def _step(self, new: Sequence[Beginning]) -> _Floats:
        """Compute one piece each, the last of some beginnings of which all else is known or stands before them."""
        self._check()
        decoder, known = self._decoder, len(self._lines)
        all_ = known + len(new)
        while all_ > len(self._totals):
            self._known = {name: np.concatenate((one, np.empty_like(one))) for name, one in self._known.items()}
            self._thoughts = np.concatenate((self._thoughts, np.empty_like(self._thoughts)))
            self._totals = np.concatenate((self._totals, np.empty_like(self._totals)))
        number = {whole: known + row for row, whole in enumerate(new)}
        lines: list[list[int]] = []
        for row, whole in enumerate(new):
            before = whole[:-1]
            if before in number:
                line = lines[number[before] - known]
            else:
                line = self._lines[self._number[before]] if before else []
            lines.append([*line, known + row])
        # Of all that is known a step is told what comes before its pieces, which is little.
        earlier = sorted({one for line in lines for one in line if one < known})
        place = {one: at for at, one in enumerate([*earlier, *range(known, all_)])}
        hidden = np.full((len(new), len(place)), HIDDEN, np.float32)
        for row, line in enumerate(lines):
            hidden[row, [place[one] for one in line]] = 0.0
        rows = decoder.rows([whole[-1] for whole in new], [len(whole) - 1 for whole in new])
        told = {name: one[earlier] for name, one in self._known.items()}
        thoughts, *own = decoder.stepping.run(None, {**rows, "hidden": hidden, **self._heard, **told})
        chances, totals = decoder.telling.run(None, {"thoughts": thoughts})
        # Only now, since a call that fails must leave nothing half known.
        self._lines += lines
        self._number |= number
        self._thoughts[known:all_] = thoughts
        self._totals[known:all_] = totals[:, 0]
        for one, new_ in zip(self._known.values(), own, strict=True):
            one[known:all_] = new_
        found: _Floats = chances
        return found


class RecentTrees:
    """What is known of the last few sounds that were asked about."""

    def __init__(self) -> None:
        self._kept: list[tuple[Encoded, PrefixTree]] = []

    def of(self, encoded: Encoded, prompt: Sequence[int], plant: Callable[[], PrefixTree]) -> PrefixTree:
        """The tree of a sound, planted if it is not known.

        Args:
            encoded: the sound.
            prompt: pieces before every text.
            plant: makes the tree.
        """
        before = tuple(prompt)
        found = next((tree for known, tree in self._kept if known is encoded and tree.prompt == before), None)
        if found is None:
            found = plant()
            self._kept = [*self._kept[1 - TREES :], (encoded, found)]
        return found

    def clear(self) -> None:
        """Forget all."""
        self._kept.clear()
