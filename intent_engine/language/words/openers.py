"""Fillers that say nothing at some places of an utterance only."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

from intent_engine.language.numbers import foreign
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.phrase_set import PhraseSet

if TYPE_CHECKING:
    from intent_engine.language.utterance import Utterance

__all__ = ["Openers", "TextPlace"]


COUNTED_WORDS = 3
"""Words of what is counted, at most: "dos cafés con leche"."""


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
    counted: PhraseSet
    """Fillers that are such only behind what is counted: "dos cafés *más*"."""
    place_of: Callable[[Sequence[str], str], TextPlace | None] | None = None
    """Where what is said between words and another word stands; None: the grammar has no texts of any words."""
    language: str = "en"
    """Whose numbers."""
    places: bool = False
    """Whether the grammar has places of a map."""
    digits: bool = False
    """Whether digits are said one by one, so that an "oh" behind one is a zero: "heading one eight oh"."""
    describing: frozenset[str] = frozenset()
    """Fillers that may be a part of a thing's name, behind its article: "the *first* box"."""
    articles: frozenset[str] = frozenset()
    names: Callable[[Sequence[str], str], bool] | None = None
    """Whether what is said between words and another word stands in the name of a thing; None: none is named."""
    called: PhraseSet = field(default_factory=lambda: PhraseSet(()))
    """Fillers that are the whole name of something: "the *ER*"."""
    hides: PhraseSet = field(default_factory=lambda: PhraseSet(()))
    """Fillers of several words of which one is a command: "*right* now"."""

    def misplaced(
        self, said: Utterance, position: int, length: int, before: Sequence[str], *, paused: bool = False
    ) -> bool:
        """Whether such a phrase stands here, and no command begins here, or a pause divides it.

        ``paused``: a pause stands before it, with nothing but fillers between: "turn left, please go ahead and stop".

        After a joint "right then" is no filler either: "turn left then right then left". Nor is "go and" one where its
        joint goes on: "go and then turn left" are two.
        """
        if self.hides.at(said.words, position) == length and self._is_said(said, position, length):
            return True
        if self.counting.at(said.words, position) == length:
            if before and self._counts_things(before[-1]):
                return paused or not self._counts_on(said, position, length, before)
            if not self.around.at(said.words, position):
                return True
        if self._describes(said, position, length, before) or self._names_something(said, position, length):
            return True
        if self.counted.at(said.words, position) == length:
            return paused or not self._counted_before(said, position, length, before)
        if before and self.place_of is not None and self.sounds.at(said.words, position) != length:
            end = self.fillers.after(said.words, position + length)
            place = self.place_of(before, said.words[end] if end < len(said) else "")
            if place is not None and place is not TextPlace.OUTSIDE:
                return self._belongs(said, position, length, end, place, paused=paused)
        if self.around.at(said.words, position) == length:
            end = self.around.after(said.words, position + length)  # "about another ten"
            return not any(map(self._counts, said.words[end : end + 1]))
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

    def _is_said(self, said: Utterance, position: int, length: int) -> bool:
        """Whether the command in such a filler is one: a pause parts it ("turn right, now left"), or its opposite
        follows, which it would be said against: "turn right now left"."""
        end = position + length
        against = opposed(said.words[position], self.language)
        parted = position > 0 and any(said.breaks[position + 1 : end])
        return len(against) > 0 and (parted or not {*said.words[end : end + 1]}.isdisjoint(against))

    def _counts_on(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether what is counted follows in the same breath: "one more coffee", but not "one more" nor "one more
        please". In a text ("tell anna two *more* people come") the word is a part of it."""
        end = position + length
        if end == len(said) or any(said.breaks[position : end + 1]):
            return False
        if self.fillers.at(said.words, end) or self.ends.at(said.words, end):
            return False
        return self.place_of is None or self.place_of(before, said.words[end]) is not TextPlace.WITHIN

    def _counted_before(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether the command ends here, with so many of something in the same breath: "sirve dos cafés más", but not
        "sirve dos más" nor "dos cafés más rápido". In a text ("toca una vez más") the words are a part of it."""
        end = position + length
        over = end == len(said) or said.breaks[end] or self.ends.at(said.words, end) or self.fillers.at(said.words, end)
        if not over or any(said.breaks[position:end]) or not before or self._counts(before[-1]):
            return False
        if self.place_of is not None and self.place_of(before, "") in (TextPlace.BEGINS, TextPlace.WITHIN):
            return False
        return any(map(self._counts_things, before[-1 - COUNTED_WORDS : -1]))

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

    def _describes(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether a filler tells which thing is meant: it stands in one breath between an article and the rest of a
        name. "The *first* aid kit" is no aid kit."""
        if self.names is None or not position or not before or said.words[position - 1] not in self.articles:
            return False
        end = position + length
        if not self.describing.issuperset(said.words[position:end]) or end == len(said):
            return False
        if any(said.breaks[position : end + 1]) or self.fillers.at(said.words, end) or self.ends.at(said.words, end):
            return False
        return self.names(before, said.words[end])

    def _names_something(self, said: Utterance, position: int, length: int) -> bool:
        """Whether a filler is the name of something where it stands: behind an article in one breath, and nothing else
        behind it that the article could be of. "Go to the *ER*, no, the hall", but "go to the er hall"."""
        if (
            not position
            or said.words[position - 1] not in self.articles
            or any(said.breaks[position : position + length])
        ):
            return False
        end = position + length
        over = end == len(said) or said.breaks[end] or self.ends.at(said.words, end) or self.fillers.at(said.words, end)
        return bool(over) and self.called.at(said.words, position) == length

    def _begins_name(self, said: Utterance, position: int, length: int, before: Sequence[str]) -> bool:
        """Whether a greeting stands in the midst of a command, in one breath: people greet before one or behind it."""
        end = position + length
        apart = any(said.breaks[position + 1 : end + 1]) or self.joints.ends(before) > 0
        end = self.fillers.after(said.words, end)
        return not apart and end < len(said) and not self.joints.at(said.words, end)

    def _begins_after(self, before: Sequence[str]) -> bool:
        return self.joints.ends(before) > 0 or self.again.ends(before) > 0

    def _counts_things(self, word: str) -> bool:
        """Whether a word says how many: where a grammar has places, "eine weitere Küche" is another one than that of
        the map, and no "Küche"."""
        article = self.places and self.language != "en" and foreign.is_article([word], self.language)
        return self._counts(word) and not article

    def _counts(self, word: str) -> bool:
        """Whether a word begins a number, or is one."""
        if is_numeral(word):
            return True
        return word in NUMBER_WORDS if self.language == "en" else foreign.is_number_word(word, self.language)
