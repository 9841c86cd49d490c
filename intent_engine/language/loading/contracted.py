"""English phrases as they are mostly said: "when you're done" of "when you are done".

Lists of phrases are written once, in full. Sentences are not read so: what is said of them is compared with speech word
by word, and "it's" is not heard as "it is" is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

__all__ = ["with_contractions"]

_SHORT: Mapping[tuple[str, str], str] = {
    ("i", "am"): "im", ("i", "have"): "ive", ("i", "will"): "ill", ("i", "would"): "id", ("it", "is"): "its",
    ("that", "is"): "thats", ("there", "is"): "theres", ("they", "are"): "theyre", ("you", "are"): "youre",
    ("you", "have"): "youve", ("you", "will"): "youll", ("you", "would"): "youd",
}  # fmt: skip
"""Two words and the one that is said for them where more follows, without its apostrophe as all such words."""


def with_contractions(phrases: Iterable[tuple[str, ...]], language: str) -> tuple[tuple[str, ...], ...]:
    """Phrases of normalised words, each with all its shorter forms behind it, and none of them twice."""
    if language != "en":
        return tuple(phrases)
    return tuple(dict.fromkeys(way for phrase in phrases for way in _ways(phrase)))


def _ways(phrase: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """A phrase and its shorter forms. Nothing is short at the end: "stay where you are" has no other."""
    yield phrase
    for place in range(len(phrase) - 2):
        if short := _SHORT.get((phrase[place], phrase[place + 1])):
            yield from ((*phrase[:place], short, *rest) for rest in _ways(phrase[place + 2 :]))
