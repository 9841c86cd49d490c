"""The phrases of speech in one grammar, and what can be seen from them alone: before any sentence is looked at."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import cache

from intent_engine.language.grammar import FREE_KINDS, Grammar
from intent_engine.language.meaning.fillers_or_commands import FillersOrCommands, before_joint
from intent_engine.language.meaning.objections import Objections
from intent_engine.language.reading import Reading
from intent_engine.language.templates.spellings import own_words
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.openers import Openers, TextPlace
from intent_engine.language.words.phrase_set import PhraseSet, SomePhrases
from intent_engine.language.words.spacing import in_a_row
from intent_engine.language.words.thing_words import thing_words

__all__ = ["Phrases"]


class Phrases:
    """Fillers, wake words and operators (stop, negation, correction ...) of a grammar, ready to be found.

    Args:
        grammar: whose phrases they are.
        lists: whether words are a command without a verb, as they stand in a list: "right". None: not known.
        place_of: where what is said between words and another word stands in a text of any words; None: there is none.
        names: whether it stands in the name of a thing; None: not known.
        called: whether something is called so, in a list or on the map; None: not known.
    """

    def __init__(
        self,
        grammar: Grammar,
        lists: Callable[[list[str]], bool] | None = None,
        place_of: Callable[[Sequence[str], str], TextPlace | None] | None = None,
        names: Callable[[Sequence[str], str], bool] | None = None,
        called: Callable[[tuple[str, ...]], bool] | None = None,
    ) -> None:
        operators, wording = grammar.operators, grammar.wording
        self._articles = thing_words(grammar.language).articles
        self.merely, self.led_by = wording.merely, wording.led_by
        """What says no more before so much, in whatever pauses."""
        self.roughly = wording.roughly
        """The same behind it: "two minutes *or so*"."""
        own = own_words(grammar)
        counting = [words for words in grammar.counting if own.isdisjoint(words)]
        counted = [words for words in grammar.counted if not own.issuperset(words)]
        fillers = (*grammar.fillers, *grammar.around, *counting, *counted)
        self.fillers = PhraseSet(fillers)
        self.idle = PhraseSet(words for words in fillers if not own.issuperset(words))
        """Fillers that no sentence needs: without "for me", "wait for me" would be gone as well."""
        self.whole = PhraseSet(words for words in fillers if not _may_be_cut(words, self.fillers, own))
        """Fillers of which no word belongs to a sentence: "go right now" may be "go right", now."""
        says_nothing = (*fillers, *operators.opener)
        self.hesitation = PhraseSet(words for words in wording.hesitations if words in says_nothing)
        comparing = (words for words in operators.negation if not wording.compares.isdisjoint(words))
        compared = frozenset(words for words in comparing if own.issuperset(words) and in_a_row(grammar, words))
        negation = [words for words in operators.negation if words not in compared]
        self.kept = PhraseSet((*operators.correction, *operators.cancel, *negation, *wording.roughly))
        """Operators and the like, of which no filler takes a part."""
        self._operators = PhraseSet(
            (*operators.stop, *operators.sequence, *operators.contrast, *operators.correction, *operators.cancel,
             *negation)
        )  # fmt: skip
        self.wake = PhraseSet(grammar.wake)
        self.stop = PhraseSet(operators.stop)
        self.stop_by_sound = PhraseSet((*operators.stop, *operators.stop_by_sound))
        self.negation = PhraseSet(negation)
        self.correction = PhraseSet(operators.correction)
        self.correcting = next(iter(operators.correction), ())
        """One of them, for what corrects in other words: "wrong way, the lab"."""
        self.in_its_place = wording.in_its_place
        self.cancel = PhraseSet(operators.cancel)
        self.sequence = PhraseSet(operators.sequence, wording.no_joints)
        self._later = PhraseSet(operators.later)
        self.later_at_last = PhraseSet({*wording.besides} & {*operators.later}, wording.no_joints)
        """What says behind a command that something else is done first: "turn left *next*"."""
        self.contrast = PhraseSet(operators.contrast)
        self.objections = Objections(grammar)
        self._opener = PhraseSet(operators.opener)
        self._restart = PhraseSet((*operators.opener, *operators.contrast))
        self._opening = PhraseSet(operators.opening)
        self._own_openers = own.intersection(words[0] for words in operators.opener)
        joining = [words for words in grammar.fillers if any((word,) in operators.sequence for word in words)]
        alone = cache(lambda word: lists is not None and lists([word]))
        self._listing = SomePhrases(
            joining, lambda words: lists is not None and lists(before_joint(words, self.sequence))
        )
        several = (words for words in grammar.fillers if len(words) > 1 and words not in joining)
        self._hides = SomePhrases(several, lambda filler: any(map(alone, filler)))
        self._agreed_at_first = PhraseSet((*wording.agreeing, *((word,) for word in wording.agrees)))
        agrees = frozenset(filter(alone, wording.agrees))
        agreeing = PhraseSet(words for words in wording.agreeing if words in grammar.fillers)
        self.or_commands = FillersOrCommands(
            self.fillers, self.sequence, self._listing, self._hides, alone, agrees, agreeing
        )
        self._openers = self._openers_of(grammar, joining, counting, counted, place_of, names, called)
        self._closed = operators.closed
        self._requests = wording.requests
        self._before_verbs = wording.before_verbs

    def _openers_of(
        self,
        grammar: Grammar,
        joining: Sequence[tuple[str, ...]],
        counting: Sequence[tuple[str, ...]],
        counted: Sequence[tuple[str, ...]],
        place_of: Callable[[Sequence[str], str], TextPlace | None] | None,
        names: Callable[[Sequence[str], str], bool] | None,
        called: Callable[[tuple[str, ...]], bool] | None,
    ) -> Openers:
        """Which fillers are none elsewhere: those that join, that count, or that a name may have."""
        operators, slots = grammar.operators, grammar.slots.values()
        named = any(slot.type == "text" and not slot.known for slot in slots)
        greetings = (words for words in grammar.wording.greetings if named and words in grammar.fillers)
        known = thing_words(grammar.language)
        return Openers(
            phrases=PhraseSet(joining),
            joints=self.sequence,
            listing=self._listing,
            around=PhraseSet(grammar.around),
            again=PhraseSet((*operators.correction, *operators.cancel, *operators.contrast)),
            greetings=PhraseSet(greetings),
            fillers=self.fillers,
            ends=self._operators,
            sounds=self.hesitation,
            counting=PhraseSet(counting),
            counted=PhraseSet(counted),
            place_of=place_of,
            language=grammar.language,
            places=any(slot.type == "location" for slot in slots),
            digits=any(slot.digits for slot in slots),
            describing=known.describing,
            articles=known.articles,
            names=names,
            called=SomePhrases(grammar.fillers, called) if called is not None else PhraseSet(()),
            hides=self._hides,
        )

    def without_fillers(self, said: Utterance) -> Utterance:
        return said.without(self.fillers, self.kept, self._openers)

    def without_greetings(self, said: Utterance) -> Utterance:
        """The same without those with which a free name may begin."""
        return said.without(self.fillers, self.kept, replace(self._openers, greetings=PhraseSet(())))

    def says_nothing(self, said: Utterance, position: int, length: int) -> bool:
        """Whether so many words at a place are a filler where they stand: "right then" opens, but not in a list."""
        before = self.without_fillers(said.part(0, position)).words
        return not self._openers.misplaced(said, position, length, before)

    def without_opening(self, said: Utterance) -> Utterance:
        """The same without any filler with which it begins: "*robot*, wait for me in the kitchen"."""
        end = 0
        while (length := self.fillers.at(said.words, end)) and self.says_nothing(said, end, length):
            if self._listing.at(said.words, end):
                return self.without_idle_fillers(said)  # "right then, left" may be a list
            end += length
        return self.without_idle_fillers(said.part(end, len(said)) if end else said)

    def opens_what_follows(self, said: Utterance, start: int, end: int) -> bool:
        """Whether what stands between two places only opens what follows, as a filler does: "go and" wait for me there.
        With a pause in it or behind it, it does not."""
        if self.fillers.at(said.words, start) != end - start or any(said.breaks[start + 1 : end + 1]):
            return False
        return not self._listing.at(said.words, start) and self.says_nothing(said, start, end - start)

    def without_idle_fillers(self, said: Utterance) -> Utterance:
        return said.without(self.idle, self.kept, self._openers)

    def cuts_a_filler(self, said: Utterance, reading: Reading) -> bool:
        """Whether a text of a reading ends with the first word of a filler, of which the others were left out: who says
        "play right now" asks for no song that is called "right"."""
        texts = [slot for slot in reading.slots if slot.slot.type in FREE_KINDS]
        if not texts:
            return False
        last = {reading.words[slot.end - 1] for slot in texts}
        return any(
            word in last and self.fillers.at(said.words, place) > 1 and not self.whole.at(said.words, place)
            for place, word in enumerate(said.words)
        )

    def without_whole_fillers(self, said: Utterance) -> Utterance:
        return said.without(self.whole, self.kept, self._openers)

    def change_meaning(self, words: Sequence[str]) -> bool:
        """Whether any of the words changes a sentence's sense, so that nothing beside it is guessed."""
        return not self._closed.isdisjoint(words)

    def operate_in(self, words: Sequence[str]) -> bool:
        """Whether an operator stands in the words, or any word that changes a sentence's sense."""
        return self.change_meaning(words) or self._operators.find(words) is not None

    def awake(self, said: Utterance) -> Utterance | None:
        """What follows the wake word with which the utterance begins; None if it does not."""
        after = self.after_wake(said.words)
        return said.part(after, len(said)) if after else None

    def after_wake(self, words: Sequence[str]) -> int:
        """Where words go on after the wake word with which they begin, past fillers; 0: they begin with none."""
        position = 0
        while position < len(words):
            if length := self.wake.at(words, position):
                return position + length
            if not (length := self.fillers.at(words, position)):
                return 0
            position += length
        return 0

    def after_cancelled(self, said: Utterance) -> int:
        """Where an utterance goes on after a pause behind words that cancel what was said before: "never mind, go
        back". 0: it does not begin so; "don't, go back" may be one negation."""
        after = 0
        while True:
            ends = (after + length for length in self.cancel.lengths_at(said.words, after))
            apart = (end for end in ends if end < len(said) and said.breaks[end])
            end = next((end for end in apart if not self.negation.at(said.words, end - 1)), 0)
            if not end:
                return after
            after = end

    def goes_on(self, words: Sequence[str]) -> int:
        """How many words at the beginning only go on from what was said before: "and then", "but"."""
        return self._opening.after(words, 0)

    def goes_on_at(self, words: Sequence[str], at: int) -> bool:
        """Whether what only goes on stands at a place, and not how what follows is counted: "for the *next* hour"; nor
        a word of the grammar: "in *well* 7"."""
        return not (words[at - 1] in self._articles or words[at] in self._own_openers) and self.goes_on(words[at:]) > 0

    def agreed(self, said: Utterance) -> int:
        """How many words at the beginning only agree with what was said before, or praise it, and stand before a pause:
        "yes, go back", "perfect, take a photo"."""
        length = self._agreed_at_first.at(said.words, 0)
        return length if length < len(said) and said.breaks[length] else 0

    def opens(self, words: Sequence[str]) -> int:
        """How many words at the beginning say nothing of where a command begins again: "no, *well*, go back", "no,
        *just* go back"."""
        position = self._restart.after(words, 0)
        return position if position < len(words) else 0

    def comes_later(self, words: Sequence[str]) -> bool:
        """Whether words begin by saying that something else is done first: "then", "um, when you get there". A wake
        word may stand before them."""
        words = words[self.after_wake(words) :]
        position = self.fillers.after(words, 0)
        return self._later.at(words, position) > (position > 0) or self._later.at(words, 0) > 0

    def takes_back(self, words: Sequence[str]) -> bool:
        """Whether words begin with a correction: "no", "I mean". A wake word may stand before it."""
        return self.correction.at(words, self.after_wake(words)) > 0

    def says_later(self, joint: Sequence[str]) -> bool:
        """Whether a joint says that something else is done first: "and then", but not "and"."""
        return len(joint) > 0 and self._later.at(joint, 0) == len(joint)

    def after_opening(self, words: list[str]) -> int:
        """Where an utterance begins, past fillers, wake words, openers and words of correction ("no stop", "hey robot
        stop", "oh stop")."""
        position = 0
        while position < len(words):
            length = max(
                self.fillers.at(words, position),
                self.wake.at(words, position),
                self.correction.at(words, position),
                self._opener.at(words, position),
            )
            if not length or self.stop.at(words, position) >= length:
                break
            position += length
        return position

    def requests(self, words: list[str]) -> bool:
        """Whether an utterance begins with words that ask for what follows: "kannst du links abbiegen?"."""
        return not self._requests.isdisjoint(words[: self.after_opening(words)])

    def only_stops(self, words: list[str], position: int) -> bool:
        """Whether nothing but stop phrases and fillers follows, with at least one of the former first."""
        return self._only(self.stop, words, position)

    def only_stops_by_sound(self, words: list[str]) -> bool:
        """Whether an utterance is nothing but these, some of them written by their sound."""
        return self._only(self.stop_by_sound, words, self.after_opening(words))

    def _only(self, stops: PhraseSet, words: list[str], position: int) -> bool:
        found = False
        while position < len(words):
            length = stops.at(words, position)
            if length:
                found = True
            elif found:
                length = self.fillers.at(words, position) or self.wake.at(words, position)
            if not length and found:
                length = _echo(words, position)
            if not length:
                return False
            position += length
        return found

    def negated_before(self, words: list[str], position: int) -> bool:
        while position and words[position - 1] in self._before_verbs:
            position -= 1
        return any(self.negation.at(words, back) == position - back for back in range(max(0, position - 3), position))

    def joined_before(self, words: list[str], position: int) -> bool:
        """Whether "and then" stands before: a stop at the end of a list of commands is where it ends anyway."""
        return any(self.sequence.at(words, back) == position - back for back in range(max(0, position - 4), position))


def _echo(words: list[str], position: int) -> int:
    """Length of the words here that only say again what stands before: "stop right there right there"."""
    for length in range(min(position, len(words) - position), 0, -1):
        if words[position : position + length] == words[position - length : position]:
            return length
    return 0


def _may_be_cut(filler: Sequence[str], fillers: PhraseSet, own: Collection[str]) -> bool:
    """Whether the end of a filler is one too, and the words before that may be a sentence's."""
    return any(fillers.cover(filler[at:]) and all(word in own for word in filler[:at]) for at in range(1, len(filler)))
