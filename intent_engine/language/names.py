"""A list of names, found again from what was heard: exactly, by number, by sound, by spelling.

Names that differ in a number or a letter are different names, however alike they are spelled: "bay 3" is never
"bay 13", nor "sala tres" "sala trece". A name that was only nearly said needs words that may be taken for each other, a
score, and a margin to the second best; a wrong place costs more than a question.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from intent_engine.language.numbers import foreign
from intent_engine.language.slots.name_words import (
    ARTICLES,
    OWNERS,
    heard_otherwise,
    is_identifier,
    name_words,
    owner,
    raw_words,
    singular,
    without_article,
)

__all__ = ["Match", "NameIndex"]

MIN_SCORE = 0.84
"""Mean likeness of the words, weighted by length."""
MIN_MARGIN = 0.05
"""To the best other name. Aliases of one name are no rivals."""
ALIKE_WEIGHT = 0.95
"""Weight of a score found after a word was taken for a number or letter that sounds alike."""
SHORTLIST = 24
"""Names that are compared word by word."""
SHORTLIST_RATIO = 60.0
"""Least likeness of their letters, in percent."""
SUGGESTED = 3
"""Names that are told where none was meant."""
SUGGESTION_SCAN = 20_000
"""Names looked at for a suggestion; those of the most similar length come first."""
MAX_GROUPS = 10_000
"""Sets of numbers whose names are kept arranged."""

Words = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Match:
    """What a name resolves to."""

    status: Literal["exact", "fuzzy", "ambiguous", "unknown"]
    """Only ``exact`` and ``fuzzy`` name something; ``ambiguous`` is worth a question."""
    name: str | None
    """The canonical name, if exact or fuzzy."""
    score: float = 0.0
    """0 to 1, of the best candidate."""
    margin: float = 0.0
    """To the best other name."""
    candidates: tuple[tuple[str, float], ...] = ()
    """Up to three (name, score), best first; ambiguous: those to ask about; unknown: the nearest, to suggest."""
    how: Literal["", "exact", "number", "sound", "spelling"] = ""
    """By what it was found: the words, the value of a number in words, sound alone, or spelling and sound."""


@dataclass(frozen=True, slots=True)
class _Found:
    """A candidate of the search."""

    name: str
    score: float
    passes: bool
    how: Literal["sound", "spelling"]


class NameIndex:
    """Names and aliases with what they stand for. Thread-safe; made ready at the first question.

    Args:
        entries: (spoken form, canonical name) pairs; several forms may stand for one name.
        language: whose words the numbers in them may be, besides English ones.
    """

    def __init__(self, entries: Iterable[tuple[str, str]], language: str = "en") -> None:
        self._entries: Iterable[tuple[str, str]] = entries
        self._language = language
        self._lock = threading.Lock()
        self._tables: _Tables | None = None

    def prepare(self) -> None:
        """Make it ready now, so that the first question is as quick as the others."""
        from intent_engine.language.words import likeness

        self._ready().arrange(())
        likeness.sound("ready")

    def _ready(self) -> _Tables:
        tables = self._tables
        if tables is None:
            with self._lock:
                if self._tables is None:
                    self._tables = _Tables(self._entries, self._language)
                    self._entries = ()
                tables = self._tables
        return tables

    def resolve(self, words: str | Sequence[str]) -> Match:
        """The name that was meant. Never raises; the same words give the same answer.

        Args:
            words: what was heard, as text or as normalised words.
        """
        tables = self._ready()
        heard = raw_words(words) if isinstance(words, str) else tuple(word for word in words if word)
        counted = _in_digits(heard, self._language)
        said = name_words(counted)
        if not said:
            return Match("unknown", None)
        names = tables.names_of(said)
        if names:
            return _exactly(names, heard, said)
        return _judged(self._search(tables, counted, said)) or self._unknown(tables, without_article(said))

    def _search(self, tables: _Tables, heard: Sequence[str], said: tuple[str, ...]) -> list[_Found]:
        """Every name that is near, best first."""
        best: dict[str, _Found] = {}

        def offer(found: _Found) -> None:
            other = best.get(found.name)
            if other is None or (found.score, found.passes) > (other.score, other.passes):
                best[found.name] = found

        for found in tables.near(said):
            offer(found)
        for one in singular(said):
            for name in tables.names_of(one):
                offer(_Found(name, ALIKE_WEIGHT, True, "spelling"))
        for alike in heard_otherwise(heard):
            for name in tables.names_of(alike):
                offer(_Found(name, ALIKE_WEIGHT, True, "sound"))
            for found in tables.near(alike):
                offer(_Found(found.name, found.score * ALIKE_WEIGHT, found.passes, found.how))
        return sorted(best.values(), key=lambda found: (-found.score, found.name))

    @staticmethod
    def _unknown(tables: _Tables, said: tuple[str, ...]) -> Match:
        """ "bay" where there are numbered bays is a question; all else is unknown, with the nearest names."""
        if not any(is_identifier(word) for word in said):
            numbered = tables.numbered(said)
            if numbered:
                candidates = tuple((name, MIN_SCORE) for name in numbered[:3])
                return Match("ambiguous", None, MIN_SCORE, 0.0, candidates)
        candidates = tables.nearest(said)
        score = candidates[0][1] if candidates else 0.0
        return Match("unknown", None, score, 0.0, candidates)


def _exactly(names: tuple[str, ...], heard: Sequence[str], said: tuple[str, ...]) -> Match:
    if len(names) > 1:
        return Match("ambiguous", None, 1.0, 0.0, tuple((name, 1.0) for name in names[:3]), "exact")
    by_value = not set(heard).issuperset(said)
    return Match("exact", names[0], 1.0, 1.0, ((names[0], 1.0),), "number" if by_value else "exact")


def _judged(ranked: list[_Found]) -> Match | None:
    """The verdict on what was found; None if nothing is near enough to be asked about."""
    if not ranked or ranked[0].score < MIN_SCORE:
        return None
    best = ranked[0]
    margin = best.score - (ranked[1].score if len(ranked) > 1 else 0.0)
    near = [found for found in ranked[:3] if found.score >= best.score - MIN_MARGIN]
    if best.passes and len(near) == 1:
        candidates = tuple((found.name, round(found.score, 3)) for found in ranked[:3])
        return Match("fuzzy", best.name, best.score, margin, candidates, best.how)
    return Match(
        "ambiguous", None, best.score, margin, tuple((found.name, round(found.score, 3)) for found in near), best.how
    )


def _in_digits(words: Words, language: str) -> Words:
    """Words with the numbers of a language in digits; the English ones are read as they are."""
    if language == "en" or not any(word.isalpha() and foreign.is_number_word(word, language) for word in words):
        return words
    return foreign.in_digits(words, language)


class _Tables:
    """The names, arranged to be found."""

    def __init__(self, entries: Iterable[tuple[str, str]], language: str) -> None:
        exact: dict[Words, tuple[str, ...]] = {}
        for spoken, name in entries:
            words = name_words(spoken if language == "en" else _in_digits(raw_words(spoken), language))
            if words:
                names = exact.get(words)
                if names is None:
                    exact[words] = (name,)
                elif name not in names:
                    exact[words] = tuple(sorted((*names, name)))
        self._exact = exact
        self._bare: dict[tuple[str, Words], tuple[str, ...]] = {}
        """Names without the article in front, by whose they are said to be."""
        self._by_identifiers: dict[tuple[str, ...], list[Words]] = {}
        self._by_letters: dict[str, list[Words]] = {}
        self._groups: dict[tuple[str, ...], _Group] = {}
        """Made when first asked for."""
        ordered = sorted(exact)  # so that the order of the file decides nothing
        self._first = ordered[:SUGGESTION_SCAN]
        for words in ordered:
            if words[0] in ARTICLES:
                bare = without_article(words)
                if bare != words:
                    owned = owner(words)
                    for said in ("", owned) if owned else ("", *OWNERS.values()):
                        self._bare[said, bare] = tuple(sorted({*self._bare.get((said, bare), ()), *exact[words]}))
            identifiers, letters = _split(words)
            self._by_identifiers.setdefault(identifiers, []).append(words)
            self._by_letters.setdefault(letters, []).append(words)
        self._all = _Group(self._by_letters)

    def names_of(self, words: Words) -> tuple[str, ...]:
        """The names that are said with exactly these words, or with these but for an article."""
        found = self._exact.get(words)
        if found is None:
            bare = without_article(words)
            found = self._exact.get(bare) or self._bare.get((owner(words), bare)) or ()
        return found

    def near(self, said: Words) -> list[_Found]:
        """Names with the same identifiers whose words are alike."""
        from intent_engine.language.words.likeness import compare, sound

        said, owned = without_article(said), owner(said)
        identifiers, letters = _split(said)
        if not letters:
            return []
        found: list[_Found] = []
        for words in self.arrange(identifiers).shortlist(letters):
            if owned and owner(words) not in ("", owned):
                continue
            like = compare(said, words)
            same = len(said) == len(words) and all(sound(a) == sound(b) for a, b in zip(said, words, strict=True))
            how: Literal["sound", "spelling"] = "sound" if same else "spelling"
            if not _stands_in(words, said):
                found.extend(_Found(name, like.score, like.passes, how) for name in self._exact[words])
        return found

    def arrange(self, identifiers: tuple[str, ...]) -> _Group:
        """The names with exactly these identifiers, made when first asked for."""
        group = self._groups.get(identifiers)
        if group is None and self._by_identifiers.keys() == {identifiers}:
            group = self._groups[identifiers] = self._all
        if group is None:
            by_letters: dict[str, list[Words]] = {}
            for words in self._by_identifiers.get(identifiers, ()):
                by_letters.setdefault(_split(words)[1], []).append(words)
            group = _Group(by_letters)
            if len(self._groups) < MAX_GROUPS:
                self._groups[identifiers] = group
        return group

    def numbered(self, said: Words) -> list[str]:
        """The names that are these words and a number or letter, in order."""
        forms = [
            words
            for words in self._by_letters.get("".join(said), ())
            if len(words) > len(said) and tuple(word for word in words if not is_identifier(word)) == said
        ]
        return list(dict.fromkeys(name for words in sorted(forms, key=_natural) for name in self._exact[words]))

    def nearest(self, said: Words) -> tuple[tuple[str, float], ...]:
        """Up to three names that are written most like it, whatever their numbers, to suggest."""
        from rapidfuzz import fuzz, process

        text = " ".join(said)
        identifiers, letters = _split(said)
        if letters:
            forms = self._all.nearest(letters)
            if len({name for words in forms for name in self._exact[words]}) < SUGGESTED:  # "station": all of one place
                forms = self._all.nearest(letters, far=True)
        else:
            forms = self._by_identifiers.get(identifiers, [])[:SUGGESTION_SCAN] or self._first
        spoken = {" ".join(words): words for words in forms}
        rows = process.extract(text, list(spoken), scorer=fuzz.ratio, limit=None)
        rows.sort(key=lambda row: (-row[1], _natural(spoken[row[0]])))
        best: dict[str, float] = {}
        for found, score, _ in rows:
            for name in self._exact[spoken[found]]:
                best.setdefault(name, round(score / 100, 3))
        return tuple(best.items())[:SUGGESTED]


class _Group:
    """Names by the number of their letters."""

    __slots__ = ("_by_length", "_forms")

    def __init__(self, forms: dict[str, list[Words]]) -> None:
        self._forms = forms
        self._by_length: dict[int, list[str]] = {}
        for letters in forms:
            self._by_length.setdefault(len(letters), []).append(letters)

    def shortlist(self, letters: str) -> list[Words]:
        """The forms whose letters, without spaces, are most alike."""
        from rapidfuzz import fuzz, process

        slack = max(2, len(letters) // 4)
        found: list[tuple[float, str]] = []
        for length in range(len(letters) - slack, len(letters) + slack + 1):
            texts = self._by_length.get(length)
            if texts:
                rows = process.extract(letters, texts, scorer=fuzz.ratio, limit=SHORTLIST, score_cutoff=SHORTLIST_RATIO)
                found.extend((-score, text) for text, score, _ in rows)
        found.sort()
        return [words for _, text in found[:SHORTLIST] for words in self._forms[text]]

    def nearest(self, letters: str, *, far: bool = False) -> list[Words]:
        """Forms whose letters are the most alike of those of similar length, however little; ``far``: all of these."""
        from rapidfuzz import fuzz, process

        texts: list[str] = []
        for length in sorted(self._by_length, key=lambda length: (abs(length - len(letters)), length)):
            texts.extend(self._by_length[length][: SUGGESTION_SCAN - len(texts)])
            if len(texts) >= SUGGESTION_SCAN:
                break
        found = process.extract(letters, texts, scorer=fuzz.ratio, limit=SHORTLIST, score_cutoff=SHORTLIST_RATIO)
        if far or len(found) < SUGGESTED:
            found = process.extract(letters, texts, scorer=fuzz.ratio, limit=None if far else SHORTLIST)
        forms: list[Words] = []
        for text, _, _ in sorted(found, key=lambda row: (-row[1], row[0])):
            forms.extend(self._forms[text][: SUGGESTION_SCAN - len(forms)])
        return forms


def _stands_in(words: Words, said: Words) -> bool:
    """Whether a name was said as it is, together or apart, and words beside it or between: these were heard, and say
    something. "Straight ahead in", before "five minutes", is no way to say "straight ahead", nor "bath or room"
    "bathroom"."""
    from intent_engine.language.words.likeness import sound

    heard = map(sound, said)
    if len(said) > len(words) and all(sound(word) in heard for word in words):  # in this order
        return True
    letters = "".join(words)
    ends = {0}  # of the beginnings that some of the words are, one after the other
    for word in said:
        ends |= {end + len(word) for end in ends if letters.startswith(word, end)}
    return len("".join(said)) > len(letters) and len(letters) in ends


def _split(words: Words) -> tuple[tuple[str, ...], str]:
    """The identifiers of a name, and its letters without spaces; of both, an article in front is no part."""
    words = without_article(words)
    identifiers = tuple(word for word in words if len(word) == 1 or not word.isalpha())
    letters = "".join(words) if not identifiers else "".join(word for word in words if word not in identifiers)
    return identifiers, letters


def _natural(words: Words) -> tuple[tuple[int, float, str], ...]:
    """A key that sorts bay 2 before bay 10."""
    return tuple((0, float(word), "") if word.isdigit() and len(word) < 300 else (1, 0.0, word) for word in words)
