"""The words of one utterance, with its pauses, and plain phrases found in them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache

from intent_engine.language.normalize import UNCLEAR, Token, plain_words, tokenize
from intent_engine.language.numbers import foreign
from intent_engine.language.numbers.english import DIGITS, NUMBER_WORDS, TEENS, TENS, ZERO
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.numbers.spelled import in_words
from intent_engine.language.thing_words import any_articles

__all__ = ["Openers", "PhraseSet", "SomePhrases", "TextPlace", "Utterance", "plain", "without_enumeration"]

_ANNOTATION = re.compile(
    r"[\[(<*]\s*(?:noise|music|silence|blank[ _]audio|pause[^\])>*]{0,8}|laughter|laughs|laughing|applause|"
    r"inaudible|cough(?:s|ing)?|sigh(?:s|ing)?|breath(?:es|ing)?|background[ _]noise|no[ _]speech|bell|beep)\s*[\])>*]",
    re.IGNORECASE,
)
"""What recognisers write for sounds that are not words."""


_ENUMERATION = re.compile(r"^\s*\d\d?\.\s+(?=[A-Z]\w*\s)")
_STUTTER = re.compile(r"\b[^aio\d] ", re.IGNORECASE)
"""A letter by itself, which may be a sound said twice,"""
_SAID_TWICE = re.compile(r"\b([^\W\d_aio])\W+\1", re.IGNORECASE)
"""if a word that begins with it follows."""


class PhraseSet:
    """Phrases of whole words, found at a position, longest first."""

    def __init__(self, phrases: Iterable[Sequence[str]]) -> None:
        self._by_first: dict[str, list[tuple[str, ...]]] = {}
        for words in sorted({tuple(words) for words in phrases if words}, key=len, reverse=True):
            self._by_first.setdefault(words[0], []).append(words)

    def __bool__(self) -> bool:
        return bool(self._by_first)

    def may_stand_in(self, words: Iterable[str]) -> bool:
        """A quick look: whether any phrase could begin in these words."""
        return not self._by_first.keys().isdisjoint(words)

    def at(self, words: Sequence[str], position: int) -> int:
        """Length of the longest phrase that begins at a position; 0 for none."""
        for phrase in self._by_first.get(words[position], ()) if position < len(words) else ():
            if tuple(words[position : position + len(phrase)]) == phrase:
                return len(phrase)
        return 0

    def lengths_at(self, words: Sequence[str], position: int) -> list[int]:
        """Lengths of all phrases that begin at a position, longest first."""
        return [
            len(phrase)
            for phrase in (self._by_first.get(words[position], ()) if position < len(words) else ())
            if tuple(words[position : position + len(phrase)]) == phrase
        ]

    def cover(self, words: Sequence[str]) -> bool:
        """Whether the words are such phrases, one after the other, and nothing else."""
        place = 0
        while place < len(words) and (length := self.at(words, place)):
            place += length
        return place == len(words)

    def ends(self, words: Sequence[str]) -> int:
        """Length of the longest phrase that the words end with; 0 for none."""
        for start in range(len(words)):
            if self.at(words, start) == len(words) - start:
                return len(words) - start
        return 0

    def find(self, words: Sequence[str], start: int = 0) -> tuple[int, int] | None:
        """First (position, length) at or after ``start``."""
        if not self.may_stand_in(words):
            return None
        for position in range(start, len(words)):
            if words[position] in self._by_first and (length := self.at(words, position)):
                return position, length
        return None


class SomePhrases(PhraseSet):
    """Those of some phrases for which a test holds. Each is tested when it is first said: a test may be slow.

    Args:
        phrases: to be tested.
        test: of a phrase; the same for all time.
    """

    def __init__(self, phrases: Iterable[Sequence[str]], test: Callable[[tuple[str, ...]], bool]) -> None:
        super().__init__(phrases)
        self._test = cache(test)

    def at(self, words: Sequence[str], position: int) -> int:
        return next(iter(self.lengths_at(words, position)), 0)

    def lengths_at(self, words: Sequence[str], position: int) -> list[int]:
        lengths = super().lengths_at(words, position)
        return [length for length in lengths if self._test(tuple(words[position : position + length]))]


def without_enumeration(text: str) -> str:
    """A text without the number before a sentence of a list: "1. Play my workout playlist." Nobody said it; models
    write it, since they were trained on such texts."""
    return _ENUMERATION.sub("", text) if text[:3].strip()[:1].isdigit() else text


class TextPlace(Enum):
    """Where a word of a sentence stands, of which a part may be any words: a title, a message."""

    OUTSIDE = "outside"
    """In no such text, or where the sentence goes on behind one."""
    BEGINS = "begins"
    """It is the first of a text."""
    WITHIN = "within"
    """It is a further one."""


@dataclass(frozen=True, slots=True)
class Openers:
    """Fillers that are none elsewhere: "right then, turn left", but "turn right then go forward"."""

    phrases: PhraseSet
    joints: PhraseSet
    """Phrases after which another command begins."""
    listing: PhraseSet
    """Those that are a command without a verb, and a joint: "right then". In a list of commands they are that."""
    around: PhraseSet
    """Fillers that are such only before a number: "about ten seconds", but "a book about cars"."""
    again: PhraseSet
    """Phrases after which a command begins again: "no, I mean go ahead and turn right"."""
    greetings: PhraseSet
    """Fillers with which a free name may begin, where the grammar has one: "play hey jude"."""
    fillers: PhraseSet
    """All of them."""
    ends: PhraseSet
    """Phrases with which a command is over: joints, stops, corrections and the like."""
    sounds: PhraseSet
    """Fillers that are no words, as "uh", and with which people think what to say."""
    counting: PhraseSet
    """Fillers that are such only between a number and what is counted: "two *more* coffees"."""
    place_of: Callable[[Sequence[str], str], TextPlace | None] | None = None
    """Where what is said between words and another word stands; None: the grammar has no texts of any words."""
    language: str = "en"
    """Whose numbers."""
    digits: bool = False
    """Whether digits are said one by one, so that an "oh" behind one is a zero: "heading one eight oh"."""

    def misplaced(
        self, said: Utterance, position: int, length: int, before: Sequence[str], *, paused: bool = False
    ) -> bool:
        """Whether such a phrase stands here, and no command begins here, or a pause divides it.

        ``paused``: a pause stands before it, with nothing but fillers between: "turn left, please go ahead and stop".

        After a joint "right then" is no filler either: "turn left then right then left". Nor is "go and" one where its
        joint goes on: "go and then turn left" are two.
        """
        if self.counting.at(said.words, position) == length:
            if before and self._counts(before[-1]):
                return paused or not self._counts_on(said, position, length, before)
            if not self.around.at(said.words, position):
                return True
        if before and self.place_of is not None and self.sounds.at(said.words, position) != length:
            end = self._after_fillers(said, position + length)
            place = self.place_of(before, said.words[end] if end < len(said) else "")
            if place is not None and place is not TextPlace.OUTSIDE:
                return self._belongs(said, position, length, end, place, paused=paused)
        if self.around.at(said.words, position) == length:
            return not any(map(self._counts, said.words[position + length : position + length + 1]))
        if before and self.greetings.at(said.words, position) == length:
            return (not paused or self.again.ends(before) > 0) and self._begins_name(said, position, length, before)
        if self.phrases.at(said.words, position) != length:
            return False
        if self.joints.at(said.words, position + length - 1) > 1:
            return True
        if self.listing.at(said.words, position) == length:
            end = position + length  # twice it opens only between pauses: "right then, right then, go"
            apart = said.breaks[position] and end < len(said) and said.breaks[end]
            begins = not before and (apart or self.listing.find(said.words[:position]) is None)
        else:
            begins = not before or paused or said.breaks[position] or self._begins_after(before)
        return not begins or any(said.breaks[position + 1 : position + length])

    def _counts_on(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether what is counted follows in the same breath: "one more coffee", but not "one more" nor "one more
        please". In a text ("tell anna two *more* people come") the word is a part of it."""
        end = position + length
        if end == len(said) or any(said.breaks[position : end + 1]):
            return False
        if self.fillers.at(said.words, end) or self.ends.at(said.words, end):
            return False
        return self.place_of is None or self.place_of(before, said.words[end]) is not TextPlace.WITHIN

    def _belongs(
        self, said: Utterance, position: int, length: int, end: int, place: TextPlace, *, paused: bool
    ) -> bool:
        """Whether a filler is a part of the text in which it stands: "play *ok* computer", "it is *about* noon".

        People put such words behind a command ("play yesterday please"), between pauses and, in other languages than
        English, behind its verb ("spiel bitte ..."). A greeting may be all that is said: "play hello hello".
        """
        begins = place is TextPlace.BEGINS
        if paused or said.breaks[position]:
            return False
        if self.greetings.at(said.words, position) == length:
            again = said.words[position : position + length] == said.words[max(position - length, 0) : position]
            if begins or again:
                return True
        over = end == len(said) or self.ends.at(said.words, end) > 0
        return not over and not any(said.breaks[position + 1 : end + 1]) and (not begins or self.language == "en")

    def _after_fillers(self, said: Utterance, position: int) -> int:
        """Where the next word stands that is no filler."""
        while position < len(said) and (length := self.fillers.at(said.words, position)):
            position += length
        return position

    def _begins_name(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether a greeting stands in the midst of a command, in one breath: people greet before one or behind it."""
        end = position + length
        apart = any(said.breaks[position + 1 : end + 1]) or self.joints.ends(before) > 0
        end = self._after_fillers(said, end)
        return not apart and end < len(said) and not self.joints.at(said.words, end)

    def _begins_after(self, before: Sequence[str]) -> bool:
        return self.joints.ends(before) > 0 or self.again.ends(before) > 0

    def _counts(self, word: str) -> bool:
        """Whether a word begins a number, or is one."""
        if is_numeral(word):
            return True
        return word in NUMBER_WORDS if self.language == "en" else foreign.is_number_word(word, self.language)


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
    def of(cls, text: str, language: str = "en", *, letters: bool = False) -> Utterance:
        """What was said.

        Args:
            text: as it was written.
            language: says how its numbers are written.
            letters: whether a letter by itself is one, also where it may be a sound said twice: "rack *b* bay three".
        """
        plain = plain_words(text)
        if plain is not None and _STUTTER.search(text) is None:
            return cls(plain, [False] * len(plain))
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
        sounds = [place for place in range(len(words)) if _stutter(tokens, place)]
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


def plain(text: str) -> list[str]:
    """The words of a text, without case, punctuation and the choice between "90" and "ninety"."""
    return in_words(Utterance.of(text).words)
