"""Trees to sentences: random ones, with their known meaning.

A sample is made from the description of the grammar alone, never by parsing: a template is walked, every value that is
put into a slot is known before it is spelled, and the action is built from those values. So a parser that is wrong
cannot agree with itself.

Whoever draws decides where the choices come from (:class:`Choices`): a seeded generator, or Hypothesis. Among the ways
to go on, number 0 is always the shortest.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from intent_engine.errors import ConfigError
from intent_engine.hints import did_you_mean
from intent_engine.language.grammar import QUANTITY_KINDS, Grammar, Intent, Sentence, Slot
from intent_engine.language.normalize import words_of
from intent_engine.language.numbers.english_words import NUMBER_WORDS
from intent_engine.language.pattern.pattern_sampler import PatternSampler
from intent_engine.language.quantities import Relative
from intent_engine.language.reading import SlotReading
from intent_engine.language.sampling.drawing import Choices, Piece, RandomChoices, one, pick
from intent_engine.language.sampling.spoken_slots import SpokenSlots, size
from intent_engine.language.slots.action_builder import CannotActError, build_action, check_speeds, names_taken
from intent_engine.language.slots.free_text import FreeText
from intent_engine.language.slots.names_apart import named_otherwise
from intent_engine.language.slots.slot_values import SlotValues
from intent_engine.language.templates.template_tree import AnyOrder, Choice, Node, Optional, Reference, Word, WordClass
from intent_engine.language.templates.template_tree import Sequence as Parts

if TYPE_CHECKING:
    from intent_engine.actions import Action
    from intent_engine.language.locations import LocationMap

__all__ = ["Choices", "Piece", "RandomChoices", "Sample", "Sampler", "sample"]

MAX_TRIES = 200
"""Sentences tried for one that makes an action (a speed so low that nothing moves makes none)."""
ONCE_IN = 4
"""Of so many sentences from which something may go on, one does."""
USUAL_JOINTS = 3
"""Joints that are sampled, the first of the list: "and", "then", "and then"."""
_DETERMINERS = frozenset(("the", "that", "this", "my", "your", "a", "an"))


@dataclass(frozen=True, slots=True)
class Sample:
    """A sentence with its meaning."""

    text: str
    intent: str
    slots: Mapping[str, Any]
    """Slot label to value, as in :class:`~intent_engine.interpretation.Interpretation`."""
    actions: tuple[Action, ...]
    pieces: tuple[Piece, ...]
    sentence: Sentence
    """The template or the pattern that it was made from."""


def sample(
    grammar: Grammar,
    locations: LocationMap | None = None,
    count: int = 20,
    *,
    intent: str | None = None,
    seed: int = 0,
    state: Collection[str] = (),
) -> list[Sample]:
    """Random sentences of a grammar, some of them with what goes on from them. The same seed gives the same sentences.

    Args:
        grammar: as loaded.
        locations: the map whose names are said.
        count: how many.
        intent: only sentences of this intent.
        seed: any whole number.
        state: states that the robot is in; intents that it forbids are left out.

    Raises:
        ConfigError: there is no such intent, or it has no sentence that can be said.
    """
    sampler = Sampler(grammar, locations, state=state)
    choices = RandomChoices(seed)
    return [sampler.going_on(sampler.draw(choices, intent), choices) for _ in range(count)]


class Sampler:
    """Draws sentences of one grammar and map.

    Args:
        grammar: as loaded.
        locations: the map whose names are said.
        state: states that the robot is in.
        texts: slot name to what is said for it, for text slots.
        without: intents that are left out.
    """

    def __init__(
        self,
        grammar: Grammar,
        locations: LocationMap | None = None,
        *,
        state: Collection[str] = (),
        texts: Mapping[str, Sequence[str]] | None = None,
        without: Collection[str] = (),
    ) -> None:
        self.grammar = grammar
        self.locations = locations
        self._state = frozenset(state)
        self._without = frozenset(without)
        self._lengths: dict[int, float] = {}
        self._ordered: dict[int, Sequence[Any]] = {}
        self._spoken_slots = SpokenSlots(grammar, locations, texts)
        self._values = SlotValues(grammar, locations, FreeText(grammar))
        self._patterns = PatternSampler(grammar, locations, self.spoken)

    @cached_property
    def intents(self) -> Mapping[str, tuple[Sentence, ...]]:
        """The intents that can be said in this state, each with its sentences; the shortest first."""
        found: dict[str, tuple[Sentence, ...]] = {}
        for intent in self.grammar.intents.values():
            if intent.requires - self._state or intent.excludes & self._state or intent.name in self._without:
                continue
            sayable = [item for item in intent.sentences if math.isfinite(self.length(item.template))]
            sayable.sort(key=lambda item: self.length(item.template))
            sayable += self._patterns.sentences(intent.name)
            if sayable:
                found[intent.name] = tuple(sayable)
        return dict(sorted(found.items(), key=lambda row: self._size_of(row[1][0])))

    def _size_of(self, sentence: Sentence) -> float:
        """Words of a sentence at its shortest; those of patterns come last."""
        return math.inf if self._patterns.has(sentence) else self.length(sentence.template)

    def of_pattern(self, sample: Sample) -> bool:
        """Whether a sample was made from a pattern, which takes its own words alone and none that sound alike."""
        return self._patterns.has(sample.sentence)

    def check(self, intent: str | None) -> None:
        """See that there is something to say.

        Raises:
            ConfigError: there is no such intent, or it has no sentence that can be said.
        """
        if intent is None and not self.intents:
            raise ConfigError("the grammar has no sentence that can be sampled")
        if intent is None or intent in self.intents:
            return
        known: Intent | None = self.grammar.intents.get(intent)
        if known is None:
            hint = did_you_mean(intent, self.grammar.intents) or f"there is {', '.join(self.grammar.intents)}"
            raise ConfigError(f"there is no intent {intent!r}; {hint}")
        if known.requires - self._state or known.excludes & self._state:
            needs = ", ".join(sorted(known.requires)) or f"not {', '.join(sorted(known.excludes))}"
            raise ConfigError(f"intent {intent!r} cannot be meant in this state of the robot; it needs: {needs}")
        if not known.sentences:
            raise ConfigError(
                f"intent {intent!r} has patterns only (regex, lark) of which nobody knows how they are said"
            )
        raise ConfigError(f"no sentence of intent {intent!r} can be said: is a map missing, or a unit?")

    def draw(self, choices: Choices, intent: str | None = None) -> Sample:
        """One sentence.

        Raises:
            ConfigError: see :meth:`check`; or no sentence found makes an action.
        """
        self.check(intent)
        for _ in range(MAX_TRIES):
            drawn = self.attempt(choices, intent)
            if drawn is not None:
                return drawn
        raise ConfigError(f"{MAX_TRIES} sentences of {intent or 'the grammar'!r} were tried, and none makes an action")

    def attempt(self, choices: Choices, intent: str | None = None) -> Sample | None:
        """One sentence, or None if its values make no action. :meth:`check` comes first."""
        names = list(self.intents)
        name = intent if intent is not None else pick(choices, names)
        sentence = pick(choices, self.intents[name])
        if self._patterns.has(sentence):
            pieces = self._patterns.drawn(sentence, choices)
            return self.finish(name, sentence, pieces) if pieces is not None else None
        return self.finish(name, sentence, self._drawn(sentence.template, choices))

    def attempt_later(self, choices: Choices, first: Sample) -> Sample | None:
        """What goes on from a command behind a joint; None: nothing does, or its values make no action, or it names
        more than the command does, or less."""
        intent = self.grammar.intents[first.intent]
        sayable = [one for one in intent.then if math.isfinite(self.length(one.template))]
        if not sayable:
            return None
        sentence = pick(choices, sayable)
        later = self.finish(intent.name, sentence, self._drawn(sentence.template, choices))
        alike = later is not None and names_taken(intent, later.slots) == names_taken(intent, first.slots)
        return later if alike else None

    def going_on(self, first: Sample, choices: Choices) -> Sample:
        """A sentence, and now and then another behind it that is one only there."""
        joints = self.grammar.operators.sequence
        if not joints or not self.grammar.intents[first.intent].then or one(choices, ONCE_IN) > 0:
            return first
        later = self.attempt_later(choices, first)
        if later is None:
            return first
        pieces = (*first.pieces, Piece(" ".join(pick(choices, joints[:USUAL_JOINTS]))), *later.pieces)
        steps = [{"intent": each.intent, "slots": dict(each.slots)} for each in (first, later)]
        actions = (*first.actions, *later.actions)
        return Sample(_joined(pieces), "compound", {"steps": steps}, actions, pieces, first.sentence)

    def finish(self, intent: str, sentence: Sentence, pieces: Sequence[Piece]) -> Sample | None:
        """The sample of these pieces, or None if their values make no action, nobody could tell them apart, or a
        pattern does not take them."""
        if any(map(_run_together, pieces, pieces[1:])) or any(map(_may_join, pieces, pieces[1:], pieces[2:])):
            return None
        if self._could_be_others(pieces):
            return None
        if self._patterns.has(sentence) and not self._patterns.takes(sentence, pieces):
            return None  # another value of a list than those that its pattern has
        said = {**sentence.fixed, **{piece.label: piece.value for piece in pieces if piece.label is not None}}
        try:
            slots = (
                (piece.label, piece.slot) for piece in pieces if piece.label is not None and piece.slot is not None
            )
            check_speeds(self.grammar.intents[intent], said, slots)
            action = build_action(self.grammar.intents[intent], said, self.locations)
        except CannotActError:
            return None
        values = {label: value.factor if isinstance(value, Relative) else value for label, value in said.items()}
        kept = _one_article(pieces)
        return Sample(_joined(kept), intent, values, (action,), kept, sentence)

    def _could_be_others(self, pieces: Sequence[Piece]) -> bool:
        """Whether two names one after the other may be two others, so that nobody knows which are meant."""
        words: list[str] = []
        slots: list[SlotReading] = []
        for piece in pieces:
            start = len(words)
            words.extend(words_of(piece.text))
            if piece.slot is not None:
                slots.append(SlotReading(piece.label or piece.slot.name, piece.slot, start, len(words), piece.value))
        otherwise = named_otherwise(
            slots, words, lambda one, begin, end: self._values.from_words(one.slot, one.label, words[begin:end], begin)
        )
        return otherwise is not None

    # -- trees --------------------------------------------------------------------------------------------------

    def length(self, node: Node) -> float:
        """Words of the shortest way to say a template, and a little for its letters; infinite if there is none."""
        known = self._lengths.get(id(node))  # trees live as long as their grammar, and hashing one walks all of it
        if known is None:
            known = self._lengths[id(node)] = self._length(node)
        return known

    def _length(self, node: Node) -> float:
        match node:
            case Word(text):
                return size(text)
            case WordClass(name):
                return 1.0 if name == "#" else math.inf
            case Choice(items):
                return min(map(self.length, items))
            case Optional():
                return 0.0
            case Parts(items) | AnyOrder(items):
                return sum(map(self.length, items))
            case Reference(name) if name in self.grammar.phrases:
                return self.length(self.grammar.phrases[name])
            case Reference(name):
                slot = self.grammar.slots[name]
                if slot.values:
                    return min(self.length(item) for _, item in slot.values)
                return min((size(form[0].text) for form in self._spoken_slots.ways(slot)), default=math.inf)
        raise AssertionError(node)

    def _drawn(self, node: Node, choices: Choices) -> list[Piece]:
        match node:
            case Word(text):
                return [Piece(text)]
            case WordClass():
                return [Piece(str(one(choices, 20) + 1))]
            case Choice(items):
                return self._drawn(pick(choices, self._shortest_first(node, items)), choices)
            case Optional(item):
                said = math.isfinite(self.length(item)) and choices.below(2) == 1
                return self._drawn(item, choices) if said else []
            case Parts(items):
                return [piece for item in items for piece in self._drawn(item, choices)]
            case AnyOrder(items):
                left, pieces = list(items), []
                while left:
                    pieces.extend(self._drawn(left.pop(one(choices, len(left))), choices))
                return pieces
            case Reference(name) if name in self.grammar.phrases:
                return self._drawn(self.grammar.phrases[name], choices)
            case Reference(name, label):
                return [self.spoken(self.grammar.slots[name], label, choices)]
        raise AssertionError(node)

    def _shortest_first(self, owner: object, items: Sequence[Node]) -> Sequence[Node]:
        """The nodes that can be said, kept for the template or slot that owns them."""
        ordered = self._ordered.get(id(owner))
        if ordered is None:
            sayable = [item for item in items if math.isfinite(self.length(item))]
            ordered = self._ordered[id(owner)] = sorted(sayable, key=self.length)
        return ordered

    # -- slots --------------------------------------------------------------------------------------------------

    def spoken(self, slot: Slot, label: str, choices: Choices) -> Piece:
        """A value for a slot, with words for it."""
        if slot.values:
            node = pick(choices, self._shortest_first(slot, [item for _, item in slot.values]))
            value = next(value for value, item in slot.values if item is node)
            return Piece(_joined(self._drawn(node, choices)), label, slot, value)
        said = pick(choices, pick(choices, self._spoken_slots.ways(slot)))
        return Piece(said.text, label, slot, said.value)


def _joined(pieces: Sequence[Piece]) -> str:
    return " ".join(piece.text for piece in pieces)


def _one_article(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """ "give me the" + "the cup": one of them is enough. What is dictated is kept: "write that" + "the cup leaks"."""
    return tuple(
        replace(piece, text=piece.text.removeprefix("the "))
        if piece.label and number and pieces[number - 1].text in _DETERMINERS and not _dictated(piece)
        else piece
        for number, piece in enumerate(pieces)
    )


def _dictated(piece: Piece) -> bool:
    return piece.slot is not None and piece.slot.dictation


def _may_join(piece: Piece, between: Piece, after: Piece) -> bool:
    """Whether the word between two numbers is in one of them, too: "200" + "and" + "one and a half"."""
    if piece.slot is None or after.slot is None or {piece.slot.type, after.slot.type} - set(QUANTITY_KINDS):
        return False
    return between.text in (*piece.text.split(), *after.text.split())


def _is_bare(piece: Piece, beside: Piece) -> bool:
    """Whether a number that is no slot stands beside a quantity."""
    return (
        piece.slot is None and piece.text.isdigit() and beside.slot is not None and beside.slot.type in QUANTITY_KINDS
    )


def _run_together(piece: Piece, after: Piece) -> bool:
    """Whether two numbers follow each other: "3 minutes" and "ten rpm" are said like "3 minutes ten", "track 20" and
    "five times" like "track 25"."""
    if _is_bare(piece, after) or _is_bare(after, piece):
        return True
    if piece.slot is None or after.slot is None or {piece.slot.type, after.slot.type} - set(QUANTITY_KINDS):
        return False
    if not isinstance(after.value, Relative):
        return True
    ends, begins = piece.text.split()[-1], after.text.split()[0]
    return begins in NUMBER_WORDS and (ends[-1].isdigit() or ends in NUMBER_WORDS)  # "1 meter 6" + "quarter speed"
