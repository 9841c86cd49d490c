"""Free words that hold what a sentence has a place of its own for: "two towels" of a sentence that counts them, and
"bracket *in black PLA*" of "print {file} [in {material}]"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from intent_engine.language.grammar import FREE_KINDS
from intent_engine.language.loading.language_words import default_another
from intent_engine.language.matcher import Matcher
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.templates.plurals import Plurals
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import thing_words

__all__ = ["FreeWordsKept"]

_ONE = "one"
_NAMED = frozenset(("boolean", "choice", "location"))


class FreeWordsKept:
    """Tells of one grammar what its free words should not keep. Thread-safe.

    Args:
        matcher: of the grammar.
        plurals: of the grammar.
    """

    def __init__(self, matcher: Matcher, plurals: Plurals) -> None:
        language = matcher.grammar.language
        self._matcher, self._plurals = matcher, plurals
        self._leads, self._articles = thing_words(language).joining, thing_words(language).articles
        self._pronouns = PhraseSet(matcher.grammar.operators.pronoun)
        another = default_another(language) if language == "en" else {}
        self._ones = {one for word, meant in another.items() for one in (word, *meant)}

    def counted(self, words: list[str], free: Reading, read: Callable[[list[str]], list[Reading]]) -> list[Reading]:
        """Readings that leave fewer words to free text, of what is said with more of what a list names, or one: who
        says "bring two towels" where a sentence counts each "towel" means no thing called "two towels", and "print a
        copy of it" counts copies where a sentence does.

        Args:
            words: that were said.
            free: what they are read as.
            read: other words.
        """
        for said, at in self._counting(words):
            better = [one for one in read(said) if one.free_words < free.free_words and one.understood]
            better = better if at is None else [one for one in better if _counts(one, at)]
            if better and better[0].intent.priority >= free.intent.priority:
                return better
        return []

    def _counting(self, words: list[str]) -> Iterator[tuple[list[str], int | None]]:
        """The words as a grammar may count them, with where an article is said for one."""
        counted = self._plurals.counted(words)
        if counted is not None:
            yield counted, None
        for at in (at for at in range(1, len(words) - 1) if words[at] in self._ones):
            one = [*words[:at], _ONE, *words[at + 1 :]]
            yield self._plurals.counted(one) or one, at

    def place_of(self, reading: Reading) -> Sequence[str]:
        """The end of free words for which a sentence has a place: words that lead to it, and at the end a value that
        stands there. Empty: there is none."""
        words = list(reading.words)
        for slot, at in self._led(reading):
            begins = (at + 1, at + 2) if words[at + 1] in self._articles else (at + 1,)
            if any(
                self._is_value(other, reading, begin, slot.end - cut + begin)
                for begin in begins
                for cut in range(begin + 1, slot.end)
                for other in self._matcher.read([*words[:begin], *words[cut:]])
            ):
                return reading.words[at : slot.end]
        return ()

    def points(self, reading: Reading) -> bool:
        """Whether the name of a thing ends with a pronoun and what leads to it, where a sentence goes on so: "print
        the bracket *on it*" of one that has "on printer {printer}"."""
        words = list(reading.words)
        return any(
            self._pronouns.cover(words[at + 1 : slot.end])
            and self._matcher.values.is_thing(slot.slot)
            and (state := self._matcher.strict.walk(words[:at])[1]) is not None
            and any(words[at] in place.arcs for place, _ in state.members)
            for slot, at in self._led(reading)
        )

    def _led(self, reading: Reading) -> Iterator[tuple[SlotReading, int]]:
        """Free words, each with where one of them leads to more."""
        for slot in reading.slots:
            if slot.slot.type in FREE_KINDS and not slot.slot.dictation:
                for at in range(slot.start + 1, slot.end - 1):
                    if reading.words[at] in self._leads:
                        yield slot, at

    def _is_value(self, other: Reading, reading: Reading, start: int, end: int) -> bool:
        """Whether words are all of what a list or a number with its noun has, in a sentence of the same command."""
        if other.problem or other.intent is not reading.intent or other.free_words >= reading.free_words:
            return False
        return any(
            one.end == end and one.start >= start + (one.slot.type not in _NAMED) and one.slot.type not in FREE_KINDS
            for one in other.slots
        )


def _counts(reading: Reading, at: int) -> bool:
    """Whether the word at a place is all of a number, and a word of the sentence says of what."""
    after = any(slot.start == at + 1 for slot in reading.slots)
    number = any(slot.slot.type == "number" and (slot.start, slot.end) == (at, at + 1) for slot in reading.slots)
    return number and not after
