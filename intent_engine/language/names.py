"""A list of names, found again from what was heard: exactly, by number, by sound, by spelling.

Names that differ in a number are different names, however alike they are spelled: "bay 3" is never "bay 13". A name
that was only nearly said needs a score, word by word, and a margin to the second best; a wrong place costs more
than a question.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from intent_engine.language.normalize import tokenize
from intent_engine.language.numbers import english
from intent_engine.language.numbers.numerals import is_numeral, numeral_value

__all__ = ["Match", "NameIndex"]

ARTICLES = frozenset(("the", "a", "an", "my", "our", "your", "this", "that"))
MIN_SCORE = 0.84
"""Mean likeness of the words, weighted by length."""
MIN_SCORE_SHORT = 0.90
"""The same for a single word of at most four letters: one letter is a quarter of it."""
MIN_WORD = 0.75
"""Likeness of the worst word: "dining room" is not "living room" though most letters agree."""
MIN_MARGIN = 0.05
"""To the best other name."""
SPELLING_WEIGHT = 0.6
"""Share of spelling in a word's likeness; the rest is sound. Chosen on misheard and absent names: docs/locations.md."""
NUMBER_ALIKES = {
    "to": "2", "too": "2", "tu": "2", "for": "4", "fore": "4", "tree": "3", "free": "3", "won": "1", "wan": "1",
    "ate": "8",
    "sex": "6", "sicks": "6", "tin": "10", "hate": "8", "fife": "5", "nein": "9",
}  # fmt: skip
"""What recognisers write for a number at the end of a name."""
SHORTLIST = 12


@dataclass(frozen=True, slots=True)
class Match:
    """What a name resolves to."""

    status: str
    """``exact``, ``fuzzy``, ``ambiguous`` or ``unknown``."""
    name: str | None
    """The canonical name, if exact or fuzzy."""
    score: float = 0.0
    """0 to 1."""
    margin: float = 0.0
    """To the best other name."""
    candidates: tuple[tuple[str, float], ...] = ()
    """Up to three names, best first."""
    how: str = ""
    """``exact``, ``number``, ``sound`` or ``spelling``."""


@lru_cache(maxsize=65536)
def sound(word: str) -> str:
    """A phonetic key (Metaphone, Philips 1990); the word itself if it has none."""
    import jellyfish

    return jellyfish.metaphone(word) or word


@lru_cache(maxsize=65536)
def likeness(said: str, known: str) -> float:
    """How alike two words are, 0 to 1, in spelling and in sound."""
    from rapidfuzz import fuzz

    if said == known:
        return 1.0
    if is_numeral(said) or is_numeral(known):
        return 0.0
    spelling = fuzz.ratio(said, known) / 100
    heard = fuzz.ratio(sound(said), sound(known)) / 100
    if said[0] != known[0] and sound(said)[:1] != sound(known)[:1]:
        heard *= 0.5  # a first sound is seldom misheard; "fridge" is not "bridge"
    return SPELLING_WEIGHT * spelling + (1 - SPELLING_WEIGHT) * heard


def name_words(text: str | Sequence[str]) -> tuple[str, ...]:
    """A name's words without articles, its numbers in digits."""
    words = [token.word for token in tokenize(text)] if isinstance(text, str) else list(text)
    kept = [word for word in words if word not in ARTICLES] or words
    result: list[str] = []
    at = 0
    while at < len(kept):
        found = english.cardinal(kept, at) if kept[at] in english.NUMBER_WORDS or kept[at][0].isdigit() else None
        if found is not None and found[0] == int(found[0]) and found[1] > at:
            result.append(str(int(found[0])))
            at = found[1]
        elif is_numeral(kept[at]):
            value = numeral_value(kept[at])
            result.append(kept[at] if value is None else f"{value:g}")
            at += 1
        else:
            if kept[at] not in ("number", "no", "nr"):
                result.append(kept[at])
            at += 1
    return tuple(result) or tuple(kept)


def _numbers(words: Iterable[str]) -> tuple[str, ...]:
    return tuple(word for word in words if is_numeral(word))


class NameIndex:
    """Names and aliases with what they stand for. Thread-safe; made ready at the first question.

    Args:
        entries: (spoken form, canonical name) pairs; several forms may stand for one name.
    """

    def __init__(self, entries: Iterable[tuple[str, str]]) -> None:
        self._entries = entries
        self._lock = threading.Lock()
        self._ready = False

    def _prepare(self) -> None:
        with self._lock:
            if self._ready:
                return
            self._exact: dict[tuple[str, ...], str] = {}
            self._groups: dict[tuple[str, ...], dict[int, tuple[list[str], list[tuple[tuple[str, ...], str]]]]] = {}
            seen = set()
            for spoken, name in self._entries:
                words = name_words(spoken)
                if not words or (words, name) in seen:
                    continue
                seen.add((words, name))
                self._exact.setdefault(words, name)
                letters = "".join(word for word in words if not is_numeral(word))
                texts, rows = self._groups.setdefault(_numbers(words), {}).setdefault(len(letters), ([], []))
                texts.append(letters)
                rows.append((words, name))
            self._entries = ()
            self._ready = True

    def resolve(self, words: str | Sequence[str]) -> Match:
        """The name that was meant. Never raises; the same words give the same answer."""
        if not self._ready:
            self._prepare()
        said = name_words(words)
        if not said:
            return Match("unknown", None)
        name = self._exact.get(said)
        if name is not None:
            given = [token.word for token in tokenize(words)] if isinstance(words, str) else list(words)
            how = "exact" if not _numbers(said) or set(given) >= set(said) else "number"
            return Match("exact", name, 1.0, 1.0, ((name, 1.0),), how)
        heard = self._as_number(said)
        name = self._exact.get(heard) if heard is not None else None
        if name is not None:
            return Match("fuzzy", name, 0.95, 0.95, ((name, 0.95),), "sound")
        ranked = self._ranked(said)
        if heard is not None:
            ranked = _merged(ranked, self._ranked(heard))
        return self._judged(said, ranked)

    def _as_number(self, said: tuple[str, ...]) -> tuple[str, ...] | None:
        """ "bay tree" as "bay 3": a word that sounds like a number, at the end of a name of several words."""
        if len(said) < 2 or said[-1] not in NUMBER_ALIKES:
            return None
        return (*said[:-1], NUMBER_ALIKES[said[-1]])

    def _shortlist(self, said: tuple[str, ...]) -> list[tuple[tuple[str, ...], str]]:
        from rapidfuzz import fuzz, process

        letters = "".join(word for word in said if not is_numeral(word))
        buckets = self._groups.get(_numbers(said), {})
        slack = max(2, len(letters) // 4)
        found: list[tuple[float, tuple[tuple[str, ...], str]]] = []
        for length in range(len(letters) - slack, len(letters) + slack + 1):
            bucket = buckets.get(length)
            if bucket is None:
                continue
            texts, rows = bucket
            for _, score, place in process.extract(
                letters, texts, scorer=fuzz.ratio, limit=SHORTLIST, score_cutoff=60.0
            ):
                found.append((score, rows[place]))
        found.sort(key=lambda row: (-row[0], row[1]))
        return [row for _, row in found[:SHORTLIST]]

    def _ranked(self, said: tuple[str, ...]) -> list[tuple[str, float, float]]:
        """(name, score, worst word) of the nearest names with the same numbers, best first."""
        best: dict[str, tuple[float, float]] = {}
        for words, name in self._shortlist(said):
            score, worst = _compare(said, words)
            if name not in best or score > best[name][0]:
                best[name] = (score, worst)
        ranked = [(name, score, worst) for name, (score, worst) in best.items()]
        ranked.sort(key=lambda row: (-row[1], row[0]))
        return ranked

    def _judged(self, said: tuple[str, ...], ranked: list[tuple[str, float, float]]) -> Match:
        candidates = tuple((name, round(score, 3)) for name, score, _ in ranked[:3])
        if not ranked:
            return Match("unknown", None, candidates=self._anywhere(said))
        name, score, worst = ranked[0]
        margin = score - (ranked[1][1] if len(ranked) > 1 else 0.0)
        short = len(said) == 1 and len(said[0]) <= 4
        if score < (MIN_SCORE_SHORT if short else MIN_SCORE) or worst < MIN_WORD:
            return Match("unknown", None, score, margin, candidates)
        if margin < MIN_MARGIN:
            return Match("ambiguous", None, score, margin, candidates)
        how = "sound" if [sound(word) for word in said] == [sound(word) for word in name.split()] else "spelling"
        return Match("fuzzy", name, score, margin, candidates, how)

    def _anywhere(self, said: tuple[str, ...]) -> tuple[tuple[str, float], ...]:
        """The three nearest names whatever their numbers, to suggest."""
        from rapidfuzz import fuzz, process

        text = " ".join(said)
        names = {" ".join(words): name for words, name in self._exact.items()}
        best: dict[str, float] = {}
        for found, score, _ in process.extract(text, names.keys(), scorer=fuzz.ratio, limit=9, score_cutoff=35.0):
            best.setdefault(names[found], round(score / 100, 3))
        return tuple(list(best.items())[:3])


def _compare(said: tuple[str, ...], known: tuple[str, ...]) -> tuple[float, float]:
    """Likeness of two names, and of their worst word. Words split or joined otherwise are compared as one."""
    if len(said) == len(known):
        likes = [likeness(one, other) for one, other in zip(said, known, strict=True)]
        weights = [max(len(word), 2) for word in known]
        mean = sum(like * weight for like, weight in zip(likes, weights, strict=True)) / sum(weights)
        return mean, min(likes)
    whole = likeness("".join(said), "".join(known))
    return whole - 0.02, whole


def _merged(
    first: list[tuple[str, float, float]], second: list[tuple[str, float, float]]
) -> list[tuple[str, float, float]]:
    best: dict[str, tuple[float, float]] = {}
    for name, score, worst in (*first, *((name, score * 0.97, worst) for name, score, worst in second)):
        if name not in best or score > best[name][0]:
            best[name] = (score, worst)
    return sorted(((name, *rest) for name, rest in best.items()), key=lambda row: (-row[1], row[0]))
