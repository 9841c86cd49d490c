"""What may be said where any words will do: the name of a thing or of a place that no map has."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence

from intent_engine.language import quantities
from intent_engine.language.grammar import FREE_KINDS, Grammar, Slot
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.numbers.numerals import is_numeral
from intent_engine.language.slots.name_words import accented_names
from intent_engine.language.slots.taken_things import TakenThings
from intent_engine.language.slots.told_besides import ToldBesides
from intent_engine.language.words.contractions import shortened
from intent_engine.language.words.phrase_set import PhraseSet
from intent_engine.language.words.thing_words import ARTICLES, thing_words

__all__ = ["FreeText"]

_COUNTING = NUMBER_WORDS | {"couple", "pair"}
_AMOUNTS = ("distance", "angle", "duration", "speed", "percent")


class FreeText:
    """The free words of one grammar's slots."""

    def __init__(self, grammar: Grammar) -> None:
        self._grammar = grammar
        # Single words of these are closed to free slots already; phrases are only seen whole.
        self._language, operators = grammar.language, grammar.operators
        self._closed = operators.closed
        changing = (
            *operators.stop, *operators.negation, *operators.correction, *operators.cancel, *operators.sequence,
        )  # fmt: skip
        self._operators = PhraseSet(words for words in changing if len(words) > 1)
        self._joints = {words[0] for words in operators.sequence if len(words) == 1 and words not in operators.later}
        """Words that join, and that a slot may allow: "salt and pepper". What they end joins another command."""
        self._pointing = {words[0] for words in operators.pronoun if len(words) == 1}
        """Words for a thing that was named before."""
        self._fillers = PhraseSet(grammar.fillers)
        counting = {word for words in grammar.counting for word in words}
        self._once_more = PhraseSet([word for word in one if word not in counting] for one in grammar.wording.once_more)
        telling = {*grammar.wording.greetings, *grammar.wording.agreeing}
        self._idle = PhraseSet(words for words in grammar.fillers if words not in telling)
        """Fillers that tell nobody anything: "please", "now"."""
        self._words = words = thing_words(grammar.language)
        idle = (*grammar.fillers, *grammar.wording.softens)
        self._begins_no_thing = words.persons | words.where | {phrase[0] for phrase in idle if phrase}
        self.articles = words.articles or ARTICLES
        """Words before a name that are no part of it."""
        self._bare_articles = self.articles - words.telling_which
        """Those of them that no title or message needs either."""
        self._going_on = words.joining - words.may_begin
        self.no_beginning = self._going_on | words.within
        """Words with which no thing begins, though a song may: "for", "at"; nor with what is within one: "of"."""
        # "Both the cup and the plate" are two things, and so are "the cup and the plate both".
        self._both = both = {phrase[0] for phrase in grammar.wording.both_of}
        self._begin_none = self.no_beginning | both
        self._whither = words.joining.intersection(words.contracted) | both
        """Prepositions with their article, where any thing may be named: "pose-le *au* bar" names none."""
        self._unfinished_things = words.unfinished | words.joining | words.not_bare
        self._parted = frozenset(grammar.wording.parted)  # which belong to a verb: "hol die Tasse *raus*"
        self._binding = (words.joining | self.articles | words.binding) - {one[0] for one in grammar.wording.why}
        self._begun = shortened(operators.closed | words.pronouns) if self._language == "en" else frozenset[str]()
        """Pronouns with their verb, with which something else begins: "the cup *it's* hot"."""
        self._taken = TakenThings(grammar)
        self._besides, self._softens = ToldBesides(grammar), grammar.wording.softens
        self.unfinished = words.unfinished
        """Words that are never the last."""
        self.alone = words.unfinished | words.alone
        """Words that are never the only one."""

    def is_thing(self, slot: Slot) -> bool:
        """Whether a slot holds the name of a thing: it lists some, is of type ``object``, or is picked up or put."""
        return slot.type in FREE_KINDS and (bool(slot.known) or slot in self._taken)

    def _names_a_thing(self, slot: Slot) -> bool:
        """The same, but not of what is dictated, unless it is one of a list."""
        return self.is_thing(slot) and bool(slot.known or not slot.dictation)

    def unfinished_in(self, slot: Slot) -> frozenset[str]:
        """Words that are never the last in a slot."""
        return self._unfinished_things - slot.known if slot.known else self.unfinished

    def problem(self, slot: Slot, words: Sequence[str], start: int, end: int) -> str:
        """Why the words from ``start`` to ``end`` are nothing for a slot; empty: they may be."""
        said = words[start:end]
        listed = bool(slot.known_names) and self._is_listed(slot, said)
        wrong = slot.without.intersection(said)
        if not listed:  # "the brake pads" are a thing where they are known, and "the brake" is none
            wrong |= (self._closed & slot.known).intersection(said) - slot.allow
        if not slot.dictation and self._parts_a_number(words, start, end):
            return f"{' '.join(said)!r} goes on with a number, and is nothing for slot {slot.name!r}"
        if not self._words.either.isdisjoint(said) and (word := self._leaves_open(slot, said)):
            return f"{word!r} leaves open which is meant in {' '.join(said)!r}; say one of them"
        if said and not slot.dictation:  # a title may begin with "and", no thing does
            wrong |= self._joints.intersection((said[0], said[-1]) if slot.known else (said[-1],))
        begun = self._begin_none if slot.known else self._whither if self._names_a_thing(slot) else frozenset[str]()
        if said and said[0] in begun and not _meant(slot, said[0]):
            wrong = frozenset((said[0],))
        if said and not wrong and self._names_a_thing(slot):
            wrong = self._begins_behind_an_article(said)
        if said and not wrong and said[0] in self._begins_no_thing and self._is_no_thing(slot, words, start, end):
            wrong = frozenset((said[0],))
        if said and not wrong and self._names_a_thing(slot):
            wrong = self._no_name(slot, said)
        # One that begins here, wherever it ends: "down, change that to" holds the beginning of "change that to".
        if not listed and self._operators.may_stand_in(said):
            operator = next(((at, n) for at in range(start, end) if (n := self._operators.at(words, at))), None)
            phrase = words[operator[0] : sum(operator)] if operator is not None else ()
            if not slot.allow.issuperset(phrase):
                wrong = frozenset((" ".join(phrase),))
        return f"{min(wrong)!r} is nothing for slot {slot.name!r}" if wrong else ""

    def _is_listed(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether words are a name that a slot lists, behind articles or not."""
        return tuple(itertools.dropwhile(self.articles.__contains__, said)) in slot.known_names

    def _begins_behind_an_article(self, said: Sequence[str]) -> frozenset[str]:
        """The word with which no name begins, between two articles: "the *with* the bad", of which a noun that may be a
        filler was left out. "The in tray" is a thing, and so is "that" on the table."""
        if len(said) < 3 or said[0] not in self.articles - self._pointing or said[2] not in self.articles:
            return frozenset()
        return frozenset(said[1:2]) & self.no_beginning

    def _leaves_open(self, slot: Slot, said: Sequence[str]) -> str:
        """The word that shows that one of two is meant, and not which: "the cup *or* the glass". Empty: none does.

        Things are never called so. What else is free may be, without an article ("play jazz or rock"), but begins with
        none ("tell Anna or Tom it is late"). A letter at the end is a name ("caja o").
        """
        if slot.dictation:
            return ""
        thing = self.is_thing(slot)
        for place, (word, after) in enumerate(zip(said, (*said[1:], ""), strict=True)):
            is_open = (after and not place) or after in self.articles or (thing and (after or len(word) > 1))
            if is_open and word in self._words.either and not _meant(slot, word):
                return word
        return ""

    def _parts_a_number(self, words: Sequence[str], start: int, end: int) -> bool:
        """Whether a number that is said with another one stands half outside: "two [or three eggs]", "two
        [three eggs]", "[soup for two to] three minutes". Which of them was meant nobody knows.

        A number with its unit belongs to the thing: "two [three meter cables]".
        """
        said = words[start:end]
        if not said:
            return False
        if start and self._counts(words[start - 1]):
            at = int(len(said) > 1 and said[0] in self._words.ranging)
            if self._counts(said[at]) and not (at == 0 and self._measures(said)):
                return True
        return (
            end < len(words)
            and len(said) > 1
            and said[-1] in self._words.ranging
            and self._counts(said[-2])
            and self._counts(words[end])
        )

    def _measures(self, said: Sequence[str]) -> bool:
        """Whether words begin with an amount that has a unit: "three meter cables"."""
        return any(
            quantities.evaluate(said[:end], kind, self._language) is not None
            for end in range(2, len(said) + 1)
            for kind in _AMOUNTS
        )

    def _is_no_thing(self, slot: Slot, words: Sequence[str], start: int, end: int) -> bool:
        """Whether words are nothing that a hand takes, in a slot whose thing is taken: they are or begin with a person
        ("grab me", "get me the cup", but "the us flag"), only say where ("grab there"), say nothing ("grab, please"),
        or begin with what softens an order ("prends *aussi* la tasse"). In any they are none where a person is given
        something: "print *me a* gear", "bring *me* dune"."""
        said, before, wording = words[start:end], words[:start][-1:], self._grammar.wording
        if _meant(slot, said[0]):
            return False
        if slot not in self._taken:
            given = said[0] in wording.for_whom and not (slot.dictation or wording.gives.isdisjoint(before))
            brought = not wording.brings.isdisjoint(before) and said[-1] not in self._words.joining  # "get me dune"
            return given and len(said) > 1 and (said[1] in self.articles or (brought and said[1] not in self._going_on))
        if said[0] in self._words.where:
            return len(said) == 1
        if said[0] not in self._words.persons:
            return self._fillers.cover(said) or self._softens.at(said, 0) > 0
        return len(said) == 1 or said[1] in self.articles or said[1] in self._words.joining

    def _no_name(self, slot: Slot, said: Sequence[str]) -> frozenset[str]:
        """The word that shows that words are not the name of one thing."""
        allowed = slot.allow
        if never := self._words.never.intersection(said) - allowed - slot.known - self._words.either:
            return never
        no_end = self._parted | self._both
        behind = self._once_more.ends(said) or int(said[-1] in no_end and not _meant(slot, said[-1]))
        if 0 < behind < len(said):
            return frozenset((" ".join(said[-behind:]),))
        bare = bool(slot.known) and said[0] in self._words.not_bare  # where none is listed, "used cups" may be some
        if bare and said[0] not in allowed and (len(said) > 1 or said[0] not in slot.known):
            return frozenset((said[0],))
        for place in range(1, len(said)):
            word = said[place]
            where = word in self._going_on and word not in self._words.whither
            led = bool(slot.known) and said[place - 1] in self._words.pronouns  # else there may be an "us flag"
            besides = (word in self._words.pronouns or word in self._begun) and word not in allowed
            besides = (besides or word in self._words.telling) and said[place - 1] not in self._binding
            if besides or (led and not where and word not in allowed):
                return frozenset((word,))  # "the cup, wash it" does something else besides
            last = place == len(said) - 1
            begins = word in self._words.next_begins and not (last and len(word) == 1)  # "box a" has a letter
            if begins and (last or said[place - 1] not in self._binding):
                return frozenset((word,))
        return frozenset()

    def tells_besides(self, slot: Slot, words: Sequence[str]) -> bool:
        """Whether words behind a pause are no part of a thing before them. A title may go on so."""
        return self._names_a_thing(slot) and words[0] not in slot.allow and self._besides.begins(words)

    def is_unfinished(self, slot: Slot, said: Sequence[str], start: int) -> bool:
        """Whether the words are only the beginning of a thing's name: for patterns; the automaton ends nothing so."""
        if slot.dictation and self._fillers.cover(said):
            return True  # "take a note, please"
        alone = list(said) == ["a"] and start > 0  # "ticket a" has a letter
        last = said[-1]
        if last in self.articles and quantities.part_of_one(said[-2:], self._language) is not None:
            return True  # "half a"
        never_last = self._unfinished_things if slot.known else self.unfinished
        return (alone or (last in never_last and last not in slot.known)) and last not in slot.allow

    def is_left_out(self, slot: Slot, words: Sequence[str], start: int, end: int) -> bool:
        """Whether words with which a sentence ends say nothing, so that the text or the name in their place is still
        to be said: "open, please". Where the sentence goes on they are meant: "translate please into French"."""
        said = words[start:end]
        return end == len(words) and self._idle.cover(said) and not all(_meant(slot, word) for word in said)

    def no_handful(self, slot: Slot, said: Sequence[str]) -> str:
        """The word of a whole name that says that no thing is meant; empty: none does. Where a slot lists no things it
        can only be a last one that says how: "the box gently"."""
        if not slot.known:
            how = self._names_a_thing(slot) and self._words.is_manner(said[-1]) and not _meant(slot, said[-1])
            return said[-1] if how else ""
        alone = len(said) == 1 or (said[0] in self._words.pronouns and said[-2] in self._words.joining)
        if alone and said[-1] in self._words.bare and said[-1] not in slot.allow:
            return said[-1]  # "take part", though a part is a thing; "take it on board"
        if len(said) > 1 and (self._points_at_all(slot, said) or self._is_a_particle(slot, said)):
            return said[-1]
        if word := self._taken.stays(slot, said):
            return word
        beside = zip(said, ("", *said[:-1]), (*said[1:], ""), strict=True)
        return next(
            (
                word
                for word, before, after in beside
                if (not after or after in self._words.joining or self._of_nothing(word, after))
                and not _meant(slot, word)
                and (
                    (self._words.is_not_held(word) and not self._is_solid(before, word, after))
                    or self._words.is_manner(word)
                )
            ),
            "",
        )

    def _points_at_all(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether a word that is no thing by itself stands behind "that" or the like, which is all that is named: "take
        that back", though "the back" may be a thing."""
        if said[-1] not in self._words.alone or said[-1] in self.articles or said[-1] in slot.allow:
            return False
        return self._pointing.issuperset(said[:-1])

    def _is_a_particle(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether the last word belongs to the verb before a name: "take the cup *back*". Behind an article, another
        such word or a word that describes, it may be a part of a thing: "the cup at the back"."""
        last, before = said[-1], said[-2]
        if last not in self._words.alone or last in self.articles or last in slot.allow or last not in slot.known:
            return False
        return before not in self._binding and before not in self.alone

    def _is_solid(self, before: str, word: str, after: str) -> bool:
        """Whether the word before makes a thing of one that is none: "toy bus", "remote control", but not "remote
        control of"."""
        solid = self._words.solid
        return (before in solid or f"{before} {word}" in solid) and after not in self._words.within

    def _of_nothing(self, word: str, after: str) -> bool:
        """Whether a word and "of" say that no thing is meant: "advantage of", but not "head of"."""
        return after in self._words.within and word not in self._words.had and not self._words.is_manner(word)

    def tells_when(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether the name of a thing ends with when or how often it is wanted, or for how long: "the cup in five
        minutes", "the cup at three", "the cup every hour", "the cup on Monday"."""
        if self.is_thing(slot) and self._ends_with_days(said):
            return True
        delaying, timed = self._words.delaying, self._words.timed
        if (delaying.isdisjoint(said[1:-1]) and timed.isdisjoint(said[1:-1])) or not self.is_thing(slot):
            return False
        before = len(said) - 2
        while said[before] in self.articles and before > 1:
            before -= 1
        if before > 0 and said[before] in timed and self._counts(said[-1]):
            return True
        return any(
            said[place] in delaying and quantities.evaluate(said[place + 1 :], "duration", self._language) is not None
            for place in range(1, len(said) - 1)
        )

    def _ends_with_days(self, said: Sequence[str]) -> bool:
        """Whether words behind the first say on which days, or how often: "this evening", "every two hours"; but "the
        plan of this week" is one."""
        known = self._words
        for place in range(1, len(said) - 1):
            rest = said[place + 1 :]
            if said[place - 1] in known.within or said[place] not in known.dating:
                continue
            if len(rest) == 1 and rest[0] in known.days:
                return True
            if said[place] in known.repeating and quantities.evaluate(rest, "duration", self._language) is not None:
                return True
        return False

    def is_amount(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether the words say only how much or how many, in a slot that lists things: "take five", "two meters".

        So does a number with a measure of things, "half a kilo", where no thing follows. A coin may be called a
        quarter, so a fraction is none; "that one" is a thing that was named before. A count before "to" or the like is
        an amount as well: "five to the library".
        """
        if not slot.known or not any(map(self._counts, said)):
            return False
        end = next((place for place, word in enumerate(said) if place and word in self._words.joining), len(said))
        said = said[:end]
        bare = self._without_articles(said)
        for words in (said, bare) if len(bare) < len(said) else (said,):
            if any(quantities.evaluate(words, kind, self._language) is not None for kind in _AMOUNTS):
                return True
            if words[-1] in self._words.measures and self._is_count(words[:-1]):
                return True
            count = quantities.evaluate(words, "number", self._language)
            if isinstance(count, float) and count.is_integer() and (count != 1 or words is said):
                return True
        return False

    def _is_count(self, words: Sequence[str]) -> bool:
        """Whether words say how many there are, or how much of one: "half a"."""
        return any(after == len(words) for _, after in quantities.counts(words, self._language))

    def _counts(self, word: str) -> bool:
        """A quick look: whether a word may be one of a number."""
        if self._language == "en":
            return word in _COUNTING or word[:1].isdigit()
        return word[:1].isdigit() or quantities.is_number_word(word, self._language)

    def _without_articles(self, words: Sequence[str], articles: Collection[str] = ()) -> Sequence[str]:
        articles = articles or self.articles
        while len(words) > 1 and words[0] in articles and not _is_code(words):
            words = words[1:]
        return words

    def has_room(self, slot: Slot, said: Sequence[str]) -> bool:
        """Whether a slot takes so many words: its articles are none of them."""
        return len(said if slot.dictation else self._without_articles(said)) <= slot.max_words

    def thing(self, slot: Slot, said: Sequence[str]) -> str:
        """The name without its articles, in one word where the slot lists it so ("screw driver"), and with its accents
        ("jose"). A title or a message keeps "my" and "this". What is dictated is no name."""
        words = list(said)
        if slot.dictation:
            return " ".join(words)
        if accented := accented_names(slot.known):
            words = [accented.get(word, word) for word in words]
        words = list(self._without_articles(words, self.articles if self.is_thing(slot) else self._bare_articles))
        for place in range(len(words) - 2, -1, -1):
            if (whole := "".join(words[place : place + 2])) in slot.known:
                words[place : place + 2] = [whole]
        return " ".join(words)


def _meant(slot: Slot, word: str) -> bool:
    """Whether a slot lists a word, or lets it stand in what it holds."""
    return word in slot.known or word in slot.allow


def _is_code(words: Sequence[str]) -> bool:
    """Whether words begin with a letter that is no article: "a 42"."""
    return len(words[0]) == 1 and is_numeral(words[1])
