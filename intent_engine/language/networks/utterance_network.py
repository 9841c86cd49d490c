"""The network of whole utterances: fillers, sentences that are joined by "and then", and fillers again."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from intent_engine.language.automaton import SOUND
from intent_engine.language.grammar import Grammar
from intent_engine.language.networks.network import Call, Edge, Networks, State
from intent_engine.language.networks.sentence_networks import SentenceNetworks, call_of
from intent_engine.language.numbers.units import units
from intent_engine.language.pattern.spoken_patterns import SpokenPatterns
from intent_engine.language.templates.template_tree import last_references
from intent_engine.language.words.thing_words import thing_words

__all__ = ["UtteranceNetwork"]

SOUND_LETTERS = 4
"""Letters of a filler, up to which it is hardly more than a sound: "uh", "so", "just"."""


class UtteranceNetwork:
    """Joins the sentences of one grammar to utterances.

    Args:
        grammar: whose.
        networks: in which its sentences are, and to which words between them are added.
        sentences: made them.
        patterns: what is said for its patterns.
        whole: sentences that are an utterance by themselves: number of the network to name of the intent.
        later: by name of the intent, numbers of the sentences that may follow a command of it and a joint.
        led: the sentences that are read with an article before what they name ("read:0").
    """

    def __init__(
        self,
        grammar: Grammar,
        networks: Networks,
        sentences: SentenceNetworks,
        patterns: SpokenPatterns,
        whole: Mapping[int, str],
        later: Mapping[str, Sequence[int]],
        led: Collection[int] = (),
    ) -> None:
        self._grammar = grammar
        self._networks = networks
        self._sentences = sentences
        self._patterns = patterns
        self._whole = whole
        self._later = later
        self._led = frozenset(led)
        self._fillers = [words for words in (*grammar.fillers, *grammar.wake) if words]
        sounds = [words for words in self._fillers if len("".join(words)) <= SOUND_LETTERS]
        sounds += [words for words in self._fillers if len(words) > 1 and words[:1] in sounds]  # "so", and "so then"
        self._sounds = sounds

    def root(self, *, stop_anywhere: bool, otherwise: bool = False) -> State:
        """Where an utterance begins.

        Args:
            stop_anywhere: whether a stop may stand among other sentences, and a negated one begin in any way; else a
                stop stands alone, only the usual negations begin a sentence, and what other languages than English put
                behind a verb is a part of it.
            otherwise: whether sentences are put in all ways in which they are understood, and not only in that of their
                file.
        """
        self._add_words()
        begin, middle, end = State(), State(), State()
        ends = {name: State() for name in self._later}
        for place in (end, *ends.values()):
            place.final = True
        begin.edges.append(Edge(middle, call=Call("negation" if stop_anywhere else "forbidding")))
        begin.edges.append(Edge(middle))
        if self._fillers:
            for place in (begin, end, *ends.values()):
                place.edges.append(Edge(place, call=Call("sounds", mark=SOUND, apart=True)))
                place.edges.append(Edge(place, call=Call("fillers", apart=True)))
        called = self._read_as if stop_anywhere else self._said_as()
        if otherwise:
            called = self._otherwise(called, "sequence" if stop_anywhere else "and")
        for index, intent in self._whole.items():
            after = ends.get(intent, end)
            middle.edges.append(Edge(self._listed(index, after), call=Call(called(index))))
        for key in self._patterns.networks:
            middle.edges.append(Edge(end, call=Call(key)))
        if stop_anywhere:
            middle.edges.append(Edge(end, call=Call("stop")))
        else:
            alone = State()
            alone.final = True
            begin.edges.append(Edge(alone, call=Call("stop")))
        end.edges.append(Edge(middle, call=Call("sequence", apart=True)))
        for name, later in self._later.items():
            between = State()
            ends[name].edges.append(Edge(between, call=Call("sequence", apart=True)))
            between.edges.append(Edge(middle))
            for index in later:
                between.edges.append(Edge(ends[name], call=Call(called(index))))
        return begin

    def _listed(self, index: int, after: State) -> State:
        """Where a sentence ends whose last word is a number that may be one of several: "drawer three *and four*"; else
        the place ``after`` any sentence of its intent."""
        numbers = {slot.name: slot for slot in self._grammar.slots.values() if slot.type == "number" and not slot.units}
        template = self._sentences.template_of(index)
        last = {one.name for one in last_references(template)} & numbers.keys() if numbers else set[str]()
        if not last:
            return after
        here, between = State(), State()
        here.edges.append(Edge(after))
        here.edges.append(Edge(between, call=Call("sequence", apart=True)))
        between.edges.extend(Edge(here, call=call_of(numbers[name], name)) for name in sorted(last))
        return here

    def _read_as(self, index: int) -> str:
        """The network of a sentence as it is understood."""
        return f"read:{index}" if index in self._led else f"sentence:{index}"

    def _said_as(self) -> Callable[[int], str]:
        """The network of each sentence as speech is compared with it. With one article alone: "a" sounds like "eight",
        and what is no command would be like more."""
        polite = self._sentences.add_polite(self._fillers, self._sounds)
        led = self._led if self._grammar.language == "en" else frozenset()
        self._sentences.add_led("led", led, thing_words(self._grammar.language).definite)
        return lambda index: f"{'led' if index in led else 'polite' if polite else 'sentence'}:{index}"

    def _otherwise(self, called: Callable[[int], str], joint: str) -> Callable[[int], str]:
        """The network of each sentence in all ways to put it. Speech is compared with the shortest joint alone, which
        nearly everybody says: with each more words would be like it."""
        return lambda index: self._sentences.add_otherwise(called(index), joint)

    def _add_words(self) -> None:
        """Add what stands before, between and after sentences."""
        operators, wording, table = self._grammar.operators, self._grammar.wording, units(self._grammar.language)
        joining = table.words.get("and", frozenset[str]()) if table is not None else frozenset[str]()
        phrases = {
            "sounds": self._sounds,
            "fillers": [words for words in self._fillers if words not in self._sounds],
            "sequence": operators.sequence,
            "and": [words for words in operators.sequence if len(words) == 1 and words[0] in joining],
            "stop": operators.stop,
            # Negated sentences are utterances too: a recogniser that looks for sentences must be able to hear "don't".
            "negation": (*operators.negation, *wording.negated),
            "forbidding": wording.forbidding,
        }
        for key, found in phrases.items():
            self._networks.add_names(key, [(words, "") for words in found])
