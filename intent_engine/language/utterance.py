"""The words of one utterance, with its pauses."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from intent_engine.language.normalize import UNCLEAR, Token, plain_words, tokenize
from intent_engine.language.numbers.english_words import DIGITS, NUMBER_WORDS, TEENS, TENS, ZERO
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.words.openers import Openers
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import any_articles

__all__ = ["Utterance", "plain", "without_enumeration"]

_ANNOTATION = re.compile(
    r"[\[(<*]\s*(?:noise|music|silence|blank[ _]audio|pause[^\])>*]{0,8}|laughter|laughs|laughing|applause|"
    r"inaudible|cough(?:s|ing)?|sigh(?:s|ing)?|breath(?:es|ing)?|background[ _]noise|no[ _]speech|bell|beep)\s*[\])>*]",
    re.IGNORECASE,
)
"""What recognisers write for sounds that are not words."""


_ENUMERATION = re.compile(r"^\s*\d\d?\.\s+(?=[A-Z]\w*\s)")
_STUTTER = re.compile(r"\b[^aio\d] ", re.IGNORECASE)
"""A letter by itself, which may be a sound said twice,"""
_DASH_BEHIND = re.compile(r"[-‐‑]\s")
_SAID_TWICE = re.compile(r"\b([^\W\d_aio])\W+\1", re.IGNORECASE)
"""if a word that begins with it follows."""


def without_enumeration(text: str) -> str:
    """A text without the number before a sentence of a list: "1. Play my workout playlist." Nobody said it; models
    write it, since they were trained on such texts."""
    return _ENUMERATION.sub("", text) if text[:3].strip()[:1].isdigit() else text


@dataclass(frozen=True, slots=True)
class Utterance:
    """Normalised words, and what stands before each of them."""

    words: list[str]
    breaks: list[bool | None]
    """``breaks[i]`` is True where a pause or punctuation stands before word ``i``; None where there is no pause, but a
    filler was removed."""
    joined: frozenset[int] = frozenset()
    """Places where a word was removed that stood between this word and the one before, also beside a pause."""
    unclear: str = ""
    """A number as it is written that could be two in this language: "1.500". Among the words it is the larger one, so
    that a stop is found beside it; nothing else may be done with them."""

    @classmethod
    def in_one_breath(cls, words: Sequence[str]) -> Utterance:
        """Words without a pause between them."""
        return cls([*words], [False] * len(words))

    @classmethod
    def of(cls, text: str, language: str = "en", *, letters: bool = False) -> Utterance:
        """What was said.

        Args:
            text: as it was written.
            language: says how its numbers are written.
            letters: whether a letter by itself is one, also where it may be a sound said twice: "rack *b* bay three".
        """
        plain = plain_words(text)
        if plain is not None and _STUTTER.search(text) is None:
            return cls.in_one_breath(plain)
        if any(bracket in text for bracket in "[(<*"):
            text = _ANNOTATION.sub(" , ", text)
        tokens = tokenize(text, language)
        words = [token.word for token in tokens]
        breaks: list[bool | None] = [token.breaks for token in tokens]
        unclear = ""
        for place, word in enumerate(words):
            if word.endswith(UNCLEAR):
                unclear = unclear or word.removesuffix(UNCLEAR)
                words[place] = re.sub("[^0-9-]", "", word)
        sounds = [place for place in range(len(words)) if _stutter(tokens, place) or _broken_off(text, tokens, place)]
        if letters:  # no name goes on with an article: "t the cup"
            sounds = [place for place in sounds if words[place + 1] in any_articles()]
        kept = [place for place in range(len(words)) if place not in sounds]
        if len(kept) < len(words):
            return cls([words[place] for place in kept], [breaks[place] for place in kept], unclear=unclear)
        return cls(words, breaks, unclear=unclear)

    @classmethod
    def with_letters(cls, text: str, language: str = "en") -> Utterance | None:
        """The same with all its letters, where some may be sounds said twice; None: there are none."""
        if _SAID_TWICE.search(text) is None:
            return None
        every = cls.of(text, language, letters=True)
        return every if len(every) > len(cls.of(text, language)) else None

    def __len__(self) -> int:
        return len(self.words)

    def part(self, start: int, end: int) -> Utterance:
        return Utterance(self.words[start:end], self.breaks[start:end])

    def cut(self, start: int, end: int) -> Utterance:
        """The utterance without some of its words; what was said before and behind keeps its pauses."""
        return Utterance(self.words[:start] + self.words[end:], self.breaks[:start] + self.breaks[end:])

    def with_other(self, start: int, end: int, other: Utterance) -> Utterance:
        """The utterance with other words in the place of some of it; what was said before and behind keeps its pauses,
        and so do the other words between themselves."""
        here = self.breaks[start : start + 1] or [False]
        return Utterance(
            self.words[:start] + other.words + self.words[end:],
            [*self.breaks[:start], *here[: len(other)], *other.breaks[1:], *self.breaks[end:]],
        )

    def zero_between(self, position: int) -> bool:
        """Whether an "oh" stands between two numbers: a digit, as in "two oh four", or a sigh: "two, oh, four". Among
        others it is a digit as they are: of "two oh oh four", but not of "go oh oh oh"."""
        if self.words[position] not in ZERO or position + 1 >= len(self.words):
            return False
        begin = position
        while begin and self.words[begin - 1] in ZERO:
            begin -= 1
        around = (*self.words[max(begin - 1, 0) : begin], self.words[position + 1])
        return len(around) == 2 and all(word in NUMBER_WORDS or is_numeral(word) for word in around)

    def _zero_after(self, position: int) -> bool:
        """Whether an "oh" stands right behind a digit."""
        before = "".join(self.words[position - 1 : position]) if position else ""
        single = before in DIGITS or before in ZERO or (len(before) == 1 and before.isdigit())
        return single and self.words[position] in ZERO and not self.breaks[position]

    def paused_in_number(self) -> bool:
        """Whether a pause stands where a number would go on: "turn twenty, five degrees", "five, ten degrees". Larger
        numbers have such pauses: "two thousand, five hundred"."""
        return True in self.breaks and any(
            (before in TENS and word in DIGITS) or (before in DIGITS and (word in TENS or word in TEENS))
            for before, word, pause in zip(self.words, self.words[1:], self.breaks[1:], strict=False)
            if pause
        )

    def paused_beside(self, position: int) -> bool:
        """Whether there is a pause before a word or after it."""
        return any(self.breaks[position : position + 2])

    def without(self, phrases: PhraseSet, but: PhraseSet | None = None, openers: Openers | None = None) -> Utterance:
        """The utterance less every such phrase, but where it is part of a longer one of ``but`` ("oh" of "oh no"), or
        one of the ``openers`` and opens nothing, or a digit.

        A pause before or after a removed phrase is kept. The same utterance if there is nothing to remove.
        """
        if not phrases.may_stand_in(self.words):
            return self
        words: list[str] = []
        breaks: list[bool | None] = []
        joined: set[int] = set()
        pause = removed = False
        position = 0
        while position < len(self.words):
            pause = pause or bool(self.breaks[position])
            length = phrases.at(self.words, position)
            if length and openers is not None and openers.misplaced(self, position, length, words, paused=pause):
                length = 0
            if length == 1 and self.zero_between(position) and not self.paused_beside(position):
                length = 0
            if length == 1 and openers is not None and openers.digits and self._zero_after(position):
                length = 0
            whole = but.at(self.words, position) if but is not None else 0
            if whole > max(length, 1):
                words.extend(self.words[position : position + whole])
                breaks.extend((pause, *self.breaks[position + 1 : position + whole]))
                position += whole
                pause = removed = False
                continue
            if length:
                pause = pause or any(self.breaks[position : position + length])
                position += length
                removed = True
                continue
            if removed and words:
                joined.add(len(words))
            breaks.append(pause or (None if removed and words else self.breaks[position]))
            words.append(self.words[position])
            pause = removed = False
            position += 1
        return Utterance(words, breaks, frozenset(joined)) if len(words) < len(self) else self


def _stutter(tokens: Sequence[Token], place: int) -> bool:
    """ "t turn", "f forty": a first sound said twice. Never "a" or "i", which are words, nor a unit: "2 m/s so"."""
    word, start, _, _ = tokens[place]
    if len(word) != 1 or word in "aio" or not word.isalpha() or place + 1 >= len(tokens):
        return False
    if place and (tokens[place - 1].word[-1].isdigit() or tokens[place - 1].end == start):
        return False
    after = tokens[place + 1].word
    return len(after) > 2 and after.startswith(word)


def _broken_off(text: str, tokens: Sequence[Token], place: int) -> bool:
    """ "turn le- turn left", "le- left": a word that was not said to its end, as transcripts have it, where the speaker
    begins again with it or with the word before it. "Pre- and post-" is none, and neither is a number."""
    word, _, end, _ = tokens[place]
    if not _DASH_BEHIND.match(text, end) or place + 1 >= len(tokens) or not word.isalpha() or word in NUMBER_WORDS:
        return False
    after = tokens[place + 1].word
    return (after.startswith(word) and after != word) or (place > 0 and after == tokens[place - 1].word)


def plain(text: str) -> list[str]:
    """The words of a text, without case, punctuation and the choice between "90" and "ninety"."""
    return in_words(Utterance.of(text).words)
