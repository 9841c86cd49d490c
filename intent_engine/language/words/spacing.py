"""Words that are written together or apart: "takeoff" of a grammar that has "take off", "way point" of one that has
"waypoint". Recognisers and people write them as they like; they sound the same. So they do with "what is" and "what's",
which hardly sound otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from functools import cached_property
from itertools import pairwise, permutations
from typing import TypeAlias

from intent_engine.language.grammar import Grammar
from intent_engine.language.slots.adjacent_numbers import is_number
from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Reference, Sequence, Word
from intent_engine.language.utterance import Utterance
from intent_engine.language.vocabulary import vocabulary
from intent_engine.language.words.contractions import PRONOUNS, apart, in_full, together
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.verb_forms import verbs_told

__all__ = ["Spacing", "in_a_row"]

LEAST_LETTERS = 2
"""Of a part: "alight" is no "a light"."""
LEAST_BEHIND_A_LETTER = 3
"""Letters of a word behind a single one: "oclock" is "o clock", "tshirt" a "t shirt"."""
MOST_SPELLED = 5
"""Letters of what may be said letter by letter: "usb" of a grammar that has "u s b"."""

_VOWELS = frozenset("aeiouyhàâäæéèêëìîïòôöœùûü18")
"""What a word may begin with before which others are shortened."""

_JOINS_SLOTS = frozenset(("de",))
"""Languages that write a verb together with the word of a list before it: "zurückfahren", of "{direction} fahren"."""

_Words: TypeAlias = frozenset[str]
_Ends: TypeAlias = tuple[_Words, _Words, bool]
"""The words that a template may begin and end with, and whether it may be left out."""
_NONE: _Words = frozenset()
_SLOT = "\0slot"
"""What stands for whatever a slot holds."""


class Spacing:
    """How a grammar writes words that can be written together or apart. Thread-safe: at worst it is looked up twice."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar

    def otherwise(self, said: Utterance) -> Utterance | None:
        """The same utterance as the grammar writes it; None: it does not know it otherwise.

        A word that the grammar does not have is parted where two of its words follow each other, and two words become
        one that it has. None that changes what is meant ("not") is part of it.
        """
        parted = self.uncontracted(said)
        words, breaks = self._unelided(parted), list(parted.breaks)
        for place in range(len(words) - 1, -1, -1):
            if place and self._grammar.language in _JOINS_SLOTS and words[place - 1] in self._articles:
                continue  # "die Vorfahren": a noun
            parts = self._parted(words[place], words[place + 1 :]) or self._spelled(words, place)
            if parts is not None:
                words[place : place + 1] = parts
                breaks[place + 1 : place + 1] = [False] * (len(parts) - 1)
        for place in range(len(words) - 3, -1, -1):
            if length := self._spells(words, place, breaks):
                words[place : place + length] = ["".join(words[place : place + length])]
                del breaks[place + 1 : place + length]
        for place in range(len(words) - 2, -1, -1):
            one = self._one(words[place], words[place + 1], words[place + 2 :]) if not breaks[place + 1] else None
            if one is not None:
                words[place : place + 2] = [one]
                del breaks[place + 1]
        return Utterance(words, breaks) if words != said.words else None

    def _unelided(self, said: Utterance) -> list[str]:
        """Words before a vowel as the grammar has them, in full: of "le" and "la" the one that may follow there. The
        vowel may be of a filler that is gone: "d'environ deux mètres"."""
        words, full = said.words, list(said.words)
        for place, word in enumerate(words[:-1]):
            known = [one for one in in_full(word, self._grammar.language) if one in self._words]
            follows = [one for one in known if place and self.follow(full[place - 1], one)]
            if known and (words[place + 1][0] in _VOWELS or said.breaks[place + 1] is None):
                full[place] = (follows or known)[0]
        return full

    def uncontracted(self, said: Utterance, places: frozenset[str] | None = None) -> Utterance:
        """The utterance with words that are one for two as these, where the grammar has only the first and it follows
        there: "fahr zum Tor" as "fahr zu dem Tor" for "fahr zu {place}". The same one if there are none.

        Behind what says nothing there, or negates ("fahr bitte nicht zum"), what is before that counts; and what takes
        the place of something else ("nein, zur Tür") is said as that was.

        Args:
            said: the utterance.
            places: the words of the names of places, within which none is parted, nor is any that the grammar has
                elsewhere; None: these do not matter.
        """
        if not self.contracts(said):
            return said
        words: list[str] = []
        breaks: list[bool | None] = []
        for place, (word, pause) in enumerate(zip(said.words, said.breaks, strict=True)):
            parts = self._contracted.get(word, (word,))
            within = places is not None and places.issuperset((word, *said.words[max(0, place - 1) : place]))
            own = within or (places is not None and word in self._words)
            named = not (places or _NONE).isdisjoint(said.words[place + 1 : place + 2])
            if own or (len(parts) > 1 and not self._may_follow(words, parts[0], word, named=named)):
                parts = (word,)
            words += parts
            breaks += (pause, *[False] * (len(parts) - 1))
        return Utterance(words, breaks) if len(words) > len(said) else said

    def contracts(self, said: Utterance) -> bool:
        """A quick look: whether any word may be one for two that the grammar has."""
        return not self._contracted.keys().isdisjoint(said.words)

    def _may_follow(self, before: list[str], first: str, contracted: str, *, named: bool) -> bool:
        """Whether a word of the grammar follows some words there, and one that it begins does not. ``named``: whether
        the name of a place may come next, before which there may be that of a thing: "stell die Kiste zum Tor"."""
        led = next((word for word in reversed(before) if word not in self._passed), "")
        told = (verb for _, verb in verbs_told([led], self._grammar))
        if any(self.follow(verb, first) and not self.follow(verb, contracted) for verb in (led, *told)):
            return True
        if named and led not in self._words and first in self._behind_slots:
            return True
        return bool(before) and before[-1] in self._turning and first in before

    def _parted(self, word: str, after: list[str]) -> tuple[str, str] | None:
        """The two words that a word is in the grammar."""
        if word not in self._words and word not in self._closed and len(word) <= self._longest:
            for place in range(1, len(word) - LEAST_LETTERS + 1):
                first, second = word[:place], word[place:]
                if place < LEAST_LETTERS and (len(second) < LEAST_BEHIND_A_LETTER or first in self._articles):
                    continue
                if self._closed.isdisjoint((first, second)) and self.follow(first, second):
                    return first, second
        if self._grammar.language == "en":
            for first, second in apart(word):
                if self.follow(first, second) and (word not in self._words or self._goes_on(second, word, after)):
                    return first, second
        return None

    def _spelled(self, words: list[str], place: int) -> tuple[str, ...] | None:
        """The letters of a word, where the grammar has them one by one: "tv" of "t v". So is "am" behind a number."""
        word = words[place]
        if not LEAST_LETTERS <= len(word) <= MOST_SPELLED or word in self._words or not self._letters.issuperset(word):
            return None
        if word in self._closed and not (place and is_number(words[place - 1], self._grammar.language)):
            return None
        return tuple(word) if all(self.follow(one, other) for one, other in pairwise(word)) else None

    def _spells(self, words: list[str], place: int, breaks: list[bool | None]) -> int:
        """How many letters that begin at a place, three or more, are a word of the grammar; 0: none are."""
        length = 0
        for word, pause in zip(words[place:], breaks[place:], strict=True):
            if len(word) > 1 or not word.isalpha() or (length and pause) or length == MOST_SPELLED:
                break
            length += 1
        known = self._words | self._things if length > LEAST_LETTERS else _NONE
        lengths = range(length, LEAST_LETTERS, -1)
        return next((one for one in lengths if "".join(words[place : place + one]) in known), 0)

    def _one(self, first: str, second: str, after: list[str]) -> str | None:
        """The word of the grammar that two words are."""
        whole = first + second
        if len(whole) == LEAST_LETTERS and self.follow(first, second):
            return None  # of "u s b", though there is an "us"
        if (whole in self._words or whole in self._things) and self._closed.isdisjoint((first, second, whole)):
            return whole
        short = together(first, second) if self._grammar.language == "en" else None
        if short is None or short not in self._words:
            return None
        if short == first + "s" and first in self._words and first not in PRONOUNS:
            return None  # the grammar has both: "forward is" is no "forwards"
        return short if not self.follow(first, second) or self._goes_on(short, second, after) else None

    def _goes_on(self, one: str, other: str, after: list[str]) -> bool:
        """Whether what comes next follows one word in the grammar, and not the other."""
        return bool(after) and self.follow(one, after[0]) and not self.follow(other, after[0])

    def follow(self, first: str, second: str) -> bool:
        """Whether one word may follow another in the grammar."""
        return any(first in ends and second in begins for ends, begins in self._following)

    @cached_property
    def _words(self) -> _Words:
        stops = (word for words in self._grammar.operators.stop for word in words)
        return frozenset(word for word in (*vocabulary(self._grammar), *stops) if word.isalpha())

    @cached_property
    def _things(self) -> _Words:
        """The words that free slots list: as likely names, and not as sentences to be parted into."""
        return frozenset(word for slot in self._grammar.slots.values() for word in slot.known if word.isalpha())

    @cached_property
    def _letters(self) -> _Words:
        """Words of a single letter."""
        return frozenset(word for word in self._words if len(word) == 1)

    @cached_property
    def _longest(self) -> int:
        """Letters of two words of the grammar, at most."""
        return 2 * max(map(len, self._words), default=0)

    @cached_property
    def _contracted(self) -> Mapping[str, tuple[str, ...]]:
        """Words that are one for two, and these, of which the grammar has the first."""
        contracted = thing_words(self._grammar.language).contracted
        return {word: parts for word, parts in contracted.items() if parts[0] in self._words}

    @cached_property
    def _passed(self) -> _Words:
        """Single words that say nothing, or negate."""
        grammar = self._grammar
        rows = (*grammar.fillers, *grammar.around, *grammar.operators.negation)
        return frozenset(words[0] for words in rows if len(words) == 1).difference(vocabulary(grammar))

    @cached_property
    def _turning(self) -> _Words:
        """Words with which what corrects, contrasts or joins may end."""
        operators = self._grammar.operators
        rows = (*operators.correction, *operators.contrast, *operators.sequence)
        return frozenset(words[-1] for words in rows)

    @cached_property
    def _behind_slots(self) -> _Words:
        """Words that stand behind slots in sentences."""
        slots = {name: Word(_SLOT) for name in self._grammar.slots}
        intents = self._grammar.intents.values()
        templates = (sentence.template for intent in intents for sentence in intent.all_sentences)
        following = _Neighbours({**slots, **self._grammar.phrases}).of(templates)
        return _NONE.union(*(begins for ends, begins in following if _SLOT in ends))

    @cached_property
    def _articles(self) -> Collection[str]:
        return thing_words(self._grammar.language).articles

    @cached_property
    def _closed(self) -> _Words:
        return self._grammar.operators.closed

    @cached_property
    def _following(self) -> list[tuple[_Words, _Words]]:
        """Words that may end a part of a sentence, with those with which the next part may begin."""
        grammar = self._grammar
        templates = [sentence.template for intent in grammar.intents.values() for sentence in intent.all_sentences]
        templates += [node for slot in grammar.slots.values() for _, node in slot.values]
        templates += [Sequence(tuple(map(Word, words))) for words in grammar.operators.stop]
        slots = grammar.slots if grammar.language in _JOINS_SLOTS else {}
        lists = {name: Choice(tuple(node for _, node in slot.values)) for name, slot in slots.items() if slot.values}
        return _Neighbours({**lists, **grammar.phrases}).of(templates)


def in_a_row(grammar: Grammar, words: Iterable[str]) -> bool:
    """Whether words may follow each other, all of them, in what the grammar writes out."""
    spacing = Spacing(grammar)
    return all(spacing.follow(first, second) for first, second in pairwise(words))


class _Neighbours:
    """Words that follow each other in templates. What slots hold stays by itself, unless they are given as phrases."""

    def __init__(self, phrases: Mapping[str, Node]) -> None:
        self._phrases = phrases
        self._walked: dict[str, _Ends] = {}
        """What is known of phrases, which may hold each other many times over."""
        self._found: dict[tuple[_Words, _Words], None] = {}

    def of(self, templates: Iterable[Node]) -> list[tuple[_Words, _Words]]:
        for node in templates:
            self._walk(node)
        return list(self._found)

    def _phrase(self, name: str) -> _Ends:
        if name not in self._walked:
            self._walked[name] = self._walk(self._phrases[name])
        return self._walked[name]

    def _walk(self, node: Node) -> _Ends:
        match node:
            case Word(text):
                return frozenset((text,)), frozenset((text,)), False
            case Reference(name, _, _) if name in self._phrases:
                return self._phrase(name)
            case Optional(item):
                begins, ends, _ = self._walk(item)
                return begins, ends, True
            case Choice(items):
                return self._any([self._walk(item) for item in items], any)
            case Sequence(items):
                begins, ends, empty = _NONE, _NONE, True
                for item in items:
                    first, last, skipped = self._walk(item)
                    self._follow(ends, first)
                    begins = begins | first if empty else begins
                    ends = ends | last if skipped else last
                    empty = empty and skipped
                return begins, ends, empty
            case AnyOrder(items):
                walked = [self._walk(item) for item in items]
                for one, other in permutations(walked, 2):
                    self._follow(one[1], other[0])
                return self._any(walked, all)
        return _NONE, _NONE, False

    @staticmethod
    def _any(walked: list[_Ends], empty: Callable[[Iterable[bool]], bool]) -> _Ends:
        begins, ends, skipped = zip(*walked, strict=True)
        return _NONE.union(*begins), _NONE.union(*ends), empty(skipped)

    def _follow(self, ends: _Words, begins: _Words) -> None:
        if ends and begins:
            self._found[ends, begins] = None
