"""Words to readings: which sentence was said, and what its slots hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from intent_engine.language import quantities
from intent_engine.language.adjacent_numbers import is_number, numbers_apart
from intent_engine.language.alternative_slots import alternatives
from intent_engine.language.automaton import SOUND, Automaton
from intent_engine.language.continuation import Continuation, Continuations
from intent_engine.language.free_text import FREE_KINDS, FreeText
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Intent, Sentence
from intent_engine.language.network import NAMED, Call, Edge, Networks, State
from intent_engine.language.numbers.english import NUMBER_WORDS
from intent_engine.language.pattern.spoken_patterns import SpokenPatterns
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.sentence_networks import SentenceNetworks, call_of
from intent_engine.language.slot_values import SlotValues
from intent_engine.language.spacing import Spacing
from intent_engine.language.utterance import Utterance
from intent_engine.language.word_state import Trace, WordState

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["NEGATED", "Matcher"]

NEGATED = {"en": (("do", "not"), ("you", "should", "not"), ("do", "not", "ever"))}
"""How a negated command begins in speech, besides the negation itself."""
FORBIDDING = {"en": (("do", "not"), ("never",)), "fr": (("ne",),), "es": (("no",),), "it": (("non",),)}
"""The usual ones of these, for finding what was probably said."""
SOUND_LETTERS = 4
"""Letters of a filler, up to which it is hardly more than a sound: "uh", "so", "just"."""

NUMBERS_BY_SOUND = frozenset(
    (("to", "two"), ("too", "two"), ("for", "four"), ("fore", "four"), ("won", "one"), ("ate", "eight"))
)
"""Words that are numbers where a unit follows, as sure as these themselves: of 30 times that "to meters", "to feet" or
"for meters" was heard in quiet and in noise, and the sentence was one but for that, each was that number."""
LEADING = frozenset(("to", "too", "for", "fore"))
GOES_ON = frozenset(("hundred", "thousand", "million", "point"))
"""Words of a number before which these may be one too; "to twenty degrees" is no 220."""
CUT_OFF = (["to"], ["for"])
"""Words with which a sentence goes on. At its end neither is "two" or "four"."""


class Matcher:
    """The automaton of one grammar and one map, and what its readings mean. Thread-safe."""

    def __init__(self, grammar: Grammar, locations: LocationMap | None = None) -> None:
        self.grammar = grammar
        self.locations = locations
        self.networks = Networks()
        intents = grammar.intents.values()
        self.sentences: list[tuple[Intent, Sentence]] = [
            *((intent, sentence) for intent in intents for sentence in intent.sentences),
            *((intent, sentence) for intent in intents for sentence in intent.then),
        ]
        """Those of a whole utterance, and after them those of a later part only."""
        self._whole = range(sum(len(intent.sentences) for intent in intents))
        self._free = FreeText(grammar)
        self.values = SlotValues(grammar, locations, self._free)
        self._parts = SentenceNetworks(grammar, locations, self.networks, self._free)
        self._parts.add_sentences([sentence for _, sentence in self.sentences])
        self.patterns = SpokenPatterns(grammar, self.networks, call_of)
        self.strict = self._automaton(self._root(self._whole), loose=False)
        self.loose = self._automaton(self._root(self._whole), loose=True)
        self.later = {
            intent.name: tuple(
                self._automaton(self._root(self._later_of(intent)), loose=loose) for loose in (False, True)
            )
            for intent in intents
            if intent.then
        }
        """By intent: what may follow a command of it and a joint; strictly, and loosely."""
        self._alternatives_of: dict[int, Mapping[tuple[str, str], tuple[tuple[str, str], ...]]] = {}

    @cached_property
    def alikes(self) -> Mapping[str, tuple[str, ...]]:
        """Word -> words of the grammar that may have been meant: that sound the same, and that sound alike."""
        same, alike = self.grammar.homophones, self.grammar.sound_alikes
        return {word: tuple(dict.fromkeys((*same.get(word, ()), *alike.get(word, ())))) for word in {*same, *alike}}

    # -- building ---------------------------------------------------------------------------------------------

    def _automaton(self, root: State, *, loose: bool, traced: bool = True, refusing: bool = False) -> Automaton:
        language = self.grammar.language
        counted = any(slot.type == "ordinal" for slot in self.grammar.slots.values())
        is_number_word = quantities.is_ordinal_word if counted else quantities.is_number_word
        return Automaton(
            self.networks,
            root,
            loose=loose,
            traced=traced,
            refusing=refusing,
            is_numeral=quantities.is_numeral,
            is_number_word=lambda word: is_number_word(word, language),
            closed_words=self.grammar.operators.closed,
            sound_alikes=self.alikes,
        )

    def _later_of(self, intent: Intent) -> list[int]:
        later = range(len(self._whole), len(self.sentences))
        return [index for index in later if self.sentences[index][0] is intent]

    def _root(self, sentences: Iterable[int]) -> State:
        root = State()
        for index in sentences:
            end = State()
            end.final = True
            root.edges.append(Edge(end, call=Call(f"sentence:{index}", ("sentence", index))))
        return root

    @cached_property
    def spacing(self) -> Spacing:
        """What the grammar writes together and apart."""
        return Spacing(self.grammar)

    @cached_property
    def spoken(self) -> Automaton:
        """The automaton of whole utterances: fillers, sentences joined by "and then", fillers. For looking ahead."""
        return self._utterances(stop_anywhere=True)

    @cached_property
    def likely(self) -> Automaton:
        """The same, with stop words only by themselves: for finding what was probably said. A stop word found in
        the middle of a misheard sentence is noise, and one that was said there is heard as it is. Nor does a free slot
        take words of its ``without``. It is only walked."""
        return self._utterances(stop_anywhere=False)

    @cached_property
    def _continuations(self) -> Continuations:
        return Continuations(self.networks, {slot.name: slot.type for slot in self.grammar.slots.values()})

    def settled(self, words: Sequence[str]) -> bool:
        """Whether what may follow a whole command is no more than the manner of it.

        Fillers at the end say nothing about that: "go forward for me" may be heard of "go forward four meters".
        """
        while (short := self._without_filler(words)) is not None:
            words = short
        rest = self.ahead(words) - {Continuation.NOTHING}
        last, language = (words[-1] if words else ""), self.grammar.language
        if rest and (last in NUMBER_WORDS or is_number(last, language)):
            return False  # "one hundred" may go on to "and twenty"
        return rest <= {Continuation.MANNER}

    def resting(self, words: Sequence[str]) -> bool:
        """Whether a whole command ends in a quantity that may go on, and people rest there ("in an hour")."""
        resting = quantities.people_rest_after(words, self.grammar.language)
        return resting and Continuation.MANNER in self.ahead(words)

    def _without_filler(self, words: Sequence[str]) -> Sequence[str] | None:
        """Words without the filler at their end; None: there is none."""
        for count in range(min(len(words) - 1, self._longest_filler), 0, -1):
            if tuple(words[-count:]) in self.grammar.fillers:
                return words[:-count]
        return None

    @cached_property
    def _longest_filler(self) -> int:
        return max(map(len, self.grammar.fillers), default=0)

    def ahead(self, words: Sequence[str]) -> frozenset[Continuation]:
        """What may still be said after the beginning of an utterance, of what is not wrong already: "take me to the
        kitchen" goes on as no "take {thing} from {place}", since "me" is nothing to take."""
        ways = self.spoken.ways_on(words)
        return self._continuations.ahead(
            (place, calls) for place, calls, trace in ways if not self._wrong(trace, words)
        )

    def _wrong(self, trace: Trace, words: Sequence[str]) -> bool:
        """Whether a free slot holds what it cannot hold, whatever follows."""
        begin, slot = 0, None
        for position, mark in (*trace, (len(words), ("close",))):
            if mark[0] == "open" and mark[1][0] == "slot":
                begin, slot = position, self.grammar.slots[mark[1][2]]
            elif mark[0] == "close" and slot is not None:
                if slot.type in FREE_KINDS and self._free.problem(slot, words, begin, position):
                    return True
                slot = None
        return False

    def _utterances(self, *, stop_anywhere: bool) -> Automaton:
        begin, middle, end = State(), State(), State()
        ends = {intent.name: State() for intent in self.grammar.intents.values() if intent.then}
        for place in (end, *ends.values()):
            place.final = True
        fillers = [words for words in (*self.grammar.fillers, *self.grammar.wake) if words]
        sounds = [words for words in fillers if len("".join(words)) <= SOUND_LETTERS]
        sounds += [words for words in fillers if len(words) > 1 and words[:1] in sounds]  # "so", and "so then"
        self.networks.add_names("sounds", [(words, "") for words in sounds])
        self.networks.add_names("fillers", [(words, "") for words in fillers if words not in sounds])
        self.networks.add_names("sequence", [(words, "") for words in self.grammar.operators.sequence])
        self.networks.add_names("stop", [(words, "") for words in self.grammar.operators.stop])
        # Negated sentences are utterances too: a recogniser that looks for sentences must be able to hear "don't".
        negation = [
            (words, "") for words in (*self.grammar.operators.negation, *NEGATED.get(self.grammar.language, ()))
        ]
        self.networks.add_names("negation", negation)
        self.networks.add_names("forbidding", [(words, "") for words in FORBIDDING.get(self.grammar.language, ())])
        begin.edges.append(Edge(middle, call=Call("negation" if stop_anywhere else "forbidding")))
        begin.edges.append(Edge(middle))
        if fillers:
            for place in (begin, end, *ends.values()):
                place.edges.append(Edge(place, call=Call("sounds", mark=SOUND, apart=True)))
                place.edges.append(Edge(place, call=Call("fillers", apart=True)))
        polite = not stop_anywhere and self._parts.add_polite(fillers, sounds)
        kind = "polite" if polite else "sentence"
        for index in self._whole:
            after = ends.get(self.sentences[index][0].name, end)
            middle.edges.append(Edge(after, call=Call(f"{kind}:{index}")))
        for key in self.patterns.networks:
            middle.edges.append(Edge(end, call=Call(key)))
        if stop_anywhere:
            middle.edges.append(Edge(end, call=Call("stop")))
        else:
            alone = State()
            alone.final = True
            begin.edges.append(Edge(alone, call=Call("stop")))
        end.edges.append(Edge(middle, call=Call("sequence", apart=True)))
        for intent in self.grammar.intents.values():
            if intent.then:
                between = State()
                ends[intent.name].edges.append(Edge(between, call=Call("sequence", apart=True)))
                between.edges.append(Edge(middle))
                for index in self._later_of(intent):
                    between.edges.append(Edge(ends[intent.name], call=Call(f"{kind}:{index}")))
        return self._automaton(begin, loose=False, traced=stop_anywhere, refusing=not stop_anywhere)

    # -- reading ----------------------------------------------------------------------------------------------

    def read(self, words: list[str], *, loose: bool = False, after: str = "") -> list[Reading]:
        """Every reading of all the words, best first; those with a problem last.

        Args:
            words: of one command.
            loose: whether names may be misspelled.
            after: the intent that the words go on from; empty: they are a command by themselves.
        """
        automaton = self.later[after][loose] if after else self.loose if loose else self.strict
        language = self.grammar.language
        traces = [
            trace
            for trace in automaton.read(words)
            if not (
                _cut_off(trace, words)
                or _leads_to_a_number(trace, words, language)
                or _names_no_number(trace, words, language)
                or (loose and self._loses_a_number(trace, words))
            )
        ]
        readings = [self._reading(trace, words) for trace in traces]
        if loose:
            readings = [way for reading in readings for way in self._otherwise(reading)]
        if len(readings) > 1:
            readings.sort(key=_preference)
        return readings

    def prefix(self, words: list[str]) -> tuple[int, WordState | None]:
        """How far the words can be the beginning of an utterance, and the state there."""
        return self.spoken.walk(words)

    def heard(self, text: str, language: str = "") -> Utterance:
        """The words of a text, in a language or in that of the grammar. A letter that may be a sound said twice is a
        word where a sentence goes on with it: "rack *b* bay three"."""
        language = language or self.grammar.language
        lettered = Utterance.with_letters(text, language)
        if lettered is not None and self.prefix(lettered.words)[1] is not None:
            return lettered
        return Utterance.of(text, language)

    def _reading(self, trace: Trace, words: list[str]) -> Reading:
        intent, sentence = self.sentences[trace[0][1][1][1]]
        heard = words
        alikes = misheard = 0
        by_sound: list[int] = []
        slots: list[SlotReading] = []
        free = 0
        start = 0
        value: Any = None
        loosely = False
        for position, mark in trace:
            kind = mark[0]
            if kind == "open":
                if mark[1][0] == "slot":
                    start, value, loosely = position, None, mark[2]
            elif kind == "value":
                value = mark[1]
            elif kind == "close":
                if mark[1][0] == "slot":
                    _, label, name = mark[1]
                    slot = self.grammar.slots[name]
                    if slot.type in FREE_KINDS:
                        free += position - start
                    elif slot.type in QUANTITY_KINDS:
                        misheard -= sum(start < place < position for place in by_sound)
                    slots.append(self.values.read(slot, label, heard, start, position, value, loosely))
            elif kind == "alike":
                # Stands before the end of the slot that holds the word.
                if heard is words:
                    heard = list(words)
                alikes += 1
                said = heard[position - 1]
                if mark[1] not in self.grammar.homophones.get(said, ()):
                    misheard += 1
                    if (said, mark[1]) in NUMBERS_BY_SOUND and not any(
                        map(self.is_number, words[position : position + 1])
                    ):
                        by_sound.append(position)
                heard[position - 1] = mark[1]
        if len(slots) > 1:
            slots = numbers_apart(slots, heard, self.grammar.language)
        return Reading(intent, sentence, tuple(slots), tuple(heard), alikes, misheard, free)

    def _otherwise(self, reading: Reading) -> Iterator[Reading]:
        """A reading; and with it those in which a name is one of another slot in the same place, unless it is exactly
        one of its own. Of two slots that may hold the same words the automaton keeps the first."""
        yield reading
        for place, slot in enumerate(reading.slots):
            if slot.status == "exact":
                continue
            for label, name in self._alternatives(reading.sentence).get((slot.label, slot.slot.name), ()):
                other = self.grammar.slots[name]
                if other.fuzzy and other.type in ("location", "choice"):
                    read = self.values.read(other, label, list(reading.words), slot.start, slot.end, None, True)
                    if not read.problem or read.status == "ambiguous":
                        yield replace(reading, slots=(*reading.slots[:place], read, *reading.slots[place + 1 :]))

    def _alternatives(self, sentence: Sentence) -> Mapping[tuple[str, str], tuple[tuple[str, str], ...]]:
        found = self._alternatives_of.get(id(sentence))
        if found is None:
            found = alternatives(sentence.template, self.grammar.phrases)
            self._alternatives_of[id(sentence)] = found
        return found

    def _loses_a_number(self, trace: Trace, words: Sequence[str]) -> bool:
        """Whether a number is taken for another word and what belongs to it for free text: "wave two times once" is no
        "wave to *times once*", for "wave two times" was said."""
        return any(
            mark[0] == "alike"
            and mark[1] not in NUMBER_WORDS
            and self.is_number(words[position - 1])
            and self._opens_free_text(trace, position)
            and self.strict.walk(list(words))[0] > position
            for position, mark in trace
        )

    def _opens_free_text(self, trace: Trace, place: int) -> bool:
        """Whether what stands behind a word is free text."""
        return any(
            position == place and mark[0] == "open" and mark[1][0] == "slot" and self._is_free(mark[1][2])
            for position, mark in trace
        )

    def _is_free(self, slot: str) -> bool:
        return self.grammar.slots[slot].type in FREE_KINDS

    def is_number(self, word: str) -> bool:
        """Whether a word is a numeral or a word of a number."""
        return is_number(word, self.grammar.language)


def _cut_off(trace: Trace, words: Sequence[str]) -> bool:
    """Whether the last word is taken for a number, but may be where a sentence broke off: "turn left to"."""
    return words[-1:] in CUT_OFF and any(mark[0] == "alike" and position == len(words) for position, mark in trace)


def _leads_to_a_number(trace: Trace, words: Sequence[str], language: str) -> bool:
    """Whether a word is taken for a number that only leads to one: "turn right to twenty degrees"."""
    return not LEADING.isdisjoint(words) and any(
        mark[0] == "alike"
        and words[position - 1] in LEADING
        and (words[position - 1], mark[1]) in NUMBERS_BY_SOUND
        and position < len(words)
        and words[position] not in GOES_ON
        and is_number(words[position], language)
        for position, mark in trace
    )


def _names_no_number(trace: Trace, words: Sequence[str], language: str) -> bool:
    """Whether what stands for the number of a name is not one whole number that is said as it is: "drawer 7 and 8",
    "drawer 7.5", "drawer minus seven". No drawer is called so, and the first of two is not the one that is meant."""
    for _, mark in trace:
        if mark[1] is NAMED:
            break
    else:
        return False  # as most are: few sentences have such numbers
    begin = 0
    heard: list[str] = []
    for position, mark in trace:
        if mark[:2] == ("open", NAMED):
            begin, heard = position, [*words]
        elif mark[0] == "alike" and heard:
            heard[position - 1] = mark[1]
        elif mark == ("close", NAMED):
            number = quantities.evaluate(heard[begin:position], "number", language)
            if not (isinstance(number, float) and number >= 0 and number.is_integer()):
                return True
    return False


def _preference(reading: Reading) -> tuple[bool, int, int, int]:
    return (bool(reading.problem), -reading.intent.priority, reading.free_words, reading.alikes)
