"""A sentence of a grammar beside the words that models heard: what it passes over, and what of it nobody heard."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from intent_engine.actions import Action
from intent_engine.language.numbers.letters import is_letter_of_a_code
from intent_engine.language.words.homophones import LETTERS_BY_SOUND
from intent_engine.language.words.opposites import opposed
from intent_engine.language.words.thing_words import ARTICLES
from intent_engine.speech.hypotheses.dictating import begin_of
from intent_engine.speech.hypotheses.left_open import open_range, open_word
from intent_engine.speech.hypotheses.left_out import (
    begin_left_out,
    begins_unheard,
    end_left_out,
    heard_otherwise,
    in_place_of,
    passed_over,
    tells,
    told_of,
    unheard,
)
from intent_engine.speech.hypotheses.narration import (
    ASKING,
    OTHERS,
    SUBJECTS,
    asks_politely,
    asks_whether,
    lets_another,
    misheard,
    told,
    verbless,
)
from intent_engine.speech.hypotheses.spoken_grammar import SpokenGrammar

__all__ = ["SaidAndHeard"]

SURE_OF_OTHERS = 0.9
"""Confidence from which other words than those that all models heard were said all the same."""


@dataclass(frozen=True, slots=True)
class SaidAndHeard:
    """One sentence, and the words that one or several models heard. A stop passes over nothing, since it waits for
    nothing; nor does what is dictated."""

    grammar: SpokenGrammar
    words: Sequence[str]
    """Of the sentence."""
    heard: Sequence[Sequence[str]]
    """The words that each model heard."""
    language: str | None = None
    """Of the speech."""
    texts: Sequence[str] = ()
    """What each model heard, as it wrote it; empty: it is not known."""

    def left_out(self) -> tuple[str, ...]:
        """The first and the last words that were heard, where the sentence begins or ends otherwise, with such as say
        something."""
        if self._free:
            return ()
        grammar, language = self.grammar, self.language
        begin = self.begin_left_out()
        if not begin and not grammar.wake(language).after(self.words) and self._english:
            lead = min((grammar.lead(one, language) for one in self.heard), default=0)
            begin = told(self.words, self.heard, lead) or self._told_of()
        end = end_left_out(self.words, self.heard)
        return tuple(" ".join(part) for part in (begin, end) if not grammar.says_nothing(part, language))

    def begin_left_out(self) -> Sequence[str]:
        """As :func:`~intent_engine.speech.hypotheses.left_out.begin_left_out`. Of a sentence that its grammar has in
        another way ("turn the lamp on") one model is enough, and one letter: whoever tells of it puts it so as well,
        and of "he turned the lamp on" in noise one may hear "e turned a land on"."""
        led = [(one, self.grammar.lead(one, self.language)) for one in self.heard]
        if not self.grammar.put_otherwise(self.words, self.language):
            return begin_left_out(self.words, self._lead, led)
        each = (begin_left_out(self.words, self._lead, [one], least=1) for one in led)
        return next(filter(None, each), ())

    def heard_otherwise(self, confidence: float) -> tuple[str, ...]:
        """What all models heard in the place of words of the sentence, where that is something else; but what is as
        good as sure is what it is: a "marker" may be a mocha.

        Args:
            confidence: in the sentence.
        """
        if self._free:
            return ()
        said = tells(self.words, self.heard) if self._english else ()
        if not said and confidence < SURE_OF_OTHERS:
            said = heard_otherwise(self.words, self.heard, self._says_nothing)
        return (" ".join(said),) if said and not self._says_nothing(said) else ()

    def opposite(self) -> tuple[str, ...]:
        """The word that all models heard and the sentence has not, where this has its opposite, which none heard: with
        "switch the lamp off" nobody means "switch the lamp on", however alike they sound."""
        if self._free or not self.heard:
            return ()
        written_apart = {one + other for one, other in pairwise(self.words)}  # "counter clockwise"
        shared = set.intersection(*map(set, self.heard)) - set(self.words) - written_apart
        unheard = set(self.words).difference(*self.heard)
        said = sorted(word for word in shared if not unheard.isdisjoint(opposed(word, self.language)))
        return tuple(said[:1])

    def begun_otherwise(self) -> tuple[str, ...]:
        """The word with which all models heard a command of the grammar begin, where this one begins with another that
        none heard: "set the oven" is no "shut the oven", but has not been said to the end. One of them must have heard
        more of it than its verb: "make the rolls" may be "bake the rolls", though there is "make it hotter"."""
        lead = self._lead
        if self._free or not self.heard or lead + 1 >= len(self.words):  # of single words all others are weighed anyway
            return ()
        heard = [one[self.grammar.lead(one, self.language) :] for one in self.heard]
        begun = {next(iter(one), "") for one in heard}
        if len(begun) > 1 or any(self.words[lead] in one for one in heard):
            return ()
        return tuple(begun) if any(self.grammar.begins(one, self.language) for one in heard) else ()

    def letter_otherwise(self) -> tuple[str, ...]:
        """The word of the grammar that all models heard and the sentence has not, where it has a letter beside a number
        that none heard: of "bay five" nobody knows which bay it is, and it is no "b five". A "be" may be that
        letter."""
        if self._free or not self.heard or not self._english:
            return ()
        heard = {LETTERS_BY_SOUND.get(word, word) for one in self.heard for word in one} | ARTICLES
        if all(word in heard for at, word in enumerate(self.words) if is_letter_of_a_code(self.words, at)):
            return ()
        shared = [word for word in self.heard[0] if len(word) > 1 and all(word in one for one in self.heard)]
        others = (word for word in shared if word not in self.words and word not in ARTICLES)
        known = (word for word in others if self.grammar.share_known([word], self.language) == 1.0)
        return tuple(word for word in known if not self._says_nothing([word]))[:1]

    def left_open(self) -> tuple[str, ...]:
        """What all models heard that leaves open what is meant, and the sentence has not: "or", "at most", "two to
        four"."""
        if self._free:
            return ()
        wording, heard = self.grammar.wording(self.language), self.heard
        found = open_word(self.words, heard, wording.leaves_open)
        found = found or open_range(self.words, heard, wording.ranging, self.language, texts=self.texts)
        return (" ".join(found),) if found else ()

    def passed_over(self) -> tuple[str, ...]:
        """What all models heard within the sentence, and with which it does not mean the same."""
        if self._free:
            return ()
        meaning = self._meaning(self.words)
        for said, place in passed_over(self.words, self.heard):
            if self._meaning([*self.words[:place], *said, *self.words[place:]]) != meaning:
                return (" ".join(said),)
        return ()

    def _meaning(self, words: Sequence[str]) -> tuple[Action, ...]:
        return self.grammar.parse(" ".join(words), self.language).actions

    def either_heard(self) -> tuple[str, ...]:
        """The joint of two commands, where a model heard that one of them is meant: "raise it *or* lower it"."""
        if self._free:
            return ()
        either = self.grammar.wording(self.language).alternatives
        pairs = (pair for one in self.heard for pair in in_place_of(self.words, one))
        return tuple(meant for said, meant in pairs if said in either and self.grammar.joins(meant, self.language))[:1]

    def begins_unheard(self) -> tuple[str, ...]:
        """The word with which the command begins, where no model heard it, and what they heard is none."""
        lead = self._lead
        if self._free or lead >= len(self.words):
            return ()
        if not begins_unheard(self.words, lead, self.heard) and not self._verbless(lead):
            return ()
        rest = self.grammar.parse(" ".join(self.words[lead + 1 :]), self.language)
        return () if rest.actions else (self.words[lead],)

    def unheard_inside(self) -> tuple[str, ...]:
        """Words of the sentence that are like nothing that was heard."""
        return () if self._free else tuple(unheard(self.words, self.heard))

    def _told_of(self) -> Sequence[str]:
        led = [(one, self.grammar.lead(one, self.language)) for one in self.heard]
        persons = {*SUBJECTS, *OTHERS, *ASKING}.difference(self.words, ("it",))  # a "let's" is heard as "it"
        said = told_of(self.words, self._lead, led, persons) or lets_another(self.words, self._lead, led)
        said = said or asks_politely(self.words, self._lead, self.heard)
        return said or asks_whether(self.words, self._lead, led)

    @property
    def _free(self) -> bool:
        return bool(begin_of(self.words)) or self.grammar.parse(" ".join(self.words), self.language).stops

    def _verbless(self, lead: int) -> bool:
        led = [(one, self.grammar.lead(one, self.language)) for one in self.heard]
        if any(count and misheard(one[count - 1], self.words[lead]) for one, count in led):
            return False  # "and half a teaspoon" for "add half a teaspoon"
        return self._english and verbless(self.words, lead, [one[count:] for one, count in led])

    @property
    def _english(self) -> bool:
        return self.language in (None, "en")

    @property
    def _lead(self) -> int:
        return self.grammar.lead(self.words, self.language)

    def _says_nothing(self, part: Sequence[str]) -> bool:
        return self.grammar.says_nothing(part, self.language)
