"""Words to readings: which sentence was said, and what its slots hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from intent_engine.language import quantities
from intent_engine.language.automaton import Automaton
from intent_engine.language.checking.trace_checks import NUMBERS_BY_SOUND, loses_a_number, means_nothing
from intent_engine.language.continuation import Continuation, Continuations
from intent_engine.language.grammar import FREE_KINDS, QUANTITY_KINDS, Grammar, Intent, Sentence, Slot
from intent_engine.language.networks.network import Call, Edge, Networks, State
from intent_engine.language.networks.sentence_networks import SentenceNetworks, call_of
from intent_engine.language.networks.utterance_network import UtteranceNetwork
from intent_engine.language.networks.word_state import Trace, WordState
from intent_engine.language.numbers.english_words import DOZENS, NUMBER_WORDS
from intent_engine.language.numbers.units import units
from intent_engine.language.pattern.spoken_patterns import SpokenPatterns
from intent_engine.language.reading import Reading, SlotReading
from intent_engine.language.slots.adjacent_numbers import amounts_apart, is_number, numbers_apart, parted_at_joint
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.growing_numbers import GrowingNumbers
from intent_engine.language.slots.slot_values import SlotValues
from intent_engine.language.templates.alternative_slots import alternatives
from intent_engine.language.utterance import Utterance
from intent_engine.language.words.another import Another
from intent_engine.language.words.keyboards import Keyboards
from intent_engine.language.words.spacing import Spacing
from intent_engine.language.words.thing_words import thing_words
from intent_engine.language.words.unit_symbols import UnitSymbols

if TYPE_CHECKING:
    from intent_engine.language.locations import LocationMap

__all__ = ["Matcher"]


STEERING = frozenset(("move", "turn"))
"""Actions whose directions have no article: "turn the left"."""


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
        self._another = Another(grammar)
        self.values = SlotValues(grammar, locations, self._free)
        self._parts = SentenceNetworks(grammar, locations, self.networks, self._free)
        self._parts.add_sentences([sentence for _, sentence in self.sentences])
        self._led = {index for index, (intent, _) in enumerate(self.sentences) if intent.action.type not in STEERING}
        self._parts.add_led("read", self._led, thing_words(grammar.language).introducing)
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
            sound_alikes=self.alikes if loose else self._another.meant,
        )

    def _later_of(self, intent: Intent) -> list[int]:
        later = range(len(self._whole), len(self.sentences))
        return [index for index in later if self.sentences[index][0] is intent]

    def _root(self, sentences: Iterable[int]) -> State:
        root = State()
        for index in sentences:
            end = State()
            end.final = True
            kind = "read" if index in self._led else "sentence"
            root.edges.append(Edge(end, call=Call(f"{kind}:{index}", ("sentence", index))))
        return root

    @cached_property
    def spacing(self) -> Spacing:
        """What the grammar writes together and apart."""
        return Spacing(self.grammar)

    @cached_property
    def unit_symbols(self) -> UnitSymbols:
        """How units that are words of its sentences are written for short."""
        return UnitSymbols(self.grammar)

    @cached_property
    def keyboards(self) -> Keyboards:
        """How its words are typed."""
        return Keyboards(self)

    @cached_property
    def spoken(self) -> Automaton:
        """The automaton of whole utterances: fillers, sentences joined by "and then", fillers."""
        return self._automaton(self._utterances.root(stop_anywhere=True), loose=False)

    @cached_property
    def begun(self) -> Automaton:
        """The same, with sentences in all ways in which they are understood: "turn the lamp on", "open the door and the
        window". For looking ahead."""
        return self._automaton(self._utterances.root(stop_anywhere=True, otherwise=True), loose=False)

    def look_ahead(self) -> None:
        """Make ready what the first look ahead would wait for: a tenth of a second."""
        self.begun.ways_on([])

    @cached_property
    def likely(self) -> Automaton:
        """The same, with stop words only by themselves: for finding what was probably said. A stop word found in
        the middle of a misheard sentence is noise, and one that was said there is heard as it is. Nor does a free slot
        take words of its ``without``. It is only walked."""
        root = self._utterances.root(stop_anywhere=False, otherwise=True)
        return self._automaton(root, loose=False, traced=False, refusing=True)

    @cached_property
    def _utterances(self) -> UtteranceNetwork:
        whole = {index: self.sentences[index][0].name for index in self._whole}
        later = {intent.name: self._later_of(intent) for intent in self.grammar.intents.values() if intent.then}
        return UtteranceNetwork(self.grammar, self.networks, self._parts, self.patterns, whole, later, self._led)

    @cached_property
    def _continuations(self) -> Continuations:
        return Continuations(self.networks, {slot.name: slot.type for slot in self.grammar.slots.values()})

    def settled(self, words: Sequence[str], *, but: Continuation = Continuation.NOTHING) -> bool:
        """Whether what may follow a whole command is no more than the manner of it, or more of a quantity.

        Fillers at the end say nothing about that: "go forward for me" may be heard of "go forward four meters".

        Args:
            words: of the command.
            but: what may follow besides, and changes nothing.
        """
        while (short := self._without_filler(words)) is not None:
            words = short
        rest = self.ahead(words) - {Continuation.NOTHING, but}
        if rest and words and self._of_a_number(words[-1]):
            # "One hundred" may go on to "and twenty".
            return rest == {Continuation.MORE} and not self._may_grow(words)
        return rest <= {Continuation.MORE, Continuation.MANNER}

    def endings(self, words: Sequence[str]) -> frozenset[tuple[str, ...]]:
        """Words that a whole command may end with besides, where they fill no slot, are few, and are all that may
        follow but for its manner: "section" after "show me the history"; else none."""
        if Continuation.WORDS not in self.ahead(words) or not self.settled(words, but=Continuation.WORDS):
            return frozenset()
        ways = ((place, calls) for place, calls, trace in self.begun.ways_on(words) if not self._wrong(trace, words))
        return self._continuations.endings(ways) or frozenset()

    def _may_grow(self, words: Sequence[str]) -> bool:
        """Whether the number with which some words end may still become another."""
        ways = self.begun.ways_on(words)
        within = {slot for *_, trace in ways if (slot := _slot_under_way(trace)) is not None}
        return any(self._growing.may_grow(self.grammar.slots[name], label, words, at) for label, name, at in within)

    @cached_property
    def _growing(self) -> GrowingNumbers:
        def read(slot: Slot, label: str, words: list[str], begin: int, end: int) -> SlotReading:
            return self.values.read(slot, label, words, begin, end, None, False)

        return GrowingNumbers(read, self._number_words_after, self.grammar.language)

    def _number_words_after(self, words: Sequence[str]) -> list[str]:
        _, reached = self.begun.walk(words)
        following = self.begun.next_words(reached) if reached is not None else ()
        table = units(self.grammar.language)
        joining = table.words["and"] if table is not None else ()
        # Nobody rests before the noun of "two dozen".
        nouns = (*DOZENS, *(table.nouns if table is not None else ()))
        return [word for word in following if word in joining or (self._of_a_number(word) and word not in nouns)]

    def _of_a_number(self, word: str) -> bool:
        """Whether a word may be one of a number: of the language, or English."""
        return word in NUMBER_WORDS or self.is_number(word)

    def tells_manner(self, words: Sequence[str]) -> bool:
        """Whether a speed may follow a whole command."""
        return Continuation.MANNER in self.ahead(words)

    def resting(self, words: Sequence[str]) -> bool:
        """Whether a whole command ends in a quantity that may go on, and people rest there ("in an hour")."""
        resting = quantities.people_rest_after(words, self.grammar.language)
        return resting and Continuation.MORE in self.ahead(words)

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
        ways = self.begun.ways_on(words)
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
                means_nothing(trace, words, language)
                or self._another.is_no_article(trace, words, loose=loose)
                or (loose and loses_a_number(trace, words, self.grammar, self.strict))
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
        return self.as_written(Utterance.of(text, language))

    def as_written(self, said: Utterance) -> Utterance:
        """An utterance with such words as the grammar has: with their accents, and two for one ("zu dem" for "zum")."""
        read = self.keyboards.read(said)
        return self.spacing.uncontracted(read, self.keyboards.words_of_places) if self.spacing.contracts(read) else read

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
            understood = heard

            def read(one: SlotReading, begin: int, end: int) -> SlotReading:
                return self.values.read(one.slot, one.label, understood, begin, end, None, False)

            slots = amounts_apart(parted_at_joint(slots, heard, read), heard, read, self.grammar.language)
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

    def is_number(self, word: str) -> bool:
        """Whether a word is a numeral or a word of a number."""
        return is_number(word, self.grammar.language)


def _slot_under_way(trace: Trace) -> tuple[str, str, int] | None:
    """The label and the name of the slot that the words so far end in, and where it begins; None: they end in none."""
    under_way = None
    for position, mark in trace:
        if mark[0] == "open" and mark[1][0] == "slot":
            under_way = mark[1][1], mark[1][2], position
        elif mark[0] == "close" and mark[1][0] == "slot":
            under_way = None
    return under_way


def _preference(reading: Reading) -> tuple[bool, int, int, int]:
    return (bool(reading.problem), -reading.intent.priority, reading.free_words, reading.alikes)
